// The gallery's figures after Sipos: what their captions say, measured from their scenes.
#include <gtest/gtest.h>

#include <cmath>

#include "render/view.hpp"
#include "unit/gallery/gallery_field.hpp"
#include "unit/render/mesh_checks.hpp"

namespace nearfield::host {
namespace {

constexpr double pi = 3.14159265358979323846;

// A node of a scene by the numbers of the operands that lead to it.
FieldPointer node_of(const std::string& name, std::initializer_list<std::size_t> path) {
  SceneDescription scene = gallery_scene("sipos/" + name + ".json");
  for (const std::size_t index : path) {
    FieldNode operand = scene.field.operands.at(index);
    scene.field = std::move(operand);
  }
  return scene_field(scene, FieldScalar::q27);
}

// Of two directions, from 0 to pi.
double angle_between(const Vector3d& a, const Vector3d& b) {
  return std::atan2(length(cross(a, b)), dot(a, b));
}

void expect_vertices_on_surface(const SceneField& field, const SurfaceMesh& mesh) {
  double worst = 0.0;
  for (const SurfaceMesh::Vertex& vertex : mesh.vertices) {
    const FieldAnswer answer = field.at(vertex.position);
    worst = std::max(worst, std::abs(answer.outward) / std::max(length(answer.gradient), 0.1));
  }
  EXPECT_LT(worst, 2e-6);
}

TEST(GallerySipos, LimingsSurfacesLieOnBothSidesOfTheCircle) {
  const double half = std::sqrt(0.5);
  const Vector3d from{-0.8, 0.0, -0.8}, outwards{half, 0.0, half};
  const double corner = 0.8 / half;
  const auto depth = [&](const char* name) {
    return corner - surface_along(*node_of(name, {}), from, outwards, 1.5);
  };
  const double edge = depth("original_edge"), near = depth("liming_0_2"), far = depth("liming_0_6"),
               cut = depth("cut_edge");
  // The circle touches where the cut does, sqrt(1/2) m from the edge.
  const double circle = half * (std::sqrt(2.0) - 1.0);
  std::printf("below the edge: %.4f, %.4f, circle %.4f, %.4f, cut %.4f m\n", edge, near, circle, far, cut);
  EXPECT_NEAR(edge, 0.0, 1e-6);
  EXPECT_NEAR(cut, 0.5, 1e-6);
  EXPECT_GT(near, edge + 0.05);
  EXPECT_LT(near, circle - 0.02);
  EXPECT_GT(far, circle + 0.01);
  EXPECT_LT(far, cut - 0.05);
}

TEST(GallerySipos, LimingsSurfaceTouchesThePlanes) {
  for (const char* name : {"liming_0_2", "liming_0_6"}) {
    const FieldPointer liming = node_of(name, {6, 1});
    const double touch = std::sqrt(0.5);
    for (const double y : {-0.5, 0.0, 0.3}) {
      EXPECT_NEAR(liming->outward({0.0, y, -touch}), 0.0, 1e-6);
      EXPECT_LT(angle_between(liming->at({0.0, y, -touch}).gradient, {1.0, 0.0, 0.0}), 1e-5);
      EXPECT_LT(angle_between(liming->at({-touch, y, 0.0}).gradient, {0.0, 0.0, 1.0}), 1e-5);
    }
  }
}

TEST(GallerySipos, TheFunctionalSplineJoinsItsPrimaries) {
  const FieldPointer spline = node_of("functional_spline", {}), primaries = node_of("primaries", {});
  std::size_t filled = 0;
  for (double x = -1.05; x <= 1.06; x += 0.15) {
    for (double y = -1.05; y <= 1.06; y += 0.15) {
      for (double z = -1.05; z <= 1.06; z += 0.15) {
        const Vector3d p{x, y, z};
        if (primaries->inside(p)) {
          EXPECT_TRUE(spline->inside(p)) << x << " " << y << " " << z;
        } else if (spline->inside(p)) {
          ++filled;
          EXPECT_LT(length(p), 0.8);
        }
      }
    }
  }
  EXPECT_GT(filled, 50U);
  // Where the sphere cuts a cylinder, the spline has the cylinder's tangent plane.
  const FieldPointer polynomial = node_of("functional_spline", {0, 3, 1});
  for (int i = 0; i < 6; ++i) {
    const double angle = 2.0 * pi * (i + 0.3) / 6.0;
    const Vector3d normal{0.0, std::cos(angle), std::sin(angle)};
    const Vector3d p = Vector3d{std::sqrt(0.64 - 0.09), 0.0, 0.0} + 0.3 * normal;
    EXPECT_NEAR(polynomial->outward(p), 0.0, 1e-6);
    EXPECT_LT(angle_between(polynomial->at(p).gradient, normal), 1e-4);
  }
}

TEST(GallerySipos, PatchesInterpolateTheirRibbons) {
  for (const char* name : {"ribbons", "ribbons_full"}) {
    const FieldPointer patch = node_of(name, {0, 0});
    for (int i = 0; i < 9; ++i) {
      const double angle = pi / 2.0 * (i + 0.5) / 9.0, a = std::cos(angle), b = std::sin(angle);
      const std::pair<Vector3d, Vector3d> sides[] = {
          {{0.0, a, b}, {0.0, a, b}}, {{b, 0.0, a}, {b, 0.0, a}}, {{a, b, 0.0}, {a, b, 0.0}}};
      for (const auto& [p, normal] : sides) {
        EXPECT_NEAR(patch->outward(p), 0.0, 1e-6) << name;
        EXPECT_LT(angle_between(patch->at(p).gradient, normal), 1e-4) << name;
      }
    }
  }
  EXPECT_NEAR(node_of("ribbons", {0, 0})->outward({0.58, 0.58, 0.58}), 0.0, 1e-5);
  EXPECT_NEAR(node_of("ribbons_full", {0, 0})->outward({0.72, 0.72, 0.72}), 0.0, 1e-5);
}

TEST(GallerySipos, PatchesWithCornersPassTheirPoints) {
  const std::pair<const char*, double> all[] = {{"corners", 0.75}, {"corners_flat", 0.6}};
  for (const auto& [name, v] : all) {
    const FieldPointer patch = node_of(name, {0});
    for (const Vector3d& p : {Vector3d{0.0, v, v}, Vector3d{v, 0.0, v}, Vector3d{v, v, 0.0}})
      EXPECT_NEAR(patch->outward(p), 0.0, 1e-5) << name;
    // Tangent planes at the corners: across the side that leads to the corner.
    for (const Vector3d& p : {Vector3d{1.0, 0.0, 0.0}, Vector3d{0.0, 1.0, 0.0}, Vector3d{0.0, 0.0, 1.0}}) {
      EXPECT_NEAR(patch->outward(p), 0.0, 1e-5) << name;
      EXPECT_LT(angle_between(patch->at(p).gradient, p), 1e-3) << name;
    }
  }
}

TEST(GallerySipos, CellsMeetWithoutAnEdge) {
  // Cells 0 and 4 have the plane x = 0 between them, 0 and 2 y = 0, 0 and 1 z = 0.
  const FieldPointer whole = node_of("cell_complex", {}), first = node_of("cell_complex", {0, 0});
  const std::pair<std::size_t, Vector3d> faces[] = {
      {4, {0.0, 1.0, 1.0}}, {2, {1.0, 0.0, 1.0}}, {1, {1.0, 1.0, 0.0}}};
  for (const auto& [other, mask] : faces) {
    const FieldPointer neighbour = node_of("cell_complex", {other, 0});
    for (int i = 0; i < 7; ++i) {
      const double angle = pi / 2.0 * (i + 0.5) / 7.0, a = std::cos(angle), b = std::sin(angle);
      const Vector3d out = mask.x == 0.0   ? Vector3d{0.0, a, b}
                           : mask.y == 0.0 ? Vector3d{a, 0.0, b}
                                           : Vector3d{a, b, 0.0};
      const Vector3d p = surface_along(*first, {}, out, 2.5) * out;
      EXPECT_NEAR(neighbour->outward(p), 0.0, 1e-5);
      EXPECT_LT(angle_between(first->at(p).gradient, neighbour->at(p).gradient), 1e-4);
      EXPECT_NEAR(whole->outward(p), 0.0, 1e-5);
    }
  }
  // Each corner where its tangent plane touches.
  EXPECT_NEAR(surface_along(*whole, {}, {1.0, 0.0, 0.0}, 2.0), 1.3, 1e-4);
  EXPECT_NEAR(surface_along(*whole, {}, {0.0, 0.0, -1.0}, 2.0), 0.6, 1e-4);
}

TEST(GallerySipos, TheCellComplexIsOneClosedSurface) {
  const FieldPointer field = node_of("cell_complex", {});
  const SurfaceMesh mesh = gallery_mesh(*field, {{-1.5, -1.5, -1.5}, {1.6, 1.5, 1.6}}, 16);
  EXPECT_EQ(expect_closed(mesh), 2);
  expect_vertices_on_surface(*field, mesh);
}

TEST(GallerySipos, TheFrameIsOneClosedSurfaceWithFiveHandles) {
  const FieldPointer field = node_of("frame", {});
  const SurfaceMesh mesh = gallery_mesh(*field, {{-1.12, -1.12, -1.12}, {1.12, 1.12, 1.12}}, 16);
  EXPECT_EQ(expect_closed(mesh), 2 - 2 * 5);
  expect_vertices_on_surface(*field, mesh);
  // A vertex' patch goes on in its bars: where it ends, and in the direction of their surface.
  const FieldPointer patch = node_of("frame", {0, 0});
  for (int i = 0; i < 8; ++i) {
    const double angle = 2.0 * pi * i / 8.0;
    const Vector3d normal{0.0, std::cos(angle), std::sin(angle)};
    const Vector3d p = Vector3d{0.55, 0.8, 0.8} + 0.18 * normal;
    EXPECT_NEAR(patch->outward(p), 0.0, 1e-5);
    EXPECT_LT(angle_between(patch->at(p).gradient, normal), 1e-3);
  }
}

TEST(GallerySipos, OtherSolidsAreClosedAndOnTheSurface) {
  struct Solid {
    const char* name;
    Box3 box;
  };
  const std::vector<Solid> all = {{"liming_0_2", {{-1.33, -0.85, -1.33}, {0.12, 0.85, 0.12}}},
                                  {"liming_0_6", {{-1.33, -0.85, -1.33}, {0.12, 0.85, 0.12}}},
                                  {"functional_spline", {{-1.22, -1.22, -1.22}, {1.22, 1.22, 1.22}}},
                                  {"ribbons", {{-0.93, -0.93, -0.93}, {1.15, 1.15, 1.15}}},
                                  {"corners", {{-0.14, -0.14, -0.14}, {1.17, 1.17, 1.17}}}};
  for (const Solid& solid : all) {
    SCOPED_TRACE(solid.name);
    const FieldPointer field = node_of(solid.name, {});
    const SurfaceMesh mesh = gallery_mesh(*field, solid.box, 18);
    EXPECT_GT(mesh.triangles.size(), 250U);
    EXPECT_EQ(expect_closed(mesh), 2);
    expect_vertices_on_surface(*field, mesh);
  }
}

}  // namespace
}  // namespace nearfield::host
