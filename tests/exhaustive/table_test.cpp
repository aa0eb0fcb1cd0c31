// Baked tables at every argument of a 24-bit grid, against long double.
#include <nearfield/curve/kernel.hpp>
#include <nearfield/curve/potential.hpp>
#include <nearfield/curve/tabulated_form.hpp>
#include <nearfield/modify/sine.hpp>
#include <reference/blends.hpp>

#include <gtest/gtest.h>

#include <cmath>
#include <cstdint>
#include <string>
#include <tuple>
#include <type_traits>

namespace {

using namespace nearfield;
using Real = long double;

constexpr uint32_t kGridBits = 24;
constexpr Real kPiReal = 3.14159265358979323846264338327950288L;

// H_1, H_2, H_3 piece by piece, expanded by hand from Li's recursion.
template <int n>
Real step_of(Real t) {
  if (t <= -1) return 0;
  if (t >= 1) return 1;
  if constexpr (n == 1) return (t + 1) / 2;
  if constexpr (n == 2) return t < 0 ? (t + 1) * (t + 1) / 2 : 1 - (1 - t) * (1 - t) / 2;
  const Real u = 3 * (t + 1) / 2;
  if (u < 1) return u * u * u / 6;
  if (u < 2) return -Real{5} / 8 + 3 * u / 4 - (u - 1.5L) * (u - 1.5L) * (u - 1.5L) / 3;
  return 1 - (3 - u) * (3 - u) * (3 - u) / 6;
}

// h of Li's exterior blend at t = u * range, divided by the range delta + epsilon.
template <int n>
struct ExteriorReference {
  Real delta, epsilon;
  explicit ExteriorReference(Real ratio) : delta(1 / (1 + ratio)), epsilon(ratio / (1 + ratio)) {}
  Real operator()(Real t) const {
    const Real g1 = step_of<n>((t + delta) / epsilon), g2 = step_of<n>((t - delta) / epsilon);
    return ((g1 + g2 - 1) * t + g1 * (1 - g2) * (t * t / delta + delta) / 2 - t) / 2;
  }
};

Real wyvill_of_square(Real u) {
  return 1 - Real{22} / 9 * u + Real{17} / 9 * u * u - Real{4} / 9 * u * u * u;
}
Real quarter_sine(Real u) { return std::sin(kPiReal / 2 * u); }
Real cubic_step_over_unit_interval(Real u) { return step_of<3>(2 * u - 1); }

template <class S>
typename TableArgument<S>::type grid_argument(uint32_t i) {
  if constexpr (ScalarTraits<S>::is_fixed)
    return i << (31 - kGridBits);
  else
    return static_cast<float>(i) * (1.0f / (1u << kGridBits));
}
template <class S>
Real real_of(S x) {
  if constexpr (ScalarTraits<S>::is_fixed)
    return static_cast<Real>(x.raw()) / (int64_t{1} << S::fraction_bits);
  else
    return static_cast<Real>(x);
}

// What was seen of one table.
template <class S>
struct Observation {
  Real error = 0;
  uint32_t worst = 0;
  Unit<S> least_value{}, greatest_value{};
  S least_slope{}, greatest_slope{};
  bool first = true;

