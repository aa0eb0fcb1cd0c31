#pragma once
/// Checks of a curve that need only its CurvePoint: closeness, derivatives, continuation of a piece.

#include <gtest/gtest.h>

#include <cmath>
#include <reference/curve_point.hpp>
#include <reference/vector.hpp>
#include <string>
#include <vector>

namespace nearfield::reference {

inline constexpr int grid_count = 1009;

/// Points strictly inside (low, high) that avoid simple fractions.
inline Real grid_point(int i, Real low, Real high) {
  return low + (high - low) * (static_cast<Real>(i) + 0.37L) / static_cast<Real>(grid_count);
}

inline void expect_close(Real actual, Real expected, Real tolerance, const std::string& what) {
  EXPECT_LE(std::fabs(actual - expected), tolerance) << what << ": " << actual << " instead of " << expected;
}

inline void expect_same(const CurvePoint& actual, const CurvePoint& expected, Real tolerance,
                        const std::string& what) {
  expect_close(actual.value, expected.value, tolerance, what + ", value");
  expect_close(actual.first, expected.first, tolerance, what + ", first derivative");
  expect_close(actual.second, expected.second, tolerance, what + ", second derivative");
}

/// Central difference of fourth order.
template <class Function>
Real central_difference(const Function& function, Real x, Real h) {
  return (8 * (function(x + h) - function(x - h)) - (function(x + 2 * h) - function(x - 2 * h))) / (12 * h);
}

/// Both derivatives against central differences all over (low, high), but next to the `breaks` (where a third
/// or lower derivative jumps). `sharpness` is the reciprocal of the length over which the curve changes.
template <class Curve>
void expect_derivatives(const Curve& curve, Real low, Real high, const std::vector<Real>& breaks,
                        Real sharpness, const std::string& what) {
  const Real h = 1e-3L / sharpness;
  for (int i = 0; i < grid_count; ++i) {
    const Real x = grid_point(i, low, high);
    bool is_near_break = x - 2 * h < low || x + 2 * h > high;
    for (const Real at : breaks) is_near_break = is_near_break || std::fabs(x - at) <= 2 * h;
    if (is_near_break) continue;
    const CurvePoint here = curve(x);
    const Real first = central_difference([&](Real y) { return curve(y).value; }, x, h);
    const Real second = central_difference([&](Real y) { return curve(y).first; }, x, h);
    const std::string place = what + " at " + std::to_string(x);
    expect_close(here.first, first, 3e-10L * sharpness, place + ", first derivative");
    expect_close(here.second, second, 3e-10L * sharpness * sharpness, place + ", second derivative");
  }
}

/// The polynomial through n + 1 samples of the piece from `start` to `start + length`, at x (Lagrange).
template <class Curve>
Real continued_piece(const Curve& curve, int n, Real start, Real length, Real x) {
  Real sum = 0;
  const auto node = [&](int i) { return start + length * static_cast<Real>(i) / static_cast<Real>(n); };
  for (int i = 0; i <= n; ++i) {
    Real term = curve(node(i)).value;
    for (int j = 0; j <= n; ++j) {
      if (j != i) term *= (x - node(j)) / (node(i) - node(j));
    }
    sum += term;
  }
  return sum;
}

}  // namespace nearfield::reference
