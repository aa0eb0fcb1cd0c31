// Algebraic fields: arithmetic, planes and quadrics, conversions, functional splines, and their certificates.
#include "algebraic_samples.hpp"

#include <reference/algebraic_blends.hpp>

namespace {

using namespace nearfield;
using namespace nearfield::test;
using reference::announced_seed;

template <class S>
class AlgebraicOf : public testing::Test {};
TYPED_TEST_SUITE(AlgebraicOf, AllScalars, );

// Every combination of the greatest and some ordinary numbers: in range and with the sign of the exact
// result.
TYPED_TEST(AlgebraicOf, SaturationKeepsTheSign) {
  using S = TypeParam;
  const S limit = algebraic_limit<S>();
  const S least = ScalarTraits<S>::is_fixed ? ScalarTraits<S>::least() : S{} - limit;
  const std::vector<S> ends = {least, S{} - limit,       number<S>(-2), number<S>(-0.125L),
                               S{},   number<S>(0.125L), number<S>(2),  limit};
  const auto expect_sign = [&](S result, Real exact) {
    EXPECT_TRUE(result <= limit && result >= least);
    const Real smallest = unit<S>(1e-20L);
    EXPECT_TRUE(!(exact > smallest) || result > S{}) << static_cast<double>(exact);
    EXPECT_TRUE(!(exact < -smallest) || result < S{}) << static_cast<double>(exact);
  };
  for (const S a : ends) {
    for (const S b : ends) {
      for (const S g : ends) {
        for (const S h : ends) {
          const Sample<S> left = {a, {g, {}, g}}, right = {b, {h, h, {}}};
          const Sample<S> product = algebraic_product(left, right);
          expect_sign(product.value, real(a) * real(b));
          expect_sign(product.gradient.x, real(a) * real(h) + real(b) * real(g));
          expect_sign(product.gradient.y, real(a) * real(h));
          expect_sign(product.gradient.z, real(b) * real(g));
          const Sample<S> sum = algebraic_sum(left, right);
          expect_sign(sum.value, real(a) + real(b));
          expect_sign(sum.gradient.x, real(g) + real(h));
          const Sample<S> scaled = algebraic_scaled(left, b);
          expect_sign(scaled.value, real(a) * real(b));
          expect_sign(scaled.gradient.x, real(g) * real(b));
        }
      }
      const Value<S> cube = algebraic_power(Value<S>{a}, 3);
      if (std::fabs(real(a)) >= 0.125L) expect_sign(cube.value, real(a) * real(a) * real(a));
    }
  }
}

TYPED_TEST(AlgebraicOf, LeavesAreTheirPolynomials) {
  using S = TypeParam;
  Random random(announced_seed("LeavesAreTheirPolynomials", 41));
  const Real reach_metres = 1.5L;
  const Reach<S> reach = {number<S>(reach_metres)};
  CertificateCheck planes, quadrics;
  Real gradient_units = 0;
  for (int i = 0; i < 300; ++i) {
    const auto look = [&](const auto& leaf, CertificateCheck& check) {
      const auto shape = leaf.template as<S>();
      check.look<S>(
          shape.certificate(reach),
          [&](const Vector3<S>& p) { return shape.template evaluate<Value<S>>(p).value; },
          [&](const Vec3& p) { return leaf.value(p); }, random, reach_metres, 20);
      const Vector3<S> at = vector<S>(in_ball(random, reach_metres));
      const Sample<S> sample = shape.template evaluate<Sample<S>>(at);
      EXPECT_EQ(sample.value, shape.template evaluate<Value<S>>(at).value);
      const Real off = greatest_component(real(sample.gradient) - leaf.gradient(real(at)));
      gradient_units = std::max(gradient_units, off / unit<S>(1));
    };
    look(random_plane(random), planes);
    look(random_quadric(random), quadrics);
  }
  planes.expect_bounds("planes");
  quadrics.expect_bounds("quadrics");
  std::printf("gradients of leaves: within %.2Lf units\n", gradient_units);
  EXPECT_LE(gradient_units, 1);
}

TYPED_TEST(AlgebraicOf, LeavesOutOfRangeAreRefused) {
  using S = TypeParam;
  const Reach<S> reach = {number<S>(1)};
  const S too_large = ScalarTraits<S>::domain() + ScalarTraits<S>::one();
  const ExactQuadric ball = {{1, 1, 1}, {}, {}, -0.25L};
  Quadric<S> quadric = ball.as<S>();
  EXPECT_TRUE(quadric.certificate(reach).valid);
  quadric.off_diagonal.y = too_large;
  EXPECT_FALSE(quadric.certificate(reach).valid);
  EXPECT_FALSE((AlgebraicPlane<S>{{too_large, {}, {}}, {}}.certificate(reach).valid));
  EXPECT_FALSE((AlgebraicPlane<S>{{}, S{} - too_large}.certificate(reach).valid));
  if constexpr (!ScalarTraits<S>::is_fixed) {
    const float nan = std::numeric_limits<float>::quiet_NaN();
    EXPECT_FALSE((AlgebraicPlane<float>{{nan, 0, 0}, 0}.certificate(reach).valid));
    quadric = ball.as<S>();
    quadric.constant = nan;
    EXPECT_FALSE(quadric.certificate(reach).valid);
  }
}

// What may saturate says so.
TEST(AlgebraicCertificates, SaturationIsDeclared) {
  using S = Fixed<27>;
  const ExactQuadric ball = {{1, 1, 1}, {}, {}, -0.25L};
  const Certificate<S> far = ball.as<S>().certificate(domain_reach<S>());
  EXPECT_TRUE(far.valid);
  EXPECT_EQ(far.magnitude, S::greatest());
  EXPECT_EQ(far.lipschitz, kNoRateBound);
  EXPECT_EQ(far.error, S::greatest());
  // Nor does a result that is small again make up for it.
  const FunctionalSpline<S> spline = {1, 1, 2, 0.5};
  const Certificate<S> near = ball.as<S>().certificate({1.0});
  const Certificate<S> of_far[2] = {far, near}, of_near[2] = {near, near};
  EXPECT_EQ(spline.certificate(of_far, {}, {}).lipschitz, kNoRateBound);
  EXPECT_EQ(spline.certificate(of_far, {}, {}).magnitude, S::greatest());
  EXPECT_NE(spline.certificate(of_near, {}, {}).lipschitz, kNoRateBound);
  const Certificate<S> both = AlgebraicUnion<S>{}.certificate(of_far, {}, {});
  EXPECT_EQ(both.lipschitz, kNoRateBound);
  EXPECT_EQ(both.magnitude, S::greatest());
}

template <class S>
struct SplineOperands {
  std::vector<Sample<S>> samples;
  std::vector<Real> primaries, bounds;

