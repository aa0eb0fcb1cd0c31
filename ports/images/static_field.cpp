// Clearances to a static field of four shapes.
#include <nearfield/nearfield.hpp>

#include <images/report.hpp>

namespace {

using namespace nearfield;
using Q = Fixed<27>;

constexpr auto kField = field(unite(unite(Sphere<Q>{{0.1, 0.2, 0.0}, 0.3}, Box<Q>{{0.5, 0.0, 0.1}, {0.3, 0.2, 0.4}}),
                                    unite(Capsule<Q>(Vector3<Q>{-0.3, 0.1, 0.0}, Vector3<Q>{0.4, 0.2, 0.3}, Q(0.1)),
                                          Cylinder<Q>{{-0.5, -0.4, 0.0}, 0.2, 0.5})));
static_assert(kField.valid());

volatile int32_t coordinate, sink;

}  // namespace

int main() {
  for (int32_t i = 0; i < 100; ++i) {
    coordinate = i * 2654435;
    const Vector3<Q> p = {Q::from_raw(coordinate), Q::from_raw(-coordinate), Q::from_raw(coordinate / 2)};
    const Clearance<Q> c = clearance(kField, p);
    sink = c.distance.raw();
    sink = c.direction.x.raw();
    sink = c.direction.y.raw();
    sink = c.direction.z.raw();
  }
  board::report_stack();
  return 0;
}
