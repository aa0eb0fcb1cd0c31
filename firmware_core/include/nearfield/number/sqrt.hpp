// Square roots with a fixed number of steps and an exactly specified result.
#pragma once

#include <nearfield/number/scalar.hpp>

namespace nearfield {

namespace detail {

// Tangents to 1/sqrt(u) at the middle of each of the 48 intervals of width 1/64 that cover [1/4, 1).
struct ReciprocalRootSeeds {
  struct Tangent {
    int32_t value = 0;  // Q30
    int32_t slope = 0;  // minus the slope, Q28
  };
  Tangent tangent[48];
};

constexpr ReciprocalRootSeeds make_reciprocal_root_seeds() {
  ReciprocalRootSeeds seeds;
  for (int i = 0; i < 48; ++i) {
    const double u = (2.0 * (i + 16) + 1.0) / 128.0;
    double y = 1.5;
    for (int step = 0; step < 6; ++step) y = y * (3.0 - u * y * y) / 2.0;
    seeds.tangent[i] = {static_cast<int32_t>(y * 1073741824.0), static_cast<int32_t>(y / (2.0 * u) * 268435456.0)};
  }
  return seeds;
}

inline constexpr ReciprocalRootSeeds kReciprocalRootSeeds = make_reciprocal_root_seeds();

// x * 4^shift in [2^62, 2^64), and about 2^62 / sqrt(that): right to 19 bits.
struct RootSeed {
  uint64_t m;
  int32_t reciprocal;  // Q30
  int shift;
};

// Precondition: x > 0.
constexpr RootSeed root_seed(uint64_t x) {
  const uint32_t high = static_cast<uint32_t>(x >> 32), low = static_cast<uint32_t>(x);
  uint32_t u = 0, rest = 0;  // [1/4, 1) in Q32, and what follows it
  int shift = 0;
  if (high != 0) {
    const int twice = leading_zeros(high) & ~1;
    u = high << twice | low >> 1 >> (31 - twice);
    rest = low << twice;
    shift = twice >> 1;
  } else {
    const int twice = leading_zeros(low) & ~1;
    u = low << (twice & 31);
    shift = 16 + (twice >> 1);
  }
  const ReciprocalRootSeeds::Tangent& tangent = kReciprocalRootSeeds.tangent[(u >> 26) - 16];
  const int32_t from_middle = static_cast<int32_t>((u & 0x03ffffffu) << 2) - 0x08000000;  // Q34
  const int32_t seed = tangent.value - multiply_high(from_middle, tangent.slope);
  // A Newton step y += y (1 - u y^2) / 2 in Q28, which is as good as its result can be.
  const uint32_t square = multiply_high(static_cast<uint32_t>(seed), static_cast<uint32_t>(seed));
  const int32_t residual = (int32_t{1} << 28) - static_cast<int32_t>(multiply_high(u, square));
  return {static_cast<uint64_t>(u) << 32 | rest, seed + multiply_high(seed, residual * 8), shift};
}

// Just below 2^62 / sqrt(m), within 2^-27 of it (relatively). Computed in such a way that compilers do not know its sign
// and multiply it with one instruction.
constexpr int32_t fine_reciprocal(const RootSeed& seed) {
  // Another step in Q62.
  const uint32_t doubled = static_cast<uint32_t>(seed.reciprocal) << 1;
  const uint64_t product = (seed.m >> 32) * multiply_high(doubled, doubled);
  const int32_t rest = static_cast<int32_t>(static_cast<int64_t>((uint64_t{1} << 62) - product) >> 30);
  const uint32_t y = doubled + static_cast<uint32_t>(multiply_high(seed.reciprocal, rest));
  // Half of it, less 4: below whatever was truncated above; see tests/exhaustive/sqrt_test.cpp.
  return (static_cast<int32_t>(y ^ 0x80000000u) >> 1) + 0x40000000 - 4;
}

// floor(sqrt(m)).
constexpr uint32_t normalised_root(const RootSeed& seed) {
  // Less 16: below 2^63 / sqrt(m) whatever was truncated, so that what follows is not above the root.
  const uint32_t y = (static_cast<uint32_t>(seed.reciprocal) << 1) - 16;
  // The first bits, and all but the last unit from what remains: (m - below^2) / (2 sqrt(m)).
  const uint32_t below = multiply_high(static_cast<uint32_t>(seed.m >> 32), y) << 1;
  const uint32_t remainder = static_cast<uint32_t>((seed.m - static_cast<uint64_t>(below) * below) >> 14);
  uint32_t root = below + (multiply_high(remainder, y) >> 18);
  if (seed.m - static_cast<uint64_t>(root) * root > 2 * static_cast<uint64_t>(root)) ++root;
  return root;
}

}  // namespace detail

// reciprocal / 2^30 approximates 2^(32 - shift) / sqrt(x), never above it, within 2^-27 of it (relatively); below
// 2^31. sqrt(x) lies in [2^(31 - shift), 2^(32 - shift)). Both are 0 for x = 0.
// Cost: 50 instructions on Cortex-M4.
struct ReciprocalRoot {
  int32_t reciprocal;
  int shift;
};
constexpr ReciprocalRoot reciprocal_root(uint64_t x) {
  if (x == 0) return {0, 0};
  const detail::RootSeed seed = detail::root_seed(x);
  return {detail::fine_reciprocal(seed), seed.shift};
}

// floor(sqrt(x)), exact for every x. Cost: 56 instructions on Cortex-M4.
constexpr uint32_t integer_sqrt(uint64_t x) {
  if (x == 0) return 0;
  const detail::RootSeed seed = detail::root_seed(x);
  return detail::normalised_root(seed) >> seed.shift;
}

// Both. Cost: 70 instructions on Cortex-M4.
struct RootParts {
  uint32_t root;
  int32_t reciprocal;
  int shift;
};
constexpr RootParts root_parts(uint64_t x) {
  if (x == 0) return {0, 0, 0};
  const detail::RootSeed seed = detail::root_seed(x);
  const uint32_t root = detail::normalised_root(seed) >> seed.shift;
  return {root, detail::fine_reciprocal(seed), seed.shift};
}

// Where the machine has an instruction for it, and compilers need call no function for the sake of errno.
#if defined(__NO_MATH_ERRNO__) && ((defined(__ARM_FP) && (__ARM_FP & 4)) || defined(__SSE2__) || defined(__aarch64__) || \
                                   defined(__riscv_flen) || defined(__wasm__))
inline constexpr bool kHasRootInstruction = true;
#else
inline constexpr bool kHasRootInstruction = false;
#endif

namespace detail {

// Without floating-point instructions; see square_root().
constexpr float square_root_of_integers(float x) {
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
  const uint32_t rounded = (root + (uint32_t{1} << (lost - 1))) >> lost;
  const int root_exponent = (exponent - 150 - shift) / 2 + lost + 150;
  const uint32_t carry = rounded >> 24;  // rounding up to 2^24
  return bits_as<float>((static_cast<uint32_t>(root_exponent + static_cast<int>(carry)) << 23) |
                        ((rounded >> carry) & 0x007fffffu));
}

}  // namespace detail

// Square root of a float >= 0, correctly rounded (the same bits as IEEE squareRoot); NaN for NaN, 0 below 0.
// Cost: the machine's instruction compiled with -fno-math-errno, otherwise as integer_sqrt() and 30 instructions more.
constexpr float square_root(float x) {
  if constexpr (kHasRootInstruction) {
    if (!__builtin_is_constant_evaluated()) return __builtin_sqrtf(x <= 0.0f ? 0.0f : x);
  }
  return detail::square_root_of_integers(x);
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
