// What every curve of the catalogue says about itself, seen from outside: at its ends, by dense sampling, at
// its breaks.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include "curves/catalogue.hpp"

namespace nearfield::host {
namespace {

constexpr int sample_count = 4001;

std::vector<AnyCurve> initial_curves() {
  std::vector<AnyCurve> curves;
  for (const CatalogueEntry& entry : curve_catalogue()) curves.push_back(entry.make(initial_values(entry)));
  return curves;
}

// Each parameter at its least and greatest number, the others as they are, where that is a curve.
std::vector<std::pair<std::string, AnyCurve>> curves_of_all_kinds() {
  std::vector<std::pair<std::string, AnyCurve>> curves;
  for (const CatalogueEntry& entry : curve_catalogue()) {
    const std::string name(entry.name);
    curves.emplace_back(name, entry.make(initial_values(entry)));
    for (std::size_t i = 0; i < entry.parameters.size(); ++i) {
      const CurveParameter& parameter = entry.parameters[i];
      if (parameter.greatest_count > 1) continue;
      for (const double extreme : {parameter.least, parameter.greatest}) {
        std::vector<ParameterValues> values = initial_values(entry);
        values[i].values[0] = extreme;
        const AnyCurve curve = entry.make(values);
        if (curve.problem() != nullptr) continue;
        curves.emplace_back(name + ", " + parameter.name + " = " + std::to_string(extreme), curve);
      }
    }
  }
  return curves;
}

double place(const CurveFacts& facts, int i) {
  return facts.from + (facts.to - facts.from) * i / (sample_count - 1);
}

double value_at(const AnyCurve& curve, double x) { return curve(Differentiable(x)).value; }

TEST(CurveCatalogue, NamesAreUniqueAndFound) {
  std::set<std::string_view> names;
  for (const CatalogueEntry& entry : curve_catalogue()) {
    EXPECT_TRUE(names.insert(entry.name).second) << entry.name;
    EXPECT_EQ(find_curve(entry.name), &entry);
    std::set<std::string_view> parameters;
    for (const CurveParameter& parameter : entry.parameters) {
      EXPECT_TRUE(parameters.insert(parameter.name).second) << entry.name << " " << parameter.name;
      EXPECT_NE(std::string(parameter.meaning), "") << entry.name << " " << parameter.name;
    }
  }
  EXPECT_GE(names.size(), 16U);
  EXPECT_EQ(find_curve("absent"), nullptr);
  EXPECT_EQ(find_curve(""), nullptr);
}

TEST(CurveCatalogue, InitialValuesAreAllowedAndHaveNoProblem) {
  for (const CatalogueEntry& entry : curve_catalogue()) {
    SCOPED_TRACE(std::string(entry.name));
    for (const CurveParameter& parameter : entry.parameters) {
      EXPECT_LE(parameter.least, parameter.greatest);
      EXPECT_LE(parameter.least_count, parameter.initial_count);
      EXPECT_LE(parameter.initial_count, parameter.greatest_count);
      EXPECT_LE(parameter.greatest_count, CurveParameter::greatest_list);
      for (int i = 0; i < parameter.initial_count; ++i) {
        EXPECT_GE(parameter.initial[i], parameter.least) << parameter.name;
        EXPECT_LE(parameter.initial[i], parameter.greatest) << parameter.name;
      }
    }
    const AnyCurve curve = entry.make(initial_values(entry));
    EXPECT_EQ(curve.problem(), nullptr) << curve.problem();
  }
}

TEST(CurveCatalogue, FamiliesHaveTheirRangesAndEndValues) {
  for (const CatalogueEntry& entry : curve_catalogue()) {
    SCOPED_TRACE(std::string(entry.name));
    const CurveFacts facts = entry.make(initial_values(entry)).facts();
    const bool step = entry.family == CurveFamily::step;
    EXPECT_EQ(facts.from, step ? -1.0 : 0.0);
    EXPECT_EQ(facts.to, 1.0);
    EXPECT_EQ(facts.before, step ? 0.0 : 1.0);
    EXPECT_EQ(facts.after, step ? 1.0 : 0.0);
    EXPECT_EQ(facts.direction, step ? Direction::rising : Direction::falling);
  }
}

TEST(CurveCatalogue, ValuesAtTheEndsAndBeyond) {
  for (const auto& [name, curve] : curves_of_all_kinds()) {
    SCOPED_TRACE(name);
    const CurveFacts facts = curve.facts();
    for (const double beyond : {1e-9, 0.5, 100.0}) {
      EXPECT_EQ(value_at(curve, facts.from - beyond), facts.before);
      EXPECT_EQ(value_at(curve, facts.to + beyond), facts.after);
    }
    EXPECT_EQ(value_at(curve, facts.from), facts.before);
    EXPECT_EQ(value_at(curve, facts.to), facts.after);
    // Just within, there is a jump as great as it says, or none.
    const double jump = std::max(std::fabs(value_at(curve, facts.from + 1e-12) - facts.before),
                                 std::fabs(value_at(curve, facts.to - 1e-12) - facts.after));
    EXPECT_NEAR(jump, facts.end_jump, 1e-9);
    EXPECT_TRUE(facts.end_jump == 0.0 || facts.continuous_derivatives < 0);
  }
}

TEST(CurveCatalogue, DirectionIsTrue) {
  for (const auto& [name, curve] : curves_of_all_kinds()) {
    SCOPED_TRACE(name);
    const CurveFacts facts = curve.facts();
    ASSERT_NE(facts.direction, Direction::none);
    const double sign = facts.direction == Direction::rising ? 1.0 : -1.0;
    double before = value_at(curve, place(facts, 0));
    for (int i = 1; i < sample_count; ++i) {
      const double x = place(facts, i);
      const Differentiable here = curve(Differentiable::argument(x));
      ASSERT_GE(sign * (here.value - before), -1e-14) << x;
      ASSERT_GE(sign * here.first, -1e-9) << x;
      before = here.value;
    }
  }
}

TEST(CurveCatalogue, CentredAndAntisymmetricAreTrue) {
  for (const auto& [name, curve] : curves_of_all_kinds()) {
    SCOPED_TRACE(name);
    const CurveFacts facts = curve.facts();
    const double half = 0.5 * (facts.before + facts.after);
    const double in_the_middle = value_at(curve, facts.middle());
    EXPECT_EQ(facts.centred, std::fabs(in_the_middle - half) <= 1e-12) << in_the_middle;
    double worst = 0.0;
    for (int i = 0; i <= sample_count / 2; ++i) {
      const double offset = (facts.to - facts.from) * i / (sample_count - 1);
      const double sum = value_at(curve, facts.middle() + offset) + value_at(curve, facts.middle() - offset);
      worst = std::max(worst, std::fabs(sum - facts.before - facts.after));
    }
    if (facts.antisymmetric) {
      EXPECT_LE(worst, 1e-12);
      EXPECT_TRUE(facts.centred);
    }
  }
}

TEST(CurveCatalogue, BreaksAscend) {
  for (const auto& [name, curve] : curves_of_all_kinds()) {
    SCOPED_TRACE(name);
    const CurveFacts facts = curve.facts();
    ASSERT_LE(facts.break_count, CurveFacts::greatest_break_count);
    for (int i = 0; i < facts.break_count; ++i) {
      EXPECT_GT(facts.breaks[i], i > 0 ? facts.breaks[i - 1] : 0.0);
      EXPECT_LT(facts.breaks[i], 1.0);
    }
  }
}

// The first derivative that does not vanish shows as a slope, or as curvature, right beside an end.
TEST(CurveCatalogue, VanishingDerivativesVanish) {
  for (const AnyCurve& curve : initial_curves()) {
    const CurveFacts facts = curve.facts();
    for (const double inwards : {1.0, -1.0}) {
      const double end = inwards > 0.0 ? facts.from : facts.to;
      const Differentiable beside = curve(Differentiable::argument(end + inwards * 1e-7));
      if (facts.vanishing_derivatives >= 1) {
        EXPECT_LT(std::fabs(beside.first), 1e-3);
      }
      if (facts.vanishing_derivatives >= 2) {
        EXPECT_LT(std::fabs(beside.second), 1e-3);
      }
    }
  }
}

// Continuous derivatives differ little between neighbours, wherever the pieces meet.
TEST(CurveCatalogue, SmoothnessHoldsAtBreaks) {
  for (const AnyCurve& curve : initial_curves()) {
    const CurveFacts facts = curve.facts();
    for (int i = 0; i < facts.break_count; ++i) {
      const double x = facts.from + facts.breaks[i] * (facts.to - facts.from);
      const Differentiable below = curve(Differentiable::argument(x - 1e-8));
      const Differentiable above = curve(Differentiable::argument(x + 1e-8));
      if (facts.continuous_derivatives >= 0) {
        EXPECT_NEAR(below.value, above.value, 1e-6);
      }
      if (facts.continuous_derivatives >= 1) {
        EXPECT_NEAR(below.first, above.first, 1e-5);
      }
      if (facts.continuous_derivatives >= 2) {
        EXPECT_NEAR(below.second, above.second, 1e-4);
      }
    }
  }
}

TEST(CurveCatalogue, ControlPointsLieInTheRange) {
  for (const auto& [name, curve] : curves_of_all_kinds()) {
    SCOPED_TRACE(name);
    const ControlPoints points = curve.control_points();
    for (int i = 0; i < points.count; ++i) {
      EXPECT_GE(points.x[i], curve.facts().from);
      EXPECT_LE(points.x[i], curve.facts().to);
    }
  }
}

TEST(CurveCatalogue, ParametersThatDoNotFitHaveAProblem) {
  const auto made = [](const char* name, const std::vector<std::vector<double>>& numbers) {
    std::vector<ParameterValues> values;
    for (const std::vector<double>& list : numbers) {
      ParameterValues& value = values.emplace_back();
      for (const double number : list) value.values[value.count++] = number;
    }
    return find_curve(name)->make(values);
  };
  EXPECT_EQ(made("bezier", {{1, 1, 0, 0}}).problem(), nullptr);
  for (const AnyCurve& curve :
       {made("polynomial", {{0}}), made("polynomial", {{9}}), made("rising_cutoff", {{6}}),
        made("logistic", {{0.5}}), made("cutoff_from_polynomial", {{2}, {5}}), made("bezier", {{0.5, 0}}),
        made("bezier", {{1, 0, 1, 1, 0}}), made("bspline", {{3}, {0.5}, {1, 1, 0, 0}}),
        made("bspline", {{2}, {0.5, 0.25}, {1, 1, 0.5, 0, 0}}), made("natural_spline", {{0, 0.5, 1}, {1, 0}}),
        made("natural_spline", {{0, 0.1, 0.2, 1}, {1, 0.1, 0, 0}}), made("arctangent", {{0}, {0.5}}),
        made("arctangent_clamped", {{10}, {0}}), made("wyvill", {{0.9}, {0.99}}),
        made("parametric_bezier", {{0.2}}), made("parametric_bezier_points", {{1, 1}, {0, 0}}),
        made("blanc", {{-1}})}) {
    EXPECT_NE(curve.problem(), nullptr);
  }
}

}  // namespace
}  // namespace nearfield::host
