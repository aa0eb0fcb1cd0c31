// I-patches in scenes: weights that are set automatically; and the L_p distance.
#include <gtest/gtest.h>
#include <nearfield/field/program.hpp>

#include <cmath>
#include <string>
#include <vector>

#include "compile/field_compiler.hpp"
#include "field_nodes.hpp"
#include "input_error_expectation.hpp"

namespace nearfield::host {
namespace {

using Q = Fixed<27>;

class Field {
 public:
  explicit Field(const std::string& node)
      : compiled_(compile_field<Q>(field_of(node), "file", SlotOfLink())) {}
  double at(double x, double y, double z) const {
    const Program<Q> program(compiled_.image.data(), compiled_.inspection);
    return program.evaluate<Value<Q>>({Q(x), Q(y), Q(z)}, nullptr).value.to_double();
  }
  double at(const Vector3d& p) const { return at(p.x, p.y, p.z); }

 private:
  CompiledField<Q> compiled_;
};

std::string text_of(const Vector3d& p) {
  return "[" + format_number(p.x) + ", " + format_number(p.y) + ", " + format_number(p.z) + "]";
}
std::string text_of(const std::vector<Vector3d>& points) {
  std::string text;
  for (const Vector3d& p : points) text += (text.empty() ? "[" : ", ") + text_of(p);
  return text + "]";
}

std::string plane(const Vector3d& normal, double offset = 0.0) {
  return "{\"type\": \"algebraic_plane\", \"normal\": " + text_of(normal) +
         ", \"offset\": " + format_number(offset) + "}";
}
std::string cylinder_about(const Vector3d& axis) {
  const Vector3d diagonal{0.5 - 0.5 * axis.x, 0.5 - 0.5 * axis.y, 0.5 - 0.5 * axis.z};
  return "{\"type\": \"quadric\", \"diagonal\": " + text_of(diagonal) + ", \"constant\": -0.5}";
}
const Vector3d axes[3] = {{1, 0, 0}, {0, 1, 0}, {0, 0, 1}};

// Three orthogonal cylinders and three planes; with the right weight (|p|^2 - 1) / 2 everywhere.
std::string ribbons(const std::string& weights) {
  std::string text = "{\"type\": \"ribbon_patch\", " + weights + ", \"operands\": [";
  for (const Vector3d& axis : axes)
    text += (axis.x > 0.0 ? "" : ", ") + cylinder_about(axis) + ", " + plane(axis);
  return text + "]}";
}
// Planes at the corners of a triangle, and its sides' bounds x, y and z.
std::string corners(const std::string& weights) {
  return "{\"type\": \"corner_patch\", " + weights + ", \"operands\": [" + plane({0.05, 0.1, 0.2}, 0.1) +
         ", " + plane({0.2, 0.1, 0.05}, 0.1) + ", " + plane({0.1, 0.2, 0.1}, 0.08) + ", " + plane(axes[0]) +
         ", " + plane(axes[1]) + ", " + plane(axes[2]) + "]}";
}

TEST(FieldPatches, RibbonPatchesAreCentredAmongPoints) {
  const Field ball(
      ribbons("\"centred_among\": [[0.6, 0.48, 0.64], [-0.48, "
              "0.6, 0.64], [0.64, 0.6, -0.48]]"));
  const Field again(ribbons("\"through\": [0.6, 0.48, 0.64], \"side_weights\": [1, 1, 1]"));
  for (const Vector3d& p : {Vector3d{0, 0, 0}, Vector3d{0.3, -0.7, 0.4}, Vector3d{-0.9, 0.2, 0.1}}) {
    const double exact = 0.5 * (p.x * p.x + p.y * p.y + p.z * p.z - 1.0);
    EXPECT_NEAR(ball.at(p), exact, 1e-6) << text_of(p);
    EXPECT_NEAR(again.at(p), exact, 1e-6) << text_of(p);
  }
}

// No other weight has less in the sum of squares.
TEST(FieldPatches, CentredIsTheLeastSumOfSquares) {
  const std::vector<Vector3d> points{{0.6, 0.48, 0.64}, {0.5, 0.7, 0.6}, {0.7, -0.5, 0.6}};
  const auto squares = [&](const Field& patch) {
    double sum = 0.0;
    for (const Vector3d& p : points) sum += patch.at(p) * patch.at(p);
    return sum;
  };
  for (const bool has_corners : {false, true}) {
    const auto patch = [&](const std::string& weights) {
      return Field(has_corners ? corners("\"side_weights\": [0.02, 0.04, 0.06], " + weights)
                               : ribbons(weights));
    };
    const double least = squares(patch("\"centred_among\": " + text_of(points)));
    for (int i = -32; i <= 32; ++i) {
      EXPECT_GE(squares(patch("\"centre_weight\": " + format_number(0.125 * i))), least - 1e-6) << i;
    }
  }
}

TEST(FieldPatches, CornerPatchesPassThroughAPointOfEachSide) {
  const std::vector<Vector3d> points{{0, 0.8, 0.9}, {0.9, 0, 0.8}, {0.7, 0.8, 0}};
  for (const char* exponent : {"2", "3"}) {
    const Field patch(corners("\"side_points\": " + text_of(points) + ", \"exponent\": " + exponent));
    const Field flat(corners(std::string("\"side_weights\": [0, 0, 0], \"exponent\": ") + exponent));
    for (const Vector3d& p : points) {
      EXPECT_NEAR(patch.at(p), 0.0, 1e-6) << text_of(p);
      EXPECT_GT(std::abs(flat.at(p)), 1e-3) << text_of(p);
    }
    const Vector3d centre{0.7, 0.7, 0.7};
    const Field both(corners("\"side_points\": " + text_of(points) + ", \"through\": " + text_of(centre) +
                             ", \"exponent\": " + exponent));
    EXPECT_NEAR(both.at(centre), 0.0, 1e-6);
    EXPECT_NEAR(both.at(points[0]), 0.0, 1e-6);
  }
}

TEST(FieldPatches, WeightsThatContradictOrDoNotExistAreRefused) {
  const auto compile = [](const std::string& text, const std::string& file) {
    compile_field<Q>(parse_scene_of_any_kind(text, file).field, file, SlotOfLink());
  };
  const std::string on_sides = "\"side_points\": [[0, 0.5, 0.25], [0.6, 0, 0.3], ";
  const std::vector<Malformed> cases{
      {scene_of(ribbons("\"centre_weight\": 1, \"through\": [1, 1, 1]")),
       "file:2:57: field.through: \"through\" beside \"centre_weight\"; one of "
       "them, not both"},
      {scene_of(ribbons("\"centred_among\": [[1, 1, 1]], \"through\": [1, 1, 1]")),
       "file:2:43: field.centred_among: \"centred_among\" beside \"through\"; "
       "one of them, not both"},
      {scene_of(corners(on_sides + "[0.2, 0.7, 0]], \"side_weights\": [1, 1, 1]")),
       "file:2:41: field.side_points: \"side_points\" beside \"side_weights\"; "
       "one of them, not both"},
      {scene_of(corners("\"exponent\": 2")),
       "file:2:1: field.side_weights: missing; one number for each side, or "
       "`side_points`"},
      {scene_of(corners("\"side_points\": [[0, 0.5, 0.25]]")),
       "file:2:41: field.side_points: 1 points for 6 operands; one for every "
       "two operands"},
      {scene_of(corners(on_sides + "[0.2, 0.7, 0.1]]")),
       "file:2:41: field.side_points[2]: not on side 3: its bound is 0.1"},
      {scene_of(corners(on_sides + "[0, 0.7, 0]]")),
       "file:2:41: field.side_points[2]: no weight has any effect"},
      {scene_of(ribbons("\"through\": [0, 1, 1]")),
       "file:2:37: field.through: no weight has any effect here"},
      {scene_of(ribbons("\"through\": [0, 1, 5]")),
       "file:2:37: field.through[2]: 5 does not fit q27; from -4 to 4 m"},
      {scene_of(ribbons("\"centred_among\": [[0, 1, 5]]")),
       "file:2:43: field.centred_among[0][2]: 5 does not fit q27; from -4 to 4 "
       "m"},
      {scene_of(ribbons("\"through\": [0.001, 1, 1]")), "file:2:37: field.through: -499997.97"},
      {scene_of(ribbons("\"centred_among\": []")), "file:2:43: field.centred_among: array of 0; "},
      {scene_of(ribbons("\"centred_among\": [[1, 1]]")), "file:2:44: field.centred_among[0]: array of 2; "},
  };
  for (const Malformed& malformed : cases) expect_input_error(compile, malformed);
}

TEST(FieldPatches, LpDistanceIsTheNormOfThreeCoordinates) {
  const double a[3] = {0.5, 1.0, 0.25};
  for (const double n : {1.0, 1.5, 2.0, 3.0, 20.0}) {
    const Field field("{\"type\": \"lp_distance\", \"exponent\": " + format_number(n) +
                      ", \"semi_axes\": [0.5, 1, 0.25], \"position\": [0.25, 0, 0]}");
    for (const Vector3d& p :
         {Vector3d{0.3, 0.2, -0.1}, Vector3d{-0.4, -0.9, 0.2}, Vector3d{0.1, 0.05, 0.3}, Vector3d{0.5, 0, 0},
          Vector3d{0, -1, 0}, Vector3d{0, 0, 0.25}, Vector3d{0, 0, 0}}) {
      const double sum = std::pow(std::abs(p.x) / a[0], n) + std::pow(std::abs(p.y) / a[1], n) +
                         std::pow(std::abs(p.z) / a[2], n);
      const double error = n == 1.5 ? 3e-5 : 1e-6;  // of the table, see LIMITS.md
      EXPECT_NEAR(field.at(p.x + 0.25, p.y, p.z), std::pow(sum, 1.0 / n), error) << n << " " << text_of(p);
    }
  }
}

}  // namespace
}  // namespace nearfield::host
