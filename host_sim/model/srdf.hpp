#pragma once

#include <string>
#include <string_view>

#include "model/robot_description.hpp"

namespace nearfield::host {

// Adds to `robot.unchecked_pairs` the link pairs of the `disable_collisions` elements of an SRDF file; other
// elements are ignored. InputError on a link that the robot does not have and on a link paired with itself;
// `robot` is then unchanged.
void read_srdf(const std::string& path, RobotDescription& robot);

// The same from text; `file` is the name that errors show.
void parse_srdf(std::string_view text, const std::string& file, RobotDescription& robot);

}  // namespace nearfield::host
