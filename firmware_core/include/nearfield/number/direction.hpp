// Unit vectors for payloads, as exact as their type can hold them.
#pragma once

#include <nearfield/number/vector.hpp>

namespace nearfield {

namespace detail {

// round(|v| 2^bits / divisor) with the sign of v, halves away from zero; 0 for a divisor of 0. Divides.
constexpr int32_t rounded_share(int32_t v, int bits, uint32_t divisor) {
  if (divisor == 0) return 0;
  const uint64_t magnitude =
      v < 0 ? uint64_t{0} - static_cast<uint64_t>(static_cast<int64_t>(v)) : static_cast<uint64_t>(v);
  const uint64_t share = ((magnitude << bits) + divisor / 2) / divisor;
  const int32_t limited = share < 0x7fffffffu ? static_cast<int32_t>(share) : 0x7fffffff;
  return v < 0 ? -limited : limited;
}

}  // namespace detail

// v / |v|, each component within 1 unit of 2^-30 and the length within 1.4 (float: both within 2^-22); zero
// for zero. For payloads: it divides, 3 times.
template <int F> constexpr Vector3<Fixed<30>> baked_direction(const Vector3<Fixed<F>>& v) {
  const uint64_t squares = sum_of_squares(v.x, v.y, v.z);
  if (squares == 0) return {};
  // The root to 32 bits.
  const int shift = leading_zeros(squares) >> 1;
  const uint32_t length = integer_sqrt(squares << (2 * shift));
  const auto component = [&](int32_t raw) {
    return Fixed<30>::from_raw(detail::rounded_share(raw, 30 + shift, length));
  };
  return {component(v.x.raw()), component(v.y.raw()), component(v.z.raw())};
}
constexpr Vector3<float> baked_direction(const Vector3<float>& v) { return polar<float>(v).direction; }

// Whether a vector is of unit length but for the rounding of its components: within 2 units of 2^-30 (float:
// 2^-21). False for NaN.
template <class U> constexpr bool is_baked_direction(const Vector3<U>& v) {
  using T = ScalarTraits<U>;
  const U one = ScalarTraits<U>::unit_one(), slack = T::rounding_unit(one), limit = one + slack;
  const auto fits = [limit](U component) { return component >= -limit && component <= limit; };
  if (!(fits(v.x) && fits(v.y) && fits(v.z))) return false;
  const U length = length_of<U>(sum_of_squares(v.x, v.y, v.z));
  return length >= one - slack && length <= limit;
}

}  // namespace nearfield
