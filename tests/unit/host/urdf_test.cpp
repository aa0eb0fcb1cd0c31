#include "model/urdf.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <string>
#include <vector>

#include "input_error_expectation.hpp"
#include "model/srdf.hpp"

namespace nearfield::host {
namespace {

// Joints in an order in which children come before parents.
const std::string robot_text = R"(<?xml version="1.0"?>
<robot name="arm" version="1.0" xmlns:xacro="x">
  <material name="red"><color rgba="1 0 0 1"/></material>
  <joint name="wrist" type="continuous">
    <parent link="fore"/><child link="hand"/>
    <axis xyz="0 3 4"/>
    <mimic joint="elbow" multiplier="-2" offset="0.5"/>
  </joint>
  <joint name="elbow" type="revolute">
    <origin xyz="0 0 +1." rpy="0 0 1.5"/>
    <parent link="base"/><child link="fore"/>
    <limit lower="-1" upper="2" effort="9" velocity="3"/>
    <dynamics damping="1"/>
  </joint>
  <joint name="slide" type="prismatic">
    <parent link="base"/><child link="rail"/>
    <axis xyz="0 0 1"/>
    <limit lower="0" upper="0.5"/>
  </joint>
  <joint name="flange" type="fixed">
    <parent link="hand"/><child link="tool"/>
    <axis xyz="0 0 0"/><mimic joint="wrist"/>
  </joint>
  <link name="hand"/>
  <link name="base">
    <visual><geometry><mesh filename="a.stl"/></geometry></visual>
    <collision name="plate"><geometry><box size="1 2 3"/></geometry></collision>
    <collision><origin xyz="1 2 3"/><geometry><cylinder radius="0.1" length="0.4"/></geometry></collision>
  </link>
  <link name="fore">
    <inertial><mass value="1"/></inertial>
    <collision><geometry><capsule radius="0.2" length="0.5"/></geometry><origin xyz="0 0 -1"/></collision>
  </link>
  <link name="rail"><collision><geometry><sphere radius="0.3"/></geometry></collision></link>
  <link name="tool"/>
</robot>
)";

TEST(Urdf, ReadsLinksAndShapes) {
  const RobotDescription robot = parse_urdf(robot_text, "f");
  EXPECT_EQ(robot.name, "arm");
  ASSERT_EQ(robot.links.size(), 5U);
  EXPECT_EQ(robot.links[robot.root_link].name, "base");
  const Link& base = robot.links[*robot.find_link("base")];
  ASSERT_EQ(base.shapes.size(), 2U);
  EXPECT_EQ(base.shapes[0].kind, CollisionKind::box);
  EXPECT_EQ(base.shapes[0].name, "plate");
  EXPECT_EQ(base.shapes[0].size.y, 2.0);
  EXPECT_EQ(base.shapes[0].position.line, 27U);
  EXPECT_EQ(base.shapes[1].kind, CollisionKind::cylinder);
  EXPECT_EQ(base.shapes[1].radius, 0.1);
  EXPECT_EQ(base.shapes[1].length, 0.4);
  EXPECT_EQ(base.shapes[1].origin.position.z, 3.0);
  const Link& fore = robot.links[*robot.find_link("fore")];
  ASSERT_EQ(fore.shapes.size(), 1U);
  EXPECT_EQ(fore.shapes[0].kind, CollisionKind::capsule);
  EXPECT_EQ(fore.shapes[0].length, 0.5);
  EXPECT_EQ(robot.links[*robot.find_link("rail")].shapes[0].kind, CollisionKind::sphere);
}

TEST(Urdf, OrdersJointsParentsFirst) {
  const RobotDescription robot = parse_urdf(robot_text, "f");
  std::vector<std::string> names;
  std::vector<bool> placed(robot.links.size(), false);
  placed[robot.root_link] = true;
  for (const Joint& joint : robot.joints) {
    names.push_back(joint.name);
    EXPECT_TRUE(placed[joint.parent]) << joint.name;
    placed[joint.child] = true;
  }
  EXPECT_EQ(names, (std::vector<std::string>{"elbow", "slide", "wrist", "flange"}));
}

TEST(Urdf, ReadsJoints) {
  const RobotDescription robot = parse_urdf(robot_text, "f");
  const Joint& elbow = robot.joints[0];
  EXPECT_EQ(elbow.kind, JointKind::revolute);
  EXPECT_EQ(elbow.lower, -1.0);
  EXPECT_EQ(elbow.upper, 2.0);
  EXPECT_EQ(elbow.velocity, 3.0);
  EXPECT_EQ(elbow.axis.x, 1.0);
  EXPECT_EQ(elbow.origin.position.z, 1.0);
  EXPECT_NEAR(elbow.origin.rotation[3], std::sin(1.5), 1e-15);
  const Joint& slide = robot.joints[1];
  EXPECT_EQ(slide.kind, JointKind::prismatic);
  EXPECT_FALSE(slide.velocity.has_value());
  const Joint& wrist = robot.joints[2];
  EXPECT_EQ(wrist.kind, JointKind::continuous);
  EXPECT_NEAR(wrist.axis.y, 0.6, 1e-15);
  EXPECT_NEAR(wrist.axis.z, 0.8, 1e-15);
  EXPECT_FALSE(wrist.lower.has_value());
  ASSERT_TRUE(wrist.mimic.has_value());
  EXPECT_EQ(wrist.mimic->joint, 0U);
  EXPECT_EQ(wrist.mimic->multiplier, -2.0);
  EXPECT_EQ(wrist.mimic->offset, 0.5);
  EXPECT_EQ(robot.joints[3].kind, JointKind::fixed);
  EXPECT_FALSE(robot.joints[3].mimic.has_value());
}

TEST(Urdf, RefusesWrongElementsAndValues) {
  const auto changed = [](std::string_view from, std::string_view to) { return with(robot_text, from, to); };
  const std::vector<Malformed> cases{
      {"<sdf/>", "file:1:1: sdf: the root element is \"sdf\"; \"robot\""},
      {"<robot name=''/>", "file:1:8: robot@name: empty"},
      {"<robot/>", "file:1:1: robot@name: missing"},
      {"<robot name='a'/>", "file:1:1: robot: no links"},
      {"<robot name='a'><lnik name='b'/></robot>",
       "file:1:17: robot/lnik: unknown element \"lnik\" (did you mean \"link\"?)"},
      {"<robot name='a'><link/></robot>", "file:1:17: robot/link@name: missing"},
      {changed("radius=\"0.3\"", "raduis=\"0.3\""),
       "file:34:50: robot/link[rail]/collision[0]/geometry/sphere@raduis: unknown attribute \"raduis\" (did "
       "you"},
      {changed("radius=\"0.3\"", "radius=\"0\""),
       "file:34:50: robot/link[rail]/collision[0]/geometry/sphere@radius: 0 is out of range; a number above "
       "0"},
      {changed("radius=\"0.3\"", "radius=\"inf\""),
       "file:34:50: robot/link[rail]/collision[0]/geometry/sphere@radius: \"inf\" is not a finite"},
      {changed("radius=\"0.3\"", "radius=\"1 2\""),
       "file:34:50: robot/link[rail]/collision[0]/geometry/sphere@radius: 2 numbers; a number"},
      {changed("radius=\"0.3\"", ""),
       "file:34:42: robot/link[rail]/collision[0]/geometry/sphere@radius: missing"},
      {changed("size=\"1 2 3\"", "size=\"1 2\""),
       "file:27:44: robot/link[base]/collision[0]/geometry/box@size: 2 numbers; 3 numbers"},
      {changed("size=\"1 2 3\"", "size=\"1 -2 3\""),
       "file:27:44: robot/link[base]/collision[0]/geometry/box@size: -2 is out of range"},
      {changed("<sphere radius=\"0.3\"/>", "<mesh filename=\"a\"/>"),
       "file:34:42: robot/link[rail]/collision[0]/geometry/mesh: a mesh cannot be checked for collision; "
       "cover"},
      {changed("<sphere radius=\"0.3\"/>", "<cone/>"),
       "file:34:42: robot/link[rail]/collision[0]/geometry/cone: unknown element \"cone\""},
      {changed("<sphere radius=\"0.3\"/>", ""),
       "file:34:32: robot/link[rail]/collision[0]/geometry: no shape"},
      {changed("<sphere radius=\"0.3\"/>", "<sphere radius=\"0.3\"/><sphere radius=\"1\"/>"),
       "file:34:64: robot/link[rail]/collision[0]/geometry/sphere: a second shape"},
      {changed("<geometry><sphere radius=\"0.3\"/></geometry>", ""),
       "file:34:21: robot/link[rail]/collision[0]: element \"geometry\" is missing"},
      {changed("xyz=\"0 0 +1.\"", "xyz=\"0 0 17\""),
       "file:10:13: robot/joint[elbow]/origin@xyz: 17 is out of range; 3 numbers from -16 to 16 m"},
      {changed("rpy=\"0 0 1.5\"", "ryp=\"0 0 1.5\""),
       "file:10:27: robot/joint[elbow]/origin@ryp: unknown attribute \"ryp\""},
      {changed("<origin xyz=\"1 2 3\"/>", "<origin/><origin/>"),
       "file:28:25: robot/link[base]/collision[1]/origin: a second element"},
      {changed("type=\"prismatic\"", "type=\"prsmatic\""),
       "file:15:23: robot/joint[slide]@type: unknown joint type \"prsmatic\" (did you mean \"prismatic\"?)"},
      {changed("type=\"prismatic\"", "type=\"floating\""),
       "file:15:23: robot/joint[slide]@type: unknown joint type \"floating\"; one of revolute, continuous"},
      {changed("xyz=\"0 3 4\"", "xyz=\"0 0 0\""),
       "file:6:11: robot/joint[wrist]/axis@xyz: the axis has no direction"},
      {changed("<limit lower=\"0\" upper=\"0.5\"/>", ""),
       "file:15:3: robot/joint[slide]: element \"limit\" is missing"},
      {changed("upper=\"0.5\"", ""),
       "file:18:5: robot/joint[slide]/limit@upper: missing; required: a number"},
      {changed("lower=\"-1\" upper=\"2\"", "lower=\"3\" upper=\"2\""),
       "file:12:12: robot/joint[elbow]/limit@lower: 3 is above upper; at most 2"},
      {changed("velocity=\"3\"", "velocity=\"-3\""),
       "file:12:44: robot/joint[elbow]/limit@velocity: -3 is out of range"},
  };
  for (const Malformed& malformed : cases) expect_input_error(parse_urdf, malformed);
}

TEST(Urdf, RefusesWhatIsNoTree) {
  const auto changed = [](std::string_view from, std::string_view to) { return with(robot_text, from, to); };
  const std::vector<Malformed> cases{
      {changed("<link name=\"tool\"/>", "<link name=\"rail\"/>"),
       "file:35:3: robot/link[rail]: a second link of this name"},
      {changed("<joint name=\"slide\"", "<joint name=\"elbow\""),
       "file:15:3: robot/joint[elbow]: a second joint of this name"},
      {changed("<child link=\"tool\"/>", "<child link=\"tol\"/>"),
       "file:21:33: robot/joint[flange]/child@link: unknown link \"tol\" (did you mean \"tool\"?)"},
      {changed("<parent link=\"hand\"/>", "<parent link=\"had\"/>"),
       "file:21:13: robot/joint[flange]/parent@link: unknown link \"had\" (did you mean \"hand\"?)"},
      {changed("<child link=\"tool\"/>", "<child link=\"rail\"/>"),
       "file:21:33: robot/joint[flange]/child@link: link \"rail\" is already the child of \"slide\""},
      {changed("<link name=\"tool\"/>", "<link name=\"tool\"/><link name=\"lone\"/>"),
       "file:35:22: robot/link[lone]: a second root"},
      {"<robot name='a'><link name='b'/><joint name='j' type='fixed'><parent link='b'/><child "
       "link='b'/></joint>"
       "</robot>",
       "file:1:1: robot: every link has a parent"},
      {"<robot name='a'><link name='r'/><link name='b'/><link name='c'/>\n"
       "<joint name='j' type='fixed'><parent link='b'/><child link='c'/></joint>\n"
       "<joint name='k' type='fixed'><parent link='c'/><child link='b'/></joint></robot>",
       "file:1:33: robot/link[b]: part of a cycle"},
      {changed("mimic joint=\"elbow\"", "mimic joint=\"elbo\""),
       "file:7:12: robot/joint[wrist]/mimic@joint: unknown joint \"elbo\" (did you mean \"elbow\"?)"},
      {changed("mimic joint=\"elbow\"", "mimic joint=\"wrist\""),
       "file:7:12: robot/joint[wrist]/mimic@joint: a joint cannot mimic itself"},
      {changed("mimic joint=\"elbow\"", "mimic joint=\"flange\""),
       "file:7:12: robot/joint[wrist]/mimic@joint: \"flange\" is fixed"},
      {changed("<limit lower=\"0\" upper=\"0.5\"/>",
               "<limit lower=\"0\" upper=\"1\"/><mimic joint=\"wrist\"/>"),
       "file:18:40: robot/joint[slide]/mimic@joint: \"wrist\" is a mimic itself"},
  };
  for (const Malformed& malformed : cases) expect_input_error(parse_urdf, malformed);
}

TEST(Urdf, AtMost64Links) {
  const auto chain = [](int count) {
    std::string text = "<robot name='a'><link name='l0'/>";
    for (int link = 1; link < count; ++link) {
      const std::string name = std::to_string(link);
      text += "<link name='l" + name + "'/><joint name='j" + name + "' type='fixed'><parent link='l" +
              std::to_string(link - 1) + "'/><child link='l" + name + "'/></joint>";
    }
    return text + "</robot>";
  };
  EXPECT_EQ(parse_urdf(chain(64), "f").joints.size(), 63U);
  EXPECT_THROW(parse_urdf(chain(65), "f"), InputError);
}

TEST(Srdf, AddsPairsOnce) {
  RobotDescription robot = parse_urdf(robot_text, "f");
  parse_srdf(
      "<robot name='arm'><group name='g'/><disable_collisions link1='hand' link2='base' reason='Never'/>"
      "<disable_collisions link1='base' link2='hand'/><disable_collisions link1='rail' "
      "link2='tool'/></robot>",
      "f", robot);
  EXPECT_EQ(robot.unchecked_pairs.size(), 2U);
  const std::size_t hand = *robot.find_link("hand");
  const std::size_t base = *robot.find_link("base");
  EXPECT_TRUE(robot.is_unchecked(hand, base));
  EXPECT_TRUE(robot.is_unchecked(base, hand));
  EXPECT_FALSE(robot.is_unchecked(base, *robot.find_link("tool")));
}

TEST(Srdf, RefusesWrongPairsAndChangesNothing) {
  RobotDescription robot = parse_urdf(robot_text, "f");
  const std::vector<Malformed> cases{
      {"<srdf/>", "file:1:1: srdf: the root element is \"srdf\""},
      {"<robot><disable_collisions link1='hand' link2='base'/><disable_collisions link1='hand' "
       "link2='bse'/></robot>",
       "file:1:88: robot/disable_collisions[1]@link2: unknown link \"bse\" (did you mean \"base\"?)"},
      {"<robot><disable_collisions link1='hand' link2='hand'/></robot>",
       "file:1:41: robot/disable_collisions[0]@link2: the same link as link1"},
      {"<robot><disable_collisions link1='hand'/></robot>",
       "file:1:8: robot/disable_collisions[0]@link2: missing"},
      {"<robot><disable_collisions link1='hand' link='base'/></robot>",
       "file:1:41: robot/disable_collisions[0]@link: unknown attribute \"link\""},
  };
  for (const Malformed& malformed : cases) {
    expect_input_error(
        [&robot](const std::string& text, const std::string& file) { parse_srdf(text, file, robot); },
        malformed);
  }
  EXPECT_TRUE(robot.unchecked_pairs.empty());
}

}  // namespace
}  // namespace nearfield::host
