// A keep-out zone as a firmware author would write it, in sources without warning flags of their own.
#include <nearfield/nearfield.hpp>

using Q = nearfield::Fixed<27>;

constexpr auto rounding = nearfield::bake<Q>(nearfield::exterior(nearfield::step::polynomial<3>, 0.25));
constexpr auto cell =
    nearfield::unite(rounding, Q(0.05), nearfield::Box<Q>{{0.0, 0.0, -0.05}, {0.8, 0.6, 0.05}},
                     nearfield::Sphere<Q>{{0.3, 0.2, 0.1}, 0.1});

int main() {
  const auto above = nearfield::clearance(nearfield::field(cell), {0.0, 0.0, 0.5});
  const auto inside = nearfield::clearance(nearfield::field(cell), {0.0, 0.0, -0.05});
  const bool right = above.status == nearfield::ClearanceStatus::clear && above.distance <= Q(0.5) &&
                     above.distance > Q(0.4) && inside.status == nearfield::ClearanceStatus::touching;
  return right ? 0 : 1;
}
