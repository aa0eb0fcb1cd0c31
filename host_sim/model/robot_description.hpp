#pragma once

#include <algorithm>
#include <cstddef>
#include <optional>
#include <set>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "model/placement.hpp"
#include "text/source_position.hpp"

namespace nearfield::host {

enum class CollisionKind { sphere, box, cylinder, capsule };

// A solid centred on its origin; cylinders and capsules lie along the local z axis.
struct CollisionShape {
  CollisionKind kind = CollisionKind::sphere;
  std::string name;     // may be empty
  Placement origin;     // in the frame of its link, or of the cell for an obstacle
  Vector3d size;        // m, box: full edges
  double radius = 0.0;  // m, sphere, cylinder, capsule
  double length = 0.0;  // m, cylinder: full height; capsule: axis segment without the caps
  SourcePosition position;
};

struct Link {
  std::string name;
  std::vector<CollisionShape> shapes;
  SourcePosition position;
};

enum class JointKind { revolute, continuous, prismatic, fixed };

// value = multiplier · (value of the other joint) + offset
struct Mimic {
  std::size_t joint = 0;  // moves, and mimics nothing itself
  double multiplier = 1.0;
  double offset = 0.0;  // rad or m
};

struct Joint {
  std::string name;
  JointKind kind = JointKind::fixed;
  std::size_t parent = 0;         // link index
  std::size_t child = 0;          // link index
  Placement origin;               // of the child's frame in the parent's, at value 0
  Vector3d axis{1.0, 0.0, 0.0};   // unit, in the child's frame
  std::optional<double> lower;    // rad or m; set for revolute and prismatic, lower <= upper
  std::optional<double> upper;    // rad or m
  std::optional<double> velocity;  // rad/s or m/s, at least 0
  std::optional<Mimic> mimic;     // never for a fixed joint
  SourcePosition position;
};

inline constexpr std::size_t most_links = 64;

// A tree of links. `joints` are ordered so that the joint that moves a joint's parent comes before it.
struct RobotDescription {
  std::string name;
  std::vector<Link> links;
  std::vector<Joint> joints;
  std::size_t root_link = 0;
  // Pairs of link indices, the smaller first, that are never checked against each other.
  std::set<std::pair<std::size_t, std::size_t>> unchecked_pairs;

  std::optional<std::size_t> find_link(std::string_view link_name) const {
    return index_of(links, link_name);
  }
  std::optional<std::size_t> find_joint(std::string_view joint_name) const {
    return index_of(joints, joint_name);
  }
  bool is_unchecked(std::size_t link_a, std::size_t link_b) const {
    return unchecked_pairs.count(std::minmax(link_a, link_b)) != 0;
  }

 private:
  template <class Named>
  static std::optional<std::size_t> index_of(const std::vector<Named>& all, std::string_view wanted) {
    for (std::size_t index = 0; index < all.size(); ++index) {
      if (all[index].name == wanted) return index;
    }
    return std::nullopt;
  }
};

}  // namespace nearfield::host
