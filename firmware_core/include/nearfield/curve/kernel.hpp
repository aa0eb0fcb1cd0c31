// Blending kernels h of the additive blends, B(x, y) = max(x, y) + h(|x - y|), as functions of t / range in [0, 1]
// divided by the range. Exact forms in `double`, for baking: never linked into a target.
#pragma once

#include <nearfield/curve/step.hpp>
#include <nearfield/table/bake.hpp>

namespace nearfield {

// A kernel whose h differs with the sign of x - y, for Sides::differ: lower half x >= y, upper half x < y.
template <class Kernel> struct TwoSided {
  Kernel kernel;

  constexpr Differentiable operator()(const Differentiable& u) const {
    return u.value < 0.5 ? kernel.at(2.0 * u, true) : kernel.at(2.0 * u - 1.0, false);
  }
  constexpr detail::Breaks breaks() const {
    const detail::Breaks lower = kernel.breaks(true), upper = kernel.breaks(false);
    detail::Breaks both;
    for (int i = 0; i < lower.count; ++i) both.add(0.5 * lower.places[i]);
    for (int i = 0; i < upper.count; ++i) both.add(0.5 + 0.5 * upper.places[i]);
    return both;
  }
};
template <class Kernel> constexpr TwoSided<Kernel> two_sided(const Kernel& kernel) { return {kernel}; }
template <class Kernel> constexpr double argument_range(const TwoSided<Kernel>& both) { return argument_range(both.kernel); }

namespace detail {

// What a table cannot hold: of a kernel that is one-sided although its sides differ.
inline constexpr double kUnusable = 4.0;

// Adds the places where the pieces of a step meet that rises within epsilon of `center`.
constexpr void add_breaks(Breaks& breaks, const CurveFacts& step, double center, double epsilon) {
  breaks.add(center - epsilon);
  for (int i = 0; i < step.break_count; ++i) breaks.add(center + epsilon * (2.0 * step.breaks[i] - 1.0));
  if (step.middle_jump > 0.0) breaks.add(center);
  breaks.add(center + epsilon);
}

}  // namespace detail

// Li's exterior blend Ext_max(delta, epsilon) (Li, equations 18 to 20; f(t) = t^2 / 2 delta + delta / 2):
// h = (S_abs(t) - |t|) / 2, range delta + epsilon.
template <class Step> struct ExteriorKernel {
  Step step;
  double delta = 0.0;    // as a fraction of the range
  double epsilon = 0.0;  // as a fraction of the range
  bool antisymmetric = true;

  constexpr Differentiable operator()(const Differentiable& t) const {
    return antisymmetric ? at(t, true) : Differentiable(detail::kUnusable);
  }
  // t = |x - y|.
  constexpr Differentiable at(const Differentiable& t, bool first_decides) const {
    const double sign = first_decides ? 1.0 : -1.0;
    const Differentiable g1 = step((sign * t + delta) * (1.0 / epsilon)), g2 = step((sign * t - delta) * (1.0 / epsilon));
    const Differentiable parabola = (0.5 / delta) * square(t) + 0.5 * delta;
    const Differentiable shares = first_decides ? g1 + g2 - 2.0 : -(g1 + g2);
    return 0.5 * (shares * t + g1 * (1.0 - g2) * parabola);
  }
  // Where the pieces of g1 and g2 meet.
  constexpr detail::Breaks breaks(bool first_decides = true) const {
    const double rising = first_decides ? epsilon : -epsilon;
    detail::Breaks places;
    detail::add_breaks(places, curve_facts(step), delta, rising);
    detail::add_breaks(places, curve_facts(step), -delta, rising);
    return places;
  }
};

template <class Step> constexpr double argument_range(const ExteriorKernel<Step>& kernel) { return 1.0 / kernel.delta; }

// ratio = epsilon / delta > 0. Below about 0.05 the step is steeper than a table of 1 KiB can follow. The range is that
// times delta. A step that is not antisymmetric needs two_sided(): by itself its table is marked unusable.
template <class Step> constexpr ExteriorKernel<Step> exterior(Step step, double ratio) {
  return {step, 1.0 / (1.0 + ratio), ratio / (1.0 + ratio), curve_facts(step).antisymmetric};
}

// Li's interior blend Int_max(epsilon) (Li, equation 24): h = -t mu(-t / epsilon) where x >= y, -t (1 - mu(t / epsilon)) where
// x < y; the same for antisymmetric steps. Range epsilon.
template <class Step> struct InteriorKernel {
  Step step;
  bool antisymmetric = true;

  constexpr Differentiable operator()(const Differentiable& t) const {
    return antisymmetric ? at(t, true) : Differentiable(detail::kUnusable);
  }
  constexpr Differentiable at(const Differentiable& t, bool first_decides) const {
    return first_decides ? -1.0 * t * step(-1.0 * t) : t * (step(t) - 1.0);
  }
  constexpr detail::Breaks breaks(bool first_decides = true) const {
    detail::Breaks places;
    detail::add_breaks(places, curve_facts(step), 0.0, first_decides ? -1.0 : 1.0);
    return places;
  }
};
template <class Step> constexpr InteriorKernel<Step> interior(Step step) { return {step, curve_facts(step).antisymmetric}; }

// Log-sum-exp of two operands (AC): ln(1 + e^(-p t)) / p. Cut off at the range 18 / p, where it is below 2^-30 of it.
struct LogSumExpKernel {
  static constexpr double range_times_sharpness = 18.0;  // of p

  constexpr Differentiable operator()(const Differentiable& u) const {
    return log(1.0 + exp(-range_times_sharpness * u)) * (1.0 / range_times_sharpness);
  }
};

// Polynomial smooth maxima of range k: (k - t)^2 / 4k, and (k - t)^3 / 6k^2, whose second derivative is continuous.
struct QuadraticKernel {
  constexpr Differentiable operator()(const Differentiable& u) const { return 0.25 * square(1.0 - u); }
};
struct CubicKernel {
  constexpr Differentiable operator()(const Differentiable& u) const {
    return (1.0 / 6.0) * (1.0 - u) * square(1.0 - u);
  }
};

}  // namespace nearfield
