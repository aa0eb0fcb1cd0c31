// From distances and rays to algebraic fields, which products and patches are made of: the unit is forgotten.
#pragma once

#include <nearfield/blend/polynomial.hpp>
#include <nearfield/shape/algebraic.hpp>
#include <nearfield/shape/ray.hpp>

namespace nearfield {

// factor * distance, the factor (1/m times whatever the value means) within the domain's number and not 0; a negative
// one turns inside out. Rounding: half a unit in the last place.
template <class S> struct AlgebraicOfDistance {
  using Scalar = S;
  static constexpr Kind kind = Kind::algebraic;
  static constexpr Kind operand_kind = Kind::distance;
  static constexpr int fixed_operand_count = 1;
  S factor{};

  template <class Out> constexpr Out combine(const Out& a) const {
    Out out;
    out.value = detail::saturated(narrow<S>(product(factor, a.value)));
    if constexpr (Out::has_gradient) {
      out.gradient = {scaled_component(a.gradient.x), scaled_component(a.gradient.y), scaled_component(a.gradient.z)};
    }
    return out;
  }
  constexpr Certificate<S> certificate(OperandCertificates<S> of, const TableFacts&, Reach<S>) const {
    using detail::sum_up;
    const S limit = ScalarTraits<S>::domain();
    const Certificate<S>& a = of[0];
    const bool known = a.magnitude > S{} && a.lipschitz != kNoRateBound;
    const S magnitude = sum_up(sum_up(a.magnitude, sum_up(a.erosion, a.inflation)), a.error);
    const AlgebraicBounds<S> distance = {known ? magnitude : algebraic_limit<S>(),
                                         detail::rate_product_up(detail::kGradientLength, a.lipschitz), a.error};
    const bool valid = a.valid && within(factor, -limit, limit) && !(factor == S{});
    return algebraic_certificate(scaled_bounds(distance, factor), valid);
  }

 private:
  constexpr S scaled_component(S a) const {
    return detail::saturated(detail::per_gradient_length<S>(product(factor, a)));
  }
};

// factor * (ray - level), the level within (0, 1]: 1/2 is the soft surface. The factor as above. Rays outside
// 0 ... kGreatestRay count as these ends. Rounding: half a unit in the last place.
template <class S> struct AlgebraicOfRay {
  using Scalar = S;
  static constexpr Kind kind = Kind::algebraic;
  static constexpr Kind operand_kind = Kind::ray;
  static constexpr int fixed_operand_count = 1;
  S level = ScalarTraits<S>::half(ScalarTraits<S>::one());
  S factor = ScalarTraits<S>::one();

  template <class Out> constexpr Out combine(const Out& a) const {
    Out out = a;
    out.value = clamp(a.value, S{}, greatest_ray<S>()) - level;
    return algebraic_scaled(out, factor);
  }
  constexpr Certificate<S> certificate(OperandCertificates<S> of, const TableFacts&, Reach<S>) const {
    const S one = ScalarTraits<S>::one(), limit = ScalarTraits<S>::domain();
    const Certificate<S>& a = of[0];
    const AlgebraicBounds<S> shifted = {greatest_ray<S>(), a.lipschitz,
                                        detail::sum_up(a.error, detail::roundings(greatest_ray<S>(), 1))};
    const bool valid = a.valid && level > S{} && level <= one && within(factor, -limit, limit) && !(factor == S{});
    return algebraic_certificate(scaled_bounds(shifted, factor), valid);
  }
};

}  // namespace nearfield
