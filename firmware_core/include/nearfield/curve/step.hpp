// Smooth unit step functions: from 0 at -1 to 1 at +1, constant outside (Li, section 2).
// Exact forms in `double`, for baking: never linked into a target.
#pragma once

#include <nearfield/curve/curve.hpp>

namespace nearfield::step {

// What all steps share.
constexpr CurveFacts step_facts(int continuous_derivatives, bool antisymmetric) {
  CurveFacts facts;
  facts.from = -1.0;
  facts.before = 0.0;
  facts.after = 1.0;
  facts.continuous_derivatives = continuous_derivatives;
  facts.vanishing_derivatives = continuous_derivatives > 0 ? continuous_derivatives : 0;
  facts.direction = Direction::rising;
  facts.antisymmetric = facts.centred = antisymmetric;
  return facts;
}

// H_0: 0, 1/2 at 0, 1. Every table of it is wrong by 1/2 at 0 itself.
struct Heaviside {
  static constexpr const char* name = "heaviside";
  constexpr Differentiable operator()(const Differentiable& t) const { return t.value < 0 ? 0.0 : t.value > 0 ? 1.0 : 0.5; }
  constexpr CurveFacts facts() const {
    CurveFacts facts = step_facts(-1, true);
    facts.middle_jump = 0.5;
    return facts;
  }
  static constexpr Heaviside from(const ParameterValues*) { return {}; }
  constexpr const char* problem() const { return nullptr; }
};

// H_n, the piecewise polynomial step of degree n on n equal pieces, C^(n-1) (Li, equations 5 and 6):
// f_0 = H_0, f_n(t) = (t/n) f_(n-1)(t) + (1 - t/n) f_(n-1)(t - 1), H_n(t) = f_n(n (t + 1) / 2).
struct Polynomial {
  static constexpr const char* name = "polynomial";
  static constexpr CurveParameter parameters[] = {integer_parameter("n", "degree", 1, 8, 3)};
  int n = 3;

  constexpr Differentiable operator()(const Differentiable& t) const {
    if (t.value <= -1.0) return 0.0;
    if (t.value >= 1.0) return 1.0;
    const Differentiable x = (0.5 * n) * (t + 1.0);
    // Row m holds f_m(x - j), j = 0 ... n - m.
    Differentiable f[9] = {};
    for (int j = 0; j <= n; ++j) f[j] = x.value > j ? 1.0 : x.value < j ? 0.0 : 0.5;
    for (int m = 1; m <= n; ++m) {
      for (int j = 0; j <= n - m; ++j) {
        const Differentiable weight = (x - j) * (1.0 / m);
        f[j] = f[j + 1] + weight * (f[j] - f[j + 1]);
      }
    }
    return f[0];
  }
  constexpr CurveFacts facts() const {
    CurveFacts facts = step_facts(n - 1, true);
    for (int i = 1; i < n; ++i) facts.add_break(static_cast<double>(i) / n);
    return facts;
  }
  static constexpr Polynomial from(const ParameterValues* values) { return {values[0].integer()}; }
  constexpr const char* problem() const { return n >= 1 && n <= 8 ? nullptr : "n is 1 to 8"; }
};
template <int n> inline constexpr Polynomial polynomial{n};

// B_m, the normalised integral of the uniform B-spline of order m on [-1, 1] (Li, equation 7), by truncated powers:
// sum of (-1)^j C(m, j) (x - j)_+^m / m!, x = m (t + 1) / 2; the upper half by symmetry, where the sum would cancel.
struct BSplineIntegral {
  static constexpr const char* name = "bspline_integral";
  static constexpr CurveParameter parameters[] = {integer_parameter("m", "order of the B-spline", 1, 8, 3)};
  int m = 3;

  constexpr Differentiable operator()(const Differentiable& t) const {
    if (t.value <= -1.0) return 0.0;
    if (t.value >= 1.0) return 1.0;
    return t.value > 0.0 ? 1.0 - lower_half((0.5 * m) * (1.0 - t)) : lower_half((0.5 * m) * (1.0 + t));
  }
  constexpr CurveFacts facts() const { return Polynomial{m}.facts(); }
  static constexpr BSplineIntegral from(const ParameterValues* values) { return {values[0].integer()}; }
  constexpr const char* problem() const { return m >= 1 && m <= 8 ? nullptr : "m is 1 to 8"; }

