// Solids without an end.
#pragma once

#include <nearfield/number/direction.hpp>
#include <nearfield/shape/certificate.hpp>
#include <nearfield/shape/elevation.hpp>
#include <nearfield/shape/revolved.hpp>

namespace nearfield {

// What lies below a plane. Metres: a point of the plane within the domain; the normal, a baked direction,
// points out. Exact signed distance.
template <class S> struct HalfSpace {
  using Scalar = S;
  static constexpr Kind kind = Kind::distance;
  Vector3<S> point;
  Vector3<Unit<S>> normal;

  template <class Out> constexpr Out evaluate(const Vector3<S>& p) const {
    using T = ScalarTraits<S>;
    Out out;
    out.value = narrow_in_range<S>(dot(subtract_in_range(p, point), normal));
    if constexpr (Out::has_gradient)
      out.gradient = {T::from_unit(normal.x), T::from_unit(normal.y), T::from_unit(normal.z)};
    return out;
  }

  // Rounding units: point sqrt(3)/2, normal (1.7 units of 2^-30, at 16 m) 3.5, product 1/2.
  constexpr Certificate<S> certificate(Reach<S> reach) const {
    using T = ScalarTraits<S>;
    const S extent = length_of<S>(sum_of_squares(point.x, point.y, point.z));
    return exact_distance<S>(reach, extent + T::times(T::rounding_unit(extent), 8),
                             coordinates_in_domain(point) && is_baked_direction(normal), 5);
  }
};

// All points within `radius` of a line parallel to the local z axis. Metres: where it meets the xy plane,
// within the domain; radius in [0, domain]. Exact signed distance, rounded down; no direction on the line.
template <class S> struct InfiniteCylinder {
  using Scalar = S;
  static constexpr Kind kind = Kind::distance;
  S x{}, y{};
  S radius{};

  template <class Out> constexpr Out evaluate(const Vector3<S>& p) const {
    return from_offset<Out>(Vector3<S>{subtract_in_range(p.x, x), subtract_in_range(p.y, y), S{}}, radius);
  }

  // Rounding units: place 1/sqrt(2), radius 1/2, root 1.
  constexpr Certificate<S> certificate(Reach<S> reach) const {
    const bool valid =
        coordinates_in_domain(Vector3<S>{x, y, S{}}) && within(radius, S{}, ScalarTraits<S>::domain());
    return exact_distance<S>(reach, length_of<S>(sum_of_squares(x, y)) + radius, valid, 3);
  }
};

// Cone about the local z axis that opens upwards. Metres: apex within the domain; sine and cosine of the half
// angle, which is from 0 (a bare half-line) to a right angle (all above the apex). Exact signed distance; no
// direction in the apex and on a bare half-line.
template <class S> struct InfiniteCone {
  using Scalar = S;
  static constexpr Kind kind = Kind::distance;
  Vector3<S> apex;
  Unit<S> sine{}, cosine{};

  template <class Out> constexpr Out evaluate(const Vector3<S>& p) const {
    const Vector3<S> q = subtract_in_range(p, apex);
    const Unit<S> down = subtract_in_range(Unit<S>{}, sine);
    if (is_lower(q.z, sum_of_squares(q.x, q.y, q.z), down)) return from_offset<Out>(q, S{});
    const Polar<S, S> axis = from_axis<Out>(q.x, q.y);
    Out out;
    out.value = narrow_in_range<S>(product(axis.length, cosine) + product(q.z, down));
    if constexpr (Out::has_gradient)
      out.gradient = revolved(axis.direction, cosine, ScalarTraits<S>::from_unit(down));
    return out;
  }

  // Rounding units: apex sqrt(3)/2, sine and cosine (1.2 units of 2^-30 together, at 16 m) 2.4, root 1,
  // product 1/2.
  constexpr Certificate<S> certificate(Reach<S> reach) const {
    using T = ScalarTraits<S>;
    const S extent = length_of<S>(sum_of_squares(apex.x, apex.y, apex.z));
    const bool valid = coordinates_in_domain(apex) && sine >= Unit<S>{} && cosine >= Unit<S>{} &&
                       is_baked_direction(Vector3<Unit<S>>{sine, cosine, Unit<S>{}});
    return exact_distance<S>(reach, extent + T::times(T::rounding_unit(extent), 8), valid, 5);
  }
};

}  // namespace nearfield
