// A tabulated curve, ready for the target: value and slope at its own argument, exact constants outside its range.
#pragma once

#include <nearfield/table/table.hpp>

namespace nearfield {

// Where a tabulated curve lies and how it is mirrored; the same for every kind of table.
template <class S> struct CurvePlacement {
  S from{}, to{};             // range of the argument
  S start{};                  // where the table begins: `from`, or the middle of a mirrored curve
  Unit<S> before{}, after{};  // values outside the range, exactly
  bool mirrored = false;      // f(start - x) = before + after - f(start + x), to the bit, x > 0
  bool squared = false;       // tabulated over the square of the argument
  ArgumentScale<S> scale;     // over the length of the table
  SquareScale<S> square_scale;
  typename TableArgument<S>::type stretch{};       // segments / 2^index_bits, Q32 for Fixed; 0 for 1
  typename TableArgument<S>::type slope_factor{};  // from slopes of the table to those of the curve, likewise
};

namespace detail {

template <int F, class R>
constexpr uint32_t curve_argument(const CurvePlacement<Fixed<F, R>>& at, Fixed<F, R> offset) {
  const uint32_t raw = static_cast<uint32_t>(offset.raw());
  const uint32_t argument = at.squared ? at.square_scale.argument(static_cast<uint64_t>(raw) * raw) : at.scale.argument(raw);
  return at.stretch == 0 ? argument : multiply_high(argument, at.stretch);
}
constexpr float curve_argument(const CurvePlacement<float>& at, float offset) {
  const float argument = at.squared ? at.square_scale.argument(offset * offset) : at.scale.argument(offset);
  return at.stretch == 0.0f ? argument : argument * at.stretch;
}

// The slope per unit of x from that of the table; over the square, twice x times it.
template <int F, class R>
constexpr int32_t curve_slope(const CurvePlacement<Fixed<F, R>>& at, int32_t slope, Fixed<F, R> x) {
  const int32_t scaled =
      at.slope_factor == 0 ? slope : shift_right_to_32<32>(static_cast<int64_t>(slope) * at.slope_factor);
  return at.squared ? shift_right_to_32<F>(2 * static_cast<int64_t>(scaled) * x.raw()) : scaled;
}
constexpr float curve_slope(const CurvePlacement<float>& at, float slope, float x) {
  const float scaled = at.slope_factor == 0.0f ? slope : slope * at.slope_factor;
  return at.squared ? 2.0f * x * scaled : scaled;
}

constexpr int32_t reflected_value(Fixed<30> sum, int32_t value) { return wrapping_subtract(sum.raw(), value); }
constexpr float reflected_value(float sum, float value) { return sum - value; }
constexpr int32_t raw_value(Fixed<30> value) { return value.raw(); }
constexpr float raw_value(float value) { return value; }

}  // namespace detail

// Value in Q30 and slope as an integer, of which the curve's own layout knows the fraction bits; floats for float.
template <bool with_slope, bool rising, class S, int degree, int bits>
constexpr auto sample_curve(const TableView<S, degree, bits>& table, const CurvePlacement<S>& at, S x) {
  decltype(sample_raw<with_slope, rising>(table, {})) result;
  if (!(at.from < x)) {
    result.value = detail::raw_value(at.before);
    return result;
  }
  if (!(x < at.to)) {
    result.value = detail::raw_value(at.after);
    return result;
  }
  const bool reflected = at.mirrored && x < at.start;
  const S offset = reflected ? subtract_in_range(at.start, x) : subtract_in_range(x, at.start);
  result = sample_raw<with_slope, rising>(table, detail::curve_argument(at, offset));
  if (reflected) result.value = detail::reflected_value(add_in_range(at.before, at.after), result.value);
  if constexpr (with_slope) result.slope = detail::curve_slope(at, result.slope, x);
  return result;
}

template <class S, class Slope> struct CurveSample {
  Unit<S> value{};
  Slope slope{};
};

// Slopes of a Fixed curve have as many fraction bits as their range leaves.
template <class S, int slope_fraction_bits> struct SlopeOf { using type = Fixed<slope_fraction_bits>; };
template <int slope_fraction_bits> struct SlopeOf<float, slope_fraction_bits> { using type = float; };

// Shape and formats as template parameters, everything else as constants. `rising`: see sample_raw().
template <class S, int segments, int degree, int bits, bool rising, int slope_fraction_bits> struct CurveTable {
  using Slope = typename SlopeOf<S, slope_fraction_bits>::type;
  Table<S, segments, degree, bits> table;
  CurvePlacement<S> placement;
  // Greatest errors against the exact curve at every argument, the argument's rounding included: of the value in Q30, of
  // the slope in Q24 where the curve has one.
  int32_t error = 0;
  int32_t slope_error = 0;

  // Value and slope, per unit of x. At and beyond the ends of the range exactly `before` or `after`, slope 0.
  // Cost on Cortex-M4, cubic, 32 bits: see ports/KERNEL.md.
  template <bool with_slope = true> constexpr CurveSample<S, Slope> sample(S x) const {
    const auto raw = sample_curve<with_slope, rising>(table.view(), placement, x);
    if constexpr (ScalarTraits<S>::is_fixed) return {Unit<S>::from_raw(raw.value), Slope::from_raw(raw.slope)};
    else return {raw.value, raw.slope};
  }
};

}  // namespace nearfield
