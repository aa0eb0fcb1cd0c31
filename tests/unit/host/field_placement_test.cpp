// What placements with a scale mean, and contours that cut what they are about.
#include <gtest/gtest.h>

#include <string>
#include <vector>

#include "compile/contour_cut.hpp"
#include "compile/field_compiler.hpp"
#include "field_nodes.hpp"
#include "text/input_error.hpp"

namespace nearfield::host {
namespace {

using Q = Fixed<24>;

Sample<Q> sample_at(const std::string& text, double x, double y, double z) {
  const CompiledField<Q> field = compile_field<Q>(field_of(text), "scene", SlotOfLink());
  const Program<Q> program(field.image.data(), field.inspection);
  return program.evaluate<Sample<Q>>({x, y, z}, nullptr);
}
std::string refusal(const std::string& text) {
  try {
    compile_field<Fixed<27>>(field_of(text), "scene", SlotOfLink());
  } catch (const InputError& error) {
    return error.what();
  }
  return "accepted";
}

TEST(FieldPlacement, ScaledAboutTheOriginOfItsFrame) {
  const std::string ball =
      "{\"type\": \"place\", \"position\": [1, 0, 0], \"rpy\": [0, 0, 1.5707963267948966], \"scale\": 3, \"operands\": "
      "[{\"type\": \"sphere\", \"radius\": 0.25, \"position\": [0.5, 0, 0]}]}";
  // Its centre is at (1, 1.5, 0), its radius 0.75.
  const Sample<Q> above = sample_at(ball, 1, 3.25, 0);
  EXPECT_NEAR(above.value.to_double(), 1.0, 1e-6);
  EXPECT_NEAR(above.gradient.y.to_double(), 1.0, 1e-6);
  EXPECT_NEAR(sample_at(ball, 1, 1.5, 0.5).value.to_double(), -0.25, 1e-6);
}

TEST(FieldPlacement, ScaleWithoutAPlace) {
  const std::string text = "{\"type\": \"place\", \"scale\": 0.5, \"operands\": [{\"type\": \"ray_point\", \"influence_radius\": 2}]}";
  const Sample<Q> sample = sample_at(text, 0.5, 0, 0);
  EXPECT_NEAR(sample.value.to_double(), 0.5, 1e-6);
  EXPECT_NEAR(16.0 * sample.gradient.x.to_double(), 1.0, 1e-5);
}

TEST(FieldPlacement, ScalesThatAreRefused) {
  const std::string ball = ", \"operands\": [{\"type\": \"sphere\", \"radius\": 0.25}]}";
  EXPECT_NE(refusal("{\"type\": \"place\"" + ball).find("rpy, link, scale"), std::string::npos);
  for (const char* factor : {"0", "-1", "0.12", "8.1", "1e400", "\"2\""}) {
    const std::string line = refusal(std::string("{\"type\": \"place\", \"scale\": ") + factor + ball);
    EXPECT_NE(line.find("field.scale: "), std::string::npos) << line;
  }
  const std::string small = refusal("{\"type\": \"place\", \"scale\": 0.25" + ball);
  EXPECT_NE(small.find("field.scale: what is around does not fit q27"), std::string::npos) << small;
}

// Potentials take the rate and error of their operand inside the scale.
TEST(FieldPlacement, EveryOperatorMayBeScaled) {
  for (const OperatorDescription& row : all_operators()) {
    const FieldKind kind = row.any_kind ? FieldKind::intensity : row.operand_kind;
    for (const char* factor : {"1.25", "0.75", "4"}) {
      const std::string place = std::string("{\"type\": \"place\", \"position\": [0.1, 0, 0], \"scale\": ") + factor +
                                ", \"operands\": [" + node_text(row, row.fewest_operands, kind) + "]}";
      try {
        EXPECT_EQ(compile_field<Q>(field_of(place), "scene", SlotOfLink()).inspection.status, LoadStatus::ok);
      } catch (const InputError& error) {
        ADD_FAILURE() << row.name << " times " << factor << ": " << error.what();
      }
    }
  }
}

// A ball's contour: the object's surface is at half its influence radius, the contour at its whole.
std::string about(const std::string& object, const std::string& contour) {
  return "{\"type\": \"variable_influence\", \"operands\": [" + object + ", " + contour + "]}";
}
std::string ray_ball(double radius, double x = 0) {
  return "{\"type\": \"ray_point\", \"influence_radius\": " + format_number(radius) + ", \"position\": [" + format_number(x) +
         ", 0, 0]}";
}

TEST(FieldPlacement, ContoursAroundTheObjectAreTaken) {
  EXPECT_EQ(refusal(about(ray_ball(1), ray_ball(0.52))), "accepted");
  EXPECT_EQ(refusal(about(ray_ball(1), ray_ball(4))), "accepted");
  EXPECT_EQ(refusal(about(ray_ball(1), ray_ball(1, 0.45))), "accepted");
  EXPECT_EQ(refusal(about(ray_ball(0.2), "{\"type\": \"superquadric\", \"exponents\": [0.6, 3], \"semi_axes\": [0.5, 0.5, 0.5]}")),
            "accepted");
}

TEST(FieldPlacement, ContoursThatCutTheObjectAreRefused) {
  for (const std::string& contour : {ray_ball(0.49), ray_ball(1, 0.52), ray_ball(0.25, 3)}) {
    const std::string line = refusal(about(ray_ball(1), contour));
    EXPECT_NE(line.find(": field.operands[1]: the contour cuts the object: at ("), std::string::npos) << line;
    EXPECT_NE(line.find("; a contour whose ray value is below 1 wherever the object's is at most 0.5"), std::string::npos) << line;
  }
  const std::string thin =
      "{\"type\": \"superquadric\", \"exponents\": [2, 2], \"semi_axes\": [1, 1, 0.4]}";
  EXPECT_NE(refusal(about(ray_ball(1), thin)).find("cuts the object"), std::string::npos);
  // Placed elsewhere, and one within the other.
  EXPECT_NE(refusal("{\"type\": \"place\", \"position\": [1, 2, 0], \"operands\": [" + about(ray_ball(1), ray_ball(0.4)) + "]}")
                .find("field.operands[0].operands[1]: the contour cuts"),
            std::string::npos);
  std::string nested = about(ray_ball(1), ray_ball(0.4));
  for (int i = 0; i < 12; ++i) nested = about(nested, ray_ball(2));
  EXPECT_NE(refusal(nested).find("the contour cuts the object"), std::string::npos);
}

// Where points can be, not where the node's own frame has its domain.
TEST(FieldPlacement, ContoursAreJudgedWherePointsCanBe) {
  const auto plane = [](const char* normal, double radius) {
    return std::string("{\"type\": \"ray_plane\", \"normal\": ") + normal + ", \"influence_radius\": " +
           format_number(radius) + "}";
  };
  const std::string cut = about(plane("[0, 0, 1]", 0.5), "{\"type\": \"ray_intersection\", \"operands\": [" +
                                                             plane("[0, 0, 1]", 0.4) + ", " + plane("[1, 0, 0]", 4) + "]}");
  const auto placed = [](const std::string& how, const std::string& what) {
    return "{\"type\": \"place\", " + how + ", \"operands\": [" + what + "]}";
  };
  EXPECT_NE(refusal(placed("\"scale\": 0.5", cut)).find("cuts the object"), std::string::npos);
  EXPECT_NE(refusal(placed("\"position\": [-2, 0, 0]", cut)).find("cuts the object"), std::string::npos);
  EXPECT_EQ(refusal(placed("\"position\": [4, 0, 0]", about(ray_ball(0.5, 3.9), ray_ball(0.24, 3.9)))), "accepted");
}

// One operand of several nodes deep is made once, not twice at each.
TEST(FieldPlacement, NestedPatchesTakeNoTime) {
  const std::string plane = ", {\"type\": \"algebraic_plane\", \"normal\": [0, 0, 1], \"offset\": -0.9}, "
                            "{\"type\": \"algebraic_plane\", \"normal\": [0, 0.1, 0], \"offset\": 0.01}, "
                            "{\"type\": \"algebraic_plane\", \"normal\": [1, 0, 0], \"offset\": -0.9}]}";
  std::string nested = "{\"type\": \"algebraic_plane\", \"normal\": [1, 0, 0], \"offset\": 0.2}";
  for (int i = 0; i < 25; ++i)
    nested = "{\"type\": \"ribbon_patch\", \"through\": [0.1, 0.1, 0.1], \"operands\": [" + nested + plane;
  EXPECT_FALSE(refusal(nested).empty());
}

TEST(FieldPlacement, ContoursOfWhatChangesAreNotJudged) {
  const std::string morph =
      "{\"type\": \"ray_morph\", \"parameter_slot\": 0, \"operands\": [" + ray_ball(0.3) + ", " + ray_ball(2) + "]}";
  EXPECT_EQ(refusal(about(ray_ball(1), morph)), "accepted");
}

TEST(ContourCut, WithoutRatesByGridAlone) {
  const auto ball = [](double radius) {
    RayField field;
    field.value = [radius](const Vector3d& p) { return length(p) / radius; };
    field.rate = std::numeric_limits<double>::infinity();
    return field;
  };
  std::size_t allowance = 10000000;
  EXPECT_FALSE(contour_cut(ball(1), ball(0.6), 4.0, allowance));
  const std::optional<ContourCut> cut = contour_cut(ball(1), ball(0.4), 4.0, allowance);
  ASSERT_TRUE(cut);
  EXPECT_LE(cut->object, 0.5);
  EXPECT_GE(cut->contour, 1.0);
  allowance = 100;
  EXPECT_FALSE(contour_cut(ball(1), ball(0.4), 4.0, allowance)) << "given up";
  EXPECT_LT(allowance, 2U);
}

}  // namespace
}  // namespace nearfield::host
