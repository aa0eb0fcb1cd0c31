/// Clearances of many algebraic fields in declared boxes, against a dense search for their surfaces.

#include <nearfield/field/compose.hpp>
#include <nearfield/query/clearance.hpp>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <functional>
#include <vector>

#include "property/conversion.hpp"
#include "reference/random.hpp"

namespace nearfield {
namespace {

using property::real;
using property::rounded;
using property::rounded_pose;
using reference::Random;
using reference::Real;
using reference::Vec3;

using Function = std::function<Real(const Vec3&)>;

bool inside(const Vec3& half, const Vec3& p) {
  return std::fabs(p.x) < half.x && std::fabs(p.y) < half.y && std::fabs(p.z) < half.z;
}
Real depth_in(const Vec3& half, const Vec3& p) {
  return std::min({half.x - std::fabs(p.x), half.y - std::fabs(p.y), half.z - std::fabs(p.z)});
}
Vec3 slope_of(const Function& g, const Vec3& p) {
  constexpr Real h = 1e-6L;
  const auto along = [&](const Vec3& step) { return (g(p + step) - g(p - step)) / (2 * h); };
  return {along({h, 0, 0}), along({0, h, 0}), along({0, 0, h})};
}

/// Where a function vanishes in a box: points on the edges of a grid, and from the nearest of them a descent
/// along the surface. What it finds are points of the surface: none is nearer than the true distance.
class SurfaceSearch {
 public:
  SurfaceSearch(const Function& g, const Vec3& half) : g_(g), half_(half) {
    constexpr int cells = 22;
    const auto corner = [&](int i, int j, int k) {
      const auto along = [](Real extent, int index) {
        return extent * (2 * static_cast<Real>(index) / cells - 1);
      };
      return Vec3{along(half.x, i), along(half.y, j), along(half.z, k)};
    };
    std::vector<Real> values;
    const auto at = [&](int i, int j, int k) {
      return values[static_cast<std::size_t>((i * (cells + 1) + j) * (cells + 1) + k)];
    };
    for (int i = 0; i <= cells; ++i) {
      for (int j = 0; j <= cells; ++j) {
        for (int k = 0; k <= cells; ++k) {
          values.push_back(g(corner(i, j, k)));
          if (i % 2 == 0 && j % 2 == 0 && k % 2 == 0) {
            steepest_ = std::max(steepest_, norm(slope_of(g, corner(i, j, k))));
          }
        }
      }
    }
    for (int i = 0; i <= cells; ++i) {
      for (int j = 0; j <= cells; ++j) {
        for (int k = 0; k <= cells; ++k) {
          for (int axis = 0; axis < 3; ++axis) {
            const int a = i + (axis == 0), b = j + (axis == 1), c = k + (axis == 2);
            if (a > cells || b > cells || c > cells || (at(i, j, k) < 0) == (at(a, b, c) < 0)) continue;
            points_.push_back(between(corner(i, j, k), corner(a, b, c)));
          }
        }
      }
    }
  }

  bool found() const { return !points_.empty(); }
  /// The greatest gradient on a coarser grid, corners included.
  Real steepest() const { return steepest_; }
  Real distance_from(const Vec3& p) const {
    Vec3 nearest{};
    Real least = HUGE_VALL;
    for (const Vec3& q : points_) {
      const Real distance = reference::distance(p, q);
      if (distance < least) {
        least = distance;
        nearest = q;
      }
    }
    if (!found()) return least;
    for (Real stride = 1; stride > 1e-3L;) {
      const Vec3 normal = reference::normalized_or_zero(slope_of(g_, nearest)), way = p - nearest;
      const Vec3 guess = nearest + stride * (way - dot(way, normal) * normal), off = 0.02L * normal;
      const bool crosses = (g_(guess - off) < 0) != (g_(guess + off) < 0);
      const Vec3 on_surface = crosses ? between(guess - off, guess + off) : guess;
      if (crosses && inside(half_, on_surface) && reference::distance(p, on_surface) < least - 1e-9L) {
        nearest = on_surface;
        least = reference::distance(p, on_surface);
      } else {
        stride /= 2;
      }
    }
    return least;
  }

 private:
  Vec3 between(Vec3 a, Vec3 b) const {
    const bool negative = g_(a) < 0;
    for (int halving = 0; halving < 45; ++halving) {
      const Vec3 middle = 0.5L * (a + b);
      ((g_(middle) < 0) == negative ? a : b) = middle;
    }
    return 0.5L * (a + b);
  }

