// Ray functions of points, segments and planes against long double, and their certificates.
#include <golden/node_writer.hpp>
#include <nearfield/field/program.hpp>
#include <nearfield/shape/ray.hpp>
#include <property/conversion.hpp>
#include <reference/random.hpp>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <functional>
#include <string>

namespace {

using namespace nearfield;
using property::real;
using reference::announced_seed;
using reference::Random;
using reference::Real;
using reference::Vec3;

template <class S>
S scalar(Real x) {
  return property::rounded<S>(x);
}
template <class S>
Vector3<S> rounded(const Vec3& v) {
  return {scalar<S>(v.x), scalar<S>(v.y), scalar<S>(v.z)};
}
template <class S>
Vec3 exact(const Vector3<S>& v) {
  return {real(v.x), real(v.y), real(v.z)};
}
Real length(const Vec3& v) { return std::sqrt(reference::squared_norm(v)); }
Real dot_product(const Vec3& a, const Vec3& b) { return a.x * b.x + a.y * b.y + a.z * b.z; }

struct Greatest {
  Real of_error = 0;
  int off_the_ceiling = 0;
};

// What a shape gives at a point, as real numbers.
struct Evaluated {
  bool valid = false;
  Real value = 0;
  Vec3 gradient{};
  Real error = 0;       // certified
  Real last_place = 0;  // of the gradient
};
template <class S, class Shape>
[[gnu::noinline]] Evaluated evaluated(const Shape& shape, const Vec3& exact_point) {
  const Vector3<S> p = rounded<S>(exact_point);
  const auto certificate = shape.certificate(domain_reach<S>());
  const auto value = shape.template evaluate<Value<S>>(p);
  const auto sample = shape.template evaluate<Sample<S>>(p);
  EXPECT_EQ(ScalarTraits<S>::word(value.value), ScalarTraits<S>::word(sample.value));
  const Real last_place = ScalarTraits<S>::is_fixed ? std::ldexp(1.0L, -fraction_bits_of<S>) : 2e-7L;
  return {certificate.valid, real(sample.value), exact(sample.gradient), real(certificate.error), last_place};
}

// Value within the certificate's error of the exact one, gradient the exact one's, constant at the greatest
// ray value.
void expect_exact(const Evaluated& found, const Vec3& offset, Real distance, Real radius,
                  Greatest& greatest) {
  ASSERT_TRUE(found.valid);
  const Real expected = std::min<Real>(distance / radius, kGreatestRay);
  const Real error = std::fabs(found.value - expected);
  EXPECT_LE(error, found.error) << expected;
  greatest.of_error = std::max(greatest.of_error, error / found.error);
  if (found.value == kGreatestRay) {
    EXPECT_EQ(length(found.gradient), 0);
  }
  if (distance / radius > kGreatestRay - 0.01L) return;
  ++greatest.off_the_ceiling;
  // The direction comes from rounded coordinates.
  const Real steepness = 1 / (16 * radius);
  const Vec3 gradient = distance > 0 ? offset / distance * steepness : Vec3{0, 0, 0};
  const Real turned = distance > 0 ? 16 * found.last_place / distance * steepness : steepness;
  const Real of_radius = found.last_place / radius * steepness;
  EXPECT_LE(length(found.gradient - gradient), 3 * found.last_place + 1e-7L * steepness + turned + of_radius);
}

template <class S>
class RayShapes : public testing::Test {};
using Scalars = testing::Types<Fixed<27>, Fixed<24>, Fixed<16>, float>;
TYPED_TEST_SUITE(RayShapes, Scalars, );

Real random_radius(Random& random) { return std::exp(random.uniform(std::log(1.0L / 63), std::log(4.0L))); }
// Within the domain of every scalar, mostly near its middle.
Vec3 random_point(Random& random) { return random.vector(-4, 4) * std::exp(random.uniform(-6, 0)); }

TYPED_TEST(RayShapes, PointsAreWithinTheirCertificates) {
  using S = TypeParam;
  Random random(announced_seed("RayShapes.PointsAreWithinTheirCertificates", 311));
  Greatest greatest;
  for (int i = 0; i < 4000; ++i) {
    const Real radius = random_radius(random);
    const Vec3 center = random.vector(-1, 1);
    const RayPoint<S> shape{rounded<S>(center), RayRadius<S>(scalar<S>(radius))};
    const Vec3 p = exact(rounded<S>(random_point(random)));
    expect_exact(evaluated<S>(shape, p), p - center, length(p - center), radius, greatest);
  }
  std::printf("greatest error / bound %.3Lf\n", greatest.of_error);
  EXPECT_GT(greatest.off_the_ceiling, 1000);
  EXPECT_GT(greatest.of_error, ScalarTraits<S>::is_fixed ? 0.1L : 0.005L);
}

TYPED_TEST(RayShapes, SegmentsAreWithinTheirCertificates) {
  using S = TypeParam;
  Random random(announced_seed("RayShapes.SegmentsAreWithinTheirCertificates", 312));
  Greatest greatest;
  for (int i = 0; i < 4000; ++i) {
    const Real radius = random_radius(random);
    const Vec3 from = exact(rounded<S>(random.vector(-0.4L, 0.4L))),
               to = exact(rounded<S>(random.vector(-0.4L, 0.4L)));
    const Capsule<S> segment(rounded<S>(from), rounded<S>(to), S{});
    const RaySegment<S> shape{segment, RayRadius<S>(scalar<S>(radius))};
    const Vec3 p = exact(rounded<S>(random_point(random)));
    // The segment that the parameters describe.
    const Vec3 axis = exact(segment.axis);
    const Real place = std::min(std::max<Real>(dot_product(p - from, axis), 0), real(segment.length));
    const Vec3 offset = p - from - axis * place;
    expect_exact(evaluated<S>(shape, p), offset, length(offset), radius, greatest);
  }
  std::printf("greatest error / bound %.3Lf\n", greatest.of_error);
  EXPECT_GT(greatest.off_the_ceiling, 1000);
}

TYPED_TEST(RayShapes, PlanesAreWithinTheirCertificates) {
  using S = TypeParam;
  Random random(announced_seed("RayShapes.PlanesAreWithinTheirCertificates", 313));
  Greatest greatest;
  for (int i = 0; i < 4000; ++i) {
    const Real radius = random_radius(random);
    const Vec3 point = random.vector(-1, 1), normal = random.unit_vector();
    const RayPlane<S> shape{rounded<S>(point), rounded<Unit<S>>(normal), RayRadius<S>(scalar<S>(radius))};
    const Vec3 p = exact(rounded<S>(random_point(random)));
    const Real height = dot_product(p - point, normal);
    if (height < -1e-3L) {
      const auto below = shape.template evaluate<Sample<S>>(rounded<S>(p));
      EXPECT_EQ(real(below.value), 0);
      EXPECT_TRUE(is_zero(below.gradient));
    } else if (height > 1e-3L) {
      expect_exact(evaluated<S>(shape, p), normal * height, height, radius, greatest);
    }
  }
  std::printf("greatest error / bound %.3Lf\n", greatest.of_error);
  EXPECT_GT(greatest.off_the_ceiling, 500);
}

TYPED_TEST(RayShapes, NeverChangeFasterThanCertified) {
  using S = TypeParam;
  Random random(announced_seed("RayShapes.NeverChangeFasterThanCertified", 314));
  Real greatest = 0;
  for (int i = 0; i < 4000; ++i) {
    const Real radius = random_radius(random);
    const RayPoint<S> shape{{}, RayRadius<S>(scalar<S>(radius))};
    const auto certificate = shape.certificate(domain_reach<S>());
    const Vector3<S> p = rounded<S>(random.vector(-1, 1)), q = rounded<S>(random.vector(-1, 1));
    const Real change = std::fabs(real(shape.template evaluate<Value<S>>(p).value) -
                                  real(shape.template evaluate<Value<S>>(q).value));
    const Real bound = 16 * real(certificate.lipschitz) * length(exact(p) - exact(q));
    EXPECT_LE(change, bound + 2 * real(certificate.error));
    greatest = std::max(greatest, change / bound);
  }
  EXPECT_GT(greatest, 0.9L);
}

TYPED_TEST(RayShapes, RefuseBadParameters) {
  using S = TypeParam;
  const auto valid = [](const auto& shape) { return shape.certificate(domain_reach<S>()).valid; };
  const auto with_radius = [](Real radius) { return RayPoint<S>{{}, RayRadius<S>(scalar<S>(radius))}; };
  EXPECT_TRUE(valid(with_radius(1.0L / 64)));
  EXPECT_TRUE(valid(with_radius(4)));
  EXPECT_FALSE(valid(with_radius(2 * real(ScalarTraits<S>::domain()))));
  EXPECT_FALSE(valid(with_radius(1.0L / 65)));
  EXPECT_FALSE(valid(with_radius(0)));
  EXPECT_FALSE(valid(with_radius(-1)));
  EXPECT_FALSE(valid(RayPoint<S>{}));
  RayPoint<S> forged = with_radius(1);
  forged.influence.gradient_factor = scalar<S>(0.07L);
  EXPECT_FALSE(valid(forged));
  forged = with_radius(1);
  forged.influence.inverse = reciprocal_of(scalar<S>(1.5L));
  EXPECT_FALSE(valid(forged));
  forged = with_radius(1);
  forged.center.x = ScalarTraits<S>::greatest();
  EXPECT_FALSE(valid(forged));

  const RayRadius<S> influence(scalar<S>(1));
  const Vector3<Unit<S>> up{{}, {}, ScalarTraits<S>::unit_one()}, none{}, slanted{up.z, {}, up.z};
  EXPECT_TRUE(valid(RayPlane<S>{{}, up, influence}));
  EXPECT_FALSE(valid(RayPlane<S>{{}, none, influence}));
  EXPECT_FALSE(valid(RayPlane<S>{{}, slanted, influence}));
  Capsule<S> segment(Vector3<S>{}, Vector3<S>{scalar<S>(1), {}, {}}, S{});
  EXPECT_TRUE(valid(RaySegment<S>{segment, influence}));
  segment.radius = scalar<S>(0.1L);
  EXPECT_FALSE(valid(RaySegment<S>{segment, influence}));
}

// Static composition and program: the same bits.
template <class S, class Shape>
void expect_same_as_program(const Shape& shape, Random& random) {
  golden::NodeWriter<S, 200> writer;
  writer.write(shape);
  ASSERT_EQ(writer.builder().finish().status, LoadStatus::ok);
  const Program<S> program = load<S>(writer.builder().words(), writer.builder().size() * 4u);
  ASSERT_TRUE(program.valid());
  EXPECT_EQ(program.kind(), Kind::ray);
  for (int i = 0; i < 50; ++i) {
    const Vector3<S> p = rounded<S>(random.vector(-2, 2));
    const auto here = shape.template evaluate<Sample<S>>(p);
    const auto there = program.template evaluate<Sample<S>>(p, nullptr);
    EXPECT_EQ(ScalarTraits<S>::word(here.value), ScalarTraits<S>::word(there.value));
    EXPECT_TRUE(here.gradient == there.gradient);
  }
}

TYPED_TEST(RayShapes, AreTheSameInPrograms) {
  using S = TypeParam;
  Random random(announced_seed("RayShapes.AreTheSameInPrograms", 315));
  const RayRadius<S> influence(scalar<S>(0.3L));
  const Vector3<S> a = rounded<S>(random.vector(-1, 1)), b = rounded<S>(random.vector(-1, 1));
  expect_same_as_program<S>(RayPoint<S>{a, influence}, random);
  expect_same_as_program<S>(RaySegment<S>{Capsule<S>(a, b, S{}), influence}, random);
  expect_same_as_program<S>(RayPlane<S>{a, rounded<Unit<S>>(random.unit_vector()), influence}, random);
}

}  // namespace
