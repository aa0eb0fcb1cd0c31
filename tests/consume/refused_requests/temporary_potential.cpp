// expected: deleted function
#include <nearfield/nearfield.hpp>

using Q = nearfield::Fixed<27>;
const nearfield::SoftPoint<Q> point{{}, nearfield::Influence<Q>(Q(0.5), Q(1.0))};
const auto field = nearfield::with_potential(
    point, nearfield::bake<Q, 2>(nearfield::over_square(nearfield::potential::wyvill)));
