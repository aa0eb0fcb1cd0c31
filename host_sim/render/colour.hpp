// Colours as amounts of light, for shading; pictures store them as sRGB.
#pragma once

#include <cstdint>
#include <optional>
#include <string_view>

namespace nearfield::host {

// Linear: 0 is none, 1 the most that a picture shows.
struct Colour {
  double red = 0.0, green = 0.0, blue = 0.0;
};

inline Colour operator+(const Colour& a, const Colour& b) {
  return {a.red + b.red, a.green + b.green, a.blue + b.blue};
}
inline Colour operator*(double factor, const Colour& a) {
  return {factor * a.red, factor * a.green, factor * a.blue};
}
inline Colour operator*(const Colour& a, const Colour& b) {
  return {a.red * b.red, a.green * b.green, a.blue * b.blue};
}
// `a` where t is 0, `b` where it is 1.
inline Colour mixed(const Colour& a, const Colour& b, double t) { return (1.0 - t) * a + t * b; }

// Of `#RRGGBB`, sRGB; nothing for anything else.
std::optional<Colour> colour_of(std::string_view text);
// The byte of a PNG for an amount of light; below 0 as 0, above 1 as 1.
std::uint8_t srgb_byte(double light);

}  // namespace nearfield::host
