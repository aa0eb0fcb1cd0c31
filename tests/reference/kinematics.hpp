#pragma once
/// Forward kinematics of a tree of links joined by fixed, revolute and prismatic joints.

#include "vector.hpp"

#include <cstddef>
#include <stdexcept>
#include <vector>

namespace nearfield::reference {

enum class JointKind { fixed, revolute, prismatic };

/// `origin` places the joint frame in the parent link; the child link's frame is the joint frame after its
/// motion. `axis` is in the joint frame, of any length but zero (it is normalised); a fixed joint ignores it.
struct Joint {
  JointKind kind = JointKind::fixed;
  std::size_t parent_link = 0;
  std::size_t child_link = 0;
  Pose origin{};
  Vec3 axis{1, 0, 0};
};

/// Links are numbered 0 … link_count - 1; joints may stand in any order.
struct KinematicTree {
  std::size_t link_count = 0;
  std::size_t root_link = 0;
  std::vector<Joint> joints;
};

/// Motion of a joint by `position`: radians (revolute), metres (prismatic), ignored (fixed).
inline Pose joint_motion(const Joint& joint, Real position) {
  switch (joint.kind) {
    case JointKind::fixed:
      return {};
    case JointKind::revolute:
      return {rotation_from_axis_angle(joint.axis, position), {}};
    case JointKind::prismatic: {
      const Real length = norm(joint.axis);
      if (!(length > 0)) throw std::invalid_argument("prismatic axis of length zero");
      return {{}, joint.axis * (position / length)};
    }
  }
  throw std::invalid_argument("unknown joint");
}

/// World poses of all links, by link number. `positions` has one entry a joint, in the joints' order.
/// std::invalid_argument if the sizes differ or the joints are not a tree that spans all links from the root.
inline std::vector<Pose> forward_kinematics(const KinematicTree& tree, const std::vector<Real>& positions,
                                            const Pose& root_pose = {}) {
  if (positions.size() != tree.joints.size()) throw std::invalid_argument("one position a joint is needed");
  if (tree.root_link >= tree.link_count) throw std::invalid_argument("root link out of range");
  if (tree.joints.size() + 1 != tree.link_count) throw std::invalid_argument("joints do not form a tree");
  std::vector<Pose> poses(tree.link_count);
  std::vector<bool> known(tree.link_count, false);
  poses[tree.root_link] = root_pose;
  known[tree.root_link] = true;
  std::size_t placed = 1;
  for (bool progress = true; progress;) {
    progress = false;
    for (std::size_t i = 0; i < tree.joints.size(); ++i) {
      const Joint& joint = tree.joints[i];
      if (joint.parent_link >= tree.link_count || joint.child_link >= tree.link_count) {
        throw std::invalid_argument("joint names a link out of range");
      }
      if (!known[joint.parent_link] || known[joint.child_link]) continue;
      poses[joint.child_link] = poses[joint.parent_link] * joint.origin * joint_motion(joint, positions[i]);
      known[joint.child_link] = true;
      ++placed;
      progress = true;
    }
  }
  if (placed != tree.link_count) throw std::invalid_argument("joints do not form a tree");
  return poses;
}

}  // namespace nearfield::reference
