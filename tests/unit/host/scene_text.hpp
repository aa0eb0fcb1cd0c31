#pragma once

#include <string>

namespace nearfield::host {

// A scene with every key that is not a parameter of a node.
inline const std::string scene_text = R"({
  "format": "nearfield-scene-1",
  "name": "cell",
  "duration": 12.5,
  "robot": "arm.urdf",
  "tool_link": "hand",
  "field": {"type": "union", "name": "all", "operands": [
    {"type": "sphere", "radius": 0.25, "position": [1, 2, 3]},
    {"type": "capsule", "from": [0, 0, 0], "to": [0, 0, 1], "radius": 0.1, "link": "person/arm"},
    {"type": "box", "size": [1, 2, 3], "position": [0, 0, 1], "rpy": [0, 0, 1.5]},
    {"type": "cylinder", "height": 2, "radius": 0.5, "orientation_xyzw": [0, 0, 0, 1]},
    {"type": "exterior_union", "blend_radius": 0.1, "rising_range": 0.005, "step": "polynomial2","operands": [
    {"type": "intersection", "operands": [{"type": "sphere", "radius": 2}, {"type": "sphere", "radius": 3}]},
    {"type": "subtraction", "operands": [{"type": "sphere", "radius": 4}, {"type": "sphere", "radius": 5}]}]},
    {"type": "exterior_intersection", "blend_radius": 0.1, "rising_range": 0.4, "operands": [
      {"type": "sphere", "radius": 6}, {"type": "sphere", "radius": 7}]},
    {"type": "exterior_subtraction", "blend_radius": 1, "rising_range": 1, "step": {"curve": "logistic"},
      "operands": [{"type": "sphere", "radius": 8}, {"type": "sphere", "radius": 9}]},
    {"type": "place", "position": [0, 1, 0], "operands": [{"type": "sphere", "radius": 10}]}
  ]},
  "soft": {"type": "soft_sum", "operands": [
  {"type": "soft_point", "influence_radius": 0.5, "position": [0, 0, 1], "weight": -2, "potential": "wyvill"},
    {"type": "soft_segment", "influence_radius": 0.75, "from": [0, 0, 0], "to": [1, 0, 0]}]},
  "person": {"robot": "person.urdf", "path": [
    {"time": 1, "joints": {"walk": 0}},
    {"time": 2, "joints": {"walk": 1.5}}]},
  "cycle": {"waypoints": [
    {"time": 0, "joints": {"a": 0, "b": 1}, "event": "grip"},
    {"time": 4, "joints": {"a": 1, "b": 2}},
    {"time": 8, "joints": {"a": 0, "b": 1}}]},
  "separation": {"human_speed": 1.6, "robot_speed": 2, "reaction_time": 0.1, "stopping_time": 0.3,
    "stopping_distance": 0.2, "intrusion_distance": 0.05, "human_uncertainty": 0.04,
    "robot_uncertainty": 0.01, "slow_override": 0.25, "slow_margin": 0.3, "cell_stop": 0.02, "cell_slow": 0.1}
}
)";

}  // namespace nearfield::host
