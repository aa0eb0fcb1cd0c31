/// Potentials of distances and rays, and the certificates of intensities, against the papers' own formulas.

#include <nearfield/curve/curves.hpp>
#include <nearfield/curve/tabulated_form.hpp>
#include <nearfield/field/builder.hpp>
#include <nearfield/field/compose.hpp>
#include <nearfield/field/program.hpp>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <functional>

#include "property/conversion.hpp"
#include "reference/potential_curves.hpp"
#include "reference/random.hpp"
#include "reference/soft_blends.hpp"
#include "reference/spline_curves.hpp"

namespace nearfield {
namespace {

using property::real;
using property::rounded;
using reference::announced_seed;
using reference::Random;
using reference::Real;
using reference::Vec3;

// A curve whose type does not matter, so that its table is compiled once.
using AnyCurve = std::function<Differentiable(const Differentiable&)>;

struct Row {
  const char* name;
  AnyCurve curve;  // over [0, 1] of its range
  reference::PotentialFunction exact;
  double to = 1;
};

template <class Curve>
Row row(const char* name, const Curve& curve, reference::PotentialFunction exact) {
  return {name, [over = over_range(curve)](const Differentiable& u) { return over(u); }, std::move(exact),
          curve.facts().to};
}

std::vector<Row> rows() {
  using reference::ArctangentCurve;
  const reference::BezierCurve bezier({1, 1, 1, 0, 0, 0});
  potential::Bezier bezier5;
  bezier5.degree = 5;
  for (int i = 0; i < 3; ++i) bezier5.b[i] = 1;
  return {
      row("cubic", potential::Cubic{}, reference::CubicCurve{}),
      row("wyvill", potential::wyvill, reference::WyvillCurve{}),
      row("bezier", bezier5, bezier),
      row("blanc", potential::Blanc{1.0}, reference::BlancCurve(1)),
      row("arctangent_clamped", potential::ArctangentClamped{20.0, 0.5}, ArctangentCurve::clamped(20, 0.5L)),
      row("range control, narrow", potential::with_range_control(potential::wyvill, 0.5, 0.25),
          reference::RemappedCurve<reference::WyvillCurve>({0.5L, 0.25L}, {})),
      row("range control, wide", potential::with_range_control(potential::Cubic{}, 2.0, 0.75),
          reference::RemappedCurve<reference::CubicCurve>({2, 0.75L}, {}))};
}

template <class S>
Table<S, 128> table_of(const Row& row) {
  return bake<S, 128>(row.curve, true);
}

template <class S>
class PotentialOfScalar : public testing::Test {};
using Scalars = testing::Types<Fixed<27>, Fixed<16>, float>;
TYPED_TEST_SUITE(PotentialOfScalar, Scalars, );

template <class S>
Certificate<S> exact_operand() {
  Certificate<S> certificate;
  certificate.valid = true;
  certificate.lipschitz = kUnitRate;
  return certificate;
}

// Value within the certificate's error of the formula, gradient within that of the table's slope.
template <class S, Kind of>
void expect_formula(Random& random, const Row& row) {
  const Table<S, 128> table = table_of<S>(row);
  Real greatest_share = 0;
  for (int i = 0; i < 300; ++i) {
    const Real influence = of == Kind::distance ? random.uniform(0.1L, 1.2L) : 1;
    const S limit = rounded<S>(influence * static_cast<Real>(row.to));
    const S weight = rounded<S>(random.uniform(-2, 2));
    const Certificate<S> operand = exact_operand<S>();
    const PotentialOf<S, of> potential(limit, weight, operand);
    const Certificate<S> certificate = potential.certificate(&operand, table.facts, domain_reach<S>());
    ASSERT_TRUE(certificate.valid) << row.name;
    Sample<S> x;
    x.value = rounded<S>(random.uniform(-0.2L, 1.2L) * real(limit));
    x.gradient = rounded<S>(random.unit_vector() * random.uniform(0, 1));
    const Real exact_limit = real(limit), r = real(x.value) / exact_limit * static_cast<Real>(row.to);
    const reference::ManyBlendPoint exact = reference::sum_of_potentials({{real(weight), row.exact, r}});
    const Sample<S> found = potential.combine(x, table.view());
    EXPECT_EQ(real(found.value), real(potential.combine(Value<S>{x.value}, table.view()).value));
    const Real off = std::fabs(real(found.value) - exact.value);
    greatest_share = std::max(greatest_share, off / real(certificate.error));
    ASSERT_LE(off, real(certificate.error)) << row.name << " at " << static_cast<double>(r);
    if (x.value == S{} || std::fabs(r - static_cast<Real>(row.to)) < 1e-6L) continue;
    const Real rate =
        r < 0 ? 0
              : exact.partials[0] * static_cast<Real>(row.to) / exact_limit / (of == Kind::distance ? 16 : 1);
    const Real unit = real(ScalarTraits<S>::rounding_unit(ScalarTraits<S>::one()));
    const Real factor = real(potential.gradient_factor);
    // The table's slope; roundings of slope and factor, times the other and the weight.
    const Real slope_error = std::ldexp(static_cast<Real>(table.facts.slope_error), -24);
    const Real slope = std::fabs(exact.partials[0]) * static_cast<Real>(row.to);
    const Real tolerance =
        std::fabs(real(weight)) * factor * slope_error + unit * (3 + 3 * factor + 3 * slope / 2);
    ASSERT_LE(reference::norm(real(found.gradient) - rate * real(x.gradient)), tolerance)
        << row.name << " at " << static_cast<double>(r) << " of " << static_cast<double>(exact_limit);
  }
  // Kinks are within a segment, whose bound is loose.
  EXPECT_GT(greatest_share, table.facts.error > (1 << 14) ? 1e-4L : 0.005L) << row.name;
}

TYPED_TEST(PotentialOfScalar, IsTheFormulaOfADistance) {
  Random random(announced_seed("IsTheFormulaOfADistance", 501));
  for (const Row& each : rows()) expect_formula<TypeParam, Kind::distance>(random, each);
}
TYPED_TEST(PotentialOfScalar, IsTheFormulaOfARay) {
  Random random(announced_seed("IsTheFormulaOfARay", 502));
  for (const Row& each : rows()) expect_formula<TypeParam, Kind::ray>(random, each);
}

TYPED_TEST(PotentialOfScalar, EndsAreExact) {
  using S = TypeParam;
  static constexpr auto table = bake<S, 8>(over_range(potential::Cubic{}));
  const S half = ScalarTraits<S>::half(ScalarTraits<S>::one()), one = ScalarTraits<S>::one();
  const PotentialOfDistance<S> potential(half, one, kUnitRate, S{});
  const auto at = [&](S value) {
    Sample<S> x;
    x.value = value;
    x.gradient.x = one;
    return potential.combine(x, table.view());
  };
  for (const S value : {half, one, ScalarTraits<S>::greatest()}) {
    EXPECT_TRUE(at(value).value == S{});
    EXPECT_TRUE(is_zero(at(value).gradient));
  }
  for (const S value : {S{}, -half, ScalarTraits<S>::least()}) {
    EXPECT_NEAR(static_cast<double>(real(at(value).value)), 1, 1e-5);
    EXPECT_TRUE(at(value).value == at(S{}).value);
    EXPECT_TRUE(is_zero(at(value).gradient));
  }
  EXPECT_LT(at(ScalarTraits<S>::half(half)).gradient.x, S{});
}

// The parts of a field with its own reference: a ball and a segment, one group, another ball beside it.
template <class S>
struct Scene {
  Vector3<S> a, b, c, d;
  S group_radius, group_weight, ball_radius, ball_weight;

