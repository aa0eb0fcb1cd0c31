#pragma once
/// Blends of ray values, which are at least 0 and smaller inside: Ricci's super-ellipsoidal set operations
/// and Hsu's scale union and scale intersection. All but the super-ellipsoidal difference are ray-linear,
/// B(ax, ay) = aB(x, y) for a ≥ 0. At x = y = … = 0, where the derivatives depend on the direction, those
/// along the diagonal are given, with equal shares.
///
/// Super-ellipsoidal difference: the complement of a solid x ≤ c is c²/x ≤ c, so that the first solid without
/// the others is the intersection of x₁, c²/x₂, c²/x₃…: (x₁ⁿ + (c²/x₂)ⁿ + …)^{1/n} with the surface at c,
/// Hsu's at c = 1 (where the circulating copy prints the union's formula). It is not ray-linear, and no
/// difference can be: all ray values of one centre are 0 there, so that the difference never contains it.
/// Only its surface at c has a meaning; c must be that of both its operands and of what uses the result.
///
/// Scale blends: with q = r₁r₂ − p and L(u, v) = r₁r₂ − r₂u − r₁v, Hoffmann and Hopcroft's conic is
/// B_H(u, v) = L(u, v)² − 2quv. For q > 0 it has two arcs in u, v ≥ 0, both ending in the points of tangency
/// (r₁, 0) and (0, r₂): the inner one, L = +√(2quv), which blends, and an outer one. Every ray of the region
/// meets the inner arc exactly once, between the chord L = 0 and the sharp result.
///
/// Union, any r₁, r₂ > 0: u = x₁/h − 1, v = x₂/h − 1; (r₂x₁ + r₁x₂)/(r₁ + r₂ + r₁r₂) ≤ h ≤ min(x₁, x₂);
/// region x₂ < (1 + r₂)x₁ and x₁ < (1 + r₁)x₂; the root with +√, for a of either sign.
///
/// Intersection, r₁, r₂ > 0 with r₁r₂ < r₁ + r₂: u = 1 − x₁/h, v = 1 − x₂/h; max(x₁, x₂) ≤ h ≤
/// (r₂x₁ + r₁x₂)/(r₁ + r₂ − r₁r₂); region x₂ > (1 − r₂)x₁ and x₁ > (1 − r₁)x₂; the root with −√, for a of
/// either sign. A range above 1 limits nothing: the region then holds its axis.
///
/// −∞ < p < r₁r₂ gives C¹ at both edges of the region; p = r₁r₂ is the chord itself, a chamfer, only C⁰.

#include "blend_point.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <stdexcept>
#include <vector>

