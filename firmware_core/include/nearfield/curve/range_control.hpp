// Hsu's blending range control: a remap of the distance before any potential.
// Exact forms in `double`, for baking: never linked into a target.
#pragma once

#include <nearfield/curve/potential.hpp>

namespace nearfield::potential {

// P(T(d; w1, w2)) with T = 1 beyond (1 + w1)/2, (d - 1/2)/w1 + 1/2 down to 1/2, A d^2 + B d + C down to (1 - w2)/2
// and 0 below; A = 2 (1/w1 - 1/w2)/w2, B = 1/w1 - A, C = 1/2 - B/2 - A/4. The surface P = P(1/2) stays where it is,
// the influence ends at (1 + w1)/2.
template <class Potential> struct RangeControlled {
  Potential potential;
  double w1 = 1.0;  // blending range outside the surface, > 0
  double w2 = 1.0;  // inside, 0 < w2 <= 1, w2 <= w1

  constexpr Differentiable remapped(const Differentiable& d) const {
    if (d.value > 0.5 * (1.0 + w1)) return 1.0;
    if (d.value >= 0.5) return (d - 0.5) * (1.0 / w1) + 0.5;
    if (d.value < 0.5 * (1.0 - w2)) return 0.0;
    const double a = 2.0 * (1.0 / w1 - 1.0 / w2) / w2, b = 1.0 / w1 - a, c = 0.5 - 0.5 * b - 0.25 * a;
    return (a * d + b) * d + c;
  }
  constexpr Differentiable operator()(const Differentiable& d) const { return potential(remapped(d)); }
  constexpr CurveFacts facts() const {
    CurveFacts facts = potential.facts();
    facts.to = 0.5 * (1.0 + w1);
    facts.antisymmetric = facts.antisymmetric && w1 == 1.0 && w2 == 1.0;
    facts.centred = facts.centred && w1 == 1.0;
    // T has kinks where it meets 0 and 1; only a potential that is flat there hides them.
    if (facts.continuous_derivatives > 1) facts.continuous_derivatives = 1;
    if (facts.vanishing_derivatives < 1 && facts.continuous_derivatives > 0) facts.continuous_derivatives = 0;
    facts.break_count = 0;
    facts.add_break(0.5 * (1.0 - w2) / facts.to);
    facts.add_break(0.5 / facts.to);
    return facts;
  }
  constexpr const char* problem() const {
    if (!(w1 > 0.0 && w1 <= 3.0)) return "w1 is above 0, at most 3";
    if (!(w2 > 0.0 && w2 <= 1.0 && w2 <= w1)) return "w2 is above 0, at most 1 and at most w1";
    if (potential.problem() != nullptr) return potential.problem();
    return potential.facts().end_jump > 0.0 ? "a potential that misses 1 or 0 at its ends has no range control" : nullptr;
  }
};

template <class Potential> constexpr RangeControlled<Potential> with_range_control(Potential potential, double w1, double w2) {
  return {potential, w1, w2};
}

}  // namespace nearfield::potential
