#include "model/json_values.hpp"

#include <array>
#include <optional>
#include <vector>

#include "model/limits.hpp"

namespace nearfield::host {

Placement read_placement(const JsonNode& object, PlacementParts parts) {
  Placement placement;
  if (parts == PlacementParts::none) return placement;
  if (const auto node = object.optional("position")) {
    const std::vector<double> position = node->numbers(3, position_range);
    placement.position = {position[0], position[1], position[2]};
  }
  if (parts == PlacementParts::position) return placement;
  const std::optional<JsonNode> quaternion_node = object.optional("orientation_xyzw");
  const std::optional<JsonNode> angles_node = object.optional("rpy");
  if (quaternion_node && angles_node) {
    angles_node->fail("a second orientation", "either orientation_xyzw or rpy");
  }
  if (quaternion_node) {
    const std::vector<double> q = quaternion_node->numbers(4, quaternion_range);
    const auto placed =
        placement_from_quaternion_xyzw(placement.position, std::array<double, 4>{q[0], q[1], q[2], q[3]});
    if (!placed) quaternion_node->fail("the quaternion is not of unit length", "a norm within 1e-6 of 1");
    placement = *placed;
  } else if (angles_node) {
    const std::vector<double> angles = angles_node->numbers(3, angle_range);
    placement = placement_from_rpy(placement.position, angles[0], angles[1], angles[2]);
  }
  return placement;
}

std::map<std::string, double> read_joint_values(const JsonNode& object) {
  std::map<std::string, double> values;
  for (const auto& [name, node] : object.members()) {
    if (name.empty()) node.fail("empty joint name", "the name of a joint");
    values[name] = node.number(joint_value_range);
  }
  return values;
}

}  // namespace nearfield::host
