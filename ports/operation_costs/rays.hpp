// Ray functions, sweeps and the quartic of a torus on their worst paths.
#pragma once

#include <operation_costs/fields.hpp>

namespace nearfield::costs {

inline void measure_slabs_and_distances() {
  const Q radii[] = {Q(0.015625), Q(0.7), Q(4.0)};
  for (const Q radius : radii) {
    const RayRadius<Q> influence(radius);
    Trial().measure(RaySlab<Q>{kPlace, {0.6, 0.0, 0.8}, influence});
    Trial().operand(kBall).measure(RayOfDistance<Q>{influence});
    Trial().operand(Box<Q>{{}, {1.0, 1.0, 1.0}}).measure(RayOfDistance<Q>{influence});
  }
}

// Convex and pinched, as a superquadric, growing, turning, and both at once.
inline void measure_sweeps() {
  const Rate exponents[] = {Rate(0.25), Rate(2.0), Rate(7.3)};
  for (const Rate exponent : exponents) {
    const Vector3<Q> radii = {0.5, 0.3, 0.4};
    Trial().measure(RaySweep<Q>(kPlace, radii, exponent, Rate(2.5)));
    Trial().measure(RaySweep<Q>(kPlace, radii, Rate(2.5), exponent, 1.5, 0.0, 0.7));
    Trial().measure(RaySweep<Q>(kPlace, radii, exponent, Rate(2.5), 1.5, -3.0, 1.0));
    Trial().measure(RaySweep<Q>({-0.2, 0.1, -1.0}, radii, exponent, exponent, 2.5, 4.0, 1.5));
    Trial().measure(RaySweep<Q>({-0.2, 0.1, -2.0}, {3.0, 3.5, 2.0}, exponent, Rate(1.2), 8.0, -4.0, 0.9));
  }
}

inline void measure_tori() {
  Trial().measure(AlgebraicTorus<Q>(kPlace, 0.3, 0.1));
  Trial().measure(AlgebraicTorus<Q>(kPlace, 4.0, 1.0, 8.0));
  Trial().measure(AlgebraicTorus<Q>({}, 1.0, 0.5, 0.015625));
}

inline void measure_ray_functions() {
  measure_slabs_and_distances();
  measure_sweeps();
  measure_tori();
}

}  // namespace nearfield::costs
