#pragma once

#include <nearfield/shape/certificate.hpp>
#include <nearfield/shape/sample.hpp>

namespace nearfield {

// Solid ball. Parameters in metres: centre within the domain, radius in [0, domain]; 0 is a bare point.
// Exact signed distance, rounded down; no direction in the centre. Budget: operations.hpp.
template <class S> struct Sphere {
  using Scalar = S;
  static constexpr Kind kind = Kind::distance;
  Vector3<S> center;
  S radius{};

  template <class Out> constexpr Out evaluate(const Vector3<S>& p) const {
    return from_offset<Out>(subtract_in_range(p, center), radius);
  }
  // Rounding units: centre sqrt(3)/2, radius 1/2, root 1.
  constexpr Certificate<S> certificate(Reach<S> reach) const {
    const S extent = length_of<S>(sum_of_squares(center.x, center.y, center.z)) + radius;
    const bool valid = coordinates_in_domain(center) && within(radius, S{}, ScalarTraits<S>::domain());
    return exact_distance<S>(reach, extent, valid, 3);
  }
};

}  // namespace nearfield
