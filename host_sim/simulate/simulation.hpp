// Runs a compiled work cell on the host and keeps what is worth showing.
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "compile/work_cell_compiler.hpp"
#include "work_cell/player.hpp"

namespace nearfield::host {

inline constexpr int kHostLinks = 65;
inline constexpr int kHostBodies = 1000;
using HostPlayer = work_cell::Player<kHostLinks, kHostBodies, kHostLinks, kHostBodies>;

// One tick as it was decided, in metres, seconds and plain numbers.
struct TickRecord {
  double time = 0.0;
  ArmTick<Q> decided;
  std::vector<Q> arm_joints, person_joints;
  Vector3d tool;
};

struct SimulationResult {
  std::vector<TickRecord> ticks;
  std::uint32_t cycles = 0;
  std::uint64_t digest = 0;
  std::uint32_t tick_budget = 0;  // instructions, Cortex-M4
};

// Called now and then with the share that is done, 0 to 1.
using ProgressReport = std::function<void(double)>;

// Plays all ticks. std::logic_error if the player refuses what the compiler accepted.
SimulationResult simulate(const CompiledWorkCell& cell, const ProgressReport& report);

// The bodies of a robot at given joint values, in real numbers, and the origins of its links.
struct PlacedBodies {
  std::vector<nearfield::Capsule<Q>> bodies;
  std::vector<Vector3d> link_origins;
};
PlacedBodies place_bodies(const CompiledRobot<Q>& robot, const std::vector<Q>& joints);

inline Vector3d real(const nearfield::Vector3<Q>& v) { return {v.x.to_double(), v.y.to_double(), v.z.to_double()}; }

}  // namespace nearfield::host
