// expected: no table of the size asked for comes within the error asked for
#include <nearfield/nearfield.hpp>

using namespace nearfield;

constexpr potential::Arctangent arctangent{100, 0.5};
constexpr auto table = tabulate<Fixed<27>, arctangent>();
