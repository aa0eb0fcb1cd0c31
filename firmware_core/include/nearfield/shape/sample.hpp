// What an evaluation returns. Every shape and blend is written once, for both kinds of result.
#pragma once

#include <nearfield/number/vector.hpp>

namespace nearfield {

// What a field's value means. Kinds never mix: a blend takes operands of its own kind, and a conversion is an operation.
enum class Kind : uint8_t {
  distance = 1,   // metres, negative inside; the gradient has no unit and points outwards
  intensity = 2,  // sum of potentials (KW), 0.5 on the surface, larger inside
  ray = 3,        // ray-linear (Hsu), >= 0: 1 at the influence boundary, 0.5 on the soft surface, smaller inside
  algebraic = 4,  // any function, 0 on the surface, negative inside; saturates at the ends of the number range
};

// Gradients of all kinds but distances are per 1/16 m, so that those of small influence radii fit the number range.
inline constexpr int kGradientLengthLog2 = -4;

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

// A ball about the point of an evaluation, in the coordinates of its frame, metres. `reach`: how far from the frame's
// origin its centre may be.
template <class S> struct Ball {
  S radius{};
  S reach{};
};

// The greatest value that an intensity has anywhere in a ball; of other kinds, the value at its centre. Operations that
// raise intensities have `highest` for it (operands.hpp); the others treat it as a Value.
template <class S> struct Highest {
  using Scalar = S;
  static constexpr bool has_gradient = false;
  S value{};
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
