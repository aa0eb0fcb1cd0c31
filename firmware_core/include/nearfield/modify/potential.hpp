// Intensities of distances and rays: F = weight * P(x / limit), P a potential tabulated over r (KW; Hsu). One skeleton
// of several members (KW's groups) is the potential of their union.
#pragma once

#include <nearfield/shape/operands.hpp>
#include <nearfield/shape/soft.hpp>

namespace nearfield {

// The operand x: a distance, limit the influence radius in metres; or a ray value, limit 1, or where Hsu's range control
// ends if P is controlled. P(0) at and below x = 0, without a gradient; exactly 0 from the limit on.
// lipschitz and error bound the operand's; the certificate is valid only if its operand's are no greater.
template <class S, Kind of> struct PotentialOf {
  static_assert(of == Kind::distance || of == Kind::ray, "potentials are of distances and rays");
  using Scalar = S;
  static constexpr Kind kind = Kind::intensity;
  static constexpr Kind operand_kind = of;
  static constexpr int fixed_operand_count = 1;
  static constexpr bool samples_table = true;
  static constexpr bool has_highest = true;
  ArgumentScale<S> scale;
  S weight{};           // may be negative
  S gradient_factor{};  // of distances R0 / limit, R0 = 1/16 m (sample.hpp); of rays 1 / limit
  Rate lipschitz;
  S error{};

  constexpr PotentialOf() = default;
  constexpr PotentialOf(S greatest_operand, S potential_weight, Rate operand_lipschitz, S operand_error)
      : scale(ArgumentScale<S>::of(greatest_operand)), weight(potential_weight),
        gradient_factor(factor_of(greatest_operand)), lipschitz(operand_lipschitz), error(operand_error) {}
  // Of an operand with this certificate.
  constexpr PotentialOf(S greatest_operand, S potential_weight, const Certificate<S>& operand)
      : PotentialOf(greatest_operand, potential_weight, operand.lipschitz, operand.error) {}

  template <class Out, class View> constexpr Out combine(const Out& x, const View& potential) const {
    Out out;
    if (!(x.value > S{})) {
      out.value = strength(potential, {});
      return out;
    }
    if (!scale.contains(quantity(x.value))) return out;
    const TableSample<S> p = sample_table<Out::has_gradient>(potential, scale.argument(quantity(x.value)));
    out.value = narrow<S>(product(weight, p.value));
    if constexpr (Out::has_gradient) {
      const S steepness = narrow<S>(product(narrow<S>(product(p.slope, gradient_factor)), weight));
      out.gradient = scaled(x.gradient, steepness);
    }
    return out;
  }

  template <class View>
  constexpr Highest<S> highest(const Highest<S>& x, const Ball<S>& ball, const View& potential) const {
    using T = ScalarTraits<S>;
    if (lipschitz == kNoRateBound) return {weight > S{} ? weight : S{}};
    // The rate of rays is per 1/16 m. Saturating last: no operand is as large as that.
    const S moved = T::multiply_up(ball.radius, lipschitz);
    const S change = (of == Kind::distance ? moved : T::times(moved, 1 << -kGradientLengthLog2)) + error;
    return combine(Highest<S>{detail::towards_highest(x.value, change, weight)}, potential);
  }

  constexpr Certificate<S> certificate(OperandCertificates<S> operands, const TableFacts& facts, Reach<S>) const {
    using T = ScalarTraits<S>;
    const PotentialOf again(scale.limit, weight, lipschitz, error);
    const S greatest = T::domain();
    Certificate<S> result;
    result.valid = operands[0].valid && scale.consistent() && scale.limit <= greatest &&
                   within(weight, -greatest, greatest) && gradient_factor == again.gradient_factor &&
                   gradient_factor > S{} && gradient_factor < T::greatest() && lipschitz >= operands[0].lipschitz &&
                   error >= operands[0].error;
    // The limit itself is rounded by half a unit: x / limit is as if x were off by that.
    const S off = operands[0].error + T::rounding_unit(scale.limit);
    const Rate per_length = detail::rate_up(gradient_factor + T::rounding_unit(gradient_factor));
    const Rate change = detail::multiply_rates(per_length, operands[0].lipschitz);
    const S units_of_factor = of == Kind::distance ? T::times(off, 1 << -kGradientLengthLog2) : off;
    detail::state_potential_bounds(result, detail::PotentialBounds::of(facts, weight), weight, change, units_of_factor,
                                   per_length);
    return result;
  }

 private:
  template <class View> constexpr S strength(const View& potential, typename TableArgument<S>::type argument) const {
    return narrow<S>(product(weight, sample_table<false>(potential, argument).value));
  }
  template <int F, class R> static constexpr uint32_t quantity(Fixed<F, R> x) { return static_cast<uint32_t>(x.raw()); }
  static constexpr float quantity(float x) { return x; }
  static constexpr S factor_of(S limit) {
    if constexpr (of == Kind::ray) {
      return detail::inverse_of(limit);
    } else if constexpr (ScalarTraits<S>::is_fixed) {
      ArithmeticStatus ignored;
      return divide(S::from_raw(ScalarTraits<S>::one().raw() >> -kGradientLengthLog2), limit, ignored);
    } else {
      return 0.0625f * detail::inverse_of(limit);
    }
  }
};

template <class S> using PotentialOfDistance = PotentialOf<S, Kind::distance>;
template <class S> using PotentialOfRay = PotentialOf<S, Kind::ray>;

}  // namespace nearfield
