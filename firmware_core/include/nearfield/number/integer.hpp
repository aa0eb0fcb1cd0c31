// Integer arithmetic with exactly one meaning on every compiler: two's complement, no undefined behaviour.
#pragma once

#include <stddef.h>
#include <stdint.h>

namespace nearfield {

static_assert((-1 >> 1) == -1, "right shifts of negative numbers must be arithmetic");

// The integer that holds every product of two numbers of width Raw.
template <class Raw> struct WideOf;
template <> struct WideOf<int8_t> { using type = int16_t; };
template <> struct WideOf<int16_t> { using type = int32_t; };
template <> struct WideOf<int32_t> { using type = int64_t; };

template <class Raw> struct UnsignedOf;
template <> struct UnsignedOf<int8_t> { using type = uint8_t; };
template <> struct UnsignedOf<int16_t> { using type = uint16_t; };
template <> struct UnsignedOf<int32_t> { using type = uint32_t; };
template <> struct UnsignedOf<int64_t> { using type = uint64_t; };

template <class Raw>
constexpr Raw greatest_of = static_cast<Raw>(static_cast<typename UnsignedOf<Raw>::type>(-1) >> 1);
template <class Raw> constexpr Raw least_of = static_cast<Raw>(-greatest_of<Raw> - 1);

// Sum, difference and negation modulo 2^width. Exact whenever the exact result is representable.
template <class Raw> constexpr Raw wrapping_add(Raw a, Raw b) {
  using U = typename UnsignedOf<Raw>::type;
  return static_cast<Raw>(static_cast<U>(static_cast<U>(a) + static_cast<U>(b)));
}
template <class Raw> constexpr Raw wrapping_subtract(Raw a, Raw b) {
  using U = typename UnsignedOf<Raw>::type;
  return static_cast<Raw>(static_cast<U>(static_cast<U>(a) - static_cast<U>(b)));
}

// Number of zero bits above the highest one; the full width for 0.
constexpr int leading_zeros(uint32_t x) {
  if (x == 0) return 32;
  return sizeof(int) == sizeof x ? __builtin_clz(static_cast<unsigned>(x)) : __builtin_clzl(x);
}
constexpr int leading_zeros(uint64_t x) {
  const uint32_t high = static_cast<uint32_t>(x >> 32);
  return high != 0 ? leading_zeros(high) : 32 + leading_zeros(static_cast<uint32_t>(x));
}

namespace detail {

// High word of a 32 x 32 bit product, put together from products of 16-bit halves.
constexpr uint32_t high_word_from_halves(uint32_t a, uint32_t b) {
  const uint32_t a_low = a & 0xffffu, a_high = a >> 16, b_low = b & 0xffffu, b_high = b >> 16;
  const uint32_t middle = a_high * b_low + (a_low * b_low >> 16);
  return a_high * b_high + (middle >> 16) + ((a_low * b_high + (middle & 0xffffu)) >> 16);
}
constexpr int32_t high_word_from_halves(int32_t a, int32_t b) {
  const int32_t a_low = a & 0xffff, a_high = a >> 16, b_low = b & 0xffff, b_high = b >> 16;
  const uint32_t lowest = static_cast<uint32_t>(a_low) * static_cast<uint32_t>(b_low);
  const int32_t middle = a_high * b_low + static_cast<int32_t>(lowest >> 16);
  return a_high * b_high + (middle >> 16) + ((a_low * b_high + (middle & 0xffff)) >> 16);
}

// Whether the core has no product of more than 32 bits: from halves it takes half as long as by a library call.
#if defined(__ARM_ARCH_6M__) || defined(__ARM_ARCH_8M_BASE__)
inline constexpr bool kShortProducts = true;
#else
inline constexpr bool kShortProducts = false;
#endif

}  // namespace detail

// High word of a 32 x 32 bit product: floor(a * b / 2^32). One instruction on Cortex-M3 and up, 20 on Cortex-M0.
constexpr uint32_t multiply_high(uint32_t a, uint32_t b) {
  if constexpr (detail::kShortProducts) return detail::high_word_from_halves(a, b);
  else return static_cast<uint32_t>((static_cast<uint64_t>(a) * b) >> 32);
}
constexpr int32_t multiply_high(int32_t a, int32_t b) {
  if constexpr (detail::kShortProducts) return detail::high_word_from_halves(a, b);
  else return static_cast<int32_t>((static_cast<int64_t>(a) * b) >> 32);
}

// floor(x / 2^shift) and x * 2^shift modulo 2^32, shift in 0 ... 31.
constexpr int32_t shift_left(int32_t x, int shift) {
  return static_cast<int32_t>(static_cast<uint32_t>(x) << shift);
}

// The lowest 32 bits of floor(x / 2^shift). Put together from halves, so that compilers treat the result as a plain
// 32-bit number (and multiply it with one instruction) instead of carrying its 64-bit origin along.
template <int shift> constexpr int32_t shift_right_to_32(int64_t x) {
  static_assert(shift > 0 && shift < 63, "a proper shift");
  const uint32_t low = static_cast<uint32_t>(static_cast<uint64_t>(x));
  const int32_t high = static_cast<int32_t>(x >> 32);
  if constexpr (shift >= 32) return high >> (shift - 32);
  else return static_cast<int32_t>(low >> shift | static_cast<uint32_t>(high) << (32 - shift));
}

// Same bits, other type. Not a numeric conversion.
template <class To, class From> constexpr To bits_as(const From& from) {
  static_assert(sizeof(To) == sizeof(From), "bits_as keeps the size");
  return __builtin_bit_cast(To, from);
}

}  // namespace nearfield
