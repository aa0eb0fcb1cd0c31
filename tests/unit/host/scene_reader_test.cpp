#include "model/scene_reader.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <set>
#include <stdexcept>
#include <string>
#include <string_view>
#include <vector>

#include "input_error_expectation.hpp"
#include "model/curve_reader.hpp"
#include "scene_text.hpp"

namespace nearfield::host {
namespace {

TEST(SceneReader, ReadsEverything) {
  const SceneDescription scene = parse_scene(scene_text, "scenes/cell.json");
  EXPECT_EQ(scene.file, "scenes/cell.json");
  EXPECT_EQ(scene.name, "cell");
  EXPECT_EQ(scene.duration, 12.5);
  EXPECT_EQ(scene.robot, "scenes/arm.urdf");
  EXPECT_EQ(scene.tool_link, "hand");
  ASSERT_TRUE(scene.person.has_value());
  EXPECT_EQ(scene.person->robot, "scenes/person.urdf");
  ASSERT_EQ(scene.person->path.size(), 2U);
  EXPECT_EQ(scene.person->path[1].time, 2.0);
  EXPECT_EQ(scene.person->path[1].joints.at("walk"), 1.5);
  ASSERT_TRUE(scene.cycle.has_value());
  ASSERT_EQ(scene.cycle->waypoints.size(), 3U);
  EXPECT_EQ(scene.cycle->waypoints[0].event, "grip");
  EXPECT_FALSE(scene.cycle->waypoints[1].event.has_value());
  EXPECT_EQ(scene.cycle->waypoints[1].joints.at("b"), 2.0);
  ASSERT_TRUE(scene.separation.has_value());
  EXPECT_EQ(scene.separation->human_speed, 1.6);
  EXPECT_EQ(scene.separation->cell_slow, 0.1);
  ASSERT_TRUE(scene.soft.has_value());
  EXPECT_EQ(scene.soft->operands[0].number("weight"), -2.0);
  EXPECT_EQ(scene.soft->operands[1].number("weight"), 1.0);
  EXPECT_EQ(scene.soft->operands[1].choices.at("potential"), "wyvill");
  EXPECT_EQ(scene.soft->operands[1].vector("to").x, 1.0);
}

TEST(SceneReader, ReadsFieldNodes) {
  const FieldNode field = parse_scene(scene_text, "f").field;
  EXPECT_EQ(field.operator_->name, "union");
  EXPECT_EQ(field.name, "all");
  EXPECT_EQ(field.path, "field");
  EXPECT_EQ(field.position.line, 7U);
  EXPECT_EQ(field.position.column, 12U);
  ASSERT_EQ(field.operands.size(), 8U);
  const FieldNode& sphere = field.operands[0];
  EXPECT_EQ(sphere.operator_, find_operator("sphere"));
  EXPECT_EQ(sphere.number("radius"), 0.25);
  EXPECT_EQ(sphere.placement.position.y, 2.0);
  EXPECT_FALSE(sphere.link.has_value());
  EXPECT_EQ(field.operands[1].link, "person/arm");
  EXPECT_EQ(field.operands[1].vector("to").z, 1.0);
  EXPECT_EQ(field.operands[2].placement.position.z, 1.0);
  EXPECT_NEAR(field.operands[2].placement.rotation[3], 0.99749498660405445, 1e-15);
  const FieldNode& blend = field.operands[4];
  EXPECT_EQ(blend.number("rising_range"), 0.005);
  EXPECT_EQ(blend.choices.at("step"), "polynomial2");
  EXPECT_EQ(field.operands[5].choices.at("step"), "polynomial3");
  EXPECT_EQ(blend.operands[1].operands[1].path, "field.operands[4].operands[1].operands[1]");
  EXPECT_THROW(static_cast<void>(sphere.number("size")), std::out_of_range);
}

TEST(SceneReader, ReadsFieldsOfAnyKindWhereTheyAreOnlyEvaluated) {
  const auto scene = [](const std::string& field) {
    return "{\"format\": \"nearfield-scene-1\", \"name\": \"a\", \"field\":\n" + field + "}";
  };
  const std::string soft = scene("{\"type\": \"soft_point\", \"influence_radius\": 1}");
  const SceneDescription read = parse_scene_of_any_kind(soft, "file");
  EXPECT_EQ(read.field.kind, FieldKind::intensity);
  EXPECT_EQ(read.duration, 0.0);
  const std::string mixed = "{\"type\": \"soft_sum\", \"operands\": [{\"type\": \"ray_point\"}]}";
  const std::vector<Malformed> cases{
      {scene(mixed),
       "file:2:35: field.operands[0]: \"ray_point\" yields a ray value; an intensity is needed here"},
      {scene("{\"type\": \"soft_some\"}"),
       "file:2:10: field.type: unknown name \"soft_some\" (did you mean \"soft_sum\"?)"},
  };
  for (const Malformed& malformed : cases) expect_input_error(parse_scene_of_any_kind, malformed);
  expect_input_error(parse_scene, {soft, "file:1:1: duration: missing"});
}

TEST(SceneReader, RefusesWrongScenes) {
  const auto changed = [](std::string_view from, std::string_view to) { return with(scene_text, from, to); };
  const std::vector<Malformed> cases{
      {"[]", "file:1:1: document: an array is not allowed here; an object"},
      {"{}", "file:1:1: format: missing; required: \"nearfield-scene-1\""},
      {changed("nearfield-scene-1", "nearfield-scene-2"),
       "file:2:13: format: unknown name \"nearfield-scene-2\" (did you mean \"nearfield-scene-1\"?)"},
      {changed("\"tool_link\"", "\"tool_lnik\""),
       "file:6:3: tool_lnik: unknown key \"tool_lnik\" (did you mean \"tool_link\"?); allowed keys: format, "
       "name,"},
      {changed("\"name\": \"cell\",", ""), "file:1:1: name: missing"},
      {changed("\"cell\"", "\"\""), "file:3:11: name: empty string"},
      {changed("12.5", "0"), "file:4:15: duration: 0 is out of range; a number above 0 and at most 3600 s"},
      {changed("12.5", "3601"), "file:4:15: duration: 3601 is out of range"},
      {changed("\"time\": 2", "\"time\": 1"), "file:26:14: person.path[1].time: 1 is not later"},
      {changed("{\"walk\": 1.5}", "{\"wlak\": 1.5}"), "file:26:27: person.path[1].joints: other joints"},
      {changed("{\"walk\": 1.5}}", "{\"walk\": 1.5}, \"event\": \"x\"}"),
       "file:26:42: person.path[1].event: unknown key \"event\""},
      {changed("\"time\": 0", "\"time\": 0.5"),
       "file:28:14: cycle.waypoints[0].time: the cycle does not start"},
      {changed("\"time\": 4", "\"time\": -4"), "file:29:14: cycle.waypoints[1].time: -4 is out of range"},
      {changed("\"time\": 8, \"joints\": {\"a\": 0", "\"time\": 8, \"joints\": {\"a\": 0.1"),
       "file:30:27: cycle.waypoints[2].joints: the cycle does not end where it starts"},
      {changed("{\"a\": 1, \"b\": 2}", "{\"a\": \"1\", \"b\": 2}"),
       "file:29:33: cycle.waypoints[1].joints.a: a string is not allowed here; a number from -1000 to 1000 "
       "rad or m"},
      {changed("\"cell_slow\": 0.1", "\"cell_slow\": 0.02"),
       "file:33:107: separation.cell_slow: 0.02 is not above cell_stop; above 0.02 m"},
      {changed("\"reaction_time\": 0.1, ", ""),
       "file:31:17: separation.reaction_time: missing; required: a number"},
      {changed("\"slow_override\": 0.25", "\"slow_override\": 1.25"),
       "file:33:49: separation.slow_override: 1.25 is out of range; a number from 0 to 1"},
      {changed("\"human_speed\"", "\"humanspeed\""),
       "file:31:18: separation.humanspeed: unknown key \"humanspeed\" (did you mean \"human_speed\"?)"},
      {changed("\"person\": {\"robot\": \"person.urdf\", \"path\": [\n    {\"time\": 1, \"joints\": "
               "{\"walk\": 0}},\n"
               "    {\"time\": 2, \"joints\": {\"walk\": 1.5}}]},\n",
               ""),
       "file:9:5: field.operands[1].link: link of a person, but the scene has none"},
  };
  for (const Malformed& malformed : cases) expect_input_error(parse_scene, malformed);
}

TEST(SceneReader, RefusesWrongFields) {
  const auto scene = [](const std::string& field) {
    return "{\"format\": \"nearfield-scene-1\", \"name\": \"a\", \"duration\": 1, \"field\":\n" + field + "}";
  };
  const std::string ball = "{\"type\": \"sphere\", \"radius\": 1}";
  const std::vector<Malformed> cases{
      {scene("1"), "file:2:1: field: a number is not allowed here; an object"},
      {scene("{}"), "file:2:1: field.type: missing; required: one of sphere, capsule, box"},
      {scene("{\"type\": \"shpere\"}"),
       "file:2:10: field.type: unknown name \"shpere\" (did you mean \"sphere\"?)"},
      {scene("{\"type\": \"soft_sum\"}"),
       "file:2:1: field: \"soft_sum\" yields an intensity; a distance is needed"},
      {scene("{\"type\": \"sphere\", \"raduis\": 1}"),
       "file:2:20: field.raduis: unknown key \"raduis\" (did you mean \"radius\"?); allowed keys: type, "
       "name, radius"},
      {scene("{\"type\": \"sphere\"}"), "file:2:1: field.radius: missing; required: a number from 0"},
      {scene("{\"type\": \"sphere\", \"radius\": 16.1}"), "file:2:30: field.radius: 16.1 is out of range"},
      {scene("{\"type\": \"sphere\", \"radius\": 1, \"rpy\": [0, 0, 0]}"),
       "file:2:33: field.rpy: unknown key"},
      {scene("{\"type\": \"sphere\", \"radius\": 1, \"position\": [0, 0, -17]}"),
       "file:2:52: field.position[2]: -17 is out of range; a number from -16 to 16 m"},
      {scene("{\"type\": \"box\", \"size\": [1, 1]}"),
       "file:2:25: field.size: array of 2; an array of 3 numbers"},
      {scene("{\"type\": \"box\", \"size\": [1, 1, 1], \"orientation_xyzw\": [0, 0, 0.1, 1]}"),
       "file:2:56: field.orientation_xyzw: the quaternion is not of unit length; a norm within 1e-6"},
      {scene("{\"type\": \"box\", \"size\": [1, 1, 1], \"orientation_xyzw\": [0, 0, 0, 1], \"rpy\": [0, 0, "
             "0]}"),
       "file:2:77: field.rpy: a second orientation"},
      {scene("{\"type\": \"capsule\", \"from\": [0, 0, 0], \"radius\": 1}"),
       "file:2:1: field.to: missing; required: 3"},
      {scene("{\"type\": \"union\"}"), "file:2:1: field.operands: missing"},
      {scene("{\"type\": \"union\", \"operands\": [" + ball + "]}"),
       "file:2:31: field.operands: array of 1; an array of 2 to 64 elements"},
      {scene("{\"type\": \"union\", \"operands\": [" + ball +
             ",\n{\"type\": \"soft_point\", \"influence_radius\": 1}]}"),
       "file:3:1: field.operands[1]: \"soft_point\" yields an intensity; a distance is needed"},
      {scene("{\"type\": \"sphere\", \"radius\": 1, \"operands\": []}"),
       "file:2:33: field.operands: unknown key"},
      {scene("{\"type\": \"exterior_union\", \"blend_radius\": 0.1, \"rising_range\": 0.41, \"operands\": [" +
             ball + "," + ball + "]}"),
       "file:2:65: field.rising_range: 0.41 does not fit blend_radius 0.1; from 0.05 to 4 times "
       "blend_radius"},
      {scene(
           "{\"type\": \"exterior_union\", \"blend_radius\": 0.1, \"rising_range\": 0.0049, \"operands\": [" +
           ball + "," + ball + "]}"),
       "file:2:65: field.rising_range: 0.0049 does not fit"},
      {scene("{\"type\": \"exterior_union\", \"blend_radius\": 0.1, \"rising_range\": 0.1, \"step\": "
             "\"polynomial4\"}"),
       "file:2:78: field.step: unknown name \"polynomial4\" (did you mean \"polynomial3\"?)"},
      {scene("{\"type\": \"place\", \"operands\": [" + ball + "]}"),
       "file:2:1: field: \"place\" without a placement"},
      {scene("{\"type\": \"place\", \"link\": \"person/\", \"operands\": [" + ball + "]}"),
       "file:2:27: field.link: no link name after person/"},
      {scene("{\"type\": \"place\", \"link\": \"a\", \"operands\": [\n"
             "{\"type\": \"sphere\", \"radius\": 1, \"link\": \"b\"}]}"),
       "file:3:41: field.operands[0].link: a link inside a placed node"},
      {scene("{\"type\": \"sphere\", \"radius\": 1, \"name\": 7}"),
       "file:2:41: field.name: a number is not allowed"},
  };
  for (const Malformed& malformed : cases) expect_input_error(parse_scene, malformed);
}

TEST(Operators, TheTableIsConsistent) {
  std::set<std::string_view> names;
  for (const OperatorDescription& row : all_operators()) {
    EXPECT_TRUE(names.insert(row.name).second) << row.name;
    EXPECT_LE(row.fewest_operands, row.most_operands) << row.name;
    for (const ParameterDescription& parameter : row.parameters) {
      EXPECT_TRUE(parameter.default_values.empty() || parameter.default_values.size() == parameter.count);
      for (const double value : parameter.default_values)
        EXPECT_TRUE(contains(parameter.range, value)) << row.name;
    }
    for (const ChoiceDescription& choice : row.choices) EXPECT_FALSE(choice.names.empty()) << row.name;
    for (const CurveDescription& curve : row.curves) {
      const std::vector<std::string_view> known = curve_names(curve.family);
      EXPECT_EQ(std::count(known.begin(), known.end(), curve.default_name), 1) << row.name;
    }
  }
}

}  // namespace
}  // namespace nearfield::host
