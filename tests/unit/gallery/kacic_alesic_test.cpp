// The gallery's figures after Kačić-Alesić and Wyvill: what their captions say, measured from their scenes.
#include <gtest/gtest.h>

#include <cmath>

#include "unit/gallery/gallery_field.hpp"
#include "unit/render/mesh_checks.hpp"

namespace nearfield::host {
namespace {

constexpr double pi = 3.14159265358979323846;

FieldPointer crossed(const std::string& name) {
  return gallery_field("kacic_alesic/crossed_" + name + ".json");
}

TEST(GalleryKacicAlesic, HarderFunctionsBulgeLess) {
  const double radius = 0.5;
  double above_before = 1.0, between_before = 1.5;
  for (const char* name : {"order_0", "order_1", "order_2", "hard"}) {
    const FieldPointer field = crossed(name);
    const double above = surface_along(*field, {}, {0.0, 0.0, 1.0}) - radius,
                 between = surface_along(*field, {}, {std::sqrt(0.5), std::sqrt(0.5), 0.0}) -
                           radius * std::sqrt(2.0);
    std::printf("%s: %.4f m above the crossing, %.4f m between the cylinders\n", name, above, between);
    EXPECT_GT(above, 0.0) << name;
    EXPECT_LT(above, above_before) << name;
    EXPECT_LT(between, between_before) << name;
    above_before = above;
    between_before = between;
  }
  // The cubic of the soft blend is the Bernstein-Bezier function of order one.
  EXPECT_NEAR(surface_along(*crossed("soft"), {}, {0.0, 0.0, 1.0}),
              surface_along(*crossed("order_1"), {}, {0.0, 0.0, 1.0}), 1e-5);
  const double soft = surface_along(*crossed("soft"), {}, {0.0, 0.0, 1.0}) - radius;
  EXPECT_GT(soft, 5.0 * above_before);
}

TEST(GalleryKacicAlesic, AllFunctionsGiveTheSameCylinder) {
  for (const char* name : {"soft", "hard", "order_0", "order_1", "order_2"}) {
    const double radius = surface_along(*crossed(name), {1.6, 0.0, 0.0}, {0.0, 0.6, 0.8});
    EXPECT_NEAR(radius, 0.5, 1e-4) << name;
  }
}

// Where the influence of the cylinder across ends on the one along x.
TEST(GalleryKacicAlesic, TheOrderOfContinuityAppearsWhereTheInfluenceEnds) {
  const auto slope = [](const SceneField& field, double x) { return field.at({x, 0.0, 0.5}).gradient.x; };
  const double end = std::sqrt(0.75);  // 1 m from the axis across
  const double near = 1e-3, step = 0.02;
  const auto jump = [&](const SceneField& field) {
    return std::abs(slope(field, end - near) - slope(field, end + near));
  };
  const auto curvature = [&](const SceneField& field) {
    return std::abs(slope(field, end - step) - slope(field, end)) / step;
  };
  const FieldPointer order_0 = crossed("order_0"), order_1 = crossed("order_1"), order_2 = crossed("order_2");
  EXPECT_NEAR(jump(*order_0), end, 0.01);
  EXPECT_LT(jump(*order_1), 0.02);
  EXPECT_LT(jump(*order_2), 0.001);
  EXPECT_GT(curvature(*order_1), 3.5);
  EXPECT_LT(curvature(*order_2), 1.5);
}

TEST(GalleryKacicAlesic, TheDonutHasBumpsAndOneHole) {
  const FieldPointer field = gallery_field("kacic_alesic/bumpy_donut.json");
  double least = 1.0, greatest = 0.0;
  for (int i = 0; i < 90; ++i) {
    const double angle = 2.0 * pi * i / 90.0;
    const double radius =
        surface_along(*field, {0.9 * std::cos(angle), 0.9 * std::sin(angle), 0.0}, {0.0, 0.0, 1.0}, 0.8);
    least = std::min(least, radius);
    greatest = std::max(greatest, radius);
  }
  std::printf("tube's radius from %.3f to %.3f m\n", least, greatest);
  EXPECT_GT(greatest - least, 0.08);
  EXPECT_FALSE(field->inside({}));
  const SurfaceMesh mesh = gallery_mesh(*field, {{-1.6, -1.6, -0.7}, {1.6, 1.6, 0.7}}, 36);
  EXPECT_EQ(expect_closed(mesh), 0);
  expect_on_surface(*field, mesh);
}

TEST(GalleryKacicAlesic, CylindersAreClosedAndOnTheSurface) {
  for (const char* name : {"soft", "hard", "order_0", "order_1", "order_2"}) {
    SCOPED_TRACE(name);
    const FieldPointer field = crossed(name);
    const SurfaceMesh mesh = gallery_mesh(*field, {{-2.7, -2.7, -0.9}, {2.7, 2.7, 0.9}}, 30);
    EXPECT_GT(mesh.triangles.size(), 500U);
    EXPECT_EQ(expect_closed(mesh), 2);
    expect_on_surface(*field, mesh);
  }
}

TEST(GalleryKacicAlesic, TheCocktailHasItsParts) {
  const FieldPointer field = scene_field(gallery_scene("kacic_alesic/cocktail.json"), FieldScalar::q24);
  // The cup: round, hollow, open above, with a bottom.
  for (int i = 0; i < 8; ++i) {
    const double angle = 2.0 * pi * (i + 0.5) / 8.0;
    const Vector3d out{std::cos(angle), std::sin(angle), 0.0};
    const Vector3d wall = Vector3d{0.0, 0.0, 1.6} + 0.68 * out;
    ASSERT_TRUE(field->inside(wall)) << i;
    EXPECT_NEAR(surface_along(*field, wall, out, 0.4),
                surface_along(*field, {0.68, 0.0, 1.6}, {1.0, 0.0, 0.0}, 0.4), 1e-4);
    EXPECT_FALSE(field->inside(Vector3d{0.0, 0.0, 1.6} + 0.45 * out)) << i;
  }
  EXPECT_FALSE(field->inside({0.1, 0.2, 2.0}));
  EXPECT_FALSE(field->inside({0.1, 0.2, 3.1}));
  EXPECT_TRUE(field->inside({0.0, 0.0, 0.4}));
  // The straw, from within to above the rim.
  for (const double t : {0.4, 0.7, 0.95})
    EXPECT_TRUE(field->inside({-0.3 + 0.95 * t, 0.1 - 0.35 * t, 0.8 + 3.1 * t})) << t;
  // The base's outline by the cosine of four times the angle.
  const double lobe = surface_along(*field, {}, {1.0, 0.0, 0.0}, 2.0),
               dent = surface_along(*field, {}, {std::cos(pi / 4.0), std::sin(pi / 4.0), 0.0}, 2.0);
  EXPECT_GT(lobe, dent + 0.03);
  EXPECT_NEAR(lobe, surface_along(*field, {}, {0.0, -1.0, 0.0}, 2.0), 2e-3);
}

}  // namespace
}  // namespace nearfield::host
