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
    const S x = beyond(q.x, half_edges.x), y = beyond(q.y, half_edges.y), z = beyond(q.z, half_edges.z), zero{};
    const Vector3<S> outside = {not_negative(x), not_negative(y), not_negative(z)};
    if constexpr (!Out::has_gradient && !ScalarTraits<S>::is_fixed && kHasRootInstruction) {
      // The same without branches: one of them is 0. Compilers can take several points at once then.
      const S most = greatest_of_two(greatest_of_two(x, y), z);
      return {from_offset<Out>(outside, zero).value + least_of_two(most, zero)};
    }
    Out out;
    if (!is_zero(outside)) {
      out = from_offset<Out>(outside, zero);
    } else {
      const S most = greatest_of_two(greatest_of_two(x, y), z);
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

 private:
  // |q| - half.
  template <int F> static constexpr Fixed<F> beyond(Fixed<F> q, Fixed<F> half) {
    return subtract_in_range(q < S{} ? subtract_in_range(S{}, q) : q, half);
  }
  static constexpr float beyond(float q, float half) { return absolute(q) - half; }
  template <int F> static constexpr Fixed<F> not_negative(Fixed<F> x) {
    return Fixed<F>::from_raw(x.raw() & ~(x.raw() >> 31));
  }
  static constexpr float not_negative(float x) { return greatest_of_two(x, 0.0f); }
};

}  // namespace nearfield