  SplineOperands(const FunctionalSpline<S>& spline, Random& random, Real greatest) {
    for (uint32_t i = 0; i < spline.primary_count + spline.bound_count; ++i) {
      samples.push_back(sample<S>(random, greatest, 0.125L));
      (i < spline.primary_count ? primaries : bounds).push_back(real(samples.back().value));
    }
  }
};

TYPED_TEST(AlgebraicOf, FunctionalSplinesAreTheReference) {
  using S = TypeParam;
  Random random(announced_seed("FunctionalSplinesAreTheReference", 42));
  Ratio error, gradient_error;
  for (int i = 0; i < 3000; ++i) {
    FunctionalSpline<S> spline;
    spline.primary_count = static_cast<uint32_t>(random.integer(1, 4));
    spline.bound_count = static_cast<uint32_t>(random.integer(1, 4));
    const Real wanted_lambda = random.uniform(-1, 1);
    spline.lambda = number<S>(wanted_lambda);
    if (spline.lambda == S{}) continue;
    const SplineOperands<S> of(spline, random, 1.25L);
    std::vector<Certificate<S>> certificates;
    for (const Sample<S>& operand : of.samples) {
      Certificate<S> exact;
      exact.valid = true;
      exact.magnitude = absolute(operand.value);
      certificates.push_back(exact);
    }
    const Certificate<S> certificate = spline.certificate(certificates.data(), {}, {});
    ASSERT_TRUE(certificate.valid);
    const Sample<S> got = spline.template combine_all<Sample<S>>(of.samples.data());
    const reference::PatchPoint expected =
        reference::functional_spline(wanted_lambda, of.primaries, of.bounds);
    error.see(std::fabs(real(got.value) - expected.value), real(certificate.error));
    std::vector<Real> partials = expected.by_primaries;
    partials.insert(partials.end(), expected.by_bounds.begin(), expected.by_bounds.end());
    // Every partial is off by no more than some units for each factor.
    const Vec3 off = real(got.gradient) - chained(of.samples, partials);
    gradient_error.see(greatest_component(off), 6 * unit<S>(1));
  }
  std::printf("functional splines: error %.3Lf of the bound, gradient %.3Lf of 6 units\n", error.greatest(),
              gradient_error.greatest());
  EXPECT_LE(error.greatest(), 1);
  EXPECT_LE(gradient_error.greatest(), 1);
  EXPECT_GT(error.greatest(), 0.02L);
}

TYPED_TEST(AlgebraicOf, LimingIsTheReferenceAndAConicOfHoffmann) {
  using S = TypeParam;
  Random random(announced_seed("LimingIsTheReferenceAndAConicOfHoffmann", 43));
  for (int i = 0; i < 1000; ++i) {
    const Real lambda = random.uniform(0.05L, 0.95L);
    const FunctionalSpline<S> blend = liming(number<S>(lambda));
    const Sample<S> of[3] = {sample<S>(random, 1, 0.125L), sample<S>(random, 1, 0.125L),
                             sample<S>(random, 1, 0.125L)};
    const Sample<S> got = blend.template combine_all<Sample<S>>(of);
    const auto expected = reference::liming(lambda, real(of[0].value), real(of[1].value), real(of[2].value));
    ASSERT_LE(std::fabs(real(got.value) - expected.value), 5 * unit<S>(1));
    const Vec3 gradient = chained<S>({of[0], of[1], of[2]}, {expected.by_l1, expected.by_l2, expected.by_c});
    ASSERT_LE(greatest_component(real(got.gradient) - gradient), 6 * unit<S>(1));

    const reference::ScaleRanges ranges = {random.uniform(0.2L, 1), random.uniform(0.2L, 1),
                                           random.uniform(-0.5L, 0.03L)};
    const Real share = 1 / (1 + 2 * (ranges.r1 * ranges.r2 - ranges.p));
    const Real l1 = random.uniform(-1, 1), l2 = random.uniform(-1, 1);
    const Real chord = ranges.r1 * ranges.r2 - ranges.r2 * l1 - ranges.r1 * l2;
    const Value<S> conic_of[3] = {{number<S>(-l1)}, {number<S>(l2)}, {number<S>(chord)}};
    const Real conic = real(liming(number<S>(share)).template combine_all<Value<S>>(conic_of).value);
    ASSERT_LE(std::fabs(conic - share * reference::hoffmann_conic(ranges, l1, l2)), 24 * unit<S>(1));
  }
}

TEST(FunctionalSplines, CountsOutOfRangeAreRefused) {
  using S = Fixed<24>;
  Certificate<S> good;
  good.valid = true;
  good.magnitude = 1.0;
  const std::vector<Certificate<S>> of(16, good);
  const auto valid = [&](const FunctionalSpline<S>& spline) {
    return spline.certificate(of.data(), {}, {}).valid;
  };
  EXPECT_TRUE(valid({8, 8, 2, 0.5}));
  EXPECT_TRUE(valid({1, 1, 4, -1.0}));
  for (const FunctionalSpline<S>& spline :
       {FunctionalSpline<S>{0, 1, 2, 0.5}, FunctionalSpline<S>{1, 0, 2, 0.5},
        FunctionalSpline<S>{9, 1, 2, 0.5}, FunctionalSpline<S>{1, 9, 2, 0.5},
        FunctionalSpline<S>{0x80000001u, 0x80000001u, 2, 0.5}}) {
    EXPECT_FALSE(valid(spline));
    EXPECT_EQ(spline.operand_count(), 0);
  }
  EXPECT_FALSE(valid({1, 1, 0, 0.5}));
  EXPECT_FALSE(valid({1, 1, 5, 0.5}));
  EXPECT_FALSE(valid({1, 1, 2, 0.0}));
  EXPECT_FALSE(valid({1, 1, 2, 1.1}));
  EXPECT_FALSE(valid({1, 1, 2, -1.1}));
}

TYPED_TEST(AlgebraicOf, ConversionsForgetTheUnit) {
  using S = TypeParam;
  Random random(announced_seed("ConversionsForgetTheUnit", 44));
  for (int i = 0; i < 1000; ++i) {
    const Sample<S> operand = sample<S>(random, 2, 1);
    const S factor = number<S>(random.uniform(-2, 2)), level = number<S>(random.uniform(0.1L, 1));
    const Sample<S> distance = AlgebraicOfDistance<S>{factor}.combine(operand);
    ASSERT_LE(std::fabs(real(distance.value) - real(factor) * real(operand.value)), unit<S>(4));
    ASSERT_LE(greatest_component(real(distance.gradient) - (real(factor) / 16) * real(operand.gradient)),
              unit<S>(1));
    const Sample<S> ray = AlgebraicOfRay<S>{level, factor}.combine(operand);
    const Real within = std::max(Real{0}, real(operand.value));
    ASSERT_LE(std::fabs(real(ray.value) - real(factor) * (within - real(level))), unit<S>(4));
    ASSERT_LE(greatest_component(real(ray.gradient) - real(factor) * real(operand.gradient)), unit<S>(2));
  }
  // The surface of a soft object.
  EXPECT_EQ((AlgebraicOfRay<S>{}.combine(Value<S>{number<S>(0.5L)}).value), S{});
}

// A spline of two balls by distance and a plane, against the same in exact arithmetic.
TYPED_TEST(AlgebraicOf, CertificatesHold) {
  using S = TypeParam;
  Random random(announced_seed("CertificatesHold", 45));
  const Real reach_metres = 1;
  CertificateCheck splines, sharp;
  for (int i = 0; i < 60; ++i) {
    const Vec3 centre = random.vector(-0.3L, 0.3L);
    const Real radius = random.uniform(0.1L, 0.5L), factor = random.uniform(0.3L, 1),
               lambda = random.uniform(-0.9L, 0.9L);
    const Sphere<S> ball = {vector<S>(centre), number<S>(radius)};
    const RealPlane plane = random_plane(random);
    const ExactQuadric quadric = random_quadric(random);
    FunctionalSpline<S> spline = liming(number<S>(lambda));
    spline.exponent = static_cast<uint32_t>(random.integer(1, 3));
    const auto ball_value = combine(AlgebraicOfDistance<S>{number<S>(factor)}, ball);
    const auto node = combine(spline, ball_value, quadric.as<S>(), plane.as<S>());
    const auto exact_ball = [&](const Vec3& p) { return factor * (distance(p, centre) - radius); };
    const auto exact = [&](const Vec3& p) {
      Real bound = 1;
      for (uint32_t e = 0; e < spline.exponent; ++e) bound *= plane.value(p);
      return (1 - lambda) * exact_ball(p) * quadric.value(p) + lambda * bound;
    };
    look_at_node<S>(splines, node, exact, random, reach_metres);
    const auto least = combine(AlgebraicUnion<S>{}, ball_value, quadric.as<S>());
    look_at_node<S>(
        sharp, least, [&](const Vec3& p) { return std::min(exact_ball(p), quadric.value(p)); }, random,
        reach_metres);
  }
  splines.expect_bounds("splines");
  sharp.expect_bounds("sharp unions");
}

}  // namespace
