#pragma once

#include <nearfield/shape/algebraic_bounds.hpp>
#include <nearfield/shape/operands.hpp>
#include <nearfield/shape/ray.hpp>

namespace nearfield {

// max(0, d) / R of a distance d, metres: the ray function of a skeleton of any shape (Hsu, equation 5). 0
// without a gradient inside, kGreatestRay at the most. Rounding: that of dividing, half a unit in the last
// place and the value's 2^-30th part.
template <class S>
struct RayOfDistance {
  using Scalar = S;
  static constexpr Kind kind = Kind::ray;
  static constexpr Kind operand_kind = Kind::distance;
  static constexpr int fixed_operand_count = 1;
  RayRadius<S> influence;

  template <class Out>
  constexpr Out combine(const Out& distance) const {
    Out out;
    if (!(distance.value > S{})) return out;
    out.value = least_of_two(quotient<S>(distance.value, influence.inverse), greatest_ray<S>());
    if constexpr (Out::has_gradient) {
      if (out.value < greatest_ray<S>()) out.gradient = scaled(distance.gradient, influence.gradient_factor);
    }
    return out;
  }
  // That of the operand over R. R's own rounding moves the result by as much as kGreatestRay / 2 units of
  // distance do.
  constexpr Certificate<S> certificate(OperandCertificates<S> of, const TableFacts&, Reach<S>) const {
    using T = ScalarTraits<S>;
    const Certificate<S>& distance = of[0];
    const Rate rate = influence.rate();
    Certificate<S> ray;
    ray.valid = distance.valid && influence.valid();
    ray.lipschitz = kNoRateBound;
    if (distance.lipschitz != kNoRateBound && ray.valid) {
      const Rate per_length = Rate::from_raw((rate.raw() >> -kGradientLengthLog2) + 1);
      ray.lipschitz = ScalarTraits<Rate>::multiply_up(distance.lipschitz, per_length);
    }
    S off = distance.error;
    if constexpr (T::is_fixed)
      off = off + T::times(T::rounding_unit(influence.radius), (kGreatestRay + 1) / 2);
    ray.error = T::multiply_up(off, rate) + T::times(T::rounding_unit(greatest_ray<S>()), 2);
    ray.magnitude = greatest_ray<S>();
    return ray;
  }
};

}  // namespace nearfield
