#include "curves/comparison.hpp"

#include <algorithm>
#include <cmath>
#include <cstdio>

#include <nearfield/curve/curves.hpp>

#include "curves/baked_curve.hpp"

namespace nearfield::host {
namespace {

// The row of a family of curves; those with a problem are none of it.
template <class Curve> ComparisonRow row_of(const std::string& name, const std::vector<Curve>& family) {
  ComparisonRow row;
  row.name = name;
  bool first = true;
  Curve gentlest{};
  for (const Curve& curve : family) {
    if (curve_problem(curve) != nullptr) continue;
    const CurveFacts facts = curve_facts(curve);
    const double slope = std::fabs(curve(Differentiable::argument(0.5)).first);
    if (first || slope < row.gentlest_slope) gentlest = curve;
    row.gentlest_slope = first ? slope : std::min(row.gentlest_slope, slope);
    row.steepest_slope = std::max(row.steepest_slope, slope);
    row.least_order = first ? facts.vanishing_derivatives : std::min(row.least_order, facts.vanishing_derivatives);
    row.greatest_order = std::max(row.greatest_order, facts.vanishing_derivatives);
    row.end_jump = std::max(row.end_jump, facts.end_jump);
    first = false;
  }
  if (const auto baked = bake_curve<Fixed<27>>(AnyCurve(gentlest), TableRequest{})) row.table_bytes = baked->layout.shape.bytes();
  return row;
}

ParameterValues list(const std::vector<double>& numbers) {
  ParameterValues values;
  values.count = static_cast<int>(numbers.size());
  std::copy(numbers.begin(), numbers.end(), values.values);
  return values;
}

std::vector<potential::NaturalSpline> natural_splines() {
  std::vector<potential::NaturalSpline> family;
  for (int i = 0; i <= 100; ++i) {
    const double drop = 0.005 * i;
    const ParameterValues values[] = {list({0, 0.25, 0.5, 0.75, 1}), list({1, 1 - drop, 0.5, drop, 0})};
    family.push_back(potential::NaturalSpline::from(values));
  }
  return family;
}

// Ones, a straight descent, zeros.
std::vector<potential::Bezier> beziers() {
  std::vector<potential::Bezier> family;
  for (int degree = 1; degree <= potential::Bezier::greatest_degree; ++degree) {
    for (int flat = 0; 2 * flat < degree; ++flat) {
      std::vector<double> b;
      for (int j = 0; j <= degree; ++j) b.push_back(std::clamp(1.0 - static_cast<double>(j - flat) / (degree - 2 * flat), 0.0, 1.0));
      const ParameterValues values = list(b);
      family.push_back(potential::Bezier::from(&values));
    }
  }
  return family;
}

// Seven knots drawn together around the middle.
std::vector<potential::BSpline> bsplines() {
  std::vector<potential::BSpline> family;
  for (int i = 1; i <= 32; ++i) {
    std::vector<double> knots;
    for (int k = -3; k <= 3; ++k) knots.push_back(0.5 + 0.005 * i * k);
    const ParameterValues values[] = {list({3}), list(knots), list({1, 1, 1, 1, 1, 0.5, 0, 0, 0, 0, 0})};
    family.push_back(potential::BSpline::from(values));
  }
  return family;
}

std::string order_text(const ComparisonRow& row) {
  std::string text = std::to_string(row.least_order);
  if (row.greatest_order != row.least_order) text += "-" + std::to_string(row.greatest_order);
  char jump[40];
  std::snprintf(jump, sizeof jump, ", ends off by %.4f", row.end_jump);
  return row.end_jump > 0 ? text + jump : text;
}

}  // namespace

std::vector<ComparisonRow> compare_potentials() {
  std::vector<potential::Arctangent> arctangents;
  for (int i = 0; i <= 99; ++i) arctangents.push_back({10.0 + 10.0 * i, 0.5});
  std::vector<potential::ParametricBezier> parametric;
  for (int i = 0; i <= 100; ++i) parametric.push_back({1.0 / 3.0 + (0.98 - 1.0 / 3.0) * i / 100});
  return {row_of<potential::Wyvill>("cubic polynomial in r^2", {potential::wyvill}),
          row_of("interpolating cubic spline", natural_splines()),
          row_of("nonparametric Bezier curve", beziers()),
          row_of("nonparametric B-spline", bsplines()),
          row_of("arctangent", arctangents),
          row_of("parametric spline", parametric)};
}

std::string comparison_text(const std::vector<ComparisonRow>& rows) {
  std::string text = "function                       slope at r = 1/2  order of continuity     table within 2^-20\n";
  for (const ComparisonRow& row : rows) {
    char line[160];
    std::snprintf(line, sizeof line, "%-28s  %6.2f ... %6.2f  %-22s  %s\n", row.name.c_str(), row.gentlest_slope,
                  row.steepest_slope, order_text(row).c_str(),
                  row.table_bytes > 0 ? (std::to_string(row.table_bytes) + " bytes").c_str() : "none of 1 KiB");
    text += line;
  }
  return text;
}

}  // namespace nearfield::host
