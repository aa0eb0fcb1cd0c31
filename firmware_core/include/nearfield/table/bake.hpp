// Makes tables in the compiler (constexpr) or in the host tool. Never linked into a target: all of it is `double`.
#pragma once

#include <nearfield/table/fit.hpp>

namespace nearfield {

namespace detail {

// Rounds half away from zero; the caller checks the range.
constexpr int64_t round_to_integer(double x) {
  return x < 0 ? -static_cast<int64_t>(0.5 - x) : static_cast<int64_t>(x + 0.5);
}
constexpr int32_t round_up(double x, double scale) {
  const double scaled = x * scale;
  return scaled < 2147483646.0 ? static_cast<int32_t>(scaled) + 1 : greatest_of<int32_t>;
}

// The scales of a table's coefficients.
struct CoefficientScale {
  int index_bits = 0;
  int slope_headroom = 0;
  double per_unit = 1.0;  // slopes per unit argument of the table from slopes per unit of [0, 1]

  constexpr double value_unit(int bits) const { return bits == 32 ? 1073741824.0 : 16384.0; }
  constexpr double slope_unit(int bits) const { return value_unit(bits) / (1 << slope_headroom); }
};

// 0, 1, -1, 2, -2.
constexpr int32_t nudge(int choice) { return choice % 2 == 0 ? -(choice / 2) : choice / 2 + 1; }

// One of the kernel's results at the last argument before a knot, in its own units, and its climb from there to the knot.
struct Approach {
  double at = 0.0;
  double climb = 0.0;
};
struct KnotAim {
  bool known = false;
  Approach value, slope;
};
// A whole number of units at a knot: the nearest to the exact one that lies no more than a unit beyond the result before
// the knot and its climb. More than three units apart they are at a kink.
constexpr int64_t meeting_place(double exact, bool known, const Approach& before) {
  int64_t met = round_to_integer(exact);
  if (!known || magnitude(before.at + before.climb - exact) > 3.0) return met;
  const double highest = before.at + greatest_of_two(before.climb, 0.0) + 1.0;
  const double lowest = before.at + least_of_two(before.climb, 0.0) - 1.0;
  while (static_cast<double>(met) > highest) --met;
  while (static_cast<double>(met) < lowest) ++met;
  return met;
}

template <int degree, int bits> struct RoundedSegment {
  FixedSegment<degree, bits> segment;
  KnotAim next;
};

// Coefficients rounded so that the kernel goes on at the left end within a unit of where the segment before ends,
// and leads at the right end within a unit to what is exact there. Tried are roundings by up to two units up or down.
template <int degree, int bits, bool rising>
constexpr RoundedSegment<degree, bits> rounded_segment(const SegmentEnds& ends, const Polynomial& polynomial,
                                                       const CoefficientScale& scale, const KnotAim& aim) {
  const double value_unit = scale.value_unit(bits), slope_unit = scale.slope_unit(bits) * scale.per_unit;
  const int64_t fine = bits == 32 ? 1 : 65536;  // the kernel's results have 30 bits in both formats
  const double fine_unit = static_cast<double>(fine);
  FixedSegment<degree, bits> exact;
  for (int j = 1; j <= degree; ++j) exact.c[j] = static_cast<int32_t>(round_to_integer(polynomial.c[j] * slope_unit));
  const int64_t left_value = meeting_place(ends.value[0] * value_unit * fine_unit, aim.known && bits == 32, aim.value);
  const int64_t left_slope = meeting_place(ends.slope[0] * slope_unit, aim.known, {aim.slope.at / fine_unit, aim.slope.climb / fine_unit}) * fine;
  // One argument before the knot.
  const double before = scale.per_unit / 2147483648.0;
  const double value_climb = ends.slope[1] * before * value_unit * fine_unit;
  const double slope_climb = polynomial.bend(0.5) * before * slope_unit * fine_unit;
  const double right_value = ends.value[1] * value_unit * fine_unit - value_climb;
  const double right_slope = ends.slope[1] * slope_unit * fine_unit - slope_climb;
  const int down = scale.index_bits - scale.slope_headroom;
  const int32_t first = bits == 32 ? least_of<int32_t> : -32768;
  const int32_t last = bits == 32 ? static_cast<int32_t>(0x80000000u - (2u << scale.index_bits)) : 32767;
  RoundedSegment<degree, bits> best;
  double least_jump = 1e30;
  constexpr int choices = degree == 1 ? 3 : degree == 2 ? 25 : 75;
  for (int choice = 0; choice < choices && least_jump > 1.0; ++choice) {
    FixedSegment<degree, bits> segment = exact;
    segment.c[1] += nudge(choice % 5);
    if (degree > 1) segment.c[2] += nudge(choice / 5 % 5);
    if (degree > 2) segment.c[3] += nudge(choice / 25);
    const RawSample<int32_t> unplaced = segment.template at<true, rising>(first, down);
    segment.c[0] = static_cast<int32_t>((left_value - unplaced.value + fine / 2) >> (bits == 32 ? 0 : 16));
    const RawSample<int32_t> right = segment.template at<true, rising>(last, down);
    // Nudges move the value only where its shift is small.
    double jump = degree > 1 && down > 1 ? 0.0 : magnitude(right.value - right_value) / fine_unit;
    if (degree > 1) {
      jump = greatest_of_two(jump, 2.0 * static_cast<double>(magnitude_of(unplaced.slope - left_slope)) / fine_unit);
      jump = greatest_of_two(jump, magnitude(right.slope - right_slope) / fine_unit);
    }
    if (jump < least_jump) {
      least_jump = jump;
      best = {segment, {true, {static_cast<double>(right.value), value_climb}, {static_cast<double>(right.slope), slope_climb}}};
    }
  }
  return best;
}

// One segment as stored, its true coefficients, and how far these are from the function.
template <class S, int degree, int bits> struct BakedSegment {
  typename StoredCoefficient<bits>::type words[size_t{degree} + 1] = {};
  Deviation deviation;
  KnotAim next;
};

template <class S, int degree, int bits, bool rising, class Function>
constexpr BakedSegment<S, degree, bits> bake_segment(const Function& f, const TableShape& shape, int segment,
                                                     const SegmentEnds& ends, const CoefficientScale& scale,
                                                     const KnotAim& aim) {
  BakedSegment<S, degree, bits> result;
  Polynomial polynomial = polynomial_of(ends, degree, 1.0 / shape.segments);
  if constexpr (ScalarTraits<S>::is_fixed) {
    const auto rounded = rounded_segment<degree, bits, rising>(ends, polynomial, scale, aim);
    const FixedSegment<degree, bits>& stored = rounded.segment;
    result.next = rounded.next;
    for (int j = 0; j <= degree; ++j) {
      result.words[j] = static_cast<typename StoredCoefficient<bits>::type>(stored.c[j]);
      polynomial.c[j] = stored.c[j] / (j == 0 ? scale.value_unit(bits) : scale.slope_unit(bits) * scale.per_unit);
    }
  } else {
    for (int j = 0; j <= degree; ++j) {
      const float stored = static_cast<float>(j == 0 ? polynomial.c[0] : polynomial.c[j] * scale.per_unit);
      result.words[j] = bits_as<uint32_t>(stored);
      polynomial.c[j] = static_cast<double>(stored) / (j == 0 ? 1.0 : scale.per_unit);
    }
  }
  result.deviation = deviation_of(polynomial, f, segment, shape.segments, compared_steps(shape.segments));
  return result;
}

// The least headroom up to `greatest` that the slopes need; one more than that when none suffices.
constexpr int headroom_for(double steepest, int greatest, int bits) {
  const double most = bits == 32 ? 1.99 : 1.98;
  int headroom = 0;
  while (headroom <= greatest && steepest >= most * (1 << headroom)) ++headroom;
  return headroom;
}

// Rounding of the kernel itself, in the value and, per unit argument, in the slope.
template <class S> constexpr Deviation kernel_rounding(int bits, const CoefficientScale& scale) {
  if (!ScalarTraits<S>::is_fixed) return {1.0 / 4194304.0, (1 << scale.slope_headroom) / 1048576.0};
  if (bits == 32) return {2.0 / scale.value_unit(32), 3.0 / scale.slope_unit(32)};
  return {1.25 / scale.slope_unit(16) / (1 << scale.index_bits), 5.0 / scale.slope_unit(16)};
}

// The facts of a table whose coefficients and headroom are in place; `usable`: they could be stored at all.
template <class S, int degree, int bits>
constexpr TableFacts facts_with_errors(const TableView<S, degree, bits>& table, int segments, const Deviation& deviation,
                                       bool usable, const CoefficientScale& scale) {
  TableFacts facts = ranges_of(table, segments);
  facts.error = facts.slope_error = greatest_of<int32_t>;
  if (usable && coefficients_in_range(table, segments)) {
    const Deviation kernel = kernel_rounding<S>(bits, scale);
    facts.error = round_up(deviation.value + kernel.value, 1073741824.0);
    facts.slope_error = round_up(deviation.slope * scale.per_unit + kernel.slope, 16777216.0);
  }
  return facts;
}

}  // namespace detail

// The range of a function's argument in units of its own parameter; functions that differ overload this.
template <class Function> constexpr double argument_range(const Function&) { return 1.0; }

namespace detail {

// What a table's format must hold. What is not a number stays.
struct PolynomialBounds {
  double steepest = 0.0;  // of slope and second derivative per unit of [0, 1]
  double sharpest = 0.0;
  double tallest = 0.0;

