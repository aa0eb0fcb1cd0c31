// The gallery's figures after Hsu: what their captions say, measured from their scenes.
#include <gtest/gtest.h>

#include <cmath>

#include "unit/gallery/gallery_field.hpp"
#include "unit/render/mesh_checks.hpp"

namespace nearfield::host {
namespace {

constexpr double pi = 3.14159265358979323846;

FieldPointer hsu(const std::string& name) { return gallery_field("hsu/" + name + ".json"); }

TEST(GalleryHsu, LpBallsPassTheirPoints) {
  const std::vector<std::pair<const char*, double>> metrics = {
      {"1_1", 1.1}, {"1_3", 1.3}, {"1_5", 1.5}, {"2", 2.0},
      {"3", 3.0},   {"5", 5.0},   {"10", 10.0}, {"20", 20.0}};
  for (const auto& [name, n] : metrics) {
    const FieldPointer field = hsu(std::string("lp_") + name);
    const double error = field->proof().error + 1e-7;
    const double along_axis = surface_along(*field, {}, {0.0, -1.0, 0.0}, 1.5);
    const double along_face = surface_along(*field, {}, {std::sqrt(0.5), 0.0, std::sqrt(0.5)}, 1.5);
    const double along_room = surface_along(
        *field, {}, {-std::sqrt(1.0 / 3.0), std::sqrt(1.0 / 3.0), std::sqrt(1.0 / 3.0)}, 1.5);
    EXPECT_NEAR(along_axis, 0.5, 4.0 * error) << n;
    EXPECT_NEAR(along_face, 0.5 * std::sqrt(2.0) * std::pow(2.0, -1.0 / n), 4.0 * error) << n;
    EXPECT_NEAR(along_room, 0.5 * std::sqrt(3.0) * std::pow(3.0, -1.0 / n), 4.0 * error) << n;
  }
}

TEST(GalleryHsu, ThePureUnionHasACreaseAndTheBlendHasNone) {
  const FieldPointer pure = hsu("pure_union"), smooth = hsu("smooth_union");
  // Across the line in which both cylinders meet, on the surface.
  const auto jump = [](const SceneField& field) {
    const double half = std::sqrt(0.5), along = half * surface_along(field, {}, {half, half, 0.0}, 1.5);
    const double near = 1e-4;
    return length(field.at({along + near, along - near, 0.0}).gradient -
                  field.at({along - near, along + near, 0.0}).gradient);
  };
  EXPECT_GT(jump(*pure), 1.0);
  EXPECT_LT(jump(*smooth), 0.01);
}

// The die's pips are where the algebraic one has them.
std::vector<Vector3d> pips() {
  std::vector<Vector3d> places;
  const SceneDescription scene = gallery_scene("hsu/die_with_range.json");
  for (std::size_t i = 1; i < scene.field.operands.size(); ++i)
    places.push_back(scene.field.operands[i].placement.position);
  return places;
}

TEST(GalleryHsu, RangeControlLeavesThePlanesAsTheyAre) {
  const FieldPointer with = hsu("die_with_range"), without = hsu("die_without_range"),
                     planes = hsu("planes_sharp");
  const std::vector<Vector3d> places = pips();
  ASSERT_EQ(places.size(), 21U);
  for (const Vector3d& place : places) {
    // What is subtracted is gone, with and without.
    EXPECT_NEAR(planes->outward(place), 0.0, 1e-6);
    EXPECT_FALSE(with->inside(0.95 * place));
    EXPECT_FALSE(without->inside(place));
  }
  // On faces, further from edges and spheres than the ranges.
  std::size_t untouched = 0, deformed = 0;
  for (double y = -1.2; y <= 1.2; y += 0.15) {
    for (double z = -1.2; z <= 1.2; z += 0.15) {
      const Vector3d on_face{1.75, y, z};
      double nearest = 9.0;
      for (const Vector3d& place : places) nearest = std::min(nearest, length(place - on_face));
      if (nearest < 0.5) continue;
      ++untouched;
      EXPECT_NEAR(surface_along(*with, {1.2, y, z}, {1.0, 0.0, 0.0}, 1.0), 0.55, 1e-5) << y << " " << z;
      if (surface_along(*without, {1.0, y, z}, {1.0, 0.0, 0.0}, 1.0) < 0.74) ++deformed;
    }
  }
  std::printf("%zu places of a face untouched with range control, %zu deformed without\n", untouched,
              deformed);
  EXPECT_GT(untouched, 100U);
  EXPECT_GT(deformed, untouched * 8 / 10);
}

TEST(GalleryHsu, ScaleUnionsHoldTheirOperandsAndEndAtTheirRange) {
  for (const char* name : {"hsu/four_cylinders.json", "hsu/six_cylinders.json"}) {
    SCOPED_TRACE(name);
    const FieldPointer blend = gallery_field(name);
    const std::size_t count = gallery_scene(name).field.operands.size();
    std::vector<FieldPointer> operands;
    for (std::size_t i = 0; i < count; ++i) operands.push_back(gallery_operand(name, i));
    std::size_t blended = 0, single = 0;
    for (double x = -1.2; x <= 1.2; x += 0.2) {
      for (double y = -1.2; y <= 1.2; y += 0.2) {
        for (double z = -0.3; z <= 0.3; z += 0.15) {
          double least = 9.0, second = 9.0;
          for (const FieldPointer& operand : operands) {
            const double value = operand->value({x, y, z});
            second = std::min(second, std::max(least, value));
            least = std::min(least, value);
          }
          if (least > 2.0) continue;
          const double value = blend->value({x, y, z});
          EXPECT_LE(value, least + 1e-4);
          if (value < least - 1e-3) ++blended;
          if (second > 2.5 * least) {  // further than the range from what the others blend to
            ++single;
            EXPECT_NEAR(value, least, 1e-4) << x << " " << y << " " << z;
          }
        }
      }
    }
    EXPECT_GT(blended, 20U);
    EXPECT_GT(single, 20U);
  }
}

TEST(GalleryHsu, BlendingRangesAreTheirOwn) {
  const FieldPointer fixed = hsu("ranges_fixed"), controlled = hsu("ranges_controlled");
  EXPECT_NEAR(surface_along(*fixed, {}, {0.0, 1.0, 0.0}, 2.0), 1.0, 1e-5);
  EXPECT_NEAR(surface_along(*controlled, {}, {0.0, 1.0, 0.0}, 2.0), 1.0, 1e-5);
  // Outside the influence reaches w1 times the radius, inside w2 times.
  EXPECT_GT(fixed->value({1.9, 0.0, 0.0}), 1e-3);
  EXPECT_EQ(controlled->value({1.501, 0.0, 0.0}), 0.0);
  EXPECT_GT(controlled->value({1.45, 0.0, 0.0}), 1e-3);
  EXPECT_LT(fixed->value({0.74, 0.0, 0.0}), 0.9);
  EXPECT_NEAR(controlled->value({0.74, 0.0, 0.0}), 1.0, 1e-5);
  // The fillet on the large cylinder becomes smaller.
  const FieldPointer by_size = hsu("cylinders_fixed"), individual = hsu("cylinders_individual");
  const Vector3d up{0.0, 0.0, 1.0};
  const double large = surface_along(*by_size, {0.4, 0.0, 0.0}, up, 1.4) - 0.6,
               small = surface_along(*individual, {0.4, 0.0, 0.0}, up, 1.4) - 0.6;
  std::printf("fillet 0.4 m from the small cylinder's axis: %.4f and %.4f m\n", large, small);
  EXPECT_GT(small, 0.0);
  EXPECT_LT(small, 0.8 * large);
}

// How far from the axis, as a part of how far the contour surface is, the transition rises from the upper
// face of the cube, least and greatest of all directions.
std::pair<double, double> outline(const SceneField& union_of, const SceneField& contour) {
  double least = 9.0, greatest = 0.0;
  const double above_face = 0.601;
  for (int i = 0; i < 12; ++i) {
    const double angle = 2.0 * pi * (i + 0.25) / 12.0;
    const Vector3d out{std::cos(angle), std::sin(angle), 0.0}, up{0.0, 0.0, above_face};
    // The cube's face is even so far.
    const double reach = 1.4 / std::max(std::abs(out.x), std::abs(out.y));
    double low = 0.0, high = reach;
    for (int k = 0; k < 30; ++k) {
      const double middle = 0.5 * (low + high);
      (contour.value(up + middle * out) < 1.0 ? low : high) = middle;
    }
    const double part = surface_along(union_of, up, out, reach) / low;
    least = std::min(least, part);
    greatest = std::max(greatest, part);
  }
  return {least, greatest};
}

void expect_outline_of(const std::string& union_of, const std::string& contour) {
  const auto [least, greatest] = outline(*hsu(union_of), *hsu(contour));
  std::printf("%s: outline at %.3f to %.3f of the contour's\n", union_of.c_str(), least, greatest);
  EXPECT_GT(least, 0.88) << union_of;
  EXPECT_LT(greatest, 1.001) << union_of;
}

TEST(GalleryHsu, TransitionsOfSoftBlendsFollowTheContourSurface) {
  for (const std::string number : {"12_0_6", "12_1_2", "12_1_5", "12_2", "12_3", "12_20"})
    expect_outline_of("variable_" + number, "contour_" + number);
}

TEST(GalleryHsu, TransitionsOfScaleUnionsFollowTheContourSurface) {
  for (const std::string number : {"14_0_6", "14_1_1", "14_1_5", "14_2", "14_3", "14_20"})
    expect_outline_of("variable_" + number, "contour_" + number);
}

TEST(GalleryHsu, TheTransitionAboutARoseIsAStar) { expect_outline_of("rose_star", "star"); }

TEST(GalleryHsu, WithoutItTransitionsFollowTheObject) {
  const FieldPointer bar = hsu("contour_14_20"), blend = hsu("soft_union_bar"),
                     scale = hsu("scale_union_bar");
  // The bar's own influence ends at 0.8 m where the contour of figure 14 is at 1.3 m.
  for (const SceneField* field : {blend.get(), scale.get()}) {
    const auto [least, greatest] = outline(*field, *bar);
    EXPECT_GT(least, 0.88 * 0.8 / 1.3);
    EXPECT_LT(greatest, 1.02 * 0.8 / 1.3);
  }
}

TEST(GalleryHsu, SolidsAreClosedAndOnTheSurface) {
  struct Solid {
    const char* name;
    Box3 box;
    long euler;  // characteristic
  };
  const std::vector<Solid> all = {{"smooth_union", {{-1.8, -1.8, -0.6}, {1.8, 1.8, 0.6}}, 2},
                                  {"four_cylinders", {{-1.4, -1.4, -1.4}, {1.4, 1.4, 1.4}}, 2},
                                  {"six_cylinders", {{-1.4, -1.4, -0.6}, {1.4, 1.4, 0.6}}, 0},
                                  {"superquadric", {{-0.6, -0.6, -0.7}, {0.6, 0.6, 0.7}}, 2}};
  for (const Solid& solid : all) {
    SCOPED_TRACE(solid.name);
    const FieldPointer field = hsu(solid.name);
    const SurfaceMesh mesh = gallery_mesh(*field, solid.box, 26);
    EXPECT_GT(mesh.triangles.size(), 400U);
    EXPECT_EQ(expect_closed(mesh), solid.euler);
    expect_on_surface(*field, mesh);
  }
}

TEST(GalleryHsu, AVariableInfluenceMeshesAsWell) {
  const FieldPointer field = hsu("variable_14_2");
  const SurfaceMesh mesh = gallery_mesh(*field, {{-1.8, -1.8, -1.4}, {1.8, 1.8, 1.4}}, 24);
  EXPECT_EQ(expect_closed(mesh), 2);
}

}  // namespace
}  // namespace nearfield::host
