// What an evaluation returns. Every shape and blend is written once, for both kinds of result.
#pragma once

#include <nearfield/number/vector.hpp>

namespace nearfield {

// What a field's value means (MATHS: kinds). Kinds never mix.
enum class Kind : uint8_t {
  distance = 1,   // metres, negative inside; the gradient has no unit and points outwards
  intensity = 2,  // sum of potentials, larger inside; the gradient is per kIntensityGradientLength
};

// Gradients of intensities are given per 1/16 m, so that those of small influence radii fit the number range.
inline constexpr int kIntensityGradientLengthLog2 = -4;

template <class S> struct Value {
  using Scalar = S;
  static constexpr bool has_gradient = false;
  S value{};
};

template <class S> struct Sample {
  using Scalar = S;
  static constexpr bool has_gradient = true;
  S value{};
  Vector3<S> gradient{};
};

// Distance and direction from the offset between a point and the nearest point of a skeleton, less a radius.
// Rounding: down, (-1, 0] units in the last place for Fixed. A zero offset has no direction: gradient 0.
template <class Out, class S> constexpr Out from_offset(const Vector3<S>& offset, S radius) {
  if constexpr (Out::has_gradient) {
    const Polar<S, S> away = polar<S>(offset);
    return {subtract_in_range(away.length, radius), away.direction};
  } else {
    return {subtract_in_range(length_of<S>(sum_of_squares(offset.x, offset.y, offset.z)), radius)};
  }
}

}  // namespace nearfield
