// Checks of the long double soft blends, of Hsu's variable radius, and of the dense search for clearances.

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <reference/potential_curves.hpp>
#include <reference/random.hpp>
#include <reference/soft_blends.hpp>
#include <reference/soft_clearance.hpp>
#include <reference/vector.hpp>
#include <stdexcept>
#include <string>
#include <vector>

#include "curve_expectations.hpp"

namespace {

using namespace nearfield::reference;

// 1 − 3r² + 2r³ in double, which is fast.
struct FastCubic {
  struct Result {
    double value;
    double first;
  };
  Result operator()(double r) const { return {1 + r * r * (2 * r - 3), 6 * r * (r - 1)}; }
};

TEST(ReferenceSoftBlends, SumOfPotentials) {
  const ManyBlendPoint sum =
      sum_of_potentials({{1, CubicCurve{}, 0.5L}, {-0.5L, BlancCurve(0.3L), 0.5L}, {2, CubicCurve{}, 1.5L}});
  expect_close(sum.value, 0.5L - 0.25L, 1e-18L, "value");
  ASSERT_EQ(sum.partials.size(), 3U);
  expect_close(sum.partials[0], -1.5L, 1e-18L, "derivative");
  expect_close(sum.partials[1], -0.5L * BlancCurve(0.3L)(0.5L).first, 1e-18L, "derivative");
  EXPECT_EQ(sum.partials[2], 0);
}

TEST(ReferenceSoftBlends, VariableRadiusIsHsusRemapWithAConstantWidth) {
  for (const Real w1 : {0.4L, 1.0L, 1.7L}) {
    for (const Real w2 : {0.2L, 0.4L, 1.0L}) {
      if (w2 > w1) continue;
      const RangeRemap remap(w1, w2);
      for (int i = 0; i < grid_count; ++i) {
        const Real d = grid_point(i, 0, 1.5L);
        const Real f = 2 * d / (1 + w1);  // so that 2d/f − 1 is w1
        expect_close(variable_range_remap(d, f, w2).value, remap(d).value, 1e-17L, "remap");
      }
    }
  }
}

TEST(ReferenceSoftBlends, ContourBoundsTheInfluenceAndLeavesTheSurface) {
  const PotentialFunction potential = BlancCurve(0);
  for (const Real f : {0.1L, 0.5L, 0.9L}) {
    expect_close(variable_radius_intensity(potential, 0.5L, f, 1).value, 0.5L, 1e-18L, "surface");
  }
  for (const Real d : {0.51L, 0.7L, 1.5L}) {
    EXPECT_EQ(variable_radius_intensity(potential, d, 1.001L, 1).value, 0) << "outside of the contour";
    expect_close(variable_radius_intensity(potential, d, 1, 1).value, 0, 1e-18L, "on the contour");
    EXPECT_GT(variable_radius_intensity(potential, d, 0.99L, 1).value, 0) << "inside of the contour";
  }
}

TEST(ReferenceSoftBlends, ContourThatCutsTheObjectLeavesItsInside) {
  // w₁ ≤ 0: the limit for w₁ → 0 from above.
  for (const Real w2 : {0.3L, 1.0L}) {
    for (const Real d : {0.1L, 0.3L, 0.49L, 0.51L, 0.8L}) {
      const BlendPoint at_limit = variable_range_remap(d, 2 * d, w2);
      expect_close(at_limit.value, d > 0.5L ? 1 : 0, 0, "limit");
      expect_close(variable_range_remap(d, 2 * d * (1 - 1e-9L), w2).value, at_limit.value, 1e-7L,
                   "towards it");
      EXPECT_EQ(variable_range_remap(d, 3 * d, w2).value, at_limit.value);
    }
    EXPECT_EQ(variable_range_remap(0.5L, 1, w2).value, 0.5L);
    EXPECT_EQ(variable_range_remap(0, 0, w2).value, 0);
    EXPECT_EQ(variable_range_remap(0, 0.3L, w2).value, 0) << "the centre is solid";
  }
  EXPECT_THROW(variable_range_remap(-0.1L, 1, 1), std::invalid_argument);
  EXPECT_THROW(variable_range_remap(0.1L, 1, 0), std::invalid_argument);
  EXPECT_THROW(variable_range_remap(0.1L, 1, 1.1L), std::invalid_argument);
}

TEST(ReferenceSoftBlends, VariableRadiusNeverRisesAlongARayAndIsContinuous) {
  for (const Real ratio : {0.3L, 0.7L, 1.0L, 1.4L, 1.9L, 1.99L}) {  // f/d, so that w₁ = 2/ratio − 1
    for (const Real w2 : {0.2L, 0.7L, 1.0L}) {
      Real before = 1;
      for (int i = 1; i < 4000; ++i) {
        const Real d = static_cast<Real>(i) / 2000;
        const Real value = variable_radius_intensity(CubicCurve{}, d, ratio * d, w2).value;
        EXPECT_LE(value, before + 1e-18L) << ratio << " " << w2 << " " << d;
        const Real greatest_slope = 1.5L * std::max(1 / (2 / ratio - 1), 2 / w2);
        EXPECT_LE(before - value, greatest_slope / 2000 * 1.01L) << ratio << " " << w2 << " " << d;
        before = value;
      }
    }
  }
}

TEST(ReferenceSoftBlends, VariableRadiusDerivatives) {
  Random random(announced_seed("ReferenceSoftBlends.VariableRadiusDerivatives", 36));
  constexpr Real h = 1e-6L;
  int compared = 0;
  for (int i = 0; i < 3000; ++i) {
    const Real d = random.uniform(0.02L, 1.5L);
    const Real f = random.uniform(0.02L, 1.6L);
    const Real w2 = random.uniform(0.1L, 1);
    const bool is_near_edge = std::fabs(d - 0.5L) < 0.01L || std::fabs(f - 1) < 0.01L ||
                              std::fabs(d - (1 - w2) / 2) < 0.01L || std::fabs(2 * d - f) < 0.1L;
    const Real inside = variable_range_remap(d, f, w2).value;
    if (is_near_edge || (inside < 0.01L && inside > 0)) continue;
    ++compared;
    const PotentialFunction potential = CubicCurve{};
    const BlendPoint point = variable_radius_intensity(potential, d, f, w2);
    const auto by_d = [&](Real x) { return variable_radius_intensity(potential, x, f, w2).value; };
    const auto by_f = [&](Real x) { return variable_radius_intensity(potential, d, x, w2).value; };
    const std::string what = std::to_string(d) + " " + std::to_string(f) + " " + std::to_string(w2);
    expect_close(point.by_x, central_difference(by_d, d, h), 1e-7L, what + ", by d");
    expect_close(point.by_y, central_difference(by_f, f, h), 1e-7L, what + ", by f");
  }
  EXPECT_GT(compared, 1000);
}

TEST(ReferenceSoftClearance, LoneBallsAreExact) {
  // Strength c: the surface is where P(r/R) = 1/2c; P(½) = ½, P(0.6) = 0.352, P(0.7) = 0.216.
  const std::array<double, 3> center{0.2, -0.1, 0.3};
  for (const auto& [strength, share] : {std::array{1.0, 0.5}, {0.5 / 0.352, 0.6}, {0.5 / 0.216, 0.7}}) {
    for (const double distance : {0.5, 0.9, 3.0, 40.0}) {
      const std::array<double, 3> p{0.2 + 0.48 * distance, -0.1 + 0.6 * distance, 0.3 - 0.64 * distance};
      const double expected = distance - 0.6 * share;
      const double found = soft_clearance({{center, 0.6, strength}}, FastCubic{}, p);
      EXPECT_NEAR(found, expected, 1e-9 * expected) << strength << " " << distance;
      // The long double curves serve as well.
      EXPECT_NEAR(soft_clearance({{center, 0.6, strength}}, taking_double(CubicCurve{}), p), expected,
                  1e-9 * expected);
    }
    EXPECT_EQ(soft_clearance({{center, 0.6, strength}}, FastCubic{}, center), 0);
  }
  EXPECT_TRUE(std::isinf(soft_clearance({{center, 0.6, 0.45}}, FastCubic{}, {1, 1, 1})));
}

TEST(ReferenceSoftClearance, TwoEqualBallsByTheirAxes) {
  // Centres at ±0.45 on x, R = 1: on the middle plane F = 2P(√(0.2025 + y²)) is ½ where P = ¼.
  const std::vector<SoftBall> balls{{{-0.45, 0, 0}, 1, 1}, {{0.45, 0, 0}, 1, 1}};
  double low = 0.5;
  double high = 1;
  for (int i = 0; i < 60; ++i) {
    const double middle = (low + high) / 2;
    (FastCubic{}(middle).value > 0.25 ? low : high) = middle;
  }
  const double waist = std::sqrt(low * low - 0.2025);
  const double from_side = soft_clearance(balls, FastCubic{}, {0, 1.6, 0});
  EXPECT_NEAR(from_side, 1.6 - waist, 1e-9);
  const SoftClearanceSearch<FastCubic> search(balls, FastCubic{});
  const double from_end = search.clearance({2.5, 0, 0});
  EXPECT_NEAR(search.intensity({2.5 - from_end, 0, 0}), 0.5, 1e-9);
}

TEST(ReferenceSoftClearance, DenserSearchesAndWalksFindNothingNearer) {
  Random random(announced_seed("ReferenceSoftClearance.DenserSearchesAndWalksFindNothingNearer", 37));
  SearchDensity denser;
  denser.directions = 900;
  denser.rays_per_ball = 240;
  denser.samples = 80;
  denser.descents = 60;
  const auto coordinates = [](const Vec3& v) {
    return std::array<double, 3>{static_cast<double>(v.x), static_cast<double>(v.y),
                                 static_cast<double>(v.z)};
  };
  int found = 0;
  for (int i = 0; i < 60; ++i) {
    std::vector<SoftBall> balls;
    const auto count = random.integer(1, 4);
    for (int k = 0; k < count; ++k) {
      const Real strength =
          k > 0 && random.chance(0.25L) ? random.uniform(-1, -0.2L) : random.uniform(0.4L, 1.3L);
      balls.push_back({coordinates(random.vector(-0.6L, 0.6L)), static_cast<double>(random.uniform(0.3L, 1)),
                       static_cast<double>(strength)});
    }
    const Vec3 p = random.vector(-1.5L, 1.5L);
    const SoftClearanceSearch<FastCubic> search(balls, FastCubic{});
    const double clearance = search.clearance(coordinates(p));
    const double dense = soft_clearance(balls, FastCubic{}, coordinates(p), denser);
    if (std::isinf(clearance)) {
      EXPECT_TRUE(std::isinf(dense)) << i;
      continue;
    }
    EXPECT_NEAR(clearance, dense, 1e-6 * clearance) << i;
    if (clearance == 0) {
      EXPECT_GE(search.intensity(coordinates(p)), 0.5) << i;
      continue;
    }
    ++found;
    // Nothing within the clearance is inside.
    for (int k = 0; k < 100; ++k) {
      const Real reach = static_cast<Real>(clearance) * (1 - 1e-6L) * std::cbrt(random.uniform());
      EXPECT_LT(search.intensity(coordinates(p + reach * random.unit_vector())), 0.5) << i;
    }
  }
  EXPECT_GT(found, 30);
}

}  // namespace
