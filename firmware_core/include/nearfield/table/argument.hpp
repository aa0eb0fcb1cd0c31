// From a quantity or a sum of squares to a table's argument, by a product with a baked reciprocal.
#pragma once

#include <nearfield/number/scalar.hpp>

namespace nearfield {

namespace detail {

// 1 / x less two units in the last place, so that quantities below x give arguments below 1.
constexpr float inverse_below(float x) { return (1.0f / x) * (1.0f - 1.0f / 8388608.0f); }

}  // namespace detail

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

  static constexpr ArgumentScale of(float limit) { return {limit, limit > 0.0f ? detail::inverse_below(limit) : 0.0f}; }
  constexpr bool contains(float quantity) const { return quantity < limit; }
  constexpr float argument(float quantity) const { return quantity * inverse; }
  constexpr bool consistent() const { return limit > 0.0f && inverse == detail::inverse_below(limit); }
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

  static constexpr SquareScale of(float limit) { return {limit * limit, limit > 0.0f ? detail::inverse_below(limit * limit) : 0.0f}; }
  constexpr bool contains(float squares) const { return squares < limit_square; }
  constexpr float argument(float squares) const { return squares * inverse; }
  constexpr bool consistent(float limit) const {
    return limit > 0.0f && limit_square == limit * limit && inverse == detail::inverse_below(limit * limit);
  }
};

}  // namespace nearfield
