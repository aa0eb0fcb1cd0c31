// expected: an operand is of the wrong kind
#include <nearfield/nearfield.hpp>

using Q = nearfield::Fixed<27>;
constexpr auto potential = nearfield::bake<Q, 2>(nearfield::over_square(nearfield::potential::wyvill));
const auto soft = nearfield::combine(nearfield::SoftPoint<Q>{{}, nearfield::Influence<Q>(Q(0.5), Q(1.0))}, potential);
const auto field = nearfield::soft_sum(soft, nearfield::AlgebraicPlane<Q>{{Q(1.0), {}, {}}, {}});
