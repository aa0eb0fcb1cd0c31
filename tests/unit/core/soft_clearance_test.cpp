// Clearances to soft surfaces: a lone object's is exact, a static field's is a program's to the bit, and what
// is refused.
#include <golden/node_writer.hpp>
#include <nearfield/curve/potential.hpp>
#include <nearfield/curve/tabulated_form.hpp>
#include <nearfield/query/soft_clearance.hpp>
#include <property/conversion.hpp>
#include <reference/random.hpp>

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <vector>

namespace nearfield {

// An intensity that cannot tell its greatest value in a ball.
template <class S>
struct Fog {
  using Scalar = S;
  static constexpr Kind kind = Kind::intensity;
  template <class Out>
  constexpr Out evaluate(const Vector3<S>&) const {
    return {};
  }
  constexpr Certificate<S> certificate(Reach<S>) const {
    Certificate<S> certificate;
    certificate.valid = true;
    return certificate;
  }
};
template <class S>
struct OperationOf<Fog<S>> {
  static constexpr Operation value = Operation::sphere;
};

namespace {

using property::real;
using property::rounded;
using reference::Random;
using reference::Real;
using reference::Vec3;

template <class S>
struct Tables {
  static constexpr Table<S, 2> over_u = bake<S, 2>(over_square(potential::wyvill));
  static constexpr Table<S, 8> over_r = bake<S, 8>(over_range(potential::Cubic{}));
};

template <class S>
S number(double x) {
  return rounded<S>(static_cast<Real>(x));
}
template <class S>
Vector3<S> at(double x, double y, double z) {
  return {number<S>(x), number<S>(y), number<S>(z)};
}
template <class S>
auto soft_ball(const Vector3<S>& center, double radius, double weight) {
  return with_potential(SoftPoint<S>{center, Influence<S>(number<S>(radius), number<S>(weight))},
                        Tables<S>::over_u);
}

template <class S>
class SoftClearanceOf : public testing::Test {};
using Scalars = testing::Types<Fixed<27>, Fixed<24>, Fixed<16>, float>;
TYPED_TEST_SUITE(SoftClearanceOf, Scalars, );

// Wyvill's is centred: F = 1/2 at half the influence radius.
TYPED_TEST(SoftClearanceOf, IsExactOfALoneBall) {
  using S = TypeParam;
  const auto lone = field(soft_ball(at<S>(0.1, -0.2, 0.3), 0.5, 1));
  Random random(reference::announced_seed("IsExactOfALoneBall", 521));
  for (int i = 0; i < 500; ++i) {
    const Vec3 away = random.unit_vector() * random.uniform(0, 2);
    const Vector3<S> p = rounded<S>(Vec3{0.1L, -0.2L, 0.3L} + away);
    const Real exact = reference::norm(real(p) - Vec3{0.1L, -0.2L, 0.3L}) - 0.25L;
    const Clearance<S> found = soft_clearance(lone, p);
    const Real coarse = 40 * real(ScalarTraits<S>::rounding_unit(ScalarTraits<S>::domain()));
    if (found.status != ClearanceStatus::clear) {
      EXPECT_EQ(real(found.distance), 0);
      EXPECT_LE(exact, coarse);
      if (found.status == ClearanceStatus::touching) {
        EXPECT_LE(exact, 0);
      }
      continue;
    }
    EXPECT_LE(real(found.distance), exact);
    EXPECT_GE(real(found.distance), exact * (1 - 1.0L / 2048) - coarse) << exact;
    if (reference::norm(away) < 0.45L) {  // beyond it F is flat, then 0
      EXPECT_LE(reference::norm(real(found.direction) - reference::normalized_or_zero(away)), 0.01L);
    }
  }
}

TYPED_TEST(SoftClearanceOf, AnswersAndRefusals) {
  using S = TypeParam;
  const auto ball = soft_ball(at<S>(0, 0, 0), 0.5, 1);
  const auto lone = field(ball);
  EXPECT_EQ(soft_clearance(lone, at<S>(0, 0, 0)).status, ClearanceStatus::touching);
  EXPECT_EQ(soft_clearance(lone, at<S>(0.2, 0, 0)).status, ClearanceStatus::touching);
  EXPECT_EQ(soft_clearance(lone, at<S>(0.25, 0, 0)).status, ClearanceStatus::undecided);
  EXPECT_EQ(soft_clearance(lone, at<S>(1, 0, 0)).status, ClearanceStatus::clear);
  EXPECT_TRUE(is_zero(soft_clearance(lone, at<S>(1, 0, 0)).direction));
  // Too weak for a surface: free as far as a query looks.
  const auto weak = field(soft_ball(at<S>(0, 0, 0), 0.5, 0.375));
  const Clearance<S> unbounded = soft_clearance(weak, at<S>(0, 0, 0));
  EXPECT_EQ(unbounded.status, ClearanceStatus::clear);
  EXPECT_GT(real(unbounded.distance), 2 * real(ScalarTraits<S>::domain()));

  const S limit = ScalarTraits<S>::domain();
  const Vector3<S> here = at<S>(1, 0, 0);
  EXPECT_EQ(soft_clearance(lone, {limit + limit, S{}, S{}}).status, ClearanceStatus::invalid);
  EXPECT_TRUE(soft_clearance(lone, {limit + limit, S{}, S{}}).distance == ScalarTraits<S>::least());
  EXPECT_EQ(soft_clearance(field(Sphere<S>{{}, number<S>(0.5)}), here).status, ClearanceStatus::invalid);
  EXPECT_EQ(soft_clearance(field(soft_ball(at<S>(0, 0, 0), -0.5, 1)), here).status, ClearanceStatus::invalid);
  EXPECT_EQ(soft_clearance(field(soft_sum(ball, Fog<S>{})), here).status, ClearanceStatus::invalid);
  EXPECT_EQ(soft_clearance(field(place(Pose<S>{}, Fog<S>{})), here).status, ClearanceStatus::invalid);
  const auto in_frame = field(in_slot(0, ball));
  Pose<S> pose;
  EXPECT_EQ(soft_clearance(in_frame, here).status, ClearanceStatus::invalid);
  EXPECT_EQ(soft_clearance(in_frame, here, nullptr, 1).status, ClearanceStatus::invalid);
  EXPECT_EQ(soft_clearance(in_frame, here, &pose, 0).status, ClearanceStatus::invalid);
  EXPECT_EQ(soft_clearance(in_frame, here, &pose, 1).status, ClearanceStatus::clear);
  pose.rotation.row[0].x = {};
  EXPECT_EQ(soft_clearance(in_frame, here, &pose, 1).status, ClearanceStatus::invalid);
  if constexpr (!ScalarTraits<S>::is_fixed) {
    EXPECT_EQ(soft_clearance(lone, {std::numeric_limits<float>::quiet_NaN(), 0, 0}).status,
              ClearanceStatus::invalid);
  }
}

// What a potential claims of its operand is believed, so that it must be subtracted.
TYPED_TEST(SoftClearanceOf, ClaimsAreSubtracted) {
  using S = TypeParam;
  const Capsule<S> center(Vector3<S>{}, Vector3<S>{}, S{});
  const auto distance = [&](const Rate& lipschitz, double error) {
    const PotentialOfDistance<S> potential(number<S>(1), number<S>(1), lipschitz, number<S>(error));
    return static_cast<double>(
        real(soft_clearance(field(combine(potential, Tables<S>::over_r, center)), at<S>(1, 0, 0)).distance));
  };
  EXPECT_NEAR(distance(kUnitRate, 0.001), 0.499, 0.0007);
  EXPECT_NEAR(distance(kUnitRate, 0.125), 0.375, 0.0007);
  EXPECT_NEAR(distance(kUnitRate + kUnitRate, 0.125), 0.1875, 0.0007);
  EXPECT_EQ(distance(kNoRateBound, 0.125), 0);
}

// Five points of weight 3.9 at one place and four of -3.9: 3.9 in exact arithmetic, far less where the sum of the five
// stops at the end of the range of Fixed<27>.
TYPED_TEST(SoftClearanceOf, SumsThatDependOnTheirOrderAreRefused) {
  using S = TypeParam;
  const auto plus = soft_ball(at<S>(0, 0, 0), 0.5, 3.9), minus = soft_ball(at<S>(0, 0, 0), 0.5, -3.9);
  const auto five = field(soft_sum(plus, plus, plus, plus, plus));
  EXPECT_TRUE(five.valid());
  const auto nine = field(soft_sum(plus, plus, plus, plus, plus, minus, minus, minus, minus));
  constexpr bool leaves = ScalarTraits<S>::is_fixed && fraction_bits_of<S> == 27;
  EXPECT_EQ(nine.valid(), !leaves);
  EXPECT_TRUE(field(soft_sum(plus, minus, plus)).valid());
  const ClearanceStatus status = soft_clearance(nine, at<S>(0.1, 0, 0)).status;
  EXPECT_EQ(status == ClearanceStatus::invalid, leaves);
  if constexpr (!leaves) {
    const Value<S> sum = nine.template evaluate<Value<S>>(at<S>(0, 0, 0), nullptr);
    EXPECT_NEAR(static_cast<double>(real(sum.value)), 3.9, static_cast<double>(real(nine.certificate().error)));
  }
}

template <class S>
class SoftClearanceIn : public testing::Test {};
using ScalarsOfPrograms = testing::Types<Fixed<27>, float>;
TYPED_TEST_SUITE(SoftClearanceIn, ScalarsOfPrograms, );

template <class S>
Pose<S> random_pose(Random& random) {
  return property::rounded_pose<S>({random.rotation(), random.vector(-0.3L, 0.3L)});
}

// Every operation that a soft field has, in frames and slots.
template <class S>
auto whole_scene(Random& random) {
  const auto point = [&random] { return rounded<S>(random.vector(-0.4L, 0.4L)); };
  const auto length = [&random] { return rounded<S>(random.uniform(0.3L, 1)); };
  const auto weight = [&random] { return rounded<S>(random.uniform(-1, 1.2L)); };
  const SoftPoint<S> ball{point(), Influence<S>(length(), weight())};
  const SoftSegment<S> rod{Capsule<S>(point(), point(), S{}), Influence<S>(length(), weight())};
  const auto group = combine(SharpUnion<S>{}, Capsule<S>(point(), point(), S{}),
                             place(random_pose<S>(random), Sphere<S>{point(), number<S>(0.1)}));
  const PotentialOfDistance<S> of_group(length(), weight(), rounded<Rate>(1.5L), number<S>(0.01));
  const RayPoint<S> seed{point(), RayRadius<S>(length())};
  const PotentialOfRay<S> of_seed(ScalarTraits<S>::one(), weight(), rounded<Rate>(4), number<S>(0.01));
  return combine(
      IntensityUnion<S>{},
      soft_sum(with_potential(ball, Tables<S>::over_u),
               place(random_pose<S>(random), with_potential(rod, Tables<S>::over_u))),
      combine(IntensityIntersection<S>{}, in_slot(1, combine(of_group, Tables<S>::over_r, group)),
              place(random_pose<S>(random), in_slot(0, combine(of_seed, Tables<S>::over_r, seed)))));
}

TYPED_TEST(SoftClearanceIn, StaticFieldsAndProgramsAgree) {
  using S = TypeParam;
  EXPECT_EQ(soft_clearance(Program<S>{}, Vector3<S>{}).status, ClearanceStatus::invalid);
  Random random(reference::announced_seed("StaticFieldsAndProgramsAgree", 522));
  int clear = 0;
  for (int i = 0; i < 40; ++i) {
    const auto node = whole_scene<S>(random);
    const auto composed = field(node);
    ASSERT_TRUE(composed.valid());
    golden::NodeWriter<S, 900> writer;
    writer.table(Tables<S>::over_u);
    writer.table(Tables<S>::over_r);
    writer.write(node);
    ASSERT_EQ(writer.builder().finish().status, LoadStatus::ok);
    const Program<S> program = load<S>(writer.builder().words(), writer.builder().size() * sizeof(uint32_t));
    ASSERT_TRUE(program.valid());
    EXPECT_TRUE(program.has_highest() && composed.has_highest());
    EXPECT_TRUE(program.certificate().error == composed.certificate().error);
    EXPECT_TRUE(program.certificate().lipschitz == composed.certificate().lipschitz);
    const std::vector<Pose<S>> slots = {random_pose<S>(random), random_pose<S>(random)};
    for (int k = 0; k < 30; ++k) {
      const Vector3<S> p = rounded<S>(random.vector(-1.5L, 1.5L));
      const S radius = rounded<S>(random.uniform(0, 1));
      EXPECT_TRUE(composed.highest(p, radius, slots.data()).value ==
                  program.highest(p, radius, slots.data()).value);
      // Never less than what is evaluated anywhere in the ball.
      const Vector3<S> q =
          rounded<S>(real(p) + real(radius) * random.uniform(0, 0.9999L) * random.unit_vector());
      const Real there = real(program.template evaluate<Value<S>>(q, slots.data()).value);
      EXPECT_LE(there,
                real(program.highest(p, radius, slots.data()).value) + 2 * real(program.certificate().error));
      const Clearance<S> a = soft_clearance(composed, p, slots.data(), 2),
                         b = soft_clearance(program, p, slots.data(), 2);
      EXPECT_EQ(a.status, b.status);
      EXPECT_TRUE(a.distance == b.distance && a.direction == b.direction);
      if (a.status == ClearanceStatus::clear) ++clear;
    }
  }
  EXPECT_GT(clear, 300);
}

// All radii of a query, in order.
TYPED_TEST(SoftClearanceOf, RadiiAscend) {
  using S = TypeParam;
  S before{};
  for (uint32_t code = 0; code < (1u << kSoftClearanceSteps); ++code) {
    const S radius = detail::soft_clearance_radius<S>(code);
    ASSERT_TRUE(code == 0 ? radius == S{} : radius >= before) << code;
    if (code > 16 * 2048) {
      ASSERT_LE(real(radius), real(before) * (1 + 1.0L / 2047)) << code;
    }
    before = radius;
  }
  EXPECT_GT(real(before), 3.4L * real(ScalarTraits<S>::domain()));  // as far as two points may be apart
}

// Small rates and balls larger than the number range would hold, times 16.
TEST(SoftClearance, OfPotentialsOfRaysIsNeverAboveTheDistanceFarAway) {
  using S = Fixed<27>;
  static constexpr auto potential = bake<S, 16>(potential::Cubic{});
  for (const double radius : {0.1, 0.25, 0.5, 1.0, 2.0, 4.0}) {
    const RayPoint<S> point{{}, RayRadius<S>(S(radius))};
    const Certificate<S> of = point.certificate(domain_reach<S>());
    const auto soft = field(combine(PotentialOfRay<S>(S(1.0), S(1.0), of), potential, point));
    ASSERT_TRUE(soft.valid());
    // The cubic potential is 1/2 at half its range.
    for (double x = 0.51 * radius; x < 4.0; x += 0.037) {
      const Clearance<S> answer = soft_clearance(soft, {S(x), {}, {}});
      ASSERT_NE(answer.status, ClearanceStatus::touching);
      ASSERT_LE(answer.distance.to_double(), x - 0.5 * radius) << "radius " << radius << " at " << x;
      // Rays end at 15.
      if (x > 0.6 * radius && x < 14 * radius) {
        ASSERT_EQ(answer.status, ClearanceStatus::clear);
        ASSERT_GE(answer.distance.to_double(), 0.9 * (x - 0.5 * radius)) << "radius " << radius << " at " << x;
      }
    }
  }
}

}  // namespace
}  // namespace nearfield
