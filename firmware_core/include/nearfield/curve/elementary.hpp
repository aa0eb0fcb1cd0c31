// Elementary functions in `double` for baking, as a constant expression. Never linked into a target.
#pragma once

namespace nearfield {

inline constexpr double kPi = 3.14159265358979323846;

// Sine and cosine for |x| <= 2 pi, by Taylor series: error below 4e-16 for |x| <= pi / 2.
constexpr double exact_sin(double x) {
  double term = x, sum = x;
  for (int n = 1; n < 16; ++n) {
    term *= -x * x / ((2 * n) * (2 * n + 1));
    sum += term;
  }
  return sum;
}
constexpr double exact_cos(double x) {
  double term = 1.0, sum = 1.0;
  for (int n = 1; n < 16; ++n) {
    term *= -x * x / ((2 * n - 1) * (2 * n));
    sum += term;
  }
  return sum;
}

}  // namespace nearfield
