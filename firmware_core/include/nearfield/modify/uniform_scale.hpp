// The same field at another size about its local origin.
#pragma once

#include <nearfield/modify/frame.hpp>
#include <nearfield/shape/algebraic_bounds.hpp>

namespace nearfield {

// Lengths inside times `factor`, 1/8 to 8, are lengths outside: p is seen at p / factor, distances come back times the
// factor, gradients of all other kinds divided by it. Shrinking needs room: no point may leave the number range inside.
template <class S> struct UniformScale {
  using Scalar = S;
  S factor = ScalarTraits<S>::one();
  S inverse = ScalarTraits<S>::one();  // 1 / factor, rounded to nearest

  constexpr UniformScale() = default;
  constexpr explicit UniformScale(S times) : factor(times), inverse(inverse_of(times)) {}

  // In range when valid() and reach() says so. Rounding: half a unit by component.
  constexpr Vector3<S> to_inner(const Vector3<S>& p) const {
    return {narrow_in_range<S>(product(p.x, inverse)), narrow_in_range<S>(product(p.y, inverse)),
            narrow_in_range<S>(product(p.z, inverse))};
  }
  // What was evaluated there. Rounding: half a unit; gradients of distances as they are, of others they may saturate.
  template <class Out> constexpr Out to_outer(Kind kind, const Out& inside) const {
    Out out = inside;
    if (kind == Kind::distance) {
      out.value = narrow_in_range<S>(product(inside.value, factor));
    } else if constexpr (Out::has_gradient) {
      out.gradient = {narrow<S>(product(inside.gradient.x, inverse)), narrow<S>(product(inside.gradient.y, inverse)),
                      narrow<S>(product(inside.gradient.z, inverse))};
    }
    return out;
  }

  constexpr bool valid() const {
    using T = ScalarTraits<S>;
    const S eighth = T::half(T::half(T::half(T::one())));
    return within(factor, eighth, T::times(T::one(), 8)) && inverse == inverse_of(factor);
  }
  // Of the points inside; the greatest number where they do not fit.
  constexpr Reach<S> reach(Reach<S> outer) const {
    return {detail::sum_up(detail::product_up(outer.radius, inverse), ScalarTraits<S>::rounding_unit(outer.radius))};
  }
  // A ball that holds, inside, what `outer` holds outside.
  constexpr Ball<S> to_inner(const Ball<S>& outer) const {
    const Reach<S> inner = reach(Reach<S>{outer.reach});
    return {detail::sum_up(detail::product_up(outer.radius, inverse), moved_inside(Reach<S>{outer.reach})), inner.radius};
  }

  // Rounding units: factor and inverse 1/2 each, of a point inside sqrt(3)/2, of a distance 1/2.
  constexpr Certificate<S> certificate(const Certificate<S>& of, Kind kind, Reach<S> outer) const {
    using T = ScalarTraits<S>;
    using detail::product_up;
    using detail::sum_up;
    Certificate<S> scaled = of;
    scaled.valid = of.valid && valid() && reach(outer).radius < T::greatest();
    if (!scaled.valid) return scaled;
    const bool rated = of.lipschitz != kNoRateBound;
    if (kind == Kind::distance) {
      const S greatest_value = sum_up(sum_up(of.magnitude, of.error), sum_up(of.erosion, of.inflation));
      scaled.magnitude = product_up(factor, of.magnitude);
      scaled.erosion = product_up(factor, of.erosion);
      scaled.inflation = product_up(factor, of.inflation);
      const S of_value = T::times(T::rounding_unit(product_up(factor, greatest_value)), halves_of(greatest_value));
      scaled.error = sum_up(product_up(factor, of.error), sum_up(T::multiply_up(moved_outside(outer), of.lipschitz), of_value));
      const S outside = sum_up(sum_up(scaled.magnitude, scaled.error), sum_up(scaled.erosion, scaled.inflation));
      scaled.valid = rated && outside < T::greatest();
    } else {
      const S lengths = T::times(moved_inside(outer), 1 << -kGradientLengthLog2);
      scaled.lipschitz = detail::rate_product_up(of.lipschitz, sum_up(inverse, T::times(T::rounding_unit(inverse), 9)));
      scaled.error = rated ? sum_up(of.error, T::multiply_up(lengths, of.lipschitz)) : T::greatest();
    }
    return scaled;
  }

 private:
  static constexpr S inverse_of(S factor) {
    if constexpr (ScalarTraits<S>::is_fixed) {
      ArithmeticStatus ignored;
      return divide(ScalarTraits<S>::one(), factor, ignored);
    } else {
      return factor > 0.0f ? 1.0f / factor : 0.0f;
    }
  }
  // How far from its place a point may be computed, in metres inside and in metres outside: the roundings of factor and
  // inverse move it by its distance from the origin times half a unit each. Float: three relative roundings, 3/8 of a unit.
  constexpr S moved_inside(Reach<S> outer) const {
    using T = ScalarTraits<S>;
    const S unit = T::rounding_unit(reach(outer).radius);
    if constexpr (!T::is_fixed) return unit;
    else return T::times(unit, 2 + half_of(outer.radius, int64_t{inverse.raw()} * inverse.raw() / T::one().raw() + T::one().raw()));
  }
  constexpr S moved_outside(Reach<S> outer) const {
    using T = ScalarTraits<S>;
    const S unit = T::rounding_unit(outer.radius);
    if constexpr (!T::is_fixed) return unit;
    else return T::times(unit, 1 + half_of(T::one(), factor.raw() * int64_t{2}) + half_of(outer.radius, int64_t{factor.raw()} + inverse.raw()));
  }
  // Half of metres * raw / one, rounded up.
  static constexpr int half_of(S metres, int64_t raw) {
    constexpr int64_t one = ScalarTraits<S>::one().raw();
    return static_cast<int>((int64_t{metres.raw()} / 2 + 1) * (raw / 2 + 1) / (one / 2) / one) + 1;
  }
  // Units of a value's last place by which the factor's rounding and its own may change it.
  static constexpr int halves_of(S greatest_value) {
    if constexpr (!ScalarTraits<S>::is_fixed) return 1;
    else return half_of(greatest_value, ScalarTraits<S>::one().raw()) + 1;
  }
};

}  // namespace nearfield
