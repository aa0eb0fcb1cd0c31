/// Operations that take a parameter with each query: between their ends, at them, and refused outside.

#include <nearfield/query/soft_clearance.hpp>

#include <nearfield/curve/potential.hpp>
#include <nearfield/curve/tabulated_form.hpp>

#include "golden/node_writer.hpp"
#include "property/conversion.hpp"
#include "property/failures.hpp"
#include "reference/random.hpp"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <cstring>
#include <limits>

namespace nearfield::property {
namespace {

using reference::Random;
using reference::Vec3;

template <class S>
inline const Table<S, 2> potential_table = bake<S, 2>(over_square(potential::wyvill));

template <class S>
Sphere<S> ball(Real x, Real radius) {
  return {{rounded<S>(x), {}, {}}, rounded<S>(radius)};
}
template <class S>
auto glow(Real x, Real wseven) {
  return with_potential(SoftPoint<S>{{rounded<S>(x), {}, {}}, Influence<S>(rounded<S>(1.0L), rounded<S>(wseven))},
                        potential_table<S>);
}
template <class S>
auto ray(Real x) {
  return RayPoint<S>{{rounded<S>(x), {}, {}}, RayRadius<S>(rounded<S>(0.5L))};
}

template <class S>
class ParametersOf : public testing::Test {};
using Scalars = testing::Types<Fixed<27>, Fixed<24>, Fixed<16>, float>;
TYPED_TEST_SUITE(ParametersOf, Scalars, );

// field(x) of an operation against what `mix` makes of its operands' own results, and as a program.
template <class S, class Node, class Mix>
void judge(const char* name, const Node& node, const Mix& mix) {
  Random random(reference::announced_seed(name, 811));
  const auto composed = field(node);
  ASSERT_TRUE(composed.valid()) << name;
  EXPECT_EQ(composed.parameter_count(), 3u);
  golden::NodeWriter<S, 2000> writer;
  writer.table(potential_table<S>);
  writer.write(node);
  const Program<S> program(writer.builder().words(), writer.builder().finish());
  ASSERT_TRUE(program.valid()) << name << " " << static_cast<int>(program.status());
  EXPECT_EQ(program.parameter_count(), 3u);
  EXPECT_EQ(program.budget().gradient, composed.budget().gradient);
  Real worst = 0;
  for (int i = 0; i < 4000; ++i) {
    const S x = i % 8 == 0 ? S{} : i % 8 == 1 ? rounded<S>(1.0L) : rounded<S>(random.uniform(0, 1));
    const S parameters[] = {rounded<S>(0.5L), {}, x};
    const Slots<S> slots(nullptr, 0, parameters, 3);
    const Vector3<S> p = rounded<S>(random.vector(-2, 2));
    const Sample<S> a = composed.template evaluate<Sample<S>>(p, slots), b = program.template evaluate<Sample<S>>(p, slots);
    ASSERT_EQ(std::memcmp(&a, &b, sizeof a), 0) << name;
    ASSERT_TRUE(program.template evaluate<Value<S>>(p, slots).value == a.value) << name;
    const auto [value, gradient] = mix(p, real(x));
    worst = std::max({worst, std::fabs(real(a.value) - value), reference::distance(real(a.gradient), gradient)});
  }
  // Of results up to 8.
  EXPECT_LE(worst, 2 * last_place<S>(8)) << name;
  std::printf("%s in %s: off by %.2g units in the last place\n", name, ScalarName<S>::text().c_str(),
              static_cast<double>(worst / last_place<S>(8)));
}
template <class S, class Node>
std::pair<Real, Vec3> result_of(const Node& node, const Vector3<S>& p) {
  const auto sample = field(node).template evaluate<Sample<S>>(p, {});
  return {real(sample.value), real(sample.gradient)};
}
template <class S, class A, class B>
auto mixed(const A& a, const B& b) {
  return [a, b](const Vector3<S>& p, Real x) {
    const auto [va, ga] = result_of<S>(a, p);
    const auto [vb, gb] = result_of<S>(b, p);
    return std::make_pair((1 - x) * va + x * vb, (1 - x) * ga + x * gb);
  };
}

TYPED_TEST(ParametersOf, MixWhatTheirOperandsGive) {
  using S = TypeParam;
  const auto near = ball<S>(0.1L, 0.5L), far = ball<S>(-1, 0.75L);
  judge<S>("morph", combine(Morph<S>{2}, near, far), mixed<S>(near, far));
  const auto dim = glow<S>(0, 0.5L), bright = glow<S>(0.5L, 3);
  judge<S>("intensity morph", combine(IntensityMorph<S>{2}, dim, bright), mixed<S>(dim, bright));
  judge<S>("ray morph", combine(RayMorph<S>{2}, ray<S>(0), ray<S>(1)), mixed<S>(ray<S>(0), ray<S>(1)));
  judge<S>("swell", combine(Swell<S>{rounded<S>(0.75L), 2}, near), [near](const Vector3<S>& p, Real x) {
    const auto [value, gradient] = result_of<S>(near, p);
    return std::make_pair(value - x * 0.75L, gradient);
  });
  judge<S>("fade", combine(Fade<S>{2}, bright), [bright](const Vector3<S>& p, Real x) {
    const auto [value, gradient] = result_of<S>(bright, p);
    return std::make_pair(x * value, x * gradient);
  });
}

// A swollen ball is a larger ball, to the certified error; the clearance follows.
TYPED_TEST(ParametersOf, MoveTheSurface) {
  using S = TypeParam;
  const auto swelling = field(combine(Swell<S>{rounded<S>(1.0L), 0}, ball<S>(0, 0.5L)));
  for (const Real x : {0.0L, 0.25L, 0.5L, 1.0L}) {
    const S parameter = rounded<S>(x);
    const Clearance<S> answer = clearance(swelling, {rounded<S>(2.0L), {}, {}}, Slots<S>(nullptr, 0, &parameter, 1));
    EXPECT_EQ(answer.status, ClearanceStatus::clear);
    EXPECT_LE(real(answer.distance), 1.5L - x);
    EXPECT_GE(real(answer.distance), 1.5L - x - 3 * real(swelling.certificate().error));
  }
  // A soft union turns hard.
  const auto soft = glow<S>(0, 0.75L), hard = glow<S>(0, 1.5L);
  const auto turning = field(combine(IntensityMorph<S>{0}, soft, hard));
  S before = ScalarTraits<S>::greatest();
  for (const Real x : {0.0L, 0.25L, 0.5L, 0.75L, 1.0L}) {
    const S parameter = rounded<S>(x);
    const Clearance<S> answer = soft_clearance(turning, {rounded<S>(1.5L), {}, {}}, Slots<S>(nullptr, 0, &parameter, 1));
    EXPECT_EQ(answer.status, ClearanceStatus::clear);
    EXPECT_LT(answer.distance, before);
    before = answer.distance;
  }
}

// Nowhere in the ball of a soft clearance is the exact intensity 1/2.
TYPED_TEST(ParametersOf, SoftClearancesOfChangingFieldsAreFree) {
  using S = TypeParam;
  Random random(reference::announced_seed("SoftClearancesOfChangingFieldsAreFree", 812));
  const auto wyvill = [](const Vec3& p, Real x, Real wseven) {
    const Real u = reference::squared_norm(p - Vec3{x, 0, 0});
    return u >= 1 ? 0 : wseven * (1 - u * (22 - u * (17 - 4 * u)) / 9);
  };
  int clear = 0;
  for (int i = 0; i < 300; ++i) {
    const Real wsevens[] = {random.uniform(0.25L, 4), random.uniform(-2, 4), random.uniform(0.25L, 4)};
    const auto first = soft_sum(glow<S>(0, wsevens[0]), glow<S>(0.5L, wsevens[1]));
    const auto second = glow<S>(-0.5L, wsevens[2]);
    const S parameters[] = {rounded<S>(random.uniform(0, 1)), rounded<S>(random.uniform(0, 1))};
    const auto changing = field(combine(IntensityMorph<S>{0}, first, combine(Fade<S>{1}, second)));
    ASSERT_TRUE(changing.valid());
    const Vec3 at = real(rounded<S>(random.vector(-1.5L, 1.5L)));
    const Clearance<S> answer = soft_clearance(changing, rounded<S>(at), Slots<S>(nullptr, 0, parameters, 2));
    if (answer.status != ClearanceStatus::clear) continue;
    ++clear;
    const Real x = real(parameters[0]), y = real(parameters[1]);
    for (int k = 0; k < 200; ++k) {
      const Vec3 p = at + std::min(real(answer.distance), Real{3}) * random.unit_vector();
      const Real exact = (1 - x) * (wyvill(p, 0, wsevens[0]) + wyvill(p, 0.5L, wsevens[1])) + x * y * wyvill(p, -0.5L, wsevens[2]);
      ASSERT_LE(exact, 0.5L + 2 * real(changing.certificate().error)) << "case " << i;
    }
  }
  EXPECT_GT(clear, 100);
}

// The greatest number that a saturated sum stands at must not be scaled down.
TYPED_TEST(ParametersOf, SaturatingIntensitiesAreRefused) {
  using S = TypeParam;
  const auto three = soft_sum(glow<S>(0, 4), glow<S>(0, 4), glow<S>(0, 4));
  const auto seven = soft_sum(three, glow<S>(0, 4), three);
  constexpr bool saturates = std::is_same_v<S, Fixed<27>>;
  EXPECT_TRUE(field(seven).valid());
  EXPECT_TRUE(field(combine(Fade<S>{0}, three)).valid());
  EXPECT_EQ(field(combine(Fade<S>{0}, seven)).valid(), !saturates);
  EXPECT_TRUE(field(combine(IntensityMorph<S>{0}, three, three)).valid());
  EXPECT_EQ(field(combine(IntensityMorph<S>{0}, seven, glow<S>(0, -4))).valid(), !saturates);
  EXPECT_EQ(field(combine(IntensityMorph<S>{0}, glow<S>(0, -4), seven)).valid(), !saturates);
}

TYPED_TEST(ParametersOf, OutOfRangeAreRefused) {
  using S = TypeParam;
  const auto swelling = field(combine(Swell<S>{rounded<S>(1.0L), 1}, ball<S>(0, 0.5L)));
  const auto fading = field(combine(Fade<S>{1}, glow<S>(0, 1)));
  const Vector3<S> p{rounded<S>(2.0L), {}, {}};
  const auto status = [&](const Slots<S>& slots) {
    EXPECT_EQ(soft_clearance(fading, p, slots).status == ClearanceStatus::invalid,
              clearance(swelling, p, slots).status == ClearanceStatus::invalid);
    return clearance(swelling, p, slots).status;
  };
  const S one = ScalarTraits<S>::one(), unit = ScalarTraits<S>::rounding_unit(one);
  const S good[] = {rounded<S>(0.5L), one}, unused[] = {one + unit + unit, one}, above[] = {{}, one + unit + unit}, below[] = {{}, -unit};
  EXPECT_EQ(status({nullptr, 0, good, 2}), ClearanceStatus::clear);
  EXPECT_EQ(status({nullptr, 0, unused, 2}), ClearanceStatus::invalid);
  EXPECT_EQ(status({nullptr, 0, good, 1}), ClearanceStatus::invalid);
  EXPECT_EQ(status({nullptr, 0, nullptr, 2}), ClearanceStatus::invalid);
  EXPECT_EQ(status({}), ClearanceStatus::invalid);
  EXPECT_EQ(status({nullptr, 0, above, 2}), ClearanceStatus::invalid);
  EXPECT_EQ(status({nullptr, 0, below, 2}), ClearanceStatus::invalid);
  if constexpr (!ScalarTraits<S>::is_fixed) {
    const float strange[] = {0.0f, std::numeric_limits<float>::quiet_NaN()};
    EXPECT_EQ(status({nullptr, 0, strange, 2}), ClearanceStatus::invalid);
  }
  EXPECT_FALSE(field(combine(Swell<S>{rounded<S>(1.0L), kParameterLimit}, ball<S>(0, 0.5L))).valid());
  EXPECT_FALSE(field(combine(Swell<S>{rounded<S>(1.0L), 0xffffffffu}, ball<S>(0, 0.5L))).valid());
  const S limit = ScalarTraits<S>::domain();
  EXPECT_FALSE(field(combine(Swell<S>{limit + unit + limit, 0}, ball<S>(0, 0.5L))).valid());
  EXPECT_TRUE(field(combine(Swell<S>{-limit, 0}, ball<S>(0, 0.5L))).valid());
}

}  // namespace
}  // namespace nearfield::property
