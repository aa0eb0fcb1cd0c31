// Solid noise and radii that depend on the place, on operands that bring them to their worst paths.
#pragma once

#include <nearfield/curve/radius_profile.hpp>

#include <operation_costs/fields.hpp>

namespace nearfield::costs {

inline constexpr double kRadii[] = {1.0, 1.4, 0.8, 1.2};
inline constexpr auto kAlongProfile = bake<Fixed<27>, 8>(along_profile(ValueSpline(kRadii, 4, false)));
inline constexpr auto kAboutProfile = bake<Fixed<27>, 8>(about_profile(ValueSpline(kRadii, 4, true)));

// Cells finer and coarser than the places' distances, and as many octaves as there may be.
inline void measure_noise() {
  const Fixed<16> frequencies[] = {Fixed<16>(0.015625), Fixed<16>(1.3), Fixed<16>(40.0)};
  for (const Fixed<16> frequency : frequencies) {
    for (uint32_t octaves = 1; octaves <= 4; ++octaves) {
      Trial().operand(kBall).measure(NoiseDistance<Q>{{Q(0.03), frequency, octaves, 17}});
      Trial(kSquaredPotential)
          .operand(SoftPoint<Q>{kPlace, {Q(4.0), Q(1.0)}})
          .measure(NoiseIntensity<Q>{{Q(-0.7), frequency, octaves, 4}});
    }
  }
}

inline void measure_radii() {
  const RayPoint<Q> rays[] = {{kPlace, RayRadius<Q>(Q(0.5))}, {kPlace, RayRadius<Q>(Q(4.0))}};
  const Q lengths[] = {Q(0.015625), Q(0.5), Q(8.0)};
  for (const RayPoint<Q>& ray : rays) {
    for (const Q length : lengths) {
      const Q cut = ray_cut<Q>(kAlongProfile.facts);
      Trial(kAlongProfile).operand(ray).measure(ScaleAlong<Q>(kPlace, {0.6, 0.0, 0.8}, length, cut));
      Trial(kAlongProfile)
          .operand(ray)
          .measure(ScaleAlong<Q>({-2.0, 0.0, 0.0}, {0.36, 0.48, 0.8}, length, cut));
      Trial(kAlongProfile).operand(ray).measure(ScaleFromAxis<Q>(length, cut));
      Trial(kAboutProfile).operand(ray).measure(ScaleAbout<Q>::axis(kAboutProfile.facts, length));
      Trial(kAboutProfile).operand(ray).measure(ScaleAbout<Q>::axis(kAboutProfile.facts, length, Rate(1.37)));
      Trial(kAboutProfile)
          .operand(ray)
          .measure(ScaleAbout<Q>::axis(kAboutProfile.facts, length, Rate(-100.0)));
      Trial(kAboutProfile).operand(ray).measure(ScaleAbout<Q>::circle(kAboutProfile.facts, length, Q{}));
      Trial(kAboutProfile).operand(ray).measure(ScaleAbout<Q>::circle(kAboutProfile.facts, length, Q(0.7)));
    }
  }
}

inline void measure_deformations() {
  measure_noise();
  measure_radii();
}

}  // namespace nearfield::costs