 private:
  constexpr Differentiable lower_half(const Differentiable& x) const {
    Differentiable sum = 0.0;
    double binomial = 1.0;
    for (int j = 0; j < m && x.value > j; ++j) {
      const Differentiable rest = x - j;
      Differentiable power = rest;
      for (int i = 2; i <= m; ++i) power = power * rest * (1.0 / i);
      sum = sum + binomial * power;
      binomial *= -static_cast<double>(m - j) / (j + 1);
    }
    return sum;
  }
};

// The general iteration of rising cutoff functions (Li, equation 14): mu_n = sin(theta_(n-1)), theta_k = (pi/2) mu_k^2,
// from any non-decreasing theta_0 on [-1, 1] with theta_0(t) + theta_0(-t) = pi/2 and theta_0(-1) = 0.
// squared: mu_n^2, which is antisymmetric.
template <class Theta> struct IteratedCutoff {
  Theta theta;
  int n = 1;
  bool squared = false;
  int theta_continuous_derivatives = 0;  // of theta_0 on the whole line

  constexpr Differentiable operator()(const Differentiable& t) const {
    if (t.value <= -1.0) return 0.0;
    if (t.value >= 1.0) return 1.0;
    Differentiable angle = theta(t);
    for (int k = 1; k < n; ++k) angle = (0.5 * kPi) * square(sin(angle));
    const Differentiable root = sin(angle);
    return squared ? square(root) : root;
  }
  // Each iteration doubles the order of contact with 0 and 1; the angle's own breaks stay within.
  constexpr CurveFacts facts() const {
    int order = theta_continuous_derivatives + 1;
    for (int k = squared ? 0 : 1; k < n; ++k) order *= 2;
    return step_facts(order - 1, squared);
  }
  constexpr const char* problem() const {
    if (n < 1 || n > 5) return "n is 1 to 5";
    for (int i = 0; i <= 64; ++i) {
      const double t = i * (1.0 / 64);
      const Differentiable above = theta(Differentiable::argument(t)), below = theta(Differentiable::argument(-t));
      if (magnitude(above.value + below.value - 0.5 * kPi) > 1e-9) return "theta(t) + theta(-t) is pi / 2";
      if (above.first < -1e-9 || below.first < -1e-9) return "theta does not decrease";
    }
    return magnitude(theta(Differentiable(-1.0)).value) < 1e-9 ? nullptr : "theta is 0 at -1";
  }
};

// theta_0 = (pi/4)(1 + t), the straight start (Li, equation 15).
struct LinearAngle {
  constexpr Differentiable operator()(const Differentiable& t) const { return (0.25 * kPi) * (1.0 + t); }
};
// theta_0 = (pi/2) mu for any antisymmetric step mu.
template <class Step> struct AngleOfStep {
  Step step;
  constexpr Differentiable operator()(const Differentiable& t) const { return (0.5 * kPi) * step(t); }
};

// R_n (Li, equation 16): 2^(n-1) - 1 derivatives vanish at both ends; not antisymmetric. Squared it is antisymmetric, for
// balanced blends, and 2^n - 1 derivatives vanish at both ends.
template <bool squared> struct RisingCutoffPower {
  static constexpr const char* name = squared ? "rising_cutoff_squared" : "rising_cutoff";
  static constexpr CurveParameter parameters[] = {integer_parameter("n", "iterations", 1, 5, 2)};
  int n = 2;
  constexpr IteratedCutoff<LinearAngle> iteration() const { return {{}, n, squared, 0}; }
  constexpr Differentiable operator()(const Differentiable& t) const { return iteration()(t); }
  constexpr CurveFacts facts() const { return iteration().facts(); }
  static constexpr RisingCutoffPower from(const ParameterValues* values) { return {values[0].integer()}; }
  constexpr const char* problem() const { return iteration().problem(); }
};
using RisingCutoff = RisingCutoffPower<false>;
using RisingCutoffSquared = RisingCutoffPower<true>;

// The iteration from theta_0 = (pi/2) H_start, a start of one's own for people who have no callable at hand.
struct CutoffFromPolynomial {
  static constexpr const char* name = "cutoff_from_polynomial";
  static constexpr CurveParameter parameters[] = {integer_parameter("n", "iterations", 1, 5, 2),
                                                  integer_parameter("start", "degree of the polynomial step to start from", 1, 4, 2)};
  int n = 2;
  int start = 2;
  constexpr IteratedCutoff<AngleOfStep<Polynomial>> iteration() const { return {{{start}}, n, false, start - 1}; }
  constexpr Differentiable operator()(const Differentiable& t) const { return iteration()(t); }
  constexpr CurveFacts facts() const {
    // At its own breaks the start is C^(start - 1), whatever the iterations do at the ends.
    CurveFacts facts = iteration().facts();
    if (start > 1) facts.continuous_derivatives = start - 1;
    for (int i = 1; i < start; ++i) facts.add_break(static_cast<double>(i) / start);
    return facts;
  }
  static constexpr CutoffFromPolynomial from(const ParameterValues* values) { return {values[0].integer(), values[1].integer()}; }
  constexpr const char* problem() const { return start >= 1 && start <= 4 ? iteration().problem() : "start is 1 to 4"; }
};

// S_alpha(t) = 1 / (1 + e^(-alpha t)) on [-1, 1], 0 and 1 outside: an approximation that jumps by tail() at both ends.
struct Logistic {
  static constexpr const char* name = "logistic";
  static constexpr CurveParameter parameters[] = {number_parameter("alpha", "steepness", 1, 200, 20)};
  double alpha = 20.0;

  constexpr Differentiable operator()(const Differentiable& t) const {
    if (t.value <= -1.0) return 0.0;
    if (t.value >= 1.0) return 1.0;
    return 1.0 / (1.0 + exp(-alpha * t));
  }
  // S_alpha(-1). Below a given tail from alpha = alpha_for_tail(tail) on.
  constexpr double tail() const { return 1.0 / (1.0 + exact_exp(alpha)); }
  static constexpr double alpha_for_tail(double tail) { return exact_log((1.0 - tail) / tail); }
  constexpr CurveFacts facts() const {
    CurveFacts facts = step_facts(-1, true);
    facts.end_jump = tail();
    return facts;
  }
  static constexpr Logistic from(const ParameterValues* values) { return {values[0].number()}; }
  constexpr const char* problem() const { return alpha >= 1.0 && alpha <= 200.0 ? nullptr : "alpha is 1 to 200"; }
};

// A step as a function of u in [0, 1] instead of t in [-1, 1].
template <class Step> struct OverUnitInterval {
  Step step;
  constexpr Differentiable operator()(const Differentiable& u) const { return step(2.0 * u - 1.0); }
};
template <class Step> constexpr OverUnitInterval<Step> over_unit_interval(Step step) { return {step}; }

}  // namespace nearfield::step
