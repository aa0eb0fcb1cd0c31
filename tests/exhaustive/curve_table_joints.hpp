#pragma once
/// Checks of a baked table that need no reference: joints, mirroring, values outside the range, and what its
/// coefficients say.

#include <curves/baked_curve.hpp>

#include <gtest/gtest.h>

#include <cmath>
#include <cstdint>
#include <type_traits>
#include <vector>

namespace nearfield::curve_tests {

using host::with_view;

template <class S>
const char* scalar_name() {
  if constexpr (std::is_same_v<S, float>)
    return "float";
  else
    return S::fraction_bits == 27 ? "Fixed<27>" : "Fixed<16>";
}

/// Kernel values as numbers: Q30 for Fixed.
inline double raw_value(int32_t value) { return static_cast<double>(value) / 1073741824.0; }
inline double raw_value(float value) { return static_cast<double>(value); }

/// A unit in the last place of values: what the kernel's rounding may move one by.
template <class S>
double value_unit(int bits) {
  if constexpr (ScalarTraits<S>::is_fixed)
    return bits == 32 ? std::ldexp(1.0, -30) : std::ldexp(1.0, -14);
  else
    return std::ldexp(1.0, -22);
}
/// The same of slopes per unit of the table's argument, for the results of sample_raw().
template <class S>
double slope_unit(int bits, int headroom) {
  if constexpr (ScalarTraits<S>::is_fixed)
    return std::ldexp(1.0, headroom - (bits == 32 ? 30 : 14));
  else
    return std::ldexp(1.0, headroom - 21);
}

/// A result of sample_raw() in units of 1.
template <class S>
struct RawNumbers {
  double value = 0.0;
  double slope = 0.0;
};
template <bool rising, class S, int degree, int bits>
RawNumbers<S> sample_numbers(const TableView<S, degree, bits>& view,
                             typename TableArgument<S>::type argument) {
  const auto raw = sample_raw<true, rising>(view, argument);
  if constexpr (ScalarTraits<S>::is_fixed) {
    return {raw_value(raw.value), std::ldexp(static_cast<double>(raw.slope), view.slope_headroom - 30)};
  } else {
    return {raw_value(raw.value), static_cast<double>(raw.slope)};
  }
}

/// c1, c2, c3 of a segment, per unit of the table's argument.
struct SlopeCoefficients {
  double c[4] = {};
  double slope(double s) const { return c[1] + s * (2 * c[2] + s * 3 * c[3]); }
  /// Greatest and least slope on the segment, by `sign`: +1 the greatest, -1 the least.
  double extreme(double sign) const {
    double greatest = std::fmax(sign * slope(-0.5), sign * slope(0.5));
    if (c[3] != 0) {
      const double turn = -c[2] / (3 * c[3]);
      if (turn > -0.5 && turn < 0.5) greatest = std::fmax(greatest, sign * slope(turn));
    }
    return sign * greatest;
  }
  double steepest() const { return std::fmax(std::fabs(extreme(1)), std::fabs(extreme(-1))); }
  /// Greatest change of the slope by s.
  double bend() const { return 2 * std::fabs(c[2]) + 3 * std::fabs(c[3]); }
};
template <class S, int degree, int bits>
SlopeCoefficients slope_coefficients(const TableView<S, degree, bits>& view, int segment) {
  SlopeCoefficients result;
  for (int j = 1; j <= degree; ++j) {
    const auto word = view.coefficients[(degree + 1) * segment + j];
    if constexpr (ScalarTraits<S>::is_fixed) {
      result.c[j] = static_cast<int32_t>(word) * slope_unit<S>(bits, view.slope_headroom);
    } else {
      result.c[j] = static_cast<double>(bits_as<float>(word));
    }
  }
  return result;
}

/// Exactly `before` up to the start of the range and `after` from its end on, with slope 0.
template <class S>
void expect_outside(const CurveFacts& facts, const host::BakedCurve<S>& baked) {
  const S from = baked.layout.placement.from, to = baked.layout.placement.to;
  const S one = ScalarTraits<S>::one();
  const auto next = [](S x, int way) {
    if constexpr (ScalarTraits<S>::is_fixed)
      return S::from_raw(x.raw() + way);
    else
      return std::nextafter(x, way < 0 ? -8.0f : 8.0f);
  };
  for (const S x : {from, next(from, -1), from - one, ScalarTraits<S>::least()}) {
    EXPECT_EQ(baked.sample(x).value, facts.before);
    EXPECT_EQ(baked.sample(x).slope, 0.0);
  }
  for (const S x : {to, next(to, 1), to + one, ScalarTraits<S>::greatest()}) {
    EXPECT_EQ(baked.sample(x).value, facts.after);
    EXPECT_EQ(baked.sample(x).slope, 0.0);
  }
}

/// Antisymmetric curves are so to the bit, unless they are tabulated over the square.
template <class S>
void expect_mirrored(const CurveFacts& facts, const host::BakedCurve<S>& baked) {
  EXPECT_EQ(baked.layout.placement.mirrored, facts.antisymmetric && !baked.layout.shape.over_square);
  if (!baked.layout.placement.mirrored) return;
  const double half = 0.5 * (facts.to - facts.from), sum = facts.before + facts.after;
  int unlike = 0;
  constexpr int count = 131072;
  for (int i = 1; i <= count + 100; ++i) {
    double distance = half * i / count;
    // Sums of floats are exact to 24 bits; Fixed has all its bits tried.
    if (ScalarTraits<S>::is_fixed) distance += std::ldexp(i % 1021, -27);
    const S offset = S(static_cast<S>(distance)), middle = S(static_cast<S>(facts.middle()));
    const auto below = baked.sample(middle - offset), above = baked.sample(middle + offset);
    // At the middle itself the two are one place.
    if (offset == S{}) continue;
    // The mirrored value of float is rounded once.
    const double rounding = ScalarTraits<S>::is_fixed ? 0.0 : std::ldexp(1.0, -24);
    if (!(std::fabs(below.value + above.value - sum) <= rounding) || below.slope != above.slope) ++unlike;
  }
  EXPECT_EQ(unlike, 0) << "places where the curve is not symmetric to the bit";
}

/// What the joints of a table were seen to do.
struct Joints {
  double value_jump =
      0.0;  ///< greatest, beyond the climb over the one argument between, in units in the last place
  double slope_jump = 0.0;
  int value_knot = 0, slope_knot = 0;  ///< where
  int slopes_beyond_one_unit = 0;      ///< at how many knots
};

/// Value and slope across every knot: at the last argument below it and at the knot itself. Slopes are left
/// out at knots on one of the curve's own kinks.
template <class S>
Joints joints_of(const CurveFacts& facts, const std::vector<double>& kinks,
                 const host::BakedCurve<S>& baked) {
  return with_view(baked, [&](const auto& view, auto rising) {
    const TableShape& shape = baked.layout.shape;
    const int k = view.index_bits;
    Joints joints;
    for (int knot = 1; knot < shape.segments; ++knot) {
      typename TableArgument<S>::type below{}, at{};
      double apart = 0.0;  // of the two arguments, as the kernel sees them
      if constexpr (ScalarTraits<S>::is_fixed) {
        at = static_cast<uint32_t>(knot) << (31 - k);
        below = at - 1;
        apart = shape.bits == 32 ? std::ldexp(1.0, -31) : std::ldexp(1.0, -16 - k);
      } else {
        at = std::ldexp(static_cast<float>(knot), -k);
        below = std::nextafter(at, 0.0f);
        apart = static_cast<double>(at) - static_cast<double>(below);
      }
      const auto left = sample_numbers<rising.value>(view, below),
                 right = sample_numbers<rising.value>(view, at);
      const SlopeCoefficients one = slope_coefficients(view, knot - 1),
                              other = slope_coefficients(view, knot);
      const double climb = std::fmax(one.steepest(), other.steepest()) * apart;
      const double bend = std::fmax(one.bend(), other.bend()) * std::ldexp(apart, k);
      const double value_jump = (std::fabs(right.value - left.value) - climb) / value_unit<S>(shape.bits);
      const double slope_jump =
          (std::fabs(right.slope - left.slope) - bend) / slope_unit<S>(shape.bits, view.slope_headroom);
      if (value_jump > joints.value_jump) {
        joints.value_jump = value_jump;
        joints.value_knot = knot;
      }
      bool kink = false;
      for (const double x : kinks) {
        const double fraction = (x - facts.from) / (facts.to - facts.from);
        const double place = detail::tabulated_break(facts, fraction, shape.over_square) * shape.segments;
        kink = kink || std::fabs(place - knot) < 1e-9;
      }
      if (kink) continue;
      if (slope_jump > joints.slope_jump) {
        joints.slope_jump = slope_jump;
        joints.slope_knot = knot;
      }
      if (slope_jump > 1.0) ++joints.slopes_beyond_one_unit;
    }
    return joints;
  });
}

/// The stated ranges of value and slope hold wherever the kernel is asked. Slopes of 128 and more are the
/// greatest that facts can state, and stand for all beyond.
template <class S>
void expect_ranges(const host::BakedCurve<S>& baked) {
  with_view(baked, [&](const auto& view, auto rising) {
    const TableFacts& facts = baked.table_facts;
    const int places = baked.layout.shape.segments * 64;
    int outside = 0;
    for (int i = 0; i < places; ++i) {
      typename TableArgument<S>::type argument{};
      if constexpr (ScalarTraits<S>::is_fixed)
        argument = static_cast<uint32_t>(i) << (31 - view.index_bits - 6);
      else
        argument = std::ldexp(static_cast<float>(i), -view.index_bits - 6);
      const auto here = sample_numbers<rising.value>(view, argument);
      const double value = std::ldexp(here.value, 30), slope = std::ldexp(here.slope, 24);
      if (!(value >= facts.least_value && value <= facts.greatest_value)) ++outside;
      const bool above_least = slope >= facts.least_slope || facts.least_slope == -greatest_of<int32_t>;
      const bool below_greatest =
          slope <= facts.greatest_slope || facts.greatest_slope == greatest_of<int32_t>;
      if (!(above_least && below_greatest)) ++outside;
    }
    EXPECT_EQ(outside, 0) << "places where value or slope leave their stated ranges";
    return 0;
  });
}

/// How far the polynomials as stored go against the curve's direction, in units in the last place of a slope.
template <class S>
double slope_against(const CurveFacts& facts, const host::BakedCurve<S>& baked) {
  return with_view(baked, [&](const auto& view, auto) {
    const double sign = static_cast<double>(facts.direction);
    double least = 0.0;
    for (int i = 0; i < baked.layout.shape.segments; ++i) {
      least = std::fmin(least, sign * slope_coefficients(view, i).extreme(-sign));
    }
    return -least / slope_unit<S>(baked.layout.shape.bits, view.slope_headroom);
  });
}

}  // namespace nearfield::curve_tests
