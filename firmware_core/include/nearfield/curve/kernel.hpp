// Blending kernels h of the additive blends, B(x, y) = max(x, y) + h(|x - y|), as functions of t / range in [0, 1]
// divided by the range. Exact forms in `double`, for baking: never linked into a target.
#pragma once

#include <nearfield/curve/step.hpp>
#include <nearfield/table/bake.hpp>

namespace nearfield {

// Li's exterior blend Ext_max(delta, epsilon) (Li, equations 18 to 20; f(t) = t^2 / 2 delta + delta / 2):
// h(t) = (S_abs(t) - t) / 2, range delta + epsilon, for a step that is antisymmetric about (0, 1/2).
template <class Step> struct ExteriorKernel {
  Step step;
  double delta = 0.0;    // as a fraction of the range
  double epsilon = 0.0;  // as a fraction of the range
  bool antisymmetric = true;

  constexpr Differentiable operator()(const Differentiable& t) const {
    if (!antisymmetric) return 4.0;  // outside what a table can hold
    const Differentiable g1 = step((t + delta) * (1.0 / epsilon)), g2 = step((t - delta) * (1.0 / epsilon));
    const Differentiable parabola = (0.5 / delta) * square(t) + 0.5 * delta;
    return 0.5 * ((g1 + g2 - 2.0) * t + g1 * (1.0 - g2) * parabola);
  }
};

template <class Step> constexpr double argument_range(const ExteriorKernel<Step>& kernel) { return 1.0 / kernel.delta; }

// ratio = epsilon / delta > 0. Below about 0.05 the step is steeper than a table of 1 KiB can follow.
// With a step that is not antisymmetric h would depend on the sign of x - y: its table is marked unusable.
template <class Step> constexpr ExteriorKernel<Step> exterior(Step step, double ratio) {
  return {step, 1.0 / (1.0 + ratio), ratio / (1.0 + ratio), curve_facts(step).antisymmetric};
}

}  // namespace nearfield
