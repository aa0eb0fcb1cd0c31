// Meshes: closed, on the surface within the certificate, of the right genus, the same by any number of
// threads.
#include "render/surface_mesh.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstring>
#include <random>
#include <set>

#include "render/cell_polygons.hpp"
#include "render/mesh_file.hpp"
#include "render/view.hpp"
#include "unit/render/mesh_checks.hpp"
#include "unit/render/scene_text.hpp"

namespace nearfield::host {
namespace {

constexpr double pi = 3.14159265358979323846;

Meshing meshed(const SceneField& field, std::size_t resolution, unsigned threads = 1) {
  MeshSettings settings;
  settings.box = grown(surface_box(field, domain_box(field)).value(), 0.05);
  settings.resolution = resolution;
  settings.threads = threads;
  return mesh_of(field, settings);
}

double volume(const SurfaceMesh& mesh) {
  double sum = 0.0;
  for (const auto& t : mesh.triangles) {
    sum +=
        dot(mesh.vertices[t[0]].position, cross(mesh.vertices[t[1]].position, mesh.vertices[t[2]].position)) /
        6.0;
  }
  return sum;
}

TEST(CellPolygons, EveryCrossedEdgeOnce) {
  for (unsigned inside = 0; inside < 256; ++inside) {
    std::set<unsigned> seen;
    for (const CellPolygon& polygon : cell_polygons(static_cast<std::uint8_t>(inside))) {
      EXPECT_GE(polygon.size(), 3U);
      for (std::size_t i = 0; i < polygon.size(); ++i) {
        EXPECT_TRUE(seen.insert(polygon[i]).second);
        EXPECT_TRUE(share_face(polygon[i], polygon[(i + 1) % polygon.size()]));
      }
    }
    for (unsigned edge = 0; edge < 12; ++edge) {
      const CellEdge ends = cell_edge(edge);
      EXPECT_EQ(seen.count(edge) == 1, (inside >> ends.from & 1U) != (inside >> ends.to & 1U))
          << inside << " " << edge;
    }
  }
}

TEST(SurfaceMesh, BallIsClosedAndRound) {
  const auto field = field_of_text(ball_text);
  const Meshing meshing = meshed(*field, 40);
  EXPECT_EQ(expect_closed(meshing.mesh), 2);
  expect_on_surface(*field, meshing.mesh);
  EXPECT_NEAR(volume(meshing.mesh) / (4.0 / 3.0 * pi * 0.125), 1.0, 0.01);
  EXPECT_GT(meshing.passed_over, meshing.cells / 8);
  for (const SurfaceMesh::Vertex& vertex : meshing.mesh.vertices) {
    ASSERT_NEAR(length(vertex.position), 0.5, 3e-8);
    ASSERT_LT(length(vertex.normal - 2.0 * vertex.position), 1e-6);
  }
}

TEST(SurfaceMesh, EveryKindIsClosed) {
  struct Known {
    std::string text;
    long euler;
  };
  const std::string blend = R"({"type": "quadratic_union", "blend_radius": 0.2, "operands": [
      {"type": "sphere", "radius": 0.3},
      {"type": "capsule", "from": [0.2, 0, 0], "to": [0.7, 0.3, 0.2], "radius": 0.15}]})";
  for (const Known& known : {Known{blend, 2}, Known{soft_text, 2}, Known{ray_text, 2}, Known{torus_text, 0},
                             Known{R"({"type": "torus", "ring_radius": 0.5, "tube_radius": 0.1})", 0}}) {
    const auto field = field_of_text(known.text);
    const Meshing meshing = meshed(*field, 30);
    EXPECT_EQ(expect_closed(meshing.mesh), known.euler) << known.text;
    EXPECT_GT(volume(meshing.mesh), 0.0) << known.text;
    if (field->proof().rate) expect_on_surface(*field, meshing.mesh);
  }
}

// Solid noise at a few cells a wave: cells of every pattern.
TEST(SurfaceMesh, RoughSurfacesAreClosed) {
  for (int seed = 1; seed <= 2; ++seed) {
    const auto field = field_of_text(
        R"({"type": "noise_distance", "amplitude": 0.2, "frequency": 6, "octaves": 2, "seed": )" +
        std::to_string(seed) + R"(, "operands": [{"type": "sphere", "radius": 0.4}]})");
    const Meshing meshing = meshed(*field, 18);
    ASSERT_GT(meshing.mesh.triangles.size(), 500U);
    expect_closed(meshing.mesh);
    expect_on_surface(*field, meshing.mesh);
  }
}

TEST(SurfaceMesh, SurfaceThatLeavesTheBox) {
  const auto field = field_of_text(ball_text);
  MeshSettings settings;
  settings.box = {{-1.0, -1.0, 0.0}, {1.0, 1.0, 1.0}};
  settings.resolution = 30;
  const Meshing open = mesh_of(*field, settings);
  EXPECT_TRUE(open.leaves_box);
  EXPECT_TRUE(open.mesh.triangles.empty());
  settings.close = true;
  const Meshing closed = mesh_of(*field, settings);
  EXPECT_FALSE(closed.leaves_box);
  EXPECT_EQ(expect_closed(closed.mesh), 2);
  EXPECT_NEAR(volume(closed.mesh) / (2.0 / 3.0 * pi * 0.125), 1.0, 0.03);
}

TEST(SurfaceMesh, SameWithAnyNumberOfThreads) {
  const auto field = field_of_text(blend_text);
  const std::string one = ply_of(meshed(*field, 24, 1).mesh, "");
  EXPECT_EQ(ply_of(meshed(*field, 24, 2).mesh, ""), one);
  EXPECT_EQ(ply_of(meshed(*field, 24, 3).mesh, ""), one);
}

TEST(MeshFile, PlyAndObjHoldTheSameNumbers) {
  SurfaceMesh mesh;
  mesh.vertices = {{{0.1, -2.0, 1e-9}, {0.0, 0.0, 1.0}},
                   {{1.0, 0.0, 0.0}, {0.0, 0.6, 0.8}},
                   {{0.0, 1.0, 0.0}, {1.0, 0.0, 0.0}}};
  mesh.triangles = {{0, 1, 2}};
  EXPECT_EQ(obj_of(mesh, "a\nb"),
            "# a b\nv 0.1 -2 1e-09\nv 1 0 0\nv 0 1 0\nvn 0 0 1\nvn 0 0.6 0.8\nvn 1 0 0\nf 1//1 2//2 3//3\n");
  const std::string ply = ply_of(mesh, "a\nb");
  const std::string header =
      "ply\nformat binary_little_endian 1.0\ncomment a b\nelement vertex 3\nproperty double x\nproperty "
      "double y\n"
      "property double z\nproperty float nx\nproperty float ny\nproperty float nz\nelement face 1\n"
      "property list uchar uint vertex_indices\nend_header\n";
  ASSERT_EQ(ply.substr(0, header.size()), header);
  ASSERT_EQ(ply.size(), header.size() + 3 * 36 + 13);
  double y = 0.0;
  std::memcpy(&y, ply.data() + header.size() + 8, sizeof y);
  EXPECT_EQ(y, -2.0);
  EXPECT_EQ(ply.substr(header.size() + 3 * 36), (std::string{3, 0, 0, 0, 0, 1, 0, 0, 0, 2, 0, 0, 0}));
}

}  // namespace
}  // namespace nearfield::host
