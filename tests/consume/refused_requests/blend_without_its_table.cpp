// expected: this operation needs a table
#include <nearfield/nearfield.hpp>

using Q = nearfield::Fixed<27>;
const nearfield::Sphere<Q> ball{{}, Q(0.5)};
const auto field = nearfield::combine(nearfield::AdditiveUnion<Q>{nearfield::ArgumentScale<Q>::of(Q(0.1))}, ball, ball);