namespace nearfield::reference {

inline void expect_ray_values(const std::vector<Real>& x, Real n) {
  if (x.empty() || !(n > 0)) {
    throw std::invalid_argument("super-ellipsoidal blend: at least one operand and n greater than 0");
  }
  for (const Real value : x) {
    if (!(value >= 0)) throw std::invalid_argument("super-ellipsoidal blend: operands are at least 0");
  }
}

/// (Σ xᵢⁿ)^{1/n}, n > 0, x ≥ 0 (otherwise std::invalid_argument); n |log₂ xᵢ| below 16000. For n < 1 the
/// derivative by an operand that is 0 while others are not is infinite.
inline ManyBlendPoint super_ellipsoidal_intersection(Real n, const std::vector<Real>& x) {
  expect_ray_values(x, n);
  Real sum = 0;
  for (const Real value : x) sum += std::pow(value, n);
  const Real result = std::pow(sum, 1 / n);
  const Real count = static_cast<Real>(x.size());
  ManyBlendPoint point{result, {}};
  for (const Real value : x) {
    point.partials.push_back(result > 0 ? std::pow(value / result, n - 1) : std::pow(count, 1 / n - 1));
  }
  return point;
}

/// (Σ xᵢ⁻ⁿ)^{−1/n}, n > 0, x ≥ 0 (otherwise std::invalid_argument); 0 where any operand is 0, and there
/// those operands share the derivative. Range of n as for the intersection.
inline ManyBlendPoint super_ellipsoidal_union(Real n, const std::vector<Real>& x) {
  expect_ray_values(x, n);
  const auto zeros = static_cast<Real>(std::count(x.begin(), x.end(), Real{0}));
  ManyBlendPoint point{0, {}};
  if (zeros > 0) {
    for (const Real value : x) point.partials.push_back(value > 0 ? Real{0} : std::pow(zeros, -1 / n - 1));
    return point;
  }
  Real sum = 0;
  for (const Real value : x) sum += std::pow(value, -n);
  point.value = std::pow(sum, -1 / n);
  for (const Real value : x) point.partials.push_back(std::pow(point.value / value, n + 1));
  return point;
}

/// The first solid without the others, with the surface of all of them at `surface`, c > 0: (x₁ⁿ + (c²/x₂)ⁿ +
/// …)^{1/n}. Infinite, with derivatives of 0 and −∞, where an operand but the first is 0.
inline ManyBlendPoint super_ellipsoidal_difference(Real n, const std::vector<Real>& x, Real surface = 1) {
  expect_ray_values(x, n);
  const Real infinity = std::numeric_limits<Real>::infinity();
  std::vector<Real> operands = x;
  bool is_infinite = false;
  for (std::size_t i = 1; i < x.size(); ++i) {
    is_infinite = is_infinite || x[i] == 0;
    operands[i] = surface * surface / x[i];
  }
  if (is_infinite) {
    ManyBlendPoint point{infinity, std::vector<Real>(x.size())};
    for (std::size_t i = 1; i < x.size(); ++i) point.partials[i] = x[i] == 0 ? -infinity : 0;
    return point;
  }
  ManyBlendPoint point = super_ellipsoidal_intersection(n, operands);
  for (std::size_t i = 1; i < x.size(); ++i) point.partials[i] *= -operands[i] / x[i];
  return point;
}

/// Ranges and curvature of Hoffmann and Hopcroft's conic: r₁, r₂ > 0, p ≤ r₁r₂.
struct ScaleRanges {
  Real r1 = 0.5L;
  Real r2 = 0.5L;
  Real p = 0;
};

/// B_H(u, v) as Hsu prints it (eq. 7).
inline Real hoffmann_conic(const ScaleRanges& ranges, Real u, Real v) {
  const auto& [r1, r2, p] = ranges;
  return r2 * r2 * u * u + r1 * r1 * v * v + r1 * r1 * r2 * r2 - 2 * r2 * r2 * r1 * u - 2 * r1 * r1 * r2 * v +
         2 * p * u * v;
}

/// `sign` is 1 for the union and −1 for the intersection in what follows.
inline void expect_scale_ranges(const ScaleRanges& ranges, Real sign, Real x1, Real x2) {
  const auto& [r1, r2, p] = ranges;
  if (!(r1 > 0 && r2 > 0 && std::isfinite(r1) && std::isfinite(r2) && std::isfinite(p) && p <= r1 * r2)) {
    throw std::invalid_argument("scale blend: ranges are greater than 0 and p is at most their product");
  }
  if (sign < 0 && !(r1 * r2 < r1 + r2)) {
    throw std::invalid_argument("scale intersection: the product of the ranges is less than their sum");
  }
  if (!(x1 >= 0 && x2 >= 0)) throw std::invalid_argument("scale blend: operands are at least 0");
}

/// Whether the result differs from the sharp one.
inline bool in_scale_region(const ScaleRanges& ranges, Real sign, Real x1, Real x2) {
  return sign * x2 < sign * (1 + sign * ranges.r2) * x1 && sign * x1 < sign * (1 + sign * ranges.r1) * x2;
}

/// h by its defining equation B_H = 0, by bisection between the chord, where B_H ≤ 0, and the sharp result,
/// where B_H > 0.
inline Real scale_root_by_bisection(const ScaleRanges& ranges, Real sign, Real x1, Real x2) {
  const auto& [r1, r2, p] = ranges;
  const Real chord = (r2 * x1 + r1 * x2) / (r1 + r2 + sign * r1 * r2);
  const Real sharp = sign > 0 ? std::min(x1, x2) : std::max(x1, x2);
  if (p == r1 * r2) return chord;
  Real beyond = chord;
  Real before = sharp;
  for (int i = 0; i < 90; ++i) {
    const Real h = (beyond + before) / 2;
    (hoffmann_conic(ranges, sign * (x1 / h - 1), sign * (x2 / h - 1)) > 0 ? before : beyond) = h;
  }
  return (beyond + before) / 2;
}

/// The same root of a h² + b h + c = 0, with +√ for the union and −√ for the intersection, in whichever of
/// its two forms does not cancel; it serves a = 0 too.
inline Real scale_root_in_closed_form(const ScaleRanges& ranges, Real sign, Real x1, Real x2) {
  const auto& [r1, r2, p] = ranges;
  const Real a = (1 + sign * 2 * r2) * r1 * r1 + (1 + sign * r1) * (1 + sign * r1) * r2 * r2 + 2 * p;
  const Real b = -2 * (x2 * (1 + sign * r2) * r1 * r1 + x1 * (1 + sign * r1) * r2 * r2 + (x1 + x2) * p);
  const Real c = r1 * r1 * x2 * x2 + r2 * r2 * x1 * x1 + 2 * p * x1 * x2;
  const Real root = sign * std::sqrt(std::max(b * b - 4 * a * c, Real{0}));
  const bool cancels = root > 0 ? b > 0 : b < 0;
  return cancels ? -2 * c / (b + root) : (root - b) / (2 * a);
}

/// By implicit differentiation of L − √(2quv) = 0.
inline BlendPoint scale_point(const ScaleRanges& ranges, Real sign, Real x1, Real x2) {
  expect_scale_ranges(ranges, sign, x1, x2);
  const auto& [r1, r2, p] = ranges;
  if (x1 == 0 && x2 == 0) {
    const Real along_diagonal = scale_point(ranges, sign, 1, 1).value;
    return {0, along_diagonal / 2, along_diagonal / 2};
  }
  if (!in_scale_region(ranges, sign, x1, x2)) {
    const bool is_first = sign > 0 ? x1 <= x2 : x1 >= x2;
    return {is_first ? x1 : x2, is_first ? Real{1} : Real{0}, is_first ? Real{0} : Real{1}};
  }
  const Real h = scale_root_by_bisection(ranges, sign, x1, x2);
  const Real q = r1 * r2 - p;
  if (q == 0) {
    const Real divisor = r1 + r2 + sign * r1 * r2;
    return {h, r2 / divisor, r1 / divisor};
  }
  const Real u = std::max(sign * (x1 / h - 1), Real{0});
  const Real v = std::max(sign * (x2 / h - 1), Real{0});
  const Real mean = std::sqrt(u * v);
  const Real bend = std::sqrt(q / 2);
  const Real weight1 = r2 * mean + bend * v;
  const Real weight2 = r1 * mean + bend * u;
  const Real total = weight1 * x1 + weight2 * x2;
  return {h, h * weight1 / total, h * weight2 / total};
}

/// B_SA2. Operands below 0 or ranges outside their limits: std::invalid_argument.
inline BlendPoint scale_union(const ScaleRanges& ranges, Real x1, Real x2) {
  return scale_point(ranges, 1, x1, x2);
}

/// B_SS2. Operands below 0 or ranges outside their limits: std::invalid_argument.
inline BlendPoint scale_intersection(const ScaleRanges& ranges, Real x1, Real x2) {
  return scale_point(ranges, -1, x1, x2);
}

/// Values alone, by the closed form.
inline Real scale_union_in_closed_form(const ScaleRanges& ranges, Real x1, Real x2) {
  expect_scale_ranges(ranges, 1, x1, x2);
  if (!in_scale_region(ranges, 1, x1, x2)) return std::min(x1, x2);
  return scale_root_in_closed_form(ranges, 1, x1, x2);
}
inline Real scale_intersection_in_closed_form(const ScaleRanges& ranges, Real x1, Real x2) {
  expect_scale_ranges(ranges, -1, x1, x2);
  if (!in_scale_region(ranges, -1, x1, x2)) return std::max(x1, x2);
  return scale_root_in_closed_form(ranges, -1, x1, x2);
}

/// Hsu's sequential blends B(…B(B(x₁, x₂), x₃)…, xₖ); the order of the operands matters.
inline ManyBlendPoint sequential_scale_union(const ScaleRanges& ranges, const std::vector<Real>& x) {
  return folded([&ranges](Real x1, Real x2) { return scale_union(ranges, x1, x2); }, x);
}
inline ManyBlendPoint sequential_scale_intersection(const ScaleRanges& ranges, const std::vector<Real>& x) {
  return folded([&ranges](Real x1, Real x2) { return scale_intersection(ranges, x1, x2); }, x);
}

}  // namespace nearfield::reference
