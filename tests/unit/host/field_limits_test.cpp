// What number types leave of the ranges of parameters: what does not fit is refused by its key.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <set>

#include "compile/field_compiler.hpp"
#include "field_nodes.hpp"
#include "input_error_expectation.hpp"

namespace nearfield::host {
namespace {

void compile_in(FieldScalar scalar, const FieldNode& node) {
  with_scalar(scalar, [&](auto zero) { compile_field<decltype(zero)>(node, "file", SlotOfLink()); });
}
void compile_text(const std::string& text, const std::string& file) {
  compile_field<Fixed<27>>(parse_scene_of_any_kind(text, file).field, file, SlotOfLink());
}

FieldNode node_of(const OperatorDescription& row) {
  return field_of(
      node_text(row, row.fewest_operands, row.any_kind ? FieldKind::algebraic : row.operand_kind));
}

// The ends of a parameter's range, and numbers next to 0.
std::set<double> extremes(const ParameterDescription& parameter) {
  std::set<double> numbers;
  const NumberRange& range = parameter.range;
  for (const double number : {range.lowest, range.highest, 0.0, 1e-12, -1e-12, 0.1, 4.0}) {
    if (parameter.whole && number != std::floor(number)) continue;
    if (contains(range, number)) numbers.insert(number);
  }
  return numbers;
}

// Other parameters follow as their ratio to this one must.
void keep_ratios(FieldNode& node) {
  for (const ParameterDescription& parameter : node.operator_->parameters) {
    if (!parameter.ratio) continue;
    const double other = node.number(std::string(parameter.ratio->other_key));
    double& value = node.parameters.at(std::string(parameter.key)).front();
    value = std::clamp(value, parameter.ratio->lowest * other, parameter.ratio->highest * other);
    value = std::min(value, parameter.range.highest);
  }
}

// Compiled, or refused at one of the node's own keys. How many were refused.
int check_parameter(const OperatorDescription& row, const ParameterDescription& parameter) {
  int refused = 0;
  for (const double number : extremes(parameter)) {
    FieldNode node = node_of(row);
    std::vector<double>& values = node.parameters.at(std::string(parameter.key));
    if (values.empty()) continue;
    std::fill(values.begin(), values.end(), number);
    keep_ratios(node);
    for (const FieldScalar scalar :
         {FieldScalar::q27, FieldScalar::q24, FieldScalar::q16, FieldScalar::single}) {
      try {
        compile_in(scalar, node);
      } catch (const InputError& error) {
        ++refused;
        // Ends of an axis may each be near enough, but not with the length between them.
        if (parameter.key == "from" && error.path() == "field") continue;
        EXPECT_EQ(error.path().substr(0, 6), "field.") << row.name << " " << number << ": " << error.what();
        EXPECT_NE(error.position().line, 0U);
      }
    }
  }
  return refused;
}

TEST(FieldLimits, EveryParameterFitsOrIsRefusedByItsKey) {
  int refused = 0;
  for (const OperatorDescription& row : all_operators()) {
    for (const ParameterDescription& parameter : row.parameters) {
      SCOPED_TRACE(std::string(row.name) + "." + std::string(parameter.key));
      refused += check_parameter(row, parameter);
    }
  }
  EXPECT_GT(refused, 100);
}

// The field's node on line 2, its operands on the next.
TEST(FieldLimits, WhatDoesNotFitNamesTheKeyAndTheRange) {
  const std::string plane = "{\"type\": \"algebraic_plane\", \"normal\": [1, 0, 0]}";
  const std::string ball = "{\"type\": \"sphere\", \"radius\": 1}";
  const std::string ray = "{\"type\": \"ray_point\", \"influence_radius\": 1}";
  const auto blend = [](const std::string& head, std::size_t count, const std::string& operand) {
    std::string text = head + ", \"operands\": [\n" + operand;
    for (std::size_t i = 1; i < count; ++i) text += ", " + operand;
    return scene_of(text + "]}");
  };
  const std::vector<Malformed> cases{
      {scene_of("{\"type\": \"soft_point\", \"influence_radius\": 1, "
                "\"weight\": 5}"),
       "file:2:57: field.weight: 5 does not fit q27; from -4 to 4"},
      {scene_of("{\"type\": \"soft_point\", \"influence_radius\": 0.0625}"),
       "file:2:44: field.influence_radius: 0.0625 does not fit q27; above "
       "0.0625 and at most 4 m"},
      {scene_of("{\"type\": \"box\", \"size\": [1, 8.5, 1]}"),
       "file:2:25: field.size[1]: 8.5 does not fit q27; from "},
      {scene_of("{\"type\": \"cylinder\", \"height\": 1, \"radius\": 1e-12}"),
       "file:2:45: field.radius: 1e-12 does not fit q27; from "},
      {scene_of("{\"type\": \"sphere\", \"radius\": 1, \"position\": [0, 0, -4.5]}"),
       "file:2:45: field.position[2]: -4.5 does not fit q27; from -4 to 4 m"},
      {scene_of("{\"type\": \"capsule\", \"from\": [5, 0, 0], \"to\": [0, 0, "
                "0], \"radius\": 1}"),
       "file:2:29: field.from[0]: 5 does not fit q27; from -4 to 4 m"},
      {scene_of("{\"type\": \"ray_segment\", \"from\": [4, 0, 0], \"to\": [-5, "
                "0, 0], \"influence_radius\": 1}"),
       "file:2:50: field.to: 9 does not fit q27: the length from `from` to "
       "`to`; at most 8 m"},
      {scene_of("{\"type\": \"quadric\", \"diagonal\": [1, 1, 5], "
                "\"constant\": -1}"),
       "file:2:33: field.diagonal[2]: 5 does not fit q27; from -4 to 4"},
      {scene_of("{\"type\": \"quadric\", \"diagonal\": [1, 1, 1], "
                "\"constant\": -5}"),
       "file:2:56: field.constant: -5 does not fit q27; from -4 to 4"},
      {blend("{\"type\": \"algebraic_of_distance\", \"factor\": 0", 1, ball),
       "file:2:45: field.factor: 0 does not fit q27; from -4 to 4 1/m, more "
       "than 3.725290298461914e-09 from 0"},
      {blend("{\"type\": \"algebraic_of_distance\", \"factor\": 5", 1, ball),
       "file:2:45: field.factor: 5 does not fit q27; from -4 to 4 1/m"},
      {blend("{\"type\": \"algebraic_of_ray\", \"level\": 1e-12", 1, ray),
       "file:2:39: field.level: 1e-12 does not fit q27; from "},
      {blend("{\"type\": \"liming\", \"lambda\": 0", 3, plane),
       "file:2:30: field.lambda: 0 does not fit q27; from -1 to 1, more than "},
      {blend("{\"type\": \"functional_spline\", \"primaries\": 1, \"lambda\": "
             "-1e-12",
             2, plane),
       "file:2:57: field.lambda: -1e-12 does not fit q27; from -1 to 1, more "
       "than "},
      {blend("{\"type\": \"hoffmann_hopcroft_union\", \"r1\": 16, \"r2\": 16", 2, plane),
       "file:2:43: field.r1: 16 does not fit q27; from "},
      {blend("{\"type\": \"hoffmann_hopcroft_union\", \"r1\": 0.1, \"r2\": 2", 2, plane),
       "file:2:43: field.r1: 0.1 does not fit q27 beside 2; above 0.1333"},
      {blend("{\"type\": \"hoffmann_hopcroft_union\", \"r1\": 1, \"r2\": 1, "
             "\"p\": -3.5",
             2, plane),
       "file:2:60: field.p: -3.5 does not fit q27 beside these r1 and r2; from "
       "-3 to 0.875 times r1 r2"},
      {blend("{\"type\": \"interior_union\", \"rising_range\": 0.1, \"step\": {\"curve\": \"logistic\", \"alpha\": 16}", 2, ball),
       "file:2:57: field.step: has not risen from 0 to 1 at its ends; within "
       "2^-24"},
      {blend("{\"type\": \"log_sum_exp_union\", \"sharpness\": 5", 3, ball),
       "file:2:44: field.sharpness: 5 does not fit q27; from 5.545"},
      {blend("{\"type\": \"exterior_union\", \"blend_radius\": 3, "
             "\"rising_range\": 1.5",
             2, ball),
       "file:2:63: field.rising_range: 1.5 does not fit q27 beside "
       "blend_radius 3; together at most 4 m"},
      {blend("{\"type\": \"ribbon_patch\", \"side_weights\": [1, 5]", 4, plane),
       "file:2:42: field.side_weights[1]: 5 does not fit q27; from -4 to 4"},
      {blend("{\"type\": \"ribbon_patch\", \"centre_weight\": -5", 4, plane),
       "file:2:43: field.centre_weight: -5 does not fit q27; from -4 to 4"},
      {blend("{\"type\": \"union\"", 2, "{\"type\": \"sphere\", \"radius\": 5}"),
       "file:3:30: field.operands[0].radius: 5 does not fit q27; from "},
  };
  for (const Malformed& malformed : cases) expect_input_error(compile_text, malformed);
}

// Where every number fits, but not together, the node is named.
TEST(FieldLimits, WhatDoesNotFitTogetherNamesTheNode) {
  const auto ball_at = [](const std::string& more) {
    return "{\"type\": \"sphere\", \"radius\": 4, \"position\": [4, 4, 4]" + more + "}";
  };
  const std::string flat = "{\"type\": \"algebraic_plane\", \"normal\": [1, 0, 0]}";
  const std::vector<Malformed> cases{
      {scene_of("{\"type\": \"union\", \"operands\": [\n{\"type\": \"sphere\", "
                "\"radius\": 1},\n" +
                ball_at("") + "]}"),
       "file:4:1: field.operands[1]: position and size together do not fit "
       "q27; everything must lie within 4 m of "
       "its frame's origin"},
      {scene_of("{\"type\": \"potential_of_distance\", \"influence_radius\": 1, "
                "\"operands\": [{\"type\": \"declared_box\", \"size\": [1, 1, "
                "1], \"operands\": [" +
                flat + "]}]}"),
       "file:2:1: field: a declared box below it; it is an operand of sharp "
       "set operations and placements only"},
      {scene_of("{\"type\": \"ribbon_patch\", \"operands\": [" + flat + ", " + flat + ", " + flat + ", " + flat +
                ", " + flat + "]}"),
       "file:2:38: field.operands: 5; an even number: two for each side"},
      {scene_of("{\"type\": \"quadratic_union\", \"blend_radius\": 1, "
                "\"operands\": [{\"type\": \"sphere\", "
                "\"radius\": 1}, {\"type\": \"declared_box\", \"size\": [1, 1, "
                "1], \"operands\": [" +
                flat + "]}]}"),
       "file:2:1: field: a declared box below it; it is an operand of sharp "
       "set operations and placements only"},
  };
  for (const Malformed& malformed : cases) {
    try {
      compile_text(malformed.text, "file");
      ADD_FAILURE() << "accepted: " << malformed.text;
    } catch (const InputError& error) {
      EXPECT_EQ(std::string(error.what()).substr(0, malformed.expected.size()), malformed.expected);
    }
  }
}

// A misspelt type or key suggests the nearest there is.
TEST(FieldLimits, MisspeltNamesSuggestTheNearest) {
  const std::vector<Malformed> cases{
      {scene_of("{\"type\": \"lp_distanse\"}"),
       "file:2:10: field.type: unknown name \"lp_distanse\" (did you mean "
       "\"lp_distance\"?); one of "},
      {scene_of("{\"type\": \"lp_distance\", \"semi_axis\": [1, 1, 1]}"),
       "file:2:25: field.semi_axis: unknown key \"semi_axis\" (did you mean "
       "\"semi_axes\"?); allowed keys: "},
      {scene_of("{\"type\": \"ribbon_patch\", \"trough\": [1, 1, 1]}"),
       "file:2:26: field.trough: unknown key \"trough\" (did you mean "
       "\"through\"?); allowed keys: "},
      {scene_of("{\"type\": \"ribbon_patch\", \"centered_among\": [[1, 1, 1]]}"),
       "file:2:26: field.centered_among: unknown key \"centered_among\" (did "
       "you mean \"centred_among\"?); "},
  };
  for (const Malformed& malformed : cases) expect_input_error(parse_scene_of_any_kind, malformed);
}

}  // namespace
}  // namespace nearfield::host
