// expected: only distances have a clearance: declare a box for an algebraic field
#include <nearfield/nearfield.hpp>

using Q = nearfield::Fixed<27>;
const auto plane = nearfield::field(nearfield::AlgebraicPlane<Q>{{Q(1.0), {}, {}}, {}});
const auto answer = nearfield::clearance(plane, {Q(1.0), {}, {}});
