// What Akleman and Chen say of layers, measured on the scenes of the gallery.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "render/bands.hpp"
#include "unit/gallery/gallery_field.hpp"
#include "unit/render/mesh_checks.hpp"

namespace nearfield::host {
namespace {

const Box3 about_handles{{-0.85, -0.8, -0.5}, {0.95, 0.85, 0.85}};

// Of unit length, evenly spread.
std::vector<Vector3d> directions(int count) {
  std::vector<Vector3d> all;
  for (int i = 0; i < count; ++i) {
    const double z = 1.0 - (2.0 * i + 1.0) / count, r = std::sqrt(1.0 - z * z), angle = 2.399963229728653 * i;
    all.push_back({r * std::cos(angle), r * std::sin(angle), z});
  }
  return all;
}

// The share of the places where a layer ends, f = `to`, that have a place with f <= `from` at 1.05 times what
// the layer should be thick, and none at 0.95 times.
double even_share(const std::string& scene, const Box3& box, double from, double to) {
  static const std::vector<Vector3d> around = directions(700);
  const FieldPointer field = gallery_field(scene);
  // The surface of the same field at another level.
  const FieldPointer end = scene_field(gallery_scene(scene), FieldScalar::q27, {}, to);
  const SurfaceMesh mesh = gallery_mesh(*end, box, 28);
  std::size_t places = 0, even = 0;
  const std::size_t stride = std::max<std::size_t>(1, mesh.vertices.size() / 150);
  for (std::size_t i = 0; i < mesh.vertices.size(); i += stride) {
    const SurfaceMesh::Vertex& vertex = mesh.vertices[i];
    const auto reaches = [&](double distance) {
      const auto is_before = [&](const Vector3d& direction) {
        return field->outward(vertex.position + distance * direction) <= from;
      };
      return is_before(-1.0 * vertex.normal) || std::any_of(around.begin(), around.end(), is_before);
    };
    ++places;
    if (reaches(1.05 * (to - from)) && !reaches(0.95 * (to - from))) ++even;
  }
  EXPECT_GE(places, 100U) << scene;
  return static_cast<double>(even) / static_cast<double>(places);
}

TEST(GalleryAkleman, LayersAreOfOneThicknessWithinFivePercent) {
  // No layer is thinner anywhere than it should be.
  EXPECT_LE(gallery_field("akleman/handles.json")->proof().rate.value_or(2.0), 1.000001);
  for (const int layer : {-1, 0, 2}) {
    const double from = 0.03 * layer;
    const double share = even_share("akleman/handles.json", grown(about_handles, 0.2), from, from + 0.03);
    std::printf("layer %d: even at %.1f %% of the places\n", layer, 100.0 * share);
    EXPECT_GE(share, 0.95);
  }
}

TEST(GalleryAkleman, LayersOfPolynomialsAreNot) {
  const Box3 box{{-0.9, -0.6, -0.4}, {0.9, 0.6, 0.4}};
  const double even = even_share("akleman/rings.json", box, 0.1, 0.15);
  const double uneven = even_share("akleman/rings_algebraic.json", box, 0.1, 0.15);
  std::printf("even at %.2f of the places with distances, at %.2f with polynomials\n", even, uneven);
  EXPECT_GE(even, 0.9);
  EXPECT_LE(uneven, 0.1);
}

TEST(GalleryAkleman, TheShapeIsClosedAndHasFiveHandles) {
  const FieldPointer field = gallery_field("akleman/handles.json");
  const SurfaceMesh mesh = gallery_mesh(*field, about_handles, 64);
  EXPECT_EQ(expect_closed(mesh), 2 - 2 * 5);
  expect_on_surface(*field, mesh);
}

TEST(GalleryAkleman, TheBlendComesNearerToTheSharpUnionWithP) {
  const std::vector<double> sharpness = {12.0, 40.0, 400.0};
  for (const double p : sharpness) {
    const std::string name = "akleman/sharpness_" + std::to_string(static_cast<int>(p)) + ".json";
    const FieldPointer blend = gallery_field(name);
    std::vector<FieldPointer> operands;
    for (std::size_t i = 0; i < 3; ++i) operands.push_back(gallery_operand(name, i));
    double greatest = 0.0;
    for (const Vector3d& at : plane_points(0.6, 0.03)) {
      double sharp = 1e9, sum = 0.0;
      for (const FieldPointer& operand : operands) sharp = std::min(sharp, operand->outward(at));
      for (const FieldPointer& operand : operands) sum += std::exp(-p * (operand->outward(at) - sharp));
      ASSERT_NEAR(blend->outward(at), sharp - std::log(sum) / p, 1e-5) << name;
      greatest = std::max(greatest, sharp - blend->outward(at));
    }
    EXPECT_LE(greatest, std::log(3.0) / p);
    EXPECT_GE(greatest, 0.5 * std::log(2.0) / p) << name;
  }
}

TEST(GalleryAkleman, ItsWavesRepeatEachThreeCentimetres) {
  const Bands bands({{1.0, 209.44}, {0.4, 41.888}});
  EXPECT_DOUBLE_EQ(bands.shade(0.0), 1.0);
  EXPECT_NEAR(bands.shade(0.15), 1.0, 1e-5);
  for (double f = 0.0; f < 0.15; f += 0.03) {
    EXPECT_GT(bands.shade(f), bands.shade(f + 0.015) + 0.5);
    EXPECT_LE(bands.shade(f), 1.0);
  }
}

}  // namespace
}  // namespace nearfield::host
