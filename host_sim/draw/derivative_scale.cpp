#include "draw/derivative_scale.hpp"

#include "draw/number_text.hpp"

namespace nearfield::host::draw {

double derivative_scale(double greatest_magnitude) {
  double scale = 1.0;
  while (scale > 1e-300) {
    for (const double factor : {1.0, 0.5, 0.2}) {
      if (greatest_magnitude * factor * scale <= 1.2) return factor * scale;
    }
    scale *= 0.1;
  }
  return scale;
}

std::string scale_text(double scale) {
  if (scale == 1.0) return "";
  if (scale >= 0.0009) return short_text(scale, 6) + " ";
  int exponent = 0;
  for (; scale < 0.9999; scale *= 10.0) --exponent;
  return short_text(scale, 0) + "·10" + superscript(exponent) + " ";
}

std::string superscript(int number) {
  static const char* const digits[] = {"⁰", "¹", "²", "³", "⁴", "⁵", "⁶", "⁷", "⁸", "⁹"};
  std::string text = number < 0 ? "⁻" : "";
  for (const char c : std::to_string(number < 0 ? -number : number)) text += digits[c - '0'];
  return text;
}

}  // namespace nearfield::host::draw
