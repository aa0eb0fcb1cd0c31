#pragma once
/// Every step with several parameters.

#include <nearfield/curve/step.hpp>
#include <reference/step_curves.hpp>

#include <curve_rows/curve_row.hpp>

#include <string>
#include <tuple>
#include <vector>

namespace nearfield::curve_tests {

/// θ₀ = (π/2) μ.
template <class Step>
struct AngleOfStep {
  Step step;
  CurvePoint operator()(Real t) const {
    const CurvePoint here = step(t);
    const Real scale = reference::pi / 2;
    return {scale * here.value, scale * here.first, scale * here.second};
  }
};

inline std::vector<CurveRow> polynomial_rows() {
  std::vector<CurveRow> rows;
  // Its value at 0 is half a jump away from both sides, which is the error that its tables state.
  Expected jump{Meets::nowhere};
  jump.kinks = {0.0};
  rows.push_back(curve_row("heaviside", step::Heaviside{}, reference::HeavisideCurve{}, jump));
  for (int n = 1; n <= 8; ++n) {
    Expected expected;
    if (n <= 3) expected.exact_segments = n == 3 ? 3 : 1;
    rows.push_back(curve_row("polynomial_" + std::to_string(n), step::Polynomial{n},
                             reference::PolynomialStepCurve(n), expected));
    rows.push_back(curve_row("bspline_integral_" + std::to_string(n), step::BSplineIntegral{n},
                             reference::BsplineStepCurve(n), expected));
  }
  return rows;
}

inline std::vector<CurveRow> cutoff_rows() {
  std::vector<CurveRow> rows;
  for (int n = 1; n <= 5; ++n) {
    rows.push_back(curve_row("rising_cutoff_" + std::to_string(n), step::RisingCutoff{n},
                             reference::RisingCutoffCurve(n),
                             {n >= 4 ? Meets::in_sixteen_kibibytes : Meets::in_one_kibibyte}));
    rows.push_back(curve_row("rising_cutoff_squared_" + std::to_string(n), step::RisingCutoffSquared{n},
                             reference::RisingCutoffSquaredCurve(n),
                             {n == 5 ? Meets::in_sixteen_kibibytes : Meets::in_one_kibibyte}));
  }
  for (const auto& [start, n, meets] : {std::tuple{1, 1, Meets::in_one_kibibyte},
                                        {2, 2, Meets::in_one_kibibyte},
                                        {3, 3, Meets::in_sixteen_kibibytes},
                                        {4, 2, Meets::in_sixteen_kibibytes}}) {
    using Angle = AngleOfStep<reference::PolynomialStepCurve>;
    const Angle angle{reference::PolynomialStepCurve(start)};
    rows.push_back(curve_row("cutoff_from_polynomial_" + std::to_string(start) + "_" + std::to_string(n),
                             step::CutoffFromPolynomial{n, start},
                             reference::IteratedRisingCutoffCurve<Angle>(n, angle), {meets}));
  }
  return rows;
}

inline std::vector<CurveRow> logistic_rows() {
  std::vector<CurveRow> rows;
  for (const int alpha : {4, 16, 40, 100}) {
    rows.push_back(curve_row("logistic_" + std::to_string(alpha), step::Logistic{static_cast<double>(alpha)},
                             reference::LogisticCurve(alpha),
                             {alpha >= 16 ? Meets::in_sixteen_kibibytes : Meets::in_one_kibibyte}));
  }
  return rows;
}

}  // namespace nearfield::curve_tests
