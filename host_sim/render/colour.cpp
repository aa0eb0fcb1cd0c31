#include "render/colour.hpp"

#include <algorithm>
#include <cmath>

namespace nearfield::host {
namespace {

double light_of(int byte) {
  const double share = byte / 255.0;
  return share <= 0.04045 ? share / 12.92 : std::pow((share + 0.055) / 1.055, 2.4);
}
int digit_of(char c) {
  if (c >= '0' && c <= '9') return c - '0';
  if (c >= 'a' && c <= 'f') return c - 'a' + 10;
  if (c >= 'A' && c <= 'F') return c - 'A' + 10;
  return -1;
}

}  // namespace

std::optional<Colour> colour_of(std::string_view text) {
  if (text.size() != 7 || text[0] != '#') return std::nullopt;
  double light[3] = {};
  for (std::size_t i = 0; i < 3; ++i) {
    const int high = digit_of(text[1 + 2 * i]), low = digit_of(text[2 + 2 * i]);
    if (high < 0 || low < 0) return std::nullopt;
    light[i] = light_of(16 * high + low);
  }
  return Colour{light[0], light[1], light[2]};
}

std::uint8_t srgb_byte(double light) {
  const double x = std::clamp(light, 0.0, 1.0);
  const double share = x <= 0.0031308 ? 12.92 * x : 1.055 * std::pow(x, 1.0 / 2.4) - 0.055;
  return static_cast<std::uint8_t>(std::lround(255.0 * share));
}

}  // namespace nearfield::host
