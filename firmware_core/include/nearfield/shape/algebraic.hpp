// Planes and quadrics as polynomials (Sipos; Li): fields of which the zero set is the surface.
#pragma once

#include <nearfield/number/vector.hpp>
#include <nearfield/shape/algebraic_bounds.hpp>

namespace nearfield {

namespace detail {

// 1/16 of an exact sum of products, rounded once: a gradient per metre as one per 1/16 m.
template <class S, int F, class R> constexpr S per_gradient_length(WideProduct<F, R> per_metre) {
  return narrow<S>(WideProduct<F - kGradientLengthLog2, R>{per_metre.raw});
}
template <class S> constexpr float per_gradient_length(float per_metre) { return per_metre * 0.0625f; }

// The length of a vector of coefficients before they were rounded, at most.
template <class S> constexpr S before_rounding(S length) { return sum_up(length, roundings(length, 1)); }

}  // namespace detail

// normal . p - offset. The normal need not be of unit length: 1/m times whatever the value means. Its components and
// the offset are within the domain's number. Rounding: half a unit in the last place.
template <class S> struct AlgebraicPlane {
  using Scalar = S;
  static constexpr Kind kind = Kind::algebraic;
  Vector3<S> normal;
  S offset{};

  template <class Out> constexpr Out evaluate(const Vector3<S>& p) const {
    using T = ScalarTraits<S>;
    Out out;
    out.value = narrow<S>(dot(normal, p) - product(offset, T::one()));
    if constexpr (Out::has_gradient) {
      const auto gradient = [](S slope) { return detail::per_gradient_length<S>(product(slope, T::one())); };
      out.gradient = {gradient(normal.x), gradient(normal.y), gradient(normal.z)};
    }
    return out;
  }
  constexpr Certificate<S> certificate(Reach<S> reach) const {
    using T = ScalarTraits<S>;
    using namespace detail;
    const S slope = length_up(normal);
    const S greatest = sum_up(product_up(slope, reach.radius), absolute(offset));
    S error{};
    // Units: normal sqrt(3)/2 a metre, offset 1/2, value 1/2.
    if constexpr (T::is_fixed) error = units_up<S>(metres_up(reach.radius) + 1);
    else error = roundings(greatest, 2);
    const bool valid = coordinates_in_domain(normal) && within(offset, -T::domain(), T::domain());
    return algebraic_certificate<S>({sum_up(greatest, error), rate_product_up(kGradientLength, before_rounding(slope)), error},
                                    valid && reach.radius < T::greatest());
  }
};

// p^T A p + linear . p + constant, A symmetric with the rows (d.x o.z o.y), (o.z d.y o.x), (o.y o.x d.z): d its
// diagonal, o what is off it (o.x belongs to y z). Planes, balls, cylinders, cones and all other quadrics. All ten
// coefficients are within the domain's number. Rounding: (0.9 R + 0.5) units in the last place at R metres from the
// origin. Fixed: A p + linear saturates on the way.
template <class S> struct Quadric {
  using Scalar = S;
  static constexpr Kind kind = Kind::algebraic;
  Vector3<S> diagonal;
  Vector3<S> off_diagonal;
  Vector3<S> linear;
  S constant{};

  template <class Out> constexpr Out evaluate(const Vector3<S>& p) const {
    const S one = ScalarTraits<S>::one();
    const auto x = dot(row_x(), p), y = dot(row_y(), p), z = dot(row_z(), p);
    const auto bx = product(linear.x, one), by = product(linear.y, one), bz = product(linear.z, one);
    const Vector3<S> outer = {narrow<S>(x + bx), narrow<S>(y + by), narrow<S>(z + bz)};
    Out out;
    out.value = narrow<S>(dot(outer, p) + product(constant, one));
    if constexpr (Out::has_gradient) {
      using detail::per_gradient_length;
      out.gradient = {per_gradient_length<S>(x + x + bx), per_gradient_length<S>(y + y + by),
                      per_gradient_length<S>(z + z + bz)};
    }
    return out;
  }
  constexpr Certificate<S> certificate(Reach<S> reach) const {
    using T = ScalarTraits<S>;
    using namespace detail;
    const S curvature = greatest_row();  // bounds A's greatest eigenvalue
    const S slope = length_up(linear), bent = product_up(curvature, reach.radius);
    const S greatest = sum_up(product_up(sum_up(bent, slope), reach.radius), absolute(constant));
    S error{};
    // Units at R metres: A 1.5 R^2, linear 0.87 R, constant 1/2, inner roundings 0.87 R, outer 1/2.
    if constexpr (T::is_fixed) {
      const int64_t metres = metres_up(reach.radius);
      error = units_up<S>((3 * metres * metres + 4 * metres + 2) / 2 + 1);
    } else {
      error = roundings(greatest, 2);
    }
    const bool saturates = !(sum_up(bent, slope) < algebraic_limit<S>());
    const S limit = T::domain();
    const bool valid = coordinates_in_domain(diagonal) && coordinates_in_domain(off_diagonal) &&
                       coordinates_in_domain(linear) && within(constant, -limit, limit);
    return algebraic_certificate<S>({saturates ? algebraic_limit<S>() : sum_up(greatest, error),
                                     rate_product_up(kGradientLength, sum_up(sum_up(bent, bent), before_rounding(slope))), error},
                                    valid && reach.radius < T::greatest());
  }

 private:
  constexpr Vector3<S> row_x() const { return {diagonal.x, off_diagonal.z, off_diagonal.y}; }
  constexpr Vector3<S> row_y() const { return {off_diagonal.z, diagonal.y, off_diagonal.x}; }
  constexpr Vector3<S> row_z() const { return {off_diagonal.y, off_diagonal.x, diagonal.z}; }
  static constexpr S sum_of_magnitudes(const Vector3<S>& row) {
    return detail::sum_up(detail::sum_up(absolute(row.x), absolute(row.y)), absolute(row.z));
  }
  constexpr S greatest_row() const {
    const S x = sum_of_magnitudes(row_x()), y = sum_of_magnitudes(row_y()), z = sum_of_magnitudes(row_z());
    const S greatest = greatest_of_two(x, greatest_of_two(y, z));
    // Of coefficients before they were rounded: half a unit each.
    return detail::sum_up(greatest, detail::roundings(greatest, 2));
  }
};

}  // namespace nearfield
