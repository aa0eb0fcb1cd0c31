#pragma once
/// I-patches (Sipos) with ribbons and with corners, as polynomials and normalised. The bounds Bᵢ are positive
/// inside the patch; the exponent e is 2 for G¹ and 3 for G². Outside, |Bᵢ|ᵉ stands for Bᵢᵉ, without which a
/// normaliser with e = 3 would vanish and change its sign there; for e = 2 it is the same.
///
/// With sᵢ = |Bᵢ|⁻ᵉ, the patches divided by ΠBᵢᵉ are Σ wᵢPᵢsᵢ + w with ribbons and Σ Cₖsₖsₖ₊₁ + Σ wₖsₖ + w
/// with corners, Cₖ belonging to the corner of sides k and k + 1 (cyclic). What they are divided by further:
///
/// - Ribbons by sides, S = Σ sᵢ: Σ wᵢPᵢλᵢ + w/S, λᵢ = sᵢ/S. On side i it is wᵢPᵢ.
///
/// - Corners by sides, S = Σ sᵢ: Σ Cₖλₖλₖ₊₁S + Σ wₖλₖ + w/S. On side k it is Cₖ₋₁sₖ₋₁ + Cₖsₖ₊₁ + wₖ. It is
///   bounded but next to a corner, where it is like Cₖ/(Bₖᵉ + Bₖ₊₁ᵉ), unbounded unless Cₖ vanishes to the
///   order e there. A tangent plane vanishes to the first order alone.
///
/// - Corners by corners, Σ sₖsₖ₊₁: every part is bounded, the Cₖ by weights that add up to 1, and that of wₖ
///   by wₖ times the lesser of |Bₖ₋₁|ᵉ and |Bₖ₊₁|ᵉ. On side k it is the normalised two-sided patch of Cₖ₋₁
///   and Cₖ with the coefficient wₖ, at a corner it is Cₖ.
///
/// Where bounds vanish, the value is the limit for all vanishing bounds equally small: the even mean of the
/// sides, or of the corners, that vanish. Derivatives there are those by the primaries; those by the
/// vanishing bounds are given as 0, which is exact where only one bound vanishes.

#include "algebraic_blends.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <stdexcept>
#include <vector>

