#include "model/problems.hpp"

#include <gtest/gtest.h>

#include <string>
#include <vector>

#include "input_error_expectation.hpp"

namespace nearfield::host {
namespace {

const std::string problem_text = R"([{"set": "shelf", "index": 3, "objects": [
  {"name": "can", "type": "cylinder", "position": [1, 2, 3], "orientation_xyzw": [0, 0, 1, 0], "height": 0.5,
   "radius": 0.25},
 {"name": "board", "type": "box", "position": [0, 0, 1], "orientation_xyzw": [0, 0, 0, 1], "size": [1, 2, 3]},
  {"type": "sphere", "position": [0, 1, 0], "radius": 0.75}],
  "start": {"a": 0.5}, "goal": {"a": -1, "b": 2}}])";

TEST(Problems, ReadsObjectsAndJointValues) {
  const std::vector<Problem> problems = parse_problems(problem_text, "f");
  ASSERT_EQ(problems.size(), 1U);
  const Problem& problem = problems[0];
  EXPECT_EQ(problem.set, "shelf");
  EXPECT_EQ(problem.index, 3);
  ASSERT_EQ(problem.objects.size(), 3U);
  EXPECT_EQ(problem.objects[0].kind, CollisionKind::cylinder);
  EXPECT_EQ(problem.objects[0].length, 0.5);
  EXPECT_EQ(problem.objects[0].radius, 0.25);
  EXPECT_EQ(problem.objects[0].origin.position.y, 2.0);
  EXPECT_EQ(problem.objects[0].origin.rotation[0], -1.0);
  EXPECT_EQ(problem.objects[1].kind, CollisionKind::box);
  EXPECT_EQ(problem.objects[1].size.z, 3.0);
  EXPECT_EQ(problem.objects[2].kind, CollisionKind::sphere);
  EXPECT_EQ(problem.objects[2].radius, 0.75);
  EXPECT_EQ(problem.start.at("a"), 0.5);
  EXPECT_EQ(problem.goal.at("b"), 2.0);
}

TEST(Problems, RefusesWrongProblems) {
  const auto changed = [](std::string_view from, std::string_view to) {
    return with(problem_text, from, to);
  };
  const std::vector<Malformed> cases{
      {"{}", "file:1:1: document: an object is not allowed here; an array of 0 to 100000 elements"},
      {"[1]", "file:1:2: [0]: a number is not allowed here"},
      {changed("\"set\"", "\"sets\""), "file:1:3: [0].sets: unknown key \"sets\" (did you mean \"set\"?)"},
      {changed("\"index\": 3", "\"index\": 3.5"), "file:1:28: [0].index: 3.5 is not a whole number"},
      {changed("\"index\": 3", "\"index\": -3"), "file:1:28: [0].index: -3 is out of range"},
      {changed("\"cylinder\"", "\"cilinder\""),
       "file:2:27: [0].objects[0].type: unknown name \"cilinder\" (did you mean \"cylinder\"?)"},
      {changed("\"height\": 0.5,\n", "\n"), "file:2:3: [0].objects[0].height: missing"},
      {changed("\"radius\": 0.25", "\"radius\": 0"), "file:3:14: [0].objects[0].radius: 0 is out of range"},
      {changed("\"radius\": 0.25", "\"radius\": 1, \"size\": [1, 1, 1]"),
       "file:3:17: [0].objects[0].size: unknown key"},
      {changed("\"position\": [0, 1, 0], ", ""), "file:5:3: [0].objects[2].position: missing"},
      {changed("[0, 0, 1, 0]", "[0, 0, 1, 1]"), "file:2:82: [0].objects[0].orientation_xyzw: the quaternion"},
      {changed("{\"a\": 0.5}", "{\"a\": null}"), "file:6:18: [0].start.a: null is not allowed here"},
  };
  for (const Malformed& malformed : cases) expect_input_error(parse_problems, malformed);
}

}  // namespace
}  // namespace nearfield::host
