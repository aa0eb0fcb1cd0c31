// Checks of the long double reference itself, by brute force: everything else in the tests is judged by it.

#include "../reference/blends.hpp"
#include "../reference/field.hpp"
#include "../reference/kinematics.hpp"
#include "../reference/potentials.hpp"
#include "../reference/random.hpp"
#include "../reference/search.hpp"
#include "../reference/segments.hpp"
#include "../reference/shapes.hpp"
#include "../reference/steps.hpp"
#include "../reference/vector.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <stdexcept>
#include <vector>

namespace {

using namespace nearfield::reference;

void expect_close(Real actual, Real expected, Real tolerance, const char* what) {
  EXPECT_LE(std::fabs(actual - expected), tolerance) << what << ": " << actual << " instead of " << expected;
}

void expect_close(const Vec3& actual, const Vec3& expected, Real tolerance, const char* what) {
  EXPECT_LE(distance(actual, expected), tolerance)
      << what << ": (" << actual.x << ", " << actual.y << ", " << actual.z << ") instead of (" << expected.x
      << ", " << expected.y << ", " << expected.z << ")";
}

// ---------------------------------------------------------------- rotations and poses

TEST(ReferenceVector, RotationsAgreeWithTheExponentialSeries) {
  Random random(announced_seed("RotationsAgreeWithTheExponentialSeries", 11));
  for (int i = 0; i < 200; ++i) {
    const Vec3 axis = random.unit_vector();
    const Real angle = random.uniform(-pi, pi);
    const Vec3 v = random.vector(-1, 1);
    Vec3 term = v;
    Vec3 sum = v;
    for (int k = 1; k < 60; ++k) {
      term = (angle / static_cast<Real>(k)) * cross(axis, term);
      sum += term;
    }
    expect_close(rotation_from_axis_angle(3 * axis, angle) * v, sum, 1e-16L, "axis and angle");
    const Vec3 imaginary = std::sin(angle / 2) * axis;
    const Mat3 turn = rotation_from_quaternion(std::cos(angle / 2), imaginary.x, imaginary.y, imaginary.z);
    expect_close(turn * v, sum, 1e-16L, "quaternion");
  }
}

TEST(ReferenceVector, RollPitchYawTurnsAboutFixedAxesInThatOrder) {
  const Vec3 after_roll = rotation_from_rpy(pi / 2, 0, 0) * Vec3{0, 1, 0};
  expect_close(after_roll, {0, 0, 1}, 1e-18L, "roll takes y to z");
  expect_close(rotation_from_rpy(0, pi / 2, 0) * Vec3{0, 0, 1}, {1, 0, 0}, 1e-18L, "pitch takes z to x");
  expect_close(rotation_from_rpy(0, 0, pi / 2) * Vec3{1, 0, 0}, {0, 1, 0}, 1e-18L, "yaw takes x to y");
  expect_close(rotation_from_rpy(pi / 2, pi / 2, 0) * Vec3{0, 1, 0}, {1, 0, 0}, 1e-18L, "roll before pitch");
  expect_close(rotation_from_rpy(0, pi / 2, pi / 2) * Vec3{0, 0, 1}, {0, 1, 0}, 1e-18L, "pitch before yaw");
}

TEST(ReferenceVector, PosesComposeAndInvert) {
  Random random(announced_seed("PosesComposeAndInvert", 12));
  for (int i = 0; i < 100; ++i) {
    const Pose outer = random.pose(2);
    const Pose inner = random.pose(2);
    const Vec3 p = random.vector(-2, 2);
    expect_close(to_world(outer * inner, p), to_world(outer, to_world(inner, p)), 1e-17L, "composition");
    expect_close(to_local(outer, to_world(outer, p)), p, 1e-17L, "local of world");
    expect_close(to_world(inverse(outer), p), to_local(outer, p), 1e-17L, "inverse");
  }
}

TEST(ReferenceRandom, StreamIsTheSameEverywhereAndDirectionsAreEven) {
  Random zero(0);
  EXPECT_EQ(zero.next(), 0xE220A8397B1DCDAFu);  // published values of SplitMix64
  Random other(1234567);
  EXPECT_EQ(other.next(), 6457827717110365317u);
  EXPECT_EQ(other.next(), 3203168211198807973u);
  Random random(announced_seed("StreamIsTheSameEverywhereAndDirectionsAreEven", 13));
  Vec3 mean{};
  Vec3 turned_mean{};
  std::array<int, 7> counts{};
  const int draws = 40000;
  for (int i = 0; i < draws; ++i) {
    const Vec3 direction = random.unit_vector();
    ASSERT_LE(std::fabs(norm(direction) - 1), 1e-18L);
    mean += direction / draws;
    turned_mean += random.rotation() * Vec3{1, 0, 0} / draws;
    const Real drawn = random.uniform(-2, 3);
    ASSERT_TRUE(drawn >= -2 && drawn < 3);
    ++counts.at(static_cast<std::size_t>(random.integer(-3, 3) + 3));
  }
  EXPECT_LE(norm(mean), 0.03L);
  EXPECT_LE(norm(turned_mean), 0.03L);
  for (const int count : counts) EXPECT_NEAR(count, draws / 7, 400);
}

// ---------------------------------------------------------------- shapes against their surfaces

/// Directions over the sphere, or over the half of it around +z.
Vec3 direction(Real u, Real v, bool half) {
  const Real turn = 2 * pi * u;
  const Real tilt = (half ? pi / 2 : pi) * v;
  return {std::sin(tilt) * std::cos(turn), std::sin(tilt) * std::sin(turn), std::cos(tilt)};
}

/// Checks value, sign, gradient and the closest surface point that both imply.
template <typename Shape>
void check_shape(const Shape& shape, const std::vector<Patch>& surface, bool inside, const Vec3& p) {
  Real brute = patch_distance(surface[0], p);
  for (const Patch& patch : surface) brute = std::min(brute, patch_distance(patch, p));
  const Real exact = signed_distance(shape, p);
  EXPECT_EQ(exact < 0, inside);
  expect_close(std::fabs(exact), brute, 1e-12L, "distance to the surface");
  const Vec3 slope = distance_gradient(shape, p);
  expect_close(norm(slope), 1, 1e-17L, "length of the gradient");
  expect_close(signed_distance(shape, p - exact * slope), 0, 1e-17L, "the step back ends on the surface");
}

TEST(ReferenceShapes, SphereMatchesItsSurface) {
  Random random(announced_seed("SphereMatchesItsSurface", 21));
  for (int i = 0; i < 30; ++i) {
    const Sphere sphere_shape{random.vector(-0.2L, 0.2L), random.uniform(0.1L, 0.5L)};
    const Vec3 p = random.vector(-0.6L, 0.6L);
    const Patch all = [&](Real u, Real v) {
      return sphere_shape.center + sphere_shape.radius * direction(u, v, false);
    };
    check_shape(sphere_shape, {all}, distance(p, sphere_shape.center) < sphere_shape.radius, p);
  }
}

TEST(ReferenceShapes, CapsuleMatchesItsSurface) {
  Random random(announced_seed("CapsuleMatchesItsSurface", 22));
  for (int i = 0; i < 30; ++i) {
    const Pose frame = random.pose(0.2L);
    const Real length = i % 5 == 0 ? 0 : random.uniform(0, 0.6L);
    const Real radius = random.uniform(0.05L, 0.3L);
    const Capsule shape{frame.translation, to_world(frame, {0, 0, length}), radius};
    const Patch side = [&](Real u, Real v) {
      return to_world(frame, {radius * std::cos(2 * pi * u), radius * std::sin(2 * pi * u), length * v});
    };
    const Patch top = [&](Real u, Real v) {
      return to_world(frame, radius * direction(u, v, true) + Vec3{0, 0, length});
    };
    const Patch bottom = [&](Real u, Real v) { return to_world(frame, -radius * direction(u, v, true)); };
    const Vec3 local = random.vector(-0.5L, 0.8L);
    const Real beyond = std::max({-local.z, local.z - length, Real{0}});
    const bool inside = local.x * local.x + local.y * local.y + beyond * beyond < radius * radius;
    check_shape(shape, {side, top, bottom}, inside, to_world(frame, local));
  }
}

TEST(ReferenceShapes, BoxMatchesItsSurface) {
  Random random(announced_seed("BoxMatchesItsSurface", 23));
  for (int i = 0; i < 60; ++i) {
    const Box shape{random.vector(-0.2L, 0.2L), random.vector(0.05L, 0.5L)};
    const Vec3& h = shape.half_extents;
    std::vector<Patch> faces;
    for (const Real side : {Real{-1}, Real{1}}) {
      faces.push_back([=](Real u, Real v) {
        return shape.center + Vec3{side * h.x, (2 * u - 1) * h.y, (2 * v - 1) * h.z};
      });
      faces.push_back([=](Real u, Real v) {
        return shape.center + Vec3{(2 * u - 1) * h.x, side * h.y, (2 * v - 1) * h.z};
      });
      faces.push_back([=](Real u, Real v) {
        return shape.center + Vec3{(2 * u - 1) * h.x, (2 * v - 1) * h.y, side * h.z};
      });
    }
    const Real spread = i % 2 == 0 ? 2.2L : 0.98L;
    const Vec3 relative = random.vector(-spread, spread);
    const Vec3 local{relative.x * h.x, relative.y * h.y, relative.z * h.z};
    const bool inside = std::max({std::fabs(relative.x), std::fabs(relative.y), std::fabs(relative.z)}) < 1;
    check_shape(shape, faces, inside, shape.center + local);
  }
}

TEST(ReferenceShapes, CylinderMatchesItsSurface) {
  Random random(announced_seed("CylinderMatchesItsSurface", 24));
  for (int i = 0; i < 60; ++i) {
    const Vec3 center = random.vector(-0.2L, 0.2L);
    const Real radius = random.uniform(0.05L, 0.5L);
    const Cylinder shape{center, radius, random.uniform(0.05L, 0.5L)};
    const auto ring = [shape](Real turn, Real reach, Real z) {
      return shape.center + Vec3{reach * std::cos(2 * pi * turn), reach * std::sin(2 * pi * turn), z};
    };
    const Patch side = [=](Real u, Real v) { return ring(u, shape.radius, (2 * v - 1) * shape.half_height); };
    const Patch top = [=](Real u, Real v) { return ring(u, v * shape.radius, shape.half_height); };
    const Patch bottom = [=](Real u, Real v) { return ring(u, v * shape.radius, -shape.half_height); };
    const Real spread = i % 2 == 0 ? 2 : 0.98L;
    const Real radial = random.uniform(0, spread);
    const Real axial = random.uniform(-spread, spread);
    const Vec3 p = ring(random.uniform(), radial * shape.radius, axial * shape.half_height);
    check_shape(shape, {side, top, bottom}, std::max(radial, std::fabs(axial)) < 1, p);
  }
}

// ---------------------------------------------------------------- segments

Segment random_segment_beside(Random& random, const Segment& first, int variety) {
  const Vec3 along = first.b - first.a;
  switch (variety) {
    case 0:
      return {random.vector(-1, 1), random.vector(-1, 1)};
    case 1: {  // parallel, or the same line
      const Vec3 aside = random.chance(0.5L) ? random.vector(-1, 1) : Vec3{};
      const Vec3 start = first.a + random.uniform(-2, 2) * along + aside;
      return {start, first.a + random.uniform(-2, 2) * along + aside};
    }
    case 2: {  // crossing in one point, at any angle down to 1e-15
      const Vec3 cross_point = point_at(first, random.uniform());
      const Vec3 tilted = along + std::pow(Real{10}, random.uniform(-15, 0)) * random.unit_vector();
      return {cross_point - random.uniform() * tilted, cross_point + random.uniform() * tilted};
    }
    case 3: {  // nearly parallel and apart
      const Vec3 start = random.vector(-1, 1);
      return {start, start + along + std::pow(Real{10}, random.uniform(-15, -1)) * random.unit_vector()};
    }
    case 4:
      return {first.b, random.vector(-1, 1)};
    default: {
      const Vec3 point = random.chance(0.5L) ? random.vector(-1, 1) : point_at(first, random.uniform());
      return {point, point};
    }
  }
}

TEST(ReferenceSegments, PointDistanceMatchesASearch) {
  Random random(announced_seed("PointDistanceMatchesASearch", 31));
  for (int i = 0; i < 300; ++i) {
    Segment segment{random.vector(-1, 1), random.vector(-1, 1)};
    if (i % 10 == 0) segment.b = segment.a;
    const Vec3 p = random.vector(-1, 1);
    const Real searched = convex_minimum([&](Real t) { return distance(p, point_at(segment, t)); });
    expect_close(point_segment_distance(p, segment), searched, 1e-18L, "distance");
    expect_close(squared_point_segment_distance(p, segment), searched * searched, 1e-17L, "squared distance");
  }
}

TEST(ReferenceSegments, SegmentDistanceMatchesASearchInEveryDegenerateCase) {
  Random random(announced_seed("SegmentDistanceMatchesASearchInEveryDegenerateCase", 32));
  for (int i = 0; i < 1200; ++i) {
    const int variety = i % 6;
    Segment first{random.vector(-1, 1), random.vector(-1, 1)};
    const Segment second = random_segment_beside(random, first, variety);
    if (i % 40 == 5) first.b = first.a;
    const Real searched =
        convex_minimum([&](Real t) { return point_segment_distance(point_at(first, t), second); });
    const Real exact = segment_segment_distance(first, second);
    ASSERT_LE(std::fabs(exact - searched), 2e-18L) << "variety " << variety << ", trial " << i;
    ASSERT_LE(std::fabs(exact - segment_segment_distance(second, first)), 2e-18L) << "variety " << variety;
    if (variety == 2 && i % 40 != 5) {
      ASSERT_LE(exact, 2e-18L) << "trial " << i;
    }
    const ClosestPair pair = closest_pair(first, second);
    ASSERT_LE(point_segment_distance(pair.on_first, first), 1e-18L);
    ASSERT_LE(point_segment_distance(pair.on_second, second), 1e-18L);
    for (int s = 0; s <= 12; ++s) {
      for (int t = 0; t <= 12; ++t) {
        const Real sampled =
            distance(point_at(first, static_cast<Real>(s) / 12), point_at(second, static_cast<Real>(t) / 12));
        ASSERT_GE(sampled, exact - 1e-18L);
      }
    }
  }
  const Segment along_x{{0, 0, 0}, {1, 0, 0}};
  const Segment over_it{{0.5L, -1, 0.5L}, {0.5L, 1, 0.5L}};
  expect_close(capsule_capsule_clearance(along_x, 0.1L, over_it, 0.2L), 0.2L, 1e-18L, "apart");
  expect_close(capsule_capsule_clearance(along_x, 0.4L, over_it, 0.3L), -0.2L, 1e-18L, "overlapping");
}

// ---------------------------------------------------------------- steps and potentials

TEST(ReferenceSteps, PolynomialEqualsIntegratedBspline) {
  for (int n = 1; n <= 8; ++n) {
    for (int i = -60; i <= 60; ++i) {
      const Real t = static_cast<Real>(i) / 48 + 1e-3L;
      expect_close(polynomial_step(n, t), bspline_step(n, t), 1e-17L, "H_n and B_n");
      expect_close(step_slope({StepKind::polynomial, n, 0}, t), step_slope({StepKind::bspline, n, 0}, t),
                   1e-16L, "slopes of H_n and B_n");
    }
  }
}

TEST(ReferenceSteps, CubicMatchesThePublishedPieces) {
  for (int i = -1000; i <= 1000; ++i) {
    const Real t = static_cast<Real>(i) / 1000;
    const Real u = 3 * (t + 1) / 2;
    Real expected = 1 - std::pow(3 - u, Real{3}) / 6;
    if (u <= 2) expected = -Real{5} / 8 + 3 * u / 4 - std::pow(u - 1.5L, Real{3}) / 3;
    if (u <= 1) expected = std::pow(u, Real{3}) / 6;
    expect_close(polynomial_step(3, t), expected, 1e-18L, "H_3");
  }
  EXPECT_EQ(polynomial_step(0, -0.1L), 0);
  EXPECT_EQ(polynomial_step(0, 0), 0.5L);
  EXPECT_EQ(polynomial_step(0, 0.1L), 1);
}

TEST(ReferenceSteps, StepsRiseFromZeroToOneWithTheirOwnSlope) {
  std::vector<UnitStep> steps;
  for (int n = 1; n <= 8; ++n) steps.push_back({StepKind::polynomial, n, 0});
  for (int m = 1; m <= 8; ++m) steps.push_back({StepKind::bspline, m, 0});
  for (int n = 1; n <= 5; ++n) steps.push_back({StepKind::rising_cutoff, n, 0});
  for (int n = 1; n <= 5; ++n) steps.push_back({StepKind::rising_cutoff_squared, n, 0});
  steps.push_back({StepKind::logistic, 0, 12});
  for (const UnitStep& step : steps) {
    const bool cut_off = step.kind != StepKind::logistic;
    if (cut_off) {
      EXPECT_EQ(step_value(step, -1), 0);
      EXPECT_EQ(step_value(step, 1), 1);
    }
    Real before = -1;
    for (int i = -210; i <= 210; ++i) {
      const Real t = static_cast<Real>(i) / 200 + 0.00123L;
      const Real here = step_value(step, t);
      EXPECT_GE(here, before - 1e-18L);
      before = here;
      if (step.kind != StepKind::rising_cutoff) {
        expect_close(here + step_value(step, -t), 1, 1e-17L, "balance");
      }
      const Real slope = difference([&](Real x) { return step_value(step, x); }, t);
      expect_close(slope, step_slope(step, t), 1e-7L, "slope");
    }
  }
}

TEST(ReferenceSteps, RisingCutoffFollowsTheGeneralIteration) {
  for (int n = 1; n <= 6; ++n) {
    for (int i = -110; i <= 110; ++i) {
      const Real t = static_cast<Real>(i) / 100;
      expect_close(rising_cutoff(n, t), rising_cutoff_by_iteration(n, t), 1e-16L, "R_n");
      expect_close(rising_cutoff_squared(n, t) + rising_cutoff_squared(n, -t), 1, 1e-16L, "squares of R_n");
    }
  }
  const Real tail = 0.001L;
  const Real alpha = std::log((1 - tail) / tail) + 0.01L;
  EXPECT_LT(logistic(alpha, -1), tail);
  EXPECT_GT(logistic(alpha, 1), 1 - tail);
}

TEST(ReferencePotentials, RunFromOneToZeroThroughOneHalf) {
  for (const Potential potential : {Potential::cubic, Potential::wyvill}) {
    expect_close(potential_value(potential, 1e-12L), 1, 1e-20L, "P(0)");
    expect_close(potential_value(potential, 0.5L), 0.5L, 1e-18L, "P(1/2)");
    expect_close(potential_value(potential, 1 - 1e-12L), 0, 1e-18L, "P(1)");
    EXPECT_EQ(potential_value(potential, -0.3L), 1);
    EXPECT_EQ(potential_value(potential, 1.3L), 0);
    Real before = 2;
    for (int i = 1; i < 100; ++i) {
      const Real r = static_cast<Real>(i) / 100;
      const Real here = potential_value(potential, r);
      EXPECT_LT(here, before);
      before = here;
      expect_close(difference([&](Real x) { return potential_value(potential, x); }, r),
                   potential_slope(potential, r), 1e-14L, "slope");
    }
    expect_close(potential_slope(potential, 1e-12L), 0, 1e-11L, "P'(0)");
    expect_close(potential_slope(potential, 1 - 1e-12L), 0, 1e-11L, "P'(1)");
  }
}

// ---------------------------------------------------------------- blends

const UnitStep cubic_step{StepKind::polynomial, 3, 0};

TEST(ReferenceBlends, ExteriorUnionContainsAndInteriorUnionIsContained) {
  Random random(announced_seed("ExteriorUnionContainsAndInteriorUnionIsContained", 41));
  for (int i = 0; i < 20000; ++i) {
    const Real delta = random.uniform(0.01L, 1);
    const Real epsilon = random.chance(0.1L) ? 0 : random.uniform(0, delta);
    const Real x = random.uniform(-1, 1);
    const Real y = x + random.uniform(-2.5L, 2.5L) * delta;
    const Blend exterior = exterior_blend(cubic_step, delta, epsilon);
    const Blend interior = interior_blend(cubic_step, epsilon);
    ASSERT_LE(blend_union(exterior, x, y), std::min(x, y) + 1e-18L);
    ASSERT_GE(blend_intersection(exterior, x, y), std::max(x, y) - 1e-18L);
    ASSERT_GE(blend_union(interior, x, y), std::min(x, y) - 1e-18L);
    ASSERT_LE(blend_intersection(interior, x, y), std::max(x, y) + 1e-18L);
    for (const Blend& blend : {exterior, interior, hard_blend()}) {
      ASSERT_LE(std::fabs(blend_union(blend, x, y) - blend_union(blend, y, x)), 1e-17L);
      ASSERT_LE(std::fabs(blend_max(blend, x + 0.3L, y + 0.3L) - blend_max(blend, x, y) - 0.3L), 1e-17L);
      if (std::fabs(x - y) < (blend.kind == BlendKind::exterior ? delta : 0) + epsilon) continue;
      ASSERT_LE(std::fabs(blend_union(blend, x, y) - std::min(x, y)), 1e-18L);
      ASSERT_LE(std::fabs(blend_intersection(blend, x, y) - std::max(x, y)), 1e-18L);
      ASSERT_LE(std::fabs(blend_subtraction(hard_blend(), x, y) - std::max(x, -y)), 0);
    }
  }
}

/// Extremes of h(t) = B(t, 0) - t over t ≥ 0, and of its slope, on a dense grid.
struct KernelExtremes {
  Real least = 0;
  Real greatest_slope = 0;
};

KernelExtremes kernel_extremes(const Blend& blend, Real range) {
  KernelExtremes extremes;
  for (int i = 1; i <= 20000; ++i) {
    const Real t = range * static_cast<Real>(i) / 20000;
    extremes.least = std::min(extremes.least, blend_max(blend, t, 0) - t);
    extremes.greatest_slope = std::max(extremes.greatest_slope, blend_max_partials(blend, t, 0).by_x - 1);
  }
  return extremes;
}

TEST(ReferenceBlends, ExtremesAgreeWithTheirIndependentMeasurement) {
  const KernelExtremes narrow = kernel_extremes(exterior_blend(cubic_step, 1, 0.25L), 2);
  expect_close(narrow.greatest_slope, 0.0048L, 5e-5L, "0.25");
  expect_close(kernel_extremes(exterior_blend(cubic_step, 1, 1), 3).greatest_slope, 0.019L, 5e-4L, "1");
  const KernelExtremes wide = kernel_extremes(exterior_blend(cubic_step, 1, 4), 6);
  expect_close(wide.greatest_slope, 0.12L, 5e-3L, "4");
  expect_close(wide.least, -0.055L, 5e-4L, "greatest erosion at 4");
  const KernelExtremes interior = kernel_extremes(interior_blend(cubic_step, 1), 2);
  expect_close(interior.greatest_slope, 0.141L, 5e-4L, "interior");
  expect_close(interior.least, -0.059L, 5e-4L, "interior erosion");
}

TEST(ReferenceBlends, PartialsMatchDifferences) {
  Random random(announced_seed("PartialsMatchDifferences", 42));
  using Value = Real (*)(const Blend&, Real, Real);
  using Slope = Partials (*)(const Blend&, Real, Real);
  const std::array<Value, 3> values{blend_union, blend_intersection, blend_subtraction};
  const std::array<Slope, 3> slopes{blend_union_partials, blend_intersection_partials,
                                    blend_subtraction_partials};
  for (int i = 0; i < 2000; ++i) {
    const UnitStep step =
        i % 2 == 0 ? UnitStep{StepKind::polynomial, 5, 0} : UnitStep{StepKind::rising_cutoff_squared, 3, 0};
    const Real delta = random.uniform(0.2L, 1);
    const Real epsilon = random.uniform(0.2L, 1);
    const std::array<Blend, 3> blends{hard_blend(), exterior_blend(step, delta, epsilon),
                                      interior_blend(step, epsilon)};
    const Real x = random.uniform(-1, 1);
    const Real y = random.uniform(-1, 1);
    if (std::fabs(x - y) < 1e-3L || std::fabs(x + y) < 1e-3L) continue;
    for (const Blend& blend : blends) {
      for (std::size_t k = 0; k < values.size(); ++k) {
        const Partials partials = slopes[k](blend, x, y);
        const Real by_x = difference([&](Real v) { return values[k](blend, v, y); }, x);
        const Real by_y = difference([&](Real v) { return values[k](blend, x, v); }, y);
        expect_close(partials.by_x, by_x, 1e-9L, "by x");
        expect_close(partials.by_y, by_y, 1e-9L, "by y");
      }
    }
  }
}

// ---------------------------------------------------------------- kinematics

TEST(ReferenceKinematics, PlanarArmMatchesItsClosedForm) {
  KinematicTree arm;
  arm.link_count = 4;
  arm.joints = {{JointKind::fixed, 2, 3, {{}, {0.3L, 0, 0}}, {}},  // the tip, listed first on purpose
                {JointKind::revolute, 0, 1, {{}, {0, 0, 0.1L}}, {0, 0, 2}},
                {JointKind::revolute, 1, 2, {{}, {0.4L, 0, 0}}, {0, 0, 1}}};
  const Real shoulder = 0.7L;
  const Real elbow = -1.9L;
  const std::vector<Pose> poses = forward_kinematics(arm, {99, shoulder, elbow});
  expect_close(poses[3].translation,
               {0.4L * std::cos(shoulder) + 0.3L * std::cos(shoulder + elbow),
                0.4L * std::sin(shoulder) + 0.3L * std::sin(shoulder + elbow), 0.1L},
               1e-18L, "tip");
  arm.joints[2].kind = JointKind::prismatic;
  arm.joints[2].axis = {0, 3, 0};
  expect_close(forward_kinematics(arm, {0, shoulder, 0.25L})[2].translation,
               {0.4L * std::cos(shoulder) - 0.25L * std::sin(shoulder),
                0.4L * std::sin(shoulder) + 0.25L * std::cos(shoulder), 0.1L},
               1e-18L, "slide along the turned y");
}

TEST(ReferenceKinematics, RandomTreesMatchMovingThePointJointByJoint) {
  Random random(announced_seed("RandomTreesMatchMovingThePointJointByJoint", 51));
  for (int trial = 0; trial < 50; ++trial) {
    KinematicTree tree;
    tree.link_count = 9;
    std::vector<Real> positions;
    for (std::size_t child = 1; child < tree.link_count; ++child) {
      const std::int64_t last = static_cast<std::int64_t>(child) - 1;
      const std::size_t parent = static_cast<std::size_t>(random.integer(0, last));
      const JointKind kind = static_cast<JointKind>(random.integer(0, 2));
      tree.joints.push_back({kind, parent, child, random.pose(0.5L), 2 * random.unit_vector()});
      positions.push_back(random.uniform(-3, 3));
    }
    const Pose root = random.pose(1);
    const std::vector<Pose> poses = forward_kinematics(tree, positions, root);
    for (std::size_t link = 0; link < tree.link_count; ++link) {
      const Vec3 start = random.vector(-1, 1);
      Vec3 moved = start;
      for (std::size_t at = link; at != tree.root_link;) {
        const Joint& joint = tree.joints[at - 1];
        const Real position = positions[at - 1];
        if (joint.kind == JointKind::prismatic) moved += position * joint.axis / norm(joint.axis);
        if (joint.kind == JointKind::revolute) {
          const Vec3 u = joint.axis / norm(joint.axis);
          moved = std::cos(position) * moved + std::sin(position) * cross(u, moved) +
                  (1 - std::cos(position)) * dot(u, moved) * u;
        }
        moved = joint.origin.rotation * moved + joint.origin.translation;
        at = joint.parent_link;
      }
      moved = root.rotation * moved + root.translation;
      expect_close(to_world(poses[link], start), moved, 1e-16L, "point of a link");
    }
  }
}

TEST(ReferenceKinematics, WhatIsNoTreeIsRefused) {
  KinematicTree loop;
  loop.link_count = 3;
  loop.joints = {{JointKind::fixed, 1, 2, {}, {}}, {JointKind::fixed, 2, 1, {}, {}}};
  EXPECT_THROW(forward_kinematics(loop, {0, 0}), std::invalid_argument);
  loop.joints = {{JointKind::fixed, 0, 1, {}, {}}, {JointKind::fixed, 0, 7, {}, {}}};
  EXPECT_THROW(forward_kinematics(loop, {0, 0}), std::invalid_argument);
  loop.joints[1] = {JointKind::revolute, 1, 2, {}, {0, 0, 0}};
  EXPECT_THROW(forward_kinematics(loop, {0, 0}), std::invalid_argument);
  EXPECT_THROW(forward_kinematics(loop, {0}), std::invalid_argument);
}

// ---------------------------------------------------------------- fields

Node random_shape(Random& random) {
  const Vec3 center = random.vector(-0.5L, 0.5L);
  switch (random.integer(0, 3)) {
    case 0:
      return sphere(center, random.uniform(0.05L, 0.4L));
    case 1:
      return capsule(center, random.vector(-0.5L, 0.5L), random.uniform(0.02L, 0.3L));
    case 2:
      return box(center, random.vector(0.05L, 0.4L));
    default: {
      const Real radius = random.uniform(0.05L, 0.4L);
      return cylinder(center, radius, random.uniform(0.05L, 0.4L));
    }
  }
}

Node random_field(Random& random, int depth, bool only_unions) {
  if (depth == 0) return random_shape(random);
  if (random.chance(0.3L)) return placed(random.pose(0.5L), random_field(random, depth - 1, only_unions));
  const Real delta = random.uniform(0.02L, 0.2L);
  const Blend blend = exterior_blend(cubic_step, delta, random.uniform(0.25L, 1) * delta);
  std::vector<Node> operands;
  const std::int64_t count = random.integer(2, 3);
  for (std::int64_t i = 0; i < count; ++i) {
    operands.push_back(random_field(random, depth - 1, only_unions));
  }
  const std::int64_t choice = only_unions ? 0 : random.integer(0, 2);
  if (choice == 0) return unite(blend, operands);
  return choice == 1 ? intersect(blend, operands) : subtract(blend, operands);
}

TEST(ReferenceField, GradientByDifferencesMatchesTheChainRule) {
  Random random(announced_seed("GradientByDifferencesMatchesTheChainRule", 61));
  std::vector<Real> errors;
  for (int i = 0; i < 3000; ++i) {
    Node node = random_field(random, static_cast<int>(random.integer(0, 2)), false);
    if (i % 4 == 0) {
      const SoftOperand bulge{node, 0.6L, 1, Potential::wyvill};
      const SoftOperand dent{point_skeleton({0.1L, 0.2L, 0}), 0.9L, -0.4L, Potential::cubic};
      node = placed(random.pose(0.5L), soft_sum({bulge, dent}));
    }
    const Vec3 p = random.vector(-1, 1);
    const Vec3 exact = sample(node, p).gradient;
    errors.push_back(distance(gradient(node, p), exact));
  }
  // A few points are within 2e-5 m of a change of curvature, fewer of an edge.
  std::sort(errors.begin(), errors.end());
  EXPECT_LE(errors[errors.size() * 98 / 100], 1e-11L);
  EXPECT_LE(errors[errors.size() * 99 / 100], 1e-6L);
}

TEST(ReferenceField, BlendedFieldsBoundTheirSharpSolids) {
  Random random(announced_seed("BlendedFieldsBoundTheirSharpSolids", 62));
  for (int i = 0; i < 1500; ++i) {
    const Node node = random_field(random, 2, true);
    const Vec3 p = random.vector(-1, 1);
    const Real sharp = sharp_distance(node, p);
    ASSERT_LE(value(node, p), sharp + 1e-17L);
    ASSERT_EQ(sharp, sharp_value(node, p));
  }
  for (int i = 0; i < 300; ++i) {
    const Node first = random_shape(random);
    const Node second = random_shape(random);
    const Vec3 p = random.vector(-1, 1);
    const Real x = value(first, p);
    const Real y = value(second, p);
    const Blend rounded = exterior_blend(cubic_step, 0.1L, 0.05L);
    ASSERT_EQ(sharp_value(unite(rounded, {first, second}), p), std::min(x, y));
    ASSERT_EQ(sharp_value(intersect(rounded, {first, second}), p), std::max(x, y));
    ASSERT_EQ(sharp_value(subtract(rounded, {first, second}), p), std::max(x, -y));
    ASSERT_EQ(value(subtract(hard_blend(), {first, second}), p), std::max(x, -y));
  }
  for (int i = 0; i < 300; ++i) {  // no point of the solid lies within the sharp value of a point outside
    const Node node = random_field(random, 2, false);
    const Vec3 p = random.vector(-1, 1);
    const Real sharp = sharp_value(node, p);
    if (sharp <= 0) continue;
    for (int k = 0; k < 50; ++k) {
      ASSERT_GT(sharp_value(node, p + 0.999999L * sharp * random.unit_vector()), 0);
    }
  }
}

TEST(ReferenceField, MovesWithItsPoseAndKeepsItsKinds) {
  Random random(announced_seed("MovesWithItsPoseAndKeepsItsKinds", 63));
  const Node shape =
      unite(exterior_blend(cubic_step, 0.1L, 0.05L), {sphere({}, 0.2L), box({}, {0.3L, 0.1L, 0.1L})});
  for (int i = 0; i < 100; ++i) {
    const Pose pose = random.pose(1);
    const Vec3 p = random.vector(-1, 1);
    expect_close(value(placed(pose, shape), to_world(pose, p)), value(shape, p), 1e-17L, "placed value");
  }
  const Node lone = soft_sum({{segment_skeleton({0, 0, 0}, {1, 0, 0}), 0.4L, 1, Potential::wyvill}});
  expect_close(value(lone, {0.5L, 0.2L, 0}), 0.5L, 1e-18L, "surface of a lone skeleton");
  EXPECT_EQ(value(lone, {0.5L, 0.4L, 0}), 0);
  EXPECT_EQ(kind_of(placed({}, lone)), FieldKind::intensity);
  EXPECT_EQ(kind_of(shape), FieldKind::distance);
  EXPECT_THROW(unite(hard_blend(), {shape, lone}), std::invalid_argument);
  EXPECT_THROW(unite(hard_blend(), {shape}), std::invalid_argument);
  EXPECT_THROW(soft_sum({{lone, 1, 1, Potential::cubic}}), std::invalid_argument);
  EXPECT_THROW(sharp_distance(lone, {}), std::invalid_argument);
  EXPECT_THROW(sharp_distance(subtract(hard_blend(), {shape, shape}), {}), std::invalid_argument);
}

}  // namespace
