// Directions of solids of revolution about the local z axis.
#pragma once

#include <nearfield/shape/sample.hpp>

namespace nearfield {

// Distance from the z axis, rounded down, and, where a gradient is asked for, the direction away from it in
// the xy plane: zero on the axis.
template <class Out, class S> constexpr Polar<S, S> from_axis(S x, S y) {
  if constexpr (Out::has_gradient)
    return polar<S>(Vector3<S>{x, y, S{}});
  else
    return {length_of<S>(sum_of_squares(x, y)), {}};
}

// The unit vector with these parts away from the axis and along it. On the axis, where nothing is away from
// it, the direction of the other part: zero if that is.
template <class S, class U> constexpr Vector3<S> revolved(const Vector3<S>& outwards, U away, S along) {
  const S zero{}, one = ScalarTraits<S>::one();
  if (is_zero(outwards) && !(away == U{}))
    return {zero, zero, along > zero ? one : along < zero ? -one : zero};
  return {narrow_in_range<S>(product(outwards.x, away)), narrow_in_range<S>(product(outwards.y, away)),
          along};
}

}  // namespace nearfield
