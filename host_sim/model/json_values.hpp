#pragma once

#include <map>
#include <string>

#include "model/placement.hpp"
#include "text/json_node.hpp"

namespace nearfield::host {

// Values that several JSON formats share. All throw InputError as JsonNode does.

// Which parts of a placement an object may give.
enum class PlacementParts { none, position, position_and_orientation };

// `position` and either `orientation_xyzw` or `rpy`, each optional; only the allowed parts are looked at.
Placement read_placement(const JsonNode& object, PlacementParts parts);

// An object of joint values in rad or m by joint name.
std::map<std::string, double> read_joint_values(const JsonNode& object);

}  // namespace nearfield::host
