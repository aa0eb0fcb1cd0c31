// expected: no table of the size asked for comes within the error asked for
#include <nearfield/nearfield.hpp>

using namespace nearfield;

constexpr potential::Cubic cubic{};
constexpr auto table = tabulate<Fixed<27>, cubic, Within<20, 8>>();
