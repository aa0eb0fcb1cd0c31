// Skeletons of the scene format: what they are, and what is refused.
#include <gtest/gtest.h>
#include <nearfield/field/program.hpp>

#include <string>

#include "compile/field_compiler.hpp"
#include "field_nodes.hpp"
#include "input_error_expectation.hpp"

namespace nearfield::host {
namespace {

CompiledField<Fixed<27>> compiled(const std::string& text, const std::string& file) {
  return compile_field<Fixed<27>>(parse_scene_of_any_kind(text, file).field, file, SlotOfLink());
}
double value(const std::string& node, double x, double y, double z) {
  const CompiledField<Fixed<27>> field = compiled(scene_of(node), "file");
  const Program<Fixed<27>> program(field.image.data(), field.inspection);
  return program.evaluate<Value<Fixed<27>>>({Fixed<27>(x), Fixed<27>(y), Fixed<27>(z)}, nullptr)
      .value.to_double();
}
void expect_refused(const std::string& node, const std::string& expected) {
  expect_input_error(compiled, {scene_of(node), expected});
}

TEST(SkeletonOperators, AreWhereTheyArePlaced) {
  const std::string at = ", \"position\": [1, 0, 0], \"radius\": 0.25}";
  EXPECT_NEAR(value("{\"type\": \"polyline\", \"points\": [[0, 0, 0], [0, 1, 0]]" + at, 2, 0.5, 0), 0.75,
              1e-7);
  EXPECT_NEAR(value("{\"type\": \"polygon\", \"vertices\": [[0, 0], [1, 0], [0, 1]]" + at, 1.25, 0.25, -1),
              0.75, 1e-7);
  EXPECT_NEAR(
      value(
          "{\"type\": \"cubic_curve\", \"control_points\": [[0, 0, 0], [0, 0.5, 0], [0, 1, 0], [0, 1.5, 0]]" +
              at,
          2, 0.5, 0),
      0.75, 1e-6);
}

TEST(SkeletonOperators, PointsAndSegmentsMayBeBare) {
  EXPECT_NEAR(value("{\"type\": \"sphere\", \"radius\": 0, \"position\": [1, 0, 0]}", 1, 0.5, 0), 0.5, 1e-7);
  EXPECT_NEAR(
      value("{\"type\": \"capsule\", \"from\": [0, 0, 0], \"to\": [1, 0, 0], \"radius\": 0}", 0.5, 0, 0.25),
      0.25, 1e-7);
}

TEST(SkeletonOperators, HalvedCurvesAreTheSameAndCertifiedMoreClosely) {
  const std::string curve =
      "{\"type\": \"cubic_curve\", \"control_points\": [[0, 0, 0], [0.3, 0, 0], [0.3, 0.3, 0], [0, 0.3, "
      "0.2]]";
  double errors[3] = {};
  for (int halvings = 0; halvings < 3; ++halvings) {
    const std::string node = curve + ", \"halvings\": " + std::to_string(halvings) + "}";
    EXPECT_NEAR(value(node, 0.5, 0.1, 0.1), value(curve + "}", 0.5, 0.1, 0.1), 1e-6);
    errors[halvings] = compiled(scene_of(node), "file").inspection.certificate.error.to_double();
  }
  EXPECT_LT(errors[1], 0.3 * errors[0]);
  EXPECT_LT(errors[2], 0.3 * errors[1]);
}

TEST(SkeletonOperators, SplinesAreBetweenTheirControlPoints) {
  // At a knot: (a + 4 b + c) / 6.
  const std::string spline =
      "{\"type\": \"cubic_curve\", \"form\": \"b_spline\", \"control_points\": "
      "[[0, 0, 0], [0.2, 0.3, 0], [0.4, 0, 0], [0.6, 0.3, 0], [0.8, 0, 0]]}";
  EXPECT_NEAR(value(spline, 0.2, 0.2, 0), 0.0, 1e-7);
  EXPECT_NEAR(value(spline, 0.4, 0.1, 0.5), 0.5, 1e-7);
}

// Of 4 by 4 control points at (0.25 i, 0.25 j), one of them raised.
std::string patch(const std::string& height, std::size_t count = 16) {
  std::string text = "{\"type\": \"bicubic_patch\", \"control_points\": [";
  for (std::size_t i = 0; i < count; ++i) {
    text += std::string(i > 0 ? ", " : "") + "[" + format_number(0.25 * static_cast<double>(i / 4)) + ", " +
            format_number(0.25 * static_cast<double>(i % 4)) + ", " + (i == 5 ? height : "0") + "]";
  }
  return text + "]";
}

TEST(SkeletonOperators, PatchesAreWhereTheirControlPointsPutThem) {
  const std::string flat = patch("0") + ", \"radius\": 0.25, \"position\": [1, 0, 0]}";
  EXPECT_NEAR(value(flat, 1.3, 0.4, -1), 0.75, 1e-7);
  EXPECT_NEAR(value(flat, 0.5, 0.4, 0), 0.25, 1e-7);
  EXPECT_NEAR(value(flat, 2.25, 0.4, 0), 0.25, 1e-7);
  // Bernstein's weights of the raised point are 4/9 each at u = v = 1/3.
  EXPECT_NEAR(value(patch("0.2") + "}", 0.25, 0.25, 16.0 / 81.0 * 0.2), 0.0, 1e-6);
}

TEST(SkeletonOperators, RefuseWhatIsNoPatch) {
  expect_refused(patch("0", 15) + "}", "file:2:45: field.control_points: array of 15; an array of 16 elements");
  expect_refused(patch("3") + "}", "file:2:45: field.control_points: 3 does not fit q27");
  expect_refused(patch("17") + "}", "file:2:125: field.control_points[5][2]: 17");
  expect_refused(patch("0") + ", \"radius\": -0.1}", "file:2:297: field.radius: -0.1");
}

TEST(SkeletonOperators, RefuseWhatIsNoSkeleton) {
  expect_refused("{\"type\": \"polyline\", \"points\": [[0, 0, 0]]}",
                 "file:2:32: field.points: array of 1; an array of 2 to 8 elements");
  expect_refused("{\"type\": \"polyline\", \"points\": [[0, 0, 0], [0, 0, 9]]}",
                 "file:2:32: field.points[1]");
  expect_refused("{\"type\": \"polyline\", \"points\": [[0, 0, 0], [0, 0, 1]], \"radius\": -1}",
                 "file:2:66: field.radius: -1");
  expect_refused("{\"type\": \"polygon\", \"vertices\": [[0, 0], [1, 0]]}",
                 "file:2:33: field.vertices: array of 2; an array of 3 to 8 elements");
  expect_refused("{\"type\": \"polygon\", \"vertices\": []}", "file:2:33: field.vertices: array of 0; an array of 3 to 8 elements");
  const char* const bad[] = {"[[0, 0], [1, 0], [2, 0]]", "[[0, 0], [1, 1], [1, 0], [0, 1]]",
                             "[[0, 0], [1, 0], [1, 0], [0, 1]]", "[[0, 0], [2, 0], [1, 0], [0, 1]]",
                             "[[0, 0], [2, 0], [2, 1], [1, 0], [0, 1]]"};
  for (const char* vertices : bad) {
    expect_refused("{\"type\": \"polygon\", \"vertices\": " + std::string(vertices) + "}",
                   "file:2:33: field.vertices: two edges meet");
  }
  const std::string curve = "{\"type\": \"cubic_curve\", \"control_points\": ";
  expect_refused(curve + "[[0, 0, 0], [1, 0, 0], [1, 1, 0], [0, 1, 0], [0, 0, 1]]}",
                 "file:2:43: field.control_points: 5 of them");
  expect_refused(curve + "[[0, 0, 0], [3, 0, 0], [1, 1, 0], [0, 1, 0]]}",
                 "file:2:43: field.control_points: 3 does not fit q27");
  expect_refused(curve + "[[0, 0, 0], [1, 0, 0], [1, 1, 0], [0, 1, 0]], \"halvings\": 3}",
                 "file:2:101: field.halvings");
  expect_refused(curve + "[[0, 0, 0], [1, 0, 0], [1, 1, 0]], \"form\": \"b_spline\"}",
                 "file:2:43: field.control_points: array of 3; an array of 4 to 13 elements");
  expect_refused(curve + "[[0,0,0],[1,0,0],[1,1,0],[0,1,0],[0,2,0],[1,2,0],[1,1,1]], \"halvings\": 2}",
                 "file:2:43: field.control_points: 7 of them");
}

}  // namespace
}  // namespace nearfield::host