  void add(uint32_t i, Real exact, const TableSample<S>& sample) {
    const Real off = std::fabs(real_of(sample.value) - exact);
    if (off > error) {
      error = off;
      worst = i;
    }
    if (first || sample.value < least_value) least_value = sample.value;
    if (first || sample.value > greatest_value) greatest_value = sample.value;
    if (first || sample.slope < least_slope) least_slope = sample.slope;
    if (first || sample.slope > greatest_slope) greatest_slope = sample.slope;
    first = false;
  }
};

template <class S>
const char* scalar_name() {
  if constexpr (std::is_same_v<S, float>)
    return "float";
  else
    return S::fraction_bits == 27 ? "Fixed<27>" : "Fixed<16>";
}

template <class S, int segments>
void expect_facts(const std::string& name, const Table<S, segments>& table, const Observation<S>& seen) {
  SCOPED_TRACE(name + ", " + scalar_name<S>());
  const TableFacts& facts = table.facts;
  std::printf("%-42s %-9s error stated %9.2f observed %9.2Lf units of 2^-30\n", name.c_str(),
              scalar_name<S>(), static_cast<double>(facts.error), std::ldexp(seen.error, 30));
  EXPECT_LE(std::ldexp(seen.error, 30), static_cast<Real>(facts.error)) << "at grid place " << seen.worst;
  EXPECT_GE(std::ldexp(real_of(seen.least_value), 30), static_cast<Real>(facts.least_value));
  EXPECT_LE(std::ldexp(real_of(seen.greatest_value), 30), static_cast<Real>(facts.greatest_value));
  EXPECT_GE(std::ldexp(real_of(seen.least_slope), 24), static_cast<Real>(facts.least_slope));
  EXPECT_LE(std::ldexp(real_of(seen.greatest_slope), 24), static_cast<Real>(facts.greatest_slope));
}

// The last argument below knot number `knot`, and the knot itself.
template <class S, int segments>
void expect_continuity(const std::string& name, const Table<S, segments>& table) {
  constexpr int K = index_bits_for(segments);
  SCOPED_TRACE(name + ", " + scalar_name<S>());
  // A unit of the kernel for float; what forces may jump by for Fixed.
  const Real value_step = ScalarTraits<S>::is_fixed ? std::ldexp(1.0L, -27) : std::ldexp(1.0L, -21);
  Real slope_step = ScalarTraits<S>::is_fixed ? std::ldexp(1.0L, -24) : std::ldexp(8.0L, -21);
  if constexpr (ScalarTraits<S>::is_fixed)
    slope_step = std::fmax(slope_step, std::ldexp(1.0L, -S::fraction_bits));
  for (uint32_t knot = 1; knot < (1u << K); ++knot) {
    TableSample<S> below, at;
    Real apart;
    if constexpr (ScalarTraits<S>::is_fixed) {
      const uint32_t place = knot << (31 - K);
      below = sample_table<true>(table.view(), place - 1);
      at = sample_table<true>(table.view(), place);
      apart = std::ldexp(1.0L, -31);
    } else {
      const float place = static_cast<float>(knot) / static_cast<float>(1u << K);
      const float before = std::nextafter(place, 0.0f);
      below = sample_table<true>(table.view(), before);
      at = sample_table<true>(table.view(), place);
      apart = static_cast<Real>(place) - static_cast<Real>(before);
    }
    // The climb over the distance between the two arguments is no jump.
    const Real climb = std::fmax(std::fabs(real_of(below.slope)), std::fabs(real_of(at.slope))) * apart;
    EXPECT_LE(std::fabs(real_of(at.value) - real_of(below.value)), value_step + climb) << "knot " << knot;
    EXPECT_LE(std::fabs(real_of(at.slope) - real_of(below.slope)), slope_step) << "knot " << knot;
  }
}

// One table and what was seen of it.
template <class S, int K>
struct TableCheck {
  Table<S, 1 << K> table;
  Observation<S> seen;

