// Curves as functions over [0, 1], as tables have them. Exact forms in `double`: never linked into a target.
#pragma once

#include <nearfield/curve/curve.hpp>
#include <nearfield/table/fit.hpp>

namespace nearfield {

// A curve as a function of u in [0, 1], the form in which a table has it: x = start + length u, or for a table over
// the square x = length sqrt(u).
template <class Curve> struct TabulatedForm {
  const Curve& curve;
  double start = 0.0, length = 1.0;
  bool squared = false;
  detail::Breaks kinks = {};

  constexpr detail::Breaks breaks() const { return kinks; }
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

// A curve from 0 to the end of its range, facts().to, as a function over [0, 1]: for tables over r or over ray values,
// whose limit is that end (of a distance: times the influence radius).
template <class Curve> struct OverRange {
  Curve curve;
  constexpr detail::Breaks breaks() const {
    const CurveFacts facts = curve.facts();
    detail::Breaks breaks;
    for (int i = 0; i < facts.break_count; ++i) {
      if (facts.breaks[i] > 0.0) breaks.places[breaks.count++] = facts.breaks[i];
    }
    return breaks;
  }
  constexpr Differentiable operator()(const Differentiable& u) const { return curve(curve.facts().to * u); }
};
template <class Curve> constexpr OverRange<Curve> over_range(Curve curve) { return {curve}; }

namespace detail {

// Where a fraction of the curve's range lies in its tabulated form.
constexpr double tabulated_break(const CurveFacts& facts, double fraction, bool squared) {
  if (squared) return fraction * fraction;
  return facts.antisymmetric ? 2.0 * (fraction - 0.5) : fraction;
}
constexpr Breaks tabulated_breaks(const CurveFacts& facts, bool squared) {
  static_assert(CurveFacts::greatest_break_count <= Breaks::greatest_count, "a curve's breaks fit");
  Breaks breaks;
  for (int i = 0; i < facts.break_count; ++i) {
    const double place = tabulated_break(facts, facts.breaks[i], squared);
    if (place > 0.0) breaks.places[breaks.count++] = place;
  }
  return breaks;
}

}  // namespace detail

// Antisymmetric curves are tabulated over the upper half of their range and mirrored, so that they are symmetric to the
// bit; others over all of it.
template <class Curve> constexpr TabulatedForm<Curve> tabulated_form(const Curve& curve, const CurveFacts& facts, bool squared) {
  const detail::Breaks breaks = detail::tabulated_breaks(facts, squared);
  if (squared) return {curve, 0.0, facts.to, true, breaks};
  if (facts.antisymmetric) return {curve, facts.middle(), facts.to - facts.middle(), false, breaks};
  return {curve, facts.from, facts.to - facts.from, false, breaks};
}

}  // namespace nearfield
