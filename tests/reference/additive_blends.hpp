#pragma once
/// Translation-equivariant blends, B(x + c, y + c) = B(x, y) + c, by the formulas of their papers: Li's
/// exterior and interior maximum, Akleman and Chen's log-sum-exp, the polynomial smooth minima of computer
/// graphics; and the set operations of distances (negative inside) made from a smooth maximum.
///
/// Li's two formulas take a step μ that need not be antisymmetric, and t = x − y of either sign.
///
/// Exterior (eq. 18 to 20): (x + y + S(t))/2, S(t) = (g₁ + g₂ − 1)t + g₁(1 − g₂)(t²/2δ + δ/2), g₁ = μ_ε(t +
/// δ), g₂ = μ_ε(t − δ). For the t² the paper prints x². For ε ≤ δ it is max(x, y) + share · (|t| − δ)²/4δ,
/// where the share is 1 − μ_ε(|t| − δ) for x ≥ y and μ_ε(δ − |t|) for x < y.
///
/// Interior (eq. 24): (1 − μ_ε(y − x))x + μ_ε(y − x)y. One step, taken at y − x, shares the whole between
/// both. It is not xμ_ε(x − y) + yμ_ε(y − x), whose shares add up to 1 for antisymmetric μ alone.
///
/// Both are symmetric in x and y if μ is antisymmetric; otherwise the order of the operands matters.

#include "blend_point.hpp"
#include "curve_point.hpp"

#include <algorithm>
#include <cmath>
#include <functional>
#include <stdexcept>
#include <vector>

