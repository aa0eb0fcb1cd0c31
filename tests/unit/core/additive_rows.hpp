#pragma once
/// Every additive blend of two operands, next to the long double formula of its paper, and what evaluates it.

#include <nearfield/blend/additive.hpp>
#include <nearfield/curve/kernel.hpp>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <string>
#include <vector>

#include "property/conversion.hpp"
#include "reference/additive_blends.hpp"
#include "reference/random.hpp"
#include "reference/step_curves.hpp"

namespace nearfield::additive_tests {

using property::real;
using reference::BlendPoint;
using reference::Random;
using reference::Real;

/// Kernels and steps whose types do not matter, so that what takes them is compiled once.
struct AnyKernel {
  std::function<Differentiable(const Differentiable&)> h;
  double range = 1.0;
  nearfield::detail::Breaks places;
  const nearfield::detail::Breaks& breaks() const { return places; }
  Differentiable operator()(const Differentiable& u) const { return h(u); }
};
inline double argument_range(const AnyKernel& kernel) { return kernel.range; }
template <class Kernel>
AnyKernel any(const Kernel& kernel) {
  return {[kernel](const Differentiable& u) { return kernel(u); }, argument_range(kernel),
          nearfield::detail::breaks_of(kernel, 0)};
}

struct AnyStep {
  std::function<Differentiable(const Differentiable&)> step;
  CurveFacts own_facts;
  Differentiable operator()(const Differentiable& t) const { return step(t); }
  const CurveFacts& facts() const { return own_facts; }
};

/// A step of the core and what it should be.
struct StepRow {
  std::string name;
  AnyStep step;
  reference::StepWithSlope exact;
  int continuous_derivatives = 0;
  std::vector<Real> knots;  ///< where its pieces meet, the ends of its range among them
  int degree = 0;           ///< of its pieces, if they are polynomials
  Real steepest = 0;        ///< greatest slope
};

/// How a blend came about; of Li's with the step's smoothness, which it inherits.
enum class Family { exterior, interior, log_sum_exp, quadratic, cubic };

/// A kernel and the smooth maximum that it stands for, of a length, x and y. Lengths are those of the
/// kernel's range over kernel.range.
struct Row {
  std::string name;
  Family family = Family::exterior;
  AnyKernel kernel;
  Sides sides = Sides::alike;
  std::function<BlendPoint(Real, Real, Real)> maximum;
  int continuous_derivatives = 1;
  std::vector<Real> edges;    ///< x - y where the formula's pieces meet, as fractions of the range, ascending
  bool cubic_pieces = false;  ///< between the edges h is a polynomial that tables hold exactly
  Real ratio = 0;             ///< epsilon / delta of the exterior blends
  Real jump = 0;       ///< of the value at edges, as a fraction of the range; of steps that only approximate
  std::string step;    ///< the step's name
  Real narrowest = 1;  ///< over what part of the range a step rises, if all of it were as steep as it gets

