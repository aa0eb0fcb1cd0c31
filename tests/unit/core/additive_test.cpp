/// Additive blends against the papers' own formulas: value, both partial derivatives, edges, facts of the kernels.

#include <nearfield/blend/additive.hpp>
#include <nearfield/blend/log_sum_exp.hpp>
#include <nearfield/curve/curves.hpp>
#include <nearfield/curve/kernel.hpp>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <numeric>

#include "property/conversion.hpp"
#include "reference/additive_blends.hpp"
#include "reference/random.hpp"
#include "reference/step_curves.hpp"

namespace nearfield {
namespace {

using property::real;
using reference::announced_seed;
using reference::BlendPoint;
using reference::Random;
using reference::Real;

/// A kernel whose type does not matter, so that it is compiled once.
struct AnyKernel {
  std::function<Differentiable(const Differentiable&)> h;
  double range = 1.0;
  Differentiable operator()(const Differentiable& u) const { return h(u); }
};
double argument_range(const AnyKernel& kernel) {
  return kernel.range;
}
template <class Kernel>
AnyKernel any(const Kernel& kernel) {
  return {[kernel](const Differentiable& u) { return kernel(u); }, argument_range(kernel)};
}

/// A kernel and the smooth maximum that it stands for, of a length, x and y.
struct Row {
  std::string name;
  AnyKernel kernel;
  Sides sides = Sides::alike;
  std::function<BlendPoint(Real, Real, Real)> maximum;
  int continuous_derivatives = 1;
};

template <class Step>
void add_li(std::vector<Row>& rows, const std::string& name, const Step& step, const reference::StepWithSlope& exact,
            int continuous_derivatives) {
  const bool alike = curve_facts(step).antisymmetric;
  for (const double ratio : {0.1, 0.25, 1.0, 4.0}) {
    const auto kernel = exterior(step, ratio);
    const auto maximum = [exact, ratio](Real delta, Real x, Real y) {
      return reference::exterior_maximum_point(exact, delta, static_cast<Real>(ratio) * delta, x, y);
    };
    const std::string full = "exterior " + name + " " + std::to_string(ratio);
    if (alike) rows.push_back({full, any(kernel), Sides::alike, maximum, continuous_derivatives});
    rows.push_back({full + " two-sided", any(two_sided(kernel)), Sides::differ, maximum, continuous_derivatives});
  }
  const auto kernel = interior(step);
  const auto maximum = [exact](Real epsilon, Real x, Real y) {
    return reference::interior_maximum_point(exact, epsilon, x, y);
  };
  if (alike) rows.push_back({"interior " + name, any(kernel), Sides::alike, maximum, continuous_derivatives});
  rows.push_back({"interior " + name + " two-sided", any(two_sided(kernel)), Sides::differ, maximum,
                  continuous_derivatives});
}

const std::vector<Row>& all_rows() {
  static const std::vector<Row> rows = [] {
    using reference::step_with_slope;
    std::vector<Row> list;
    add_li(list, "H_1", step::polynomial<1>, step_with_slope(reference::PolynomialStepCurve(1)), 0);
    add_li(list, "H_2", step::polynomial<2>, step_with_slope(reference::PolynomialStepCurve(2)), 1);
    add_li(list, "H_3", step::polynomial<3>, step_with_slope(reference::PolynomialStepCurve(3)), 2);
    add_li(list, "H_5", step::polynomial<5>, step_with_slope(reference::PolynomialStepCurve(5)), 2);
    add_li(list, "R_2", step::RisingCutoff{2}, step_with_slope(reference::RisingCutoffCurve(2)), 1);
    add_li(list, "R_3", step::RisingCutoff{3}, step_with_slope(reference::RisingCutoffCurve(3)), 2);
    add_li(list, "R_2^2", step::RisingCutoffSquared{2}, step_with_slope(reference::RisingCutoffSquaredCurve(2)), 2);
    list.push_back({"log-sum-exp", any(LogSumExpKernel{}), Sides::alike,
                    [](Real range, Real x, Real y) {
                      return reference::log_sum_exp_point(18 / range, x, y);
                    },
                    2});
    const auto maximum_of = [](auto minimum) {
      return [minimum](Real k, Real x, Real y) {
        const BlendPoint point = minimum(k, -x, -y);
        return BlendPoint{-point.value, point.by_x, point.by_y};
      };
    };
    list.push_back({"quadratic", any(QuadraticKernel{}), Sides::alike, maximum_of(reference::quadratic_minimum_point), 1});
    list.push_back({"cubic", any(CubicKernel{}), Sides::alike, maximum_of(reference::cubic_minimum_point), 2});
    return list;
  }();
  return rows;
}

/// Value and partial derivatives of a blend of S, by operands whose gradients are the axes.
template <class S, class Blend, class View>
BlendPoint combined(const Blend& blend, const View& view, S x, S y) {
  const S one = ScalarTraits<S>::one();
  const Sample<S> a{x, {one, {}, {}}}, b{y, {{}, one, {}}};
  const Sample<S> out = blend.combine(a, b, view);
  EXPECT_TRUE(out.value == blend.combine(Value<S>{x}, Value<S>{y}, view).value);
  return {real(out.value), real(out.gradient.x), real(out.gradient.y)};
}

template <class S, SetOperation operation, int segments>
BlendPoint blended(Sides sides, S length, const Table<S, segments>& table, S x, S y) {
  if (sides == Sides::alike) return combined<S>(Additive<S, operation>{ArgumentScale<S>::of(length)}, table.view(), x, y);
  return combined<S>(Additive<S, operation, Sides::differ>{ArgumentScale<S>::of(length)}, table.view(), x, y);
}

struct Worst {
  Real value = 0, slope = 0;  // shares of what is stated
};

template <class S>
class Trial {
 public:
  Trial(const Row& row, Random& random) : row_(row), random_(random), table_(bake<S, 64>(row.kernel)) {}

