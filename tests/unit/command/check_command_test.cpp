// `nearfield check` on a robot of two balls, and on what it must refuse.
#include <cstdlib>
#include <regex>

#include "command_runner.hpp"
#include "text/json.hpp"
#include "text/json_node.hpp"
#include "unit/host/input_error_expectation.hpp"

namespace nearfield::host {
namespace {

// A ball at the base and one that slides along x, at 0.5 m for a joint value of 0.
const std::string robot = R"(<robot name="slide">
  <link name="base"><collision><geometry><sphere radius="0.1"/></geometry></collision></link>
  <link name="hand"><collision><geometry><sphere radius="0.05"/></geometry></collision></link>
  <joint name="slide" type="prismatic"><parent link="base"/><child link="hand"/><origin xyz="0.5 0 0"/>
    <axis xyz="1 0 0"/><limit lower="-0.45" upper="0.5"/></joint>
</robot>
)";
const std::string pairs = R"(<robot name="slide"></robot>)";
// A wall whose near face lies at x = 0.9; the hand touches it at a joint value of 0.35, the base at -0.35.
const std::string problems = R"([
  {"set": "slide", "index": 1, "objects": [{"type": "box", "position": [1, 0, 0], "size": [0.2, 1, 1]}],
   "start": {"slide": 0}, "goal": {"slide": 0.25}},
  {"set": "slide", "index": 2, "objects": [{"type": "box", "position": [1, 0, 0], "size": [0.2, 1, 1]}],
   "start": {"slide": -0.25}, "goal": {"slide": 0.125}}
])";

class CheckCommand : public testing::Test {
 protected:
  void SetUp() override {
    folder_.write("robot.urdf", robot);
    folder_.write("robot.srdf", pairs);
    folder_.write("problems.json", problems);
  }
  Outcome check(const std::vector<std::string>& more = {}) const {
    std::vector<std::string> arguments = {"check",      "--robot",    "robot.urdf",   "--srdf",
                                          "robot.srdf", "--problems", "problems.json"};
    arguments.insert(arguments.end(), more.begin(), more.end());
    return folder_.run(arguments);
  }
  std::string refused(const std::string& problem_text) const {
    folder_.write("bad.json", problem_text);
    return refusal(folder_,
                   {"check", "--robot", "robot.urdf", "--srdf", "robot.srdf", "--problems", "bad.json"});
  }

  ScratchFolder folder_;
};

// Exactly the fields of the panda data's expected.json.
std::vector<double> clearances_in(const JsonNode& problem) {
  problem.reject_unknown_keys({"set", "index", "start", "goal"});
  std::vector<double> values;
  for (const char* which : {"start", "goal"}) {
    const JsonNode configuration = problem.required(which);
    configuration.reject_unknown_keys({"scene_clearance", "self_clearance"});
    values.push_back(configuration.required("scene_clearance").number({}));
    values.push_back(configuration.required("self_clearance").number({}));
  }
  return values;
}

TEST_F(CheckCommand, AllClear) {
  const Outcome outcome = check();
  EXPECT_EQ(outcome.status, 0);
  EXPECT_EQ(outcome.err, "");
  EXPECT_EQ(outcome.out, "2 of 2 problems have a clear start and goal\n");
}

TEST_F(CheckCommand, Json) {
  const Outcome outcome = check({"--json"});
  EXPECT_EQ(outcome.status, 0);
  EXPECT_EQ(outcome.err, "");
  const JsonDocument document = parse_json(outcome.out, "output");
  const std::vector<JsonNode> list = JsonNode(document).elements(2, 2);
  const std::vector<double> expected[] = {{0.35, 0.35, 0.1, 0.6}, {0.6, 0.1, 0.225, 0.475}};
  for (std::size_t i = 0; i < 2; ++i) {
    EXPECT_EQ(list[i].required("set").string(100), "slide");
    EXPECT_EQ(list[i].required("index").integer(0, 9), static_cast<std::int64_t>(i) + 1);
    const std::vector<double> found = clearances_in(list[i]);
    for (std::size_t j = 0; j < 4; ++j) {
      EXPECT_LE(found[j], expected[i][j]) << i << " " << j;
      EXPECT_GT(found[j], expected[i][j] - 2e-6) << i << " " << j;
    }
  }
}

TEST_F(CheckCommand, StatusIsOneWhenAProblemIsNotClear) {
  for (const auto& [goal, words] :
       {std::pair("0.375", "slide 1: goal scene -0.025"), std::pair("-0.375", "self -0.025")}) {
    folder_.write("problems.json", with(problems, "\"goal\": {\"slide\": 0.25}",
                                        std::string("\"goal\": {\"slide\": ") + goal + "}"));
    const Outcome outcome = check();
    EXPECT_EQ(outcome.status, 1);
    EXPECT_EQ(outcome.err, "");
    EXPECT_NE(outcome.out.find(words), std::string::npos) << outcome.out;
    EXPECT_NE(outcome.out.find("1 of 2 problems have a clear start and goal\n"), std::string::npos)
        << outcome.out;
    const Outcome json = check({"--json"});
    EXPECT_EQ(json.status, 1);
    EXPECT_EQ(json.err, "");
    const JsonDocument document = parse_json(json.out, "output");
    const std::vector<double> values = clearances_in(JsonNode(document).elements(2, 2)[0]);
    EXPECT_LT(std::min(values[2], values[3]), 0.0);
  }
}

