// Checks of the long double translation-equivariant blends: values known from the papers, bounds, laws of
// symmetry, agreement of independent formulas, derivatives by differences.

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <reference/additive_blends.hpp>
#include <reference/random.hpp>
#include <reference/step_curves.hpp>
#include <reference/vector.hpp>
#include <stdexcept>
#include <string>
#include <vector>

#include "curve_expectations.hpp"

namespace {

using namespace nearfield::reference;

const PolynomialStepCurve cubic_step(3);
const StepWithSlope antisymmetric = step_with_slope(cubic_step);
const StepWithSlope one_sided = step_with_slope(RisingCutoffCurve(2));

// Points of t that pass every edge of a blend with ranges δ and ε.
std::vector<Real> differences_to_try(Real reach) {
  std::vector<Real> differences;
  for (int i = 0; i < grid_count; i += 4) differences.push_back(grid_point(i, -reach, reach));
  return differences;
}

void expect_partials(const BinaryBlend& blend, Real x, Real y, Real tolerance, const std::string& what) {
  constexpr Real h = 1e-4L;
  const BlendPoint point = blend(x, y);
  const Real by_x = central_difference([&](Real moved) { return blend(moved, y).value; }, x, h);
  const Real by_y = central_difference([&](Real moved) { return blend(x, moved).value; }, y, h);
  const std::string place = what + " at " + std::to_string(x) + ", " + std::to_string(y);
  expect_close(point.by_x, by_x, tolerance, place + ", by x");
  expect_close(point.by_y, by_y, tolerance, place + ", by y");
  expect_close(point.by_x + point.by_y, 1, 1e-17L, place + ", sum of the derivatives");
}

TEST(ReferenceAdditiveBlends, ExteriorTieIsAQuarterOfItsRange) {
  for (const StepWithSlope& mu : {antisymmetric, one_sided}) {
    for (const Real epsilon : {0.0L, 0.1L, 0.25L}) {
      const BlendPoint tie = exterior_maximum_point(mu, 0.25L, epsilon, 3, 3);
      EXPECT_EQ(tie.value, 3 + 0.25L / 4);
      EXPECT_EQ(tie.by_x, 0.5L);
    }
  }
  // Beyond it both steps overlap: S(0) = μ(δ/ε)² δ/2 with H₃(¼) = 95/128 (u = 15/8 of Li's eq. 8).
  const Real step = -0.625L + 0.75L * 1.875L - 0.375L * 0.375L * 0.375L / 3;
  expect_close(exterior_maximum(antisymmetric.value, 0.25L, 1, 0, 0), step * step * 0.25L / 4, 1e-19L,
               "overlapping steps");
}

TEST(ReferenceAdditiveBlends, ExteriorIsSharpBeyondItsRangeAndContainsItsOperands) {
  for (const StepWithSlope& mu : {antisymmetric, one_sided}) {
    for (const Real ratio : {0.0L, 0.25L, 1.0L}) {
      const Real delta = 0.3L;
      const Real epsilon = ratio * delta;
      for (const Real t : differences_to_try(1)) {
        const Real x = 0.7L + t;
        const Real excess = exterior_maximum(mu.value, delta, epsilon, x, 0.7L) - std::max(x, 0.7L);
        const Real beyond = std::fabs(t) - delta;
        const Real share =
            t >= 0 ? 1 - step_of_range(mu.value, epsilon, beyond) : step_of_range(mu.value, epsilon, -beyond);
        expect_close(excess, share * beyond * beyond / (4 * delta), 1e-18L, "closed form of the excess");
        if (beyond > epsilon) {
          EXPECT_LE(std::fabs(excess), 1e-18L) << t;
        } else {
          EXPECT_GE(excess, -1e-18L) << t;
        }
      }
    }
  }
}

TEST(ReferenceAdditiveBlends, MeasuredPeaksOfTheExteriorSlope) {
  const auto greatest_slope = [](Real epsilon) {
    Real greatest = -1;
    for (int i = 0; i < 4000; ++i) {
      const Real t = static_cast<Real>(i) * 0.00125L;
      const Real slope = (smoothed_absolute_slope(antisymmetric, 1, epsilon, t) - 1) / 2;
      greatest = std::max(greatest, slope);
    }
    return greatest;
  };
  expect_close(greatest_slope(0.25L), 0.0048L, 5e-5L, "epsilon = delta/4");
  expect_close(greatest_slope(1), 0.019L, 5e-4L, "epsilon = delta");
  expect_close(greatest_slope(4), 0.12L, 5e-3L, "epsilon = 4 delta");
}

TEST(ReferenceAdditiveBlends, InteriorLiesBetweenItsOperandsAndKeepsTheTie) {
  for (const StepWithSlope& mu : {antisymmetric, one_sided}) {
    for (const Real t : differences_to_try(1)) {
      const Real value = interior_maximum(mu.value, 0.6L, 0.4L + t, 0.4L);
      EXPECT_LE(value, std::max(0.4L + t, 0.4L) + 1e-18L);
      EXPECT_GE(value, std::min(0.4L + t, 0.4L) - 1e-18L);
      if (std::fabs(t) > 0.6L) {
        EXPECT_EQ(value, std::max(0.4L + t, 0.4L)) << t;
      }
    }
    expect_close(interior_maximum(mu.value, 0.6L, 0.4L, 0.4L), 0.4L, 1e-19L, "tie");
  }
}

TEST(ReferenceAdditiveBlends, InteriorOfAOneSidedStepDependsOnTheOrder) {
  // t = x − y: −tμ(−t) for x ≥ y, −|t|(1 − μ(|t|)) for x < y, added to the greater one.
  const RealFunction& mu = one_sided.value;
  for (const Real t : {0.1L, 0.35L, 0.5L}) {
    expect_close(interior_maximum(mu, 0.6L, t, 0), t - t * mu(-t / 0.6L), 1e-18L, "first greater");
    expect_close(interior_maximum(mu, 0.6L, 0, t), t - t * (1 - mu(t / 0.6L)), 1e-18L, "second greater");
    EXPECT_GT(std::fabs(interior_maximum(mu, 0.6L, t, 0) - interior_maximum(mu, 0.6L, 0, t)), 1e-3L);
    // Shares taken from two steps do not add up to 1, so that they move the tie.
    EXPECT_GT(mu(0) + mu(0), 1.4L);
  }
}

TEST(ReferenceAdditiveBlends, SymmetricExactlyForAntisymmetricSteps) {
  Real greatest_gap = 0;
  for (const Real t : differences_to_try(1)) {
    expect_close(smoothed_absolute(antisymmetric.value, 0.2L, 0.5L, t),
                 smoothed_absolute(antisymmetric.value, 0.2L, 0.5L, -t), 1e-18L, "even");
    expect_close(interior_maximum(antisymmetric.value, 0.5L, t, 0),
                 interior_maximum(antisymmetric.value, 0.5L, 0, t), 1e-18L, "interior");
    greatest_gap = std::max(greatest_gap, std::fabs(smoothed_absolute(one_sided.value, 0.2L, 0.5L, t) -
                                                    smoothed_absolute(one_sided.value, 0.2L, 0.5L, -t)));
  }
  EXPECT_GT(greatest_gap, 0.01L);
}

TEST(ReferenceAdditiveBlends, DegenerateRangesAreTheLimits) {
  const BlendPoint sharp = exterior_maximum_point(antisymmetric, 0, 0, 2, 2);
  EXPECT_EQ(sharp.value, 2);
  EXPECT_EQ(sharp.by_x, 0.5L);
  EXPECT_EQ(exterior_maximum(antisymmetric.value, 0, 0, -1, 2), 2);
  EXPECT_EQ(interior_maximum(antisymmetric.value, 0, -1, 2), 2);
  EXPECT_EQ(interior_maximum(antisymmetric.value, 0, 3, 2), 3);
  EXPECT_THROW(exterior_maximum(antisymmetric.value, 0, 0.1L, 1, 2), std::invalid_argument);
  EXPECT_THROW(exterior_maximum(antisymmetric.value, 0.1L, -0.1L, 1, 2), std::invalid_argument);
  EXPECT_GT(exterior_maximum(antisymmetric.value, 1e-6L, 1, 0.5L, 0), 1000.0L);
}

TEST(ReferenceAdditiveBlends, LogSumExp) {
  for (const Real p : {0.5L, 8.0L, 200.0L}) {
    expect_close(log_sum_exp_point(p, 0.3L, 0.3L).value, 0.3L + std::log(2.0L) / p, 1e-18L, "tie");
    expect_close(log_sum_exp_point(-p, 0.3L, 0.3L).value, 0.3L - std::log(2.0L) / p, 1e-18L, "tie of minima");
    for (const Real t : differences_to_try(2)) {
      expect_close(log_sum_exp_point(p, t, 0).value, std::log(std::exp(p * t) + 1) / p, 1e-17L, "naive");
    }
    const ManyBlendPoint all = log_sum_exp(p, {0.1L, -0.2L, 0.15L, 0.05L});
    const BinaryBlend pair = [p](Real x, Real y) { return log_sum_exp_point(p, x, y); };
    const ManyBlendPoint folded_all = folded(pair, {0.1L, -0.2L, 0.15L, 0.05L});
    expect_close(all.value, folded_all.value, 1e-18L, "associative");
    for (std::size_t i = 0; i < 4; ++i) {
      expect_close(all.partials[i], folded_all.partials[i], 1e-18L, "associative, derivative");
    }
  }
  EXPECT_EQ(log_sum_exp_point(HUGE_VALL, 1, 4).value, 4);
  EXPECT_EQ(log_sum_exp_point(-HUGE_VALL, 1, 4).value, 1);
  EXPECT_EQ(log_sum_exp_point(HUGE_VALL, 4, 4).by_y, 0.5L);
  EXPECT_EQ(log_sum_exp_point(1e6L, 1e6L, -1e6L).value, 1e6L);
  EXPECT_THROW(log_sum_exp(0, {1, 2}), std::invalid_argument);
  EXPECT_THROW(log_sum_exp(1, {}), std::invalid_argument);
}

TEST(ReferenceAdditiveBlends, PolynomialMinima) {
  EXPECT_EQ(quadratic_minimum_point(0.5L, 1, 1).value, 1 - 0.5L / 4);
  expect_close(cubic_minimum_point(0.5L, 1, 1).value, 1 - 0.5L / 6, 1e-19L, "tie");
  EXPECT_EQ(quadratic_minimum_point(0, 1, 1).value, 1);
  EXPECT_EQ(cubic_minimum_point(0, 2, 1).value, 1);
  const BinaryBlend exterior = [](Real x, Real y) {
    return exterior_maximum_point(antisymmetric, 0.5L, 0, x, y);
  };
  for (const Real t : differences_to_try(1)) {
    const BlendPoint quadratic = quadratic_minimum_point(0.5L, t, 0);
    const BlendPoint li = union_point(exterior, t, 0);
    expect_close(quadratic.value, li.value, 1e-18L, "the exterior union with a sharp step");
    expect_close(quadratic.by_x, li.by_x, 1e-18L, "the exterior union with a sharp step, derivative");
    EXPECT_LE(cubic_minimum_point(0.5L, t, 0).value, std::min(t, 0.0L));
    EXPECT_GE(cubic_minimum_point(0.5L, t, 0).value, quadratic.value - 1e-18L);
  }
}

TEST(ReferenceAdditiveBlends, DerivativesAgreeWithDifferences) {
  Random random(announced_seed("ReferenceAdditiveBlends.DerivativesAgreeWithDifferences", 31));
  for (int i = 0; i < 400; ++i) {
    const Real x = random.uniform(-1, 1);
    const Real y = random.uniform(-1, 1);
    const Real delta = random.uniform(0.2L, 1);
    const Real epsilon = random.uniform(0.2L, 1);
    for (const StepWithSlope& mu : {antisymmetric, one_sided}) {
      // The steps' third derivatives jump at their knots.
      const BinaryBlend exterior = [&](Real a, Real b) {
        return exterior_maximum_point(mu, delta, epsilon, a, b);
      };
      const BinaryBlend interior = [&](Real a, Real b) { return interior_maximum_point(mu, epsilon, a, b); };
      expect_partials(exterior, x, y, 3e-5L, "exterior");
      expect_partials(interior, x, y, 3e-5L, "interior");
    }
    expect_partials([](Real a, Real b) { return log_sum_exp_point(7, a, b); }, x, y, 1e-11L, "log-sum-exp");
    expect_partials([](Real a, Real b) { return log_sum_exp_point(-7, a, b); }, x, y, 1e-11L, "log-sum-exp");
    expect_partials([&](Real a, Real b) { return quadratic_minimum_point(delta, a, b); }, x, y, 3e-4L,
                    "quadratic");
    expect_partials([&](Real a, Real b) { return cubic_minimum_point(delta, a, b); }, x, y, 1e-6L, "cubic");
  }
}

TEST(ReferenceAdditiveBlends, DerivativesAreContinuousAtEveryEdge) {
  const auto expect_continuous = [](const BinaryBlend& blend, Real edge, const std::string& what) {
    constexpr Real h = 1e-9L;
    const BlendPoint before = blend(edge - h, 0);
    const BlendPoint after = blend(edge + h, 0);
    expect_close(before.value, after.value, 1e-8L, what);
    expect_close(before.by_x, after.by_x, 1e-7L, what + ", derivative");
  };
  for (const Real sign : {-1.0L, 1.0L}) {
    for (const Real edge : {0.0L, 0.05L, 0.3L, 0.55L}) {
      expect_continuous(
          [](Real x, Real y) { return exterior_maximum_point(antisymmetric, 0.3L, 0.25L, x, y); },
          sign * edge, "exterior");
    }
    for (const Real edge : {0.0L, 0.25L}) {
      expect_continuous([](Real x, Real y) { return interior_maximum_point(one_sided, 0.25L, x, y); },
                        sign * edge, "interior");
      expect_continuous([](Real x, Real y) { return quadratic_minimum_point(0.25L, x, y); }, sign * edge,
                        "quadratic");
      expect_continuous([](Real x, Real y) { return cubic_minimum_point(0.25L, x, y); }, sign * edge,
                        "cubic");
    }
  }
}

TEST(ReferenceAdditiveBlends, SetOperationsOfDistances) {
  const BinaryBlend sharp = sharp_maximum_point;
  EXPECT_EQ(union_point(sharp, -1, 2).value, -1);
  EXPECT_EQ(intersection_point(sharp, -1, 2).value, 2);
  EXPECT_EQ(subtraction_point(sharp, -1, 2).value, -1);
  EXPECT_EQ(subtraction_point(sharp, -1, -2).value, 2);
  EXPECT_EQ(subtraction_point(sharp, -1, -2).by_y, -1);
  const BinaryBlend smooth = [](Real x, Real y) {
    return exterior_maximum_point(antisymmetric, 0.4L, 0.1L, x, y);
  };
  // Li turned around: F = −φ, union Ext(F₁, F₂), subtraction −Ext(−F₁, F₂).
  EXPECT_EQ(union_point(smooth, 0.1L, 0.2L).value,
            -exterior_maximum(antisymmetric.value, 0.4L, 0.1L, -0.1L, -0.2L));
  EXPECT_EQ(subtraction_point(smooth, 0.1L, 0.2L).value,
            exterior_maximum(antisymmetric.value, 0.4L, 0.1L, 0.1L, -0.2L));
  EXPECT_LT(union_point(smooth, 0.1L, 0.1L).value, 0.1L);
  EXPECT_GT(intersection_point(smooth, 0.1L, 0.1L).value, 0.1L);
  const BlendPoint mirrored = union_point(smooth, 0.1L, 0.2L);
  EXPECT_GT(mirrored.by_x, mirrored.by_y);
}

}  // namespace