  Worst run() {
    EXPECT_LT(table_.facts.error, 1 << 24) << row_.name;
    for (int i = 0; i < 6; ++i) {
      range_ = property::rounded<S>(random_.uniform(0.02L, 1.0L));
      for (int k = 0; k < 120; ++k) judge_pair();
    }
    return worst_;
  }

 private:
  void judge_pair() {
    const Real range = real(range_);
    const S x = property::rounded<S>(random_.uniform(-1, 1));
    const Real apart = random_.chance(0.2L) ? (random_.chance(0.5L) ? 0 : range) + random_.uniform(-1e-3L, 1e-3L) * range
                                            : random_.uniform(-1.2L, 1.2L) * range;
    const S y = property::rounded<S>(real(x) + (random_.chance(0.5L) ? apart : -apart));
    const auto maximum = [&](Real a, Real b) {
      return row_.maximum(range / static_cast<Real>(row_.kernel.range), a, b);
    };
    judge(blended<S, SetOperation::unite>(row_.sides, range_, table_, x, y),
          reference::union_point(maximum, real(x), real(y)), "union", x, y);
    judge(blended<S, SetOperation::intersect>(row_.sides, range_, table_, x, y),
          reference::intersection_point(maximum, real(x), real(y)), "intersection", x, y);
    judge(blended<S, SetOperation::subtract>(row_.sides, range_, table_, x, y),
          reference::subtraction_point(maximum, real(x), real(y)), "subtraction", x, y);
  }
  void judge(const BlendPoint& found, const BlendPoint& exact, const char* operation, S x, S y) {
    const Real unit = real(ScalarTraits<S>::rounding_unit(ScalarTraits<S>::one() + ScalarTraits<S>::one()));
    const Real value = real(range_) * std::ldexp(static_cast<Real>(table_.facts.error), -30) + 2 * unit;
    const Real halves = row_.sides == Sides::alike ? 1 : 2;
    // The product with a gradient is rounded to so many units (detail::scaled_by_slope).
    const Real product = fraction_bits_of<S> >= 24 ? std::ldexp(Real{4}, table_.slope_headroom) : 1;
    const Real slope = std::ldexp(static_cast<Real>(table_.facts.slope_error), -24) / halves + (product + 1) * unit;
    const auto where = [&] {
      return row_.name + " " + operation + " of " + std::to_string(static_cast<double>(real(x))) + ", " +
             std::to_string(static_cast<double>(real(y))) + ", range " + std::to_string(static_cast<double>(real(range_)));
    };
    ASSERT_LE(std::fabs(found.value - exact.value), value) << where();
    worst_.value = std::max(worst_.value, std::fabs(found.value - exact.value) / value);
    // At the tie itself sharp edges have no derivative.
    if (row_.continuous_derivatives == 0 || x == y) return;
    ASSERT_LE(std::fabs(found.by_x - exact.by_x), slope) << where() << ": by the first operand";
    ASSERT_LE(std::fabs(found.by_y - exact.by_y), slope) << where() << ": by the second operand";
    worst_.slope = std::max(worst_.slope, std::fabs(found.by_x - exact.by_x) / slope);
  }

