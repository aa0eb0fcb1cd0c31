#pragma once

#include <cstddef>

#include "text/number.hpp"

namespace nearfield::host {

// What every reader of positions and sizes allows: the range of the numbers in a robot-cell field.
inline constexpr NumberRange position_range{-16.0, 16.0, "m"};
inline constexpr NumberRange size_range{0.0, 16.0, "m", true};
inline constexpr NumberRange angle_range{-10.0, 10.0, "rad"};
inline constexpr NumberRange joint_value_range{-1000.0, 1000.0, "rad or m"};
inline constexpr NumberRange quaternion_range{-1.000001, 1.000001, {}};

inline constexpr std::size_t longest_name = 200;   // bytes
inline constexpr std::size_t longest_path = 4096;  // bytes

}  // namespace nearfield::host
