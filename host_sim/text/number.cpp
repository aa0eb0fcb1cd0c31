#include "text/number.hpp"

#include <array>
#include <charconv>
#include <cmath>
#include <system_error>

namespace nearfield::host {

std::string format_number(double value) {
  std::array<char, 32> buffer{};
  const auto result = std::to_chars(buffer.data(), buffer.data() + buffer.size(), value);
  return std::string(buffer.data(), result.ptr);
}

std::optional<double> parse_number(std::string_view text) {
  double value = 0.0;
  const char* const end = text.data() + text.size();
  const auto result = std::from_chars(text.data(), end, value, std::chars_format::general);
  if (result.ec != std::errc() || result.ptr != end || !std::isfinite(value)) return std::nullopt;
  return value;
}

bool contains(const NumberRange& range, double value) {
  const bool high_enough = range.lowest_excluded ? value > range.lowest : value >= range.lowest;
  return high_enough && value <= range.highest;
}

std::string describe(const NumberRange& range) {
  const NumberRange unlimited;
  std::string text;
  if (range.highest == unlimited.highest) {
    if (range.lowest == unlimited.lowest) {
      text = "of any size";
    } else {
      text = (range.lowest_excluded ? "above " : "at least ") + format_number(range.lowest);
    }
  } else if (range.lowest_excluded) {
    text = "above " + format_number(range.lowest) + " and at most " + format_number(range.highest);
  } else {
    text = "from " + format_number(range.lowest) + " to " + format_number(range.highest);
  }
  if (!range.unit.empty()) text += " " + std::string(range.unit);
  return text;
}

}  // namespace nearfield::host
