// Checks of the long double potentials with two derivatives by their definitions: central differences, the
// conditions the papers state, and second constructions of the same function.

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <initializer_list>
#include <reference/curve_point.hpp>
#include <reference/potential_curves.hpp>
#include <reference/potentials.hpp>
#include <reference/spline_curves.hpp>
#include <reference/vector.hpp>
#include <stdexcept>
#include <string>
#include <vector>

#include "curve_expectations.hpp"

namespace {

using namespace nearfield::reference;

/// Constant 1 and 0 outside [0, 1].
template <class Curve>
void expect_outside(const Curve& curve, const std::string& what) {
  for (const Real beyond : {1e-15L, 0.1L, 7.0L}) {
    expect_same(curve(-beyond), {1, 0, 0}, 0, what);
    expect_same(curve(1 + beyond), {0, 0, 0}, 0, what);
  }
}

/// 1 to 0, with derivatives 1…order vanishing at both ends.
template <class Curve>
void expect_ends(const Curve& curve, int order, const std::string& what) {
  expect_outside(curve, what);
  expect_close(curve(0).value, 1, 1e-18L, what + " at 0");
  expect_close(curve(1).value, 0, 1e-18L, what + " at 1");
  for (const Real end : {0.0L, 1.0L}) {
    if (order >= 1) expect_close(curve(end).first, 0, 1e-16L, what + ", first derivative at an end");
    if (order >= 2) expect_close(curve(end).second, 0, 1e-15L, what + ", second derivative at an end");
  }
}

template <class Curve>
void expect_antisymmetric_potential(const Curve& curve, const std::string& what) {
  expect_close(curve(0.5L).value, 0.5L, 2e-19L, what + " at 1/2");
  for (int i = 0; i < grid_count; ++i) {
    const Real r = grid_point(i, 0, 1);
    expect_close(curve(r).value + curve(1 - r).value, 1, 1e-17L, what);
  }
}

// ---------------------------------------------------------------- potentials by formula

TEST(ReferenceCurves, CubicIsTheLeastPolynomialWithFlatEnds) {
  const CubicCurve cubic;
  expect_ends(cubic, 1, "cubic");
  expect_antisymmetric_potential(cubic, "cubic");
  expect_derivatives(cubic, 0, 1, {}, 1, "cubic");
  for (int i = 0; i < grid_count; ++i) {
    const Real r = grid_point(i, 0, 1);
    expect_close(cubic(r).value, cubic_potential(r), 1e-18L, "cubic");
    expect_close(cubic(r).first, cubic_potential_slope(r), 1e-18L, "cubic, slope");
  }
}

TEST(ReferenceCurves, WyvillPassesThroughItsPointAndIsACubicInTheSquare) {
  const WyvillCurve standard;
  expect_close(standard.k(), -Real{4} / 9, 1e-18L, "standard k");
  for (int i = 0; i < grid_count; ++i) {
    const Real r = grid_point(i, 0, 1);
    expect_close(standard(r).value, wyvill_potential(r), 1e-18L, "wyvill");
    expect_close(standard(r).first, wyvill_potential_slope(r), 2e-18L, "wyvill, slope");
  }
  for (const Real r0 : {0.3L, 0.5L, 0.6L}) {
    for (const Real f0 : {0.35L, 0.5L, 0.7L}) {
      const WyvillCurve curve(r0, f0);
      expect_ends(curve, 1, "wyvill");
      expect_close(curve(r0).value, f0, 1e-18L, "wyvill through its point");
      expect_derivatives(curve, 0, 1, {}, 2, "wyvill");
      // A cubic in r² is fixed by four values: continued from other places it is the same.
      const auto of_square = [&](Real u) { return CurvePoint{curve(std::sqrt(u)).value, 0, 0}; };
      for (const Real u : {0.05L, 0.5L, 0.95L}) {
        expect_close(continued_piece(of_square, 3, 0, 1, u), of_square(u).value, 1e-17L,
                     "cubic in the square");
      }
    }
  }
  for (const Real k : {-1.0L, 2.0L, -1.01L, 2.01L}) {
    const WyvillCurve curve(0.5L, 0.5625L * (1 + k / 4));
    bool rises = false;
    for (int i = 0; i < 20000; ++i) rises = rises || curve(static_cast<Real>(i) / 20000).first > 1e-17L;
    EXPECT_EQ(rises, k < -1 || k > 2) << "k = " << k;
  }
}

TEST(ReferenceCurves, ArctangentHasItsPointOfInflectionAndItsClampedEnds) {
  for (const Real c1 : {10.0L, 50.0L, 1000.0L}) {
    for (const Real c2 : {0.25L, 0.5L, 0.6L}) {
      const std::string what = "arctangent " + std::to_string(c1);
      const ArctangentCurve plain = ArctangentCurve::plain(c1, c2);
      const ArctangentCurve clamped = ArctangentCurve::clamped(c1, c2);
      expect_outside(plain, what);
      expect_same(plain(c2), {0.5L, -c1 / pi, 0}, 1e-16L, what + " at its point of inflection");
      expect_close(plain(0).value, 0.5L + std::atan(c1 * c2) / pi, 1e-18L, what + " misses 1");
      EXPECT_LT(plain(0).value, 1);
      EXPECT_GT(plain(1).value, 0);
      expect_ends(clamped, 0, what + " clamped");
      expect_derivatives(plain, 0, 1, {}, c1, what);
      expect_derivatives(clamped, 0, 1, {}, c1, what + " clamped");
      for (int i = 0; i < grid_count; ++i) {
        const Real r = grid_point(i, 0, 1);
        const Real expected = (plain(r).value - plain(1).value) / (plain(0).value - plain(1).value);
        expect_close(clamped(r).value, expected, 1e-18L, what + " clamped");
      }
    }
    expect_antisymmetric_potential(ArctangentCurve::plain(c1, 0.5L), "arctangent");
    expect_antisymmetric_potential(ArctangentCurve::clamped(c1, 0.5L), "clamped arctangent");
  }
}

TEST(ReferenceCurves, BlancIsCentredAndSmoothInTheMiddleForEverySoftness) {
  for (const Real s : {0.0L, 0.01L, 0.25L, 0.75L, 1.0L, 1.125L, 3.0L, 20.0L}) {
    const std::string what = "blanc " + std::to_string(s);
    const BlancCurve curve(s);
    expect_ends(curve, 1, what);
    const CurvePoint left = curve(0.5L);
    const CurvePoint right = curve(std::nextafter(0.5L, 1.0L));
    expect_close(left.value, 0.5L, 1e-19L, what + " at 1/2");
    expect_close(right.value, left.value, 1e-17L, what + " past 1/2");
    expect_close(right.first, left.first, 1e-16L * (1 + s), what + ", slope past 1/2");
    expect_close(left.first, -(2 + 16 * s / 9), 1e-17L * (1 + s), what + ", slope at 1/2");
    expect_derivatives(curve, 0, 1, {0.5L}, 4 + 4 * s + (s > 0 ? 2 / std::sqrt(s) : Real{0}), what);
    for (int i = 0; i < grid_count; ++i) {
      const Real d = grid_point(i, 0, 1);
      const Real u = d * d;
      const Real expected = d <= 0.5L ? 1 - (3 * u) * (3 * u) / (s + (4.5L - 4 * s) * u)
                                      : (1 - u) * (1 - u) / (0.75L - s + (1.5L + 4 * s) * u);
      expect_close(curve(d).value, expected, 1e-18L, what);
      EXPECT_LE(curve(d).first, 0) << what;
    }
  }
}

TEST(ReferenceCurves, RangeRemapMeetsItsPiecesAndIsSmoothInTheMiddle) {
  for (const Real w1 : {0.2L, 0.5L, 1.0L, 2.5L}) {
    for (const Real w2 : {0.1L, 0.2L, 0.5L, 1.0L}) {
      if (w2 > w1) continue;
      const std::string what = "remap " + std::to_string(w1) + " " + std::to_string(w2);
      const RangeRemap remap(w1, w2);
      const Real low = (1 - w2) / 2;
      const Real high = (1 + w1) / 2;
      expect_close(remap(low).value, 0, 1e-17L, what + " at its low end");
      expect_close(remap(low).first, 2 / w2 - 1 / w1, 1e-16L, what + ", slope at its low end");
      expect_close(remap(high).value, 1, 1e-18L, what + " at its high end");
      expect_same(remap(high + 1e-15L), {1, 0, 0}, 0, what);
      expect_same(remap(low - 1e-15L), {0, 0, 0}, 0, what);
      const CurvePoint before = remap(0.5L - 1e-19L);
      const CurvePoint middle = remap(0.5L);
      expect_close(middle.value, 0.5L, 0, what + " at 1/2");
      expect_close(before.value, middle.value, 1e-17L, what + " before 1/2");
      expect_close(before.first, middle.first, 1e-16L, what + ", slope before 1/2");
      expect_derivatives(remap, low, high, {0.5L}, 1 / w2, what);

      const RemappedCurve<BlancCurve> blanc(remap, BlancCurve(0.5L));
      expect_close(blanc(0.5L).value, 0.5L, 1e-18L, what + " of blanc at 1/2");
      for (const Real joint : {low, 0.5L, high}) {
        const CurvePoint left = blanc(joint - 1e-19L);
        const CurvePoint right = blanc(joint + 1e-18L);
        expect_close(left.value, right.value, 1e-16L, what + " of blanc across a joint");
        expect_close(left.first, right.first, 1e-14L, what + " of blanc, slope across a joint");
      }
      expect_derivatives(blanc, low, high, {0.5L}, 20 / w2, what + " of blanc");
      expect_same(blanc(high + 1e-15L), {0, 0, 0}, 0, what + " of blanc beyond its range");
      expect_same(blanc(low - 1e-15L), {1, 0, 0}, 0, what + " of blanc below its range");
    }
  }
  for (int i = 0; i < grid_count; ++i) {
    const Real d = grid_point(i, 0, 1);
    expect_same(RangeRemap(1, 1)(d), {d, 1, 0}, 1e-19L, "remap by 1 and 1");
  }
}

TEST(ReferenceCurves, FormulasRefuseBadParameters) {
  EXPECT_THROW(WyvillCurve(0, 0.5L), std::invalid_argument);
  EXPECT_THROW(WyvillCurve(1, 0.5L), std::invalid_argument);
  EXPECT_THROW(ArctangentCurve::plain(0, 0.5L), std::invalid_argument);
  EXPECT_THROW(BlancCurve(-0.01L), std::invalid_argument);
  EXPECT_THROW(RangeRemap(0, 0.5L), std::invalid_argument);
  EXPECT_THROW(RangeRemap(0.5L, 0), std::invalid_argument);
  EXPECT_THROW(RangeRemap(0.5L, 0.6L), std::invalid_argument);
  EXPECT_THROW(RangeRemap(2, 1.1L), std::invalid_argument);
}

// ---------------------------------------------------------------- potentials by points

TEST(ReferenceCurves, NaturalSplineSatisfiesItsDefinition) {
  for (std::size_t count = 3; count <= 10; ++count) {
    std::vector<Real> x;
    std::vector<Real> y;
    for (std::size_t i = 0; i < count; ++i) {
      const Real share = static_cast<Real>(i) / static_cast<Real>(count - 1);
      x.push_back(share * (0.6L + 0.4L * share));
      y.push_back(cubic_potential(share) + 0.05L * std::sin(9 * share));
    }
    x.back() = 1;
    y.front() = 1;
    y.back() = 0;
    const std::string what = "natural spline of " + std::to_string(count);
    const NaturalSplineCurve spline(x, y);
    expect_outside(spline, what);
    const std::vector<Real> inner(x.begin() + 1, x.end() - 1);
    expect_derivatives(spline, 0, 1, inner, 4, what);
    expect_close(spline(0).second, 0, 1e-18L, what + ", second derivative at 0");
    expect_close(spline(1).second, 0, 1e-15L, what + ", second derivative at 1");
    Real greatest = spline(1).first;
    for (std::size_t i = 0; i < count; ++i) {
      expect_close(spline(x[i]).value, y[i], 1e-17L, what + " through its points");
      greatest = std::max(greatest, spline(x[i]).first);
      if (i > 0 && i + 1 < count) expect_same(spline(std::nextafter(x[i], 0.0L)), spline(x[i]), 2e-15L, what);
      if (i + 1 == count) continue;
      // One cubic a segment: its second derivative is the chord's at the middle.
      const Real middle = (x[i] + x[i + 1]) / 2;
      expect_close(spline(middle).second, (spline(x[i]).second + spline(x[i + 1]).second) / 2, 2e-15L, what);
    }
    for (int i = 0; i < grid_count; ++i) greatest = std::max(greatest, spline(grid_point(i, 0, 1)).first);
    EXPECT_GE(spline.greatest_slope(), greatest - 1e-17L) << what;
    EXPECT_LE(spline.greatest_slope(), greatest + 1e-3L) << what;
  }
}

TEST(ReferenceCurves, NaturalSplinesWorkedByHand) {
  const NaturalSplineCurve bent({0, 0.5L, 1}, {1, 0.8L, 0});
  expect_same(bent(0.5L), {0.8L, -1, -3.6L}, 1e-17L, "spline of three points");
  expect_close(bent.greatest_slope(), -0.1L, 1e-17L, "greatest slope");
  const NaturalSplineCurve line({0, 0.3L, 0.4L, 1}, {1, 0.7L, 0.6L, 0});
  for (int i = 0; i < grid_count; ++i) {
    const Real r = grid_point(i, 0, 1);
    expect_same(line(r), {1 - r, -1, 0}, 1e-17L, "spline of points on a line");
  }
  EXPECT_GT(NaturalSplineCurve({0, 0.45L, 0.55L, 1}, {1, 0.95L, 0.05L, 0}).greatest_slope(), 0);
}

TEST(ReferenceCurves, BezierAgreesWithDeCasteljauAndHasTheOrderOfItsEqualEnds) {
  const std::vector<Real> pattern{1, 0.7L, 0.9L, 0.2L, 0.65L, 0.1L, 0.35L, 0.55L, 0.15L, 0};
  for (std::size_t n = 1; n <= 9; ++n) {
    std::vector<Real> ordinates(pattern.begin(), pattern.begin() + static_cast<std::ptrdiff_t>(n));
    ordinates.push_back(0);
    const BezierCurve curve(ordinates);
    const std::string what = "bezier " + std::to_string(n);
    expect_ends(curve, 0, what);
    expect_derivatives(curve, 0, 1, {}, 4, what);
    for (int i = 0; i < grid_count; ++i) {
      const Real r = grid_point(i, 0, 1);
      std::vector<Real> points = ordinates;
      for (std::size_t level = n; level > 0; --level) {
        for (std::size_t j = 0; j < level; ++j) points[j] = (1 - r) * points[j] + r * points[j + 1];
      }
      expect_close(curve(r).value, points[0], 1e-18L, what);
    }
  }
  expect_ends(BezierCurve({1, 1, 0, 0}), 1, "bezier of order 1");
  expect_ends(BezierCurve({1, 1, 1, 0, 0, 0}), 2, "bezier of order 2");
  expect_antisymmetric_potential(BezierCurve({1, 1, 1, 0, 0, 0}), "bezier of order 2");
  for (int i = 0; i < grid_count; ++i) {
    const Real r = grid_point(i, 0, 1);
    expect_same(BezierCurve({1, 1, 0, 0})(r), CubicCurve()(r), 1e-17L, "cubic as bezier");
  }
}

/// Cox–de Boor, the basis function of the given degree over knots i…i + degree + 1.
Real basis(std::size_t degree, std::size_t i, const std::vector<Real>& knots, Real x) {
  if (degree == 0) return x >= knots[i] && x < knots[i + 1] ? 1 : 0;
  Real sum = 0;
  const Real rising = knots[i + degree] - knots[i];
  const Real falling = knots[i + degree + 1] - knots[i + 1];
  if (rising > 0) sum += (x - knots[i]) / rising * basis(degree - 1, i, knots, x);
  if (falling > 0) sum += (knots[i + degree + 1] - x) / falling * basis(degree - 1, i + 1, knots, x);
  return sum;
}

TEST(ReferenceCurves, ExplicitBsplineAgreesWithTheCoxDeBoorBasis) {
  struct Example {
    int degree;
    std::vector<Real> knots;
    std::vector<Real> coefficients;
  };
  const std::vector<Example> examples{
      {1, {0, 0, 0.3L, 1, 1}, {1, 0.4L, 0}},
      {2, {0, 0, 0, 0.4L, 0.4L, 1, 1, 1}, {1, 1, 0.6L, 0.3L, 0}},
      {3, {0, 0, 0, 0, 0.2L, 0.55L, 0.7L, 1, 1, 1, 1}, {1, 1, 0.9L, 0.4L, 0.1L, 0, 0}},
      {3,
       {-0.75L, -0.5L, -0.25L, 0, 0.25L, 0.5L, 0.75L, 1, 1.25L, 1.5L, 1.75L},
       {1, 0.9L, 0.8L, 0.5L, 0.2L, 0, 0}},
      {5, {0, 0, 0, 0, 0, 0, 0.5L, 1, 1, 1, 1, 1, 1}, {1, 1, 1, 0.5L, 0, 0, 0}},
  };
  for (const Example& example : examples) {
    const ExplicitBsplineCurve curve(example.degree, example.knots, example.coefficients);
    const std::string what = "B-spline of degree " + std::to_string(example.degree);
    expect_outside(curve, what);
    expect_derivatives(curve, 0, 1, example.knots, 8, what);
    const auto degree = static_cast<std::size_t>(example.degree);
    for (int i = 0; i < grid_count; ++i) {
      const Real r = grid_point(i, 0, 1);
      Real expected = 0;
      for (std::size_t j = 0; j < example.coefficients.size(); ++j) {
        expected += example.coefficients[j] * basis(degree, j, example.knots, r);
      }
      expect_close(curve(r).value, expected, 1e-18L, what);
    }
  }
  expect_ends(ExplicitBsplineCurve(5, examples[4].knots, examples[4].coefficients), 2, "B-spline of order 2");
  expect_antisymmetric_potential(ExplicitBsplineCurve(5, examples[4].knots, examples[4].coefficients),
                                 "B-spline");
}

TEST(ReferenceCurves, BsplineOverBezierKnotsIsTheBezierCurve) {
  const std::vector<Real> pattern{1, 1, 0.9L, 0.3L, 0.75L, 0.2L, 0.3L, 0.1L, 0.05L, 0};
  for (int n = 1; n <= 9; ++n) {
    const auto size = static_cast<std::size_t>(n + 1);
    const std::vector<Real> ordinates(pattern.begin(), pattern.begin() + n + 1);
    std::vector<Real> knots(size, 0);
    knots.insert(knots.end(), size, 1);
    const ExplicitBsplineCurve bspline(n, knots, ordinates);
    const BezierCurve bezier(ordinates);
    for (int i = 0; i < grid_count; ++i) {
      const Real r = grid_point(i, 0, 1);
      expect_same(bspline(r), bezier(r), 1e-16L, "B-spline over Bezier knots");
    }
  }
}

TEST(ReferenceCurves, ParametricBezierPassesThroughThePointsOfItsCurve) {
  using Points = std::array<ParametricBezierCurve::ControlPoint, 4>;
  const auto expect_on_curve = [](const Points& points, Real sharpness, const std::string& what) {
    const ParametricBezierCurve curve(points);
    expect_outside(curve, what);
    expect_derivatives(curve, 0, 1, {}, sharpness, what);
    for (int i = 0; i < grid_count; ++i) {
      const Real t = grid_point(i, 0, 1);
      const Real weights[4] = {(1 - t) * (1 - t) * (1 - t), 3 * t * (1 - t) * (1 - t), 3 * t * t * (1 - t),
                               t * t * t};
      Real r = 0;
      Real f = 0;
      for (std::size_t j = 0; j < 4; ++j) {
        r += weights[j] * points[j].r;
        f += weights[j] * points[j].f;
      }
      // A rounding of r is magnified by the slope.
      expect_close(curve(r).value, f, 1e-18L * (1 + std::fabs(curve(r).first)), what);
      expect_close(curve.parameter(r), t, 1e-18L * sharpness, what + ", parameter");
    }
  };
  for (const Real c : {0.2L, Real{1} / 3, 0.5L, 0.8L, 0.95L}) {
    const std::string what = "parametric bezier " + std::to_string(c);
    expect_on_curve({{{0, 1}, {c, 1}, {1 - c, 0}, {1, 0}}}, 16 / (1 - c), what);
    expect_ends(ParametricBezierCurve(c), 1, what);
    expect_antisymmetric_potential(ParametricBezierCurve(c), what);
    expect_close(ParametricBezierCurve(c)(0.5L).first, -1 / (1 - c), 1e-16L, what + ", slope at 1/2");
  }
  expect_on_curve({{{0, 1}, {0.4L, 0.9L}, {0.5L, 0.1L}, {1, 0}}}, 16, "parametric bezier of four points");
  expect_on_curve({{{0, 1}, {0.9L, 1}, {0.8L, 0.3L}, {1, 0}}}, 32, "parametric bezier of four points");
}

TEST(ReferenceCurves, SoftParametricBezierIsTheCubic) {
  const ParametricBezierCurve soft(Real{1} / 3);
  for (int i = 0; i < grid_count; ++i) {
    const Real r = grid_point(i, 0, 1);
    expect_same(soft(r), CubicCurve()(r), 1e-16L, "parametric bezier with c = 1/3");
  }
}

TEST(ReferenceCurves, CurvesThroughPointsRefuseBadParameters) {
  EXPECT_THROW(NaturalSplineCurve({0, 1}, {1, 0}), std::invalid_argument);
  EXPECT_THROW(NaturalSplineCurve({0, 0.5L, 0.5L, 1}, {1, 0.5L, 0.4L, 0}), std::invalid_argument);
  EXPECT_THROW(NaturalSplineCurve({0, 0.5L, 0.9L}, {1, 0.5L, 0}), std::invalid_argument);
  EXPECT_THROW(NaturalSplineCurve({0, 0.5L, 1}, {1, 0.5L}), std::invalid_argument);
  EXPECT_THROW(BezierCurve({1}), std::invalid_argument);
  EXPECT_THROW(BezierCurve(std::vector<Real>(11, 1)), std::invalid_argument);
  EXPECT_THROW(ExplicitBsplineCurve(2, {0, 0, 0, 1, 1}, {1, 0.5L, 0}), std::invalid_argument);
  EXPECT_THROW(ExplicitBsplineCurve(1, {0, 0, 0.6L, 0.4L, 1, 1}, {1, 0.5L, 0.5L, 0}), std::invalid_argument);
  EXPECT_THROW(ExplicitBsplineCurve(1, {0, 0, 0.5L, 0.5L, 1, 1}, {1, 0.5L, 0.4L, 0}), std::invalid_argument);
  EXPECT_THROW(ExplicitBsplineCurve(1, {0, 0.1L, 0.5L, 1, 1}, {1, 0.5L, 0}), std::invalid_argument);
  EXPECT_THROW(ParametricBezierCurve(1), std::invalid_argument);
  EXPECT_THROW(ParametricBezierCurve(1.2L), std::invalid_argument);
  EXPECT_THROW(ParametricBezierCurve(0), std::invalid_argument);
  EXPECT_THROW(ParametricBezierCurve({{{0, 1}, {0.5L, 1}, {0.5L, 0}, {0.9L, 0}}}), std::invalid_argument);
  EXPECT_THROW(ParametricBezierCurve({{{0, 1}, {1.5L, 1}, {-0.5L, 0}, {1, 0}}}), std::invalid_argument);
}

}  // namespace
