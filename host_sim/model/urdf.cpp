#include "model/urdf.hpp"

#include <array>
#include <limits>
#include <optional>
#include <utility>
#include <vector>

#include "model/limits.hpp"
#include "model/robot_tree.hpp"
#include "text/names.hpp"
#include "text/read_file.hpp"
#include "text/xml.hpp"
#include "text/xml_node.hpp"

namespace nearfield::host {
namespace {

constexpr NumberRange any_number{};
constexpr NumberRange velocity_range{0.0, std::numeric_limits<double>::max(), "rad/s or m/s"};
constexpr NumberRange axis_range{-1e6, 1e6, {}};
constexpr double shortest_axis = 1e-9;

Vector3d vector_of(const std::vector<double>& numbers) { return {numbers[0], numbers[1], numbers[2]}; }

Placement read_origin(const XmlNode& parent) {
  const std::optional<XmlNode> origin = parent.optional_child("origin");
  if (!origin) return {};
  origin->reject_unknown_attributes({"xyz", "rpy"});
  origin->reject_unknown_children({});
  Vector3d position;
  Vector3d angles;
  if (origin->has_attribute("xyz")) position = vector_of(origin->numbers("xyz", 3, position_range));
  if (origin->has_attribute("rpy")) angles = vector_of(origin->numbers("rpy", 3, angle_range));
  return placement_from_rpy(position, angles.x, angles.y, angles.z);
}

void read_geometry(const XmlNode& geometry, CollisionShape& shape) {
  const std::string allowed = "one of sphere, box, cylinder, capsule";
  const std::vector<XmlNode> shapes = geometry.children();
  geometry.reject_unknown_attributes({});
  if (shapes.empty()) geometry.fail("no shape", allowed);
  const XmlNode& node = shapes.front();
  if (node.name() == "mesh") {
    node.fail("a mesh cannot be checked for collision",
              "cover the part with spheres, boxes, cylinders or capsules, several <collision> a link");
  }
  geometry.reject_unknown_children({"sphere", "box", "cylinder", "capsule"});
  if (shapes.size() > 1) shapes[1].fail("a second shape", "one shape a collision; write several collisions");
  node.reject_unknown_children({});
  if (node.name() == "box") {
    shape.kind = CollisionKind::box;
    node.reject_unknown_attributes({"size"});
    shape.size = vector_of(node.numbers("size", 3, size_range));
    return;
  }
  if (node.name() == "sphere") {
    shape.kind = CollisionKind::sphere;
    node.reject_unknown_attributes({"radius"});
  } else {
    shape.kind = node.name() == "cylinder" ? CollisionKind::cylinder : CollisionKind::capsule;
    node.reject_unknown_attributes({"radius", "length"});
    shape.length = node.number("length", size_range);
  }
  shape.radius = node.number("radius", size_range);
}

CollisionShape read_collision(const XmlNode& node) {
  node.reject_unknown_attributes({"name"});
  node.reject_unknown_children({"origin", "geometry", "material", "verbose"});
  CollisionShape shape;
  shape.position = node.position();
  if (node.has_attribute("name")) shape.name = node.text("name");
  shape.origin = read_origin(node);
  read_geometry(node.required_child("geometry"), shape);
  return shape;
}

Link read_link(const XmlNode& node) {
  node.reject_unknown_attributes({"name", "type"});
  node.reject_unknown_children({"collision", "visual", "inertial", "material", "contact", "gazebo", "sensor",
                                "self_collision_checking"});
  Link link;
  link.name = node.text("name");
  link.position = node.position();
  for (const XmlNode& child : node.children()) {
    if (child.name() != "collision") continue;
    link.shapes.push_back(read_collision(child.labelled(std::to_string(link.shapes.size()))));
  }
  return link;
}

JointKind read_joint_kind(const XmlNode& node) {
  constexpr std::array<std::pair<std::string_view, JointKind>, 4> kinds{{{"revolute", JointKind::revolute},
                                                                        {"continuous", JointKind::continuous},
                                                                        {"prismatic", JointKind::prismatic},
                                                                        {"fixed", JointKind::fixed}}};
  const std::string type = node.text("type");
  std::vector<std::string_view> names;
  for (const auto& [name, kind] : kinds) {
    if (name == type) return kind;
    names.push_back(name);
  }
  node.fail_attribute("type", unknown_name("joint type", type, names), "one of " + joined(names));
}

void read_axis(const XmlNode& node, Joint& joint) {
  const std::optional<XmlNode> element = node.optional_child("axis");
  if (!element) return;
  element->reject_unknown_attributes({"xyz"});
  element->reject_unknown_children({});
  const Vector3d axis = vector_of(element->numbers("xyz", 3, axis_range));
  const double axis_length = length(axis);
  if (axis_length >= shortest_axis) {
    joint.axis = (1.0 / axis_length) * axis;
  } else if (joint.kind != JointKind::fixed) {
    element->fail_attribute("xyz", "the axis has no direction", "a vector of at least 1e-9");
  }
}

void read_limit(const XmlNode& node, Joint& joint) {
  const std::optional<XmlNode> limit = node.optional_child("limit");
  const bool limited = joint.kind == JointKind::revolute || joint.kind == JointKind::prismatic;
  if (!limit) {
    if (limited) node.fail("element \"limit\" is missing", "lower and upper, which this joint type requires");
    return;
  }
  limit->reject_unknown_attributes(
      {"lower", "upper", "velocity", "effort", "acceleration", "deceleration", "jerk"});
  limit->reject_unknown_children({});
  if (joint.kind == JointKind::fixed) return;
  joint.velocity = limit->optional_number("velocity", velocity_range);
  if (!limited) return;
  joint.lower = limit->number("lower", any_number);
  joint.upper = limit->number("upper", any_number);
  if (*joint.lower > *joint.upper) {
    limit->fail_attribute("lower", format_number(*joint.lower) + " is above upper",
                          "at most " + format_number(*joint.upper));
  }
}

std::optional<NamedMimic> read_mimic(const XmlNode& node) {
  const std::optional<XmlNode> element = node.optional_child("mimic");
  if (!element) return std::nullopt;
  element->reject_unknown_attributes({"joint", "multiplier", "offset"});
  element->reject_unknown_children({});
  NamedMimic mimic{element->text("joint"), 1.0, 0.0, *element};
  mimic.multiplier = element->optional_number("multiplier", joint_value_range).value_or(1.0);
  mimic.offset = element->optional_number("offset", joint_value_range).value_or(0.0);
  return mimic;
}

std::string read_link_name(const XmlNode& joint, std::string_view element) {
  const XmlNode node = joint.required_child(element);
  node.reject_unknown_attributes({"link"});
  node.reject_unknown_children({});
  return node.text("link");
}

NamedJoint read_joint(const XmlNode& node) {
  node.reject_unknown_attributes({"name", "type"});
  node.reject_unknown_children({"origin", "parent", "child", "axis", "limit", "mimic", "calibration",
                                "dynamics", "safety_controller", "material", "gazebo"});
  Joint joint;
  joint.name = node.text("name");
  joint.kind = read_joint_kind(node);
  joint.position = node.position();
  joint.origin = read_origin(node);
  read_axis(node, joint);
  read_limit(node, joint);
  return {joint, read_link_name(node, "parent"), read_link_name(node, "child"), read_mimic(node), node};
}

}  // namespace

RobotDescription parse_urdf(std::string_view text, const std::string& file) {
  const XmlDocument document = parse_xml(text, file);
  const XmlNode robot_node(document);
  if (robot_node.name() != "robot") {
    robot_node.fail("the root element is " + in_quotes(robot_node.name()), "\"robot\"");
  }
  robot_node.reject_unknown_attributes({"name", "version", "path"});
  robot_node.reject_unknown_children(
      {"link", "joint", "material", "transmission", "gazebo", "sensor", "ros2_control"});

  RobotDescription robot;
  robot.name = robot_node.text("name");
  std::vector<XmlNode> link_nodes;
  std::vector<NamedJoint> joints;
  for (const XmlNode& child : robot_node.children()) {
    if (child.name() == "link") {
      if (robot.links.size() == most_links) {
        child.fail("too many links", "at most " + std::to_string(most_links));
      }
      const XmlNode node = child.labelled(child.text("name"));
      robot.links.push_back(read_link(node));
      link_nodes.push_back(node);
    } else if (child.name() == "joint") {
      joints.push_back(read_joint(child.labelled(child.text("name"))));
    }
  }
  if (robot.links.empty()) robot_node.fail("no links", "at least one link");
  build_robot_tree(robot, robot_node, link_nodes, joints);
  return robot;
}

RobotDescription read_urdf(const std::string& path) { return parse_urdf(read_file(path), path); }

}  // namespace nearfield::host
