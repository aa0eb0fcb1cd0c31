#include "draw/number_text.hpp"

#include <charconv>
#include <cmath>
#include <stdexcept>

namespace nearfield::host::draw {

std::string fixed_text(double value, int decimals) {
  if (!std::isfinite(value) || std::fabs(value) >= 1e15) {
    throw std::invalid_argument("draw: a number to write is not finite or is out of range");
  }
  if (decimals < 0 || decimals > 9) throw std::invalid_argument("draw: decimals must be 0 to 9");
  char digits[40];
  const auto end =
      std::to_chars(digits, digits + sizeof digits, value, std::chars_format::fixed, decimals).ptr;
  std::string text(digits, end);
  if (text[0] == '-' && text.find_first_not_of("-0.") == std::string::npos) text.erase(0, 1);
  return text;
}

std::string short_text(double value, int decimals) {
  std::string text = fixed_text(value, decimals);
  if (text.find('.') == std::string::npos) return text;
  text.erase(text.find_last_not_of('0') + 1);
  if (text.back() == '.') text.pop_back();
  return text;
}

std::string length_text(double metres) {
  return std::fabs(metres) < 0.9995 ? fixed_text(metres * 1000.0, 0) + " mm" : fixed_text(metres, 2) + " m";
}

}  // namespace nearfield::host::draw
