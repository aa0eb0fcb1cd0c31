// Square roots with a fixed number of steps and an exactly specified result.
#pragma once

#include <nearfield/number/scalar.hpp>

namespace nearfield {

namespace detail {

// Tangents to 1/sqrt(u) at the middle of each of the 48 intervals of width 1/64 that cover [1/4, 1).
struct ReciprocalRootSeeds {
  int32_t value[48] = {};  // Q30
  int32_t slope[48] = {};  // minus the slope, Q28
};

constexpr ReciprocalRootSeeds make_reciprocal_root_seeds() {
  ReciprocalRootSeeds seeds;
  for (int i = 0; i < 48; ++i) {
    const double u = (2.0 * (i + 16) + 1.0) / 128.0;
    double y = 1.5;
    for (int step = 0; step < 6; ++step) y = y * (3.0 - u * y * y) / 2.0;
    seeds.value[i] = static_cast<int32_t>(y * 1073741824.0);
    seeds.slope[i] = static_cast<int32_t>(y / (2.0 * u) * 268435456.0);
  }
  return seeds;
}

inline constexpr ReciprocalRootSeeds kReciprocalRootSeeds = make_reciprocal_root_seeds();

// x * 4^shift in [2^62, 2^64), y just below 2^63 / sqrt(that), Q31, and half of it. The half is computed in such a way
// that compilers do not know its sign and multiply it with one instruction.
struct Normalised {
  uint64_t m;
  uint32_t y;
  int32_t half;
  int shift;
};

constexpr Normalised normalise(uint64_t x) {
  const int shift = leading_zeros(x) >> 1;
  const uint64_t m = x << (2 * shift);
  const uint32_t u = static_cast<uint32_t>(m >> 32);  // [1/4, 1) in Q32

  const uint32_t index = (u >> 26) - 16;
  const int32_t from_middle = static_cast<int32_t>((u & 0x03ffffffu) << 2) - 0x08000000;  // Q34
  const int32_t seed = kReciprocalRootSeeds.value[index] - multiply_high(from_middle, kReciprocalRootSeeds.slope[index]);
  // Newton steps y += y (1 - u y^2) / 2: the first in Q28, which is as good as its result can be ...
  const uint32_t square = multiply_high(static_cast<uint32_t>(seed), static_cast<uint32_t>(seed));
  const int32_t residual = (1 << 28) - static_cast<int32_t>(multiply_high(u, square));
  const int32_t better = seed + multiply_high(seed, residual * 8);  // Q30
  // ... the second in Q62.
  const uint32_t doubled = static_cast<uint32_t>(better) << 1;
  const uint64_t product = static_cast<uint64_t>(u) * multiply_high(doubled, doubled);
  const int32_t rest = static_cast<int32_t>(static_cast<int64_t>((uint64_t{1} << 62) - product) >> 30);
  const uint32_t y = doubled + static_cast<uint32_t>(multiply_high(better, rest));
  // Less 8: below 1/sqrt(u) whatever was truncated above; see tests/exhaustive/sqrt_test.cpp.
  const int32_t half = (static_cast<int32_t>(y ^ 0x80000000u) >> 1) + 0x40000000 - 4;
  return {m, y - 8, half, shift};
}

}  // namespace detail

// reciprocal / 2^30 approximates 2^(32 - shift) / sqrt(x), never above it, within 2^-27 of it (relatively); below
// 2^31. sqrt(x) lies in [2^(31 - shift), 2^(32 - shift)). Both are 0 for x = 0.
// Cost: 50 instructions on Cortex-M4; the same for every x > 0.
struct ReciprocalRoot {
  int32_t reciprocal;
  int shift;
};
constexpr ReciprocalRoot reciprocal_root(uint64_t x) {
  if (x == 0) return {0, 0};
  const detail::Normalised n = detail::normalise(x);
  return {n.half, n.shift};
}

// The same, with root = floor(sqrt(x)), exact for every x. Cost: 75 instructions on Cortex-M4.
struct RootParts {
  uint32_t root;
  int32_t reciprocal;
  int shift;
};
constexpr RootParts root_parts(uint64_t x) {
  if (x == 0) return {0, 0, 0};
  const detail::Normalised n = detail::normalise(x);
  const uint32_t below = static_cast<uint32_t>(((n.m >> 32) * n.y) >> 31);
  const uint64_t remainder = n.m - static_cast<uint64_t>(below) * below;
  const uint32_t step = static_cast<uint32_t>(remainder >> 6);
  uint32_t root = below + (step > 8 ? multiply_high(step - 8, n.y) >> 26 : 0);
  const uint64_t rest = n.m - static_cast<uint64_t>(root) * root;
  if (rest > 2 * static_cast<uint64_t>(root)) ++root;
  return {root >> n.shift, n.half, n.shift};
}

// floor(sqrt(x)).
constexpr uint32_t integer_sqrt(uint64_t x) { return root_parts(x).root; }

// Square root of a float >= 0, correctly rounded (the same bits as IEEE squareRoot); NaN for NaN, 0 below 0.
constexpr float square_root(float x) {
  const uint32_t bits = bits_as<uint32_t>(x);
  if (bits == 0 || bits >= 0x7f800000u) return x <= 0.0f ? 0.0f : x;
  int exponent = static_cast<int>(bits >> 23);
  uint64_t mantissa = bits & 0x007fffffu;
  if (exponent == 0) exponent = 1;
  else mantissa |= 0x00800000u;
  // x = mantissa * 2^(exponent - 150). Shift so that the root has exactly 32 bits, then round it to 24.
  int shift = leading_zeros(mantissa);
  if (((exponent - 150 - shift) & 1) != 0) --shift;
  const uint32_t root = integer_sqrt(mantissa << shift);
  const int lost = 8 - leading_zeros(root);  // a tie cannot happen: its square would need 50 bits
  const uint32_t rounded = (root + (1u << (lost - 1))) >> lost;
  const int root_exponent = (exponent - 150 - shift) / 2 + lost + 150;
  const uint32_t carry = rounded >> 24;  // rounding up to 2^24
  return bits_as<float>((static_cast<uint32_t>(root_exponent + static_cast<int>(carry)) << 23) |
                        ((rounded >> carry) & 0x007fffffu));
}

// Length of (x, y, z), rounded down, saturated at the greatest number. Error: (-1, 0] units in the last place for
// Fixed in range; for float the roundings of three squares, two sums and a correctly rounded root.
template <int F, class R> constexpr uint64_t sum_of_squares(Fixed<F, R> x, Fixed<F, R> y, Fixed<F, R> z) {
  const int64_t a = x.raw(), b = y.raw(), c = z.raw();
  return static_cast<uint64_t>(a * a) + static_cast<uint64_t>(b * b) + static_cast<uint64_t>(c * c);
}
template <int F, class R> constexpr uint64_t sum_of_squares(Fixed<F, R> x, Fixed<F, R> y) {
  const int64_t a = x.raw(), b = y.raw();
  return static_cast<uint64_t>(a * a) + static_cast<uint64_t>(b * b);
}
constexpr float sum_of_squares(float x, float y, float z) { return (x * x + y * y) + z * z; }
constexpr float sum_of_squares(float x, float y) { return x * x + y * y; }

template <class S> constexpr S root_to_scalar(uint32_t root) {
  return root > static_cast<uint32_t>(greatest_of<typename S::Raw>) ? S::greatest()
                                                                    : S::from_raw(static_cast<typename S::Raw>(root));
}
// Square root of a sum of squares.
template <class S> constexpr S length_of(uint64_t squares) { return root_to_scalar<S>(integer_sqrt(squares)); }
template <class S> constexpr float length_of(float squares) { return square_root(squares); }


// sqrt(hypotenuse^2 - leg^2) for hypotenuse >= leg >= 0, rounded down (float: a few units in the last place lower).
template <int F, class R> constexpr Fixed<F, R> other_leg(Fixed<F, R> hypotenuse, Fixed<F, R> leg) {
  const uint64_t h = static_cast<uint64_t>(hypotenuse.raw()), l = static_cast<uint64_t>(leg.raw());
  return length_of<Fixed<F, R>>(h * h - l * l);
}
constexpr float other_leg(float hypotenuse, float leg) {
  return square_root((hypotenuse - leg) * (hypotenuse + leg)) * 0.9999995f;
}

}  // namespace nearfield
