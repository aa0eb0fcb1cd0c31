/// Hsu's variable influential radius against his formulas, its limits and edges, and in fields.

#include <nearfield/curve/potential.hpp>
#include <nearfield/curve/tabulated_form.hpp>
#include <nearfield/field/builder.hpp>
#include <nearfield/field/compose.hpp>
#include <nearfield/field/program.hpp>
#include <nearfield/modify/influence.hpp>
#include <nearfield/query/soft_clearance.hpp>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "property/conversion.hpp"
#include "reference/potential_curves.hpp"
#include "reference/random.hpp"
#include "reference/soft_blends.hpp"

namespace nearfield {
namespace {

using property::real;
using property::rounded;
using reference::announced_seed;
using reference::BlendPoint;
using reference::Random;
using reference::Real;

template <class S>
class VariableInfluenceOf : public testing::Test {};
using Scalars = testing::Types<Fixed<27>, Fixed<24>, Fixed<16>, float>;
TYPED_TEST_SUITE(VariableInfluenceOf, Scalars, );

template <class S>
Real unit_of() {
  return ScalarTraits<S>::is_fixed ? real(ScalarTraits<S>::rounding_unit(ScalarTraits<S>::one()))
                                   : std::ldexp(Real{1}, -23);
}

// Operands whose gradients are the axes, so that the result's gradient shows both partial derivatives.
template <class S>
Sample<S> remapped(const VariableInfluence<S>& influence, S d, S f) {
  Sample<S> object, contour;
  object.value = d;
  object.gradient.x = ScalarTraits<S>::one();
  contour.value = f;
  contour.gradient.y = ScalarTraits<S>::one();
  return influence.combine(object, contour);
}

template <class S>
void expect_formula(const VariableInfluence<S>& influence, S d, S f) {
  const Real unit = unit_of<S>(), at_d = real(d), at_f = real(f);
  const Real exact_w2 = real(influence.w2);
  const BlendPoint exact = reference::variable_range_remap(at_d, at_f, exact_w2);
  const Sample<S> found = remapped(influence, d, f);
  const auto where = [&] {
    return ::testing::Message() << "d " << static_cast<double>(at_d) << " f " << static_cast<double>(at_f)
                                << " w2 " << static_cast<double>(exact_w2);
  };
  EXPECT_EQ(real(found.value), real(influence.combine(Value<S>{d}, Value<S>{f}).value));
  ASSERT_LE(std::fabs(real(found.value) - exact.value), 2 * unit) << where();
  ASSERT_EQ(real(found.gradient.z), 0);
  const Real width = 2 * at_d - at_f;
  if (!(width > 0)) return;
  const Real k = at_f / width, steep = std::fabs(at_d - 0.5L) / width;
  // Not at the kinks of T, and where no factor saturates.
  if (std::fabs(at_f - 1) < 4 * unit || std::fabs(2 * (0.5L - at_d) / exact_w2 - 1) < 16 * unit ||
      found.value <= S{} || exact.value <= 8 * unit || k > 12 || steep > 12 ||
      std::fabs(exact.by_x) > 15 || std::fabs(exact.by_y) > 15) {
    return;
  }
  const Real tolerance = unit * (4 + 4 * k + 4 * steep) * (2 + k) / std::min(width, Real{1});
  ASSERT_LE(std::fabs(real(found.gradient.x) - exact.by_x), tolerance) << where();
  ASSERT_LE(std::fabs(real(found.gradient.y) - exact.by_y), tolerance) << where();
}

TYPED_TEST(VariableInfluenceOf, IsTheFormula) {
  using S = TypeParam;
  Random random(announced_seed("IsTheFormula", 511));
  for (int i = 0; i < 20000; ++i) {
    const VariableInfluence<S> influence(rounded<S>(random.chance(0.2L) ? 1 : random.uniform(0.125L, 1)));
    const Real d = random.chance(0.6L)
                       ? random.uniform(0, 1.2L)
                       : 0.5L + random.uniform(-1, 1) * std::pow(Real{10}, random.uniform(-5, -1));
    const Real f = random.chance(0.3L)
                       ? 1 + random.uniform(-1, 1) * std::pow(Real{10}, random.uniform(-5, -1))
                       : random.uniform(0, 1.5L);
    expect_formula<S>(influence, rounded<S>(d), rounded<S>(f));
    if (this->HasFatalFailure()) return;
  }
}

TYPED_TEST(VariableInfluenceOf, EdgesAndLimits) {
  using S = TypeParam;
  const VariableInfluence<S> influence(ScalarTraits<S>::one());
  const auto value = [&](double d, double f) {
    return static_cast<double>(
        real(remapped(influence, rounded<S>(static_cast<Real>(d)), rounded<S>(static_cast<Real>(f))).value));
  };
  const double unit = 2 * static_cast<double>(unit_of<S>());
  EXPECT_EQ(value(0.75, 1.25), 1);  // beyond the contour
  EXPECT_EQ(value(0.75, 1.75), 1);  // which cuts the object: w1 <= 0 outside it
  EXPECT_EQ(value(0.25, 0.5), 0);   // w1 <= 0 inside it
  EXPECT_EQ(value(0.25, 1.5), 0);
  EXPECT_EQ(value(0, 0), 0);        // a common centre
  EXPECT_EQ(value(0.5, 0.5), 0.5);  // on the surface, whatever the contour
  EXPECT_EQ(value(0.5, 0.9375), 0.5);
  EXPECT_EQ(value(0.5, 1.5), 0.5);
  EXPECT_NEAR(value(0.75, 1), 1, unit);        // at the contour
  EXPECT_EQ(value(0.9375, 0), 0.5);            // the contour's centre: w1 without bound
  EXPECT_NEAR(value(0.75, 0.75), 0.75, unit);  // f = d: w1 = 1, T is d
  EXPECT_NEAR(value(0.3125, 0.3125), 0.3125, unit);
  EXPECT_NEAR(value(0.25, 0.4375), 0, unit);     // w2 > 2 w1: Hsu's parabola falls below 0
  for (const double f : {0.0, 0.3, 0.8, 1.0}) {  // falling inwards and never below 0
    double before = 2;
    for (double d = 1.1; d >= 0; d -= 1.0 / 512) {
      const double here = value(d, f);
      EXPECT_GE(here, 0);
      EXPECT_LE(here, before + unit) << d << " " << f;
      before = here;
    }
  }
}

TYPED_TEST(VariableInfluenceOf, IsTotal) {
  using S = TypeParam;
  const S one = ScalarTraits<S>::one(), half = ScalarTraits<S>::half(one),
          unit = ScalarTraits<S>::rounding_unit(one);
  std::vector<S> values = {S{},
                           unit,
                           -unit,
                           half,
                           half - unit,
                           half + unit,
                           one,
                           one - unit,
                           one + unit,
                           ScalarTraits<S>::greatest(),
                           ScalarTraits<S>::least(),
                           -one};
  if constexpr (ScalarTraits<S>::is_fixed) {
    values.push_back(S::from_raw(greatest_of<int32_t>));
    values.push_back(S::from_raw(least_of<int32_t>));
    values.push_back(S::from_raw(1));
    values.push_back(S::from_raw(2));
  }
  for (const double w2 : {0.125, 0.3, 1.0}) {
    const VariableInfluence<S> influence(rounded<S>(static_cast<Real>(w2)));
    for (const S d : values) {
      for (const S f : values) {
        Sample<S> object, contour;
        object.value = d;
        contour.value = f;
        for (const S g : {ScalarTraits<S>::greatest(), ScalarTraits<S>::least()}) {
          object.gradient = {g, -g, one};
          contour.gradient = {g, g, one};
          const Sample<S> found = influence.combine(object, contour);
          EXPECT_TRUE(found.value >= S{} && found.value <= one)
              << real(d) << " " << real(f) << " " << real(found.value);
        }
      }
    }
  }
}

TYPED_TEST(VariableInfluenceOf, CertificateChecksParameters) {
  using S = TypeParam;
  Certificate<S> of[2];
  of[0].valid = of[1].valid = true;
  const auto valid = [&](const VariableInfluence<S>& influence) {
    return influence.certificate(of, TableFacts{}, domain_reach<S>()).valid;
  };
  EXPECT_TRUE(valid(VariableInfluence<S>(rounded<S>(1))));
  EXPECT_TRUE(valid(VariableInfluence<S>(rounded<S>(0.125L))));
  EXPECT_FALSE(valid(VariableInfluence<S>(rounded<S>(1.01L))));
  EXPECT_FALSE(valid(VariableInfluence<S>(rounded<S>(0.12L))));
  EXPECT_FALSE(valid(VariableInfluence<S>(S{})));
  EXPECT_FALSE(valid(VariableInfluence<S>{}));
  VariableInfluence<S> bad(rounded<S>(0.5L));
  bad.inverse_w2 = ScalarTraits<S>::one();
  EXPECT_FALSE(valid(bad));
  of[1].valid = false;
  EXPECT_FALSE(valid(VariableInfluence<S>(rounded<S>(1))));
}

template <class S>
class VariableInfluenceIn : public testing::Test {};
using ScalarsOfFields = testing::Types<Fixed<27>, float>;
TYPED_TEST_SUITE(VariableInfluenceIn, ScalarsOfFields, );

// An object and a contour of other shape with one centre: Hsu's figures, as a static field and as a program.
TYPED_TEST(VariableInfluenceIn, FieldsAreTheFormula) {
  using S = TypeParam;
  static constexpr auto table = bake<S, 8>(over_range(potential::Cubic{}));
  const S one = ScalarTraits<S>::one();
  const VariableInfluence<S> influence(one);
  const RayPoint<S> object{{}, RayRadius<S>(rounded<S>(0.5L))};
  const Capsule<S> axis(rounded<S>(reference::Vec3{-0.1L, 0, 0}), rounded<S>(reference::Vec3{0.1L, 0, 0}),
                        S{});
  const RaySegment<S> contour{axis, RayRadius<S>(rounded<S>(0.75L))};
  const auto remap = combine(influence, object, contour);
  const PotentialOfRay<S> potential(one, one, field(remap).certificate());
  const auto whole = field(combine(potential, table, remap));
  ASSERT_TRUE(whole.valid());
  EXPECT_EQ(whole.kind(), Kind::intensity);
  EXPECT_TRUE(whole.certificate().lipschitz == kNoRateBound);

  ImageBuilder<S, 200> builder;
  const uint32_t reference = builder.table(table);
  builder.operation(object).operation(contour).operation(influence).operation(potential, reference);
  ASSERT_EQ(builder.finish().status, LoadStatus::ok);
  const Program<S> program = load<S>(builder.words(), builder.size() * sizeof(uint32_t));

  Random random(announced_seed("FieldsAreTheFormula", 512));
  const reference::PotentialFunction cubic = reference::CubicCurve{};
  for (int i = 0; i < 500; ++i) {
    const Vector3<S> p = rounded<S>(random.vector(-1, 1));
    const reference::Vec3 at = real(p);
    const Real d = reference::norm(at) / 0.5L;
    const reference::Vec3 off = at - reference::Vec3{std::clamp(at.x, -0.1L, 0.1L), 0, 0};
    const Real exact = reference::variable_radius_intensity(cubic, d, reference::norm(off) / 0.75L, 1).value;
    const Sample<S> found = whole.template evaluate<Sample<S>>(p, nullptr);
    EXPECT_NEAR(static_cast<double>(real(found.value)), static_cast<double>(exact),
                200 * static_cast<double>(unit_of<S>()));
    const Sample<S> same = program.template evaluate<Sample<S>>(p, nullptr);
    EXPECT_TRUE(found.value == same.value && found.gradient == same.gradient);
  }
  // Nothing bounds its rate, so nothing is known of a ball.
  EXPECT_EQ(soft_clearance(whole, rounded<S>(reference::Vec3{1, 1, 1})).status, ClearanceStatus::invalid);
  EXPECT_EQ(soft_clearance(program, rounded<S>(reference::Vec3{1, 1, 1})).status, ClearanceStatus::invalid);
}

}  // namespace
}  // namespace nearfield
