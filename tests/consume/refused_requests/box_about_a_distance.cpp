// expected: an operand is of the wrong kind
#include <nearfield/nearfield.hpp>

using Q = nearfield::Fixed<27>;
const auto field = nearfield::in_box({Q(1.0), Q(1.0), Q(1.0)}, nearfield::Sphere<Q>{{}, Q(0.5)});
