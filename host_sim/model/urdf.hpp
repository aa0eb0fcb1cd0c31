#pragma once

#include <string>
#include <string_view>

#include "model/robot_description.hpp"

namespace nearfield::host {

// Reads the collision geometry and the joints of a robot from URDF (the subset in FORMATS.md). InputError,
// with file, line, column and path, on anything that would make the robot other than its author meant.
RobotDescription read_urdf(const std::string& path);

// The same from text; `file` is the name that errors show.
RobotDescription parse_urdf(std::string_view text, const std::string& file);

}  // namespace nearfield::host
