#include "simulate/check.hpp"

#include <algorithm>
#include <map>
#include <memory>
#include <utility>

#include <nearfield/query/capsule_clearance.hpp>
#include <nearfield/query/capsule_pair.hpp>

#include "compile/quantise.hpp"
#include "model/problems.hpp"
#include "model/srdf.hpp"
#include "model/urdf.hpp"
#include "text/input_error.hpp"
#include "text/names.hpp"

namespace nearfield::host {
namespace {

class Checker {
 public:
  Checker(const RobotDescription& robot, const std::string& robot_file, bool checks_neighbours, std::string problem_file)
      : robot_(compile_robot<Q>(robot, robot_file, checks_neighbours)), problem_file_(std::move(problem_file)),
        chain_(std::make_unique<HostPlayer::ArmChain>()) {
    for (const nearfield::Joint<Q>& joint : robot_.joints) chain_->add_joint(joint);
    for (const nearfield::Body<Q>& body : robot_.bodies) chain_->add_body(body);
    for (const Joint& joint : robot.joints) known_joints_.push_back(joint.name);
    if (robot_.bodies.empty()) throw InputError(robot_file, {}, "robot", "no collision shapes", "at least one link needs one");
  }

  CheckedProblem check(const Problem& problem, std::size_t number) {
    const std::string path = "[" + std::to_string(number) + "]";
    CheckedProblem checked{problem.set, problem.index, {}, {}};
    CompiledField<Q> obstacles;
    Program<Q> scene;
    if (!problem.objects.empty()) {
      obstacles = compile_obstacles<Q>(problem.objects, problem_file_, path + ".objects");
      scene = load<Q>(obstacles.image.data(), obstacles.image.size() * sizeof(std::uint32_t));
    }
    checked.start = check(problem.start, scene, {problem.start_position, path + ".start"});
    checked.goal = check(problem.goal, scene, {problem.goal_position, path + ".goal"});
    return checked;
  }

 private:
  // Of the joint values of a configuration.
  struct Place {
    SourcePosition position;
    std::string path;
  };
  InputError error_at(const Place& place, const std::string& member, const std::string& what,
                      const std::string& allowed) const {
    return InputError(problem_file_, place.position, place.path + member, what, allowed);
  }

  CheckedConfiguration check(const std::map<std::string, double>& joints, const Program<Q>& scene, const Place& place) {
    const std::vector<Q> values = values_of(joints, place);
    const KinematicsStatus status = chain_->link_poses(values.data(), poses_.data());
    if (status == KinematicsStatus::joint_out_of_limits) throw outside_limits(values, place);
    if (status != KinematicsStatus::ok) throw error_at(place, "", "a link leaves the number range", "at most 4 m in each coordinate");
    CheckedConfiguration result;
    result.scene = {ClearanceStatus::clear, ScalarTraits<Q>::greatest(), {}};
    result.itself = result.scene;
    bodies_.clear();
    for (int i = 0; i < chain_->body_count(); ++i) bodies_.push_back(chain_->placed_body(i, poses_.data()));
    for (int i = 0; i < chain_->body_count() && scene.valid(); ++i) {
      const SweepEffort<Q> effort = {16, quantise<Q>(0.000001)};
      result.scene = nearer(result.scene, clearance(scene, bodies_[static_cast<std::size_t>(i)], chain_->body_error(i), effort));
    }
    for (const BodyPair& pair : robot_.self_pairs) {
      result.itself = nearer(result.itself, clearance_between(bodies_[pair.first], bodies_[pair.second],
                                                              chain_->body_error(pair.first) + chain_->body_error(pair.second)));
    }
    return result;
  }

  std::vector<Q> values_of(const std::map<std::string, double>& joints, const Place& place) const {
    for (const auto& [name, value] : joints) {
      if (std::find(known_joints_.begin(), known_joints_.end(), name) == known_joints_.end()) {
        throw error_at(place, "." + name, "the robot has no such joint", "allowed are " + joined({known_joints_.begin(), known_joints_.end()}));
      }
    }
    std::vector<Q> values;
    for (const std::string& name : robot_.variable_names) {
      const auto found = joints.find(name);
      if (found == joints.end()) {
        throw error_at(place, "", "no value for the joint " + name, "every moving joint needs one");
      }
      values.push_back(quantise<Q>(found->second));
    }
    values.resize(kHostLinks);
    return values;
  }
  InputError outside_limits(const std::vector<Q>& values, const Place& place) const {
    for (const nearfield::Joint<Q>& joint : robot_.joints) {
      const Q value = narrow<Q>(product(joint.multiplier, values[joint.variable])) + joint.offset;
      if (joint.kind == nearfield::JointKind::fixed || (value >= joint.lower && value <= joint.upper)) continue;
      return error_at(place, "." + robot_.variable_names[joint.variable],
                      std::to_string(value.to_double()) + " is outside the joint's limits",
                        "allowed are " + std::to_string(joint.lower.to_double()) + " to " +
                            std::to_string(joint.upper.to_double()));
    }
    return error_at(place, "", "a joint is outside its limits", "");
  }

  CompiledRobot<Q> robot_;
  std::string problem_file_;
  std::unique_ptr<HostPlayer::ArmChain> chain_;
  std::vector<std::string> known_joints_;
  std::vector<nearfield::Pose<Q>> poses_ = std::vector<nearfield::Pose<Q>>(kHostLinks);
  std::vector<nearfield::Capsule<Q>> bodies_;
};

}  // namespace

std::vector<CheckedProblem> check_problems(const std::string& robot_file, const std::string& srdf_file,
                                           const std::string& problem_file, const ProgressReport& report) {
  RobotDescription robot = read_urdf(robot_file);
  if (!srdf_file.empty()) read_srdf(srdf_file, robot);
  const std::vector<Problem> problems = read_problems(problem_file);
  Checker checker(robot, robot_file, !srdf_file.empty(), problem_file);
  std::vector<CheckedProblem> checked;
  for (std::size_t i = 0; i < problems.size(); ++i) {
    checked.push_back(checker.check(problems[i], i));
    report(static_cast<double>(i + 1) / static_cast<double>(problems.size()));
  }
  return checked;
}

}  // namespace nearfield::host
