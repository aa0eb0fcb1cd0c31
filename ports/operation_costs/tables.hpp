// Tables that operations sample. How many segments they have does not change what that costs.
#pragma once

#include <nearfield/curve/kernel.hpp>
#include <nearfield/curve/potential.hpp>
#include <nearfield/curve/ray_kernel.hpp>
#include <nearfield/curve/tabulated_form.hpp>

namespace nearfield::costs {

inline constexpr auto kKernel = bake<Fixed<27>>(exterior(step::polynomial<3>, 0.25));
inline constexpr auto kTwoSidedKernel = bake<Fixed<27>>(two_sided(exterior(step::polynomial<3>, 0.25)));
inline constexpr auto kSquaredPotential = bake<Fixed<27>, 2>(over_square(potential::wyvill));
inline constexpr auto kPotential = bake<Fixed<27>, 8>(over_range(potential::Cubic{}));

inline constexpr auto kRoundUnion = profile::super_ellipsoidal_union(2.0);
inline constexpr auto kRoundIntersection = profile::super_ellipsoidal_intersection(2.0);
inline constexpr auto kScaleUnion = profile::scale_union(0.9, 0.6, 0.0);
inline constexpr auto kScaleIntersection = profile::scale_intersection(0.9, 0.6, 0.0);
template <const auto& profile>
inline constexpr auto kProfile = bake<Fixed<27>, 32>(profile);

}  // namespace nearfield::costs
