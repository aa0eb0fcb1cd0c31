// expected: the curve's parameters are out of range
#include <nearfield/nearfield.hpp>

using namespace nearfield;

constexpr ParameterValues points[] = {{4, {0, 0.4, 0.5, 1}}, {4, {1, 0.99, 0.01, 0}}};
constexpr auto spline = potential::NaturalSpline::from(points);
constexpr auto table = tabulate<Fixed<27>, spline, Within<12>>();
