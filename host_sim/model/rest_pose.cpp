#include "model/rest_pose.hpp"

#include <algorithm>
#include <cmath>

namespace nearfield::host {
namespace {

// Nearest to 0 within the joint's limits.
double rest_value(const Joint& joint) {
  double value = 0.0;
  if (joint.lower) value = std::max(value, *joint.lower);
  if (joint.upper) value = std::min(value, *joint.upper);
  return value;
}

// Right-handed about a unit axis.
Placement turned(const Vector3d& axis, double angle) {
  const double c = std::cos(angle), s = std::sin(angle), rest = 1.0 - c;
  Placement placement;
  placement.rotation = {axis.x * axis.x * rest + c,          axis.x * axis.y * rest - axis.z * s,
                        axis.x * axis.z * rest + axis.y * s, axis.x * axis.y * rest + axis.z * s,
                        axis.y * axis.y * rest + c,          axis.y * axis.z * rest - axis.x * s,
                        axis.x * axis.z * rest - axis.y * s, axis.y * axis.z * rest + axis.x * s,
                        axis.z * axis.z * rest + c};
  return placement;
}

Placement motion(const Joint& joint, double value) {
  if (joint.kind == JointKind::fixed) return {};
  if (joint.kind == JointKind::prismatic) return {value * joint.axis};
  return turned(joint.axis, value);
}

}  // namespace

std::vector<Placement> rest_placements(const RobotDescription& robot) {
  std::vector<Placement> placements(robot.links.size());
  for (const Joint& joint : robot.joints) {
    double value = rest_value(joint);
    if (joint.mimic) {
      value = joint.mimic->multiplier * rest_value(robot.joints[joint.mimic->joint]) + joint.mimic->offset;
    }
    placements[joint.child] = compose(placements[joint.parent], compose(joint.origin, motion(joint, value)));
  }
  return placements;
}

}  // namespace nearfield::host
