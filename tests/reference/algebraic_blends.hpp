#pragma once
/// Blends of algebraic values: Hoffmann and Hopcroft's conic, Liming's curve and the functional spline.
/// I-patches: implicit_patches.hpp.

#include "blend_point.hpp"
#include "ray_linear_blends.hpp"

#include <cmath>
#include <cstddef>
#include <stdexcept>
#include <vector>

namespace nearfield::reference {

/// B_H(x₁, x₂) (Hsu eq. 7) with its derivatives.
inline BlendPoint hoffmann_conic_point(const ScaleRanges& ranges, Real x1, Real x2) {
  const auto& [r1, r2, p] = ranges;
  return {hoffmann_conic(ranges, x1, x2), 2 * r2 * r2 * (x1 - r1) + 2 * p * x2,
          2 * r1 * r1 * (x2 - r2) + 2 * p * x1};
}

/// Union of two values that are negative inside, r₁, r₂ > 0 and p ≤ r₁r₂ (otherwise std::invalid_argument).
///
/// The fillet fills the triangle x₁ ≥ 0, x₂ ≥ 0, x₁/r₁ + x₂/r₂ ≤ 1 up to the inner arc of B_H = 0. B_H is
/// positive on the side of the corner, so that −B_H has the sign of the union there; elsewhere the result is
/// min(x₁, x₂). The range 0 ≤ xᵢ ≤ rᵢ, which Hsu gives as the region, is too wide: beyond the triangle B_H
/// is positive again past its outer arc, at (r₁, r₂) for p > r₁r₂/2.
///
/// The surface is C¹ for p < r₁r₂ (tangent to x₂ = 0 at x₁ = r₁ and to x₁ = 0 at x₂ = r₂). The value is not
/// even continuous: it jumps along the three sides of the triangle but at those two points, never changing
/// its sign by that. It tells the side and locates the surface; it measures nothing.
inline BlendPoint hoffmann_union(const ScaleRanges& ranges, Real x1, Real x2) {
  const auto& [r1, r2, p] = ranges;
  if (!(r1 > 0 && r2 > 0 && p <= r1 * r2)) {
    throw std::invalid_argument("Hoffmann blend: ranges are greater than 0 and p is at most their product");
  }
  if (x1 >= 0 && x2 >= 0 && r2 * x1 + r1 * x2 <= r1 * r2) {
    const BlendPoint conic = hoffmann_conic_point(ranges, x1, x2);
    return {-conic.value, -conic.by_x, -conic.by_y};
  }
  const Real share_of_first = x1 < x2 ? Real{1} : x1 > x2 ? Real{0} : Real{0.5L};
  return {x1 < x2 ? x1 : x2, share_of_first, 1 - share_of_first};
}

/// −union(−x₁, −x₂): B_H(−x₁, −x₂) in the triangle, max(x₁, x₂) elsewhere. Hsu's −B_H(−x₁, −x₂) has the
/// other sign: his union is positive inside the fillet.
inline BlendPoint hoffmann_intersection(const ScaleRanges& ranges, Real x1, Real x2) {
  const BlendPoint mirrored = hoffmann_union(ranges, -x1, -x2);
  return {-mirrored.value, mirrored.by_x, mirrored.by_y};
}

/// The first without the second.
inline BlendPoint hoffmann_difference(const ScaleRanges& ranges, Real x1, Real x2) {
  const BlendPoint point = hoffmann_intersection(ranges, x1, -x2);
  return {point.value, point.by_x, -point.by_y};
}

/// Liming's (1 − λ)L₁L₂ + λC² with its derivatives. For 0 < λ < 1 its zeros have L₁L₂ ≤ 0: to blend the
/// corner where both are positive, one of them takes the other sign. With −L₁, L₂, C = r₁r₂ − r₂L₁ − r₁L₂ and
/// λ = 1/(1 + 2(r₁r₂ − p)) it is λB_H(L₁, L₂).
struct LimingPoint {
  Real value{};
  Real by_l1{};
  Real by_l2{};
  Real by_c{};
};

inline LimingPoint liming(Real lambda, Real l1, Real l2, Real c) {
  return {(1 - lambda) * l1 * l2 + lambda * c * c, (1 - lambda) * l2, (1 - lambda) * l1, 2 * lambda * c};
}

/// Derivatives of a product by its factors: each the product of the others.
inline std::vector<Real> products_of_others(const std::vector<Real>& factors) {
  std::vector<Real> products;
  for (std::size_t i = 0; i < factors.size(); ++i) {
    Real product = 1;
    for (std::size_t j = 0; j < factors.size(); ++j) {
      if (j != i) product *= factors[j];
    }
    products.push_back(product);
  }
  return products;
}

inline Real product_of(const std::vector<Real>& factors) {
  Real product = 1;
  for (const Real factor : factors) product *= factor;
  return product;
}

/// A function of primaries (or corners) and bounds.
struct PatchPoint {
  Real value{};
  std::vector<Real> by_primaries{};
  std::vector<Real> by_bounds{};
};

/// (1 − λ)ΠPᵢ + λΠBᵢ², any number of either.
inline PatchPoint functional_spline(Real lambda, const std::vector<Real>& primaries,
                                    const std::vector<Real>& bounds) {
  const Real bound = product_of(bounds);
  PatchPoint point{(1 - lambda) * product_of(primaries) + lambda * bound * bound,
                   products_of_others(primaries), products_of_others(bounds)};
  for (Real& partial : point.by_primaries) partial *= 1 - lambda;
  for (Real& partial : point.by_bounds) partial *= 2 * lambda * bound;
  return point;
}

}  // namespace nearfield::reference
