// Operands that bring the solids beyond the common ones, and offsets, to their worst paths.
#pragma once

#include <operation_costs/fields.hpp>

namespace nearfield::costs {

inline void measure_solids() {
  const Vector3<Q> low = {-0.3, 0.1, 0.0}, high = {0.4, 0.2, 0.3};
  // A side that leans either way, hardly, and almost as much as it can; a ball alone.
  Trial().measure(TaperedCapsule<Q>(low, high, 0.3, 0.1));
  Trial().measure(TaperedCapsule<Q>(low, high, 0.1, 0.3));
  Trial().measure(TaperedCapsule<Q>(low, high, 0.1, 0.1));
  Trial().measure(TaperedCapsule<Q>(low, high, 0.75, 0.0));
  Trial().measure(TaperedCapsule<Q>(low, high, 0.0, 0.75));
  Trial().measure(TaperedCapsule<Q>(low, high, 1.0, 0.1));
  Trial().measure(TaperedCapsule<Q>(low, high, 0.1, 1.0));
  Trial().measure(ConeFrustum<Q>(kPlace, 0.3, 0.1, 0.4));
  Trial().measure(ConeFrustum<Q>(kPlace, 0.0, 1.0, 0.25));
  Trial().measure(ConeFrustum<Q>({}, 1.0, 1.0, 1.0));
  Trial().measure(Torus<Q>{kPlace, 0.5, 0.1});
  Trial().measure(Torus<Q>{{}, 1.0, 0.0});
  Trial().measure(Disc<Q>{kPlace, 0.5, 0.1});
  Trial().measure(Disc<Q>{{}, 1.0, 0.0});
  Trial().measure(HalfSpace<Q>{kPlace, {0.6, 0.0, 0.8}});
  Trial().measure(InfiniteCylinder<Q>{0.1, 0.2, 0.3});
  Trial().measure(InfiniteCone<Q>{kPlace, 0.6, 0.8});
  Trial().measure(InfiniteCone<Q>{{}, 0.0, 1.0});
  Trial().measure(InfiniteCone<Q>{{}, 1.0, 0.0});
  Trial().operand(kBall).measure(Offset<Q>{0.1});
}

}  // namespace nearfield::costs
