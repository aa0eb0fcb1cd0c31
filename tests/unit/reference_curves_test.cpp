// Checks of the long double steps with two derivatives by their definitions: central differences, the
// conditions the papers state, and second constructions of the same function.

#include <gtest/gtest.h>

#include <cmath>
#include <reference/curve_point.hpp>
#include <reference/sine_cosine.hpp>
#include <reference/step_curves.hpp>
#include <reference/steps.hpp>
#include <reference/vector.hpp>
#include <stdexcept>
#include <string>
#include <vector>

#include "curve_expectations.hpp"

namespace {

using namespace nearfield::reference;

template <class Curve>
void expect_never_falls(const Curve& curve, const std::string& what) {
  for (int i = 0; i < grid_count; ++i)
    EXPECT_GE(curve(grid_point(i, -1, 1)).first, -1e-18L) << what << " " << i;
}

/// Constant 0 and 1 outside [-1, 1], and continuous at both ends.
template <class Step>
void expect_unit_step(const Step& step, const std::string& what) {
  for (const Real beyond : {1e-15L, 0.1L, 7.0L}) {
    expect_same(step(-1 - beyond), {0, 0, 0}, 0, what);
    expect_same(step(1 + beyond), {1, 0, 0}, 0, what);
  }
  expect_close(step(-1).value, 0, 1e-18L, what + " at -1");
  expect_close(step(1).value, 1, 1e-18L, what + " at 1");
  expect_never_falls(step, what);
}

template <class Step>
void expect_antisymmetric_step(const Step& step, const std::string& what) {
  for (int i = 0; i < grid_count; ++i) {
    const Real t = grid_point(i, -1, 1);
    expect_close(step(t).value + step(-t).value, 1, 1e-18L, what);
  }
}

std::vector<Real> uniform_breaks(int segments) {
  std::vector<Real> breaks;
  for (int i = 1; i < segments; ++i)
    breaks.push_back(-1 + 2 * static_cast<Real>(i) / static_cast<Real>(segments));
  return breaks;
}

TEST(ReferenceCurves, SineAndCosineAgreeWithTheStandardOnes) {
  for (int i = 0; i < 20000; ++i) {
    const Real angle = pi / 2 * (-1 + 2 * static_cast<Real>(i) / 19999);
    const SineCosine both = sine_cosine(angle);
    expect_close(both.sine, std::sin(angle), 2e-19L, "sine");
    expect_close(both.cosine, std::cos(angle), 2e-19L, "cosine");
  }
}

TEST(ReferenceCurves, HeavisideIsAHalfInTheMiddle) {
  const HeavisideCurve step;
  expect_same(step(-1e-18L), {0, 0, 0}, 0, "below 0");
  expect_same(step(0), {0.5L, 0, 0}, 0, "at 0");
  expect_same(step(1e-18L), {1, 0, 0}, 0, "above 0");
}

TEST(ReferenceCurves, PolynomialAndBsplineStepsAreOneFunction) {
  for (int n = 1; n <= 8; ++n) {
    const std::string what = "H" + std::to_string(n);
    const PolynomialStepCurve polynomial(n);
    const BsplineStepCurve bspline(n);
    expect_unit_step(polynomial, what);
    expect_unit_step(bspline, "B" + std::to_string(n));
    expect_antisymmetric_step(polynomial, what);
    for (int i = 0; i < grid_count; ++i) {
      const Real t = grid_point(i, -1, 1);
      expect_close(polynomial(t).value, bspline_step(n, t), 1e-17L, what + " and the integrated B-spline");
      expect_close(polynomial(t).value, polynomial_step(n, t), 1e-17L, what + " and its recursion");
      expect_close(polynomial(t).first, polynomial_step_slope(n, t), 1e-16L,
                   what + ", slope of the recursion");
      expect_same(bspline(t), polynomial(t), 1e-16L, what);
    }
    expect_derivatives(polynomial, -1, 1, uniform_breaks(n), 2, what);
    expect_derivatives(bspline, -1, 1, uniform_breaks(n), 2, "B" + std::to_string(n));
  }
}

TEST(ReferenceCurves, CubicStepHasThePiecesThatLiPrints) {
  const PolynomialStepCurve step(3);
  for (int i = 0; i < grid_count; ++i) {
    const Real t = grid_point(i, -1, 1);
    const Real u = 3 * (t + 1) / 2;
    const Real expected = u < 1   ? u * u * u / 6
                          : u < 2 ? -Real{5} / 8 + 3 * u / 4 - (u - 1.5L) * (u - 1.5L) * (u - 1.5L) / 3
                                  : 1 - (3 - u) * (3 - u) * (3 - u) / 6;
    expect_close(step(t).value, expected, 1e-18L, "cubic step");
  }
}

TEST(ReferenceCurves, PiecesOfAPolynomialStepPartAtKnotsInTheOrderOfItsDegreeAlone) {
  // Two polynomials of degree n meet with n − 1 equal derivatives exactly when they differ by C (t − knot)ⁿ.
  for (int n = 1; n <= 8; ++n) {
    const PolynomialStepCurve step(n);
    const Real length = 2 / static_cast<Real>(n);
    for (int knot = 0; knot <= n; ++knot) {
      const Real at = -1 + length * static_cast<Real>(knot);
      const auto difference = [&](Real back) {
        // Beyond the last knot the step is 1; the piece right of any other is continued to its left.
        const Real right = knot == n ? Real{1} : continued_piece(step, n, at, length, at - back);
        return std::fabs(step(at - back).value - right);
      };
      const Real far = difference(length);
      EXPECT_GT(far, 1e-7L) << "H" << n << ", knot " << knot;
      expect_close(std::log2(far / difference(length / 2)), static_cast<Real>(n), 1e-6L,
                   "order of the difference");
    }
  }
}

/// `remainder(distance)` has to be coefficient · distance^order with relative corrections of the second
/// order.
template <class Remainder>
void expect_leading_power(const Remainder& remainder, Real coefficient, Real order, const std::string& what) {
  for (const Real size : {1e-13L, 1e-12L, 1e-11L}) {
    const Real distance = std::pow(size / coefficient, 1 / order);
    const Real tolerance = 0.3L * order * distance * distance + 1e-5L;
    expect_close(remainder(distance) / (coefficient * std::pow(distance, order)), 1, tolerance, what);
  }
}

TEST(ReferenceCurves, RisingCutoffsAreFlatAtTheirEndsToTheStatedOrder) {
  // 1 ∓ sin(π/2 · t) is a (1 ∓ t)² with a = π²/8 near the ends, so that n − 1 warps leave a^(2ⁿ⁻¹ − 1)
  // y^(2ⁿ⁻¹).
  Real warped_coefficient = 1;
  Real warped_order = 1;
  for (int n = 1; n <= 5; ++n) {
    const std::string what = "R" + std::to_string(n);
    const RisingCutoffCurve rising(n);
    const RisingCutoffSquaredCurve square(n);
    const Real low = pi / 4 * warped_coefficient;
    expect_leading_power([&](Real y) { return rising(y - 1).value; }, low, warped_order, what + " at -1");
    expect_leading_power([&](Real y) { return 1 - rising(1 - y).value; }, low * low / 2, 2 * warped_order,
                         what + " at 1");
    expect_leading_power([&](Real y) { return square(y - 1).value; }, low * low, 2 * warped_order,
                         what + " squared at -1");
    if (n >= 2) expect_close(rising(-1).first, 0, 1e-18L, what + ", first derivative at -1");
    if (n >= 3) expect_close(rising(-1).second, 0, 1e-17L, what + ", second derivative at -1");
    expect_close(rising(1).first, 0, 1e-18L, what + ", first derivative at 1");
    if (n >= 2) expect_close(rising(1).second, 0, 1e-17L, what + ", second derivative at 1");
    warped_coefficient *= warped_coefficient * pi * pi / 8;
    warped_order *= 2;
  }
}

TEST(ReferenceCurves, RisingCutoffsAgreeWithTheirDefinition) {
  for (int n = 1; n <= 5; ++n) {
    const std::string what = "R" + std::to_string(n);
    const RisingCutoffCurve rising(n);
    const RisingCutoffSquaredCurve square(n);
    expect_unit_step(rising, what);
    expect_unit_step(square, what + " squared");
    expect_antisymmetric_step(square, what + " squared");
    EXPECT_GT(std::fabs(rising(0.3L).value + rising(-0.3L).value - 1), 0.01L)
        << what << " is not antisymmetric";
    const Real sharpness = static_cast<Real>(1 << n);
    expect_derivatives(rising, -1, 1, {}, sharpness, what);
    expect_derivatives(square, -1, 1, {}, sharpness, what + " squared");
    for (int i = 0; i < grid_count; ++i) {
      const Real t = grid_point(i, -1, 1);
      expect_close(rising(t).value, rising_cutoff(n, t), 3e-18L, what);
      expect_close(rising(t).first, rising_cutoff_slope(n, t), 1e-16L, what + ", slope");
      expect_close(square(t).value, rising_cutoff_squared(n, t), 3e-18L, what + " squared");
    }
  }
}

TEST(ReferenceCurves, IterationFromTheLinearAngleGivesTheRisingCutoffs) {
  for (int n = 1; n <= 5; ++n) {
    const IteratedRisingCutoffCurve<LinearAngle> iterated(n, {});
    const RisingCutoffCurve rising(n);
    expect_unit_step(iterated, "iterated");
    for (int i = 0; i < grid_count; ++i) {
      const Real t = grid_point(i, -1, 1);
      expect_same(iterated(t), rising(t), 1e-15L, "iterated R" + std::to_string(n));
    }
  }
}

TEST(ReferenceCurves, IterationFromOtherAnglesKeepsTheRisingCutoffCondition) {
  const auto from_step = [](Real t) {
    const CurvePoint step = PolynomialStepCurve(4)(t);
    return CurvePoint{pi / 2 * step.value, pi / 2 * step.first, pi / 2 * step.second};
  };
  const auto from_cube = [](Real t) {
    return CurvePoint{pi / 8 * (2 + t + t * t * t), pi / 8 * (1 + 3 * t * t), pi / 8 * 6 * t};
  };
  const auto expect_condition = [](const auto& curve, int n) {
    const std::string what = "iterated " + std::to_string(n);
    expect_unit_step(curve, what);
    expect_derivatives(curve, -1, 1, uniform_breaks(4), static_cast<Real>(2 << n), what);
    for (int i = 0; i < grid_count; ++i) {
      const Real t = grid_point(i, -1, 1);
      const Real rise = curve(t).value;
      const Real fall = curve(-t).value;
      expect_close(rise * rise + fall * fall, 1, 1e-17L, what);
    }
  };
  for (int n = 1; n <= 4; ++n) {
    expect_condition(IteratedRisingCutoffCurve<decltype(from_step)>(n, from_step), n);
    expect_condition(IteratedRisingCutoffCurve<decltype(from_cube)>(n, from_cube), n);
  }
}

TEST(ReferenceCurves, LogisticTailIsBelowEpsilonFromItsLeastAlphaOn) {
  for (const Real alpha : {1.0L, 4.0L, 8.0L, 20.0L}) {
    const LogisticCurve step(alpha);
    const std::string what = "logistic";
    expect_close(step(-1).value, step.tail(), 1e-19L, what + " at -1");
    expect_close(1 - step(1).value, step.tail(), 1e-19L, what + " at 1");
    expect_same(step(-1 - 1e-15L), {0, 0, 0}, 0, what);
    expect_same(step(1 + 1e-15L), {1, 0, 0}, 0, what);
    expect_never_falls(step, what);
    expect_antisymmetric_step(step, what);
    expect_derivatives(step, -1, 1, {}, alpha, what);
    for (int i = 0; i < grid_count; ++i) {
      const Real t = grid_point(i, -1, 1);
      expect_close(step(t).value, logistic(alpha, t), 1e-18L, what);
      expect_close(step(t).first, logistic_slope(alpha, t), 1e-17L, what + ", slope");
    }
  }
  for (const Real epsilon : {0.25L, 1e-3L, 1e-9L}) {
    const Real least = std::log((1 - epsilon) / epsilon);
    EXPECT_LT(LogisticCurve(least * 1.0001L).tail(), epsilon);
    EXPECT_GT(LogisticCurve(least * 0.9999L).tail(), epsilon);
  }
}

TEST(ReferenceCurves, StepsRefuseBadParameters) {
  EXPECT_THROW(PolynomialStepCurve(0), std::invalid_argument);
  EXPECT_THROW(PolynomialStepCurve(9), std::invalid_argument);
  EXPECT_THROW(BsplineStepCurve(0), std::invalid_argument);
  EXPECT_THROW(BsplineStepCurve(9), std::invalid_argument);
  EXPECT_THROW(RisingCutoffCurve(0), std::invalid_argument);
  EXPECT_THROW(RisingCutoffSquaredCurve(0), std::invalid_argument);
  EXPECT_THROW(LogisticCurve(0), std::invalid_argument);
  EXPECT_THROW(IteratedRisingCutoffCurve<LinearAngle>(0, {}), std::invalid_argument);
  const auto unbalanced = [](Real t) {
    return CurvePoint{pi / 8 * (1 + t) * (1 + t), pi / 4 * (1 + t), pi / 4};
  };
  EXPECT_THROW(IteratedRisingCutoffCurve<decltype(unbalanced)>(1, unbalanced), std::invalid_argument);
}

}  // namespace