namespace nearfield::reference {

/// coefficient · Π s over at most two sides.
struct ReciprocalTerm {
  Real coefficient = 0;
  std::vector<std::size_t> sides{};
};

/// Quotient of two sums of such terms, by the coefficients of the numerator and by the bounds. Only the terms
/// with the greatest number of vanishing bounds in the denominator matter; a numerator with more of them
/// than the denominator has makes it infinite, but terms with a coefficient of 0 do not count.
inline PatchPoint reciprocal_quotient(const std::vector<ReciprocalTerm>& numerator,
                                      const std::vector<ReciprocalTerm>& denominator,
                                      const std::vector<Real>& bounds, int exponent) {
  const auto order = [&bounds](const ReciprocalTerm& term) {
    return std::count_if(term.sides.begin(), term.sides.end(), [&](std::size_t i) { return bounds[i] == 0; });
  };
  const auto power = [&](std::size_t i) {
    return std::pow(std::fabs(bounds[i]), static_cast<Real>(-exponent));
  };
  // The term's value without its coefficient, the bounds that vanish and the one left out.
  const std::size_t none = bounds.size();
  const auto monomial = [&](const ReciprocalTerm& term, std::size_t left_out) {
    Real product = 1;
    for (const std::size_t i : term.sides) {
      if (bounds[i] != 0 && i != left_out) product *= power(i);
    }
    return product;
  };
  const auto has = [](const ReciprocalTerm& term, std::size_t i) {
    return std::find(term.sides.begin(), term.sides.end(), i) != term.sides.end();
  };

  auto leading = order(denominator.front());
  for (const ReciprocalTerm& term : denominator) leading = std::max(leading, order(term));
  Real below = 0;
  for (const ReciprocalTerm& term : denominator) {
    if (order(term) == leading) below += term.coefficient * monomial(term, none);
  }
  PatchPoint point{0, std::vector<Real>(numerator.size()), std::vector<Real>(bounds.size())};
  Real unbounded = 0;
  for (std::size_t t = 0; t < numerator.size(); ++t) {
    const ReciprocalTerm& term = numerator[t];
    if (order(term) > leading) unbounded += term.coefficient * monomial(term, none);
    if (order(term) != leading) continue;
    point.by_primaries[t] = monomial(term, none) / below;
    point.value += term.coefficient * point.by_primaries[t];
  }
  if (unbounded != 0) point.value = std::copysign(std::numeric_limits<Real>::infinity(), unbounded);

  for (std::size_t j = 0; j < bounds.size(); ++j) {
    if (bounds[j] == 0) continue;
    // Both sums are (with s_j)·s_j + (without), so that nothing cancels where s_j is very large.
    std::array<Real, 2> with{};
    std::array<Real, 2> without{};
    for (const ReciprocalTerm& term : numerator) {
      if (order(term) == leading) (has(term, j) ? with : without)[0] += term.coefficient * monomial(term, j);
    }
    for (const ReciprocalTerm& term : denominator) {
      if (order(term) == leading) (has(term, j) ? with : without)[1] += term.coefficient * monomial(term, j);
    }
    const Real by_power = (with[0] * without[1] - without[0] * with[1]) / (below * below);
    point.by_bounds[j] = by_power * static_cast<Real>(-exponent) * power(j) / bounds[j];
  }
  return point;
}

/// Coefficients of a patch: one per side, and that of the bounds' product.
struct PatchCoefficients {
  std::vector<Real> side{};
  Real bound = 0;
  int exponent = 2;
};

inline void expect_patch(const PatchCoefficients& w, const std::vector<Real>& primaries,
                         const std::vector<Real>& bounds, std::size_t fewest) {
  if (bounds.size() < fewest || bounds.size() > 8 || primaries.size() != bounds.size() ||
      w.side.size() != bounds.size() || w.exponent < 2 || w.exponent > 3) {
    throw std::invalid_argument(
        "I-patch: two (with corners three) to eight sides, as many coefficients and primaries, exponent 2 or "
        "3");
  }
}

inline std::size_t next_side(std::size_t k, std::size_t count) { return k + 1 < count ? k + 1 : 0; }

/// Π |Bᵢ|ᵉ over all sides but those two (or one, given twice).
inline Real bound_product(const PatchCoefficients& w, const std::vector<Real>& bounds, std::size_t but,
                          std::size_t and_but) {
  Real product = 1;
  for (std::size_t i = 0; i < bounds.size(); ++i) {
    if (i != but && i != and_but) product *= std::pow(std::fabs(bounds[i]), static_cast<Real>(w.exponent));
  }
  return product;
}

/// Σᵢ wᵢPᵢ Π_{j≠i} Bⱼᵉ + w Π Bᵢᵉ; two to eight sides. Wrong sizes, here and below: std::invalid_argument.
inline Real ribbon_patch_polynomial(const PatchCoefficients& w, const std::vector<Real>& primaries,
                                    const std::vector<Real>& bounds) {
  expect_patch(w, primaries, bounds, 2);
  Real sum = w.bound * bound_product(w, bounds, bounds.size(), bounds.size());
  for (std::size_t i = 0; i < bounds.size(); ++i) {
    sum += w.side[i] * primaries[i] * bound_product(w, bounds, i, i);
  }
  return sum;
}

/// Σₖ Cₖ Π_{i≠k,k+1} Bᵢᵉ + Σₖ wₖ Π_{i≠k} Bᵢᵉ + w Π Bᵢᵉ; three to eight sides.
inline Real corner_patch_polynomial(const PatchCoefficients& w, const std::vector<Real>& corners,
                                    const std::vector<Real>& bounds) {
  expect_patch(w, corners, bounds, 3);
  const std::size_t count = bounds.size();
  Real sum = w.bound * bound_product(w, bounds, count, count);
  for (std::size_t k = 0; k < count; ++k) {
    sum += corners[k] * bound_product(w, bounds, k, next_side(k, count));
    sum += w.side[k] * bound_product(w, bounds, k, k);
  }
  return sum;
}

/// The normalisers, which make the normalised patches when the polynomials are divided by them.
inline Real normaliser_by_sides(const PatchCoefficients& w, const std::vector<Real>& bounds) {
  Real sum = 0;
  for (std::size_t i = 0; i < bounds.size(); ++i) sum += bound_product(w, bounds, i, i);
  return sum;
}
inline Real normaliser_by_corners(const PatchCoefficients& w, const std::vector<Real>& bounds) {
  Real sum = 0;
  for (std::size_t k = 0; k < bounds.size(); ++k) {
    sum += bound_product(w, bounds, k, next_side(k, bounds.size()));
  }
  return sum;
}

inline std::vector<ReciprocalTerm> reciprocal_sides(std::size_t count) {
  std::vector<ReciprocalTerm> terms;
  for (std::size_t i = 0; i < count; ++i) terms.push_back({1, {i}});
  return terms;
}
inline std::vector<ReciprocalTerm> reciprocal_corners(std::size_t count) {
  std::vector<ReciprocalTerm> terms;
  for (std::size_t k = 0; k < count; ++k) terms.push_back({1, {k, next_side(k, count)}});
  return terms;
}

/// Normalised by sides; Pᵢ on side i times wᵢ. Finite everywhere.
inline PatchPoint ribbon_patch(const PatchCoefficients& w, const std::vector<Real>& primaries,
                               const std::vector<Real>& bounds) {
  expect_patch(w, primaries, bounds, 2);
  std::vector<ReciprocalTerm> numerator;
  for (std::size_t i = 0; i < bounds.size(); ++i) numerator.push_back({w.side[i] * primaries[i], {i}});
  numerator.push_back({w.bound, {}});
  PatchPoint point = reciprocal_quotient(numerator, reciprocal_sides(bounds.size()), bounds, w.exponent);
  point.by_primaries.resize(bounds.size());
  for (std::size_t i = 0; i < bounds.size(); ++i) point.by_primaries[i] *= w.side[i];
  return point;
}

/// By either normaliser; primaries are the corners.
inline PatchPoint normalised_corner_patch(const PatchCoefficients& w, const std::vector<Real>& corners,
                                          const std::vector<Real>& bounds,
                                          const std::vector<ReciprocalTerm>& normaliser) {
  expect_patch(w, corners, bounds, 3);
  const std::size_t count = bounds.size();
  std::vector<ReciprocalTerm> numerator;
  for (std::size_t k = 0; k < count; ++k) numerator.push_back({corners[k], {k, next_side(k, count)}});
  for (std::size_t k = 0; k < count; ++k) numerator.push_back({w.side[k], {k}});
  numerator.push_back({w.bound, {}});
  PatchPoint point = reciprocal_quotient(numerator, normaliser, bounds, w.exponent);
  point.by_primaries.resize(count);
  return point;
}

/// Normalised by corners. Finite everywhere.
inline PatchPoint corner_patch(const PatchCoefficients& w, const std::vector<Real>& corners,
                               const std::vector<Real>& bounds) {
  return normalised_corner_patch(w, corners, bounds, reciprocal_corners(bounds.size()));
}

/// Normalised by sides: infinite at a corner whose Cₖ is not 0 there, and unbounded near any other.
inline PatchPoint corner_patch_by_sides(const PatchCoefficients& w, const std::vector<Real>& corners,
                                        const std::vector<Real>& bounds) {
  return normalised_corner_patch(w, corners, bounds, reciprocal_sides(bounds.size()));
}

/// Primaries (or corners) and bounds at one point.
struct PatchSample {
  std::vector<Real> primaries{};
  std::vector<Real> bounds{};
};

using NormalisedPatch = PatchPoint (*)(const PatchCoefficients&, const std::vector<Real>&,
                                       const std::vector<Real>&);

/// The coefficient w of the bounds' product that makes the sum of the squares of the normalised patch over
/// the samples least. One sample: the patch passes through its point. Several: it is centred among them.
/// w.bound is ignored. Every sample on a bound, where w has no effect: std::invalid_argument.
inline Real centred_bound_coefficient(NormalisedPatch patch, PatchCoefficients w,
                                      const std::vector<PatchSample>& samples) {
  Real products = 0;
  Real squares = 0;
  for (const PatchSample& at : samples) {
    w.bound = 0;
    const Real without = patch(w, at.primaries, at.bounds).value;
    PatchCoefficients bound_alone{std::vector<Real>(w.side.size()), 1, w.exponent};
    const Real effect = patch(bound_alone, std::vector<Real>(at.primaries.size()), at.bounds).value;
    products += without * effect;
    squares += effect * effect;
  }
  if (!(squares > 0)) throw std::invalid_argument("I-patch: its coefficient needs a point off the bounds");
  return -products / squares;
}

/// The coefficient wₖ of a side between two corners that leads the side through a point on it: the values
/// there of both corners, and of the two bounds beyond them (not 0, otherwise std::invalid_argument).
inline Real side_coefficient_through(Real corner_before, Real corner_after, Real bound_before,
                                     Real bound_after, int exponent) {
  if (bound_before == 0 || bound_after == 0) {
    throw std::invalid_argument("I-patch: a side's coefficient needs a point off the other bounds");
  }
  const auto power = [exponent](Real bound) {
    return std::pow(std::fabs(bound), static_cast<Real>(-exponent));
  };
  return -(corner_before * power(bound_before) + corner_after * power(bound_after));
}

}  // namespace nearfield::reference
