// Checks of the long double algebraic blends: Hoffmann and Hopcroft, Liming, functional spline, I-patches.

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <cstddef>
#include <reference/algebraic_blends.hpp>
#include <reference/implicit_patches.hpp>
#include <reference/random.hpp>
#include <reference/vector.hpp>
#include <stdexcept>
#include <string>
#include <vector>

#include "curve_expectations.hpp"

namespace {

using namespace nearfield::reference;

TEST(ReferenceAlgebraicBlends, HoffmannConicIsTangentToBothOperands) {
  for (const Real p : {-20.0L, -0.3L, 0.0L, 0.1L, 0.24L}) {
    const ScaleRanges ranges{0.8L, 0.3L, p};
    const BlendPoint on_first = hoffmann_conic_point(ranges, 0, 0.3L);
    const BlendPoint on_second = hoffmann_conic_point(ranges, 0.8L, 0);
    expect_close(on_first.value, 0, 1e-19L, "x1 = 0");
    expect_close(on_first.by_y, 0, 1e-19L, "tangent to x1 = 0");
    expect_close(on_second.value, 0, 1e-19L, "x2 = 0");
    expect_close(on_second.by_x, 0, 1e-19L, "tangent to x2 = 0");
    for (int i = 0; i < grid_count; ++i) {
      const Real x1 = grid_point(i, -1, 1);
      const Real x2 = grid_point((i * 37) % grid_count, -1, 1);
      const BlendPoint point = hoffmann_conic_point(ranges, x1, x2);
      const Real line = 0.24L - 0.3L * x1 - 0.8L * x2;
      expect_close(point.value, line * line - 2 * (0.24L - p) * x1 * x2, 1e-17L, "factored");
      const auto by_x = [&](Real x) { return hoffmann_conic(ranges, x, x2); };
      const auto by_y = [&](Real y) { return hoffmann_conic(ranges, x1, y); };
      expect_close(point.by_x, central_difference(by_x, x1, 1e-2L), 1e-13L, "by x1");
      expect_close(point.by_y, central_difference(by_y, x2, 1e-2L), 1e-13L, "by x2");
    }
  }
}

TEST(ReferenceAlgebraicBlends, HoffmannUnionHasTheSignsOfTheFilletedSolid) {
  for (const Real p : {-20.0L, 0.0L, 0.2L}) {
    const ScaleRanges ranges{0.8L, 0.3L, p};
    for (int i = 0; i < 60; ++i) {
      for (int k = 0; k < 60; ++k) {
        const Real x1 = -0.2L + static_cast<Real>(i) * 0.0203L;
        const Real x2 = -0.2L + static_cast<Real>(k) * 0.0107L;
        const Real value = hoffmann_union(ranges, x1, x2).value;
        // The inner arc: r₁r₂ − r₂x₁ − r₁x₂ = √(2(r₁r₂ − p)x₁x₂).
        const bool is_filled =
            x1 >= 0 && x2 >= 0 && 0.24L - 0.3L * x1 - 0.8L * x2 > std::sqrt(2 * (0.24L - p) * x1 * x2);
        EXPECT_EQ(value < 0, x1 < 0 || x2 < 0 || is_filled) << x1 << " " << x2 << " p " << p;
        const Real intersection = hoffmann_intersection(ranges, x1, x2).value;
        EXPECT_EQ(intersection, -hoffmann_union(ranges, -x1, -x2).value);
        EXPECT_EQ(hoffmann_difference(ranges, x1, x2).value, hoffmann_intersection(ranges, x1, -x2).value);
      }
    }
  }
  // Why the region is a triangle: at (r₁, r₂), far outside, the conic is positive again for p > r₁r₂/2.
  EXPECT_GT(hoffmann_conic({0.8L, 0.3L, 0.13L}, 0.8L, 0.3L), 0);
  EXPECT_LT(hoffmann_conic({0.8L, 0.3L, 0.11L}, 0.8L, 0.3L), 0);
  EXPECT_GT(hoffmann_intersection({0.8L, 0.3L, 0}, -0.01L, -0.01L).value, 0);
  EXPECT_LT(hoffmann_intersection({0.8L, 0.3L, 0}, -0.01L, -0.5L).value, 0);
  EXPECT_GT(hoffmann_difference({0.8L, 0.3L, 0}, -0.01L, 0.01L).value, 0);
  EXPECT_LT(hoffmann_difference({0.8L, 0.3L, 0}, -1, 1).by_y, 0.5L);
  EXPECT_THROW(hoffmann_union({0.8L, 0.3L, 0.25L}, 0, 0), std::invalid_argument);
}

TEST(ReferenceAlgebraicBlends, LimingBetweenLinesIsHoffmannsConic) {
  const ScaleRanges ranges{0.8L, 0.3L, -0.1L};
  const Real lambda = 1 / (1 + 2 * (0.24L - ranges.p));
  for (int i = 0; i < 50; ++i) {
    const Real x1 = grid_point(i * 20, -1, 1);
    const Real x2 = grid_point((i * 371) % grid_count, -1, 1);
    const LimingPoint point = liming(lambda, -x1, x2, 0.24L - 0.3L * x1 - 0.8L * x2);
    const BlendPoint conic = hoffmann_conic_point(ranges, x1, x2);
    expect_close(point.value, lambda * conic.value, 1e-18L, "value");
    expect_close(-point.by_l1 - 0.3L * point.by_c, lambda * conic.by_x, 1e-18L, "by x1");
    expect_close(point.by_l2 - 0.8L * point.by_c, lambda * conic.by_y, 1e-18L, "by x2");
  }
  EXPECT_EQ(liming(0, 2, 3, 5).value, 6);
  EXPECT_EQ(liming(1, 2, 3, 5).value, 25);
}

TEST(ReferenceAlgebraicBlends, FunctionalSpline) {
  const PatchPoint as_liming = functional_spline(0.3L, {2, -3}, {5});
  expect_close(as_liming.value, liming(0.3L, 2, -3, 5).value, 1e-17L, "Liming");
  expect_close(as_liming.by_primaries[1], 0.7L * 2, 1e-18L, "by the second primary");
  expect_close(as_liming.by_bounds[0], 0.3L * 10, 1e-18L, "by the bound");
  const PatchPoint point = functional_spline(0.25L, {1, 2, 0}, {0.5L, 2, 0});
  EXPECT_EQ(point.value, 0);
  EXPECT_EQ(point.by_primaries[2], 0.75L * 2);
  EXPECT_EQ(point.by_primaries[0], 0);
  EXPECT_EQ(point.by_bounds[2], 0);
}

// Bounds x, y, z; ribbons are the cylinders of radius 1 about the axes.
PatchSample three_cylinders(const Vec3& p) {
  return {{p.y * p.y + p.z * p.z - 1, p.x * p.x + p.z * p.z - 1, p.x * p.x + p.y * p.y - 1}, {p.x, p.y, p.z}};
}

TEST(ReferenceImplicitPatches, ThreeCylindersAndPlanesGiveTheSphere) {
  Random random(announced_seed("ReferenceImplicitPatches.ThreeCylindersAndPlanesGiveTheSphere", 38));
  const PatchCoefficients w{{1, 1, 1}, 3, 2};
  for (int i = 0; i < 300; ++i) {
    Vec3 p = random.vector(-2, 2);
    if (i % 5 == 0) p.x = 0;
    if (i % 10 == 0) p.z = 1e-12L;
    if (i % 20 == 0) p.y = 0;
    const PatchSample at = three_cylinders(p);
    const PatchPoint patch = ribbon_patch(w, at.primaries, at.bounds);
    expect_close(patch.value, squared_norm(p) - 1, 1e-17L, "sphere");
    const Real polynomial = ribbon_patch_polynomial(w, at.primaries, at.bounds);
    const Real n = normaliser_by_sides(w, at.bounds);
    expect_close(polynomial, (squared_norm(p) - 1) * n, 1e-16L * (1 + n), "polynomial");
    if (i % 20 == 0) continue;  // two bounds vanish: no derivative by them
    const auto& [by_x, by_y, by_z] =
        std::array{patch.by_primaries[0], patch.by_primaries[1], patch.by_primaries[2]};
    expect_close(patch.by_bounds[0] + 2 * p.x * (by_y + by_z), 2 * p.x, 1e-15L, "by x");
    expect_close(patch.by_bounds[1] + 2 * p.y * (by_x + by_z), 2 * p.y, 1e-15L, "by y");
    expect_close(patch.by_bounds[2] + 2 * p.z * (by_x + by_y), 2 * p.z, 1e-15L, "by z");
  }
  // Halved it is the oracle (|p|² − 1)/2; the automatic coefficient of a point on the sphere is 3.
  const PatchSample on_sphere = three_cylinders({0.6L, 0.48L, 0.64L});
  expect_close(centred_bound_coefficient(ribbon_patch, w, {on_sphere}), 3, 1e-16L, "through a point");
  const PatchSample other = three_cylinders({0.36L, 0.48L, 0.8L});
  expect_close(centred_bound_coefficient(ribbon_patch, w, {on_sphere, other}), 3, 1e-16L, "through both");
  EXPECT_THROW(centred_bound_coefficient(ribbon_patch, w, {three_cylinders({0, 0.6L, 0.8L})}),
               std::invalid_argument);
}

struct RandomPatch {
  PatchCoefficients w;
  PatchSample at;
};

RandomPatch random_patch(Random& random, std::size_t fewest, int exponent) {
  RandomPatch patch;
  patch.w.exponent = exponent;
  patch.w.bound = random.uniform(-2, 2);
  const auto count = static_cast<std::size_t>(random.integer(static_cast<std::int64_t>(fewest), 8));
  for (std::size_t i = 0; i < count; ++i) {
    patch.w.side.push_back(random.uniform(-1, 2));
    patch.at.primaries.push_back(random.uniform(-1, 1));
    patch.at.bounds.push_back(random.uniform(0.2L, 1) * (random.chance(0.3L) ? -1 : 1));
  }
  return patch;
}

void expect_patch_derivatives(NormalisedPatch patch, const RandomPatch& given, const std::string& what) {
  const PatchPoint point = patch(given.w, given.at.primaries, given.at.bounds);
  for (std::size_t i = 0; i < given.at.bounds.size(); ++i) {
    const auto by_primary = [&](Real value) {
      std::vector<Real> moved = given.at.primaries;
      moved[i] = value;
      return patch(given.w, moved, given.at.bounds).value;
    };
    const auto by_bound = [&](Real value) {
      std::vector<Real> moved = given.at.bounds;
      moved[i] = value;
      return patch(given.w, given.at.primaries, moved).value;
    };
    expect_close(point.by_primaries[i], central_difference(by_primary, given.at.primaries[i], 1e-3L), 1e-12L,
                 what + ", by primary");
    expect_close(point.by_bounds[i], central_difference(by_bound, given.at.bounds[i], 1e-4L), 1e-7L,
                 what + ", by bound");
  }
}

TEST(ReferenceImplicitPatches, NormalisedPatchesAreTheQuotientsOfThePolynomials) {
  Random random(announced_seed("ReferenceImplicitPatches.NormalisedPatchesAreTheQuotients", 39));
  for (int i = 0; i < 60; ++i) {
    const int exponent = i % 2 == 0 ? 2 : 3;
    const RandomPatch ribbons = random_patch(random, 2, exponent);
    const auto& [p, b] = ribbons.at;
    expect_close(ribbon_patch(ribbons.w, p, b).value,
                 ribbon_patch_polynomial(ribbons.w, p, b) / normaliser_by_sides(ribbons.w, b), 1e-16L,
                 "ribbons");
    expect_patch_derivatives(ribbon_patch, ribbons, "ribbons");

    const RandomPatch corners = random_patch(random, 3, exponent);
    const auto& [c, d] = corners.at;
    const Real polynomial = corner_patch_polynomial(corners.w, c, d);
    expect_close(corner_patch(corners.w, c, d).value, polynomial / normaliser_by_corners(corners.w, d),
                 1e-15L, "corners");
    expect_close(corner_patch_by_sides(corners.w, c, d).value, polynomial / normaliser_by_sides(corners.w, d),
                 1e-14L, "corners by sides");
    expect_patch_derivatives(corner_patch, corners, "corners");
    expect_patch_derivatives(corner_patch_by_sides, corners, "corners by sides");
  }
}

TEST(ReferenceImplicitPatches, RibbonSidesAreTheRibbonsWithTheirTangents) {
  Random random(announced_seed("ReferenceImplicitPatches.RibbonSides", 40));
  for (int i = 0; i < 60; ++i) {
    const int exponent = i % 2 == 0 ? 2 : 3;
    RandomPatch given = random_patch(random, 2, exponent);
    auto& [p, b] = given.at;
    b[0] = 0;
    const PatchPoint on_side = ribbon_patch(given.w, p, b);
    expect_close(on_side.value, given.w.side[0] * p[0], 1e-18L, "side");
    EXPECT_EQ(on_side.by_primaries[0], given.w.side[0]);
    for (std::size_t k = 0; k < b.size(); ++k) {
      EXPECT_EQ(on_side.by_bounds[k], 0);
      if (k > 0) {
        EXPECT_EQ(on_side.by_primaries[k], 0);
      }
    }
    // Next to the side it departs like Bᵉ.
    b[0] = 1e-5L;
    const PatchPoint near = ribbon_patch(given.w, p, b);
    expect_close(near.value, on_side.value, 3e4L * std::pow(1e-5L, static_cast<Real>(exponent)), "near");
    expect_close(near.by_bounds[0], 0, 1e5L * std::pow(1e-5L, static_cast<Real>(exponent - 1)), "near");
    // Where two vanish, the even mean, approached by equal bounds.
    b[0] = 0;
    b[1] = 0;
    const Real mean = (given.w.side[0] * p[0] + given.w.side[1] * p[1]) / 2;
    expect_close(ribbon_patch(given.w, p, b).value, mean, 1e-18L, "even mean");
    b[0] = 1e-20L;
    b[1] = -1e-20L;
    expect_close(ribbon_patch(given.w, p, b).value, mean, 1e-17L, "towards the mean");
  }
}

TEST(ReferenceImplicitPatches, CornerSidesAreTwoSidedPatches) {
  Random random(announced_seed("ReferenceImplicitPatches.CornerSides", 41));
  for (int i = 0; i < 60; ++i) {
    RandomPatch given = random_patch(random, 3, 2);
    auto& [c, b] = given.at;
    const std::size_t last = b.size() - 1;
    b[0] = 0;
    // C_{k−1,k}B_{k+1}² + C_{k,k+1}B_{k−1}² + w_k B_{k−1}²B_{k+1}²
    const Real after = b[1] * b[1];
    const Real before = b[last] * b[last];
    const Real ribbon = c[last] * after + c[0] * before + given.w.side[0] * before * after;
    const PatchPoint on_side = corner_patch(given.w, c, b);
    expect_close(on_side.value, ribbon / (before + after), 1e-16L, "side");
    expect_close(corner_patch_by_sides(given.w, c, b).value, ribbon / (before * after), 1e-13L, "by sides");
    expect_patch_derivatives(corner_patch, given, "on a side");
    given.w.side[0] = side_coefficient_through(c[last], c[0], b[last], b[1], 2);
    expect_close(corner_patch(given.w, c, b).value, 0, 1e-17L, "side through a point");
  }
}

TEST(ReferenceImplicitPatches, CornersAreBoundedWhenNormalisedByCorners) {
  Random random(announced_seed("ReferenceImplicitPatches.Corners", 42));
  for (int i = 0; i < 60; ++i) {
    RandomPatch given = random_patch(random, 3, i % 2 == 0 ? 2 : 3);
    auto& [c, b] = given.at;
    for (const Real small : {1e-3L, 1e-8L, 1e-30L}) {
      b[0] = small * random.uniform(-1, 1);
      b[1] = small * random.uniform(-1, 1);
      expect_close(corner_patch(given.w, c, b).value, c[0], 1e3L * small * small, "next to the corner");
    }
    // By sides it grows like C/(Bₖᵉ + Bₖ₊₁ᵉ), without bound although C falls like the distance.
    c[0] = 1e-8L;
    b[0] = 1e-8L;
    b[1] = 1e-8L;
    EXPECT_GT(corner_patch_by_sides(given.w, c, b).value, 1e6L);
    b[0] = 0;
    b[1] = 0;
    EXPECT_EQ(corner_patch(given.w, c, b).value, c[0]);
    EXPECT_TRUE(std::isinf(corner_patch_by_sides(given.w, c, b).value));
    for (Real& bound : b) bound = 0;
    Real mean = 0;
    for (const Real corner : c) mean += corner / static_cast<Real>(c.size());
    expect_close(corner_patch(given.w, c, b).value, mean, 1e-18L, "all bounds vanish");
  }
}

TEST(ReferenceImplicitPatches, EqualCornersAndNoOtherTermsGiveThemselves) {
  const PatchCoefficients w{{0, 0, 0, 0, 0}, 0, 2};
  const std::vector<Real> corners(5, 0.7L);
  expect_close(corner_patch(w, corners, {0.3L, 1, -2, 0.01L, 5}).value, 0.7L, 1e-18L, "equal corners");
  // Opposite sides that vanish together do not meet in a corner.
  const PatchPoint point = corner_patch({{0, 0, 0, 0}, 0, 2}, {1, 1, 3, 3}, {0, 2, 0, 2});
  expect_close(point.value, 2, 1e-18L, "opposite sides");
}

TEST(ReferenceImplicitPatches, WrongSizesAreRefused) {
  EXPECT_THROW(ribbon_patch({{1}, 0, 2}, {1}, {1}), std::invalid_argument);
  EXPECT_THROW(ribbon_patch({{1, 1}, 0, 4}, {1, 1}, {1, 1}), std::invalid_argument);
  EXPECT_THROW(ribbon_patch({{1, 1}, 0, 2}, {1, 1, 1}, {1, 1}), std::invalid_argument);
  EXPECT_THROW(corner_patch({{1, 1}, 0, 2}, {1, 1}, {1, 1}), std::invalid_argument);
  EXPECT_THROW(side_coefficient_through(1, 1, 0, 1, 2), std::invalid_argument);
}

}  // namespace
