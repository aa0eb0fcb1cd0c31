#include "model/robot_tree.hpp"

#include <string_view>

#include "text/names.hpp"

namespace nearfield::host {
namespace {

std::size_t link_index(const RobotDescription& robot, const NamedJoint& joint, std::string_view element,
                       const std::string& name) {
  if (const auto index = robot.find_link(name)) return *index;
  std::vector<std::string_view> names;
  for (const Link& link : robot.links) names.push_back(link.name);
  joint.node.required_child(element).fail_attribute("link", unknown_name("link", name, names),
                                                    "one of " + joined(names));
}

void check_names(const RobotDescription& robot, const std::vector<XmlNode>& link_nodes,
                 const std::vector<NamedJoint>& joints) {
  std::set<std::string_view> names;
  for (std::size_t index = 0; index < robot.links.size(); ++index) {
    if (!names.insert(robot.links[index].name).second) {
      link_nodes[index].fail("a second link of this name", "each name once");
    }
  }
  names.clear();
  for (const NamedJoint& joint : joints) {
    if (!names.insert(joint.joint.name).second) {
      joint.node.fail("a second joint of this name", "each name once");
    }
  }
}

// Joints from the root outwards, those of one link in the file's order.
std::vector<const NamedJoint*> order_joints(RobotDescription& robot, const XmlNode& robot_node,
                                            const std::vector<XmlNode>& link_nodes,
                                            const std::vector<NamedJoint>& joints) {
  const std::size_t link_count = robot.links.size();
  std::vector<std::vector<const NamedJoint*>> joints_of_parent(link_count);
  std::vector<const NamedJoint*> joint_of_child(link_count, nullptr);
  for (const NamedJoint& joint : joints) {
    const std::size_t parent = link_index(robot, joint, "parent", joint.parent);
    const std::size_t child = link_index(robot, joint, "child", joint.child);
    if (joint_of_child[child] != nullptr) {
      joint.node.required_child("child").fail_attribute(
          "link",
          "link " + in_quotes(joint.child) + " is already the child of " +
              in_quotes(joint_of_child[child]->joint.name),
          "one parent a link");
    }
    joint_of_child[child] = &joint;
    joints_of_parent[parent].push_back(&joint);
  }
  std::optional<std::size_t> root;
  for (std::size_t link = 0; link < link_count; ++link) {
    if (joint_of_child[link] != nullptr) continue;
    if (root) {
      link_nodes[link].fail(
          "a second root: no joint leads to it, nor to " + in_quotes(robot.links[*root].name),
          "exactly one link without a parent");
    }
    root = link;
  }
  if (!root) robot_node.fail("every link has a parent: the joints form a cycle", "a tree with one root");
  robot.root_link = *root;

  std::vector<const NamedJoint*> ordered;
  std::vector<bool> reached(link_count, false);
  std::vector<std::size_t> queue{*root};
  reached[*root] = true;
  for (std::size_t next = 0; next < queue.size(); ++next) {
    for (const NamedJoint* joint : joints_of_parent[queue[next]]) {
      const std::size_t child = *robot.find_link(joint->child);
      ordered.push_back(joint);
      reached[child] = true;
      queue.push_back(child);
    }
  }
  for (std::size_t link = 0; link < link_count; ++link) {
    if (!reached[link]) link_nodes[link].fail("part of a cycle of joints", "a tree with one root");
  }
  return ordered;
}

void resolve_mimic(RobotDescription& robot, std::size_t index,
                   const std::vector<const NamedJoint*>& ordered) {
  Joint& joint = robot.joints[index];
  const std::optional<NamedMimic>& mimic = ordered[index]->mimic;
  if (!mimic || joint.kind == JointKind::fixed) return;
  const auto leader = robot.find_joint(mimic->joint);
  if (!leader) {
    std::vector<std::string_view> names;
    for (const Joint& other : robot.joints) names.push_back(other.name);
    mimic->node.fail_attribute("joint", unknown_name("joint", mimic->joint, names),
                               "one of " + joined(names));
  }
  const std::string allowed = "a joint that moves and has no mimic";
  if (*leader == index) mimic->node.fail_attribute("joint", "a joint cannot mimic itself", allowed);
  if (robot.joints[*leader].kind == JointKind::fixed) {
    mimic->node.fail_attribute("joint", in_quotes(mimic->joint) + " is fixed", allowed);
  }
  if (ordered[*leader]->mimic) {
    mimic->node.fail_attribute("joint", in_quotes(mimic->joint) + " is a mimic itself", allowed);
  }
  joint.mimic = Mimic{*leader, mimic->multiplier, mimic->offset};
}

}  // namespace

void build_robot_tree(RobotDescription& robot, const XmlNode& robot_node,
                      const std::vector<XmlNode>& link_nodes, const std::vector<NamedJoint>& joints) {
  check_names(robot, link_nodes, joints);
  const std::vector<const NamedJoint*> ordered = order_joints(robot, robot_node, link_nodes, joints);
  robot.joints.clear();
  for (const NamedJoint* named : ordered) {
    robot.joints.push_back(named->joint);
    robot.joints.back().parent = *robot.find_link(named->parent);
    robot.joints.back().child = *robot.find_link(named->child);
  }
  for (std::size_t index = 0; index < ordered.size(); ++index) resolve_mimic(robot, index, ordered);
}

}  // namespace nearfield::host
