#pragma once

#include <nearfield/shape/certificate.hpp>
#include <nearfield/shape/revolved.hpp>

namespace nearfield {

// All points within `tube_radius` of a circle about the local z axis. Metres: centre within the domain, ring
// radius in (0, domain], tube radius in [0, ring radius]; 0 is the circle itself. Exact signed distance,
// rounded down by less than two units; no direction on the circle and in the centre, on the axis that of the
// axis.
template <class S> struct Torus {
  using Scalar = S;
  static constexpr Kind kind = Kind::distance;
  Vector3<S> center;
  S ring_radius{};
  S tube_radius{};

  template <class Out> constexpr Out evaluate(const Vector3<S>& p) const {
    const Vector3<S> q = subtract_in_range(p, center);
    const Polar<S, S> axis = from_axis<Out>(q.x, q.y);
    Out out =
        from_offset<Out>(Vector3<S>{subtract_in_range(axis.length, ring_radius), S{}, q.z}, tube_radius);
    if constexpr (Out::has_gradient) out.gradient = revolved(axis.direction, out.gradient.x, out.gradient.z);
    return out;
  }

  // Rounding units: centre sqrt(3)/2, radii 1/2 each, two roots 2.
  constexpr Certificate<S> certificate(Reach<S> reach) const {
    const S extent = length_of<S>(sum_of_squares(center.x, center.y, center.z)) + ring_radius + tube_radius;
    const bool valid =
        coordinates_in_domain(center) && valid_length(ring_radius) && within(tube_radius, S{}, ring_radius);
    return exact_distance<S>(reach, extent, valid, 4);
  }
};

}  // namespace nearfield
