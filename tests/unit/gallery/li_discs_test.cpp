// What Li says of his blends, measured on the scenes of the gallery's figures 2 to 11.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "unit/gallery/gallery_field.hpp"

namespace nearfield::host {
namespace {

const std::vector<Vector3d>& places() {
  static const std::vector<Vector3d> all = plane_points(0.6, 0.02);
  return all;
}

// Square centimetres inside, of a grid.
double area(const SceneField& field) {
  const auto inside = std::count_if(places().begin(), places().end(),
                                    [&field](const Vector3d& p) { return field.inside(p); });
  return 4.0 * static_cast<double>(inside);
}

TEST(GalleryLi, ExteriorUnionsContainBothDiscs) {
  for (const char* name : {"union_0_5", "union_1", "union_5", "apart_0_25", "apart_0_35", "apart_6"}) {
    SCOPED_TRACE(name);
    const GalleryBlend discs(std::string("li/exterior_") + name + ".json");
    for (const Vector3d& p : places()) ASSERT_LE(discs.blend->outward(p), discs.of_union(p) + discs.error);
  }
}

TEST(GalleryLi, ExteriorUnionsBulgeByAQuarterOfDelta) {
  // Where both circles meet.
  const Vector3d joint{0.0, std::sqrt(0.2 * 0.2 - 0.13 * 0.13), 0.0};
  EXPECT_NEAR(gallery_field("li/exterior_union_0_5.json")->outward(joint), -0.05 / 4.0, 1e-4);
  EXPECT_NEAR(gallery_field("li/exterior_union_1.json")->outward(joint), -0.1 / 4.0, 1e-5);
  EXPECT_NEAR(gallery_field("li/exterior_union_5.json")->outward(joint), -0.5 / 4.0, 1e-5);
}

TEST(GalleryLi, ExteriorIntersectionsAndSubtractionsLieInsideTheSharpOnes) {
  for (const char* name : {"0_01", "1", "2"}) {
    SCOPED_TRACE(name);
    const GalleryBlend lens(std::string("li/exterior_intersection_") + name + ".json");
    for (const Vector3d& p : places())
      ASSERT_GE(lens.blend->outward(p), lens.of_intersection(p) - lens.error);
  }
  for (const char* name : {"0_2", "1", "2"}) {
    SCOPED_TRACE(name);
    const GalleryBlend crescent(std::string("li/exterior_subtraction_") + name + ".json");
    for (const Vector3d& p : places())
      ASSERT_GE(crescent.blend->outward(p), crescent.of_subtraction(p) - crescent.error);
  }
}

TEST(GalleryLi, DeltaDecidesHowMuchIsBlended) {
  const auto area_of = [](const std::string& name) {
    return area(*gallery_field("li/exterior_" + name + ".json"));
  };
  EXPECT_LT(area_of("union_0_5"), area_of("union_1"));
  EXPECT_LT(1.1 * area_of("union_1"), area_of("union_5"));
  EXPECT_GT(area_of("intersection_0_01"), area_of("intersection_1"));
  EXPECT_GT(area_of("intersection_1"), area_of("intersection_2"));
  EXPECT_GT(area_of("subtraction_0_2"), area_of("subtraction_1"));
  EXPECT_GT(area_of("subtraction_1"), area_of("subtraction_2"));
}

TEST(GalleryLi, DiscsThatDoNotTouchAreJoinedFromSomeDeltaOn) {
  const GalleryBlend apart("li/exterior_apart_0_25.json"), joined("li/exterior_apart_0_35.json"),
      blob("li/exterior_apart_6.json");
  EXPECT_GT(apart.of_union({}), 0.005);
  EXPECT_FALSE(apart.blend->inside({}));
  EXPECT_TRUE(joined.blend->inside({}));
  EXPECT_FALSE(joined.blend->inside({0.0, 0.05, 0.0}));
  EXPECT_TRUE(blob.blend->inside({0.0, 0.2, 0.0}));
}

TEST(GalleryLi, InteriorUnionsLieInsideTheSharpOne) {
  double before = 1e9;
  for (const char* name : {"0_25", "5", "10"}) {
    SCOPED_TRACE(name);
    const GalleryBlend discs(std::string("li/interior_union_") + name + ".json");
    for (const Vector3d& p : places()) ASSERT_GE(discs.blend->outward(p), discs.of_union(p) - discs.error);
    EXPECT_LT(area(*discs.blend), before);
    before = area(*discs.blend);
  }
}

TEST(GalleryLi, InteriorIntersectionsAndSubtractionsContainTheSharpOnes) {
  for (const char* name : {"0_25", "5", "20"}) {
    SCOPED_TRACE(name);
    const GalleryBlend lens(std::string("li/interior_intersection_") + name + ".json");
    const GalleryBlend crescent(std::string("li/interior_subtraction_") + name + ".json");
    for (const Vector3d& p : places()) {
      ASSERT_LE(lens.blend->outward(p), lens.of_intersection(p) + lens.error);
      ASSERT_LE(crescent.blend->outward(p), crescent.of_subtraction(p) + crescent.error);
    }
  }
}

TEST(GalleryLi, InteriorBlendsKeepTheJoints) {
  const double height = std::sqrt(0.2 * 0.2 - 0.13 * 0.13);
  for (const char* name : {"union_0_25", "union_5", "union_10", "intersection_0_25", "intersection_5",
                           "intersection_20", "subtraction_0_25", "subtraction_5", "subtraction_20"}) {
    const FieldPointer field = gallery_field(std::string("li/interior_") + name + ".json");
    for (const double y : {height, -height}) {
      EXPECT_NEAR(field->outward({0.0, y, 0.0}), 0.0, field->proof().error + 5e-8) << name;
    }
  }
  // The exterior ones do not.
  EXPECT_LT(gallery_field("li/exterior_union_0_5.json")->outward({0.0, height, 0.0}), -0.01);
}

// With H_3; to the left of 0 the blend is its mirror image.
double step(double t) {
  const double u = 1.5 * (std::clamp(t, -1.0, 1.0) + 1.0);
  if (u <= 1.0) return u * u * u / 6.0;
  if (u <= 2.0) return -0.625 + 0.75 * u - std::pow(u - 1.5, 3.0) / 3.0;
  return 1.0 - std::pow(3.0 - u, 3.0) / 6.0;
}
double smooth_absolute(double t, double delta, double epsilon) {
  const double g1 = step((t + delta) / epsilon), g2 = step((t - delta) / epsilon);
  return (g1 + g2 - 1.0) * t + g1 * (1.0 - g2) * (t * t / (2.0 * delta) + delta / 2.0);
}

TEST(GalleryLi, TheGraphOfTheSmoothAbsoluteValue) {
  struct Known {
    const char* name;
    double delta;
  };
  for (const Known& known : {Known{"0_1", 0.1}, Known{"0_5", 0.5}, Known{"1", 1.0}}) {
    const FieldPointer field = gallery_field(std::string("li/smooth_absolute_") + known.name + ".json");
    for (double x = -1.4; x <= 1.4; x += 0.01) {
      // The scene's rounded parameters and the table's error come in here; the picture has 10 mm a pixel.
      ASSERT_NEAR(field->outward({x, smooth_absolute(x, known.delta, 0.05), 0.0}), 0.0, 2e-5)
          << known.name << " " << x;
    }
  }
}

TEST(GalleryLi, CornersOfExtMaxAndIntMax) {
  struct Known {
    const char* name;
    double range;
  };
  for (const Known& known : {Known{"0_1", 0.1}, Known{"0_5", 0.5}, Known{"1", 1.0}}) {
    const FieldPointer field = gallery_field(std::string("li/exterior_corner_") + known.name + ".json");
    EXPECT_NEAR(field->outward({}), -known.range / 4.0, 1e-5);
    EXPECT_NEAR(field->outward({-known.range - 0.06, 0.0, 0.0}), 0.0, 1e-7);
    EXPECT_LT(field->outward({-0.5 * known.range, 0.0, 0.0}), -0.01 * known.range);
  }
  for (const Known& known : {Known{"0_25", 0.25}, Known{"1", 1.0}, Known{"2", 2.0}}) {
    const FieldPointer field = gallery_field(std::string("li/interior_corner_") + known.name + ".json");
    EXPECT_NEAR(field->outward({}), 0.0, 1e-7);
    EXPECT_NEAR(field->outward({-known.range - 0.01, 0.0, 0.0}), 0.0, 1e-7);
    EXPECT_GT(field->outward({-0.25 * known.range, 0.0, 0.0}), 0.05 * known.range);
  }
}

}  // namespace
}  // namespace nearfield::host