  explicit Scene(Random& random)
      : a(point(random)),
        b(point(random)),
        c(point(random)),
        d(point(random)),
        group_radius(rounded<S>(random.uniform(0.3L, 1))),
        group_weight(rounded<S>(random.uniform(0.5L, 1.5L))),
        ball_radius(rounded<S>(random.uniform(0.3L, 1))),
        ball_weight(rounded<S>(random.uniform(-1, 1))) {}
  static Vector3<S> point(Random& random) { return rounded<S>(random.vector(-0.5L, 0.5L)); }
  Capsule<S> member() const { return {a, b, S{}}; }
  Capsule<S> other() const { return {c, c, S{}}; }
};

Real segment_distance(const reference::Segment& s, const Vec3& p) {
  const Vec3 along = s.b - s.a;
  const Real squared = reference::dot(along, along);
  const Real place = squared > 0 ? std::clamp(reference::dot(p - s.a, along) / squared, Real{0}, Real{1}) : 0;
  return reference::norm(p - (s.a + place * along));
}

TYPED_TEST(PotentialOfScalar, CertificatesHold) {
  using S = TypeParam;
  static constexpr auto over_r = bake<S, 32>(over_range(potential::Cubic{}));
  static constexpr auto over_u = bake<S, 2>(over_square(potential::wyvill));
  Random random(announced_seed("CertificatesHold", 503));
  const reference::CubicCurve cubic;
  const reference::WyvillCurve wyvill;
  Real greatest_error = 0, greatest_rate = 0;
  for (int i = 0; i < 60; ++i) {
    const Scene<S> scene(random);
    const auto group = combine(SharpUnion<S>{}, scene.member(), scene.other());
    const PotentialOfDistance<S> potential(scene.group_radius, scene.group_weight,
                                           field(group).certificate());
    const SoftPoint<S> ball{scene.d, Influence<S>(scene.ball_radius, scene.ball_weight)};
    const auto whole = field(soft_sum(combine(potential, over_r, group), with_potential(ball, over_u)));
    ASSERT_TRUE(whole.valid());
    // KW's group: one skeleton, whose distance is the least of its members'.
    const auto exact = [&](const Vec3& p) {
      const Real nearest = std::min(segment_distance(property::stored_segment(scene.member()), p),
                                    reference::norm(p - real(scene.c)));
      return real(scene.group_weight) * cubic(nearest / real(scene.group_radius)).value +
             real(scene.ball_weight) *
                 wyvill(reference::norm(p - real(scene.d)) / real(scene.ball_radius)).value;
    };
    const Real rate = real(whole.certificate().lipschitz) * 16;
    for (int k = 0; k < 60; ++k) {
      const Vector3<S> p = rounded<S>(random.vector(-1, 1));
      const Real value = exact(real(p));
      const Real off = std::fabs(real(whole.template evaluate<Value<S>>(p, nullptr).value) - value);
      ASSERT_LE(off, real(whole.certificate().error));
      greatest_error = std::max(greatest_error, off / real(whole.certificate().error));
      const Real apart = std::pow(Real{10}, random.uniform(-4, -1));
      const Real change = std::fabs(exact(real(p) + apart * random.unit_vector()) - value) / apart;
      ASSERT_LE(change, rate);
      greatest_rate = std::max(greatest_rate, change / rate);
    }
  }
  std::printf("%s: greatest error %.3Lf of the certified, greatest rate %.3Lf\n",
              property::ScalarName<S>::text().c_str(), greatest_error, greatest_rate);
  EXPECT_GT(greatest_error,
            ScalarTraits<S>::is_fixed ? 0.02L : 1e-4L);  // float's is of points at its domain's end
  EXPECT_GT(greatest_rate, 0.2L);
}

TYPED_TEST(PotentialOfScalar, CertificatesRefuse) {
  using S = TypeParam;
  static constexpr auto table = bake<S, 8>(over_range(potential::Cubic{}));
  const S one = ScalarTraits<S>::one(), limit = ScalarTraits<S>::domain(),
          unit = ScalarTraits<S>::rounding_unit(one);
  Certificate<S> operand = exact_operand<S>();
  operand.error = unit;
  TableFacts facts = table.facts;
  const auto valid = [&](const PotentialOfDistance<S>& potential) {
    return potential.certificate(&operand, facts, domain_reach<S>()).valid;
  };
  const PotentialOfDistance<S> good(one, one, operand);
  EXPECT_TRUE(valid(good));
  EXPECT_TRUE(valid(PotentialOfDistance<S>(limit, limit, operand)));
  EXPECT_TRUE(valid(PotentialOfDistance<S>(one, -limit, kNoRateBound, ScalarTraits<S>::greatest())));
  EXPECT_FALSE(valid(PotentialOfDistance<S>(one, one, kUnitRate, S{})));  // claims less error than there is
  EXPECT_FALSE(valid(PotentialOfDistance<S>(one, one, Rate::from_raw(kUnitRate.raw() - 1), unit)));
  EXPECT_FALSE(valid(PotentialOfDistance<S>(limit + ScalarTraits<S>::rounding_unit(limit), one, operand)));
  EXPECT_FALSE(valid(PotentialOfDistance<S>(S{}, one, operand)));
  EXPECT_FALSE(valid(PotentialOfDistance<S>(-one, one, operand)));
  EXPECT_FALSE(valid(PotentialOfDistance<S>(one, limit + limit, operand)));
  PotentialOfDistance<S> bad = good;
  bad.gradient_factor = ScalarTraits<S>::half(bad.gradient_factor);
  EXPECT_FALSE(valid(bad));
  bad = good;
  bad.scale.inverse = bad.scale.inverse / 2;
  EXPECT_FALSE(valid(bad));
  facts.error = greatest_of<int32_t>;  // what bake() says of functions that a table cannot hold
  EXPECT_FALSE(valid(good));
  facts = table.facts;
  operand.valid = false;
  EXPECT_FALSE(valid(good));
}

TYPED_TEST(PotentialOfScalar, ImagesCheckKindsAndClaims) {
  using S = TypeParam;
  static constexpr auto table = bake<S, 8>(over_range(potential::Cubic{}));
  const S one = ScalarTraits<S>::one(), half = ScalarTraits<S>::half(one);
  const Sphere<S> ball{{}, half};
  const auto status = [&](const auto& shape, const auto& potential) {
    ImageBuilder<S, 200> builder;
    const uint32_t reference = builder.table(table);
    builder.operation(shape).operation(potential, reference);
    return builder.finish().status;
  };
  const PotentialOfDistance<S> good(one, one, field(ball).certificate());
  EXPECT_EQ(status(ball, good), LoadStatus::ok);
  EXPECT_EQ(status(ball, PotentialOfRay<S>(one, one, field(ball).certificate())), LoadStatus::kind_mismatch);
  EXPECT_EQ(status(ball, PotentialOfDistance<S>(one, one, kUnitRate, S{})),
            LoadStatus::parameter_out_of_range);
}

}  // namespace
}  // namespace nearfield