  BlendPoint at(Real range, Real x, Real y) const {
    return maximum(range / static_cast<Real>(kernel.range), x, y);
  }
};

namespace detail {

inline std::vector<Real> equal_pieces(int count) {
  std::vector<Real> knots;
  for (int i = 0; i <= count; ++i)
    knots.push_back(static_cast<Real>(2 * i - count) / static_cast<Real>(count));
  return knots;
}

template <class Step, class Exact>
StepRow step_row(const std::string& name, const Step& step, const Exact& exact, int continuous_derivatives,
                 const std::vector<Real>& knots = {-1, 1}, int degree = 0) {
  EXPECT_EQ(curve_problem(step), nullptr) << name;
  Real steepest = 0;
  for (int i = -128; i <= 128; ++i) steepest = std::max(steepest, exact(static_cast<Real>(i) / 128).first);
  return {name,
          {[step](const Differentiable& t) { return step(t); }, curve_facts(step)},
          reference::step_with_slope(exact),
          continuous_derivatives,
          knots,
          degree,
          steepest};
}

inline int at_most_two(int derivatives) { return std::min(derivatives, 2); }

/// theta_0 = (pi / 2) H_start.
struct PolynomialAngle {
  reference::PolynomialStepCurve step;
  reference::CurvePoint operator()(Real t) const {
    const reference::CurvePoint here = step(t);
    const Real scale = reference::pi / 2;
    return {scale * here.value, scale * here.first, scale * here.second};
  }
};

inline void add_edge(std::vector<Real>& edges, Real edge) {
  if (std::fabs(edge) > 1 + 1e-12L) return;
  for (const Real other : edges) {
    if (std::fabs(other - edge) < 1e-9L) return;
  }
  edges.push_back(edge);
}

/// Where g1 and g2, or the interior's step, have their knots; the tie, the parabola's vertices, the ends of
/// the range.
inline std::vector<Real> edges_of(const StepRow& step, Real delta, Real epsilon) {
  std::vector<Real> edges = {-1, 0, 1};
  for (const Real center : {delta, -delta}) {
    add_edge(edges, center);
    for (const Real knot : step.knots) add_edge(edges, center + epsilon * knot);
  }
  std::sort(edges.begin(), edges.end());
  return edges;
}

}  // namespace detail

/// Every step of curve/curves.hpp, and iterations with starts of one's own.
inline std::vector<StepRow> all_steps() {
  using detail::at_most_two;
  using detail::step_row;
  std::vector<StepRow> rows;
  rows.push_back(step_row("H_0", step::Heaviside{}, reference::HeavisideCurve{}, -1, {-1, 0, 1}, 0));
  for (const int n : {1, 2, 3, 4, 5, 8}) {
    rows.push_back(step_row("H_" + std::to_string(n), step::Polynomial{n}, reference::PolynomialStepCurve(n),
                            at_most_two(n - 1), detail::equal_pieces(n), n));
  }
  for (const int m : {1, 2, 3, 6, 8}) {
    rows.push_back(step_row("B_" + std::to_string(m), step::BSplineIntegral{m},
                            reference::BsplineStepCurve(m), at_most_two(m - 1), detail::equal_pieces(m), m));
  }
  for (const int n : {1, 2, 3, 4, 5}) {
    rows.push_back(step_row("R_" + std::to_string(n), step::RisingCutoff{n}, reference::RisingCutoffCurve(n),
                            at_most_two((1 << (n - 1)) - 1)));
    rows.push_back(step_row("R_" + std::to_string(n) + "^2", step::RisingCutoffSquared{n},
                            reference::RisingCutoffSquaredCurve(n), at_most_two((1 << n) - 1)));
  }
  for (const auto& [start, n] : {std::pair{1, 2}, {2, 1}, {2, 3}, {3, 2}, {4, 2}}) {
    const detail::PolynomialAngle angle{reference::PolynomialStepCurve(start)};
    const reference::IteratedRisingCutoffCurve<detail::PolynomialAngle> exact(n, angle);
    const std::string name = "cutoff from H_" + std::to_string(start) + " " + std::to_string(n);
    // At its ends it is smoother than its start, but not where the start's pieces meet.
    const int of_ends = start * (1 << (n - 1)) - 1,
              smoothness = start == 1 ? of_ends : std::min(start - 1, of_ends);
    rows.push_back(step_row(name, step::CutoffFromPolynomial{n, start}, exact, at_most_two(smoothness),
                            detail::equal_pieces(start)));
    step::IteratedCutoff<step::AngleOfStep<step::Polynomial>> square{{{start}}, n, true, start - 1};
    rows.push_back(step_row(
        name + ", squared", square,
        [exact](Real t) {
          return t > 1 ? reference::CurvePoint{1, 0, 0} : reference::squared(exact(t));
        },
        at_most_two(start == 1 ? 2 * of_ends + 1 : std::min(start - 1, 2 * of_ends + 1)),
        detail::equal_pieces(start)));
  }
  // They only approximate: 8 has tails that show, those of 16 are below 2^-23.
  for (const int alpha : {8, 16, 40, 100}) {
    rows.push_back(step_row("S_" + std::to_string(alpha), step::Logistic{static_cast<double>(alpha)},
                            reference::LogisticCurve(alpha), alpha < 16 ? -1 : 2));
  }
  return rows;
}

/// The exterior blend of a ratio epsilon / delta, and the interior blend, of one step.
inline Row exterior_row(const StepRow& step, double ratio, Sides sides) {
  const auto kernel = exterior(step.step, ratio);
  const Real epsilon = static_cast<Real>(ratio);
  Row row;
  row.name =
      "exterior " + step.name + " " + std::to_string(ratio) + (sides == Sides::alike ? "" : " two-sided");
  row.family = Family::exterior;
  row.kernel = sides == Sides::alike ? any(kernel) : any(two_sided(kernel));
  row.sides = sides;
  row.maximum = [exact = step.exact, epsilon](Real delta, Real x, Real y) {
    return reference::exterior_maximum_point(exact, delta, epsilon * delta, x, y);
  };
  // A step at delta, where the parabola touches 0, leaves one derivative continuous.
  row.continuous_derivatives = step.name == "H_0" ? 1 : step.continuous_derivatives;
  row.edges = detail::edges_of(step, 1 / (1 + epsilon), epsilon / (1 + epsilon));
  // For epsilon > delta both g1 and g2 rise around the tie.
  row.cubic_pieces = step.name == "H_0" || (step.degree == 1 && ratio <= 1);
  row.ratio = epsilon;
  row.jump = static_cast<Real>(step.step.facts().end_jump) * (1 + epsilon);
  row.step = step.name;
  row.narrowest = epsilon / (1 + epsilon) / std::max<Real>(step.steepest, 1);
  return row;
}
inline Row interior_row(const StepRow& step, Sides sides) {
  const auto kernel = interior(step.step);
  Row row;
  row.name = "interior " + step.name + (sides == Sides::alike ? "" : " two-sided");
  row.family = Family::interior;
  row.kernel = sides == Sides::alike ? any(kernel) : any(two_sided(kernel));
  row.sides = sides;
  row.maximum = [exact = step.exact](Real epsilon, Real x, Real y) {
    return reference::interior_maximum_point(exact, epsilon, x, y);
  };
  row.continuous_derivatives = std::max(step.continuous_derivatives, 0);
  row.edges = detail::edges_of(step, 0, 1);
  row.cubic_pieces = step.degree == 1 || step.degree == 2 || step.name == "H_0";
  row.jump = static_cast<Real>(step.step.facts().end_jump);
  row.step = step.name;
  row.narrowest = 1 / std::max<Real>(step.steepest, 1);
  return row;
}

/// All ratios that a scene allows: the least and the greatest, some of which a table's knots meet the edges,
/// and for each step one drawn at random.
inline const std::vector<Row>& all_rows() {
  static const std::vector<Row> rows = [] {
    Random random(reference::announced_seed("AdditiveRows", 400));
    std::vector<Row> list;
    for (const StepRow& step : all_steps()) {
      const bool alike = step.step.facts().antisymmetric;
      const Sides sides = alike ? Sides::alike : Sides::differ;
      std::vector<double> ratios = {0.25, 1.0, 4.0};
      ratios.push_back(static_cast<double>(std::exp(random.uniform(std::log(0.05L), std::log(4.0L)))));
      if (step.continuous_derivatives < 1) ratios.insert(ratios.end(), {1.0 / 3.0, 3.0});
      if (step.name == "H_1" || step.name == "H_3" || step.name == "R_2") ratios.push_back(0.05);
      for (const double ratio : ratios) list.push_back(exterior_row(step, ratio, sides));
      list.push_back(interior_row(step, sides));
      if (step.name == "H_3" || step.name == "H_1") {
        for (const double ratio : ratios) list.push_back(exterior_row(step, ratio, Sides::differ));
        list.push_back(interior_row(step, Sides::differ));
      }
    }
    const auto add = [&list](const char* name, Family family, const AnyKernel& kernel, const auto& maximum,
                             int continuous_derivatives) {
      Row row;
      row.name = name;
      row.family = family;
      row.kernel = kernel;
      row.maximum = maximum;
      row.continuous_derivatives = continuous_derivatives;
      row.edges = {-1, 0, 1};
      list.push_back(row);
    };
    add(
        "log-sum-exp", Family::log_sum_exp, any(LogSumExpKernel{}),
        [](Real range, Real x, Real y) { return reference::log_sum_exp_point(18 / range, x, y); }, 2);
    const auto maximum_of = [](auto minimum) {
      return [minimum](Real k, Real x, Real y) {
        const BlendPoint point = minimum(k, -x, -y);
        return BlendPoint{-point.value, point.by_x, point.by_y};
      };
    };
    add("quadratic", Family::quadratic, any(QuadraticKernel{}),
        maximum_of(reference::quadratic_minimum_point), 1);
    add("cubic", Family::cubic, any(CubicKernel{}), maximum_of(reference::cubic_minimum_point), 2);
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
  const ArgumentScale<S> scale = ArgumentScale<S>::of(length);
  if (sides == Sides::alike) return combined<S>(Additive<S, operation>{scale}, table.view(), x, y);
  return combined<S>(Additive<S, operation, Sides::differ>{scale}, table.view(), x, y);
}

/// Whether the blend of a row takes its table: not where a step that only approximates ends too far from 0
/// and 1.
template <class S, int segments>
bool fits(const Row& row, const Table<S, segments>& table) {
  const ArgumentScale<S> scale = ArgumentScale<S>::of(ScalarTraits<S>::one());
  if (row.sides == Sides::alike) return AdditiveUnion<S>{scale}.fits(table.view());
  return TwoSidedUnion<S>{scale}.fits(table.view());
}

/// A number some units in the last place away.
template <class S>
S moved(S x, int units) {
  if constexpr (ScalarTraits<S>::is_fixed) {
    return S::from_raw(x.raw() + units);
  } else {
    for (; units > 0; --units) x = std::nextafter(x, 1e9f);
    for (; units < 0; ++units) x = std::nextafter(x, -1e9f);
    return x;
  }
}

}  // namespace nearfield::additive_tests
