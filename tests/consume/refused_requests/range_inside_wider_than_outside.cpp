// expected: the curve's parameters are out of range
#include <nearfield/nearfield.hpp>

using namespace nearfield;

constexpr auto range = potential::with_range_control(potential::Cubic{}, 0.4, 0.5);
constexpr auto table = tabulate<Fixed<27>, range, Within<12>>();
