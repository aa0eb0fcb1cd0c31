// Curves of the catalogue in scenes: names, objects with parameters, range control.
#include <gtest/gtest.h>

#include <string>
#include <string_view>
#include <vector>

#include "input_error_expectation.hpp"
#include "model/curve_reader.hpp"
#include "model/scene_reader.hpp"

namespace nearfield::host {
namespace {

std::string scene_of(const std::string& node) {
  return "{\"format\": \"nearfield-scene-1\", \"name\": \"a\", \"field\":\n" + node + "}";
}
std::string blend_with(const std::string& step) {
  return scene_of(
      "{\"type\": \"interior_union\", \"rising_range\": 0.1, \"step\":\n" + step +
      ", \"operands\": [{\"type\": \"sphere\", \"radius\": 1}, {\"type\": \"sphere\", \"radius\": 2}]}");
}
std::string soft_with(const std::string& potential) {
  return scene_of("{\"type\": \"soft_point\", \"influence_radius\": 1, \"potential\":\n" + potential + "}");
}

ConfiguredCurve step_of(const std::string& text) {
  return parse_scene_of_any_kind(blend_with(text), "file").field.curves.at("step");
}
ConfiguredCurve potential_of(const std::string& text) {
  return parse_scene_of_any_kind(soft_with(text), "file").field.curves.at("potential");
}

TEST(FieldCurves, EveryNameOfTheCatalogueIsACurve) {
  for (const CatalogueEntry& entry : curve_catalogue()) {
    const std::string name = "\"" + std::string(entry.name) + "\"";
    const bool is_step = entry.family == CurveFamily::step;
    const ConfiguredCurve by_name = is_step ? step_of(name) : potential_of(name);
    const ConfiguredCurve by_object =
        is_step ? step_of("{\"curve\": " + name + "}") : potential_of("{\"curve\": " + name + "}");
    const ConfiguredCurve expected = configured_curve(std::string(entry.name), {});
    EXPECT_EQ(by_name.name, entry.name);
    EXPECT_EQ(by_name.parameters, expected.parameters);
    EXPECT_EQ(by_object.parameters, expected.parameters);
  }
}

// Every parameter of every curve may be given, and its default changes nothing.
TEST(FieldCurves, DefaultsMayBeWritten) {
  for (const CatalogueEntry& entry : curve_catalogue()) {
    std::string object = "{\"curve\": \"" + std::string(entry.name) + "\"";
    for (const CurveParameter& parameter : entry.parameters) {
      const std::string values = settable_text(parameter.initial, parameter.initial_count);
      object += ", \"" + std::string(parameter.name) +
                "\": " + (parameter.greatest_count > 1 ? "[" + values + "]" : values);
    }
    const ConfiguredCurve curve =
        entry.family == CurveFamily::step ? step_of(object + "}") : potential_of(object + "}");
    EXPECT_EQ(curve.parameters, configured_curve(std::string(entry.name), {}).parameters) << object;
  }
}

TEST(FieldCurves, ShortFormsAndParameters) {
  EXPECT_EQ(step_of("\"polynomial1\"").parameters, "n = 1");
  EXPECT_EQ(step_of("\"polynomial2\"").parameters, "n = 2");
  EXPECT_EQ(step_of("\"polynomial3\"").parameters, "n = 3");
  EXPECT_EQ(step_of("{\"curve\": \"polynomial\", \"n\": 5}").parameters, "n = 5");
  EXPECT_EQ(step_of("{\"curve\": \"polynomial2\"}").parameters, "n = 2");
  EXPECT_EQ(potential_of("{\"curve\": \"arctangent\", \"c1\": 20, \"c2\": 0.25}").parameters,
            "c1 = 20, c2 = 0.25");
  EXPECT_EQ(potential_of("{\"curve\": \"blanc\", \"s\": 0.05}").parameters, "s = 0.05");
  EXPECT_EQ(potential_of("{\"curve\": \"bezier\", \"b\": [1, 1, 0.25, 0, 0]}").parameters,
            "b = (1, 1, 0.25, 0, 0)");
}

TEST(FieldCurves, RangeControlStandsBesideThePotential) {
  const ConfiguredCurve curve = potential_of("\"cubic\", \"range_control\": {\"w1\": 0.5, \"w2\": 0.25}");
  EXPECT_EQ(curve.parameters, "w1 = 0.5, w2 = 0.25");
  EXPECT_EQ(curve.curve.facts().to, 0.75);
  EXPECT_EQ(potential_of("\"cubic\", \"range_control\": {\"w1\": 0.5}").parameters, "w1 = 0.5, w2 = 0.5");
  const std::string by_default =
      "{\"type\": \"soft_point\", \"influence_radius\": 1, \"range_control\": {\"w1\": 2}}";
  const FieldNode node = parse_scene_of_any_kind(scene_of(by_default), "file").field;
  EXPECT_EQ(node.curves.at("potential").name, "wyvill");
  EXPECT_EQ(node.curves.at("potential").curve.facts().to, 1.5);
}

TEST(FieldCurves, WrongCurvesAreRefused) {
  const std::vector<Malformed> cases{
      {blend_with("\"logistics\""),
       "file:3:1: field.step: unknown name \"logistics\" (did you mean \"logistic\"?); one of polynomial3, "},
      {blend_with("\"wyvill\""), "file:3:1: field.step: unknown name \"wyvill\"; one of polynomial3, "},
      {blend_with("3"), "file:3:1: field.step: neither a curve's name nor an object; a name or "},
      {blend_with("[]"), "file:3:1: field.step: neither a curve's name nor an object; a name or "},
      {blend_with("{}"), "file:3:1: field.step.curve: missing; required: a curve's name"},
      {blend_with("{\"curve\": \"polynomal\"}"),
       "file:3:11: field.step.curve: unknown name \"polynomal\" (did you mean \"polynomial\"?)"},
      {blend_with("{\"curve\": \"polynomial\", \"m\": 3}"),
       "file:3:25: field.step.m: unknown key \"m\"; allowed keys: curve, n"},
      {blend_with("{\"curve\": \"polynomial2\", \"n\": 3}"), "file:3:26: field.step.n: unknown key \"n\""},
      {blend_with("{\"curve\": \"polynomial\", \"n\": 2.5}"),
       "file:3:30: field.step.n: 2.5 is not a whole number; a whole number from 1 to 8"},
      {blend_with("{\"curve\": \"polynomial\", \"n\": 9}"), "file:3:30: field.step.n: 9 is out of range"},
      {blend_with("{\"curve\": \"logistic\", \"alhpa\": 9}"),
       "file:3:23: field.step.alhpa: unknown key \"alhpa\" (did you mean \"alpha\"?)"},
      {blend_with("{\"curve\": \"logistic\", \"alpha\": \"9\"}"),
       "file:3:32: field.step.alpha: a string is not allowed here; a number from 1 to 200"},
      {blend_with("\"logistic\", \"range_control\": {\"w1\": 1}"),
       "file:3:13: field.range_control: unknown key \"range_control\""},
      {soft_with("{\"curve\": \"arctangent\", \"c1\": 0}"),
       "file:3:31: field.potential.c1: 0 is out of range; a number from 1 to 1000"},
      {soft_with("{\"curve\": \"bezier\", \"b\": 1}"),
       "file:3:26: field.potential.b: a number is not allowed here"},
      {soft_with("{\"curve\": \"bezier\", \"b\": [1, 1, 7, 0]}"),
       "file:3:33: field.potential.b[2]: 7 is out of range; a number from 0 to 1"},
      {soft_with("{\"curve\": \"bezier\", \"b\": [1]}"),
       "file:3:26: field.potential.b: array of 1; an array of "},
      {soft_with("{\"curve\": \"wyvill\", \"radius\": 0.1, \"intensity\": 0.01}"),
       "file:3:1: field.potential: a curve through this point is not monotone; values that fit each other"},
      {soft_with("\"cubic\", \"range_control\": 1"),
       "file:3:27: field.range_control: a number is not allowed here"},
      {soft_with("\"cubic\", \"range_control\": {\"w3\": 1}"),
       "file:3:28: field.range_control.w3: unknown key \"w3\" (did you mean \"w1\"?); allowed keys: w1, w2"},
      {soft_with("\"cubic\", \"range_control\": {\"w1\": 4}"),
       "file:3:34: field.range_control.w1: 4 is out of range"},
      {soft_with("\"cubic\", \"range_control\": {\"w1\": 0.5, \"w2\": 0.75}"),
       "file:3:27: field.range_control: w2 is above 0, at most 1 and at most w1; values that fit each other"},
      {soft_with("\"arctangent\", \"range_control\": {\"w1\": 0.5}"),
       "file:3:32: field.range_control: a potential that misses 1 or 0 at its ends has no range control"},
  };
  for (const Malformed& malformed : cases) expect_input_error(parse_scene_of_any_kind, malformed);
}

}  // namespace
}  // namespace nearfield::host
