// The exact curves of the core: against the long double reference, which was written apart from them, and
// against the conditions that the papers state and the curves declare of themselves.
#include <curve_rows/potential_rows.hpp>
#include <curve_rows/step_rows.hpp>

#include <gtest/gtest.h>

#include <cmath>
#include <cstddef>
#include <string>
#include <vector>

namespace nearfield::curve_tests {
namespace {

constexpr int kPlaces = 2003;

// Greatest magnitudes of the value and of its derivatives over the range.
struct Scale {
  double first = 0.0, second = 0.0;
};

class CurveConditions : public testing::TestWithParam<CurveRow> {
 protected:
  const host::AnyCurve& curve() const { return GetParam().curve; }
  const CurveFacts facts_ = GetParam().curve.facts();
  const double length_ = facts_.to - facts_.from;

  // Inside the range, away from simple fractions.
  double place(int i) const { return facts_.from + length_ * (i + 0.37) / kPlaces; }
  Differentiable at(double x) const { return curve()(Differentiable::argument(x)); }
  Scale scale() const {
    Scale greatest;
    for (int i = 0; i < kPlaces; ++i) {
      const Differentiable here = at(place(i));
      greatest.first = std::fmax(greatest.first, std::fabs(here.first));
      greatest.second = std::fmax(greatest.second, std::fabs(here.second));
    }
    return greatest;
  }
  // How far the value is from that of its end, at a distance from it; 0 at the start, 1 at the end of the
  // range.
  double rise_from_end(int end, double distance) const {
    return end == 0 ? std::fabs(at(facts_.from + distance).value - facts_.before)
                    : std::fabs(at(facts_.to - distance).value - facts_.after);
  }
  // The power of the distance by which the value leaves its end, where it has gone 1e-11 to 1e-9.
  double order_at_end(int end) const {
    const auto distance_of = [&](double rise) {
      double low = 0.0, high = 0.5 * length_;
      for (int i = 0; i < 60; ++i) {
        const double middle = 0.5 * (low + high);
        (rise_from_end(end, middle) < rise ? low : high) = middle;
      }
      return high;
    };
    return std::log(100.0) / std::log(distance_of(1e-9) / distance_of(1e-11));
  }
};

TEST_P(CurveConditions, AgreesWithTheReferenceInValueAndDerivatives) {
  ASSERT_EQ(curve().problem(), nullptr);
  const Scale greatest = scale();
  std::vector<CurvePoint> exact(kPlaces);
  GetParam().reference(place(0), length_ / kPlaces, kPlaces, exact.data());
  double value = 0.0, first = 0.0, second = 0.0;
  for (int i = 0; i < kPlaces; ++i) {
    const double x = place(0) + length_ / kPlaces * i;
    const Differentiable here = at(x);
    const CurvePoint& truth = exact[static_cast<std::size_t>(i)];
    value = std::fmax(value, static_cast<double>(std::fabs(static_cast<Real>(here.value) - truth.value)));
    first = std::fmax(first, static_cast<double>(std::fabs(static_cast<Real>(here.first) - truth.first)));
    second = std::fmax(second, static_cast<double>(std::fabs(static_cast<Real>(here.second) - truth.second)));
  }
  EXPECT_LE(value, 1e-14);
  EXPECT_LE(first, 1e-12 * greatest.first);
  EXPECT_LE(second, 1e-12 * (greatest.second + greatest.first / length_));
}

TEST_P(CurveConditions, IsConstantOutsideItsRange) {
  for (const double beyond : {1e-15, 0.25, 7.0}) {
    for (const int end : {0, 1}) {
      const Differentiable here = at(end == 0 ? facts_.from - beyond : facts_.to + beyond);
      EXPECT_EQ(here.value, end == 0 ? facts_.before : facts_.after);
      EXPECT_EQ(here.first, 0.0);
      EXPECT_EQ(here.second, 0.0);
    }
  }
  const bool step = facts_.direction == Direction::rising;
  EXPECT_EQ(facts_.before, step ? 0.0 : 1.0);
  EXPECT_EQ(facts_.after, step ? 1.0 : 0.0);
}

TEST_P(CurveConditions, GoesOneWayOnly) {
  ASSERT_NE(facts_.direction, Direction::none);
  const double way = static_cast<double>(facts_.direction), tolerance = 1e-13 * scale().first;
  double before = facts_.before;
  for (int i = 0; i < kPlaces; ++i) {
    const Differentiable here = at(place(i));
    EXPECT_GE(way * here.first, -tolerance) << place(i);
    EXPECT_GE(way * (here.value - before), -1e-15) << place(i);
    EXPECT_TRUE(here.value >= 0.0 && here.value <= 1.0) << here.value;
    before = here.value;
  }
}

TEST_P(CurveConditions, MeetsItsEndsInTheOrderThatItDeclares) {
  const double beside = 1e-13 * length_;
  const double jump = std::fmax(rise_from_end(0, beside), rise_from_end(1, beside));
  EXPECT_NEAR(jump, facts_.end_jump, 1e-11 * (1.0 + scale().first));
  if (GetParam().name == "heaviside" || facts_.end_jump > 0.0) {
    EXPECT_EQ(facts_.vanishing_derivatives, 0);
    return;
  }
  const double order = std::fmin(order_at_end(0), order_at_end(1));
  const double declared = facts_.vanishing_derivatives + 1;
  EXPECT_GE(order, 0.93 * declared);
  // Nor do more derivatives vanish than it declares.
  EXPECT_LE(order, 1.07 * declared);
  const Scale greatest = scale();
  for (const double x : {facts_.from + beside, facts_.to - beside}) {
    if (facts_.vanishing_derivatives >= 1) {
      EXPECT_LE(std::fabs(at(x).first), 1e-9 * greatest.first);
    }
    if (facts_.vanishing_derivatives >= 2) {
      EXPECT_LE(std::fabs(at(x).second), 1e-9 * greatest.second);
    }
  }
}

TEST_P(CurveConditions, IsAsSmoothAsItDeclaresAndNoSmoother) {
  std::vector<double> joints{facts_.from, facts_.to};
  for (int i = 0; i < facts_.break_count; ++i) joints.push_back(facts_.from + length_ * facts_.breaks[i]);
  if (GetParam().name == "heaviside") joints.push_back(0.0);
  const Scale greatest = scale();
  const double beside = 1e-11 * length_;
  double jumps[3] = {};
  for (const double x : joints) {
    const Differentiable left = at(x - beside), right = at(x + beside);
    jumps[0] = std::fmax(jumps[0], std::fabs(right.value - left.value));
    jumps[1] = std::fmax(jumps[1], std::fabs(right.first - left.first) / (greatest.first + 1e-9));
    jumps[2] = std::fmax(jumps[2], std::fabs(right.second - left.second) / (greatest.second + 1e-9));
  }
  // The least tail is that of logistic 100: 4e-44, which no double shows.
  const bool jump_is_invisible = facts_.end_jump > 0.0 && facts_.end_jump < 1e-9;
  for (int k = 0; k <= 2; ++k) {
    if (k <= facts_.continuous_derivatives) {
      EXPECT_LE(jumps[k], 1e-8) << "derivative " << k;
    } else if (k == facts_.continuous_derivatives + 1 && !jump_is_invisible) {
      EXPECT_GE(jumps[k], 1e-7) << "derivative " << k;
    }
  }
}

TEST_P(CurveConditions, IsSymmetricAndCentredIfItSaysSo) {
  double uneven = 0.0;
  for (int i = 0; i < kPlaces; ++i) {
    const double t = 0.5 * length_ * (i + 0.37) / kPlaces;
    const double sum = at(facts_.middle() + t).value + at(facts_.middle() - t).value;
    uneven = std::fmax(uneven, std::fabs(sum - facts_.before - facts_.after));
  }
  const double off_centre = std::fabs(at(facts_.middle()).value - 0.5);
  EXPECT_TRUE(facts_.antisymmetric ? uneven <= 1e-15 * (5.0 + scale().first) : uneven >= 1e-6) << uneven;
  EXPECT_TRUE(facts_.centred ? off_centre <= 2e-15 : off_centre >= 1e-6) << off_centre;
}

INSTANTIATE_TEST_SUITE_P(PolynomialStep, CurveConditions, testing::ValuesIn(polynomial_rows()), name_of_row);
INSTANTIATE_TEST_SUITE_P(CutoffStep, CurveConditions, testing::ValuesIn(cutoff_rows()), name_of_row);
INSTANTIATE_TEST_SUITE_P(LogisticStep, CurveConditions, testing::ValuesIn(logistic_rows()), name_of_row);
INSTANTIATE_TEST_SUITE_P(Formula, CurveConditions, testing::ValuesIn(formula_rows()), name_of_row);
INSTANTIATE_TEST_SUITE_P(Arctangent, CurveConditions, testing::ValuesIn(arctangent_rows()), name_of_row);
INSTANTIATE_TEST_SUITE_P(Spline, CurveConditions, testing::ValuesIn(spline_rows()), name_of_row);
INSTANTIATE_TEST_SUITE_P(Parametric, CurveConditions, testing::ValuesIn(parametric_rows()), name_of_row);
INSTANTIATE_TEST_SUITE_P(RangeControl, CurveConditions, testing::ValuesIn(range_rows()), name_of_row);

TEST(CurveDefinitions, PolynomialStepsAndIntegralsOfBsplinesAreOneFunction) {
  for (int n = 1; n <= 8; ++n) {
    double worst = 0.0;
    for (int i = 0; i <= 200000; ++i) {
      const double t = -1.0 + i * 1e-5;
      worst = std::fmax(worst, std::fabs(step::Polynomial{n}(t).value - step::BSplineIntegral{n}(t).value));
    }
    EXPECT_LE(worst, 1e-14) << "n = " << n;
  }
}

TEST(CurveDefinitions, IterationFromTheStraightAngleIsTheRisingCutoff) {
  for (int n = 1; n <= 5; ++n) {
    for (int i = 1; i < 1000; ++i) {
      const double t = -1.0 + i * 2e-3;
      const double root = step::RisingCutoff{n}(t).value;
      EXPECT_NEAR((step::CutoffFromPolynomial{n, 1}(t).value), root, 1e-15);
      EXPECT_NEAR(step::RisingCutoffSquared{n}(t).value, root * root, 1e-15);
    }
    // 2^(n-1) - 1 vanishing derivatives; the square has 2^n - 1.
    EXPECT_EQ(step::RisingCutoff{n}.facts().vanishing_derivatives, (1 << (n - 1)) - 1);
    EXPECT_EQ(step::RisingCutoffSquared{n}.facts().vanishing_derivatives, (1 << n) - 1);
    EXPECT_FALSE(step::RisingCutoff{n}.facts().antisymmetric);
    EXPECT_TRUE(step::RisingCutoffSquared{n}.facts().antisymmetric);
  }
}

TEST(CurveDefinitions, IterationTakesAnAngleOfOnesOwn) {
  const auto angle = [](const Differentiable& t) { return 0.25 * kPi * (1.0 + sin((0.5 * kPi) * t)); };
  const step::IteratedCutoff<decltype(angle)> own{angle, 1, false, 1};
  ASSERT_EQ(own.problem(), nullptr);
  // sin(pi/4 (1 + sin(pi/2 t))) is R_2.
  for (int i = 1; i < 1000; ++i) {
    const double t = -1.0 + i * 2e-3;
    EXPECT_NEAR(own(t).value, step::RisingCutoff{2}(t).value, 1e-15);
  }
}

TEST(CurveDefinitions, OrderOfBezierCurvesFollowsTheirCoefficients) {
  for (const int n : {1, 3, 5, 7, 9}) {
    potential::Bezier curve;
    curve.degree = n;
    for (int i = 0; i <= n; ++i) curve.b[i] = 2 * i < n ? 1.0 : 0.0;
    EXPECT_EQ(curve.facts().vanishing_derivatives, (n - 1) / 2) << "degree " << n;
    EXPECT_TRUE(curve.facts().antisymmetric && curve.facts().centred);
  }
}

TEST(CurveDefinitions, PotentialsPassThroughTheirPoints) {
  for (const double radius : {0.47, 0.5, 0.6}) {
    const potential::Wyvill curve{radius, 0.5};
    ASSERT_EQ(curve.problem(), nullptr);
    EXPECT_NEAR(curve(radius).value, 0.5, 1e-15);
  }
  // 1 - (22/9) r^2 + (17/9) r^4 - (4/9) r^6.
  for (int i = 1; i < 100; ++i) {
    const double u = i * 1e-2 * i * 1e-2;
    EXPECT_NEAR(potential::wyvill(i * 1e-2).value, 1 - 22.0 / 9 * u + 17.0 / 9 * u * u - 4.0 / 9 * u * u * u,
                1e-15);
  }
  for (const double s : {0.0, 0.1, 1.0, 10.0, 100.0}) EXPECT_NEAR(potential::Blanc{s}(0.5).value, 0.5, 1e-15);
  const ParameterValues points[] = {parameter_of({0, 0.15, 0.4, 0.65, 1}),
                                    parameter_of({1, 0.95, 0.6, 0.2, 0})};
  const auto spline = potential::NaturalSpline::from(points);
  for (int i = 0; i < 5; ++i) EXPECT_NEAR(spline(points[0].values[i]).value, points[1].values[i], 1e-15);
  EXPECT_NEAR(spline(Differentiable::argument(1e-12)).second, 0.0, 1e-9);
  EXPECT_NEAR(spline(Differentiable::argument(1 - 1e-12)).second, 0.0, 1e-9);
}

TEST(CurveDefinitions, TailsAreAsStated) {
  for (const double alpha : {1.0, 4.0, 16.0, 40.0}) {
    const step::Logistic curve{alpha};
    EXPECT_NEAR(curve(-1.0 + 1e-15).value, curve.tail(), 1e-14);
    EXPECT_NEAR(curve(1.0 - 1e-15).value, 1.0 - curve.tail(), 1e-14);
    EXPECT_NEAR(step::Logistic::alpha_for_tail(curve.tail()), alpha, 1e-9 * alpha);
  }
  for (const double c2 : {0.3, 0.5, 0.7}) {
    const potential::Arctangent curve{10, c2};
    const double start = 1.0 - curve(1e-15).value, end = curve(1.0 - 1e-15).value;
    EXPECT_NEAR(curve.facts().end_jump, std::fmax(start, end), 1e-14);
    EXPECT_EQ(curve(c2).value, 0.5);
  }
}

TEST(CurveDefinitions, RangeControlKeepsTheSurfaceAndMovesTheInfluence) {
  for (const auto& [w1, w2] : {std::pair{0.5, 0.5}, {1.0, 0.3}, {2.0, 0.5}, {1.0, 1.0}}) {
    const auto curve = potential::with_range_control(potential::wyvill, w1, w2);
    ASSERT_EQ(curve.problem(), nullptr);
    EXPECT_EQ(curve(0.5).value, potential::wyvill(0.5).value);
    EXPECT_EQ(curve.facts().to, 0.5 * (1.0 + w1));
    EXPECT_EQ(curve(0.5 * (1.0 + w1) + 1e-12).value, 0.0);
    EXPECT_GT(curve(0.5 * (1.0 + w1) - 1e-3).value, 0.0);
    if (w2 < 1.0) {
      EXPECT_NEAR(curve(0.5 * (1.0 - w2)).value, 1.0, 1e-15);
    }
  }
  // w1 = w2 = 1 changes nothing.
  const auto plain = potential::with_range_control(potential::wyvill, 1.0, 1.0);
  for (int i = 1; i < 100; ++i) EXPECT_NEAR(plain(i * 1e-2).value, potential::wyvill(i * 1e-2).value, 1e-15);
}

}  // namespace
}  // namespace nearfield::curve_tests
