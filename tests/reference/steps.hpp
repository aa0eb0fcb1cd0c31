#pragma once
/// Smooth unit step functions (Li, section 2), by their definitions: 0 up to t = -1, 1 from t = 1 on.

#include "vector.hpp"

#include <array>
#include <cmath>
#include <cstddef>
#include <stdexcept>

namespace nearfield::reference {

/// H₀ (Li eq. 4): 0, ½ at t = 0, 1.
inline Real heaviside(Real t) {
  return t < 0 ? Real{0} : t > 0 ? Real{1} : Real{0.5L};
}

/// fₙ (Li eq. 5) and its derivative by the product rule (one-sided, or halved, at the jumps of f₀ and f₁′).
struct StepRecursion {
  Real value{};
  Real slope{};
};

inline StepRecursion step_recursion(int n, Real t) {
  if (n == 0) return {heaviside(t), 0};
  const StepRecursion here = step_recursion(n - 1, t);
  const StepRecursion before = step_recursion(n - 1, t - 1);
  const Real order = static_cast<Real>(n);
  const Real weight = t / order;
  return {weight * here.value + (1 - weight) * before.value,
          (here.value - before.value) / order + weight * here.slope + (1 - weight) * before.slope};
}

/// Hₙ (Li eq. 6), n = 0…8; n outside this range: std::invalid_argument.
inline Real polynomial_step(int n, Real t) {
  if (n < 0 || n > 8) throw std::invalid_argument("polynomial step: n is 0 to 8");
  if (n == 0) return heaviside(t);
  if (t <= -1) return 0;
  if (t >= 1) return 1;
  return step_recursion(n, static_cast<Real>(n) * (t + 1) / 2).value;
}

/// Hₙ′; 0 for n = 0 and for |t| ≥ 1.
inline Real polynomial_step_slope(int n, Real t) {
  if (n < 0 || n > 8) throw std::invalid_argument("polynomial step: n is 0 to 8");
  if (n == 0 || t <= -1 || t >= 1) return 0;
  return static_cast<Real>(n) / 2 * step_recursion(n, static_cast<Real>(n) * (t + 1) / 2).slope;
}

/// B-spline basis function number `first` of the given order (degree + 1) over the uniform knots
/// -1 + 2 i / interval_count, by the Cox–de Boor recursion.
inline Real uniform_bspline(int order, int first, int interval_count, Real t) {
  const auto knot = [interval_count](int i) {
    return -1 + 2 * static_cast<Real>(i) / static_cast<Real>(interval_count);
  };
  if (order == 1) return t >= knot(first) && t < knot(first + 1) ? 1 : 0;
  const Real rising = (t - knot(first)) / (knot(first + order - 1) - knot(first));
  const Real falling = (knot(first + order) - t) / (knot(first + order) - knot(first + 1));
  return rising * uniform_bspline(order - 1, first, interval_count, t) +
         falling * uniform_bspline(order - 1, first + 1, interval_count, t);
}

/// Integral of the order-m uniform B-spline on [-1, 1] from -1 to `end`, not normalised. Each knot interval
/// is a polynomial of degree m - 1, which the five-point Gauss rule (exact to degree 9) integrates exactly.
inline Real bspline_integral(int m, Real end) {
  const Real inner = std::sqrt(5 - 2 * std::sqrt(Real{10} / 7)) / 3;
  const Real outer = std::sqrt(5 + 2 * std::sqrt(Real{10} / 7)) / 3;
  const Real inner_weight = (322 + 13 * std::sqrt(Real{70})) / 900;
  const Real outer_weight = (322 - 13 * std::sqrt(Real{70})) / 900;
  const std::array<Real, 5> nodes{-outer, -inner, 0, inner, outer};
  const std::array<Real, 5> weights{outer_weight, inner_weight, Real{128} / 225, inner_weight, outer_weight};
  Real integral = 0;
  for (int i = 0; i < m; ++i) {
    const Real low = -1 + 2 * static_cast<Real>(i) / static_cast<Real>(m);
    const Real knot_high = -1 + 2 * static_cast<Real>(i + 1) / static_cast<Real>(m);
    const Real high = end < knot_high ? end : knot_high;
    if (high <= low) break;
    for (std::size_t k = 0; k < nodes.size(); ++k) {
      const Real t = (low + high) / 2 + (high - low) / 2 * nodes[k];
      integral += weights[k] * (high - low) / 2 * uniform_bspline(m, 0, m, t);
    }
  }
  return integral;
}

/// B_m (Li eq. 7), m = 1…10; m outside this range: std::invalid_argument.
inline Real bspline_step(int m, Real t) {
  if (m < 1 || m > 10) throw std::invalid_argument("B-spline step: m is 1 to 10");
  if (t <= -1) return 0;
  if (t >= 1) return 1;
  return bspline_integral(m, t) / bspline_integral(m, 1);
}

/// Rₙ (Li eq. 16), n ≥ 1; n below 1: std::invalid_argument.
inline Real rising_cutoff(int n, Real t) {
  if (n < 1) throw std::invalid_argument("rising cutoff: n is at least 1");
  if (t <= -1) return 0;
  if (t >= 1) return 1;
  return n == 1 ? std::sin(pi / 4 * (1 + t)) : rising_cutoff(n - 1, std::sin(pi / 2 * t));
}

inline Real rising_cutoff_slope(int n, Real t) {
  if (n < 1) throw std::invalid_argument("rising cutoff: n is at least 1");
  if (t <= -1 || t >= 1) return 0;
  if (n == 1) return pi / 4 * std::cos(pi / 4 * (1 + t));
  return rising_cutoff_slope(n - 1, std::sin(pi / 2 * t)) * (pi / 2) * std::cos(pi / 2 * t);
}

/// The same function by the general iteration (Li eq. 14): μ_k = sin θ_{k−1}, θ_k = (π/2) μ_k², from the
/// linear θ₀ (Li eq. 15).
inline Real rising_cutoff_by_iteration(int n, Real t) {
  Real theta = t <= -1 ? Real{0} : t >= 1 ? pi / 2 : pi / 4 * (1 + t);
  for (int k = 1; k < n; ++k) theta = pi / 2 * std::sin(theta) * std::sin(theta);
  return std::sin(theta);
}

inline Real rising_cutoff_squared(int n, Real t) {
  const Real root = rising_cutoff(n, t);
  return root * root;
}

inline Real rising_cutoff_squared_slope(int n, Real t) {
  return 2 * rising_cutoff(n, t) * rising_cutoff_slope(n, t);
}

/// S_α (Li eq. 17); never quite 0 or 1.
inline Real logistic(Real alpha, Real t) {
  return 1 / (1 + std::exp(-alpha * t));
}

inline Real logistic_slope(Real alpha, Real t) {
  return alpha * logistic(alpha, t) * (1 / (1 + std::exp(alpha * t)));
}

enum class StepKind { polynomial, bspline, rising_cutoff, rising_cutoff_squared, logistic };

/// One of the steps above: `order` is n or m; `alpha` is used by the logistic step alone.
struct UnitStep {
  StepKind kind = StepKind::polynomial;
  int order = 3;
  Real alpha = 0;
};

inline Real step_value(const UnitStep& step, Real t) {
  switch (step.kind) {
    case StepKind::polynomial:
      return polynomial_step(step.order, t);
    case StepKind::bspline:
      return bspline_step(step.order, t);
    case StepKind::rising_cutoff:
      return rising_cutoff(step.order, t);
    case StepKind::rising_cutoff_squared:
      return rising_cutoff_squared(step.order, t);
    case StepKind::logistic:
      return logistic(step.alpha, t);
  }
  throw std::invalid_argument("unknown unit step");
}

inline Real step_slope(const UnitStep& step, Real t) {
  switch (step.kind) {
    case StepKind::polynomial:
      return polynomial_step_slope(step.order, t);
    case StepKind::bspline:
      if (step.order < 1 || step.order > 10) throw std::invalid_argument("B-spline step: m is 1 to 10");
      if (t <= -1 || t >= 1) return 0;
      return uniform_bspline(step.order, 0, step.order, t) / bspline_integral(step.order, 1);
    case StepKind::rising_cutoff:
      return rising_cutoff_slope(step.order, t);
    case StepKind::rising_cutoff_squared:
      return rising_cutoff_squared_slope(step.order, t);
    case StepKind::logistic:
      return logistic_slope(step.alpha, t);
  }
  throw std::invalid_argument("unknown unit step");
}

/// μ_ε(t) = μ(t/ε) (Li definition 3); ε = 0 is the Heaviside step, whatever μ is.
inline Real ranged_step(const UnitStep& step, Real epsilon, Real t) {
  return epsilon > 0 ? step_value(step, t / epsilon) : heaviside(t);
}

inline Real ranged_step_slope(const UnitStep& step, Real epsilon, Real t) {
  return epsilon > 0 ? step_slope(step, t / epsilon) / epsilon : Real{0};
}

}  // namespace nearfield::reference