TEST_F(CheckCommand, LinkPairsThatAreNotChecked) {
  folder_.write("problems.json",
                with(problems, "\"goal\": {\"slide\": 0.25}", "\"goal\": {\"slide\": -0.375}"));
  EXPECT_EQ(check().status, 1);
  folder_.write(
      "robot.srdf",
      R"(<robot name="slide"><disable_collisions link1="base" link2="hand" reason="Adjacent"/></robot>)");
  EXPECT_EQ(check().status, 0);
  // Without a list of pairs, links that a joint joins are not checked against each other.
  EXPECT_EQ(folder_.run({"check", "--robot", "robot.urdf", "--problems", "problems.json"}).status, 0);
}

TEST_F(CheckCommand, NoProblemsAndNoObjects) {
  folder_.write("problems.json", "[]");
  EXPECT_EQ(check().status, 0);
  folder_.write("problems.json",
                R"([{"set": "s", "index": 0, "objects": [], "start": {"slide": 0}, "goal": {"slide": 0}}])");
  const Outcome outcome = check({"--json"});
  EXPECT_EQ(outcome.status, 0) << outcome.err;
  EXPECT_NO_THROW(parse_json(outcome.out, "output"));
}

// Joint values that do not fit the robot are refused at the object of joint values.
TEST_F(CheckCommand, RefusesBadProblems) {
  struct {
    const char* from;
    const char* to;
    const char* line;
  } const cases[] = {
      {"\"goal\": {\"slide\": 0.25}", "\"goal\": {\"slide\": 0.625}", "bad.json:3:35: [0].goal.slide: 0.625"},
      {"\"goal\": {\"slide\": 0.25}", "\"goal\": {\"slide\": -0.5}", "bad.json:3:35: [0].goal.slide: -0.5"},
      {"\"goal\": {\"slide\": 0.25}", "\"goal\": {\"slide\": \"0\"}",
       "bad.json:3:45: [0].goal.slide: a string is not allowed"},
      {"\"goal\": {\"slide\": 0.25}", "\"goal\": {\"glide\": 0.25}",
       "bad.json:3:35: [0].goal.glide: the robot has no such joint"},
      {"\"goal\": {\"slide\": 0.25}", "\"goal\": {}",
       "bad.json:3:35: [0].goal: no value for the joint slide"},
      {"\"goal\": {\"slide\": 0.25}", "\"gaol\": {\"slide\": 0.25}",
       "bad.json:3:27: [0].gaol: unknown key \"gaol\""},
      {"{\"slide\": 0.125}}\n]", "{\"slide\": 0.125}}", "bad.json:5:"},
      {"{\"slide\": 0.125}}\n]", "{\"slide\": 0.125}}\n]]", "bad.json:6:2: "},
  };
  for (const auto& [from, to, start] : cases) {
    const std::string line = refused(with(problems, from, to));
    EXPECT_EQ(line.substr(0, std::string(start).size()), start) << to;
  }
}

TEST_F(CheckCommand, RefusesObstaclesOutOfRange) {
  const std::string one =
      R"([{"set": "s", "index": 0, "objects": [{"type": "sphere", "position": [1, 0, 0], "radius": 0.1}],
   "start": {"slide": 0}, "goal": {"slide": 0}}])";
  for (const auto& [from, to, place] :
       {std::tuple("[1, 0, 0]", "[5, 0, 0]", "[0].objects[0]"),
        std::tuple("[1, 0, 0]", "[50, 0, 0]", "[0].objects[0].position[0]: 50"),
        std::tuple("0.1", "-0.1", "[0].objects[0].radius: -0.1"),
        std::tuple("\"sphere\"", "\"ball\"", "[0].objects[0].type: ")}) {
    const std::string line = refused(with(one, from, to));
    EXPECT_TRUE(std::regex_search(line, std::regex("^bad.json:1:\\d+: "))) << line;
    EXPECT_NE(line.find(place), std::string::npos) << line;
  }
}

TEST_F(CheckCommand, RefusesBadRobots) {
  folder_.write("bad.urdf", with(robot, "radius=\"0.05\"", "radius=\"-0.05\""));
  expect_refusal(folder_, {"check", "--robot", "bad.urdf", "--problems", "problems.json"}, "bad.urdf:3:");
  folder_.write("bad.urdf", "<robot name=\"r\"><link name=\"a\"/></robot>");
  expect_refusal(folder_, {"check", "--robot", "bad.urdf", "--problems", "problems.json"},
                 "bad.urdf: robot: no collision shapes");
  folder_.write("bad.srdf", "<robot><disable_collisions link1=\"base\" link2=\"hnad\"/></robot>");
  expect_refusal(folder_,
                 {"check", "--robot", "robot.urdf", "--srdf", "bad.srdf", "--problems", "problems.json"},
                 "bad.srdf:1:");
}

TEST_F(CheckCommand, PandaAsTheCommandSeesIt) {
  const char* shared = std::getenv("NEARFIELD_SHARED_DATA");
  if (shared == nullptr) GTEST_SKIP() << "NEARFIELD_SHARED_DATA is not set: the panda data is not checked";
  const std::filesystem::path panda = std::filesystem::path(shared) / "panda";
  if (!std::filesystem::is_directory(panda))
    GTEST_SKIP() << panda << " is not there: the panda data is not checked";
  const Outcome outcome = folder_.run({"check", "--robot", panda / "panda_spherized.urdf", "--srdf",
                                       panda / "panda.srdf", "--problems", panda / "problems.json"});
  EXPECT_EQ(outcome.status, 1) << outcome.err;
  EXPECT_EQ(outcome.err, "");
  EXPECT_EQ(outcome.out.find("table_pick_panda 41: goal scene -0.00362"), 0U) << outcome.out;
  EXPECT_NE(outcome.out.find("\n699 of 700 problems have a clear start and goal\n"), std::string::npos)
      << outcome.out;
}

}  // namespace
}  // namespace nearfield::host
