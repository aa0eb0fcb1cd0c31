// expected: the curve is too steep for a table of this size
#include <nearfield/nearfield.hpp>

using namespace nearfield;

constexpr auto steep = [](const Differentiable& x) { return 0.5 + 0.5 * sin(200.0 * x); };
constexpr auto table = tabulate<Fixed<27>, steep, Exactly<3, 4>>();
