// Blending kernels h of the additive blends, B(x, y) = max(x, y) + h(|x - y|), as functions of t / range in [0, 1]
// divided by the range. Exact forms in `double`, for baking: never linked into a target.
#pragma once

#include <nearfield/curve/step.hpp>

namespace nearfield {

// Li's exterior blend Ext_max(delta, epsilon) (Li, equations 18 to 20; f(t) = t^2 / 2 delta + delta / 2):
// h(t) = (S_abs(t) - t) / 2, range delta + epsilon, for a step that is antisymmetric about (0, 1/2).
template <class Step> struct ExteriorKernel {
  Step step;
  double delta = 0.0;    // as a fraction of the range
  double epsilon = 0.0;  // as a fraction of the range

  constexpr ExactSample operator()(double t) const {
    const ExactSample g1 = step((t + delta) / epsilon), g2 = step((t - delta) / epsilon);
    const double d1 = g1.slope / epsilon, d2 = g2.slope / epsilon;
    const double parabola = 0.5 * (t * t / delta + delta), parabola_slope = t / delta;
    const double between = g1.value * (1.0 - g2.value);
    const double value = (g1.value + g2.value - 1.0) * t + between * parabola;
    const double slope = (d1 + d2) * t + (g1.value + g2.value - 1.0) +
                         (d1 * (1.0 - g2.value) - g1.value * d2) * parabola + between * parabola_slope;
    return {0.5 * (value - t), 0.5 * (slope - 1.0)};
  }
};

template <class Step> constexpr double argument_range(const ExteriorKernel<Step>& kernel) { return 1.0 / kernel.delta; }

// ratio = epsilon / delta > 0. Below about 0.05 the step is steeper than a table of 1 KiB can follow.
template <class Step> constexpr ExteriorKernel<Step> exterior(Step step, double ratio) {
  static_assert(Step::antisymmetric, "with other steps h depends on the sign of x - y");
  return {step, 1.0 / (1.0 + ratio), ratio / (1.0 + ratio)};
}

}  // namespace nearfield
