// Potential functions of soft objects: from 1 at the skeleton to 0 at the influence radius (KW, Hsu).
// Exact forms in `double`, for baking: never linked into a target.
#pragma once

#include <nearfield/table/bake.hpp>

namespace nearfield::potential {

// 1 - (22/9) r^2 + (17/9) r^4 - (4/9) r^6 as a function of u = r^2 in [0, 1]; P(1/2) = 1/2, order 1 (KW).
// A cubic in u: its table is exact up to rounding.
struct Wyvill {
  constexpr ExactSample operator()(double u) const {
    return {((-4.0 / 9.0 * u + 17.0 / 9.0) * u - 22.0 / 9.0) * u + 1.0, (-12.0 / 9.0 * u + 34.0 / 9.0) * u - 22.0 / 9.0};
  }
};

inline constexpr Wyvill wyvill{};

}  // namespace nearfield::potential
