// Wrong scenes, robots and link pairs given to the command: each is refused in one line that names the place.
#include <regex>

#include "command_runner.hpp"
#include "unit/host/input_error_expectation.hpp"

namespace nearfield::host {
namespace {

// A folder with copies of the scene and the robots that come with Nearfield.
class CommandBadInput : public testing::Test {
 protected:
  void SetUp() override {
    for (const char* name : {"scenes", "robots"}) {
      std::filesystem::copy(std::filesystem::path(NEARFIELD_SOURCE_DIR "/host_sim") / name,
                            folder_.path() / name, std::filesystem::copy_options::recursive);
    }
    scene_ = folder_.read("scenes/work_cell.json");
    robot_ = folder_.read("robots/ur5e_like.urdf");
    pairs_ = folder_.read("robots/ur5e_like.srdf");
  }

  // The line on which sim and bake refuse; both must say the same.
  std::string refused(const std::vector<std::string>& options) const {
    const auto with_verb = [&options](const char* verb) {
      std::vector<std::string> arguments = {verb, "--output", "made"};
      arguments.insert(arguments.end(), options.begin(), options.end());
      return arguments;
    };
    const std::string line = refusal(folder_, with_verb("sim"));
    EXPECT_EQ(refusal(folder_, with_verb("bake")), line);
    return line;
  }
  std::string refused_scene(const std::string& text) const {
    folder_.write("scenes/bad.json", text);
    return refused({"--scene", "scenes/bad.json"});
  }
  std::string refused_robot(const std::string& text) const {
    folder_.write("robots/bad.urdf", text);
    return refused({"--robot", "robots/bad.urdf"});
  }
  std::string refused_pairs(const std::string& text) const {
    folder_.write("bad.srdf", text);
    return refused({"--srdf", "bad.srdf"});
  }