  template <class Function>
  explicit TableCheck(const Function& function) : table(bake<S, 1 << K>(function)) {}
  void add(uint32_t i, Real truth) {
    seen.add(i, truth, sample_table<true>(table.view(), grid_argument<S>(i)));
  }
  void expect(const std::string& name) const {
    const std::string full_name = name + ", " + std::to_string(1 << K) + " segments";
    expect_facts(full_name, table, seen);
    expect_continuity(full_name, table);
  }
};

// `function` as baked into tables of each of the sizes, `exact` as defined: evaluated once for all tables.
template <int... K, class Function, class Exact>
void expect_tables(const std::string& name, const Function& function, const Exact& exact) {
  std::tuple<TableCheck<Fixed<27>, K>...> fine{TableCheck<Fixed<27>, K>(function)...};
  std::tuple<TableCheck<Fixed<16>, K>...> coarse{TableCheck<Fixed<16>, K>(function)...};
  std::tuple<TableCheck<float, K>...> floating{TableCheck<float, K>(function)...};
  const auto all = std::tuple_cat(std::tie(std::get<TableCheck<Fixed<27>, K>>(fine)...),
                                  std::tie(std::get<TableCheck<Fixed<16>, K>>(coarse)...),
                                  std::tie(std::get<TableCheck<float, K>>(floating)...));
  for (uint32_t i = 0; i < 1u << kGridBits; ++i) {
    const Real truth = exact(static_cast<Real>(i) / (1u << kGridBits));
    std::apply([i, truth](auto&... check) { (check.add(i, truth), ...); }, all);
  }
  std::apply([&name](const auto&... check) { (check.expect(name), ...); }, all);
}

template <int n>
void expect_exterior(double ratio, const char* ratio_text) {
  const std::string name = "exterior, step " + std::to_string(n) + ", ratio " + ratio_text;
  const auto kernel = exterior(step::polynomial<n>, ratio);
  const ExteriorReference<n> exact{static_cast<Real>(ratio)};
  expect_tables<5, 6>(name, kernel, exact);
}

TEST(ReferenceOfTables, AgreesWithTheRecursion) {
  for (int i = -50; i <= 50; ++i) {
    const Real t = static_cast<Real>(i) / 41;
    EXPECT_NEAR(static_cast<double>(step_of<1>(t) - reference::polynomial_step(1, t)), 0.0, 1e-17);
    EXPECT_NEAR(static_cast<double>(step_of<2>(t) - reference::polynomial_step(2, t)), 0.0, 1e-17);
    EXPECT_NEAR(static_cast<double>(step_of<3>(t) - reference::polynomial_step(3, t)), 0.0, 1e-17);
  }
  const reference::UnitStep cubic{reference::StepKind::polynomial, 3, 0};
  for (int i = 0; i <= 100; ++i) {
    const Real t = static_cast<Real>(i) / 100;
    const Real delta = 0.8L, epsilon = 0.2L;
    const Real expected = (reference::smooth_absolute(cubic, delta, epsilon, t) - t) / 2;
    EXPECT_NEAR(static_cast<double>(ExteriorReference<3>(0.25L)(t) - expected), 0.0, 1e-17);
  }
}

TEST(Table, ExteriorOfLinearStep) {
  expect_exterior<1>(0.25, "0.25");
  expect_exterior<1>(1.0, "1");
}
TEST(Table, ExteriorOfQuadraticStep) {
  expect_exterior<2>(0.25, "0.25");
  expect_exterior<2>(1.0, "1");
}
TEST(Table, ExteriorOfCubicStep) {
  expect_exterior<3>(0.25, "0.25");
  expect_exterior<3>(1.0, "1");
}
TEST(Table, WyvillOverTheSquare) { expect_tables<1>("wyvill", over_square(potential::wyvill), wyvill_of_square); }
TEST(Table, QuarterSine) { expect_tables<6>("quarter sine", detail::QuarterSine{}, quarter_sine); }
TEST(Table, CubicStepOverTheUnitInterval) {
  expect_tables<5>("cubic step", step::over_unit_interval(step::polynomial<3>),
                   cubic_step_over_unit_interval);
}

// A function that leaves the range of a table is marked, so that no certificate accepts it.
TEST(Table, FunctionsThatDoNotFitAreMarked) {
  const auto steep = [](const Differentiable& u) { return 20.0 * (u - 0.5); };
  const auto tall = [](const Differentiable& u) { return 2.5 + u; };
  EXPECT_EQ((bake<Fixed<27>, 8>(steep).facts.error), greatest_of<int32_t>);
  EXPECT_EQ((bake<Fixed<27>, 8>(tall).facts.error), greatest_of<int32_t>);
  EXPECT_EQ((bake<float, 8>(tall).facts.error), greatest_of<int32_t>);
}

template <class S>
Real greatest_sine_error(S angle, Real unit) {
  const SineCosine<S> found = sine_cosine(angle);
  const Real exact = real_of(angle);
  return std::fmax(std::fabs(real_of(found.sine) - std::sin(exact)),
                   std::fabs(real_of(found.cosine) - std::cos(exact))) /
         unit;
}

TEST(SineCosineSweep, FixedWithin16Radians) {
  const Real unit = std::ldexp(1.0L, -30);
  Real greatest = 0;
  for (int64_t raw = least_of<int32_t>; raw <= greatest_of<int32_t>; raw += 1399) {
    greatest = std::fmax(greatest, greatest_sine_error(Fixed<27>::from_raw(static_cast<int32_t>(raw)), unit));
  }
  // Around the multiples of a quarter turn.
  for (int quarter = -10; quarter <= 10; ++quarter) {
    const auto middle = static_cast<int32_t>(std::llround(std::ldexp(quarter * kPiReal / 2, 27)));
    for (int32_t d = -20000; d <= 20000; ++d) {
      greatest = std::fmax(greatest, greatest_sine_error(Fixed<27>::from_raw(middle + d), unit));
    }
  }
  std::printf("sine and cosine, Fixed<27>: stated %u observed %.2Lf units of 2^-30\n", kSineErrorUnits,
              greatest);
  EXPECT_LE(greatest, static_cast<Real>(kSineErrorUnits));

  greatest = 0;
  for (int32_t raw = -(16 << 16); raw <= 16 << 16; ++raw) {
    greatest = std::fmax(greatest, greatest_sine_error(Fixed<16>::from_raw(raw), unit));
  }
  std::printf("sine and cosine, Fixed<16>: stated %u observed %.2Lf units of 2^-30\n", kSineErrorUnits,
              greatest);
  EXPECT_LE(greatest, static_cast<Real>(kSineErrorUnits));
}

TEST(SineCosineSweep, FloatWithin16Radians) {
  const Real unit = std::ldexp(1.0L, -21);
  Real greatest = 0;
  for (int32_t i = -(1 << 24); i <= 1 << 24; i += 13) {
    greatest = std::fmax(greatest, greatest_sine_error(static_cast<float>(i) * (1.0f / (1 << 20)), unit));
  }
  for (float angle = 16.0f; angle > 1e-30f; angle *= 0.999f) {
    greatest = std::fmax(greatest, greatest_sine_error(angle, unit));
    greatest = std::fmax(greatest, greatest_sine_error(-angle, unit));
  }
  std::printf("sine and cosine, float: stated %u observed %.2Lf units of 2^-21\n", kSineErrorUnits, greatest);
  EXPECT_LE(greatest, static_cast<Real>(kSineErrorUnits));
}

TEST(SineCosineSweep, NoAngleIsTheAngleZero) {
  for (const float angle : {std::nanf(""), HUGE_VALF, -HUGE_VALF, 1024.0f, -1e30f}) {
    EXPECT_EQ(sine_cosine(angle).sine, sine_cosine(0.0f).sine);
    EXPECT_EQ(sine_cosine(angle).cosine, sine_cosine(0.0f).cosine);
  }
}

}  // namespace
