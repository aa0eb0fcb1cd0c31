// expected: the curve's parameters are out of range
#include <nearfield/nearfield.hpp>

using namespace nearfield;

constexpr potential::ParametricBezierPoints parametric{1.3, 1.0, -0.2, 0.0};
constexpr auto table = tabulate<Fixed<27>, parametric, Within<8>>();
