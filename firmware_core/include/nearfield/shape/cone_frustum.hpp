#pragma once

#include <nearfield/number/direction.hpp>
#include <nearfield/shape/certificate.hpp>
#include <nearfield/shape/revolved.hpp>

namespace nearfield {

// Solid frustum of a cone about the local z axis. Metres: centre within the domain; radii of the lower and of
// the upper face in [0, domain], not both 0; half height in (0, domain]. Exact signed distance outside and
// inside; where a face and the side are equally near inside, the side wins. On the axis, where the side is
// nearest, the direction is that in which the radius falls, none if it does not.
template <class S> struct ConeFrustum {
  using Scalar = S;
  static constexpr Kind kind = Kind::distance;
  Vector3<S> center;
  S radius_below{};
  S radius_above{};
  S half_height{};
  Unit<S> away{}, along{};  // the side's normal, away from the axis and along it

  constexpr ConeFrustum() = default;
  constexpr ConeFrustum(const Vector3<S>& at, S lower_radius, S upper_radius, S half_of_height)
      : center(at), radius_below(lower_radius), radius_above(upper_radius), half_height(half_of_height) {
    const Vector3<Unit<S>> normal =
        baked_direction(Vector3<S>{half_height + half_height, radius_below - radius_above, S{}});
    away = normal.x;
    along = normal.y;
  }

  template <class Out> constexpr Out evaluate(const Vector3<S>& p) const {
    const S zero{};
    const Vector3<S> q = subtract_in_range(p, center);
    const Polar<S, S> axis = from_axis<Out>(q.x, q.y);
    const S face = subtract_in_range(absolute(q.z), half_height);
    // From the rims, in the half plane through p.
    const S x_below = subtract_in_range(axis.length, radius_below), z_below = add_in_range(q.z, half_height);
    const S x_above = subtract_in_range(axis.length, radius_above),
            z_above = subtract_in_range(q.z, half_height);
    const S side = narrow_in_range<S>(product(x_below, away) + product(z_below, along));
    const bool inside = face <= zero && side <= zero;
    Out out;
    if (inside ? side < face : face > zero && (q.z < zero ? x_below : x_above) <= zero) {
      out.value = face;
      if constexpr (Out::has_gradient)
        out.gradient.z = q.z < zero ? -ScalarTraits<S>::one() : ScalarTraits<S>::one();
      return out;
    }
    const bool below = is_negative(product(z_below, away) - product(x_below, along));
    const bool above = is_negative(product(x_above, along) - product(z_above, away));
    if (inside || (side > zero && !below && !above)) {
      out.value = side;
      if constexpr (Out::has_gradient) {
        out.gradient = revolved(axis.direction, away, ScalarTraits<S>::from_unit(along));
      }
      return out;
    }
    const Out rim = from_offset<Out>(
        below ? Vector3<S>{x_below, zero, z_below} : Vector3<S>{x_above, zero, z_above}, zero);
    out.value = rim.value;
    if constexpr (Out::has_gradient) out.gradient = revolved(axis.direction, rim.gradient.x, rim.gradient.z);
    return out;
  }

  // Rounding units: centre sqrt(3)/2, radii and half height 1/sqrt(2), root 1; side: normal (1.2 units of
  // 2^-30, at 16 m) 2.4, product 1/2; rim: root 1, the other one than is nearest 1.
  constexpr Certificate<S> certificate(Reach<S> reach) const {
    const S radius = greatest_of_two(radius_below, radius_above), limit = ScalarTraits<S>::domain();
    const S extent = length_of<S>(sum_of_squares(center.x, center.y, center.z)) +
                     length_of<S>(sum_of_squares(radius, half_height));
    const ConeFrustum again(center, radius_below, radius_above, half_height);
    const bool valid = coordinates_in_domain(center) && within(radius_below, S{}, limit) &&
                       within(radius_above, S{}, limit) && radius > S{} && valid_length(half_height) &&
                       away == again.away && along == again.along;
    return exact_distance<S>(
        reach, extent + ScalarTraits<S>::times(ScalarTraits<S>::rounding_unit(extent), 8), valid, 6);
  }

 private:
  template <int F, class R> static constexpr bool is_negative(WideProduct<F, R> x) { return x.raw < 0; }
  static constexpr bool is_negative(float x) { return x < 0.0f; }
};

}  // namespace nearfield
