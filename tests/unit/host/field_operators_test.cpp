// Every operator of the scene format, read, compiled and evaluated in every scalar.
#include <gtest/gtest.h>
#include <nearfield/field/program.hpp>

#include <cmath>
#include <string>
#include <string_view>
#include <vector>

#include "compile/field_compiler.hpp"
#include "field_nodes.hpp"
#include "input_error_expectation.hpp"

namespace nearfield::host {
namespace {

template <class S>
struct Evaluated {
  Inspection<S> inspection;
  std::vector<std::uint32_t> image;
  Program<S> program;

  explicit Evaluated(const FieldNode& node) {
    CompiledField<S> compiled = compile_field<S>(node, "scene", SlotOfLink());
    inspection = compiled.inspection;
    image = compiled.image;
    program = Program<S>(image.data(), inspection);
  }
  Sample<S> at(double x, double y, double z) const {
    const S half = ScalarTraits<S>::half(ScalarTraits<S>::one());
    return program.template evaluate<Sample<S>>(
        {S(static_cast<S>(x)), S(static_cast<S>(y)), S(static_cast<S>(z))}, Slots<S>(nullptr, 0, &half, 1));
  }
};

struct Numbers {
  double value, x, y, z;
};
template <class S>
Numbers numbers(const Sample<S>& sample) {
  const auto real = [](S s) { return ScalarTraits<S>::to_double(s); };
  return {real(sample.value), real(sample.gradient.x), real(sample.gradient.y), real(sample.gradient.z)};
}

constexpr double place[3] = {0.275, 0.4, 0.15};

// Evaluated in S as in `expected`, within `tolerance`; returns it.
template <class S>
Numbers expect_same(const FieldNode& node, const Numbers& expected, double tolerance) {
  const Evaluated<S> field(node);
  EXPECT_EQ(field.inspection.status, LoadStatus::ok);
  EXPECT_EQ(field.inspection.kind, node.kind);
  const Numbers found = numbers(field.at(place[0], place[1], place[2]));
  EXPECT_NEAR(found.value, expected.value, tolerance);
  EXPECT_NEAR(found.x, expected.x, tolerance);
  EXPECT_NEAR(found.y, expected.y, tolerance);
  EXPECT_NEAR(found.z, expected.z, tolerance);
  return found;
}

// The gradient in S is what differences of the value give.
void expect_gradient_of_differences(const FieldNode& node, const Numbers& found) {
  const Evaluated<Fixed<27>> field(node);
  const double step = 1.0 / 1024.0, length = node.kind == FieldKind::distance ? 1.0 : 1.0 / 16.0;
  const double gradient[3] = {found.x, found.y, found.z};
  for (int axis = 0; axis < 3; ++axis) {
    double above[3] = {place[0], place[1], place[2]}, below[3] = {place[0], place[1], place[2]};
    above[axis] += step;
    below[axis] -= step;
    const double difference = numbers(field.at(above[0], above[1], above[2])).value -
                              numbers(field.at(below[0], below[1], below[2])).value;
    EXPECT_NEAR(gradient[axis], length * difference / (2.0 * step), 2e-4) << "axis " << axis;
  }
}

// The operator called `name` with its fewest operands, and once more than that where it may have more.
std::vector<std::string> nodes_of(const OperatorDescription& row) {
  const FieldKind kind = row.any_kind ? FieldKind::algebraic : row.operand_kind;
  std::vector<std::string> nodes{node_text(row, row.fewest_operands, kind)};
  if (row.most_operands == 64) nodes.push_back(node_text(row, row.fewest_operands + 1, kind));
  return nodes;
}

void check_node(const OperatorDescription& row, const std::string& text) {
  SCOPED_TRACE(text);
  try {
    const FieldNode node = field_of(text);
    EXPECT_TRUE(row.any_kind || node.kind == row.kind);
    const Evaluated<Fixed<27>> field(node);
    EXPECT_EQ(load<Fixed<27>>(field.image.data(), 4 * field.image.size()).status(), LoadStatus::ok);
    const Numbers found = numbers(field.at(place[0], place[1], place[2]));
    EXPECT_NE(found.value, 0.0);
    expect_gradient_of_differences(node, found);
    expect_same<Fixed<24>>(node, found, 1e-5);
    expect_same<Fixed<16>>(node, found, 5e-3);
    expect_same<float>(node, found, 1e-4);
  } catch (const InputError& error) {
    ADD_FAILURE() << error.what();
  }
}

TEST(FieldOperators, EachIsReadCompiledAndEvaluated) {
  for (const OperatorDescription& row : all_operators()) {
    ASSERT_EQ(operator_rows.count(row.name), 1U) << "no row for " << row.name;
    for (const std::string& text : nodes_of(row)) check_node(row, text);
  }
  EXPECT_EQ(operator_rows.size(), all_operators().size());
}

TEST(FieldOperators, EachRefusesOperandsOfOtherKinds) {
  for (const OperatorDescription& row : all_operators()) {
    if (row.most_operands == 0 || row.any_kind) continue;
    for (const FieldKind kind :
         {FieldKind::distance, FieldKind::intensity, FieldKind::ray, FieldKind::algebraic}) {
      if (kind == row.operand_kind) continue;
      const std::string text = scene_of(node_text(row, row.fewest_operands, kind));
      const std::string leaf_name(field_of(leaf(kind, 0)).operator_->name);
      expect_input_error(parse_scene_of_any_kind,
                         {text, "file:3:1: field.operands[0]: \"" + leaf_name + "\" yields a"});
    }
  }
}

TEST(FieldOperators, PlacedNodesYieldWhatTheirOperandYields) {
  const std::string placed = "{\"type\": \"place\", \"position\": [0, 0, 1], \"operands\": [";
  EXPECT_EQ(field_of(placed + leaf(FieldKind::ray, 0) + "]}").kind, FieldKind::ray);
  EXPECT_EQ(field_of(placed + placed + leaf(FieldKind::algebraic, 0) + "]}]}").kind, FieldKind::algebraic);
  expect_input_error(parse_scene_of_any_kind, {scene_of("{\"type\": \"ray_union\", \"operands\": [\n" +
                                                        placed + leaf(FieldKind::ray, 0) + "]},\n" + placed +
                                                        leaf(FieldKind::intensity, 0) + "]}]}"),
                                               "file:4:55: field.operands[1].operands[0]: "
                                               "\"soft_point\" yields an intensity; a ray "
                                               "value is needed here: one of place, "});
}

// Operators that are their operands' own at a far place, and a blend of more operands than one operation
// takes.
TEST(FieldOperators, LogSumExpOfManyOperandsIsBlendedInGroups) {
  std::string text = "{\"type\": \"log_sum_exp_union\", \"sharpness\": 50, \"operands\": [";
  for (int i = 0; i < 40; ++i)
    text += (i > 0 ? "," : "") + std::string("{\"type\": \"sphere\", \"radius\": 0.5}");
  const Evaluated<Fixed<27>> field(field_of(text + "]}"));
  const double distance = std::sqrt(3.0) - 0.5;
  EXPECT_NEAR(numbers(field.at(1, 1, 1)).value, distance - std::log(40.0) / 50.0, 1e-6);
}

TEST(FieldOperators, EqualTablesAreShared) {
  const auto union_of = [](const std::string& second) {
    const std::string blend =
        "{\"type\": \"exterior_union\", "
        "\"blend_radius\": 0.5, \"rising_range\": 0.25, ";
    const std::string operands = "\"operands\": [{\"type\": \"sphere\", \"radius\": 0.3}, ";
    return blend + "\"step\": \"polynomial2\", " + operands + blend + second + operands +
           "{\"type\": \"sphere\", \"radius\": 0.3}]}]}";
  };
  const auto tables_of = [&](const std::string& second) {
    return Evaluated<Fixed<27>>(field_of(union_of(second))).image[image_format::table_words];
  };
  const std::uint32_t one_table = tables_of("\"step\": \"polynomial2\", ");
  EXPECT_EQ(tables_of("\"step\": {\"curve\": \"polynomial\", \"n\": 2}, "), one_table);
  EXPECT_GT(tables_of("\"step\": {\"curve\": \"polynomial\", \"n\": 3}, "), one_table);
}

TEST(FieldOperators, TablesAreAsSmallAsTheErrorAllows) {
  const auto tables_of = [](const std::string& node) {
    return Evaluated<Fixed<27>>(field_of(node)).image[image_format::table_words];
  };
  const std::string operands =
      ", \"operands\": [{\"type\": \"sphere\", "
      "\"radius\": 1}, {\"type\": \"sphere\", "
      "\"radius\": 2}]}";
  constexpr std::uint32_t header = image_format::table_header_words;
  EXPECT_EQ(tables_of("{\"type\": \"quadratic_union\", \"blend_radius\": 0.5" + operands), header + 4U);
  EXPECT_EQ(tables_of("{\"type\": \"soft_point\", \"influence_radius\": 1}"), header + 4U * 2U);
  EXPECT_EQ(tables_of("{\"type\": \"interior_union\", \"rising_range\": 0.5, "
                      "\"step\": \"polynomial1\"" +
                      operands),
            header + 4U);
  // Corners that no table follows: the best there is.
  const std::string corners = "\"rising_range\": 0.4, \"step\": \"polynomial1\"";
  EXPECT_GT(tables_of("{\"type\": \"exterior_union\", \"blend_radius\": 0.1, " + corners + operands),
            header + 4U * 64U);
}

// The remap leaves the surface where it is and moves the end of the influence.
TEST(FieldOperators, RangeControlMovesTheEndOfTheInfluence) {
  const auto intensity = [](double x, const std::string& more) {
    const Evaluated<Fixed<27>> field(
        field_of("{\"type\": \"soft_point\", \"influence_radius\": 1, "
                 "\"potential\": \"wyvill\"" +
                 more + "}"));
    return numbers(field.at(x, 0, 0)).value;
  };
  const std::string narrow = ", \"range_control\": {\"w1\": 0.5, \"w2\": 0.25}";
  EXPECT_NEAR(intensity(0.5, narrow), 0.5, 1e-5);
  EXPECT_GT(intensity(0.74, narrow), 0.0);
  EXPECT_EQ(intensity(0.75, narrow), 0.0);
  EXPECT_GT(intensity(0.75, ""), 0.01);
  EXPECT_GT(intensity(1.2, ", \"range_control\": {\"w1\": 1.5}"), 0.0);
  EXPECT_EQ(intensity(0.3, narrow), 1.0);
}

// Three orthogonal cylinders and three planes: (|p|^2 - 1) / 2 everywhere.
TEST(FieldOperators, RibbonPatchThroughAPoint) {
  const std::string text =
      R"({"type": "ribbon_patch", "side_weights": [1, 1, 1],
    "through": [0.6, 0.48, 0.64], "operands": [
    {"type": "quadric", "diagonal": [0, 0.5, 0.5], "constant": -0.5},
    {"type": "algebraic_plane", "normal": [1, 0, 0]},
    {"type": "quadric", "diagonal": [0.5, 0, 0.5], "constant": -0.5},
    {"type": "algebraic_plane", "normal": [0, 1, 0]},
    {"type": "quadric", "diagonal": [0.5, 0.5, 0], "constant": -0.5},
    {"type": "algebraic_plane", "normal": [0, 0, 1]}]})";
  const Evaluated<Fixed<27>> patch(field_of(text));
  for (const double x : {-0.5, 0.0, 0.3}) {
    for (const double y : {0.0, 0.7}) {
      for (const double z : {-0.9, 0.0, 0.4}) {
        EXPECT_NEAR(numbers(patch.at(x, y, z)).value, 0.5 * (x * x + y * y + z * z - 1.0), 1e-6)
            << x << " " << y << " " << z;
      }
    }
  }
}

// A potential that no table over the square can hold is one over the distance.
TEST(FieldOperators, PotentialsThatNeedTheDistanceItself) {
  const std::string potential =
      "\"influence_radius\": 1, \"potential\": {\"curve\": "
      "\"arctangent_clamped\", \"c1\": 20}";
  const auto compile = [](const std::string& text, const std::string& file) {
    compile_field<Fixed<27>>(parse_scene_of_any_kind(text, file).field, file, SlotOfLink());
  };
  expect_input_error(compile, {scene_of("{\"type\": \"soft_point\", " + potential + "}"),
                               "file:2:60: field.potential: too steep for a table of 256 segments; "});
  const Evaluated<Fixed<27>> field(field_of("{\"type\": \"potential_of_distance\", " + potential +
                                            ", \"operands\": [{\"type\": \"sphere\", \"radius\": 0.25}]}"));
  EXPECT_NEAR(numbers(field.at(0.75, 0, 0)).value, 0.5, 1e-5);
}

}  // namespace
}  // namespace nearfield::host
