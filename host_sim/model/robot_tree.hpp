#pragma once

#include <optional>
#include <string>
#include <vector>

#include "model/robot_description.hpp"
#include "text/xml_node.hpp"

namespace nearfield::host {

// A joint as it stands in the file: other links and joints by name.
struct NamedMimic {
  std::string joint;
  double multiplier = 1.0;
  double offset = 0.0;
  XmlNode node;
};

struct NamedJoint {
  Joint joint;  // all but parent, child and mimic
  std::string parent;
  std::string child;
  std::optional<NamedMimic> mimic;
  XmlNode node;
};

// Fills robot.joints and robot.root_link from robot.links and the named joints. InputError on unknown links
// and joints, names used twice, links with two parents, more or less than one root, a cycle, and a mimic of
// itself, of a fixed joint or of another mimic. `robot_node` and `link_nodes` (one a link) place the errors.
void build_robot_tree(RobotDescription& robot, const XmlNode& robot_node,
                      const std::vector<XmlNode>& link_nodes, const std::vector<NamedJoint>& joints);

}  // namespace nearfield::host
