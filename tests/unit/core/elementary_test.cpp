// The elementary functions of baking against the long double ones of the C library, and derivatives that come
// from the chain rule against differences.
#include <nearfield/number/differentiable.hpp>
#include <reference/random.hpp>

#include <gtest/gtest.h>

#include <cmath>
#include <cstdint>
#include <cstdio>
#include <limits>
#include <string>

namespace nearfield {
namespace {

using Real = long double;

const std::uint64_t kSeed = reference::announced_seed("Elementary", 611);
constexpr int kCount = 400000;
constexpr double kGreatestUlps = 2.0;

double drawn(reference::Random& random, double low, double high) {
  return static_cast<double>(random.uniform(static_cast<Real>(low), static_cast<Real>(high)));
}

// The distance between doubles at x.
double unit_at(Real x) {
  int exponent = 0;
  std::frexp(std::fabs(x), &exponent);
  return std::ldexp(1.0, exponent - 53 < -1074 ? -1074 : exponent - 53);
}

// The worst of one function over many arguments.
struct Worst {
  double units = 0.0;
  double at = 0.0;

  template <class Function, class Exact>
  void look(const Function& function, const Exact& exact, double x) {
    const Real truth = exact(static_cast<Real>(x));
    const double off =
        static_cast<double>(std::fabs(static_cast<Real>(function(x)) - truth)) / unit_at(truth);
    if (off <= units) return;  // so that what is not a number is seen
    units = off;
    at = x;
  }
};

// Evenly over [low, high], and at random over it and towards its end that is nearer to 0.
template <class Function, class Exact>
void expect_close(const std::string& name, const Function& function, const Exact& exact, double low,
                  double high) {
  reference::Random random(kSeed);
  Worst worst;
  for (int i = 0; i <= kCount; ++i) {
    worst.look(function, exact, low + (high - low) * i / kCount);
    worst.look(function, exact, drawn(random, low, high));
    const double small = std::exp2(drawn(random, -60.0, 0.0));
    worst.look(function, exact, (std::fabs(low) < std::fabs(high) ? high : low) * small);
  }
  std::printf("%s on [%g, %g]: %.3f units in the last place at %.17g (seed %llu)\n", name.c_str(), low, high,
              worst.units, worst.at, static_cast<unsigned long long>(kSeed));
  EXPECT_LE(worst.units, kGreatestUlps) << name << " at " << worst.at << ", seed " << kSeed;
}

const auto exact_sine = [](Real x) { return std::sin(x); };
const auto exact_cosine = [](Real x) { return std::cos(x); };

TEST(Elementary, SineAndCosine) {
  for (const double reach : {0.8, 3.2, 100.0, 1048576.0}) {
    expect_close("sine", exact_sin, exact_sine, -reach, reach);
    expect_close("cosine", exact_cos, exact_cosine, -reach, reach);
  }
  // Where either is nearly 0, around the multiples of a quarter turn.
  Worst sine, cosine;
  for (int quarter = -10000; quarter <= 10000; ++quarter) {
    const double middle = quarter * (kPi / 2);
    for (const double beside : {0.0, 1e-15, -1e-15, 1e-9, -1e-9, 1e-3}) {
      if (quarter != 0 || beside != 0.0) sine.look(exact_sin, exact_sine, middle + beside);
      cosine.look(exact_cos, exact_cosine, middle + beside);
    }
  }
  EXPECT_LE(sine.units, kGreatestUlps) << sine.at;
  EXPECT_LE(cosine.units, kGreatestUlps) << cosine.at;
  EXPECT_EQ(exact_sin(0.0), 0.0);
  EXPECT_EQ(exact_cos(0.0), 1.0);
}

TEST(Elementary, SquareRoot) {
  const auto exact = [](Real x) { return std::sqrt(x); };
  expect_close("square root", exact_sqrt, exact, 0.0, 4.0);
  Worst worst;
  reference::Random random(kSeed);
  for (int i = 0; i < kCount; ++i) worst.look(exact_sqrt, exact, std::exp2(drawn(random, -1021.0, 1023.0)));
  worst.look(exact_sqrt, exact, std::numeric_limits<double>::min());
  worst.look(exact_sqrt, exact, std::numeric_limits<double>::max());
  EXPECT_LE(worst.units, kGreatestUlps) << worst.at << ", seed " << kSeed;
  for (const double none : {0.0, -0.0, -1e-300, -1.0, -1e300, 1e-310})
    EXPECT_EQ(exact_sqrt(none), 0.0) << none;
  for (int i = 1; i < 1000; ++i) EXPECT_EQ(exact_sqrt(static_cast<double>(i) * i), i);
}

TEST(Elementary, Exponential) {
  const auto exact = [](Real x) { return std::exp(x); };
  expect_close("exponential", exact_exp, exact, -1.0, 1.0);
  expect_close("exponential", exact_exp, exact, -707.9, 708.9);
  EXPECT_EQ(exact_exp(0.0), 1.0);
  for (const double x : {-708.1, -1000.0, -1e300}) EXPECT_EQ(exact_exp(x), 0.0) << x;
  for (const double x : {709.0, 710.0, 1e300}) EXPECT_EQ(exact_exp(x), exact_exp(709.0)) << x;
}

TEST(Elementary, Logarithm) {
  const auto exact = [](Real x) { return std::log(x); };
  expect_close("logarithm", exact_log, exact, 1e-3, 4.0);
  Worst worst;
  reference::Random random(kSeed);
  for (int i = 0; i < kCount; ++i) {
    worst.look(exact_log, exact, std::exp2(drawn(random, -1021.0, 1023.0)));
    worst.look(exact_log, exact, drawn(random, 0.6, 1.6));
  }
  // Just beside 1, where it is nearly 0.
  for (double beside = 1e-15; beside < 0.1; beside *= 1.01) {
    worst.look(exact_log, exact, 1.0 + beside);
    worst.look(exact_log, exact, 1.0 - beside);
  }
  EXPECT_LE(worst.units, kGreatestUlps) << worst.at << ", seed " << kSeed;
  EXPECT_EQ(exact_log(1.0), 0.0);
  const double least = exact_log(std::numeric_limits<double>::min());
  for (const double none : {0.0, -1.0, 1e-310}) EXPECT_EQ(exact_log(none), least) << none;
}

TEST(Elementary, Arctangent) {
  const auto exact = [](Real x) { return std::atan(x); };
  for (const double reach : {0.25, 1.5, 12.0, 1e4, 1e300})
    expect_close("arctangent", exact_atan, exact, -reach, reach);
  // Around the places where it changes its reduction.
  Worst worst;
  for (const double border : {0.19, 0.369, 0.619, 0.867, 1.22, 1.91, 3.37, 10.1}) {
    for (int i = -1000; i <= 1000; ++i) worst.look(exact_atan, exact, border * (1.0 + i * 1e-15));
  }
  EXPECT_LE(worst.units, kGreatestUlps) << worst.at;
  EXPECT_EQ(exact_atan(0.0), 0.0);
  for (const double x : {1e-3, 0.5, 1.0, 2.0, 1e9}) EXPECT_EQ(exact_atan(-x), -exact_atan(x));
}

// The same in the compiler.
TEST(Elementary, AreTheSameInConstantExpressions) {
  constexpr double in_compiler[] = {exact_sin(1.25), exact_cos(1.25), exact_sqrt(1.25),
                                    exact_exp(1.25), exact_log(1.25), exact_atan(1.25)};
  volatile double x = 1.25;
  const double at_run_time[] = {exact_sin(x), exact_cos(x), exact_sqrt(x),
                                exact_exp(x), exact_log(x), exact_atan(x)};
  for (int i = 0; i < 6; ++i) EXPECT_EQ(in_compiler[i], at_run_time[i]) << i;
}

// First and second derivative against central differences of value and first derivative.
template <class Function>
void expect_derivatives(const std::string& name, const Function& function, double low, double high) {
  reference::Random random(kSeed);
  for (int i = 0; i < 2000; ++i) {
    const double x = drawn(random, low, high), h = 1e-4;
    const Differentiable here = function(Differentiable::argument(x));
    const Differentiable left = function(Differentiable::argument(x - h)),
                         right = function(Differentiable::argument(x + h));
    const double scale = 1.0 + std::fabs(here.first) + std::fabs(here.second);
    EXPECT_NEAR(here.first, (right.value - left.value) / (2 * h), 2e-6 * scale)
        << name << " at " << x << ", seed " << kSeed;
    EXPECT_NEAR(here.second, (right.first - left.first) / (2 * h), 2e-6 * scale)
        << name << " at " << x << ", seed " << kSeed;
  }
}

TEST(Differentiable, FollowsTheChainRule) {
  using D = Differentiable;
  expect_derivatives(
      "polynomial", [](const D& x) { return 1.0 - x * x * (3.0 - 2.0 * x); }, -1, 1);
  expect_derivatives(
      "quotient", [](const D& x) { return (1.0 + x) / (2.0 + x * x); }, -1, 1);
  expect_derivatives(
      "square and sign", [](const D& x) { return -square(x - 0.25) + x; }, -1, 1);
  expect_derivatives(
      "sine", [](const D& x) { return sin(2.0 * x) * cos(x * x); }, -1, 1);
  expect_derivatives(
      "exponential", [](const D& x) { return exp(-x * x) + 1.0 / (1.0 + exp(-4.0 * x)); }, -1, 1);
  expect_derivatives(
      "logarithm", [](const D& x) { return log(1.0 + x * x); }, -1, 1);
  expect_derivatives(
      "square root", [](const D& x) { return sqrt(1.5 + x); }, -1, 1);
  expect_derivatives(
      "arctangent", [](const D& x) { return atan(3.0 * (x - 0.2)); }, -1, 1);
}

TEST(Differentiable, ConstantsDoNotChange) {
  const Differentiable constant = 3.5, x = Differentiable::argument(0.25);
  EXPECT_EQ(constant.first, 0.0);
  EXPECT_EQ(constant.second, 0.0);
  EXPECT_EQ(x.first, 1.0);
  EXPECT_EQ(x.second, 0.0);
  EXPECT_EQ((constant * x).first, 3.5);
  static_assert((Differentiable::argument(2.0) * Differentiable::argument(2.0)).second == 2.0, "");
}

}  // namespace
}  // namespace nearfield
