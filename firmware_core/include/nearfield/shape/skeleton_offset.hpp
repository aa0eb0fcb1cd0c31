#pragma once

#include <nearfield/number/vector.hpp>

namespace nearfield::detail {

// clamp(place, 0, length). Without branches, across which compilers would carry products' operands in 64
// bits.
template <int F, class R>
constexpr Fixed<F, R> place_on_segment(Fixed<F, R> place, Fixed<F, R> length) {
  const R from_start = static_cast<R>(place.raw() & ~(place.raw() >> (Fixed<F, R>::width - 1)));
  return Fixed<F, R>::from_raw(least_of_two<R>(from_start, length.raw()));
}
constexpr float place_on_segment(float place, float length) { return clamp(place, 0.0f, length); }

// An offset from a point of a skeleton: 0 where rounding leaves a float so small that its square has no
// digits left.
template <int F, class R>
constexpr Vector3<Fixed<F, R>> settled(const Vector3<Fixed<F, R>>& offset) {
  return offset;
}
constexpr Vector3<float> settled(const Vector3<float>& offset) {
  return sum_of_squares(offset.x, offset.y, offset.z) < 1e-30f ? Vector3<float>{} : offset;
}

}  // namespace nearfield::detail
