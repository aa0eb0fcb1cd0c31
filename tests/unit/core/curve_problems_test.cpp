// Parameters and requests that cannot be met are refused in so many words. That the same requests do not
// compile is what consume/refused_requests.sh shows.
#include <curves/baked_curve.hpp>
#include <nearfield/curve/curves.hpp>

#include <gtest/gtest.h>

#include <initializer_list>
#include <limits>
#include <string>
#include <type_traits>
#include <vector>

namespace nearfield {
namespace {

constexpr double kNone = std::numeric_limits<double>::quiet_NaN();

ParameterValues numbers(const std::vector<double>& list) {
  ParameterValues values;
  for (const double number : list) values.values[values.count++] = number;
  return values;
}
std::string problem_of(const host::AnyCurve& curve) {
  return curve.problem() == nullptr ? "" : curve.problem();
}
template <class Curve>
std::string problem_of(const Curve& curve) {
  return problem_of(host::AnyCurve(curve));
}
template <class Curve>
std::string problem_from(std::initializer_list<std::vector<double>> parameters) {
  std::vector<ParameterValues> values;
  for (const std::vector<double>& list : parameters) values.push_back(numbers(list));
  return problem_of(Curve::from(values.data()));
}

TEST(CurveProblems, Steps) {
  for (const int n : {-1, 0, 9}) {
    EXPECT_EQ(problem_of(step::Polynomial{n}), "n is 1 to 8");
    EXPECT_EQ(problem_of(step::BSplineIntegral{n}), "m is 1 to 8");
  }
  for (const int n : {0, 6}) {
    EXPECT_EQ(problem_of(step::RisingCutoff{n}), "n is 1 to 5");
    EXPECT_EQ(problem_of(step::RisingCutoffSquared{n}), "n is 1 to 5");
    EXPECT_EQ(problem_of(step::CutoffFromPolynomial{n, 2}), "n is 1 to 5");
  }
  EXPECT_EQ(problem_of(step::CutoffFromPolynomial{2, 0}), "start is 1 to 4");
  EXPECT_EQ(problem_of(step::CutoffFromPolynomial{2, 5}), "start is 1 to 4");
  for (const double alpha : {0.99, 200.1, kNone})
    EXPECT_EQ(problem_of(step::Logistic{alpha}), "alpha is 1 to 200");
}

TEST(CurveProblems, StartingAnglesOfOnesOwn) {
  const auto problem_of_angle = [](const auto& angle) {
    return problem_of(step::IteratedCutoff<std::decay_t<decltype(angle)>>{angle, 2, false, 0});
  };
  EXPECT_EQ(problem_of_angle([](const Differentiable& t) { return (0.25 * kPi) * (1.0 + t); }), "");
  EXPECT_EQ(problem_of_angle([](const Differentiable& t) { return 0.5 + t; }),
            "theta(t) + theta(-t) is pi / 2");
  EXPECT_EQ(problem_of_angle([](const Differentiable& t) { return (0.25 * kPi) * (1.0 - t); }),
            "theta does not decrease");
  EXPECT_EQ(problem_of_angle([](const Differentiable& t) { return (0.25 * kPi) * (1.0 + 0.5 * t); }),
            "theta is 0 at -1");
}

TEST(CurveProblems, PotentialsByFormula) {
  for (const double radius : {0.0, 1.0, -0.5, kNone}) {
    EXPECT_EQ(problem_of(potential::Wyvill{radius, 0.5}), "radius lies between 0 and 1");
  }
  EXPECT_EQ(problem_of(potential::Wyvill{0.5, 0.99}), "a curve through this point is not monotone");
  EXPECT_EQ(problem_of(potential::Wyvill{0.5, 0.1}), "a curve through this point is not monotone");
  for (const double c1 : {0.5, 1001.0, kNone}) {
    EXPECT_EQ(problem_of(potential::Arctangent{c1, 0.5}), "c1 is 1 to 1000");
    EXPECT_EQ(problem_of(potential::ArctangentClamped{c1, 0.5}), "c1 is 1 to 1000");
  }
  for (const double c2 : {0.05, 0.95, kNone})
    EXPECT_EQ(problem_of(potential::Arctangent{10, c2}), "c2 is 0.1 to 0.9");
  for (const double s : {-0.1, 100.5, kNone}) EXPECT_EQ(problem_of(potential::Blanc{s}), "s is 0 to 100");
}

TEST(CurveProblems, NaturalSplines) {
  using potential::NaturalSpline;
  const std::string disorder = "as many values as places; places ascend from 0 to 1, values go from 1 to 0";
  EXPECT_EQ(problem_from<NaturalSpline>({{0, 0.5, 1}, {1, 0.5, 0}}), "");
  EXPECT_EQ(problem_from<NaturalSpline>({{0, 0.5, 1}, {1, 0}}), disorder);
  EXPECT_EQ(problem_from<NaturalSpline>({{0, 1}, {1, 0}}), disorder);
  EXPECT_EQ(problem_from<NaturalSpline>({{0, 0.5, 0.5, 1}, {1, 0.6, 0.5, 0}}), disorder);
  EXPECT_EQ(problem_from<NaturalSpline>({{0.1, 0.5, 1}, {1, 0.5, 0}}), disorder);
  EXPECT_EQ(problem_from<NaturalSpline>({{0, 0.5, 1}, {1, 0.5, 0.1}}), disorder);
  // Through falling points, and yet it swings.
  EXPECT_EQ(problem_from<NaturalSpline>({{0, 0.4, 0.5, 1}, {1, 0.99, 0.01, 0}}),
            "the spline through these points is not monotone");
}

TEST(CurveProblems, BeziersAndBsplines) {
  using potential::Bezier;
  using potential::BSpline;
  EXPECT_EQ(problem_from<Bezier>({{1}}), "there are 2 to 10 coefficients");
  EXPECT_EQ(problem_from<Bezier>({{1, 1, 1, 1, 1, 1, 0, 0, 0, 0, 0}}), "there are 2 to 10 coefficients");
  EXPECT_EQ(problem_from<Bezier>({{0.9, 0.5, 0}}), "the first coefficient is 1, the last 0");
  EXPECT_EQ(problem_from<Bezier>({{1, 0.5, 0.1}}), "the first coefficient is 1, the last 0");
  EXPECT_EQ(problem_from<Bezier>({{1, 0, 0, 1, 0}}), "the curve of these coefficients is not monotone");
  // Coefficients that rise once, of a curve that does not.
  EXPECT_EQ(problem_from<Bezier>({{1, 0, 1, 0}}), "");

  EXPECT_EQ(problem_from<BSpline>({{0}, {}, {1, 0}}), "the degree is 1 to 5");
  EXPECT_EQ(problem_from<BSpline>({{6}, {}, {1, 1, 1, 1, 0, 0, 0}}), "the degree is 1 to 5");
  EXPECT_EQ(problem_from<BSpline>({{2}, {0.1, 0.2, 0.3, 0.4, 0.5, 0.6, 0.7, 0.8, 0.9}, {1, 0}}),
            "there are at most 8 interior knots");
  EXPECT_EQ(problem_from<BSpline>({{2}, {0.5}, {1, 0.5, 0}}),
            "there are degree + 1 + (number of knots) coefficients");
  EXPECT_EQ(problem_from<BSpline>({{1}, {0.6, 0.4}, {1, 0.7, 0.3, 0}}), "the knots ascend between 0 and 1");
  EXPECT_EQ(problem_from<BSpline>({{1}, {0.0, 0.4}, {1, 0.7, 0.3, 0}}), "the knots ascend between 0 and 1");
  EXPECT_EQ(problem_from<BSpline>({{1}, {0.5, 0.5}, {1, 0.7, 0.3, 0}}),
            "a knot is repeated at most as often as the degree");
  EXPECT_EQ(problem_from<BSpline>({{1}, {0.5}, {1, 0.7, 0.1}}), "the first coefficient is 1, the last 0");
  EXPECT_EQ(problem_from<BSpline>({{1}, {0.3, 0.6}, {1, 0.2, 0.7, 0}}),
            "the curve of these coefficients is not monotone");
}

TEST(CurveProblems, ParametricBeziers) {
  for (const double c : {0.2, 1.0, kNone})
    EXPECT_EQ(problem_of(potential::ParametricBezier{c}), "c is 1/3 or more and below 1");
  using Points = potential::ParametricBezierPoints;
  EXPECT_EQ(problem_of(Points{0.6, 1, 0.4, 0}), "");
  EXPECT_EQ(problem_of(Points{0.0, 1, 0.4, 0}),
            "a vertical slope at an end: the first r is above 0, the second below 1");
  EXPECT_EQ(problem_of(Points{0.6, 1, 1.0, 0}),
            "a vertical slope at an end: the first r is above 0, the second below 1");
  // c = 1 would be vertical in the middle, and anything beyond folds.
  EXPECT_EQ(problem_of(Points{1.0, 1, 0.0, 0}),
            "the curve folds back or is vertical inside: it is no function of r");
  EXPECT_EQ(problem_of(Points{1.3, 1, -0.2, 0}),
            "the curve folds back or is vertical inside: it is no function of r");
  EXPECT_EQ(problem_of(Points{0.4, -0.1, 0.6, 1}), "the curve of these points is not monotone");
  EXPECT_EQ(problem_of(Points{0.4, 1.1, 0.6, 0}), "the curve of these points is not monotone");
}

TEST(CurveProblems, RangeControl) {
  const auto problem = [](double w1, double w2) {
    return problem_of(potential::with_range_control(potential::Cubic{}, w1, w2));
  };
  EXPECT_EQ(problem(1.0, 0.5), "");
  for (const double w1 : {0.0, -1.0, 3.5, kNone}) EXPECT_EQ(problem(w1, 0.5), "w1 is above 0, at most 3");
  for (const double w2 : {0.0, 1.2, kNone})
    EXPECT_EQ(problem(2.0, w2), "w2 is above 0, at most 1 and at most w1");
  EXPECT_EQ(problem(0.5, 0.6), "w2 is above 0, at most 1 and at most w1");
  EXPECT_EQ(problem_of(potential::with_range_control(potential::Blanc{-1}, 1, 1)), "s is 0 to 100");
  EXPECT_EQ(problem_of(potential::with_range_control(potential::Arctangent{10, 0.5}, 1, 1)),
            "a potential that misses 1 or 0 at its ends has no range control");
}

template <class S>
bool is_baked(const host::AnyCurve& curve, const TableRequest& request) {
  return host::bake_curve<S>(curve, request).has_value();
}

TEST(CurveProblems, ErrorsThatDoNotFitAreNoTable) {
  const host::AnyCurve steep(potential::Arctangent{1000, 0.5}), cubic(potential::Cubic{}),
      jump(step::Heaviside{});
  EXPECT_FALSE(is_baked<Fixed<27>>(steep, {20, 1024}));
  EXPECT_FALSE(is_baked<Fixed<27>>(steep, {20, 16384}));
  EXPECT_TRUE(is_baked<Fixed<27>>(steep, {0, 1024}));
  EXPECT_FALSE(is_baked<Fixed<27>>(cubic, {30, 1024}));
  EXPECT_TRUE(is_baked<Fixed<27>>(cubic, {26, 16}));
  EXPECT_FALSE(is_baked<Fixed<27>>(cubic, {20, 8}));
  EXPECT_FALSE(is_baked<Fixed<27>>(cubic, {20, 1024, 0, 0, 16}));
  EXPECT_TRUE(is_baked<Fixed<27>>(cubic, {12, 1024, 0, 0, 16}));
  EXPECT_FALSE(is_baked<Fixed<27>>(jump, {4, 1024}));
  EXPECT_FALSE(is_baked<float>(cubic, {22, 1024}));
  // A step has arguments below 0, so there is none over their square.
  EXPECT_FALSE(is_baked<Fixed<27>>(host::AnyCurve(step::Polynomial{3}),
                                   {10, 1024, 0, 0, 32, TableParameter::squared}));
}

TEST(CurveProblems, ValuesThatNoTableHoldsAreNone) {
  const auto tall = [](const Differentiable& x) { return 2.5 * x; };
  const auto lost = [](const Differentiable& x) { return log(x - 2.0) / (x - x); };
  EXPECT_FALSE(is_baked<Fixed<27>>(host::AnyCurve(tall), {0, 1024}));
  EXPECT_FALSE(is_baked<Fixed<27>>(host::AnyCurve(tall), {10, 1024}));
  EXPECT_FALSE(is_baked<Fixed<27>>(host::AnyCurve(lost), {0, 1024}));
  EXPECT_FALSE(is_baked<float>(host::AnyCurve(lost), {10, 1024}));
}

}  // namespace
}  // namespace nearfield
