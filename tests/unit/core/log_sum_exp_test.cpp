/// Log-sum-exp of any number of operands against the paper's formula.

#include <nearfield/blend/log_sum_exp.hpp>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <cstdio>
#include <vector>

#include "property/conversion.hpp"
#include "reference/additive_blends.hpp"
#include "reference/random.hpp"

namespace nearfield {
namespace {

using property::real;
using reference::announced_seed;
using reference::Random;
using reference::Real;

template <class S, SetOperation operation>
Sample<S> log_sum_exp_of(S range, const std::vector<Sample<S>>& operands) {
  LogSumExp<S, operation> blend;
  blend.scale = ArgumentScale<S>::of(range);
  blend.operands = static_cast<uint32_t>(operands.size());
  const Sample<S> out = blend.template combine_all<Sample<S>>(operands.data());
  std::vector<Value<S>> values;
  for (const Sample<S>& operand : operands) values.push_back({operand.value});
  EXPECT_TRUE(out.value == blend.template combine_all<Value<S>>(values.data()).value);
  return out;
}

// Three gradients along the axes; of more operands the others have none.
template <class S>
std::vector<Sample<S>> random_operands(Random& random, int count, Real spread) {
  std::vector<Sample<S>> operands;
  const S one = ScalarTraits<S>::one();
  const S zero{};
  const Vector3<S> axes[3] = {{one, zero, zero}, {zero, one, zero}, {zero, zero, one}};
  for (int i = 0; i < count; ++i) {
    operands.push_back(
        {property::rounded<S>(random.uniform(-spread, spread)), i < 3 ? axes[i] : Vector3<S>{}});
  }
  return operands;
}

template <class S>
void expect_log_sum_exp(const char* test, std::uint64_t seed) {
  Random random(announced_seed(test, seed));
  Real worst = 0, worst_weight = 0;
  for (int trial = 0; trial < 4000; ++trial) {
    const int count = 1 + static_cast<int>(random.uniform(0, 17.99L));
    const S range = property::rounded<S>(random.uniform(0.05L, 2));
    const std::vector<Sample<S>> operands =
        random_operands<S>(random, count, random.uniform(0.001L, 1) * real(range));
    const Real p = 32 * std::log(Real{2}) / real(range);
    std::vector<Real> values;
    for (const Sample<S>& operand : operands) values.push_back(-real(operand.value));
    const reference::ManyBlendPoint exact = reference::log_sum_exp(p, values);
    const Sample<S> found = log_sum_exp_of<S, SetOperation::unite>(range, operands);
    const Real unit = real(ScalarTraits<S>::rounding_unit(range));
    const Real stated = std::ldexp(real(range), ScalarTraits<S>::is_fixed ? -27 : -24) + 2 * unit;
    ASSERT_LE(std::fabs(real(found.value) + exact.value), stated)
        << "of " << count << ", range " << real(range);
    worst = std::max(worst, std::fabs(real(found.value) + exact.value) / stated);
    const Real weights[3] = {real(found.gradient.x), real(found.gradient.y), real(found.gradient.z)};
    for (std::size_t i = 0; i < 3 && i < exact.partials.size(); ++i) {
      const Real error = std::fabs(weights[i] - exact.partials[i]);
      ASSERT_LE(error, 1e-6L + static_cast<Real>(count) * 3 *
                                   real(ScalarTraits<S>::rounding_unit(ScalarTraits<S>::one())));
      worst_weight = std::max(worst_weight, error);
    }
    const Real least = *std::max_element(values.begin(), values.end());
    EXPECT_LE(exact.value - least, std::log(static_cast<Real>(count)) / p + 1e-18L);
    EXPECT_LE(-real(found.value), least + std::log(static_cast<Real>(count)) / p + stated)
        << "within ln(n) / p";
    EXPECT_GE(-real(found.value), least - stated);
  }
  std::printf("greatest share of the stated error %.3f, of a weight %.2e\n", static_cast<double>(worst),
              static_cast<double>(worst_weight));
}

TEST(LogSumExpOfAny, EqualsThePapersFormulaInFixed27) {
  expect_log_sum_exp<Fixed<27>>("LogSumExpFixed27", 411);
}
TEST(LogSumExpOfAny, EqualsThePapersFormulaInFixed16) {
  expect_log_sum_exp<Fixed<16>>("LogSumExpFixed16", 412);
}
TEST(LogSumExpOfAny, EqualsThePapersFormulaInFloat) { expect_log_sum_exp<float>("LogSumExpFloat", 413); }

template <class S>
void expect_no_order(const char* test, std::uint64_t seed) {
  Random random(announced_seed(test, seed));
  for (int trial = 0; trial < 500; ++trial) {
    const int count = 2 + static_cast<int>(random.uniform(0, 16.99L));
    const S range = property::rounded<S>(random.uniform(0.05L, 2));
    std::vector<Sample<S>> operands =
        random_operands<S>(random, count, random.uniform(0.001L, 1) * real(range));
    const S value = log_sum_exp_of<S, SetOperation::unite>(range, operands).value;
    for (int k = 0; k < 5; ++k) {
      for (std::size_t i = operands.size(); i > 1; --i) {
        std::swap(operands[i - 1],
                  operands[static_cast<std::size_t>(random.uniform(0, static_cast<Real>(i) - 0.01L))]);
      }
      ASSERT_TRUE(value == (log_sum_exp_of<S, SetOperation::unite>(range, operands).value)) << "of " << count;
    }
  }
}

TEST(LogSumExpOfAny, DoesNotDependOnTheOrderToTheBit) {
  expect_no_order<Fixed<27>>("LogSumExpOrderFixed27", 414);
  expect_no_order<float>("LogSumExpOrderFloat", 415);
}

TEST(LogSumExpOfAny, IntersectsAndSubtracts) {
  using Q = Fixed<27>;
  const Q range(0.5);
  const double p = 32.0 * std::log(2.0) / 0.5;
  const std::vector<Sample<Q>> operands = {
      {Q(0.1), {Q(1.0), {}, {}}}, {Q(0.11), {{}, Q(1.0), {}}}, {Q(-0.08), {{}, {}, Q(1.0)}}};
  const auto log_sum = [p](std::vector<double> values) {
    double sum = 0;
    for (const double value : values) sum += std::exp(p * value);
    return std::log(sum) / p;
  };
  EXPECT_NEAR((log_sum_exp_of<Q, SetOperation::intersect>(range, operands).value.to_double()),
              log_sum({0.1, 0.11, -0.08}), 1e-8);
  const Sample<Q> less = log_sum_exp_of<Q, SetOperation::subtract>(range, operands);
  EXPECT_NEAR(less.value.to_double(), log_sum({0.1, -0.11, 0.08}), 2e-8);
  EXPECT_GT(less.gradient.x.to_double(), 0.5);
  EXPECT_LT(less.gradient.z.to_double(), -0.2);
}

TEST(LogSumExpOfAny, RefusesTooManyOperandsAndABrokenScale) {
  using Q = Fixed<27>;
  Certificate<Q> exact;
  exact.valid = true;
  exact.lipschitz = kUnitRate;
  const Certificate<Q> operands[18] = {exact, exact, exact, exact, exact, exact, exact, exact, exact,
                                       exact, exact, exact, exact, exact, exact, exact, exact, exact};
  LogSumExpUnion<Q> blend{ArgumentScale<Q>::of(Q(0.5)), 18};
  EXPECT_TRUE(blend.certificate(operands, {}, domain_reach<Q>()).valid);
  EXPECT_NEAR(blend.certificate(operands, {}, domain_reach<Q>()).inflation.to_double(),
              0.5 / 32 * std::log2(18.0), 0.5 / 32 * 0.09);
  blend.operands = 19;
  EXPECT_FALSE(blend.certificate(operands, {}, domain_reach<Q>()).valid);
  blend.operands = 2;
  ++blend.scale.inverse;
  EXPECT_FALSE(blend.certificate(operands, {}, domain_reach<Q>()).valid);
}

}  // namespace
}  // namespace nearfield
