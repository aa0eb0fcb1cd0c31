#include "simulate/simulation.hpp"

#include <algorithm>
#include <memory>
#include <stdexcept>

namespace nearfield::host {
namespace {

using HostChain = HostPlayer::ArmChain;

std::unique_ptr<HostChain> chain_of(const CompiledRobot<Q>& robot) {
  auto chain = std::make_unique<HostChain>();
  for (const nearfield::Joint<Q>& joint : robot.joints) chain->add_joint(joint);
  for (const nearfield::Body<Q>& body : robot.bodies) chain->add_body(body);
  return chain;
}

}  // namespace

SimulationResult simulate(const CompiledWorkCell& cell, const ProgressReport& report) {
  const work_cell::WorkCell view = cell.view();
  const auto player = std::make_unique<HostPlayer>(view);
  if (player->status() != work_cell::PlayerStatus::ok) {
    throw std::logic_error("the player refuses a compiled work cell: status " +
                           std::to_string(static_cast<int>(player->status())));
  }
  SimulationResult result;
  // Of the firmware, whose chains are as large as the robots.
  const std::size_t capacity = std::max({cell.arm.joints.size() + 1, cell.arm.bodies.size(),
                                         cell.person.joints.size() + 1});
  result.tick_budget = player->monitor().budget(target::cortex_m4, static_cast<std::uint32_t>(capacity));
  result.ticks.reserve(view.ticks);
  const std::size_t arm_variables = cell.arm.variable_names.size();
  const std::size_t person_variables = cell.person.variable_names.size();
  std::vector<nearfield::Pose<Q>> poses(kHostLinks);
  for (std::uint32_t tick = 0; tick < view.ticks; ++tick) {
    TickRecord record;
    record.time = tick * 0.001;
    record.arm_joints.assign(player->arm_joints(), player->arm_joints() + arm_variables);
    record.person_joints.assign(player->person_joints(), player->person_joints() + person_variables);
    record.decided = player->decide();
    if (player->arm().link_poses(player->arm_joints(), poses.data()) == KinematicsStatus::ok) {
      record.tool = real(poses[view.tool_link].translation);
    }
    player->advance(record.decided);
    result.ticks.push_back(std::move(record));
    if (tick % 200 == 0) report(static_cast<double>(tick) / view.ticks);
  }
  report(1.0);
  result.cycles = player->cycles();
  result.digest = player->digest();
  return result;
}

PlacedBodies place_bodies(const CompiledRobot<Q>& robot, const std::vector<Q>& joints) {
  PlacedBodies placed;
  const std::unique_ptr<HostChain> chain = chain_of(robot);
  std::vector<nearfield::Pose<Q>> poses(kHostLinks);
  std::vector<Q> values = joints;
  values.resize(kHostLinks);
  if (chain->link_poses(values.data(), poses.data()) != KinematicsStatus::ok) return placed;
  for (int i = 0; i < chain->body_count(); ++i) placed.bodies.push_back(chain->placed_body(i, poses.data()));
  for (int i = 0; i < chain->link_count(); ++i) {
    placed.link_origins.push_back(real(poses[static_cast<std::size_t>(i)].translation));
  }
  return placed;
}

}  // namespace nearfield::host
