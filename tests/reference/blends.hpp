#pragma once
/// Blends of two distances (Li, section 3) and the soft sum of potentials (Kačić-Alesić and Wyvill).
/// Distances are negative inside, so union = -B(-x, -y), intersection = B(x, y), x without y = B(x, -y),
/// where B is a (smooth) maximum.

#include "blend_point.hpp"
#include "potentials.hpp"
#include "steps.hpp"
#include "vector.hpp"

#include <algorithm>
#include <stdexcept>
#include <utility>
#include <vector>

namespace nearfield::reference {

/// S_abs(t, δ, ε) (Li eq. 18 and 19, with t²/2δ where the paper prints x²/2δ), δ > 0, ε ≥ 0.
inline Real smooth_absolute(const UnitStep& step, Real delta, Real epsilon, Real t) {
  const Real parabola = t * t / (2 * delta) + delta / 2;
  const Real g1 = ranged_step(step, epsilon, t + delta);
  const Real g2 = ranged_step(step, epsilon, t - delta);
  return (g1 + g2 - 1) * t + g1 * (1 - g2) * parabola;
}

/// dS_abs/dt.
inline Real smooth_absolute_slope(const UnitStep& step, Real delta, Real epsilon, Real t) {
  const Real parabola = t * t / (2 * delta) + delta / 2;
  const Real g1 = ranged_step(step, epsilon, t + delta);
  const Real g2 = ranged_step(step, epsilon, t - delta);
  const Real g1_slope = ranged_step_slope(step, epsilon, t + delta);
  const Real g2_slope = ranged_step_slope(step, epsilon, t - delta);
  return (g1_slope + g2_slope) * t + (g1 + g2 - 1) + (g1_slope * (1 - g2) - g1 * g2_slope) * parabola +
         g1 * (1 - g2) * t / delta;
}

/// Ext_max (Li eq. 20).
inline Real exterior_max(const UnitStep& step, Real delta, Real epsilon, Real x, Real y) {
  return (x + y + smooth_absolute(step, delta, epsilon, x - y)) / 2;
}

/// Int_max (Li eq. 24).
inline Real interior_max(const UnitStep& step, Real epsilon, Real x, Real y) {
  const Real share = ranged_step(step, epsilon, y - x);
  return (1 - share) * x + share * y;
}

enum class BlendKind { hard, exterior, interior, custom };

/// A maximum of two values. `delta` (metres, > 0) is used by the exterior blend alone, `epsilon` (metres,
/// ≥ 0) and `step` by both smooth ones.
struct Blend {
  BlendKind kind = BlendKind::hard;
  UnitStep step{};
  Real delta = 0;
  Real epsilon = 0;
  BinaryBlend custom{};
};

inline Blend hard_blend() {
  return {};
}
inline Blend exterior_blend(const UnitStep& step, Real delta, Real epsilon) {
  return {BlendKind::exterior, step, delta, epsilon, {}};
}
inline Blend interior_blend(const UnitStep& step, Real epsilon) {
  return {BlendKind::interior, step, 0, epsilon, {}};
}

/// Any smooth maximum, such as those of additive_blends.hpp.
inline Blend custom_blend(BinaryBlend maximum) {
  return {BlendKind::custom, {}, 0, 0, std::move(maximum)};
}

inline Real blend_max(const Blend& blend, Real x, Real y) {
  switch (blend.kind) {
    case BlendKind::hard:
      return std::max(x, y);
    case BlendKind::exterior:
      return exterior_max(blend.step, blend.delta, blend.epsilon, x, y);
    case BlendKind::interior:
      return interior_max(blend.step, blend.epsilon, x, y);
    case BlendKind::custom:
      return blend.custom(x, y).value;
  }
  throw std::invalid_argument("unknown blend");
}

/// Partial derivatives of a blend by its two operands.
struct Partials {
  Real by_x{};
  Real by_y{};
};

/// Analytic; the hard maximum at x = y gives half to each.
inline Partials blend_max_partials(const Blend& blend, Real x, Real y) {
  switch (blend.kind) {
    case BlendKind::hard: {
      const Real share = heaviside(x - y);
      return {share, 1 - share};
    }
    case BlendKind::exterior: {
      const Real slope = smooth_absolute_slope(blend.step, blend.delta, blend.epsilon, x - y);
      return {(1 + slope) / 2, (1 - slope) / 2};
    }
    case BlendKind::interior: {
      const Real share = ranged_step(blend.step, blend.epsilon, y - x);
      const Real shift = ranged_step_slope(blend.step, blend.epsilon, y - x) * (y - x);
      return {1 - share - shift, share + shift};
    }
    case BlendKind::custom: {
      const BlendPoint point = blend.custom(x, y);
      return {point.by_x, point.by_y};
    }
  }
  throw std::invalid_argument("unknown blend");
}

inline Real blend_union(const Blend& blend, Real x, Real y) {
  return -blend_max(blend, -x, -y);
}
inline Real blend_intersection(const Blend& blend, Real x, Real y) {
  return blend_max(blend, x, y);
}

/// The first solid without the second.
inline Real blend_subtraction(const Blend& blend, Real x, Real y) {
  return blend_max(blend, x, -y);
}

inline Partials blend_union_partials(const Blend& blend, Real x, Real y) {
  return blend_max_partials(blend, -x, -y);
}
inline Partials blend_intersection_partials(const Blend& blend, Real x, Real y) {
  return blend_max_partials(blend, x, y);
}
inline Partials blend_subtraction_partials(const Blend& blend, Real x, Real y) {
  const Partials partials = blend_max_partials(blend, x, -y);
  return {partials.by_x, -partials.by_y};
}

/// One term c·P(r/R) of a soft sum: strength c (may be negative), distance r ≥ 0 and radius of influence
/// R > 0, both in metres.
struct SoftTerm {
  Real strength = 1;
  Potential potential = Potential::wyvill;
  Real distance = 0;
  Real influence_radius = 1;
};

/// F = Σ cᵢ Pᵢ(rᵢ/Rᵢ); the surface is at F = 0.5 and the inside above it.
inline Real soft_sum_value(const std::vector<SoftTerm>& terms) {
  Real sum = 0;
  for (const SoftTerm& term : terms) {
    sum += term.strength * potential_value(term.potential, term.distance / term.influence_radius);
  }
  return sum;
}

/// ∂F/∂rᵢ of one term, 1/metres; the gradient of F in space is the sum of this times ∇rᵢ.
inline Real soft_term_slope(const SoftTerm& term) {
  return term.strength * potential_slope(term.potential, term.distance / term.influence_radius) /
         term.influence_radius;
}

}  // namespace nearfield::reference
