#include "model/srdf.hpp"

#include <algorithm>
#include <optional>
#include <utility>
#include <vector>

#include "text/names.hpp"
#include "text/read_file.hpp"
#include "text/xml.hpp"
#include "text/xml_node.hpp"

namespace nearfield::host {
namespace {

std::size_t read_link(const XmlNode& node, std::string_view attribute, const RobotDescription& robot) {
  const std::string name = node.text(attribute);
  if (const auto index = robot.find_link(name)) return *index;
  std::vector<std::string_view> names;
  for (const Link& link : robot.links) names.push_back(link.name);
  node.fail_attribute(attribute, unknown_name("link", name, names), "one of " + joined(names));
}

}  // namespace

void parse_srdf(std::string_view text, const std::string& file, RobotDescription& robot) {
  const XmlDocument document = parse_xml(text, file);
  const XmlNode robot_node(document);
  if (robot_node.name() != "robot") {
    robot_node.fail("the root element is " + in_quotes(robot_node.name()), "\"robot\"");
  }
  auto pairs = robot.unchecked_pairs;
  std::size_t count = 0;
  for (const XmlNode& child : robot_node.children()) {
    if (child.name() != "disable_collisions") continue;
    const XmlNode node = child.labelled(std::to_string(count++));
    node.reject_unknown_attributes({"link1", "link2", "reason"});
    const std::size_t first = read_link(node, "link1", robot);
    const std::size_t second = read_link(node, "link2", robot);
    if (first == second) node.fail_attribute("link2", "the same link as link1", "two different links");
    pairs.insert(std::minmax(first, second));
  }
  robot.unchecked_pairs = std::move(pairs);
}

void read_srdf(const std::string& path, RobotDescription& robot) { parse_srdf(read_file(path), path, robot); }

}  // namespace nearfield::host
