// expected: an operand is of the wrong kind
#include <nearfield/nearfield.hpp>

using Q = nearfield::Fixed<27>;
const auto field = nearfield::unite(nearfield::Sphere<Q>{{}, Q(0.5)}, nearfield::RayPoint<Q>{{}, nearfield::RayRadius<Q>(Q(0.5))});
