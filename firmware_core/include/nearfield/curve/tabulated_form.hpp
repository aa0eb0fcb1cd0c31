// Curves as functions over [0, 1], as tables have them. Exact forms in `double`: never linked into a target.
#pragma once

#include <nearfield/curve/curve.hpp>

namespace nearfield {

// A curve as a function of u in [0, 1], the form in which a table has it: x = start + length u, or for a table over
// the square x = length sqrt(u).
template <class Curve> struct TabulatedForm {
  const Curve& curve;
  double start = 0.0, length = 1.0;
  bool squared = false;

  constexpr Differentiable operator()(const Differentiable& u) const {
    return squared ? of_square(u) : curve(start + length * u);
  }

 private:
  // d/du of P(length sqrt(u)). Towards u = 0, P' / r tends to P'' and the second derivative to a constant, if at all.
  constexpr Differentiable of_square(const Differentiable& u) const {
    const double root = exact_sqrt(u.value > 0.0 ? u.value : 0.0), r = root > 1e-4 ? root : 1e-4;
    const Differentiable at_root = curve(Differentiable(length * root, length, 0.0));
    const Differentiable near = root > 1e-4 ? at_root : curve(Differentiable(length * r, length, 0.0));
    const double first = root > 1e-6 ? at_root.first / (2.0 * root) : near.first / (2.0 * r);
    return chain(u, at_root.value, first, (near.second - near.first / r) / (4.0 * r * r));
  }
};

// A potential over u = r^2, for tables that squared distances index without a square root.
template <class Curve> struct OverSquare {
  Curve curve;
  constexpr Differentiable operator()(const Differentiable& u) const {
    return TabulatedForm<Curve>{curve, 0.0, 1.0, true}(u);
  }
};
template <class Curve> constexpr OverSquare<Curve> over_square(Curve curve) { return {curve}; }

// Antisymmetric curves are tabulated over the upper half of their range and mirrored, so that they are symmetric to the
// bit; others over all of it.
template <class Curve> constexpr TabulatedForm<Curve> tabulated_form(const Curve& curve, const CurveFacts& facts, bool squared) {
  if (squared) return {curve, 0.0, facts.to, true};
  if (facts.antisymmetric) return {curve, facts.middle(), facts.to - facts.middle(), false};
  return {curve, facts.from, facts.to - facts.from, false};
}

}  // namespace nearfield