  Function g_;
  Vec3 half_;
  Real steepest_ = 0;
  std::vector<Vec3> points_;
};

// Fields with random parameters: the exact function and the composition.
struct PlaneCase {
  static constexpr const char* name = "plane";
  Vec3 normal;
  Real offset;
  explicit PlaneCase(Random& random)
      : normal(random.uniform(0.3L, 2) * random.unit_vector()), offset(random.uniform(-1.5L, 1.5L)) {}
  Real value(const Vec3& p) const { return dot(normal, p) - offset; }
  template <class S>
  auto node() const {
    return AlgebraicPlane<S>{rounded<S>(normal), rounded<S>(offset)};
  }
};

struct QuadricCase {
  static constexpr const char* name = "quadric";
  Vec3 diagonal, mixed, linear;
  Real constant;
  explicit QuadricCase(Random& random)
      : diagonal(random.vector(-0.5L, 1)), mixed(random.vector(-0.3L, 0.3L)),
        linear(random.vector(-0.5L, 0.5L)), constant(random.uniform(-0.6L, 0.6L)) {}
  Real value(const Vec3& p) const {
    const Real squares = diagonal.x * p.x * p.x + diagonal.y * p.y * p.y + diagonal.z * p.z * p.z;
    const Real products = mixed.x * p.y * p.z + mixed.y * p.x * p.z + mixed.z * p.x * p.y;
    return squares + 2 * products + dot(linear, p) + constant;
  }
  template <class S>
  auto node() const {
    return Quadric<S>{rounded<S>(diagonal), rounded<S>(mixed), rounded<S>(linear), rounded<S>(constant)};
  }
};

/// (|p|^2 + R^2 - r^2)^2 - 4 R^2 (x^2 + y^2), halved: a functional spline of one primary and one bound.
struct TorusCase {
  static constexpr const char* name = "torus";
  Real wide, thick;
  explicit TorusCase(Random& random) : wide(random.uniform(0.35L, 0.6L)), thick(random.uniform(0.1L, 0.3L)) {}
  Real constant() const { return wide * wide - thick * thick; }
  Real value(const Vec3& p) const {
    const Real across = p.x * p.x + p.y * p.y, bound = across + p.z * p.z + constant();
    return 0.5L * bound * bound - 2 * wide * wide * across;
  }
  Real exact_distance(const Vec3& p) const {
    return std::fabs(std::hypot(std::hypot(p.x, p.y) - wide, p.z) - thick);
  }
  template <class S>
  auto node() const {
    const S one = rounded<S>(Real{1}), flat = rounded<S>(-4 * wide * wide);
    const Quadric<S> primary{{flat, flat, {}}, {}, {}, {}};
    return combine(FunctionalSpline<S>{1, 1, 2, rounded<S>(Real{0.5L})}, primary,
                   Quadric<S>{{one, one, one}, {}, {}, rounded<S>(constant())});
  }
};

struct SplineCase {
  static constexpr const char* name = "functional spline";
  PlaneCase first, second, bound;
  Real lambda;
  explicit SplineCase(Random& random)
      : first(random), second(random), bound(random), lambda(random.uniform(0.1L, 0.6L)) {
    for (PlaneCase* plane : {&first, &second, &bound}) plane->offset *= 0.4L;
  }
  Real value(const Vec3& p) const {
    const Real b = bound.value(p);
    return (1 - lambda) * first.value(p) * second.value(p) + lambda * b * b;
  }
  template <class S>
  auto node() const {
    return combine(liming<S>(rounded<S>(lambda)), first.node<S>(), second.node<S>(), bound.node<S>());
  }
};

/// Hoffmann and Hopcroft's union of a ball and a half-space, with a fillet.
struct FilletCase {
  static constexpr const char* name = "Hoffmann-Hopcroft";
  PlaneCase plane;
  Vec3 centre;
  Real radius, first_range, second_range, conic;
  explicit FilletCase(Random& random)
      : plane(random), centre(random.vector(-0.4L, 0.4L)), radius(random.uniform(0.2L, 0.6L)),
        first_range(random.uniform(0.1L, 0.4L)), second_range(random.uniform(0.1L, 0.4L)),
        conic(random.uniform(-0.5L, 0.5L)) {}
  Real value(const Vec3& p) const {
    const Real x = plane.value(p), y = squared_norm(p - centre) - radius * radius;
    const Real u = std::max(x / first_range, Real{0}), v = std::max(y / second_range, Real{0}), w = 1 - u - v;
    const Real least = std::min(x, y), fillet = u * v - w * w / (2 * (1 - conic));
    return w > 0 ? std::min(least, (first_range + second_range) * fillet) : least;
  }
  template <class S>
  auto node() const {
    const S one = rounded<S>(Real{1});
    const Real constant = squared_norm(centre) - radius * radius;
    const Quadric<S> ball{{one, one, one}, {}, rounded<S>(-2 * centre), rounded<S>(constant)};
    const auto blend =
        HoffmannHopcroftUnion<S>::of(rounded<S>(first_range), rounded<S>(second_range), rounded<S>(conic));
    return combine(blend, plane.node<S>(), ball);
  }
};

/// What is seen of one kind of field.
struct Tally {
  int clear = 0, touching = 0, undecided = 0, outside = 0, limited_by_box = 0;
  std::vector<Real> shares;
  Real loosest = 0, tightest = HUGE_VALL;  // Lipschitz bound by the greatest gradient in the box

