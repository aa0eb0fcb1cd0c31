#pragma once

#include <nearfield/shape/certificate.hpp>
#include <nearfield/shape/revolved.hpp>

namespace nearfield {

// All points within `thickness` of a filled disc in the local xy plane. Metres: centre within the domain;
// radius of the disc and thickness in [0, domain]. Exact signed distance, rounded down by less than two
// units; no direction on the disc.
template <class S> struct Disc {
  using Scalar = S;
  static constexpr Kind kind = Kind::distance;
  Vector3<S> center;
  S radius{};
  S thickness{};

  template <class Out> constexpr Out evaluate(const Vector3<S>& p) const {
    const S zero{};
    const Vector3<S> q = subtract_in_range(p, center);
    if (sum_of_squares(q.x, q.y) <= sum_of_squares(radius, zero)) {
      Out out;
      out.value = subtract_in_range(absolute(q.z), thickness);
      if constexpr (Out::has_gradient) {
        const S one = ScalarTraits<S>::one();
        out.gradient.z = q.z > zero ? one : q.z < zero ? -one : zero;
      }
      return out;
    }
    const Polar<S, S> axis = from_axis<Out>(q.x, q.y);
    Out out = from_offset<Out>(Vector3<S>{subtract_in_range(axis.length, radius), zero, q.z}, thickness);
    if constexpr (Out::has_gradient) out.gradient = revolved(axis.direction, out.gradient.x, out.gradient.z);
    return out;
  }

  // Rounding units: centre sqrt(3)/2, radius and thickness 1/2 each, two roots 2.
  constexpr Certificate<S> certificate(Reach<S> reach) const {
    const S extent = length_of<S>(sum_of_squares(center.x, center.y, center.z)) + radius + thickness;
    const S limit = ScalarTraits<S>::domain();
    const bool valid =
        coordinates_in_domain(center) && within(radius, S{}, limit) && within(thickness, S{}, limit);
    return exact_distance<S>(reach, extent, valid, 4);
  }
};

}  // namespace nearfield
