#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "model/vector3d.hpp"

namespace nearfield::host {

// Points as comma-separated values: three numbers a line (m), white space around them allowed, the first line
// may be `x,y,z`, empty lines do not count. InputError with line and column of the first value that is not a
// number, that is missing or too many, and when there is no point at all.
std::vector<Vector3d> parse_points(std::string_view text, const std::string& file);
std::vector<Vector3d> read_points(const std::string& path);

}  // namespace nearfield::host
