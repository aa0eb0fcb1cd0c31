// Tables made by the compiler, against tables of the same curves made while the program runs: the same bits.
// No flag raises a compiler's limits on constant expressions here.
#include <curves/baked_curve.hpp>
#include <nearfield/curve/curves.hpp>
#include <nearfield/curve/tabulate.hpp>

#include <gtest/gtest.h>

#include <cmath>
#include <cstddef>
#include <cstdint>
#include <initializer_list>

namespace nearfield {
namespace {

using Q27 = Fixed<27>;

constexpr ParameterValues numbers(std::initializer_list<double> list) {
  ParameterValues values;
  for (const double number : list) values.values[values.count++] = number;
  return values;
}
constexpr ParameterValues kSplinePoints[] = {numbers({0, 0.25, 0.5, 0.75, 1}),
                                             numbers({1, 0.85, 0.5, 0.15, 0})};
constexpr ParameterValues kBezierPoints[] = {numbers({1, 1, 1, 0, 0, 0})};
constexpr ParameterValues kBsplinePoints[] = {numbers({3}), numbers({0.25, 0.5, 0.75}),
                                              numbers({1, 1, 0.9, 0.5, 0.1, 0, 0})};

constexpr step::Polynomial kCubicStep{3};
constexpr step::BSplineIntegral kIntegralStep{4};
constexpr step::RisingCutoffSquared kCutoff{2};
constexpr step::Logistic kLogistic{4};
constexpr potential::Wyvill kWyvill{};
constexpr potential::Arctangent kArctangent{5, 0.5};
constexpr potential::Blanc kBlanc{0.0};
constexpr auto kSpline = potential::NaturalSpline::from(kSplinePoints);
constexpr auto kBezier = potential::Bezier::from(kBezierPoints);
constexpr auto kBspline = potential::BSpline::from(kBsplinePoints);
constexpr potential::ParametricBezier kParametric{0.4};
constexpr auto kRange = potential::with_range_control(potential::Cubic{}, 0.5, 0.5);
constexpr auto kOwn = [](const Differentiable& x) { return 0.5 + 0.25 * x * x * x - 0.125 * sin(3.0 * x); };

bool same(float a, float b) { return bits_as<uint32_t>(a) == bits_as<uint32_t>(b); }
template <class Number>
bool same(const Number& a, const Number& b) {
  return a == b;
}

template <class S>
void expect_same_scales(const CurvePlacement<S>& a, const CurvePlacement<S>& b) {
  EXPECT_TRUE(same(a.scale.limit, b.scale.limit) && same(a.scale.inverse, b.scale.inverse));
  EXPECT_TRUE(same(a.square_scale.inverse, b.square_scale.inverse));
  if constexpr (ScalarTraits<S>::is_fixed) {
    EXPECT_EQ(a.scale.shift, b.scale.shift);
    EXPECT_EQ(a.square_scale.shift, b.square_scale.shift);
    EXPECT_EQ(a.square_scale.limit_square(), b.square_scale.limit_square());
  } else {
    EXPECT_TRUE(same(a.square_scale.limit_square, b.square_scale.limit_square));
  }
}

template <class S>
void expect_same_placement(const CurvePlacement<S>& a, const CurvePlacement<S>& b) {
  EXPECT_TRUE(same(a.from, b.from) && same(a.to, b.to) && same(a.start, b.start));
  EXPECT_TRUE(same(a.before, b.before) && same(a.after, b.after));
  EXPECT_EQ(a.mirrored, b.mirrored);
  EXPECT_EQ(a.squared, b.squared);
  EXPECT_TRUE(same(a.stretch, b.stretch) && same(a.slope_factor, b.slope_factor));
  expect_same_scales(a, b);
}

void expect_same_facts(const TableFacts& a, const TableFacts& b) {
  EXPECT_EQ(a.error, b.error);
  EXPECT_EQ(a.slope_error, b.slope_error);
  EXPECT_EQ(a.least_value, b.least_value);
  EXPECT_EQ(a.greatest_value, b.greatest_value);
  EXPECT_EQ(a.least_slope, b.least_slope);
  EXPECT_EQ(a.greatest_slope, b.greatest_slope);
}

// `table` is what the compiler made of `curve` for `request`.
template <class S, int segments, int degree, int bits, bool rising, int slope_fraction_bits, class Curve>
void expect_same_at_run_time(const CurveTable<S, segments, degree, bits, rising, slope_fraction_bits>& table,
                             const Curve& curve, const TableRequest& request) {
  const auto baked = host::bake_curve<S>(host::AnyCurve(curve), request);
  ASSERT_TRUE(baked.has_value());
  const TableShape& shape = baked->layout.shape;
  ASSERT_EQ(shape.segments, segments);
  ASSERT_EQ(shape.degree, degree);
  ASSERT_EQ(shape.bits, bits);
  EXPECT_EQ(baked->layout.rising, rising);
  EXPECT_EQ(baked->layout.scale.slope_headroom, table.table.slope_headroom);
  if (ScalarTraits<S>::is_fixed) {
    EXPECT_EQ(baked->layout.slope_fraction_bits, slope_fraction_bits);
  }
  const std::size_t count = static_cast<std::size_t>((degree + 1) * segments);
  ASSERT_EQ(bits == 16 ? baked->narrow.size() : baked->wide.size(), count);
  for (std::size_t i = 0; i < count; ++i) {
    if constexpr (bits == 16) {
      EXPECT_EQ(baked->narrow[i], table.table.coefficients[i]) << "coefficient " << i;
    } else {
      EXPECT_EQ(baked->wide[i], table.table.coefficients[i]) << "coefficient " << i;
    }
  }
  expect_same_facts(baked->table_facts, table.table.facts);
  expect_same_placement(baked->layout.placement, table.placement);
  EXPECT_EQ(baked->error, std::ldexp(static_cast<double>(table.error), -30));
  EXPECT_EQ(baked->slope_error, std::ldexp(static_cast<double>(table.slope_error), -24));
  EXPECT_GT(table.error, 0);
  if (request.log2_error > 0) {
    EXPECT_LE(baked->error, std::ldexp(1.0, -request.log2_error));
  }
}

// Every test has its table made in a constant expression, and uses it in one.
template <class S, const auto& curve, class Request>
void expect_the_same_table() {
  static constexpr auto table = tabulate<S, curve, Request>();
  static constexpr CurveFacts facts = curve_facts(curve);
  static_assert(
      table.sample(S(static_cast<S>(facts.from))).value == Unit<S>(static_cast<Unit<S>>(facts.before)), "");
  static_assert(table.sample(S(static_cast<S>(facts.to))).value == Unit<S>(static_cast<Unit<S>>(facts.after)),
                "");
  expect_same_at_run_time(table, curve, Request::value);
}

template <int log2_error, int bytes, int degree, int segments, int bits>
struct Detailed {
  static constexpr TableRequest value{log2_error, bytes, degree, segments, bits};
};

TEST(Tabulate, StepsAreTheSameAtRunTime) {
  expect_the_same_table<Q27, kCubicStep, Within<20>>();
  expect_the_same_table<Q27, kIntegralStep, Within<12>>();
  expect_the_same_table<Q27, kCutoff, Within<12>>();
  expect_the_same_table<Q27, kLogistic, Within<12>>();
}

TEST(Tabulate, PotentialsByFormulaAreTheSameAtRunTime) {
  expect_the_same_table<Q27, kWyvill, Within<20>>();
  expect_the_same_table<Q27, kArctangent, Within<14>>();
  expect_the_same_table<Q27, kBlanc, Within<12>>();
  expect_the_same_table<Q27, kRange, Within<20>>();
}

TEST(Tabulate, PotentialsByPointsAreTheSameAtRunTime) {
  expect_the_same_table<Q27, kSpline, Within<20>>();
  expect_the_same_table<Q27, kBezier, Within<12>>();
  expect_the_same_table<Q27, kBspline, Within<20>>();
  expect_the_same_table<Q27, kParametric, Within<12>>();
}

TEST(Tabulate, EveryScalarIsTheSameAtRunTime) {
  expect_the_same_table<Fixed<24>, kCutoff, Within<10>>();
  expect_the_same_table<Fixed<16>, kBlanc, Within<10>>();
  expect_the_same_table<float, kBezier, Within<10>>();
  expect_the_same_table<float, kWyvill, BestOf<64>>();
}

TEST(Tabulate, EveryRequestIsTheSameAtRunTime) {
  expect_the_same_table<Q27, kBezier, BestOf<128>>();
  expect_the_same_table<Q27, kBezier, Exactly<1, 8>>();
  expect_the_same_table<Q27, kBezier, Exactly<2, 8>>();
  expect_the_same_table<Q27, kBezier, Exactly<3, 7>>();
  expect_the_same_table<Q27, kBezier, Exactly<3, 8, 16>>();
  expect_the_same_table<Q27, kWyvill, Exactly<2, 6, 16>>();
  expect_the_same_table<Q27, kWyvill, Within<14, 1024, TableParameter::direct>>();
  expect_the_same_table<Q27, kWyvill, Within<14, 1024, TableParameter::squared>>();
  expect_the_same_table<Q27, kCutoff, Detailed<10, 256, 2, 0, 16>>();
}

TEST(Tabulate, RequestsAreKept) {
  constexpr auto exactly = tabulate<Q27, kBezier, Exactly<3, 7>>();
  EXPECT_EQ(exactly.table.segments, 7);
  constexpr auto direct = tabulate<Q27, kWyvill, Within<14, 1024, TableParameter::direct>>();
  EXPECT_FALSE(direct.placement.squared);
  constexpr auto squared = tabulate<Q27, kWyvill, Within<14, 1024, TableParameter::squared>>();
  EXPECT_TRUE(squared.placement.squared);
  constexpr auto small = tabulate<Q27, kBezier, BestOf<128>>();
  EXPECT_LE(sizeof(small.table.coefficients), 128U);
  constexpr auto short_words = tabulate<Q27, kBezier, Exactly<3, 8, 16>>();
  EXPECT_EQ(sizeof(short_words.table.coefficients), 64U);
}

// A callable of one's own needs nothing but its formula.
TEST(Tabulate, OwnLambdasAreCurves) {
  expect_the_same_table<Q27, kOwn, Within<14>>();
  constexpr auto table = tabulate<Q27, kOwn, Within<14>>();
  EXPECT_EQ(table.sample(Q27(-1.0)).value, table.placement.before);
  EXPECT_EQ(table.sample(Q27(2.0)).value, table.placement.after);
  for (int i = 1; i < 1000; ++i) {
    const double x = i * 1e-3;
    const auto here = table.sample(Q27(x));
    EXPECT_NEAR(here.value.to_double(), 0.5 + 0.25 * x * x * x - 0.125 * std::sin(3 * x),
                std::ldexp(1.0, -14));
    EXPECT_NEAR(here.slope.to_double(), 0.75 * x * x - 0.375 * std::cos(3 * x),
                std::ldexp(table.slope_error, -24) + 2e-8);
  }
}

}  // namespace
}  // namespace nearfield
