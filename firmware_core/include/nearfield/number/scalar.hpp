// What the scalar-generic code asks of a number type, for Fixed and for float.
#pragma once

#include <nearfield/number/fixed.hpp>

namespace nearfield {

static_assert(sizeof(float) == 4, "float is IEEE 754 binary32");

// The float side of the vocabulary of fixed.hpp. Each is one IEEE operation, rounded to nearest even; nothing
// saturates (an infinity or NaN never passes the domain check of a query).
constexpr float add_in_range(float a, float b) { return a + b; }
constexpr float subtract_in_range(float a, float b) { return a - b; }
constexpr float absolute(float a) { return a < 0 ? -a : a; }
constexpr float product(float a, float b) { return a * b; }
template <class To> constexpr To narrow(float wide) { return wide; }
template <class To> constexpr To narrow_in_range(float wide) { return wide; }
template <class To> constexpr To narrow(float wide, ArithmeticStatus& status) {
  if (!(wide > -3.0e38f && wide < 3.0e38f)) status.saturated = true;
  return wide;
}

constexpr float add(float a, float b, ArithmeticStatus& status) { return narrow<float>(a + b, status); }

template <class S> constexpr S least_of_two(S a, S b) { return b < a ? b : a; }
template <class S> constexpr S greatest_of_two(S a, S b) { return a < b ? b : a; }
template <class S> constexpr S clamp(S value, S low, S high) {
  return value < low ? low : high < value ? high : value;
}

// A bound on a rate of change (a Lipschitz constant, a table's slope): Q7.24 for every scalar, rounded up.
using Rate = Fixed<24>;

// unit: the type for numbers within [-2, 2), with the most fraction bits: direction cosines, table values.
// tag: names the type in a program image.
// domain(): greatest |coordinate| of a point that a query accepts. Half of what fits twice over, so that differences
//   of accepted points are always representable.
// rounding_unit(reach): the error unit in which shapes state their rounding when coordinates stay within +-reach:
//   one unit in the last place for Fixed, four units in the last place at `reach` for float.
template <class S> struct ScalarTraits;

template <int F, class R> struct ScalarTraits<Fixed<F, R>> {
  using S = Fixed<F, R>;
  using Unit = Fixed<S::width - 2, R>;
  static constexpr bool is_fixed = true;
  static constexpr uint32_t tag = static_cast<uint32_t>(F) | static_cast<uint32_t>(S::width) << 8;
  static constexpr S domain() { return S::from_raw(static_cast<R>(greatest_of<R> / 4 + 1)); }
  static constexpr S greatest() { return S::greatest(); }
  static constexpr S least() { return S::least(); }
  static constexpr S one() { return S::from_raw(static_cast<R>(R{1} << F)); }
  static constexpr Unit unit_one() { return Unit::from_raw(static_cast<R>(R{1} << (S::width - 2))); }
  static constexpr S rounding_unit(S) { return S::unit_in_last_place(); }
  static constexpr S from_unit(Unit u) {
    constexpr int shift = Unit::fraction_bits - F;
    if constexpr (shift <= 0) return S::from_raw(u.raw());
    else return S::from_raw(static_cast<R>((u.raw() + (R{1} << (shift - 1))) >> shift));
  }
  static constexpr S half(S a) { return S::from_raw(static_cast<R>(a.raw() >> 1)); }
  static constexpr S times(S a, int count) {
    ArithmeticStatus ignored;
    return S::saturate(static_cast<int64_t>(a.raw()) * count, ignored);
  }
  static constexpr double to_double(S a) { return a.to_double(); }
  static constexpr uint32_t word(S a) { return static_cast<uint32_t>(static_cast<int32_t>(a.raw())); }
  // a * rate rounded up, for a >= 0 and rate >= 0; saturates.
  static constexpr S multiply_up(S a, Rate rate) {
    ArithmeticStatus ignored;
    const int64_t exact = static_cast<int64_t>(a.raw()) * rate.raw();
    return S::saturate((exact + ((int64_t{1} << Rate::fraction_bits) - 1)) >> Rate::fraction_bits, ignored);
  }
  // a / rate rounded down, for a >= 0 and rate >= 1, with reciprocal = floor(2^30 / rate).
  static constexpr S divide_down(S a, Fixed<30> reciprocal) {
    return S::from_raw(static_cast<R>((static_cast<int64_t>(a.raw()) * reciprocal.raw()) >> 30));
  }
  // Bounds on what small rotations move, for error budgets: length * units * 2^-30, rounded up; and the units of 2^-30
  // by which an angle multiplier * value + offset within +-16 rad may be off when all three were rounded.
  static constexpr S rotation_units_times(S length, uint32_t units) {
    ArithmeticStatus ignored;
    const int64_t exact = static_cast<int64_t>(length.raw()) * static_cast<int64_t>(units);
    return S::saturate((exact >> 30) + 1, ignored);
  }
  static constexpr uint32_t angle_units(S multiplier, S offset) {
    const int64_t half_unit = (int64_t{1} << (30 - F)) / 2 + 1;
    const int64_t m = multiplier.raw() < 0 ? -static_cast<int64_t>(multiplier.raw()) : multiplier.raw();
    const int64_t one = int64_t{1} << F;
    const int64_t offset_units = offset == S{} ? 0 : half_unit;
    if (m == one || m == 0) return static_cast<uint32_t>(half_unit + offset_units);
    // value's rounding times m, the product's own, and m's rounding times the greatest value: (16 + |offset|) / m.
    const int64_t driven = 16 * one + (offset.raw() < 0 ? -static_cast<int64_t>(offset.raw()) : offset.raw());
    const int64_t units = ((half_unit * m) >> F) + 1 + half_unit + offset_units + half_unit * (driven / m + 1);
    return units < (int64_t{1} << 30) ? static_cast<uint32_t>(units) : uint32_t{1} << 30;
  }
};

template <> struct ScalarTraits<float> {
  using S = float;
  using Unit = float;
  static constexpr bool is_fixed = false;
  static constexpr uint32_t tag = 0x01002018;
  static constexpr float domain() { return 16.0f; }
  static constexpr float greatest() { return 1024.0f; }
  static constexpr float least() { return -1024.0f; }
  static constexpr float one() { return 1.0f; }
  static constexpr float unit_one() { return 1.0f; }
  static constexpr float rounding_unit(float reach) { return reach * (1.0f / 2097152.0f); }
  static constexpr float from_unit(float u) { return u; }
  static constexpr float half(float a) { return a * 0.5f; }
  static constexpr float times(float a, int count) { return a * static_cast<float>(count); }
  static constexpr double to_double(float a) { return static_cast<double>(a); }
  static constexpr uint32_t word(float a) { return bits_as<uint32_t>(a); }
  // Upward within a few units in the last place: the factor covers the roundings of the three operations.
  static constexpr float multiply_up(float a, Rate rate) {
    return a * (static_cast<float>(rate.raw()) * (1.0f / 16777216.0f)) * 1.000001f;
  }
  static constexpr float divide_down(float a, Fixed<30> reciprocal) {
    return a * (static_cast<float>(reciprocal.raw()) * (1.0f / 1073741824.0f)) * 0.999999f;
  }
  static constexpr float rotation_units_times(float length, uint32_t units) {
    return length * static_cast<float>(units) * (1.0f / 2097152.0f) * 1.000001f;
  }
  static constexpr uint32_t angle_units(float multiplier, float offset) {
    const float m = multiplier < 0 ? -multiplier : multiplier, o = offset < 0 ? -offset : offset;
    return 4 + static_cast<uint32_t>(4.0f * (16.0f + o + (m < 1024.0f ? m : 1024.0f)));
  }
};

// Fraction bits of a Fixed; the mantissa's 23 of a float.
template <class S> constexpr int fraction_bits_of = 23;
template <int F, class R> constexpr int fraction_bits_of<Fixed<F, R>> = F;

template <class S> using Unit = typename ScalarTraits<S>::Unit;

// floor(2^30 / rate) for rate >= 1: the factor by which a field value becomes a distance.
constexpr Fixed<30> reciprocal_down(Rate rate) {
  const int32_t divisor = rate.raw() < (int32_t{1} << 24) ? int32_t{1} << 24 : rate.raw();
  return Fixed<30>::from_raw(static_cast<int32_t>((int64_t{1} << 54) / divisor));
}

}  // namespace nearfield
