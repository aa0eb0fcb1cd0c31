// The kernel: value and slope of a function of one bounded variable, from a uniform table of cubics.
// Everything in Nearfield that is not a polynomial goes through sample_table().
#pragma once

#include <nearfield/number/scalar.hpp>

namespace nearfield {

// Facts about a baked table, rounded outwards. They hold for every argument and for the coefficients as stored.
struct TableFacts {
  int32_t error = 0;        // greatest |table - exact function|, Q30, kernel rounding included
  int32_t least_value = 0;  // range of the value, Q30
  int32_t greatest_value = 0;
  int32_t least_slope = 0;  // range of the slope per unit argument, Q24 (a Rate)
  int32_t greatest_slope = 0;
};

// Where a table's coefficients are and how they are scaled; the coefficients may lie in an image in flash.
// Segment i of 2^log2_segments covers arguments [i, i + 1) / 2^log2_segments. With s in [-1/2, 1/2) the place
// within the segment, counted from its middle,
//   value = c0 + s (c1 + s (c2 + s c3)) / 2^log2_segments        slope = c1 + s (2 c2 + s 3 c3)
// Fixed: c0 in Q30, c1 ... c3 in Q(30 - slope_headroom), two's complement; float: the bits of all four as they are.
template <class S> struct TableView {
  const uint32_t* coefficients = nullptr;  // c0 ... c3 of segment 0, of segment 1, ...
  int log2_segments = 0;
  int slope_headroom = 0;
};

// Whether every intermediate result of the kernel stays in range on these coefficients: |c1| + |c2| + |c3| leaves room
// for the slope and its rounding, c0 for the value. 2^k segments, headroom within 0 ... 3 and k.
template <class S> constexpr bool coefficients_in_range(const TableView<S>& table);

// Value and slope ranges of a table, rounded outwards, from its coefficients alone; error is left 0. Integer
// arithmetic: the same on the host, in a constant expression and on a target that checks an image.
template <class S> constexpr TableFacts ranges_of(const TableView<S>& table);

// Arguments: a fraction of the table's range in [0, 1), Q31 for Fixed. At or beyond the end callers do not ask.
template <class S> struct TableArgument { using type = uint32_t; };
template <> struct TableArgument<float> { using type = float; };

template <class S> struct TableSample {
  Unit<S> value{};  // in [-2, 2)
  S slope{};        // per unit argument
};

// Value and slope at `argument` in [0, 1); beyond, the last segment's last value.
// Rounding: each of the three products is truncated: value within 2 units of 2^-30 of the stored cubic, slope within
// 3 units of 2^-(30 - slope_headroom) plus its rounding to S.
// Cost in line, Cortex-M4: 16 instructions for the value, 24 with the slope.
template <bool with_slope, class S>
constexpr TableSample<S> sample_table(const TableView<S>& table, typename TableArgument<S>::type argument) {
  const int k = table.log2_segments;
  static_assert(fraction_bits_of<S> <= 27, "a slope of +-16 must fit the scalar");
  if constexpr (ScalarTraits<S>::is_fixed) {
    const uint32_t in_range = argument < 0x80000000u ? argument : 0x7fffffffu;
    const uint32_t* stored = table.coefficients + 4 * (in_range >> (31 - k));
    const int32_t c[4] = {static_cast<int32_t>(stored[0]), static_cast<int32_t>(stored[1]),
                          static_cast<int32_t>(stored[2]), static_cast<int32_t>(stored[3])};
    const int32_t s = static_cast<int32_t>((in_range << (k + 1)) ^ 0x80000000u);  // Q32, from the middle
    const int32_t inner = wrapping_add(c[2], multiply_high(c[3], s));
    const int32_t outer = wrapping_add(c[1], multiply_high(inner, s));
    const int32_t climb = multiply_high(outer, s);
    TableSample<S> result;
    const int down = k - table.slope_headroom;
    result.value = Unit<S>::from_raw(wrapping_add(c[0], climb >> down));
    if constexpr (with_slope) {
      const int32_t bend = wrapping_add(inner, multiply_high(c[3], s));
      const int32_t slope = wrapping_add(outer, multiply_high(bend, s));
      const int drop = 30 - table.slope_headroom - S::fraction_bits;
      result.slope = S::from_raw((slope + ((1 << drop) >> 1)) >> drop);
    }
    return result;
  } else {
    const float segments = static_cast<float>(1 << k);
    const float in_range = argument < 0.99999994f ? (argument > 0.0f ? argument : 0.0f) : 0.99999994f;
    const float place = in_range * segments;
    const int32_t index = static_cast<int32_t>(place);
    const uint32_t* stored = table.coefficients + 4 * index;
    const float c[4] = {bits_as<float>(stored[0]), bits_as<float>(stored[1]), bits_as<float>(stored[2]),
                        bits_as<float>(stored[3])};
    const float s = (place - static_cast<float>(index)) - 0.5f;
    const float inner = c[2] + c[3] * s;
    const float outer = c[1] + inner * s;
    TableSample<S> result;
    result.value = c[0] + (outer * s) * (1.0f / segments);
    if constexpr (with_slope) result.slope = outer + (inner + c[3] * s) * s;
    return result;
  }
}

namespace detail {

// Coefficients of one segment as integers: c0 in Q30, the others in Q(30 - headroom), and how far off that may be.
struct IntegerSegment {
  int64_t c[4];
  int64_t slack;
};
template <class S> constexpr IntegerSegment integer_segment(const TableView<S>& table, int segment) {
  IntegerSegment result = {};
  for (int j = 0; j < 4; ++j) {
    const uint32_t word = table.coefficients[4 * segment + j];
    if constexpr (ScalarTraits<S>::is_fixed) {
      result.c[j] = static_cast<int32_t>(word);
      result.slack = 4;
    } else {
      const float coefficient = bits_as<float>(word);
      const bool usable = coefficient > -63.0f && coefficient < 63.0f;  // false for NaN
      const int64_t q24 = usable ? static_cast<int32_t>(coefficient * 16777216.0f) : int64_t{1} << 40;
      result.c[j] = j == 0 ? q24 * 64 : q24 * 64 / (int64_t{1} << table.slope_headroom);
      result.slack = 2048;
    }
  }
  return result;
}
constexpr int64_t magnitude_of(int64_t x) { return x < 0 ? -x : x; }

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

template <class S> constexpr bool coefficients_in_range(const TableView<S>& table) {
  const int headroom = table.slope_headroom, k = table.log2_segments;
  if (headroom < 0 || headroom > 3 || headroom > k) return false;
  for (int i = 0; i < (1 << k); ++i) {
    const detail::IntegerSegment segment = detail::integer_segment(table, i);
    const int64_t* c = segment.c;
    const int64_t sum = detail::magnitude_of(c[1]) + detail::magnitude_of(c[2]) + detail::magnitude_of(c[3]);
    if (sum > greatest_of<int32_t> - (1 << 23)) return false;
    if (detail::magnitude_of(c[0]) + (sum >> (k - headroom)) > greatest_of<int32_t> - 8) return false;
  }
  return true;
}

template <class S> constexpr TableFacts ranges_of(const TableView<S>& table) {
  const int k = table.log2_segments, headroom = table.slope_headroom;
  detail::IntegerRange values, slopes;  // Q30, Q(30 - headroom)
  int64_t slack = 0;
  for (int i = 0; i < (1 << k); ++i) {
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
    const int64_t left = c[0] + ((-4 * c[1] + 2 * c[2] - c[3]) >> (3 + k - headroom));
    const int64_t right = c[0] + ((4 * c[1] + 2 * c[2] + c[3]) >> (3 + k - headroom));
    values.include(left);
    values.include(right);
    // A turning point within the segment lies no farther beyond an end than the slope can carry it.
    if (slope.least < 0 && slope.greatest > 0) {
      const int64_t fall = ((-slope.least) >> (k - headroom)) + 1, rise = (slope.greatest >> (k - headroom)) + 1;
      values.include(left - fall > right - rise ? left - fall : right - rise);
      values.include(left + rise < right + fall ? left + rise : right + fall);
    }
  }
  const int64_t slope_unit = int64_t{1} << (6 - headroom);  // of Q24 in Q(30 - headroom)
  TableFacts facts;
  facts.least_value = detail::to_int32(values.least - slack);
  facts.greatest_value = detail::to_int32(values.greatest + slack);
  // Rounding of the slope to S: half a unit in its last place.
  const int64_t rounding = ScalarTraits<S>::is_fixed && fraction_bits_of<S> < 24 ? (int64_t{1} << (24 - fraction_bits_of<S>)) / 2 : 1;
  facts.least_slope = detail::to_int32((slopes.least - slack) / slope_unit - 1 - rounding);
  facts.greatest_slope = detail::to_int32((slopes.greatest + slack) / slope_unit + 1 + rounding);
  return facts;
}

// A table as a value: coefficients and facts, made by bake() in bake.hpp, to be kept in read-only memory.
// Size: 16 bytes a segment and 28 more.
template <class S, int Log2Segments> struct Table {
  static constexpr int segments = 1 << Log2Segments;
  uint32_t coefficients[static_cast<size_t>(4 * segments)] = {};
  int slope_headroom = 0;
  S range{};  // of the function's argument, in its own parameter's unit: 1, or (delta + epsilon) / delta for a kernel
  TableFacts facts;

  constexpr TableView<S> view() const { return {coefficients, Log2Segments, slope_headroom}; }
};

// Maps a quantity in [0, limit) to a table's argument in [0, 1), by a product with a baked reciprocal.
// Rounding: down, less than 2^-29 of the table's range for Fixed. Cost: 3 instructions on Cortex-M4.
template <class S> struct ArgumentScale {
  S limit{};
  uint32_t shift = 0;    // brings `limit` to 32 bits
  uint32_t inverse = 0;  // 2^63 / (limit shifted)

  static constexpr ArgumentScale of(S limit) {
    if (!(limit > S{})) return {};
    const uint32_t raw = static_cast<uint32_t>(limit.raw());
    const int shift = leading_zeros(raw);
    const uint64_t inverse = (uint64_t{1} << 63) / (raw << shift);
    return {limit, static_cast<uint32_t>(shift), inverse > 0xffffffffu ? 0xffffffffu : static_cast<uint32_t>(inverse)};
  }
  // `quantity` is a magnitude in units of the last place of S.
  constexpr bool contains(uint32_t quantity) const { return quantity < static_cast<uint32_t>(limit.raw()); }
  constexpr uint32_t argument(uint32_t quantity) const { return multiply_high(quantity << shift, inverse); }
  constexpr bool consistent() const {
    const ArgumentScale again = of(limit);
    return limit > S{} && shift == again.shift && inverse == again.inverse;
  }
};
template <> struct ArgumentScale<float> {
  float limit = 0.0f;
  float inverse = 0.0f;

  static constexpr ArgumentScale of(float limit) { return {limit, limit > 0.0f ? 1.0f / limit : 0.0f}; }
  constexpr bool contains(float quantity) const { return quantity < limit; }
  constexpr float argument(float quantity) const { return quantity * inverse; }
  constexpr bool consistent() const { return limit > 0.0f && inverse == 1.0f / limit; }
};

// The same for a sum of squares (see sum_of_squares()) in [0, limit^2).
template <class S> struct SquareScale {
  uint32_t limit_high = 0, limit_low = 0;  // limit^2, in squared units of the last place
  uint32_t shift = 0;                      // 64-bit left shift that brings limit^2 to 64 bits
  uint32_t inverse = 0;

  static constexpr SquareScale of(S limit) {
    if (!(limit > S{})) return {};
    const uint64_t square = static_cast<uint64_t>(limit.raw()) * static_cast<uint64_t>(limit.raw());
    const int shift = leading_zeros(square);
    const uint32_t high = static_cast<uint32_t>((square << shift) >> 32);
    // One more than the truncated divisor, so that the argument stays below 1.
    const uint64_t inverse = (uint64_t{1} << 63) / (static_cast<uint64_t>(high) + 1);
    return {static_cast<uint32_t>(square >> 32), static_cast<uint32_t>(square), static_cast<uint32_t>(shift),
            static_cast<uint32_t>(inverse)};
  }
  constexpr uint64_t limit_square() const { return static_cast<uint64_t>(limit_high) << 32 | limit_low; }
  constexpr bool contains(uint64_t squares) const { return squares < limit_square(); }
  constexpr uint32_t argument(uint64_t squares) const {
    return multiply_high(static_cast<uint32_t>((squares << shift) >> 32), inverse);
  }
  constexpr bool consistent(S limit) const {
    const SquareScale again = of(limit);
    return limit > S{} && limit_square() == again.limit_square() && shift == again.shift && inverse == again.inverse;
  }
};
template <> struct SquareScale<float> {
  float limit_square = 0.0f;
  float inverse = 0.0f;

  static constexpr SquareScale of(float limit) { return {limit * limit, limit > 0.0f ? 1.0f / (limit * limit) : 0.0f}; }
  constexpr bool contains(float squares) const { return squares < limit_square; }
  constexpr float argument(float squares) const { return squares * inverse; }
  constexpr bool consistent(float limit) const {
    return limit > 0.0f && limit_square == limit * limit && inverse == 1.0f / (limit * limit);
  }
};

}  // namespace nearfield
