#pragma once
/// Every potential with several parameters.

#include <nearfield/curve/curves.hpp>
#include <reference/potential_curves.hpp>
#include <reference/spline_curves.hpp>

#include <curve_rows/curve_row.hpp>

#include <array>
#include <string>
#include <vector>

namespace nearfield::curve_tests {

/// A parameter in a name: 0.4 as "0_4".
inline std::string text_of(double parameter) {
  std::string text = std::to_string(parameter);
  while (text.back() == '0') text.pop_back();
  if (text.back() == '.') text.pop_back();
  for (char& c : text) c = c == '.' ? '_' : c;
  return text;
}
/// The same number: references take the parameters that the curves have, rounded to double.
inline Real real(double number) { return static_cast<Real>(number); }
inline std::vector<Real> reals(const std::vector<double>& numbers) {
  return {numbers.begin(), numbers.end()};
}
inline ParameterValues parameter_of(const std::vector<double>& numbers) {
  ParameterValues values;
  for (const double number : numbers) values.values[values.count++] = number;
  return values;
}

inline std::vector<CurveRow> formula_rows() {
  std::vector<CurveRow> rows;
  Expected exact;
  exact.exact_segments = 1;
  rows.push_back(curve_row("cubic", potential::Cubic{}, reference::CubicCurve{}, exact));
  rows.push_back(curve_row("wyvill", potential::Wyvill{}, reference::WyvillCurve{}, exact));
  rows.push_back(curve_row("wyvill_0_4_0_8", potential::Wyvill{0.4, 0.8},
                           reference::WyvillCurve(real(0.4), real(0.8)), exact));
  rows.push_back(curve_row("wyvill_0_6_0_3", potential::Wyvill{0.6, 0.3},
                           reference::WyvillCurve(real(0.6), real(0.3)), exact));
  for (const double s : {0.0, 0.1, 1.0, 10.0, 100.0}) {
    Expected expected;
    if (s == 0.1 || s == 10) expected.meets = Meets::in_sixteen_kibibytes;
    if (s == 100) expected.meets = Meets::nowhere;
    expected.too_steep_for_float = s == 100;
    rows.push_back(
        curve_row("blanc_" + text_of(s), potential::Blanc{s}, reference::BlancCurve(real(s)), expected));
  }
  return rows;
}

inline std::vector<CurveRow> arctangent_rows() {
  std::vector<CurveRow> rows;
  const auto add = [&rows](double c1, double c2, bool clamped) {
    Expected expected;
    // In the middle, half of the range is tabulated.
    if (c1 > 10 || (c1 == 10 && c2 != 0.5)) expected.meets = Meets::in_sixteen_kibibytes;
    if (c1 == 1000) expected.meets = Meets::nowhere;
    expected.too_steep_for_float = c1 == 1000;
    const std::string parameters = text_of(c1) + "_" + text_of(c2);
    if (clamped) {
      rows.push_back(curve_row("arctangent_clamped_" + parameters, potential::ArctangentClamped{c1, c2},
                               reference::ArctangentCurve::clamped(real(c1), real(c2)), expected));
    } else {
      rows.push_back(curve_row("arctangent_" + parameters, potential::Arctangent{c1, c2},
                               reference::ArctangentCurve::plain(real(c1), real(c2)), expected));
    }
  };
  for (const double c1 : {5.0, 10.0, 40.0, 100.0, 1000.0}) {
    add(c1, 0.5, false);
    add(c1, 0.4, true);
  }
  add(10, 0.4, false);
  add(10, 0.5, true);
  return rows;
}

inline CurveRow natural_spline(const std::string& name, const std::vector<double>& r,
                               const std::vector<double>& intensity, const Expected& expected = {}) {
  const ParameterValues values[] = {parameter_of(r), parameter_of(intensity)};
  return curve_row(name, potential::NaturalSpline::from(values),
                   reference::NaturalSplineCurve(reals(r), reals(intensity)), expected);
}
inline CurveRow bezier(const std::string& name, const std::vector<double>& b, const Expected& expected = {}) {
  const ParameterValues values[] = {parameter_of(b)};
  return curve_row(name, potential::Bezier::from(values), reference::BezierCurve(reals(b)), expected);
}
inline CurveRow bspline(const std::string& name, int degree, const std::vector<double>& knots,
                        const std::vector<double>& b, const Expected& expected = {}) {
  const ParameterValues values[] = {parameter_of({static_cast<double>(degree)}), parameter_of(knots),
                                    parameter_of(b)};
  std::vector<Real> all(static_cast<size_t>(degree) + 1, 0);
  all.insert(all.end(), knots.begin(), knots.end());
  all.insert(all.end(), static_cast<size_t>(degree) + 1, 1);
  return curve_row(name, potential::BSpline::from(values),
                   reference::ExplicitBsplineCurve(degree, all, reals(b)), expected);
}
inline CurveRow parametric(const std::string& name, double r1, double f1, double r2, double f2,
                           const Expected& expected = {}) {
  const std::array<reference::ParametricBezierCurve::ControlPoint, 4> points{
      {{0, 1}, {real(r1), real(f1)}, {real(r2), real(f2)}, {1, 0}}};
  return curve_row(name, potential::ParametricBezierPoints{r1, f1, r2, f2},
                   reference::ParametricBezierCurve(points), expected);
}

inline std::vector<CurveRow> spline_rows() {
  std::vector<CurveRow> rows;
  // As many segments as make some of them meet at every knot; of the upper half where a curve is
  // antisymmetric.
  const auto exact = [](int segments, const std::vector<double>& kinks = {}) {
    return Expected{Meets::in_one_kibibyte, segments, kinks};
  };
  rows.push_back(
      natural_spline("natural_spline_even", {0, 0.25, 0.5, 0.75, 1}, {1, 0.85, 0.5, 0.15, 0}, exact(2)));
  rows.push_back(
      natural_spline("natural_spline_uneven", {0, 0.15, 0.4, 0.65, 1}, {1, 0.95, 0.6, 0.2, 0}, exact(20)));
  rows.push_back(bezier("bezier_3", {1, 1, 0, 0}, exact(1)));
  rows.push_back(bezier("bezier_5", {1, 1, 1, 0, 0, 0}));
  rows.push_back(bezier("bezier_9", {1, 1, 1, 1, 1, 0, 0, 0, 0, 0}));
  rows.push_back(bezier("bezier_9_steep", {1, 1, 1, 1, 1, 1, 1, 1, 1, 0}));
  rows.push_back(bspline("bspline_even", 3, {0.25, 0.5, 0.75}, {1, 1, 0.9, 0.5, 0.1, 0, 0}, exact(2)));
  rows.push_back(
      bspline("bspline_repeated_knot", 3, {0.3, 0.3, 0.6}, {1, 1, 0.8, 0.6, 0.3, 0, 0}, exact(10)));
  // Parabolas come in pairs.
  // Kinks that lie between the places of a uniform comparison.
  rows.push_back(bspline("bspline_close_knots", 1, {0.51, 0.5105, 0.511}, {1, 0.49, 0.4892, 0.489, 0},
                         {Meets::nowhere, 0, {0.51, 0.5105, 0.511}}));
  rows.push_back(bspline("bspline_steep_piece", 1, {0.51, 0.511}, {1, 0.9, 0.1, 0}, {Meets::nowhere, 0, {0.51, 0.511}, true}));
  rows.push_back(bspline("bspline_kinked", 2, {0.5, 0.5}, {1, 1, 0.7, 0, 0}, exact(4, {0.5})));
  return rows;
}

inline std::vector<CurveRow> parametric_rows() {
  std::vector<CurveRow> rows;
  for (const double c : {0.4, 0.6, 0.9}) {
    rows.push_back(curve_row("parametric_bezier_" + text_of(c), potential::ParametricBezier{c},
                             reference::ParametricBezierCurve(real(c)),
                             {c == 0.9 ? Meets::in_sixteen_kibibytes : Meets::in_one_kibibyte}));
  }
  rows.push_back(parametric("parametric_bezier_points", 0.3, 0.9, 0.5, 0.2));
  return rows;
}

template <class Potential, class Reference>
void add_range_control(std::vector<CurveRow>& rows, const std::string& name, const Potential& potential,
                       const Reference& exact, bool is_soft) {
  for (const auto& [w1, w2] : {std::array<double, 2>{0.5, 0.5}, {1.0, 0.3}, {2.0, 0.5}}) {
    const reference::RangeRemap remap(real(w1), real(w2));
    rows.push_back(curve_row(name + "_range_" + text_of(w1) + "_" + text_of(w2),
                             potential::with_range_control(potential, w1, w2),
                             reference::RemappedCurve<Reference>(remap, exact),
                             {w1 == w2 && is_soft ? Meets::in_one_kibibyte : Meets::in_sixteen_kibibytes}));
  }
}
inline std::vector<CurveRow> range_rows() {
  std::vector<CurveRow> rows;
  add_range_control(rows, "cubic", potential::Cubic{}, reference::CubicCurve{}, true);
  add_range_control(rows, "wyvill", potential::Wyvill{}, reference::WyvillCurve{}, true);
  add_range_control(rows, "blanc", potential::Blanc{1.0}, reference::BlancCurve(1), false);
  return rows;
}

}  // namespace nearfield::curve_tests
