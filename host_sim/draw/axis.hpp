#pragma once

#include <cstddef>
#include <string>
#include <vector>

namespace nearfield::host::draw {

struct Tick {
  double value = 0.0;
  std::string text;
};

/// Round values (1, 2 or 5 times a power of ten apart) within [low, high], at most `greatest_count` (>= 2) of
/// them, each written with as many decimals as their spacing needs. Empty unless low < high, both finite.
std::vector<Tick> round_ticks(double low, double high, std::size_t greatest_count);

/// The smallest round value (1, 1.5, 2, 3, 4, 5, 6 or 8 times a power of ten) that is at least `value`, which
/// must be above zero and finite; 1 otherwise.
double round_up(double value);

/// Positions as near to the wanted ones (ascending) as keeps neighbours at least `gap` apart and all of them
/// within [low, high]; when they do not all fit, they are spread evenly over it.
std::vector<double> spread_apart(const std::vector<double>& wanted, double gap, double low, double high);

}  // namespace nearfield::host::draw
