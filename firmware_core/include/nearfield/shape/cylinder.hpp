#pragma once

#include <nearfield/shape/certificate.hpp>
#include <nearfield/shape/sample.hpp>

namespace nearfield {

// Solid finite cylinder about the local z axis. Metres: centre within the domain, radius and half height in
// (0, domain]. Exact signed distance outside and inside; where cap and wall are equally near inside, the wall wins.
template <class S> struct Cylinder {
  using Scalar = S;
  static constexpr Kind kind = Kind::distance;
  Vector3<S> center;
  S radius{};
  S half_height{};

  template <class Out> constexpr Out evaluate(const Vector3<S>& p) const {
    const S zero{};
    const Vector3<S> q = subtract_in_range(p, center);
    const Out wall = from_offset<Out>(Vector3<S>{q.x, q.y, zero}, radius);
    const S cap = subtract_in_range(absolute(q.z), half_height);
    if (wall.value <= zero || cap <= zero) {
      if (wall.value >= cap) return wall;
      Out out;
      out.value = cap;
      if constexpr (Out::has_gradient) out.gradient.z = towards_cap(q.z, ScalarTraits<S>::one());
      return out;
    }
    // Outside both: the nearest point is on the rim.
    Out rim = from_offset<Out>(Vector3<S>{wall.value, zero, cap}, zero);
    if constexpr (Out::has_gradient) {
      const S outwards = rim.gradient.x;
      rim.gradient = {narrow_in_range<S>(product(wall.gradient.x, outwards)),
                      narrow_in_range<S>(product(wall.gradient.y, outwards)), towards_cap(q.z, rim.gradient.z)};
    }
    return rim;
  }

  // Rounding units: centre sqrt(3)/2, radius and half height 1/2 each, two roots 2.
  constexpr Certificate<S> certificate(Reach<S> reach) const {
    const S extent = length_of<S>(sum_of_squares(center.x, center.y, center.z)) +
                     length_of<S>(sum_of_squares(radius, half_height));
    const bool valid = coordinates_in_domain(center) && valid_length(radius) && valid_length(half_height);
    return exact_distance<S>(reach, extent, valid, 5);
  }

 private:
  static constexpr S towards_cap(S z, S amount) { return z < S{} ? -amount : amount; }
};

}  // namespace nearfield