  // At least these shares are attained, and the bound of the gradient is at most so loose.
  void expect(const char* name, Real greatest, Real median, Real looseness) {
    ASSERT_GT(shares.size(), 25u) << name;
    const auto middle = shares.begin() + static_cast<std::ptrdiff_t>(shares.size() / 2);
    std::nth_element(shares.begin(), middle, shares.end());
    const Real most = *std::max_element(shares.begin(), shares.end());
    std::printf("%-10s %4d clear, %3d of them by the box's surface, %3d touching, "
                "%2d undecided, %3d outside; ",
                name, clear, limited_by_box, touching, undecided, outside);
    std::printf("of the true distance: greatest %.4Lf, median %.3Lf; ", most, *middle);
    std::printf("rate of the greatest gradient: %.3Lf to %.2Lf\n", tightest, loosest);
    EXPECT_GT(tightest, 0.999L) << name;
    EXPECT_LT(loosest, looseness) << name;
    EXPECT_GE(most, greatest) << name;
    EXPECT_GE(*middle, median) << name;
    EXPECT_GT(touching, 50) << name;
    EXPECT_GT(limited_by_box, 20) << name;
    EXPECT_GT(outside, 100) << name;
  }
};

template <class S, class Case>
void look(const Case& of, const Vec3& half, const reference::Pose& within, const reference::Pose& around,
          const SurfaceSearch& surface, const std::vector<Vec3>& points, Tally& tally) {
  const auto boxed = in_box(rounded<S>(half), place(rounded_pose<S>(within), of.template node<S>()));
  const auto placed = field(place(rounded_pose<S>(around), boxed));
  ASSERT_TRUE(placed.valid());
  const S ball_radius = rounded<S>(Real{2});
  const auto hollow = field(subtract(Sphere<S>{rounded<S>(around.translation), ball_radius},
                                     place(rounded_pose<S>(around), boxed)));
  const Real error = real(placed.certificate().error);
  const Real looseness = 16 * real(boxed.box.lipschitz) / surface.steepest();
  tally.loosest = std::max(tally.loosest, looseness);
  tally.tightest = std::min(tally.tightest, looseness);
  for (const Vec3& local : points) {
    const Vector3<S> p = rounded<S>(reference::to_world(around, local));
    const Vec3 at = reference::to_local(around, real(p));
    const Clearance<S> answer = clearance(placed, p), in_cavity = clearance(hollow, p);
    ASSERT_NE(answer.status, ClearanceStatus::invalid);
    if (depth_in(half, at) < -1e-3L) {
      ++tally.outside;
      ASSERT_EQ(answer.status, ClearanceStatus::undecided);
      ASSERT_LE(real(answer.distance), 0);
      ASSERT_NE(in_cavity.status, ClearanceStatus::clear);
      continue;
    }
    const Real g = of.value(reference::to_local(within, at)), depth = std::max(depth_in(half, at), Real{0});
    const Real truth = std::min(surface.distance_from(at), depth);
    // Neither way farther than the surface is, and the box's surface.
    const Real value = real(placed.template evaluate<Value<S>>(p, nullptr).value);
    ASSERT_LE(std::fabs(value), truth + error);
    if (answer.status == ClearanceStatus::clear) {
      ASSERT_GT(g, 0);
      ASSERT_GT(real(answer.distance), 0);
      ASSERT_LE(real(answer.distance), truth);
      ++tally.clear;
      const bool by_box = value >= depth - 2 * error;
      tally.limited_by_box += by_box;
      if (by_box) {
        ASSERT_GE(real(answer.distance), depth - 4 * error);
      } else if (truth < depth) {
        tally.shares.push_back(real(answer.distance) / truth);
      }
    }
    if (answer.status == ClearanceStatus::touching) {
      ASSERT_LE(g, 0);
      ++tally.touching;
    }
    tally.undecided += answer.status == ClearanceStatus::undecided;
    if (in_cavity.status == ClearanceStatus::clear) {
      ASSERT_LT(g, 0);
      ASSERT_LE(real(in_cavity.distance), truth);
    }
  }
}

template <class Case>
void expect_never_above(Real greatest, Real median, Real looseness) {
  Random random(reference::announced_seed(Case::name, 434));
  Tally of_q27, of_q16, of_float;
  int cut = 0, outside = 0, enclosed = 0;
  for (int trial = 0; trial < 30; ++trial) {
    const Case of(random);
    const bool small = trial % 3 == 0;
    const Real side = trial % 2 == 0 ? -1 : 1;
    const Vec3 half = (small ? 0.1L : 1) * random.vector(0.4L, 0.8L);
    reference::Pose within{random.rotation(), random.vector(-0.4L, 0.4L)};
    const reference::Pose around{random.rotation(), random.vector(-2, 2)};
    const Function g = [&](const Vec3& p) { return of.value(reference::to_local(within, p)); };
    // Small boxes as deep inside or as far outside as there is room: most do not cut the surface.
    for (int draw = 0; small && draw < 100; ++draw) {
      const reference::Pose other{within.rotation, random.vector(-0.6L, 0.6L)};
      if (side * of.value(reference::to_local(other, {})) > side * g({})) within = other;
    }
    const SurfaceSearch surface(g, half);
    ++(surface.found() ? cut : g({}) > 0 ? outside : enclosed);
    std::vector<Vec3> points;
    for (int k = 0; k < 70; ++k) {
      const Vec3 p = random.vector(-1.2L, 1.2L);
      points.push_back({p.x * half.x, p.y * half.y, p.z * half.z});
    }
    look<Fixed<27>>(of, half, within, around, surface, points, of_q27);
    look<Fixed<16>>(of, half, within, around, surface, points, of_q16);
    look<float>(of, half, within, around, surface, points, of_float);
    if (testing::Test::HasFatalFailure()) return;
  }
  std::printf("%s: boxes that cut the surface %d, wholly outside %d, wholly inside %d\n", Case::name, cut,
              outside, enclosed);
  EXPECT_TRUE(cut > 3 && outside > 0 && enclosed > 0);
  of_q27.expect("  Fixed<27>", greatest, median, looseness);
  of_q16.expect("  Fixed<16>", 0.9L * greatest, 0.8L * median, looseness);
  of_float.expect("  float", greatest, median, looseness);
}

// What is attained: all of it for planes, less where the gradient differs within the box.
TEST(ClearanceInABox, OfAPlane) { expect_never_above<PlaneCase>(0.999L, 0.995L, 1.001L); }
TEST(ClearanceInABox, OfAQuadric) { expect_never_above<QuadricCase>(0.3L, 0.15L, 12); }
TEST(ClearanceInABox, OfATorus) { expect_never_above<TorusCase>(0.05L, 0.015L, 20); }
TEST(ClearanceInABox, OfAFunctionalSpline) { expect_never_above<SplineCase>(0.2L, 0.05L, 20); }
TEST(ClearanceInABox, OfAFillet) { expect_never_above<FilletCase>(0.1L, 0.04L, 80); }

// The search finds a torus as near as it is.
TEST(ClearanceInABox, SearchFindsTheNearestPoint) {
  Random random(reference::announced_seed("SearchFindsTheNearestPoint", 435));
  const TorusCase torus(random);
  const Vec3 half{1, 1, 0.5L};
  const SurfaceSearch search([&](const Vec3& p) { return torus.value(p); }, half);
  Real greatest = 0;
  for (int i = 0; i < 200; ++i) {
    const Vec3 p = random.vector(-0.9L, 0.9L);
    const Real found = search.distance_from(p), exact = torus.exact_distance(p);
    ASSERT_GE(found, exact - 1e-9L);
    greatest = std::max(greatest, found - exact);
  }
  std::printf("found at most %.1Le m too far\n", greatest);
  EXPECT_LT(greatest, 1e-4L);
}

}  // namespace
}  // namespace nearfield