  ScratchFolder folder_;
  std::string scene_, robot_, pairs_;
};

struct Change {
  const char* from;  // its only occurrence in the good text
  const char* to;
  const char* says;  // how the line goes on after FILE:LINE:COLUMN:
};

// The line must read `FILE:LINE:COLUMN: SAYS...` with the line number of the change.
void expect_place(const std::string& line, const std::string& file, const std::string& good,
                  const Change& change) {
  const std::size_t at = good.find(change.from);
  const auto number = 1 + std::count(good.begin(), good.begin() + static_cast<std::ptrdiff_t>(at), '\n');
  std::smatch match;
  ASSERT_TRUE(std::regex_match(line, match, std::regex("([^:]+):(\\d+):(\\d+): (.*)"))) << line;
  EXPECT_EQ(match[1], file) << line;
  EXPECT_EQ(match[2], std::to_string(number)) << line;
  EXPECT_EQ(match[4].str().substr(0, std::string(change.says).size()), change.says) << line;
}

// Without the text from the first occurrence of `from` up to the first of `to` after it.
std::string without(std::string text, const std::string& from, const std::string& to) {
  const std::size_t first = text.find(from);
  const std::size_t end = text.find(to, first);
  if (first == std::string::npos || end == std::string::npos) {
    ADD_FAILURE() << "nothing to remove from " << from << " to " << to;
    return text;
  }
  return text.erase(first, end - first);
}

TEST_F(CommandBadInput, Scenes) {
  const Change changes[] = {
      {"\"duration\": 24.0,", "\"duration\": 24.0,,", "unexpected \",\""},
      {"\"duration\": 24.0,", "\"duration\": 24.0, \"duration\": 24.0,", "duration: "},
      {"\"duration\"", "\"durations\"", "durations: unknown key \"durations\" (did you mean \"duration\"?)"},
      {"24.0", "0", "duration: 0 is out of range"},
      {"24.0", "\"24\"", "duration: a string is not allowed here"},
      {"24.0", "1e999", "duration: "},
      {"nearfield-scene-1", "nearfield-scene-2", "format: "},
      {"\"radius\": 0.02", "\"radius\": -0.02", "field.operands[3].radius: -0.02 is out of range"},
      {"\"radius\": 0.02", "\"radius\": 0", "field.operands[3].radius: 0 is out of range"},
      {"\"radius\": 0.02", "\"raduis\": 0.02",
       "field.operands[3].raduis: unknown key \"raduis\" (did you mean"},
      {"\"radius\": 0.02", "\"radius\": null", "field.operands[3].radius: null is not allowed here"},
      {"\"height\": 1.5", "\"height\": 1500", "field.operands[4].height: 1500 is out of range"},
      {"[1.2, 1.6, 0.05]", "[1.2, 1.6]", "field.operands[0].size: "},
      {"[1.2, 1.6, 0.05]", "[1.2, -1.6, 0.05]", "field.operands[0].size[1]: -1.6 is out of range"},
      {"\"exterior_union\"", "\"exterior_onion\"",
       "field.type: unknown name \"exterior_onion\" (did you mean"},
      {"\"rising_range\": 0.0125", "\"rising_range\": 0.3",
       "field.rising_range: 0.3 does not fit blend_radius 0.05"},
      {"\"position\": [0.8, -0.1, 0]", "\"position\": [5, -0.1, 0]", "field.operands[4]"},
      {"\"position\": [0.8, -0.1, 0]", "\"position\": [50, -0.1, 0]",
       "field.operands[4].position[0]: 50 is out of range"},
      {"\"person/head\"", "\"person/hat\"", "soft.operands[5].link: no link `"},
      {"\"person/head\"", "\"persona/head\"", "soft.operands[5].link: "},
      {"\"time\": 1.6,", "\"time\": 0.6,", "cycle.waypoints[2].time: "},
      {"\"elbow_joint\": 1.4109", "\"elbow_jiont\": 1.4109",
       "cycle.waypoints[5].joints: other joints than in the first"},
      {"\"human_speed\": 1.6", "\"human_speed\": -1.6", "separation.human_speed: -1.6 is out of range"},
      {"\"reaction_time\": 0.08,", "", "separation.reaction_time: missing"},
      {"\"cell_slow\": 0.03", "\"cell_slow\": 0.004", "separation.cell_slow: "},
  };
  for (const Change& change : changes) {
    SCOPED_TRACE(change.to);
    const std::string line = refused_scene(with(scene_, change.from, change.to));
    if (std::string(change.says) == "separation.reaction_time: missing") {
      EXPECT_NE(line.find(change.says), std::string::npos) << line;  // at the object that lacks it
    } else {
      expect_place(line, "scenes/bad.json", scene_, change);
    }
  }
}

// A joint's value outside the limits is refused at its waypoint.
TEST_F(CommandBadInput, JointValues) {
  struct {
    const char* waypoint;  // how its line starts
    Change change;
  } const cases[] = {
      {"{\"time\": 3.4,",
       {"\"shoulder_pan_joint\": -0.3274", "\"shoulder_pan_joint\": 6.5",
        "cycle.waypoints[5].joints.shoulder_pan_joint: 6.500000 is outside the joint's limits"}},
      {"{\"time\": 11.2,",
       {"\"lean\": 0.28", "\"lean\": 2.8",
        "person.path[5].joints.lean: 2.800000 is outside the joint's limits"}},
  };
  for (const auto& [waypoint, change] : cases) {
    SCOPED_TRACE(change.to);
    const std::string line = refused_scene(with(scene_, change.from, change.to));
    expect_place(line, "scenes/bad.json", scene_, {waypoint, "", change.says});
  }
}

TEST_F(CommandBadInput, ScenesThatLackAPart) {
  const std::string no_cycle = without(scene_, "\"cycle\"", "\"separation\"");
  EXPECT_EQ(refused_scene(no_cycle).find("scenes/bad.json: cycle: missing; "), 0U) << refused_scene(no_cycle);
  const std::string no_robot = without(scene_, "\"robot\": \"../robots/ur5e_like.urdf\"", "\"duration\"");
  EXPECT_EQ(refused_scene(no_robot).find("scenes/bad.json: robot: missing; "), 0U) << refused_scene(no_robot);
  const std::string nobody = without(scene_, "\"person\": {", "\"cycle\"");
  EXPECT_NE(refused_scene(nobody).find(": soft.operands[4].link: "), std::string::npos)
      << refused_scene(nobody);
  const std::string no_tool = with(scene_, "\"tool0\"", "\"tool9\"");
  EXPECT_EQ(refused_scene(no_tool).find("scenes/bad.json: tool_link: the robot has no link `tool9`"), 0U);
  EXPECT_EQ(refused_scene("").find("scenes/bad.json:1:1: "), 0U);
  EXPECT_EQ(refused_scene("\xff").find("scenes/bad.json:1:1: "), 0U);
  EXPECT_EQ(refused_scene(scene_.substr(0, scene_.size() / 2)).find("scenes/bad.json:"), 0U);
}

TEST_F(CommandBadInput, ScenesThatNameOtherFilesWrongly) {
  EXPECT_EQ(refused_scene(with(scene_, "../robots/ur5e_like.urdf", "../robots/absent.urdf"))
                .find("scenes/../robots/absent.urdf: cannot be opened: "),
            0U);
  EXPECT_EQ(refused_scene(with(scene_, "../robots/person.urdf", "../robots"))
                .find("scenes/../robots: is a directory"),
            0U);
  EXPECT_EQ(refused_scene(with(scene_, "../robots/person.urdf", "work_cell.json"))
                .find("scenes/work_cell.json:1:1: "),
            0U);
}

std::string field_in_scene(const std::string& scene, const std::string& field) {
  const std::size_t first = scene.find("\"field\":"), end = scene.find("\"soft\":");
  return scene.substr(0, first) + "\"field\": " + field + ",\n" + scene.substr(end);
}

TEST_F(CommandBadInput, ScenesThatAreTooDeep) {
  const std::string deep_json = std::string(100, '[') + std::string(100, ']');
  EXPECT_EQ(refused_scene(field_in_scene(scene_, deep_json)).find("scenes/bad.json:"), 0U);
  const std::string ball = R"({"type": "sphere", "radius": 0.1})";
  std::string blends = ball, frames = ball;
  for (int i = 0; i < 25; ++i) blends = R"({"type": "union", "operands": [)" + ball + ", " + blends + "]}";
  for (int i = 0; i < 25; ++i)
    frames = R"({"type": "place", "position": [0, 0, 0.01], "operands": [)" + frames + "]}";
  for (const std::string& field : {blends, frames}) {
    const std::string line = refused_scene(field_in_scene(scene_, field));
    EXPECT_TRUE(std::regex_search(line, std::regex("^scenes/bad.json:\\d+:\\d+: field[^ ]*: .*; "))) << line;
  }
}

TEST_F(CommandBadInput, ScenesThatAreTooLarge) {
  const std::string ball = R"({"type": "sphere", "radius": 0.1})";
  const auto union_of = [](int count, const std::string& operand) {
    std::string text = R"({"type": "union", "operands": [)" + operand;
    for (int i = 1; i < count; ++i) text += ",\n" + operand;
    return text + "]}";
  };
  const std::string wide = refused_scene(field_in_scene(scene_, union_of(65, ball)));
  EXPECT_TRUE(std::regex_search(wide, std::regex("^scenes/bad.json:\\d+:\\d+: field.operands: .*; ")))
      << wide;
  const std::string large =
      refused_scene(field_in_scene(scene_, union_of(64, union_of(64, union_of(4, ball)))));
  EXPECT_TRUE(std::regex_search(large, std::regex("^scenes/bad.json:\\d+:\\d+: field[^ ]*: .*; "))) << large;
}

TEST_F(CommandBadInput, Robots) {
  const Change changes[] = {
      {"<robot name=\"ur5e_like\">", "<robot nmae=\"ur5e_like\">", "robot"},
      {"<capsule radius=\"0.075\" length=\"0.04\"/>", "<capsule radius=\"-0.075\" length=\"0.04\"/>",
       "robot/link[base_link]/collision[0]/geometry/capsule@radius: -0.075 is out of range"},
      {"<capsule radius=\"0.075\" length=\"0.04\"/>", "<capsule radius=\"75\" length=\"0.04\"/>",
       "robot/link[base_link]"},
      {"<capsule radius=\"0.075\" length=\"0.04\"/>", "<capsule raduis=\"0.075\" length=\"0.04\"/>",
       "robot/link[base_link]"},
      {"<capsule radius=\"0.075\" length=\"0.04\"/>", "<mesh filename=\"base.stl\"/>",
       "robot/link[base_link]"},
      {"<capsule radius=\"0.075\" length=\"0.04\"/>", "<capsule radius=\"0.075\" length=\"0.04\">", ""},
      {"<joint name=\"shoulder_pan_joint\" type=\"revolute\">",
       "<joint name=\"shoulder_pan_joint\" type=\"revolving\">", "robot/joint[shoulder_pan_joint]"},
      {"<link name=\"shoulder_link\">", "<link name=\"base_link\">", "robot/link[base_link]"},
      {"<child link=\"shoulder_link\"/>", "<child link=\"shulder_link\"/>",
       "robot/joint[shoulder_pan_joint]"},
      {"<origin xyz=\"0 -0.03 0\" rpy=\"1.570796327 0 0\"/>",
       "<origin xyz=\"0 -0.03\" rpy=\"1.570796327 0 0\"/>", "robot/link[shoulder_link]"},
      {"<origin xyz=\"0 -0.03 0\" rpy=\"1.570796327 0 0\"/>",
       "<origin xyz=\"0 -0.03 0\" ypr=\"1.570796327 0 0\"/>", "robot/link[shoulder_link]"},
  };
  for (const Change& change : changes) {
    SCOPED_TRACE(change.to);
    const std::string line = refused_robot(with(robot_, change.from, change.to));
    // A missing end is seen at the next end tag.
    if (*change.says == '\0')
      EXPECT_EQ(line.find("robots/bad.urdf:"), 0U) << line;
    else
      expect_place(line, "robots/bad.urdf", robot_, change);
  }
  for (const std::string& text :
       {std::string(), std::string("{}"), std::string("<robot"), robot_.substr(0, robot_.size() / 2),
        std::string("<robot name=\"r\"/>"), pairs_}) {
    const std::string line = refused_robot(text);
    EXPECT_TRUE(std::regex_search(line, std::regex("^robots/bad.urdf:\\d+:\\d+: "))) << line;
  }
}

TEST_F(CommandBadInput, RobotsThatTheSceneDoesNotFit) {
  const std::string other =
      R"(<robot name="r"><link name="a"><collision><geometry><sphere radius="0.1"/></geometry>
    </collision></link><link name="tool0"/>
    <joint name="j" type="revolute"><parent link="a"/><child link="tool0"/>
    <axis xyz="0 0 1"/><limit lower="-1" upper="1"/></joint></robot>)";
  const std::string line = refused_robot(other);
  EXPECT_EQ(line.find(NEARFIELD_SOURCE_DIR "/host_sim/scenes/work_cell.json:"), 0U) << line;
  EXPECT_NE(line.find(": cycle.waypoints[0].joints"), std::string::npos) << line;
}

TEST_F(CommandBadInput, LinkPairs) {
  const Change changes[] = {
      {"link1=\"base_link\" link2=\"upper_arm_link\"", "link1=\"base_link\" link2=\"uper_arm_link\"",
       "robot/disable_collisions"},
      {"link1=\"base_link\" link2=\"upper_arm_link\"", "link1=\"base_link\" link2=\"base_link\"",
       "robot/disable_collisions"},
      {"link1=\"base_link\" link2=\"upper_arm_link\"", "link1=\"base_link\"", "robot/disable_collisions"},
  };
  for (const Change& change : changes) {
    SCOPED_TRACE(change.to);
    expect_place(refused_pairs(with(pairs_, change.from, change.to)), "bad.srdf", pairs_, change);
  }
  EXPECT_EQ(refused_pairs("<robot>").find("bad.srdf:1:"), 0U);
  // The .srdf beside a robot is read without being named.
  folder_.write("robots/bad.srdf", "<robot");
  const std::string line = refused_robot(robot_);
  EXPECT_EQ(line.find("robots/bad.srdf:1:"), 0U) << line;
}

}  // namespace
}  // namespace nearfield::host
