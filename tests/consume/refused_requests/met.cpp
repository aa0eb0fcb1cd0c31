// Compiles: requests like those beside, with parameters that are allowed.
#include <nearfield/nearfield.hpp>

using namespace nearfield;

constexpr ParameterValues points[] = {{4, {0, 0.4, 0.6, 1}}, {4, {1, 0.7, 0.3, 0}}};
constexpr auto spline = potential::NaturalSpline::from(points);
constexpr potential::ParametricBezierPoints parametric{0.6, 1.0, 0.4, 0.0};
constexpr auto range = potential::with_range_control(potential::Cubic{}, 0.5, 0.4);
constexpr potential::Arctangent arctangent{5, 0.5};
constexpr auto own = [](const Differentiable& x) { return 0.5 + 0.5 * sin(2.0 * x); };

static_assert(tabulate<Fixed<27>, spline, Within<12>>().error > 0, "");
static_assert(tabulate<Fixed<27>, parametric, Within<12>>().error > 0, "");
static_assert(tabulate<Fixed<27>, range, Within<12>>().error > 0, "");
static_assert(tabulate<Fixed<27>, arctangent>().error > 0, "");
static_assert(tabulate<Fixed<27>, own, Exactly<3, 4>>().error > 0, "");
