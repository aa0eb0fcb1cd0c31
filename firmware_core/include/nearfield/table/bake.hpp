// Makes tables in the compiler (constexpr) or in the host tool. Never linked into a target: all of it is `double`.
#pragma once

#include <nearfield/table/table.hpp>

namespace nearfield {

// An exact function's value and first derivative.
struct ExactSample {
  double value = 0.0;
  double slope = 0.0;
};

namespace detail {

constexpr double magnitude(double x) { return x < 0 ? -x : x; }

// Rounds half away from zero; the caller checks the range.
constexpr int64_t round_to_integer(double x) {
  return x < 0 ? -static_cast<int64_t>(0.5 - x) : static_cast<int64_t>(x + 0.5);
}
constexpr int32_t round_up(double x, double scale) {
  const double scaled = x * scale;
  return scaled < 2147483646.0 ? static_cast<int32_t>(scaled) + 1 : greatest_of<int32_t>;
}

// The cubic c0 + s (c1 + s (c2 + s c3)) h on s in [-1/2, 1/2], h the segment's width.
struct Cubic {
  double c[4] = {};
  double h = 1.0;
  constexpr double value(double s) const { return c[0] + s * (c[1] + s * (c[2] + s * c[3])) * h; }
};

}  // namespace detail

// The range of a function's argument in units of its own parameter; functions that differ overload this.
template <class Function> constexpr double argument_range(const Function&) { return 1.0; }

// Bakes `function`, callable as ExactSample(double argument) for argument in [0, 1], into a table of 2^Log2Segments
// cubic Hermite segments: value and slope are continuous across knots up to rounding, and exact there.
// The stated error is the greatest difference found at 8 places a segment, plus a quarter, plus the kernel's rounding;
// tests/exhaustive/table_test.cpp checks each shipped table at every argument of a 24-bit grid against long double.
// Fails (in a constant expression: does not compile; otherwise facts.error is the greatest integer, which no
// certificate accepts) when a value leaves [-2, 2) or a slope leaves [-16, 16).
template <class S, int Log2Segments = 5, class Function>
constexpr Table<S, Log2Segments> bake(const Function& function) {
  static_assert(Log2Segments >= 3 && Log2Segments <= 6, "8 to 64 segments: 128 bytes to 1 KiB");
  constexpr int segments = 1 << Log2Segments;
  constexpr double h = 1.0 / segments;
  Table<S, Log2Segments> table;

  double steepest = 0.0;
  ExactSample knots[static_cast<size_t>(segments) + 1] = {};
  for (int i = 0; i <= segments; ++i) knots[i] = function(i * h);
  detail::Cubic cubics[static_cast<size_t>(segments)] = {};
  for (int i = 0; i < segments; ++i) {
    const ExactSample a = knots[i], b = knots[i + 1];
    const double chord = (b.value - a.value) / h;
    detail::Cubic& cubic = cubics[i];
    cubic.h = h;
    cubic.c[0] = 0.5 * (a.value + b.value) - h * (b.slope - a.slope) / 8;
    cubic.c[1] = 1.5 * chord - 0.25 * (a.slope + b.slope);
    cubic.c[2] = 0.5 * (b.slope - a.slope);
    cubic.c[3] = a.slope + b.slope - 2 * chord;
    // Bounds the slope and every intermediate result of the kernel.
    const double bound = detail::magnitude(cubic.c[1]) + detail::magnitude(cubic.c[2]) + detail::magnitude(cubic.c[3]);
    if (bound > steepest) steepest = bound;
  }
  int headroom = 0;
  while (headroom < 3 && steepest >= 1.99 * (1 << headroom)) ++headroom;
  table.slope_headroom = headroom;
  table.range = S(static_cast<S>(argument_range(function)));
  bool fits = steepest < 1.99 * (1 << headroom);

  const double value_scale = 1073741824.0;
  const double slope_scale = 1073741824.0 / (1 << headroom);
  double error = 0.0;
  for (int i = 0; i < segments; ++i) {
    detail::Cubic& cubic = cubics[i];
    fits = fits && detail::magnitude(cubic.c[0]) < 1.99;
    if (!fits) break;
    for (int j = 0; j < 4; ++j) {
      const double scale = j == 0 ? value_scale : slope_scale;
      const int64_t stored = detail::round_to_integer(cubic.c[j] * scale);
      cubic.c[j] = static_cast<double>(stored) / scale;
      if constexpr (ScalarTraits<S>::is_fixed) table.coefficients[4 * i + j] = static_cast<uint32_t>(static_cast<int32_t>(stored));
      else table.coefficients[4 * i + j] = bits_as<uint32_t>(static_cast<float>(cubic.c[j]));
    }
    for (int place = 0; place < 8; ++place) {
      const double s = (place + 0.5) / 8 - 0.5;
      const double difference = detail::magnitude(cubic.value(s) - function((i + 0.5 + s) * h).value);
      if (difference > error) error = difference;
    }
  }
  fits = fits && coefficients_in_range(table.view());
  table.facts = ranges_of(table.view());
  const double kernel = ScalarTraits<S>::is_fixed ? 3.0 / value_scale : 1.0 / 2097152.0;
  table.facts.error = fits ? detail::round_up(1.25 * error + kernel, value_scale) : greatest_of<int32_t>;
  return table;
}

}  // namespace nearfield
