// expected: deleted function
#include <nearfield/nearfield.hpp>

using Q = nearfield::Fixed<27>;
const nearfield::Sphere<Q> ball{{}, Q(0.5)};
const auto field = nearfield::unite(nearfield::Table<Q, 4>{}, Q(0.1), ball, ball);
