// Clearances of a robot in the starts and goals of motion-planning problems.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include <nearfield/query/clearance.hpp>

#include "simulate/simulation.hpp"

namespace nearfield::host {

struct CheckedConfiguration {
  Clearance<Q> scene;   // over all bodies
  Clearance<Q> itself;  // over all pairs that are checked

  bool clear() const { return scene.status == ClearanceStatus::clear && itself.status == ClearanceStatus::clear; }
};

struct CheckedProblem {
  std::string set;
  std::int64_t index = 0;
  CheckedConfiguration start, goal;

  bool valid() const { return start.clear() && goal.clear(); }
};

// InputError for files that cannot be read, joints that are missing or outside their limits, obstacles out of range.
// Values for joints that do not move are ignored.
std::vector<CheckedProblem> check_problems(const std::string& robot_file, const std::string& srdf_file,
                                           const std::string& problem_file, const ProgressReport& report);

}  // namespace nearfield::host
