// Checks of the long double ray-linear blends: known points, homogeneity, the two forms of Hsu's roots,
// continuity at the edges of their regions, derivatives by differences.

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <reference/random.hpp>
#include <reference/ray_linear_blends.hpp>
#include <reference/vector.hpp>
#include <stdexcept>
#include <string>
#include <vector>

#include "curve_expectations.hpp"

namespace {

using namespace nearfield::reference;

using ManyBlend = std::function<ManyBlendPoint(const std::vector<Real>&)>;

void expect_partials(const ManyBlend& blend, const std::vector<Real>& x, Real tolerance,
                     const std::string& what) {
  const ManyBlendPoint point = blend(x);
  ASSERT_EQ(point.partials.size(), x.size()) << what;
  for (std::size_t i = 0; i < x.size(); ++i) {
    const auto along = [&](Real moved) {
      std::vector<Real> shifted = x;
      shifted[i] = moved;
      return blend(shifted).value;
    };
    expect_close(point.partials[i], central_difference(along, x[i], 1e-4L * x[i]), tolerance,
                 what + ", operand " + std::to_string(i));
  }
}

// Euler's relation: a ray-linear function is the sum of its operands times its derivatives.
void expect_ray_linear(const ManyBlend& blend, const std::vector<Real>& x, Real tolerance) {
  const ManyBlendPoint point = blend(x);
  Real sum = 0;
  std::vector<Real> scaled = x;
  for (std::size_t i = 0; i < x.size(); ++i) {
    sum += point.partials[i] * x[i];
    scaled[i] = 3 * x[i];
  }
  expect_close(sum, point.value, tolerance * point.value, "Euler");
  expect_close(blend(scaled).value, 3 * point.value, tolerance * point.value, "homogeneous");
}

ScaleRanges random_ranges(Random& random, Real greatest, Real lowest_p) {
  ScaleRanges ranges;
  ranges.r1 = random.uniform(0.02L, greatest);
  ranges.r2 = random.uniform(0.02L, greatest);
  ranges.p = random.chance(0.5L) ? random.uniform(lowest_p, ranges.r1 * ranges.r2)
                                 : ranges.r1 * ranges.r2 * (1 - random.uniform(0.001L, 1));
  return ranges;
}

TEST(ReferenceRayLinearBlends, SuperEllipsoidsPassThroughKnownPoints) {
  for (const Real n : {0.6L, 1.0L, 2.0L, 7.5L, 40.0L}) {
    expect_close(super_ellipsoidal_intersection(n, {1, 0, 0}).value, 1, 1e-18L, "on an axis");
    expect_close(super_ellipsoidal_intersection(n, {0, 0.5L}).value, 0.5L, 1e-18L, "on an axis");
    expect_close(super_ellipsoidal_intersection(n, {1, 1}).value, std::pow(2.0L, 1 / n), 1e-18L, "tie");
    expect_close(super_ellipsoidal_union(n, {1, 1, 1}).value, std::pow(3.0L, -1 / n), 1e-18L, "tie");
    EXPECT_EQ(super_ellipsoidal_union(n, {1, 0, 2}).value, 0);
    EXPECT_EQ(super_ellipsoidal_intersection(n, {0, 0}).value, 0);
  }
  expect_close(super_ellipsoidal_intersection(2, {3, 4}).value, 5, 1e-18L, "3, 4, 5");
  expect_close(super_ellipsoidal_union(1, {3, 6}).value, 2, 1e-18L, "harmonic");
  EXPECT_THROW(super_ellipsoidal_union(0, {1}), std::invalid_argument);
  EXPECT_THROW(super_ellipsoidal_union(2, {1, -1}), std::invalid_argument);
  EXPECT_THROW(super_ellipsoidal_union(2, {}), std::invalid_argument);
}

TEST(ReferenceRayLinearBlends, SuperEllipsoidalDifferenceKeepsTheSurfaceButNotTheRays) {
  // Far inside the first solid and far outside the second each one's surface remains.
  expect_close(super_ellipsoidal_difference(20, {1, 3}).value, 1, 1e-9L, "surface of the first");
  expect_close(super_ellipsoidal_difference(20, {0.3L, 1}).value, 1, 1e-9L, "surface of the second");
  expect_close(super_ellipsoidal_difference(20, {0.1L, 0.5L}, 0.5L).value, 0.5L, 1e-9L,
               "surface at one half");
  EXPECT_GT(super_ellipsoidal_difference(6, {0.5L, 0.9L}).value, 1);  // inside the second
  EXPECT_GT(super_ellipsoidal_difference(6, {1.1L, 5}).value, 1);     // outside the first
  EXPECT_LT(super_ellipsoidal_difference(6, {0.5L, 5, 4}).value, 1);  // inside the difference
  EXPECT_GT(super_ellipsoidal_difference(6, {0.5L, 5, 0.8L}).value, 1);
  const ManyBlendPoint at_center = super_ellipsoidal_difference(6, {0, 0});
  EXPECT_TRUE(std::isinf(at_center.value));
  EXPECT_EQ(at_center.partials[0], 0);
  const Real once = super_ellipsoidal_difference(6, {0.6L, 1.5L}).value;
  const Real twice = super_ellipsoidal_difference(6, {1.2L, 3}).value;
  EXPECT_GT(std::fabs(twice - 2 * once), 0.01L);
}

TEST(ReferenceRayLinearBlends, SuperEllipsoidalDerivatives) {
  Random random(announced_seed("ReferenceRayLinearBlends.SuperEllipsoidalDerivatives", 32));
  for (int i = 0; i < 200; ++i) {
    const Real n = random.uniform(0.6L, 12);
    const std::vector<Real> x{random.uniform(0.2L, 2), random.uniform(0.2L, 2), random.uniform(0.2L, 2)};
    const ManyBlend both[] = {
        [n](const std::vector<Real>& o) { return super_ellipsoidal_intersection(n, o); },
        [n](const std::vector<Real>& o) { return super_ellipsoidal_union(n, o); }};
    for (const ManyBlend& blend : both) {
      expect_partials(blend, x, 1e-9L, "super-ellipsoidal");
      expect_ray_linear(blend, x, 1e-17L);
    }
    expect_partials([n](const std::vector<Real>& o) { return super_ellipsoidal_difference(n, o); }, x, 1e-7L,
                    "difference");
  }
  EXPECT_EQ(super_ellipsoidal_intersection(3, {2, 0}).partials[0], 1);
  EXPECT_EQ(super_ellipsoidal_intersection(3, {2, 0}).partials[1], 0);
  EXPECT_EQ(super_ellipsoidal_union(3, {2, 0}).partials[1], 1);
  expect_close(super_ellipsoidal_union(2, {0, 0}).partials[0], 0.5L * std::pow(2.0L, -0.5L), 1e-18L,
               "origin");
}

TEST(ReferenceRayLinearBlends, BothFormsOfTheScaleUnionAgree) {
  Random random(announced_seed("ReferenceRayLinearBlends.BothFormsOfTheScaleUnionAgree", 33));
  int blended = 0;
  for (int i = 0; i < 1500; ++i) {
    const ScaleRanges ranges = random_ranges(random, 3, random.chance(0.5L) ? -3.0L : -200.0L);
    const Real x1 = random.uniform(0.1L, 3);
    const Real x2 = x1 * random.uniform(0.4L, 2.5L);
    const Real h = scale_union(ranges, x1, x2).value;
    expect_close(scale_union_in_closed_form(ranges, x1, x2), h, 1e-15L, "two forms");
    EXPECT_LE(h, std::min(x1, x2));
    if (in_scale_region(ranges, 1, x1, x2)) {
      ++blended;
      EXPECT_GE(h, (ranges.r2 * x1 + ranges.r1 * x2) / (ranges.r1 + ranges.r2 + ranges.r1 * ranges.r2));
    }
  }
  EXPECT_GT(blended, 300);
}

TEST(ReferenceRayLinearBlends, BothFormsOfTheScaleIntersectionAgree) {
  Random random(announced_seed("ReferenceRayLinearBlends.BothFormsOfTheScaleIntersectionAgree", 34));
  int blended = 0;
  for (int i = 0; i < 1500; ++i) {
    const ScaleRanges ranges = random_ranges(random, i % 4 == 0 ? 1.9L : 1.0L, i % 2 == 0 ? -3.0L : -200.0L);
    const Real x1 = random.uniform(0.1L, 3);
    const Real x2 = x1 * random.uniform(0, 2.5L);
    const Real h = scale_intersection(ranges, x1, x2).value;
    expect_close(scale_intersection_in_closed_form(ranges, x1, x2), h, 1e-15L * h, "two forms");
    EXPECT_GE(h, std::max(x1, x2));
    if (in_scale_region(ranges, -1, x1, x2)) {
      ++blended;
      EXPECT_LE(h, (ranges.r2 * x1 + ranges.r1 * x2) / (ranges.r1 + ranges.r2 - ranges.r1 * ranges.r2));
    }
  }
  EXPECT_GT(blended, 300);
}

TEST(ReferenceRayLinearBlends, ClosedFormPassesTheVanishingLeadingCoefficient) {
  // a = (r₁ + r₂ ± r₁r₂)² − 2(r₁r₂ − p) vanishes at one p and changes its sign there.
  for (const Real sign : {1.0L, -1.0L}) {
    const Real r1 = 0.5L;
    const Real r2 = 0.25L;
    const Real sum = r1 + r2 + sign * r1 * r2;
    const Real vanishing = r1 * r2 - sum * sum / 2;
    for (const Real offset : {-1e-3L, -1e-17L, 0.0L, 1e-17L, 1e-3L}) {
      const ScaleRanges ranges{r1, r2, vanishing + offset};
      for (const Real x2 : {0.8L, 0.9L, 1.0L, 1.1L, 1.2L}) {
        const Real by_bisection = scale_point(ranges, sign, 1, x2).value;
        const Real closed = sign > 0 ? scale_union_in_closed_form(ranges, 1, x2)
                                     : scale_intersection_in_closed_form(ranges, 1, x2);
        expect_close(closed, by_bisection, 1e-16L, "near a = 0");
      }
    }
  }
}

TEST(ReferenceRayLinearBlends, SymmetricTieAndChamfer) {
  // At x₁ = x₂ = 1 and r₁ = r₂ = r: u = v and r² − 2ru = u√(2q), so u = r²/(2r + √(2q)).
  for (const Real p : {-5.0L, -0.1L, 0.0L, 0.2L}) {
    const Real u = 0.25L / (1 + std::sqrt(2 * (0.25L - p)));
    expect_close(scale_union({0.5L, 0.5L, p}, 1, 1).value, 1 / (1 + u), 1e-18L, "union");
    expect_close(scale_intersection({0.5L, 0.5L, p}, 1, 1).value, 1 / (1 - u), 1e-18L, "intersection");
  }
  const BlendPoint chamfer = scale_union({0.5L, 0.25L, 0.125L}, 1, 1.1L);
  const Real divisor = 0.5L + 0.25L + 0.125L;
  expect_close(chamfer.value, (0.25L + 0.5L * 1.1L) / divisor, 1e-18L, "chamfer");
  expect_close(chamfer.by_x, 0.25L / divisor, 1e-18L, "chamfer, derivative");
}

// Value and derivatives on both sides of an edge of the region; the second operand is `slope` times the
// first.
void expect_smooth_edge(const ScaleRanges& ranges, Real sign, Real slope) {
  constexpr Real h = 1e-9L;
  const BlendPoint before = scale_point(ranges, sign, 1.3L, 1.3L * (slope - h));
  const BlendPoint after = scale_point(ranges, sign, 1.3L, 1.3L * (slope + h));
  const std::string what = "edge at ratio " + std::to_string(slope) + ", p " + std::to_string(ranges.p);
  expect_close(before.value, after.value, 1e-8L * (1 + slope), what);
  expect_close(before.by_x, after.by_x, 2e-6L, what + ", by x1");
  expect_close(before.by_y, after.by_y, 2e-6L, what + ", by x2");
  EXPECT_NE(in_scale_region(ranges, sign, 1, slope - h), in_scale_region(ranges, sign, 1, slope + h)) << what;
}

TEST(ReferenceRayLinearBlends, EdgesOfTheRegionsAreSmooth) {
  for (const Real p : {-3.0L, -0.5L, 0.0L, 0.05L, 0.1L}) {
    const ScaleRanges ranges{0.6L, 0.3L, p};
    expect_smooth_edge(ranges, 1, 1 + ranges.r2);
    expect_smooth_edge(ranges, 1, 1 / (1 + ranges.r1));
    expect_smooth_edge(ranges, -1, 1 - ranges.r2);
    expect_smooth_edge(ranges, -1, 1 / (1 - ranges.r1));
  }
  // At r = 1 the edge of the intersection is the axis itself.
  expect_close(scale_intersection({1, 1, 0}, 1, 0).value, 1, 0, "axis");
  expect_close(scale_intersection({1, 1, 0}, 1, 1e-9L).value, 1, 1e-8L, "near the axis");
  // Beyond, the blend moves even what lies on the axis.
  EXPECT_GT(scale_intersection({1.5L, 1.5L, 0}, 1, 0).value, 1.05L);
}

TEST(ReferenceRayLinearBlends, ScaleDerivativesAndHomogeneity) {
  Random random(announced_seed("ReferenceRayLinearBlends.ScaleDerivativesAndHomogeneity", 35));
  for (int i = 0; i < 300; ++i) {
    const Real sign = i % 2 == 0 ? 1 : -1;
    ScaleRanges ranges = random_ranges(random, 0.95L, -3);
    ranges.r1 += 0.04L;  // wide enough for the differences
    ranges.r2 += 0.04L;
    const Real low = sign > 0 ? 1 / (1 + ranges.r1) : 1 - ranges.r2;
    const Real high = sign > 0 ? 1 + ranges.r2 : 1 / (1 - std::min(ranges.r1, 0.9L));
    const Real place = random.uniform(0.02L, 0.98L);
    const std::vector<Real> x{1.7L, 1.7L * (low + place * (high - low))};
    const ManyBlend blend = [&](const std::vector<Real>& o) {
      const BlendPoint point = scale_point(ranges, sign, o[0], o[1]);
      return ManyBlendPoint{point.value, {point.by_x, point.by_y}};
    };
    const std::string what = "r1 " + std::to_string(ranges.r1) + " r2 " + std::to_string(ranges.r2) + " p " +
                             std::to_string(ranges.p) + " place " + std::to_string(place);
    expect_partials(blend, x, 1e-4L, what);
    expect_ray_linear(blend, x, 1e-15L);
    EXPECT_GE(blend(x).partials[0], 0);
    EXPECT_GE(blend(x).partials[1], 0);
  }
}

TEST(ReferenceRayLinearBlends, SequencesAndOrigin) {
  const ScaleRanges ranges{0.5L, 0.5L, 0};
  const std::vector<Real> x{1, 1.1L, 0.95L, 1.05L};
  for (const bool is_union : {true, false}) {
    const ManyBlend blend = [&](const std::vector<Real>& o) {
      return is_union ? sequential_scale_union(ranges, o) : sequential_scale_intersection(ranges, o);
    };
    expect_partials(blend, x, 1e-9L, "sequence");
    expect_ray_linear(blend, x, 1e-16L);
  }
  EXPECT_EQ(sequential_scale_union(ranges, {0.7L}).value, 0.7L);
  EXPECT_LT(sequential_scale_union(ranges, x).value, 0.95L);
  EXPECT_GT(sequential_scale_intersection(ranges, x).value, 1.1L);
  const BlendPoint origin = scale_union(ranges, 0, 0);
  EXPECT_EQ(origin.value, 0);
  expect_close(2 * origin.by_x, scale_union(ranges, 1, 1).value, 1e-18L, "along the diagonal");
  EXPECT_EQ(scale_union(ranges, 0, 1).value, 0);
}

TEST(ReferenceRayLinearBlends, ParametersOutsideTheirRangesAreRefused) {
  EXPECT_THROW(scale_union({0, 1, 0}, 1, 1), std::invalid_argument);
  EXPECT_THROW(scale_union({0.5L, 0.5L, 0.26L}, 1, 1), std::invalid_argument);
  EXPECT_THROW(scale_intersection({2, 2, 0}, 1, 1), std::invalid_argument);
  EXPECT_THROW(scale_union({0.5L, 0.5L, 0}, -1, 1), std::invalid_argument);
  EXPECT_NO_THROW(scale_union({2, 2, 0}, 1, 1));
}

}  // namespace
