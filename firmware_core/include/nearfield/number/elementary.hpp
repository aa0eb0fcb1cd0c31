// Elementary functions in `double` as constant expressions, for baking: never linked into a target. Each is within
// 2 units in the last place of the exact value, from basic IEEE operations alone, so that compilers and machines agree
// to the bit. Straight-line code, because compilers count the steps of constant expressions.
#pragma once

#include <nearfield/number/integer.hpp>

namespace nearfield {

inline constexpr double kPi = 3.14159265358979323846;

constexpr double magnitude(double x) { return x < 0 ? -x : x; }

namespace detail {

// 2^exponent, exponent in -1022 ... 1023.
constexpr double power_of_two(int exponent) {
  return bits_as<double>(static_cast<uint64_t>(static_cast<int64_t>(exponent) + 1023) << 52);
}
// Nearest integer, |x| < 2^31; halves away from zero.
constexpr int32_t nearest_integer(double x) { return static_cast<int32_t>(x < 0 ? x - 0.5 : x + 0.5); }

// Sine and cosine of r + tail, r in [-pi / 4, pi / 4] and the tail below its last place, by Taylor's series.
constexpr double sine_of_reduced(double r, double tail) {
  const double z = r * r;
  const double high = 1.0 / 6227020800.0 + z * (-1.0 / 1307674368000.0 + z * (1.0 / 355687428096000.0));
  const double low = -1.0 / 6.0 + z * (1.0 / 120.0 + z * (-1.0 / 5040.0 + z * (1.0 / 362880.0 + z * (-1.0 / 39916800.0 + z * high))));
  return r + (r * z * low + tail * (1.0 - 0.5 * z));
}
constexpr double cosine_of_reduced(double r, double tail) {
  const double z = r * r;
  const double high = 1.0 / 479001600.0 + z * (-1.0 / 87178291200.0 + z * (1.0 / 20922789888000.0 + z * (-1.0 / 6402373705728000.0)));
  const double low = 1.0 / 24.0 + z * (-1.0 / 720.0 + z * (1.0 / 40320.0 + z * (-1.0 / 3628800.0 + z * high)));
  const double half = 0.5 * z, rough = 1.0 - half;
  return rough + (((1.0 - rough) - half) + (z * z * low - r * tail));
}

// x less its nearest multiple of pi / 2, and which quarter turn that is.
struct QuarterTurn {
  double rest = 0.0;
  double tail = 0.0;
  uint32_t quarter = 0;
};
constexpr QuarterTurn reduce_angle(double x) {
  const int32_t n = nearest_integer(x * (2.0 / kPi));
  // pi / 2 in three parts; products of n with the first two are exact.
  const double first = x - n * 1.5707963267341256, second = n * 6.077100506303966e-11, third = n * 2.0222662487959506e-21;
  const double rough = first - second, lost = (first - rough) - second;
  const double rest = rough + (lost - third);
  return {rest, (rough - rest) + (lost - third), static_cast<uint32_t>(n) & 3u};
}

}  // namespace detail

// For |x| <= 2^20 radians.
constexpr double exact_sin(double x) {
  const detail::QuarterTurn turn = detail::reduce_angle(x);
  const double s = (turn.quarter & 1u) != 0 ? detail::cosine_of_reduced(turn.rest, turn.tail) : detail::sine_of_reduced(turn.rest, turn.tail);
  return (turn.quarter & 2u) != 0 ? -s : s;
}
constexpr double exact_cos(double x) {
  const detail::QuarterTurn turn = detail::reduce_angle(x);
  const double s = (turn.quarter & 1u) != 0 ? detail::sine_of_reduced(turn.rest, turn.tail) : detail::cosine_of_reduced(turn.rest, turn.tail);
  return turn.quarter == 1u || turn.quarter == 2u ? -s : s;
}

// For x >= 0 in the normal range; 0 for 0 and for negative x.
constexpr double exact_sqrt(double x) {
  if (!(x >= 2.2250738585072014e-308)) return 0.0;
  const uint64_t bits = bits_as<uint64_t>(x);
  const int half_exponent = (static_cast<int>(bits >> 52) - 1023) >> 1;
  const double scale = detail::power_of_two(half_exponent);
  const double m = x / scale / scale;  // in [1, 4)
  // Within 6 % on [1, 4); Newton's steps square the relative error and halve it.
  double root = 0.72 + 0.33 * m;
  root = 0.5 * (root + m / root);
  root = 0.5 * (root + m / root);
  root = 0.5 * (root + m / root);
  root = 0.5 * (root + m / root);
  return root * scale;
}

// e^x for x <= 709; 0 below -708, and the value at 709 above.
constexpr double exact_exp(double x) {
  if (x < -708.0) return 0.0;
  const double in_range = x < 709.0 ? x : 709.0;
  const int32_t n = detail::nearest_integer(in_range * 1.4426950408889634);
  const double high = in_range - n * 0.6931471803691238;
  const double low = n * 1.9082149292705877e-10;
  const double r = high - low;
  const double tail = (high - r) - low;
  const double far = 1.0 / 362880.0 + r * (1.0 / 3628800.0 + r * (1.0 / 39916800.0 + r * (1.0 / 479001600.0 + r * (1.0 / 6227020800.0))));
  const double series = 0.5 + r * (1.0 / 6.0 + r * (1.0 / 24.0 + r * (1.0 / 120.0 + r * (1.0 / 720.0 + r * (1.0 / 5040.0 + r * (1.0 / 40320.0 + r * far))))));
  return (1.0 + (r + (tail + r * r * series))) * detail::power_of_two(n);
}

// Natural logarithm of x > 0 in the normal range; the value at the least normal number below it.
constexpr double exact_log(double x) {
  const double least = 2.2250738585072014e-308;
  const uint64_t bits = bits_as<uint64_t>(x >= least ? x : least);
  int exponent = static_cast<int>(bits >> 52) - 1023;
  double m = bits_as<double>((bits & 0x000fffffffffffffu) | 0x3ff0000000000000u);
  if (m > 1.4142135623730951) {
    m *= 0.5;
    ++exponent;
  }
  const double f = m - 1.0, s = f / (2.0 + f), z = s * s;
  const double far = 2.0 / 15.0 + z * (2.0 / 17.0 + z * (2.0 / 19.0 + z * (2.0 / 21.0)));
  const double series = z * (2.0 / 3.0 + z * (2.0 / 5.0 + z * (2.0 / 7.0 + z * (2.0 / 9.0 + z * (2.0 / 11.0 + z * (2.0 / 13.0 + z * far))))));
  const double half_square = 0.5 * f * f;
  return exponent * 0.6931471803691238 - ((half_square - (s * (half_square + series) + exponent * 1.9082149292705877e-10)) - f);
}

// Arctangent, radians, any x.
constexpr double exact_atan(double x) {
  const double a = magnitude(x);
  // Angles whose tangents have few digits, in two parts each; the rest is at most a sixteenth of a quarter turn.
  double tangent = 0.0, angle = 0.0, angle_rest = 0.0;
  if (a > 10.1) { tangent = -1.0; angle = 1.5707963267948966; angle_rest = 6.123233995736766e-17; }
  else if (a > 3.37) { tangent = 5.0; angle = 1.373400766945016; angle_rest = -3.3077103557695165e-17; }
  else if (a > 1.91) { tangent = 2.5; angle = 1.1902899496825317; angle_rest = 7.683333629842069e-17; }
  else if (a > 1.22) { tangent = 1.5; angle = 0.982793723247329; angle_rest = 1.3903311031230998e-17; }
  else if (a > 0.867) { tangent = 1.0; angle = 0.7853981633974483; angle_rest = 3.061616997868383e-17; }
  else if (a > 0.619) { tangent = 0.75; angle = 0.6435011087932844; angle_rest = 1.5834785051444286e-17; }
  else if (a > 0.369) { tangent = 0.5; angle = 0.4636476090008061; angle_rest = 2.2698777452961687e-17; }
  else if (a > 0.19) { tangent = 0.25; angle = 0.24497866312686414; angle_rest = 1.0698755618734451e-17; }
  const double y = tangent < 0.0 ? -1.0 / a : (a - tangent) / (1.0 + a * tangent);
  const double z = y * y;
  const double far = 1.0 / 13.0 + z * (-1.0 / 15.0 + z * (1.0 / 17.0 + z * (-1.0 / 19.0 + z * (1.0 / 21.0 + z * (-1.0 / 23.0)))));
  const double series = z * (-1.0 / 3.0 + z * (1.0 / 5.0 + z * (-1.0 / 7.0 + z * (1.0 / 9.0 + z * (-1.0 / 11.0 + z * far)))));
  const double result = angle + (y + (y * series + angle_rest));
  return x < 0 ? -result : result;
}

}  // namespace nearfield
