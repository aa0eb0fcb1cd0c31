#pragma once

#include <cstdint>
#include <map>
#include <string>
#include <string_view>
#include <vector>

#include "model/robot_description.hpp"

namespace nearfield::host {

// One motion-planning problem: obstacles (boxes, cylinders and spheres in the robot's base frame) and the
// joint values, in rad or m by joint name, of a start and a goal.
struct Problem {
  std::string set;
  std::int64_t index = 0;  // within its set
  std::vector<CollisionShape> objects;
  std::map<std::string, double> start;
  std::map<std::string, double> goal;
  SourcePosition start_position;
  SourcePosition goal_position;
};

// Reads a JSON array of problems (FORMATS.md). InputError on anything else.
std::vector<Problem> read_problems(const std::string& path);

// The same from text; `file` is the name that errors show.
std::vector<Problem> parse_problems(std::string_view text, const std::string& file);

}  // namespace nearfield::host
