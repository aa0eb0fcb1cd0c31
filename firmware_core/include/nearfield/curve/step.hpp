// Smooth unit step functions: from 0 at -1 to 1 at +1, constant outside (Li, section 2).
// Exact forms in `double`, for baking: never linked into a target.
#pragma once

#include <nearfield/table/bake.hpp>

namespace nearfield::step {

// H_n, the piecewise polynomial step of degree n on n equal pieces, C^(n-1) (Li, equations 5 and 6):
// f_0 = H_0, f_n(t) = (t/n) f_(n-1)(t) + (1 - t/n) f_(n-1)(t - 1), H_n(t) = f_n(n (t + 1) / 2).
template <int n> struct Polynomial {
  static_assert(n >= 1 && n <= 8, "the degree of a polynomial step is 1 to 8");
  static constexpr int continuous_derivatives = n - 1;
  static constexpr bool antisymmetric = true;  // about (0, 1/2)

  constexpr ExactSample operator()(double t) const {
    if (t <= -1.0) return {0.0, 0.0};
    if (t >= 1.0) return {1.0, 0.0};
    const double x = 0.5 * n * (t + 1.0);
    // Row m holds f_m(x - j), j = 0 ... n - m, and their derivatives.
    double value[size_t{n} + 1] = {}, slope[size_t{n} + 1] = {};
    for (int j = 0; j <= n; ++j) value[j] = x - j > 0.0 ? 1.0 : x - j < 0.0 ? 0.0 : 0.5;
    for (int m = 1; m <= n; ++m) {
      for (int j = 0; j <= n - m; ++j) {
        const double weight = (x - j) / m;
        slope[j] = (value[j] - value[j + 1]) / m + weight * slope[j] + (1.0 - weight) * slope[j + 1];
        value[j] = weight * value[j] + (1.0 - weight) * value[j + 1];
      }
    }
    return {value[0], slope[0] * 0.5 * n};
  }
};

template <int n> inline constexpr Polynomial<n> polynomial{};

// A step as a function of u in [0, 1] instead of t in [-1, 1], the form in which it is tabulated.
template <class Step> struct OverUnitInterval {
  Step step;
  constexpr ExactSample operator()(double u) const {
    const ExactSample s = step(2.0 * u - 1.0);
    return {s.value, 2.0 * s.slope};
  }
};
template <class Step> constexpr OverUnitInterval<Step> over_unit_interval(Step step) { return {step}; }

}  // namespace nearfield::step