  const Row& row_;
  Random& random_;
  Table<S, 64> table_;
  S range_{};
  Worst worst_;
};

template <class S>
void expect_papers_formulas(const char* test, std::uint64_t seed) {
  Random random(announced_seed(test, seed));
  Worst worst;
  for (const Row& row : all_rows()) {
    const Worst of_row = Trial<S>(row, random).run();
    worst.value = std::max(worst.value, of_row.value);
    worst.slope = std::max(worst.slope, of_row.slope);
  }
  std::printf("greatest share of the stated error: value %.3f, partial derivatives %.3f\n",
              static_cast<double>(worst.value), static_cast<double>(worst.slope));
}

TEST(AdditiveBlends, EqualThePapersFormulasInFixed27) {
  expect_papers_formulas<Fixed<27>>("AdditiveBlendsFixed27", 401);
}
TEST(AdditiveBlends, EqualThePapersFormulasInFixed24) {
  expect_papers_formulas<Fixed<24>>("AdditiveBlendsFixed24", 402);
}
TEST(AdditiveBlends, EqualThePapersFormulasInFixed16) {
  expect_papers_formulas<Fixed<16>>("AdditiveBlendsFixed16", 403);
}
TEST(AdditiveBlends, EqualThePapersFormulasInFloat) {
  expect_papers_formulas<float>("AdditiveBlendsFloat", 404);
}

/// Partial derivative by the first operand, in the reference's place, of an intersection with y = 0.
template <int segments>
Real slope_at(const Row& row, const Table<Fixed<27>, segments>& table, Real x) {
  return blended<Fixed<27>, SetOperation::intersect>(row.sides, Fixed<27>(1.0), table, property::rounded<Fixed<27>>(x), Fixed<27>()).by_x;
}

TEST(AdditiveBlends, ValuesAndSlopesAreContinuousAcrossEveryEdge) {
  for (const Row& row : all_rows()) {
    const Table<Fixed<27>, 64> table = bake<Fixed<27>, 64>(row.kernel);
    const Real unit = std::ldexp(Real{1}, -27);
    for (const Real edge : {-1, 0, 1}) {
      const auto value_at = [&](Real x) {
        return blended<Fixed<27>, SetOperation::intersect>(row.sides, Fixed<27>(1.0), table, property::rounded<Fixed<27>>(x), Fixed<27>()).value;
      };
      EXPECT_LE(std::fabs(value_at(edge + unit) - value_at(edge - unit)), 5 * unit) << row.name << " at " << edge;
      if (row.continuous_derivatives < 1) continue;
      // Log-sum-exp ends where its slope is e^-18.
      const Real slack = row.name == "log-sum-exp" ? 2e-8L : 0;
      EXPECT_LE(std::fabs(slope_at(row, table, edge + unit) - slope_at(row, table, edge - unit)), 16 * unit + slack)
          << row.name << " at " << edge;
    }
  }
}

// With a step of 1/256 the second difference of the slope is d times the jump of the second derivative, and d^2 times the
// third derivative where there is none.
TEST(AdditiveBlends, SecondDerivativesAreContinuousFromH3On) {
  constexpr Real d = 1 / Real{256};
  for (const Row& row : all_rows()) {
    const Table<Fixed<27>, 256> table = bake<Fixed<27>, 256>(row.kernel);
    for (const Real edge : {-1, 0, 1}) {
      const auto jump = [&](Real step) {
        return std::fabs(slope_at(row, table, edge + step) - 2 * slope_at(row, table, edge) + slope_at(row, table, edge - step)) /
               step;
      };
      const Real ratio = jump(d) / std::max(jump(2 * d), Real{1e-6L});
      if (row.continuous_derivatives >= 2) {
        EXPECT_TRUE(ratio < 0.75L || jump(d) < 2e-2L) << row.name << " at " << edge << ": " << jump(d) << ", " << jump(2 * d);
      }
    }
  }
  const auto jump_of = [](const char* name, Real edge) {
    for (const Row& row : all_rows()) {
      if (row.name != name) continue;
      const Table<Fixed<27>, 256> table = bake<Fixed<27>, 256>(row.kernel);
      return std::fabs(slope_at(row, table, edge + d) - 2 * slope_at(row, table, edge) + slope_at(row, table, edge - d)) / d;
    }
    return Real{-1};
  };
  // The measure sees a jump where there is one.
  EXPECT_GT(jump_of("quadratic", 1), 0.4L);
  EXPECT_GT(jump_of("interior H_2", 1), 0.9L);
}

TEST(AdditiveBlends, TakeTheTieValuesOfThePapers) {
  using Q = Fixed<27>;
  const auto tie = [](const AnyKernel& kernel, double length) {
    const Table<Q, 64> table = bake<Q, 64>(kernel);
    const Q range(length * kernel.range);
    return blended<Q, SetOperation::intersect>(Sides::alike, range, table, Q(0.25), Q(0.25)).value - 0.25L;
  };
  // S_abs(0) / 2 = mu(delta / epsilon)^2 delta / 4.
  EXPECT_NEAR(static_cast<double>(tie(any(exterior(step::polynomial<3>, 0.25)), 0.4)), 0.4 / 4, 1e-7);
  EXPECT_NEAR(static_cast<double>(tie(any(exterior(step::polynomial<3>, 1.0)), 0.4)), 0.4 / 4, 1e-7);
  const double mu = step::polynomial<3>(Differentiable(0.25)).value;
  EXPECT_NEAR(static_cast<double>(tie(any(exterior(step::polynomial<3>, 4.0)), 0.1)), 0.1 * mu * mu / 4, 1e-7);
  EXPECT_NEAR(static_cast<double>(tie(any(interior(step::polynomial<3>)), 0.4)), 0.0, 1e-8);
  EXPECT_NEAR(static_cast<double>(tie(any(LogSumExpKernel{}), 0.9)), std::log(2.0) / 20.0, 1e-7);
  EXPECT_NEAR(static_cast<double>(tie(any(QuadraticKernel{}), 0.4)), 0.1, 1e-8);
  EXPECT_NEAR(static_cast<double>(tie(any(CubicKernel{}), 0.6)), 0.1, 1e-8);
}

// The union's solid: where the blend is below the sharp minimum it is larger.
TEST(AdditiveBlends, StatedInflationAndErosionAreReached) {
  using Q = Fixed<27>;
  Certificate<Q> exact;
  exact.valid = true;
  exact.lipschitz = kUnitRate;
  const Certificate<Q> operands[2] = {exact, exact};
  for (const Row& row : all_rows()) {
    const Table<Q, 64> table = bake<Q, 64>(row.kernel);
    const Additive<Q, SetOperation::unite> alike{ArgumentScale<Q>::of(Q(1.0))};
    const Additive<Q, SetOperation::unite, Sides::differ> differ{ArgumentScale<Q>::of(Q(1.0))};
    const Certificate<Q> certificate = row.sides == Sides::alike
                                           ? alike.certificate(operands, table.facts, domain_reach<Q>())
                                           : differ.certificate(operands, table.facts, domain_reach<Q>());
    Real inflation = 0, erosion = 0, spread = 1;
    for (int i = -4096; i <= 4096; ++i) {
      const Q x(i / 4096.0);
      const BlendPoint point = blended<Q, SetOperation::unite>(row.sides, Q(1.0), table, x, Q());
      const Real sharp = std::min(real(x), Real{0});
      inflation = std::max(inflation, sharp - point.value);
      erosion = std::max(erosion, point.value - sharp);
      spread = std::max(spread, std::fabs(point.by_x) + std::fabs(point.by_y));
    }
    const Real few = 1e-6L;
    EXPECT_LE(inflation, real(certificate.inflation)) << row.name;
    EXPECT_LE(erosion, real(certificate.erosion)) << row.name;
    EXPECT_LE(spread, real(certificate.lipschitz)) << row.name;
    EXPECT_GE(inflation, 0.99L * real(certificate.inflation) - few) << row.name;
    EXPECT_GE(erosion, 0.99L * real(certificate.erosion) - few) << row.name;
    EXPECT_GE(spread, 1 + 0.95L * (real(certificate.lipschitz) - 1) - 1e-4L) << row.name;
    if (row.name.find("interior") == 0) {
      EXPECT_LE(inflation, few) << row.name << ": contained in the union";
    }
    if (row.name.find("interior") != 0 && row.name.find("4.0") == std::string::npos &&
        row.name.find("R_") == std::string::npos) {
      EXPECT_LE(erosion, few) << row.name << ": contains the union";
    }
  }
}

TEST(AdditiveBlends, OneSidedTablesOfStepsThatAreNotAntisymmetricAreRefused) {
  const Table<Fixed<27>, 64> exterior_table = bake<Fixed<27>, 64>(exterior(step::RisingCutoff{2}, 0.25));
  const Table<Fixed<27>, 64> interior_table = bake<Fixed<27>, 64>(interior(step::RisingCutoff{2}));
  EXPECT_EQ(exterior_table.facts.error, greatest_of<int32_t>);
  EXPECT_EQ(interior_table.facts.error, greatest_of<int32_t>);
}

// Log-sum-exp of any number of operands.

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
    operands.push_back({property::rounded<S>(random.uniform(-spread, spread)), i < 3 ? axes[i] : Vector3<S>{}});
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
    const std::vector<Sample<S>> operands = random_operands<S>(random, count, random.uniform(0.001L, 1) * real(range));
    const Real p = 32 * std::log(Real{2}) / real(range);
    std::vector<Real> values;
    for (const Sample<S>& operand : operands) values.push_back(-real(operand.value));
    const reference::ManyBlendPoint exact = reference::log_sum_exp(p, values);
    const Sample<S> found = log_sum_exp_of<S, SetOperation::unite>(range, operands);
    const Real unit = real(ScalarTraits<S>::rounding_unit(range));
    const Real stated = std::ldexp(real(range), ScalarTraits<S>::is_fixed ? -27 : -24) + 2 * unit;
    ASSERT_LE(std::fabs(real(found.value) + exact.value), stated) << "of " << count << ", range " << real(range);
    worst = std::max(worst, std::fabs(real(found.value) + exact.value) / stated);
    const Real weights[3] = {real(found.gradient.x), real(found.gradient.y), real(found.gradient.z)};
    for (std::size_t i = 0; i < 3 && i < exact.partials.size(); ++i) {
      const Real error = std::fabs(weights[i] - exact.partials[i]);
      ASSERT_LE(error, 1e-6L + static_cast<Real>(count) * 3 * real(ScalarTraits<S>::rounding_unit(ScalarTraits<S>::one())));
      worst_weight = std::max(worst_weight, error);
    }
    const Real least = *std::max_element(values.begin(), values.end());
    EXPECT_LE(exact.value - least, std::log(static_cast<Real>(count)) / p + 1e-18L);
    EXPECT_LE(-real(found.value), least + std::log(static_cast<Real>(count)) / p + stated) << "within ln(n) / p";
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
TEST(LogSumExpOfAny, EqualsThePapersFormulaInFloat) {
  expect_log_sum_exp<float>("LogSumExpFloat", 413);
}

template <class S>
void expect_no_order(const char* test, std::uint64_t seed) {
  Random random(announced_seed(test, seed));
  for (int trial = 0; trial < 500; ++trial) {
    const int count = 2 + static_cast<int>(random.uniform(0, 16.99L));
    const S range = property::rounded<S>(random.uniform(0.05L, 2));
    std::vector<Sample<S>> operands = random_operands<S>(random, count, random.uniform(0.001L, 1) * real(range));
    const S value = log_sum_exp_of<S, SetOperation::unite>(range, operands).value;
    for (int k = 0; k < 5; ++k) {
      for (std::size_t i = operands.size(); i > 1; --i) {
        std::swap(operands[i - 1], operands[static_cast<std::size_t>(random.uniform(0, static_cast<Real>(i) - 0.01L))]);
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
  const std::vector<Sample<Q>> operands = {{Q(0.1), {Q(1.0), {}, {}}}, {Q(0.11), {{}, Q(1.0), {}}}, {Q(-0.08), {{}, {}, Q(1.0)}}};
  const auto log_sum = [p](std::vector<double> values) {
    double sum = 0;
    for (const double value : values) sum += std::exp(p * value);
    return std::log(sum) / p;
  };
  EXPECT_NEAR((log_sum_exp_of<Q, SetOperation::intersect>(range, operands).value.to_double()), log_sum({0.1, 0.11, -0.08}), 1e-8);
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
  EXPECT_NEAR(blend.certificate(operands, {}, domain_reach<Q>()).inflation.to_double(), 0.5 / 32 * std::log2(18.0), 0.5 / 32 * 0.09);
  blend.operands = 19;
  EXPECT_FALSE(blend.certificate(operands, {}, domain_reach<Q>()).valid);
  blend.operands = 2;
  ++blend.scale.inverse;
  EXPECT_FALSE(blend.certificate(operands, {}, domain_reach<Q>()).valid);
}

}  // namespace
}  // namespace nearfield
