#pragma once

#include <limits>
#include <optional>
#include <string>
#include <string_view>

namespace nearfield::host {

// The shortest decimal text that reads back as the same double, independent of the locale.
std::string format_number(double value);

// The whole of `text` as a decimal number such as `-1.5e-3`, correctly rounded, independent of the locale.
// Nothing when it is anything else: white space, a leading plus, hexadecimal, infinity, not-a-number, or a
// magnitude that no double has.
std::optional<double> parse_number(std::string_view text);

// What a number may be: from `lowest` (or just above it) to `highest`, both in `unit`.
struct NumberRange {
  double lowest = std::numeric_limits<double>::lowest();
  double highest = std::numeric_limits<double>::max();
  std::string_view unit = {};
  bool lowest_excluded = false;
};

bool contains(const NumberRange& range, double value);

// The range in words: `from 0 to 16 m`, `above 0 and at most 16 m`, `at least 0 m`, `of any size`.
std::string describe(const NumberRange& range);

}  // namespace nearfield::host
