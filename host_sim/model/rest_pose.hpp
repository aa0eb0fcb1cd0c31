#pragma once

#include <vector>

#include "model/robot_description.hpp"

namespace nearfield::host {

// Where each link's frame lies in that of the root link when every joint that mimics nothing has the value 0,
// or the limit nearest to it. By link index.
std::vector<Placement> rest_placements(const RobotDescription& robot);

}  // namespace nearfield::host
