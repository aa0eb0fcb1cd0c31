#pragma once

#include <nearfield/shape/certificate.hpp>
#include <nearfield/shape/sample.hpp>

namespace nearfield {

// Solid box along the local axes. Metres: centre within the domain, half edges in (0, domain].
// Exact signed distance outside and inside; on the medial planes inside, the first of x, y, z wins.
template <class S> struct Box {
  using Scalar = S;
  static constexpr Kind kind = Kind::distance;
  Vector3<S> center;
  Vector3<S> half_edges;

  template <class Out> constexpr Out evaluate(const Vector3<S>& p) const {
    const Vector3<S> q = subtract_in_range(p, center);
    const S x = subtract_in_range(absolute(q.x), half_edges.x);
    const S y = subtract_in_range(absolute(q.y), half_edges.y);
    const S z = subtract_in_range(absolute(q.z), half_edges.z);
    const S zero{};
    const S most = greatest_of_two(greatest_of_two(x, y), z);
    Out out;
    if (most > zero) {
      const Vector3<S> outside = {greatest_of_two(x, zero), greatest_of_two(y, zero), greatest_of_two(z, zero)};
      out = from_offset<Out>(outside, zero);
    } else {
      out.value = most;
      if constexpr (Out::has_gradient) {
        const S one = ScalarTraits<S>::one();
        out.gradient = most == x ? Vector3<S>{one, zero, zero}
                       : most == y ? Vector3<S>{zero, one, zero} : Vector3<S>{zero, zero, one};
      }
    }
    if constexpr (Out::has_gradient) {
      if (q.x < zero) out.gradient.x = -out.gradient.x;
      if (q.y < zero) out.gradient.y = -out.gradient.y;
      if (q.z < zero) out.gradient.z = -out.gradient.z;
    }
    return out;
  }

  // Rounding units: centre and half edges 1 in each of three directions (sqrt(3)), root 1.
  constexpr Certificate<S> certificate(Reach<S> reach) const {
    const S extent = length_of<S>(sum_of_squares(center.x, center.y, center.z)) +
                     length_of<S>(sum_of_squares(half_edges.x, half_edges.y, half_edges.z));
    const bool valid = coordinates_in_domain(center) && valid_length(half_edges.x) && valid_length(half_edges.y) &&
                       valid_length(half_edges.z);
    return exact_distance<S>(reach, extent, valid, 4);
  }
};

}  // namespace nearfield
