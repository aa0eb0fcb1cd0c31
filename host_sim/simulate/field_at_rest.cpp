#include "simulate/field_at_rest.hpp"

#include <string_view>

#include "model/urdf.hpp"
#include "text/names.hpp"

namespace nearfield::host {
namespace {

std::optional<std::string> person_file(const SceneDescription& scene) {
  if (!scene.person) return std::nullopt;
  return scene.person->robot;
}

}  // namespace

std::optional<Placement> RestingRobot::placement_of(const std::string& link) {
  read();
  const auto index = robot_->find_link(link);
  if (!index) return std::nullopt;
  return placements_[*index];
}

std::string RestingRobot::link_names() {
  read();
  std::vector<std::string_view> names;
  for (const Link& link : robot_->links) names.push_back(link.name);
  return joined(names);
}

void RestingRobot::read() {
  if (robot_) return;
  robot_ = read_urdf(*file_);
  placements_ = rest_placements(*robot_);
}

RestingLinks::RestingLinks(const SceneDescription& scene)
    : file_(scene.file), arm_(scene.robot), person_(person_file(scene)) {}

Placement RestingLinks::placement_of(const FieldNode& node, const std::string& link) {
  const std::string prefix = "person/";
  const bool of_person = link.rfind(prefix, 0) == 0;
  RestingRobot& robot = of_person ? person_ : arm_;
  if (!robot.exists()) {
    fail(node, "link of a robot, but the scene has none", "name one with the scene's key \"robot\"");
  }
  const auto placement = robot.placement_of(of_person ? link.substr(prefix.size()) : link);
  if (!placement) {
    fail(node, "no link " + in_quotes(link),
         std::string(of_person ? "person/ and one of " : "one of ") + robot.link_names());
  }
  return *placement;
}

void RestingLinks::fail(const FieldNode& node, const std::string& message, const std::string& allowed) const {
  throw InputError(file_, node.position, node.path + ".link", message, allowed);
}

}  // namespace nearfield::host
