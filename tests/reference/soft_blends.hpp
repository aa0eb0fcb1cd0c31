#pragma once
/// Soft blends: sums of potentials (Kačić-Alesić and Wyvill, Hsu eq. 12) and Hsu's variable influential
/// radius (eq. 13 to 15). Potentials are callables that give a CurvePoint, such as those of
/// potential_curves.hpp.
///
/// Hsu's remap T(d; w₁, w₂) with w₁ = 2d/f − 1 for a contour f is, with k = 1/w₁ = f/(2d − f) and s = d − ½:
/// - d > ½: 1 where f > 1, otherwise ks + ½. Where w₁ ≤ 0, f > 1.
/// - ½(1 − w₂) ≤ d < ½ and w₁ > 0: (2/w₂)(k − 1/w₂)s² + ks + ½, but at least 0.
/// - otherwise 0.
///
/// T is continuous for every w₂ in (0, 1], not only for w₂ ≤ w₁ as Hsu demands of constants: for 2w₁ < w₂, as
/// happens where the contour is close to the object, the parabola dips below 0, where every potential is 1.
///
/// For w₁ ≤ 0 and d < ½ the limit (w₁ → 0 from above) is 0, so that the inside of the object stays inside; 1
/// would bore a hole, for instance at the centre of an object (d = 0) that the contour does not share.
///
/// T jumps at d = ½ where f ≥ 1, that is where the contour touches or cuts the object.

#include "blend_point.hpp"
#include "curve_point.hpp"

#include <functional>
#include <stdexcept>
#include <vector>

namespace nearfield::reference {

using PotentialFunction = std::function<CurvePoint(Real)>;

/// One term cP(d); c may be negative.
struct PotentialTerm {
  Real strength = 1;
  PotentialFunction potential{};
  Real argument = 0;
};

/// Σ cᵢ Pᵢ(dᵢ), with the derivatives by dᵢ.
inline ManyBlendPoint sum_of_potentials(const std::vector<PotentialTerm>& terms) {
  ManyBlendPoint sum;
  for (const PotentialTerm& term : terms) {
    const CurvePoint potential = term.potential(term.argument);
    sum.value += term.strength * potential.value;
    sum.partials.push_back(term.strength * potential.first);
  }
  return sum;
}

/// T at the ray value d ≥ 0 of the object, x, and f ≥ 0 of the contour, y, for w₂ in (0, 1]; otherwise
/// std::invalid_argument. At d = ½ it is ½, with the derivatives of the outer piece for f < 1 and 0 for f
/// ≥ 1. At f = 1 the derivatives are those from inside the contour.
inline BlendPoint variable_range_remap(Real d, Real f, Real w2) {
  if (!(d >= 0 && f >= 0 && w2 > 0 && w2 <= 1)) {
    throw std::invalid_argument("variable radius: ray values are at least 0 and w2 is in (0, 1]");
  }
  if (d > 0.5L && f > 1) return {1, 0, 0};
  if (d == 0.5L && f >= 1) return {0.5L, 0, 0};
  if (d < (1 - w2) / 2 || 2 * d <= f) return {0, 0, 0};
  const Real width = 2 * d - f;
  const Real k = f / width;
  const Real k_by_d = -2 * f / (width * width);
  const Real k_by_f = 2 * d / (width * width);
  const Real s = d - 0.5L;
  if (d >= 0.5L) return {k * s + 0.5L, k + s * k_by_d, s * k_by_f};
  const Real a = 2 * (k - 1 / w2) / w2;
  const Real value = a * s * s + k * s + 0.5L;
  if (value <= 0) return {0, 0, 0};
  const Real by_k = 2 * s * s / w2 + s;
  return {value, 2 * a * s + k + by_k * k_by_d, by_k * k_by_f};
}

/// P(T), by d (x) and f (y); arguments as above.
inline BlendPoint variable_radius_intensity(const PotentialFunction& potential, Real d, Real f, Real w2) {
  const BlendPoint ranged = variable_range_remap(d, f, w2);
  const CurvePoint outer = potential(ranged.value > 1 ? Real{1} : ranged.value);
  return {outer.value, outer.first * ranged.by_x, outer.first * ranged.by_y};
}

}  // namespace nearfield::reference
