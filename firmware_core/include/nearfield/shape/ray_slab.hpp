#pragma once

#include <nearfield/shape/ray.hpp>

namespace nearfield {

// |(p - point) . normal| / R: both sides of a plane, what norms of ray functions are built from (Hsu,
// equation 4). 0 without a gradient on the plane.
template <class S>
struct RaySlab {
  using Scalar = S;
  static constexpr Kind kind = Kind::ray;
  Vector3<S> point;
  Vector3<Unit<S>> normal;  // a unit vector
  RayRadius<S> influence;

  template <class Out>
  constexpr Out evaluate(const Vector3<S>& p) const {
    const S height = narrow_in_range<S>(dot(subtract_in_range(p, point), normal));
    if (height == S{}) return {};
    const bool below = height < S{};
    Out out = influence.template ray<Out>(below ? -height : height, normal);
    if constexpr (Out::has_gradient) {
      if (below) out.gradient = subtract_in_range(Vector3<S>{}, out.gradient);
    }
    return out;
  }
  // Rounding units: point sqrt(3)/2, normal (half a unit of 2^-30 a component, at 16 m) 2, product 1/2.
  constexpr Certificate<S> certificate(Reach<S> reach) const {
    const S extent = length_of<S>(sum_of_squares(point.x, point.y, point.z));
    const Capsule<S> along_normal(point, normal, ScalarTraits<S>::one(), S{});
    return influence.certificate(reach, extent, along_normal.valid(), 4);
  }
};

}  // namespace nearfield