  constexpr void include(double steep, double sharp, double tall) {
    raise(steepest, steep);
    raise(sharpest, sharp);
    raise(tallest, tall);
  }
  constexpr void include(const PolynomialBounds& other) { include(other.steepest, other.sharpest, other.tallest); }

 private:
  static constexpr void raise(double& bound, double x) {
    if (bound == bound && !(x <= bound)) bound = x;
  }
};

// The ends of `count` segments from `first` on, and the bounds of their polynomials.
template <int count> struct SurveyedSegments {
  SegmentEnds ends[static_cast<size_t>(count)] = {};
  PolynomialBounds bounds;
};
template <int count, class Function>
constexpr SurveyedSegments<count> survey(const Function& f, const TableShape& shape, int first, bool monotone) {
  SurveyedSegments<count> result;
  for (int i = 0; i < count && first + i < shape.segments; ++i) {
    result.ends[i] = segment_ends(f, shape, first + i, monotone);
    const Polynomial polynomial = polynomial_of(result.ends[i], shape.degree, 1.0 / shape.segments);
    result.bounds.include(polynomial.steepest(), polynomial.sharpest(), magnitude(polynomial.c[0]));
  }
  return result;
}

// Scale of a table with these bounds; usable only if headroom up to `greatest_headroom` suffices.
struct ScaleChoice {
  CoefficientScale scale;
  bool usable = false;
};
constexpr ScaleChoice choose_scale(const TableShape& shape, const PolynomialBounds& bounds, int greatest_headroom) {
  ScaleChoice choice;
  const int k = index_bits_for(shape.segments);
  choice.scale.index_bits = k;
  choice.scale.per_unit = static_cast<double>(1 << k) / shape.segments;
  const int headroom = headroom_for(bounds.steepest * choice.scale.per_unit, greatest_headroom, shape.bits);
  choice.usable = headroom <= greatest_headroom && bounds.tallest < 1.99;
  choice.scale.slope_headroom = choice.usable ? headroom : greatest_headroom;
  return choice;
}

}  // namespace detail

// Bakes `function`, callable as Differentiable(Differentiable) with arguments in [0, 1], into a uniform table:
// cubic Hermite segments (degree 3), pairs of parabolas (degree 2) or chords (degree 1) through its exact values and,
// but for chords, slopes at the knots; value and slope (chords: the value) are continuous to a unit in the last place.
// The errors stated are bounds from the exact function and its derivatives at nine or more places a segment;
// tests/exhaustive checks them at every argument of a 24-bit grid against long double.
// Fails (facts.error is the greatest integer, which no certificate accepts) when a value leaves [-2, 2) or a slope
// +-2 * 2^index_bits.
template <class S, int segments = 32, int degree = 3, int bits = 32, class Function>
constexpr Table<S, segments, degree, bits> bake(const Function& function, bool monotone = false) {
  static_assert(segments >= 1 && segments <= 1024 && (degree != 2 || segments % 2 == 0),
                "1 to 1024 segments; parabolas in pairs");
  const TableShape shape{degree, segments, bits, false};
  Table<S, segments, degree, bits> table;
  table.range = S(static_cast<S>(argument_range(function)));
  const auto surveyed = detail::survey<segments>(function, shape, 0, monotone);
  const detail::ScaleChoice choice = detail::choose_scale(shape, surveyed.bounds, table.index_bits);
  table.slope_headroom = choice.scale.slope_headroom;
  detail::Deviation worst;
  detail::KnotAim aim;
  for (int i = 0; choice.usable && i < segments; ++i) {
    const auto baked = detail::bake_segment<S, degree, bits, false>(function, shape, i, surveyed.ends[i], choice.scale, aim);
    aim = baked.next;
    for (int j = 0; j <= degree; ++j) table.coefficients[(degree + 1) * i + j] = baked.words[j];
    worst.include(baked.deviation.value, baked.deviation.slope);
  }
  table.facts = detail::facts_with_errors(table.view(), segments, worst, choice.usable, choice.scale);
  return table;
}

}  // namespace nearfield
