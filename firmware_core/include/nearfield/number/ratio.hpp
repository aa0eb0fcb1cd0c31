// Quotients of magnitudes without a division, in a fixed number of steps.
#pragma once

#include <nearfield/number/scalar.hpp>

namespace nearfield {

namespace detail {

// Tangents to 1/x at the middle of each of the 32 intervals of width 1/32 that cover [1, 2), less a little.
struct ReciprocalSeeds {
  uint32_t value[32] = {};  // Q32
  int32_t slope[32] = {};   // minus the slope, Q27
};

constexpr ReciprocalSeeds make_reciprocal_seeds() {
  ReciprocalSeeds seeds;
  for (int i = 0; i < 32; ++i) {
    const uint64_t middle = 65 + 2 * static_cast<uint64_t>(i);  // Q6
    seeds.value[i] = static_cast<uint32_t>((uint64_t{1} << 38) / middle) - 2;
    seeds.slope[i] = static_cast<int32_t>((uint64_t{1} << 39) / (middle * middle));
  }
  return seeds;
}

inline constexpr ReciprocalSeeds kReciprocalSeeds = make_reciprocal_seeds();

// 2^63 / d for d in [2^31, 2^32): less than that, by less than 1.2.
constexpr uint32_t normalised_reciprocal(uint32_t d) {
  const uint32_t index = (d >> 26) & 31u;
  // Q37, two's complement.
  const int32_t from_middle = static_cast<int32_t>(((d & 0x03ffffffu) ^ 0x02000000u) << 6);
  const int32_t descent = multiply_high(from_middle, kReciprocalSeeds.slope[index]);
  const uint32_t seed = kReciprocalSeeds.value[index] - static_cast<uint32_t>(descent);
  // 1 / (1 - rest) = 1 + rest + rest^2, rest in [0, 2^-12] as Q43; what is left out is below 2^-36.
  const uint32_t rest = static_cast<uint32_t>(((uint64_t{1} << 63) - static_cast<uint64_t>(d) * seed) >> 20);
  const uint32_t correction = rest + (multiply_high(rest, rest) >> 11);
  return seed + (multiply_high(seed, correction) >> 11);
}

}  // namespace detail

// A table's argument (TableArgument) numerator / denominator, in [0, 1). Magnitudes in units of the last
// place of one scalar, numerator <= denominator. A denominator of 0 gives 0, equal ones the last argument
// below 1. Rounding: down, by at most two units of 2^-31 beyond the exact quotient rounded down. Cost: 30
// instructions on Cortex-M4; the same for all operands that are not 0.
constexpr uint32_t ratio(uint32_t numerator, uint32_t denominator) {
  if (denominator == 0) return 0;
  const int shift = leading_zeros(denominator);
  return multiply_high(numerator << shift, detail::normalised_reciprocal(denominator << shift));
}
// One IEEE division. Total: what is not a number gives a number in range.
constexpr float ratio(float numerator, float denominator) {
  if (!(denominator > 0.0f)) return 0.0f;
  const float quotient = numerator / denominator;
  constexpr float last = 1.0f - 1.0f / 16777216.0f;
  return !(quotient > 0.0f) ? 0.0f : quotient < last ? quotient : last;
}

// 1 / x of a scalar x > 0 (0 for any other), for quotient(). Payloads hold it baked.
template <class S> struct Reciprocal {
  uint32_t mantissa = 0;  // 1 / raw = mantissa / 2^(63 - shift), less than that by less than 1.2 units
  uint32_t shift = 0;
};
template <> struct Reciprocal<float> {
  float inverse = 0.0f;
};

template <int F> constexpr Reciprocal<Fixed<F>> reciprocal_of(Fixed<F> x) {
  if (x.raw() <= 0) return {};
  const uint32_t raw = static_cast<uint32_t>(x.raw());
  const int shift = leading_zeros(raw);
  return {detail::normalised_reciprocal(raw << shift), static_cast<uint32_t>(shift)};
}
constexpr Reciprocal<float> reciprocal_of(float x) { return {x > 0.0f ? 1.0f / x : 0.0f}; }

template <class S> constexpr bool operator==(const Reciprocal<S>& a, const Reciprocal<S>& b) {
  return a.mantissa == b.mantissa && a.shift == b.shift;
}
constexpr bool operator==(const Reciprocal<float>& a, const Reciprocal<float>& b) {
  return a.inverse == b.inverse;
}

// numerator / denominator for a numerator >= 0, rounded half up; saturates. The result may be of another
// fixed-point type. Error: half a unit in the last place and the quotient's 2^-30th part; float: the
// quotient's 2^-23rd part.
template <class To, int F>
constexpr To quotient(Fixed<F> numerator, const Reciprocal<Fixed<F>>& denominator) {
  static_assert(To::fraction_bits <= 30, "the shift below must stay positive");
  const uint64_t exact = static_cast<uint64_t>(static_cast<uint32_t>(numerator.raw())) * denominator.mantissa;
  const uint32_t drop = 63u - (denominator.shift & 31u) - static_cast<uint32_t>(To::fraction_bits);
  const uint64_t rounded = ((exact >> (drop - 1)) + 1) >> 1;
  if (rounded > static_cast<uint64_t>(greatest_of<typename To::Raw>)) return To::greatest();
  return To::from_raw(static_cast<typename To::Raw>(rounded));
}
template <class To> constexpr float quotient(float numerator, const Reciprocal<float>& denominator) {
  return numerator * denominator.inverse;
}

}  // namespace nearfield
