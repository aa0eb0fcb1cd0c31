// Metrics as compositions, exponents below 1, and what sweeps and tori refuse.
#include <nearfield/curve/ray_kernel.hpp>
#include <nearfield/field/metrics.hpp>
#include <nearfield/shape/quadrics.hpp>
#include <property/conversion.hpp>
#include <reference/metrics.hpp>
#include <reference/random.hpp>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <limits>

namespace nearfield {
namespace {

using property::real;
using property::rounded;
using reference::Random;
using reference::Real;
using reference::Vec3;

void expect_close(Real found, Real exact, Real tolerance) {
  EXPECT_LE(std::fabs(found - exact), tolerance)
      << static_cast<double>(found) << " instead of " << static_cast<double>(exact);
}
template <class S>
bool is_valid(const RaySweep<S>& sweep) {
  return sweep.certificate(domain_reach<S>()).valid;
}
Real cut_off(Real ray) { return std::min<Real>(ray, kGreatestRay); }

constexpr auto cube_profile = profile::super_ellipsoidal_intersection(3.0);
template <class S>
constexpr auto cube_table = bake<S, 64>(cube_profile);

// Two implementations of one norm: by logarithms, and nested by a table of it.
TEST(RayMetrics, LpMetricIsTheNestedNormOfThreeSlabs) {
  using S = Fixed<27>;
  const Vector3<S> center = {0.25, -0.5, 0.125}, radii = {0.5, 0.75, 0.25};
  const Vector3<Fixed<30>> axes[3] = {{1.0, 0.0, 0.0}, {0.0, 1.0, 0.0}, {0.0, 0.0, 1.0}};
  const auto nested = field(generalised_distance(cube_profile, cube_table<S>,
                                                 RaySlab<S>{center, axes[0], RayRadius<S>(radii.x)},
                                                 RaySlab<S>{center, axes[1], RayRadius<S>(radii.y)},
                                                 RaySlab<S>{center, axes[2], RayRadius<S>(radii.z)}));
  const auto metric = field(lp_metric(center, radii, Rate(3.0)));
  ASSERT_TRUE(nested.valid() && metric.valid());
  const Real bound = real(nested.certificate().error) + real(metric.certificate().error);
  EXPECT_LT(real(metric.certificate().error), 1e-4L);
  EXPECT_LT(metric.certificate().lipschitz, nested.certificate().lipschitz);
  EXPECT_LT(metric.budget().value, nested.budget().value);
  Random random(reference::announced_seed("lp metric", 81));
  Real worst = 0, steepest = 0;
  for (int i = 0; i < 20000; ++i) {
    const Vector3<S> p = rounded<S>(random.vector(-2, 2));
    const Sample<S> a = metric.evaluate<Sample<S>>(p, nullptr), b = nested.evaluate<Sample<S>>(p, nullptr);
    worst = std::max(worst, std::fabs(real(a.value) - real(b.value)));
    steepest = std::max(steepest, reference::distance(real(a.gradient), real(b.gradient)));
  }
  EXPECT_LE(worst, bound);
  EXPECT_LT(worst, 1e-5L);
  EXPECT_LT(steepest, 1e-4L);
}

TEST(RayMetrics, BoxMetricIsTheLimitOfGreatExponents) {
  using S = Fixed<27>;
  const Vector3<S> radii = {0.5, 0.75, 0.25};
  const auto box = field(box_metric({}, radii));
  const auto metric = field(lp_metric({}, radii, Rate(64.0)));
  ASSERT_TRUE(box.valid() && metric.valid());
  Random random(reference::announced_seed("box metric", 82));
  for (int i = 0; i < 1000; ++i) {
    const Vec3 p = random.vector(-1, 1);
    const Real exact =
        reference::norm_of(std::numeric_limits<Real>::infinity(), {p.x / 0.5L, p.y / 0.75L, p.z / 0.25L});
    const Real found = real(box.evaluate<Value<S>>(rounded<S>(p), nullptr).value);
    expect_close(found, exact, 1e-6L);
    const Real great = real(metric.evaluate<Value<S>>(rounded<S>(p), nullptr).value);
    EXPECT_GE(great, found - 1e-6L);
    EXPECT_LE(great, found * std::pow(3.0L, 1 / 64.0L) + 1e-6L);
  }
}

// Exponents below 1: within the error, which is large, everywhere; and away from the planes in which a
// coordinate is 0 within what logarithms give.
template <class S>
void judge_pinched(std::uint64_t seed) {
  Random random(seed);
  Real share = 0, relative = 0;
  for (int draw = 0; draw < 200; ++draw) {
    reference::Sweep exact;
    exact.radii = {0.5L, 0.75L, 0.25L};
    constexpr Real exponents[] = {0.2L, 0.25L, 0.6L, 0.9L, 1, 2, 20};
    exact.section = exponents[random.integer(0, 4)];
    exact.ends = exponents[random.integer(0, 6)];
    if (draw % 2 == 1) {
      exact.length = 1;
      exact.twist = random.uniform(-1, 1);
      exact.end_scale = random.uniform(0.5L, 1.5L);
    }
    const RaySweep<S> sweep(rounded<S>(exact.from), rounded<S>(exact.radii), rounded<Rate>(exact.section),
                            rounded<Rate>(exact.ends), rounded<S>(exact.length), rounded<S>(exact.twist),
                            rounded<S>(exact.end_scale));
    const Certificate<S> certificate = sweep.certificate(domain_reach<S>());
    ASSERT_TRUE(certificate.valid);
    EXPECT_EQ(certificate.lipschitz == kNoRateBound, exact.section < 1 || exact.ends < 1);
    EXPECT_LE(real(certificate.error), kGreatestRay + 1);
    for (int i = 0; i < 200; ++i) {
      Vec3 p = real(rounded<S>(random.vector(-1, 1)));
      const Real tiny = property::last_place<S>(1) * static_cast<Real>(random.integer(0, 3));
      if (random.chance(0.1L)) p.x = tiny;
      if (random.chance(0.1L)) p.y = -tiny;
      if (random.chance(0.1L)) p.z = tiny;
      const Sample<S> sample = sweep.template evaluate<Sample<S>>(rounded<S>(p));
      EXPECT_EQ(ScalarTraits<S>::word(sample.value),
                ScalarTraits<S>::word(sweep.template evaluate<Value<S>>(rounded<S>(p)).value));
      const Real truth = cut_off(reference::ray_of(exact, p)), off = std::fabs(real(sample.value) - truth);
      ASSERT_LE(off, real(certificate.error)) << exact.section << " " << exact.ends;
      share = std::max(share, off / real(certificate.error));
      // Unturned, coordinates and their logarithms are as good as exact.
      if (draw % 2 == 0 && exact.from.x == 0)
        relative = std::max(relative, off / std::max<Real>(truth, 0.05L));
    }
  }
  std::printf("%s: greatest error %.3f of the certified, relative error of superquadrics 2^%.1f\n",
              property::ScalarName<S>::text().c_str(), static_cast<double>(share),
              std::log2(static_cast<double>(relative)));
  EXPECT_LT(relative, (ScalarTraits<S>::is_fixed && fraction_bits_of<S> < 20) ? 1e-3L : 3e-6L);
}
TEST(RayMetrics, ExponentsBelowOne) {
  const std::uint64_t seed = reference::announced_seed("exponents below 1", 83);
  judge_pinched<Fixed<27>>(seed);
  judge_pinched<Fixed<24>>(seed);
  judge_pinched<Fixed<16>>(seed);
  judge_pinched<float>(seed);
}

TEST(RayMetrics, GradientsOfPinchedSectionsSaturateWhereTheyAreInfinite) {
  using S = Fixed<27>;
  const RaySweep<S> pinched = superquadric<S>({}, {1.0, 1.0, 1.0}, Rate(0.25), Rate(2.0));
  const Sample<S> beside = pinched.evaluate<Sample<S>>({S::unit_in_last_place(), 0.25, 0.0});
  EXPECT_EQ(beside.gradient.x, S::greatest());
  // A relative error of 1e-3 an octave below 1/2: (x / y)^(1/4) at x = 2^-27.
  EXPECT_NEAR(beside.value.to_double(), 0.25 * std::pow(1.0 + std::pow(4.0 / 134217728.0, 0.25), 4.0), 1e-6);
  const Sample<S> on = pinched.evaluate<Sample<S>>({0.0, 0.25, 0.0});
  EXPECT_EQ(on.gradient.x, S{});
  EXPECT_NEAR(on.gradient.y.to_double(), 1.0 / 16.0, 1e-7);
  EXPECT_NEAR(on.value.to_double(), 0.25, 1e-7);
}

TEST(RaySweep, NothingButPointsOfThePathIsZero) {
  using S = Fixed<27>;
  const RaySweep<S> sweep({0.0, 0.0, -0.5}, {0.25, 0.25, 0.25}, Rate(2.0), Rate(2.0), 1.0, 0.5, 0.5);
  for (const double z : {-0.5, 0.0, 0.5}) {
    const Sample<S> on = sweep.evaluate<Sample<S>>({0.0, 0.0, z});
    EXPECT_EQ(on.value, S{}) << z;
    EXPECT_TRUE(is_zero(on.gradient)) << z;
  }
  EXPECT_GT(sweep.evaluate<Value<S>>({0.0, 0.0, 0.5 + 1e-8}).value, S{});
  EXPECT_GT(sweep.evaluate<Value<S>>({1e-8, 0.0, 0.0}).value, S{});
  EXPECT_EQ(sweep.evaluate<Value<S>>({4.0, 4.0, 0.0}).value, greatest_ray<S>());
  EXPECT_TRUE(is_zero(sweep.evaluate<Sample<S>>({4.0, 4.0, 0.0}).gradient));
}

template <class S>
void expect_refusals() {
  const Vector3<S> at{}, radii = {rounded<S>(0.5L), rounded<S>(0.25L), rounded<S>(0.75L)};
  const auto s = [](Real x) { return rounded<S>(x); };
  const Rate two(2.0);
  EXPECT_TRUE(is_valid(RaySweep<S>(at, radii, two, two)));
  EXPECT_TRUE(is_valid(RaySweep<S>(at, radii, Rate(0.2), Rate(64.0), s(1), s(-3.9L), s(1))));
  const NormExponent bad[] = {NormExponent(Rate(0.19)), NormExponent(Rate(64.01)), NormExponent(Rate()),
                              NormExponent(Rate(-2.0))};
  for (const NormExponent& exponent : bad) {
    EXPECT_FALSE(is_valid(RaySweep<S>(at, radii, exponent, two)));
    EXPECT_FALSE(is_valid(RaySweep<S>(at, radii, two, exponent)));
  }
  for (const Real radius : {0.0L, -0.5L, 1 / 65.0L, 2 * real(ScalarTraits<S>::domain())}) {
    EXPECT_FALSE(is_valid(RaySweep<S>(at, {s(radius), radii.y, radii.z}, two, two)))
        << static_cast<double>(radius);
    EXPECT_FALSE(is_valid(RaySweep<S>(at, {radii.x, radii.y, s(radius)}, two, two)))
        << static_cast<double>(radius);
  }
  // Folded: a scale of 0 and less, a section that becomes too thin, and twists.
  for (const Real scale : {0.0L, -1.0L, 0.124L, 8.1L}) {
    EXPECT_FALSE(is_valid(RaySweep<S>(at, radii, two, two, s(1), S{}, s(scale))))
        << static_cast<double>(scale);
  }
  EXPECT_FALSE(is_valid(RaySweep<S>(at, {radii.x, s(0.03L), radii.z}, two, two, s(1), S{}, s(0.25L))));
  EXPECT_FALSE(is_valid(RaySweep<S>(at, radii, two, two, s(1), s(4.1L))));
  EXPECT_FALSE(is_valid(RaySweep<S>(at, radii, two, two, s(0.1L), s(0.5L), s(1))));
  EXPECT_FALSE(is_valid(RaySweep<S>(at, {s(0.02L), s(0.02L), radii.z}, two, two, s(1), s(15.1L))));
  EXPECT_FALSE(is_valid(RaySweep<S>(at, radii, two, two, s(-1), S{}, s(1))));
  EXPECT_FALSE(is_valid(RaySweep<S>(at, radii, two, two, S{}, s(0.1L))));
  EXPECT_FALSE(is_valid(RaySweep<S>(at, radii, two, two, S{}, S{}, s(0.5L))));
  RaySweep<S> altered(at, radii, two, two, s(1), s(1), s(0.5L));
  altered.log_turning += 1;
  EXPECT_FALSE(is_valid(altered));

  const Reach<S> reach = domain_reach<S>();
  const auto torus = [&](Real ring, Real tube, Real size) {
    return AlgebraicTorus<S>(at, s(ring), s(tube), s(size)).certificate(reach).valid;
  };
  EXPECT_TRUE(torus(0.5L, 0.5L, 1));
  EXPECT_FALSE(torus(0.5L, 0.51L, 1));
  EXPECT_FALSE(torus(0.5L, 0, 1));
  EXPECT_FALSE(torus(-0.5L, 0.1L, 1));
  EXPECT_FALSE(torus(0.5L, 0.1L, 0));
  EXPECT_FALSE((RaySlab<S>{at, {rounded<Unit<S>>(1.0L), rounded<Unit<S>>(1.0L), {}}, RayRadius<S>(s(0.5L))}
                    .certificate(reach)
                    .valid));
  EXPECT_FALSE(
      (RaySlab<S>{at, {rounded<Unit<S>>(1.0L), {}, {}}, RayRadius<S>(S{})}.certificate(reach).valid));
}
TEST(RaySweep, BadParametersAreRefused) {
  expect_refusals<Fixed<27>>();
  expect_refusals<Fixed<24>>();
  expect_refusals<Fixed<16>>();
  expect_refusals<float>();
  const float nan = std::numeric_limits<float>::quiet_NaN();
  const Vector3<float> radii = {0.5f, 0.5f, 0.5f};
  EXPECT_FALSE(is_valid(RaySweep<float>({nan, 0.0f, 0.0f}, radii, Rate(2.0), Rate(2.0))));
  EXPECT_FALSE(is_valid(RaySweep<float>({}, {nan, 0.5f, 0.5f}, Rate(2.0), Rate(2.0))));
  EXPECT_FALSE(is_valid(RaySweep<float>({}, radii, Rate(2.0), Rate(2.0), 1.0f, nan)));
  EXPECT_FALSE(is_valid(RaySweep<float>({}, radii, Rate(2.0), Rate(2.0), nan)));
  EXPECT_FALSE(AlgebraicTorus<float>({}, nan, 0.1f, 1.0f).certificate(domain_reach<float>()).valid);
  EXPECT_FALSE(AlgebraicTorus<float>({}, 0.5f, nan, 1.0f).certificate(domain_reach<float>()).valid);
}

// Of one that saturates far away, in a declared box about it.
TEST(AlgebraicTorus, HasADistanceInABox) {
  using S = Fixed<27>;
  const reference::QuarticTorus exact{{}, 0.3L, 0.1L, 0.2L};
  const AlgebraicTorus<S> torus({}, 0.3, 0.1);
  EXPECT_EQ(torus.certificate(domain_reach<S>()).lipschitz, kNoRateBound);
  const auto boxed = field(in_box({0.5, 0.5, 0.25}, torus));
  ASSERT_TRUE(boxed.valid());
  Random random(reference::announced_seed("torus in a box", 84));
  for (int i = 0; i < 20000; ++i) {
    const Vec3 p = real(rounded<S>(random.vector(-0.5L, 0.5L)));
    const Real value = real(torus.evaluate<Value<S>>(rounded<S>(p)).value);
    expect_close(value, reference::quartic_of(exact, p), 64 * property::last_place<S>(1));
    if (std::fabs(p.z) > 0.25L) continue;
    const Real ring = std::hypot(std::hypot(p.x, p.y) - 0.3L, p.z) - 0.1L;
    const Real distance = real(boxed.evaluate<Value<S>>(rounded<S>(p), nullptr).value);
    EXPECT_LE(distance, std::max<Real>(ring, 0) + real(boxed.certificate().error));
    EXPECT_EQ(distance > 0, value > 0);
  }
}

// Named quadrics, where they were built and elsewhere.
TEST(Quadrics, AreTheirPolynomials) {
  constexpr double turn[9] = {0.0, -1.0, 0.0, 1.0, 0.0, 0.0, 0.0, 0.0, 1.0},
                   tip[9] = {1.0, 0.0, 0.0, 0.0, 0.0, -1.0, 0.0, 1.0, 0.0};
  constexpr auto ball = algebraic_sphere(0.5).moved(0.25, -0.5, 0.125).rounded<Fixed<27>>();
  static_assert(ball.certificate(domain_reach<Fixed<27>>()).valid, "");
  const auto bar = algebraic_cylinder(0.25, 0.5).turned(tip).moved(0.5, 0.0, 0.25).rounded<Fixed<27>>();
  const auto cone = algebraic_cone(0.5, 1.0).turned(turn).turned(tip).rounded<Fixed<27>>();
  Random random(reference::announced_seed("quadrics", 85));
  const Real c = std::cos(0.5L), s = std::sin(0.5L);
  for (int i = 0; i < 1000; ++i) {
    const Vec3 p = real(rounded<Fixed<27>>(random.vector(-1, 1)));
    const auto value = [&](const Quadric<Fixed<27>>& quadric) {
      return real(quadric.evaluate<Value<Fixed<27>>>(rounded<Fixed<27>>(p)).value);
    };
    expect_close(value(ball), reference::squared_norm(p - Vec3{0.25L, -0.5L, 0.125L}) - 0.25L, 1e-7L);
    expect_close(value(bar), ((p.x - 0.5L) * (p.x - 0.5L) + (p.z - 0.25L) * (p.z - 0.25L) - 0.0625L) / 0.5L,
                 1e-7L);
    expect_close(value(cone), (p.x * p.x + p.z * p.z) * c * c - p.y * p.y * s * s, 1e-7L);
  }
}

}  // namespace
}  // namespace nearfield
