#pragma once

#include <map>
#include <optional>
#include <string>
#include <vector>

#include "model/field_node.hpp"
#include "text/source_position.hpp"

namespace nearfield::host {

// Joint values, in rad or m by joint name, at a time in s.
struct Waypoint {
  double time = 0.0;
  std::map<std::string, double> joints;
  std::optional<std::string> event;  // only in a cycle
  SourcePosition position;
};

// A moving human: a robot description whose joints follow a path, held before its first and after its last
// time.
struct PersonDescription {
  std::string robot;           // URDF file, relative to the current folder
  std::vector<Waypoint> path;  // at least 2, times strictly increasing, all with the same joints
};

// What the arm does over and over: at least 2 waypoints, the first at time 0, times strictly increasing,
// all with the same joints, the last joint values equal to the first.
struct CycleDescription {
  std::vector<Waypoint> waypoints;
};

// What protective distances are computed from.
struct SeparationDescription {
  double human_speed = 0.0;         // m/s
  double robot_speed = 0.0;         // m/s
  double reaction_time = 0.0;       // s
  double stopping_time = 0.0;       // s
  double stopping_distance = 0.0;   // m
  double intrusion_distance = 0.0;  // m
  double human_uncertainty = 0.0;   // m
  double robot_uncertainty = 0.0;   // m
  double slow_override = 0.0;       // share of full speed, 0 to 1
  double slow_margin = 0.0;         // m
  double cell_stop = 0.0;           // m
  double cell_slow = 0.0;           // m, above cell_stop
};

struct SceneDescription {
  std::string file;
  std::string name;
  FieldNode field;                       // distance: what the arm must not touch
  std::optional<FieldNode> soft;         // intensity
  std::optional<std::string> robot;      // URDF file, relative to the current folder
  std::optional<std::string> tool_link;  // its origin carries the tool
  std::optional<PersonDescription> person;
  std::optional<CycleDescription> cycle;
  std::optional<SeparationDescription> separation;
  double duration = 0.0;  // s
};

}  // namespace nearfield::host
