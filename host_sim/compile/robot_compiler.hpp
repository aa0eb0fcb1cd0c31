// Robots as firmware_core sees them: joints, bodies, pairs to keep apart.
#pragma once

#include <string>
#include <vector>

#include <nearfield/query/chain.hpp>

#include "model/robot_description.hpp"

namespace nearfield::host {

// Link 0 is the root; link k + 1 is moved by joint k of the description.
template <class S> struct CompiledRobot {
  std::vector<nearfield::Joint<S>> joints;
  std::vector<nearfield::Body<S>> bodies;
  std::vector<nearfield::BodyPair> self_pairs;  // bodies of link pairs that are not unchecked
  std::vector<std::string> link_names;          // by link number
  std::vector<std::string> variable_names;      // by variable number: joints that move and mimic nothing
  std::vector<bool> fixed_to_root;              // by link number: joined to the root by fixed joints only
  double greatest_cover = 0.0;                  // m: how far bodies stand out of the boxes and cylinders they cover

  // The number of a link; the link count when there is none of that name.
  std::size_t find_link(const std::string& name) const;
};

// Spheres and capsules are taken as they are. A cylinder becomes the capsule of its axis and radius; a box a row of
// capsules that cover it. Both are larger than the solid (greatest_cover), so that clearances stay lower bounds.
// Directly joined links are not checked against each other when `checks_neighbours` is false.
// InputError (with `file`) where a number does not fit the scalar type or there are more bodies than firmware takes.
template <class S>
CompiledRobot<S> compile_robot(const RobotDescription& robot, const std::string& file, bool checks_neighbours);

}  // namespace nearfield::host
