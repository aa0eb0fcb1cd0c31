#pragma once

#include <nearfield/number/wide_quotient.hpp>
#include <nearfield/shape/algebraic_bounds.hpp>

namespace nearfield {

// The quartic (|q|^2 + R^2 - r^2)^2 - 4 R^2 (q_x^2 + q_y^2), q = p - centre, of a torus about the local z
// axis, R the ring's radius and r the tube's, as
//   (beta^2 + q_z^2 - r^2) / size,  beta = (|q|^2 - R^2 - r^2) / 2R,
// which is that over 4 R^2 size: near the ring beta is the distance from its cylinder. With size = 2 r its
// gradient on the surface has the length rho / R, rho the distance from the axis. Metres: 1/64 <= r <= R <=
// domain, 1/64 <= size <= 2 domain. beta and the value saturate. Rounding: 2 units in the last place each.
template <class S>
struct AlgebraicTorus {
  using Scalar = S;
  static constexpr Kind kind = Kind::algebraic;
  Vector3<S> center;
  S ring{};
  S tube{};
  S size{};
  Reciprocal<S> inverse_ring;  // of 2 R
  Reciprocal<S> inverse_size;

  constexpr AlgebraicTorus() = default;
  constexpr AlgebraicTorus(const Vector3<S>& place, S ring_radius, S tube_radius, S scale_length)
      : center(place),
        ring(ring_radius),
        tube(tube_radius),
        size(scale_length),
        inverse_ring(reciprocal_of(ring_radius + ring_radius)),
        inverse_size(reciprocal_of(scale_length)) {}
  constexpr AlgebraicTorus(const Vector3<S>& place, S ring_radius, S tube_radius)
      : AlgebraicTorus(place, ring_radius, tube_radius, tube_radius + tube_radius) {}

  template <class Out>
  constexpr Out evaluate(const Vector3<S>& p) const {
    const Vector3<S> q = subtract_in_range(p, center);
    const auto tube_square = square(tube);
    const S beta =
        quotient_of(square(q.x) + square(q.y) + square(q.z) - (square(ring) + tube_square), inverse_ring);
    Out out;
    out.value = quotient_of(square(beta) + square(q.z) - tube_square, inverse_size);
    if constexpr (Out::has_gradient) {
      const Vector3<S> along = {quotient_of(twice(product(beta, q.x)), inverse_ring),
                                quotient_of(twice(product(beta, q.y)), inverse_ring),
                                quotient_of(twice(product(beta, q.z)), inverse_ring)};
      out.gradient = {slope_of(along.x, S{}), slope_of(along.y, S{}), slope_of(along.z, q.z)};
    }
    return out;
  }

  constexpr Certificate<S> certificate(Reach<S> reach) const {
    using T = ScalarTraits<S>;
    using namespace detail;
    const S limit = T::domain();
    const S least = T::half(T::half(T::half(T::half(T::half(T::half(T::one()))))));  // 1/64
    const AlgebraicTorus again(center, ring, tube, size);
    const S far = reach.radius + length_up(center);
    const bool valid = coordinates_in_domain(center) && within(ring, least, limit) &&
                       within(tube, least, ring) && within(size, least, limit + limit) &&
                       inverse_ring == again.inverse_ring && inverse_size == again.inverse_size &&
                       far < T::greatest();
    if (!valid) return {};
    const Rate per_ring = inverse_up(ring + ring), per_size = inverse_up(size);
    // Bounds of |beta| and of the value, the greatest number where they may saturate.
    const auto own_squares = square(ring) + square(tube), far_square = square(far);
    const S beta = sum_up(quotient_of(far_square < own_squares ? own_squares : far_square, inverse_ring),
                          T::times(T::rounding_unit(far), 4));
    const S rough = quotient_of(square(beta) + far_square, inverse_size);
    const S value = sum_up(rough, T::times(T::rounding_unit(rough), 4));
    if (!(beta < T::greatest() && value < T::greatest())) {
      return algebraic_certificate<S>({algebraic_limit<S>(), kNoRateBound, algebraic_limit<S>()}, true);
    }
    const Rate bend = rate_product_up(per_ring, beta);  // beta / 2R
    const Rate span = rate_product_up(per_size, far), slope = bend + bend + kUnitRate;
    const bool bounded = span < kNoRateBound && slope < kNoRateBound;
    const Rate eightfold = bounded ? ScalarTraits<Rate>::multiply_up(slope, span) : kNoRateBound;
    const Rate lipschitz =
        eightfold == kNoRateBound ? kNoRateBound : Rate::from_raw((eightfold.raw() >> 3) + 1);
    // Of beta: rounding 2, R and r by half a unit (r + R) / 2R and beta / 2R; float: of each of its terms.
    S off{}, of_value{};
    if constexpr (T::is_fixed) {
      off = T::times(S::unit_in_last_place(), 4 + (bend.raw() >> Rate::fraction_bits));
      of_value = T::times(S::unit_in_last_place(),
                          3 + (rate_product_up(per_size, value).raw() >> Rate::fraction_bits));
    } else {
      off = roundings(sum_up(beta, quotient_of(far_square + own_squares, inverse_ring)), 2);
      of_value = roundings(sum_up(value, quotient_of(square(tube), inverse_size)), 3);
    }
    const S of_square = product_up(sum_up(sum_up(beta, beta), off), off);
    const S of_tube = product_up(tube, roundings(tube, 2));
    S error = sum_up(T::multiply_up(sum_up(of_square, of_tube), per_size), of_value);
    // Of the centre, sqrt(3)/2 units.
    if (lipschitz != kNoRateBound)
      error = sum_up(error, T::multiply_up(T::times(T::rounding_unit(far), 16), lipschitz));
    return algebraic_certificate<S>({sum_up(value, error), lipschitz, error}, true);
  }

 private:
  // Squares of lengths: 64-bit integers in squared units of the last place, below 2^62 each; floats.
  template <int F>
  static constexpr int64_t square(Fixed<F> x) {
    return int64_t{x.raw()} * x.raw();
  }
  static constexpr float square(float x) { return x * x; }
  template <int F, class R>
  static constexpr int64_t twice(WideProduct<F, R> x) {
    return x.raw * 2;
  }
  static constexpr float twice(float x) { return x + x; }

  // Saturating, also of floats.
  template <class Squares>
  static constexpr S quotient_of(Squares squares, const Reciprocal<S>& length) {
    const S result = quotient_of_products(squares, length), limit = algebraic_limit<S>();
    if constexpr (ScalarTraits<S>::is_fixed)
      return result;
    else
      return clamp(result, -limit, limit);
  }
  // (beta q / R + z) / (8 size): the gradient per 1/16 m.
  constexpr S slope_of(S along, S z) const {
    if constexpr (ScalarTraits<S>::is_fixed) {
      const int64_t sum = int64_t{along.raw()} + z.raw();
      return quotient_of(sum * (int64_t{1} << (S::fraction_bits - 3)), inverse_size);
    } else {
      return quotient_of((along + z) * 0.125f, inverse_size);
    }
  }
  // 1 / x of the x that was rounded, rounded up.
  static constexpr Rate inverse_up(S x) {
    if constexpr (ScalarTraits<S>::is_fixed) {
      return quotient<Rate>(ScalarTraits<S>::one(), reciprocal_of(x - S::unit_in_last_place())) +
             Rate::from_raw(32);
    } else {
      return detail::rate_up_from((1.0f / x) * 1.00001f);
    }
  }
};

}  // namespace nearfield