namespace nearfield::reference {

using RealFunction = std::function<Real(Real)>;

/// A unit step on all of ℝ (0 below −1, 1 above 1) and its derivative.
struct StepWithSlope {
  RealFunction value;
  RealFunction slope;
};

/// From a callable that gives a CurvePoint, such as those of step_curves.hpp.
template <class Curve>
StepWithSlope step_with_slope(const Curve& curve) {
  return {[curve](Real t) { return curve(t).value; }, [curve](Real t) { return curve(t).first; }};
}

/// μ_ε(t) = μ(t/ε), ε ≥ 0; for ε = 0 the limit, Heaviside's step (½ at 0).
inline Real step_of_range(const RealFunction& mu, Real epsilon, Real t) {
  if (epsilon > 0) return mu(t / epsilon);
  return t < 0 ? Real{0} : t > 0 ? Real{1} : Real{0.5L};
}

inline Real step_slope_of_range(const StepWithSlope& mu, Real epsilon, Real t) {
  return epsilon > 0 ? mu.slope(t / epsilon) / epsilon : Real{0};
}

/// δ > 0, or δ = ε = 0. For δ → 0 with ε > 0 kept, S(t) grows without bound where μ_ε(t)(1 − μ_ε(t)) > 0.
inline void expect_exterior_ranges(Real delta, Real epsilon) {
  if (!(epsilon >= 0) || !(delta > 0 || (delta == 0 && epsilon == 0))) {
    throw std::invalid_argument(
        "exterior maximum: delta is greater than 0 and epsilon at least 0, or both are 0");
  }
}

/// S(t) for t of either sign; |t| for |t| ≥ δ + ε, and everywhere for δ = ε = 0. Ranges that
/// expect_exterior_ranges() refuses: std::invalid_argument.
inline Real smoothed_absolute(const RealFunction& mu, Real delta, Real epsilon, Real t) {
  expect_exterior_ranges(delta, epsilon);
  if (delta == 0) return std::fabs(t);
  const Real g1 = step_of_range(mu, epsilon, t + delta);
  const Real g2 = step_of_range(mu, epsilon, t - delta);
  return (g1 + g2 - 1) * t + g1 * (1 - g2) * (t * t / (2 * delta) + delta / 2);
}

/// dS/dt; 0 at t = 0 for δ = ε = 0.
inline Real smoothed_absolute_slope(const StepWithSlope& mu, Real delta, Real epsilon, Real t) {
  expect_exterior_ranges(delta, epsilon);
  if (delta == 0) return t < 0 ? Real{-1} : t > 0 ? Real{1} : Real{0};
  const Real g1 = step_of_range(mu.value, epsilon, t + delta);
  const Real g2 = step_of_range(mu.value, epsilon, t - delta);
  const Real g1_slope = step_slope_of_range(mu, epsilon, t + delta);
  const Real g2_slope = step_slope_of_range(mu, epsilon, t - delta);
  const Real f = t * t / (2 * delta) + delta / 2;
  return (g1 + g2 - 1) + (g1_slope + g2_slope) * t + (g1_slope * (1 - g2) - g1 * g2_slope) * f +
         g1 * (1 - g2) * t / delta;
}

/// Ext_max; ranges as for smoothed_absolute().
inline Real exterior_maximum(const RealFunction& mu, Real delta, Real epsilon, Real x, Real y) {
  return (x + y + smoothed_absolute(mu, delta, epsilon, x - y)) / 2;
}

inline BlendPoint exterior_maximum_point(const StepWithSlope& mu, Real delta, Real epsilon, Real x, Real y) {
  const Real slope = smoothed_absolute_slope(mu, delta, epsilon, x - y);
  return {exterior_maximum(mu.value, delta, epsilon, x, y), (1 + slope) / 2, (1 - slope) / 2};
}

/// Int_max, ε ≥ 0; the sharp maximum for ε = 0. At x = y it is x, for every μ.
inline Real interior_maximum(const RealFunction& mu, Real epsilon, Real x, Real y) {
  const Real share_of_y = step_of_range(mu, epsilon, y - x);
  return (1 - share_of_y) * x + share_of_y * y;
}

inline BlendPoint interior_maximum_point(const StepWithSlope& mu, Real epsilon, Real x, Real y) {
  const Real share_of_y = step_of_range(mu.value, epsilon, y - x);
  const Real shift = step_slope_of_range(mu, epsilon, y - x) * (y - x);
  return {(1 - share_of_y) * x + share_of_y * y, 1 - share_of_y - shift, share_of_y + shift};
}

/// max(x, y); the derivative at x = y is halved between both.
inline BlendPoint sharp_maximum_point(Real x, Real y) {
  const Real share_of_x = x < y ? Real{0} : x > y ? Real{1} : Real{0.5L};
  return {std::max(x, y), share_of_x, 1 - share_of_x};
}

/// ln(Σ exp(p xᵢ))/p (Akleman and Chen's w_p), p not 0: a smooth maximum for p > 0, a smooth minimum for
/// p < 0, the sharp ones for infinite p. At least one operand; otherwise and for p = 0 std::invalid_argument.
inline ManyBlendPoint log_sum_exp(Real p, const std::vector<Real>& operands) {
  if (operands.empty() || p == 0 || std::isnan(p)) {
    throw std::invalid_argument("log-sum-exp: at least one operand and p not 0");
  }
  const Real greatest = p > 0 ? *std::max_element(operands.begin(), operands.end())
                              : *std::min_element(operands.begin(), operands.end());
  std::vector<Real> shares;
  Real sum = 0;
  for (const Real x : operands) {
    shares.push_back(x == greatest ? Real{1} : std::exp(p * (x - greatest)));
    sum += shares.back();
  }
  for (Real& share : shares) share /= sum;
  return {greatest + (std::isinf(p) ? Real{0} : std::log(sum) / p), shares};
}

inline BlendPoint log_sum_exp_point(Real p, Real x, Real y) {
  const ManyBlendPoint both = log_sum_exp(p, {x, y});
  return {both.value, both.partials[0], both.partials[1]};
}

/// min(x, y) − h²k/4, h = max(k − |x − y|, 0)/k, k ≥ 0; the sharp minimum for k = 0. C¹.
/// It is the exterior minimum −Ext_max(−x, −y) with δ = k, ε = 0.
inline BlendPoint quadratic_minimum_point(Real k, Real x, Real y) {
  const Real h = k > 0 ? std::max(k - std::fabs(x - y), Real{0}) / k : Real{0};
  const Real value = std::min(x, y) - h * h * k / 4;
  const Real towards_other = h / 2;
  if (x < y) return {value, 1 - towards_other, towards_other};
  if (x > y) return {value, towards_other, 1 - towards_other};
  return {value, 0.5L, 0.5L};
}

/// min(x, y) − h³k/6, h as above, k ≥ 0; the sharp minimum for k = 0. C².
inline BlendPoint cubic_minimum_point(Real k, Real x, Real y) {
  const Real h = k > 0 ? std::max(k - std::fabs(x - y), Real{0}) / k : Real{0};
  const Real value = std::min(x, y) - h * h * h * k / 6;
  const Real towards_other = h * h / 2;
  if (x < y) return {value, 1 - towards_other, towards_other};
  if (x > y) return {value, towards_other, 1 - towards_other};
  return {value, 0.5L, 0.5L};
}

/// −B(−x, −y) of a blend: the smooth minimum of a smooth maximum and the other way round.
inline BlendPoint negated_point(const BinaryBlend& blend, Real x, Real y) {
  const BlendPoint mirrored = blend(-x, -y);
  return {-mirrored.value, mirrored.by_x, mirrored.by_y};
}

/// The set operations of distances, negative inside, from a smooth maximum: Li's eq. 21 to 23 and 25 to 27
/// with the sign of both operands and of the result turned.
inline BlendPoint union_point(const BinaryBlend& maximum, Real x, Real y) {
  return negated_point(maximum, x, y);
}
inline BlendPoint intersection_point(const BinaryBlend& maximum, Real x, Real y) { return maximum(x, y); }

/// The first solid without the second.
inline BlendPoint subtraction_point(const BinaryBlend& maximum, Real x, Real y) {
  const BlendPoint point = maximum(x, -y);
  return {point.value, point.by_x, -point.by_y};
}

}  // namespace nearfield::reference
