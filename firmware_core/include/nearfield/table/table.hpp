// The kernel: value and slope of a function of one bounded variable, from a uniform table of polynomials.
// Everything in Nearfield that is not a polynomial goes through sample_table().
#pragma once

#include <nearfield/table/argument.hpp>

namespace nearfield {

// Facts about a baked table, rounded outwards. They hold for every argument and for the coefficients as stored.
struct TableFacts {
  int32_t error = 0;        // greatest |table - exact function|, Q30, kernel rounding included
  int32_t slope_error = 0;  // the same of the slope per unit argument, Q24, before it is rounded to a scalar
  int32_t least_value = 0;  // range of the value, Q30
  int32_t greatest_value = 0;
  int32_t least_slope = 0;  // range of the slope per unit argument, Q24 (a Rate)
  int32_t greatest_slope = 0;
};

// How one coefficient is stored. Fixed: 32 or 16 bits, two's complement; float: the bits of a float.
template <int bits> struct StoredCoefficient;
template <> struct StoredCoefficient<32> { using type = uint32_t; };
template <> struct StoredCoefficient<16> { using type = int16_t; };

// Where a table's coefficients are and how they are scaled; they may lie in an image in flash.
// Segment i covers arguments [i, i + 1) / 2^index_bits; there are at most 2^index_bits segments. With s in
// [-1/2, 1/2) the place within the segment, counted from its middle, a table of degree 3 (2, 1: fewer terms) gives
//   value = c0 + s (c1 + s (c2 + s c3)) / 2^index_bits        slope = c1 + s (2 c2 + s 3 c3)
// Fixed, 32 bits: c0 in Q30, c1 ... c3 in Q(30 - slope_headroom); 16 bits: c0 in Q14, the others in
// Q(14 - slope_headroom).
template <class S, int degree = 3, int bits = 32> struct TableView {
  static_assert(degree >= 1 && degree <= 3 && (ScalarTraits<S>::is_fixed || bits == 32), "no such table");
  using Coefficient = typename StoredCoefficient<bits>::type;
  const Coefficient* coefficients = nullptr;  // c0 ... c(degree) of segment 0, of segment 1, ...
  int index_bits = 0;
  int slope_headroom = 0;
};

// Arguments: a fraction of 2^index_bits segments in [0, 1), Q31 for Fixed.
template <class S> struct TableArgument { using type = uint32_t; };
template <> struct TableArgument<float> { using type = float; };

// What the kernel computes: the value in Q30 and the slope per unit argument in Q(30 - slope_headroom), integers
// (int32_t); two floats for float.
template <class Number> struct RawSample {
  Number value{};
  Number slope{};
};

template <class S> struct TableSample {
  Unit<S> value{};  // in [-2, 2)
  S slope{};        // per unit argument
};

namespace detail {

// One segment at s in Q32 (32-bit coefficients) or Q16 (16-bit ones).
template <int degree, int bits> struct FixedSegment {
  int32_t c[4] = {};

  static constexpr int32_t times(int32_t coefficient, int32_t s) {
    if constexpr (bits == 32) return multiply_high(coefficient, s);
    else return (coefficient * s) >> 16;
  }
  // down = index_bits - slope_headroom; `rising` says that it is negative.
  template <bool with_slope, bool rising> constexpr RawSample<int32_t> at(int32_t s, int down) const {
    int32_t inner = c[degree], outer = inner;
    if constexpr (degree == 3) inner = wrapping_add(c[2], times(c[3], s));
    if constexpr (degree > 1) outer = wrapping_add(c[1], times(inner, s));
    RawSample<int32_t> result;
    // The last product of 16-bit numbers keeps all its bits.
    const int32_t climb = bits == 32 ? multiply_high(outer, s) : outer * s;
    const int32_t base = bits == 32 ? c[0] : shift_left(c[0], 16);
    result.value = wrapping_add(base, rising ? shift_left(climb, -down) : climb >> down);
    if constexpr (with_slope) {
      int32_t slope = outer;
      if constexpr (degree == 2) slope = wrapping_add(slope, times(inner, s));
      if constexpr (degree == 3) slope = wrapping_add(slope, times(wrapping_add(inner, times(c[3], s)), s));
      result.slope = bits == 32 ? slope : shift_left(slope, 16);
    }
    return result;
  }
};

}  // namespace detail

// Value and slope. Precondition: argument < segments / 2^index_bits; the scales of argument.hpp give no other.
// Rounding: each product is truncated: value within 2 units of 2^-30 of the stored polynomial (16 bits: of 2^-15),
// slope within 3 units of 2^-(30 - slope_headroom) (16 bits: of 2^-(14 - slope_headroom)).
// Cost in line on Cortex-M4, cubic, 32 bits: 11 instructions for the value, 14 with the slope (ports/KERNEL.md).
// `rising`: slope_headroom > index_bits, which only tables of very few segments need.
template <bool with_slope, bool rising = false, class S, int degree, int bits>
constexpr auto sample_raw(const TableView<S, degree, bits>& table, typename TableArgument<S>::type argument) {
  const int k = table.index_bits;
  if constexpr (ScalarTraits<S>::is_fixed) {
    const auto* stored = table.coefficients + (degree + 1) * (argument >> (31 - k));
    detail::FixedSegment<degree, bits> segment;
    // Not a loop: compilers keep one at -O2.
    segment.c[0] = static_cast<int32_t>(stored[0]);
    segment.c[1] = static_cast<int32_t>(stored[1]);
    if constexpr (degree > 1) segment.c[2] = static_cast<int32_t>(stored[2]);
    if constexpr (degree > 2) segment.c[3] = static_cast<int32_t>(stored[3]);
    const int32_t s = static_cast<int32_t>((argument << (k + 1)) ^ 0x80000000u);  // Q32, from the middle
    return segment.template at<with_slope, rising>(bits == 32 ? s : s >> 16, k - table.slope_headroom);
  } else {
    const float place = argument * static_cast<float>(int32_t{1} << k);
    const int32_t index = static_cast<int32_t>(place);
    const uint32_t* stored = table.coefficients + (degree + 1) * index;
    float c[4] = {bits_as<float>(stored[0]), bits_as<float>(stored[1])};
    if constexpr (degree > 1) c[2] = bits_as<float>(stored[2]);
    if constexpr (degree > 2) c[3] = bits_as<float>(stored[3]);
    const float s = (place - static_cast<float>(index)) - 0.5f;
    float inner = c[degree], outer = inner;
    if constexpr (degree == 3) inner = c[2] + c[3] * s;
    if constexpr (degree > 1) outer = c[1] + inner * s;
    RawSample<float> result;
    result.value = c[0] + (outer * s) * (1.0f / static_cast<float>(int32_t{1} << k));
    result.slope = outer;
    if constexpr (with_slope && degree == 2) result.slope = outer + inner * s;
    if constexpr (with_slope && degree == 3) result.slope = outer + (inner + c[3] * s) * s;
    return result;
  }
}

namespace detail {

// length * value of a raw sample, rounded down, for |value| < 1 and |length| within the domain.
template <int F> constexpr Fixed<F> scaled_by_value(Fixed<F> length, int32_t value) {
  return Fixed<F>::from_raw(multiply_high(shift_left(length.raw(), 1), shift_left(value, 1)));
}
constexpr float scaled_by_value(float length, float value) { return length * value; }

// component * slope of a raw sample: within 2^(2 + headroom) units in the last place, down, of scalars with 24 and more
// fraction bits; rounded half up for others.
template <int F> constexpr Fixed<F> scaled_by_slope(Fixed<F> component, int32_t slope, int headroom) {
  if constexpr (F >= 24) {
    return Fixed<F>::from_raw(shift_left(multiply_high(component.raw(), slope), 2 + headroom));
  } else {
    const int64_t exact = static_cast<int64_t>(component.raw()) * slope;
    return Fixed<F>::from_raw(static_cast<int32_t>((exact + (int64_t{1} << (29 - headroom))) >> (30 - headroom)));
  }
}
constexpr float scaled_by_slope(float component, float slope, int) { return component * slope; }

// Half the slope of a raw sample, and 1 + slope.
constexpr int32_t half_of(int32_t slope) { return slope >> 1; }
constexpr float half_of(float slope) { return 0.5f * slope; }
constexpr int32_t one_more(int32_t slope, int headroom) {
  return wrapping_add(slope, (int32_t{1} << 30) >> headroom);
}
constexpr float one_more(float slope, int) { return 1.0f + slope; }

}  // namespace detail

// The same in the scalar's types, for slope_headroom <= index_bits and 30 - fraction bits. The slope is rounded half up.
template <bool with_slope, class S, int degree, int bits>
constexpr TableSample<S> sample_table(const TableView<S, degree, bits>& table,
                                      typename TableArgument<S>::type argument) {
  const auto raw = sample_raw<with_slope>(table, argument);
  if constexpr (ScalarTraits<S>::is_fixed) {
    static_assert(S::fraction_bits <= 27, "a slope of +-16 must fit the scalar");
    TableSample<S> result;
    result.value = Unit<S>::from_raw(raw.value);
    if constexpr (with_slope) {
      const int drop = 30 - table.slope_headroom - S::fraction_bits;
      result.slope = S::from_raw((raw.slope + ((int32_t{1} << drop) >> 1)) >> drop);
    }
    return result;
  } else {
    return {raw.value, raw.slope};
  }
}

namespace detail {

// Coefficients of one segment as integers: c0 in Q30, the others in Q(30 - headroom), and how far the kernel may be
// off the polynomial of these.
struct IntegerSegment {
  int64_t c[4];
  int64_t slack;
};
template <class S, int degree, int bits>
constexpr IntegerSegment integer_segment(const TableView<S, degree, bits>& table, int segment) {
  IntegerSegment result = {};
  for (int j = 0; j <= degree; ++j) {
    const auto word = table.coefficients[(degree + 1) * segment + j];
    if constexpr (ScalarTraits<S>::is_fixed) {
      result.c[j] = int64_t{static_cast<int32_t>(word)} * (bits == 32 ? 1 : 65536);
      result.slack = bits == 32 ? 4 : 4 * 65536;
    } else {
      const float coefficient = bits_as<float>(word);
      const bool usable = coefficient > -127.0f && coefficient < 127.0f;  // false for NaN
      const int64_t q24 = usable ? static_cast<int32_t>(coefficient * 16777216.0f) : int64_t{1} << 40;
      result.c[j] = j == 0 ? q24 * 64 : q24 * 64 / (int64_t{1} << table.slope_headroom);
      result.slack = 2048;  // of Q30; float slopes need less than their headroom
    }
  }
  return result;
}
constexpr int64_t magnitude_of(int64_t x) { return x < 0 ? -x : x; }
constexpr int64_t shifted_down(int64_t x, int shift) { return shift >= 0 ? x >> shift : x * (int64_t{1} << -shift); }

struct IntegerRange {
  int64_t least = int64_t{1} << 62, greatest = -(int64_t{1} << 62);
  constexpr void include(int64_t x) {
    if (x < least) least = x;
    if (x > greatest) greatest = x;
  }
};
constexpr int32_t to_int32(int64_t x) {
  return x > greatest_of<int32_t> ? greatest_of<int32_t> : x < -greatest_of<int32_t> ? -greatest_of<int32_t>
                                                                                      : static_cast<int32_t>(x);
}

}  // namespace detail

inline constexpr int kGreatestHeadroom = 10;

// Whether every intermediate result of the kernel stays in range on these coefficients: |c1| + |c2| + |c3| leaves room
// for the slope and its rounding, c0 for the value.
template <class S, int degree, int bits>
constexpr bool coefficients_in_range(const TableView<S, degree, bits>& table, int segments) {
  const int headroom = table.slope_headroom, k = table.index_bits;
  if (headroom < 0 || headroom > kGreatestHeadroom) return false;
  for (int i = 0; i < segments; ++i) {
    const detail::IntegerSegment segment = detail::integer_segment(table, i);
    const int64_t* c = segment.c;
    const int64_t sum = detail::magnitude_of(c[1]) + detail::magnitude_of(c[2]) + detail::magnitude_of(c[3]);
    if (sum > greatest_of<int32_t> - (int32_t{1} << 23)) return false;
    const int64_t climb = 4 * detail::magnitude_of(c[1]) + 2 * detail::magnitude_of(c[2]) + detail::magnitude_of(c[3]);
    if (detail::magnitude_of(c[0]) + detail::shifted_down(climb, 3 + k - headroom) > greatest_of<int32_t> - 2 * segment.slack) return false;
  }
  return true;
}

namespace detail {

// Widens `values` by those between the ends of a segment. Of each sixteenth, a turning point in it lies no farther beyond
// an end than its slope can carry it.
constexpr void include_turning_points(IntegerRange& values, const int64_t* c, int down) {
  const auto value_at = [&](int64_t j) {
    return c[0] + shifted_down(256 * j * c[1] + 16 * j * j * c[2] + j * j * j * c[3], 12 + down);
  };
  const auto slope_at = [&](int64_t j) { return (256 * c[1] + 32 * j * c[2] + 3 * j * j * c[3]) >> 8; };
  const int64_t bow = 3 * magnitude_of(c[3]) / 1024 + 1;  // of the slope, above or below its chord
  for (int j = -8; j < 8; ++j) {
    IntegerRange slope;
    slope.include(slope_at(j));
    slope.include(slope_at(j + 1));
    const int64_t steepest_fall = bow - slope.least, steepest_rise = slope.greatest + bow;
    if (steepest_fall < 0 || steepest_rise < 0) continue;
    const int64_t left = value_at(j), right = value_at(j + 1);
    const int64_t fall = shifted_down(steepest_fall, 4 + down) + 1, rise = shifted_down(steepest_rise, 4 + down) + 1;
    values.include(left - fall > right - rise ? left - fall : right - rise);
    values.include(left + rise < right + fall ? left + rise : right + fall);
  }
}

}  // namespace detail

// Value and slope ranges of a table, rounded outwards, from its coefficients alone; the errors are left 0. Integer
// arithmetic: the same on the host, in a constant expression and on a target that checks an image.
template <class S, int degree, int bits>
constexpr TableFacts ranges_of(const TableView<S, degree, bits>& table, int segments) {
  const int k = table.index_bits, headroom = table.slope_headroom;
  detail::IntegerRange values, slopes;  // Q30, Q(30 - headroom)
  int64_t slack = 0;
  for (int i = 0; i < segments; ++i) {
    const detail::IntegerSegment segment = detail::integer_segment(table, i);
    const int64_t* c = segment.c;
    slack = segment.slack;
    detail::IntegerRange slope;
    slope.include((4 * c[1] - 4 * c[2] + 3 * c[3]) >> 2);
    slope.include((4 * c[1] + 4 * c[2] + 3 * c[3]) >> 2);
    if (c[3] != 0 && 2 * detail::magnitude_of(c[2]) < 3 * detail::magnitude_of(c[3])) {
      slope.include(c[1] - c[2] * c[2] / (3 * c[3]));
    }
    slopes.include(slope.least);
    slopes.include(slope.greatest);
    const int64_t left = c[0] + detail::shifted_down(-4 * c[1] + 2 * c[2] - c[3], 3 + k - headroom);
    const int64_t right = c[0] + detail::shifted_down(4 * c[1] + 2 * c[2] + c[3], 3 + k - headroom);
    values.include(left);
    values.include(right);
    if (slope.least < 0 && slope.greatest > 0) detail::include_turning_points(values, c, k - headroom);
  }
  // Q24 from Q(30 - headroom), outwards, in 64 bits.
  const auto to_rate = [headroom](int64_t x) { return headroom <= 6 ? x >> (6 - headroom) : x * (int64_t{1} << (headroom - 6)); };
  TableFacts facts;
  facts.least_value = detail::to_int32(values.least - slack);
  facts.greatest_value = detail::to_int32(values.greatest + slack);
  // Rounding of the slope to S: half a unit in its last place.
  const int64_t rounding = ScalarTraits<S>::is_fixed && fraction_bits_of<S> < 24 ? (int64_t{1} << (24 - fraction_bits_of<S>)) / 2 : 1;
  facts.least_slope = detail::to_int32(to_rate(slopes.least - slack) - 1 - rounding);
  facts.greatest_slope = detail::to_int32(to_rate(slopes.greatest + slack) + 1 + rounding);
  return facts;
}

// The number of bits that index `segments` segments.
constexpr int index_bits_for(int segments) {
  int bits = 0;
  while ((1 << bits) < segments) ++bits;
  return bits;
}

// A table as a value: coefficients and facts, made by bake() in bake.hpp, to be kept in read-only memory.
// Size: (degree + 1) * bits / 8 bytes a segment and 32 more.
template <class S, int segment_count, int degree = 3, int bits = 32> struct Table {
  using View = TableView<S, degree, bits>;
  static constexpr int segments = segment_count;
  static constexpr int index_bits = index_bits_for(segments);
  typename View::Coefficient coefficients[static_cast<size_t>((degree + 1) * segments)] = {};
  int slope_headroom = 0;
  S range{};  // of the function's argument, in its own parameter's unit: 1, or (delta + epsilon) / delta for a kernel
  TableFacts facts;

  constexpr View view() const { return {coefficients, index_bits, slope_headroom}; }
};

}  // namespace nearfield
