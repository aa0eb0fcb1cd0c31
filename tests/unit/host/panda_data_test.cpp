#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <filesystem>
#include <limits>
#include <map>
#include <string>
#include <utility>
#include <vector>

#include "model/problems.hpp"
#include "model/srdf.hpp"
#include "model/urdf.hpp"
#include "text/json.hpp"
#include "text/json_node.hpp"
#include "text/read_file.hpp"

namespace nearfield::host {
namespace {

// The 700 problems of a real arm and the clearances that an independent program found for them, read from the
// folder that the environment variable NEARFIELD_SHARED_DATA names.
class PandaData : public testing::Test {
 protected:
  void SetUp() override {
    const char* folder = std::getenv("NEARFIELD_SHARED_DATA");
    if (folder == nullptr) GTEST_SKIP() << "NEARFIELD_SHARED_DATA is not set: the panda data is not read";
    folder_ = std::filesystem::path(folder) / "panda";
    if (!std::filesystem::is_directory(folder_)) GTEST_SKIP() << folder_ << " is not there";
    robot_ = read_urdf(path("panda_spherized.urdf"));
    read_srdf(path("panda.srdf"), robot_);
  }

  std::string path(const std::string& name) const { return (folder_ / name).string(); }

  std::filesystem::path folder_;
  RobotDescription robot_;
};

struct Ball {
  Vector3d centre;
  double radius;
  std::size_t link;
};

Placement joint_motion(const Joint& joint, double value) {
  Placement motion;
  if (joint.kind == JointKind::prismatic) {
    motion.position = value * joint.axis;
  } else if (joint.kind != JointKind::fixed) {
    const double s = std::sin(value / 2.0);
    motion = *placement_from_quaternion_xyzw(
        {}, {s * joint.axis.x, s * joint.axis.y, s * joint.axis.z, std::cos(value / 2.0)});
  }
  return motion;
}

std::vector<Ball> forward_kinematics(const RobotDescription& robot,
                                     const std::map<std::string, double>& values) {
  std::vector<Placement> links(robot.links.size());
  for (const Joint& joint : robot.joints) {
    const double value = joint.kind == JointKind::fixed ? 0.0 : values.at(joint.name);
    links[joint.child] = compose(compose(links[joint.parent], joint.origin), joint_motion(joint, value));
  }
  std::vector<Ball> balls;
  for (std::size_t link = 0; link < links.size(); ++link) {
    for (const CollisionShape& shape : robot.links[link].shapes) {
      balls.push_back({transform_point(links[link], shape.origin.position), shape.radius, link});
    }
  }
  return balls;
}

double signed_distance(const CollisionShape& shape, const Vector3d& point) {
  const Vector3d p = transform_point(inverse(shape.origin), point);
  Vector3d q;
  switch (shape.kind) {
    case CollisionKind::box:
      q = {std::abs(p.x) - shape.size.x / 2.0, std::abs(p.y) - shape.size.y / 2.0,
           std::abs(p.z) - shape.size.z / 2.0};
      break;
    case CollisionKind::cylinder:
      q = {std::hypot(p.x, p.y) - shape.radius, -std::numeric_limits<double>::max(),
           std::abs(p.z) - shape.length / 2.0};
      break;
    default:
      return length(p) - shape.radius;
  }
  const Vector3d outside{std::max(q.x, 0.0), std::max(q.y, 0.0), std::max(q.z, 0.0)};
  return length(outside) + std::min(std::max({q.x, q.y, q.z}), 0.0);
}

double scene_clearance(const std::vector<Ball>& balls, const std::vector<CollisionShape>& objects) {
  double least = std::numeric_limits<double>::infinity();
  for (const Ball& ball : balls) {
    for (const CollisionShape& object : objects) {
      least = std::min(least, signed_distance(object, ball.centre) - ball.radius);
    }
  }
  return least;
}

double self_clearance(const RobotDescription& robot, const std::vector<Ball>& balls) {
  double least = std::numeric_limits<double>::infinity();
  for (std::size_t a = 0; a < balls.size(); ++a) {
    for (std::size_t b = 0; b < a; ++b) {
      if (balls[a].link == balls[b].link || robot.is_unchecked(balls[a].link, balls[b].link)) continue;
      least = std::min(least, length(balls[a].centre - balls[b].centre) - balls[a].radius - balls[b].radius);
    }
  }
  return least;
}

TEST_F(PandaData, RobotHasItsSpheresJointsAndPairs) {
  std::size_t spheres = 0;
  for (const Link& link : robot_.links) {
    for (const CollisionShape& shape : link.shapes) {
      EXPECT_EQ(shape.kind, CollisionKind::sphere);
      ++spheres;
    }
  }
  EXPECT_EQ(spheres, 59U);
  EXPECT_EQ(robot_.unchecked_pairs.size(), 34U);
  EXPECT_EQ(robot_.links[robot_.root_link].name, "panda_link0");
  const auto moving = std::count_if(robot_.joints.begin(), robot_.joints.end(),
                                    [](const Joint& joint) { return joint.kind != JointKind::fixed; });
  EXPECT_EQ(moving, 7);
  const Joint& last = robot_.joints[*robot_.find_joint("panda_joint7")];
  EXPECT_EQ(last.upper, 2.9671);
  EXPECT_EQ(last.velocity, 2.871);
}

TEST_F(PandaData, ClearancesAgreeWithAnIndependentProgram) {
  const std::vector<Problem> problems = read_problems(path("problems.json"));
  const JsonDocument document = parse_json(read_file(path("expected.json")), path("expected.json"));
  const std::vector<JsonNode> expected = JsonNode(document).elements(700, 700);
  ASSERT_EQ(problems.size(), 700U);
  for (std::size_t index = 0; index < problems.size(); ++index) {
    const Problem& problem = problems[index];
    SCOPED_TRACE(problem.set + " " + std::to_string(problem.index));
    ASSERT_EQ(expected[index].required("set").string(100), problem.set);
    ASSERT_EQ(expected[index].required("index").integer(0, 1000), problem.index);
    for (const auto& [key, values] : {std::pair("start", &problem.start), std::pair("goal", &problem.goal)}) {
      const std::vector<Ball> balls = forward_kinematics(robot_, *values);
      const JsonNode clearances = expected[index].required(key);
      EXPECT_NEAR(scene_clearance(balls, problem.objects), clearances.required("scene_clearance").number({}),
                  1e-9);
      EXPECT_NEAR(self_clearance(robot_, balls), clearances.required("self_clearance").number({}), 1e-9);
    }
  }
}

}  // namespace
}  // namespace nearfield::host
