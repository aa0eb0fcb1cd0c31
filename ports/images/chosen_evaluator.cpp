// Programs of a chosen list of operations: four shapes, sharp set operations, frames.
#include <images/evaluator.hpp>

namespace {

using namespace nearfield;
using images::Q;

using Chosen = OnlyOperations<Operation::sphere, Operation::capsule, Operation::box, Operation::cylinder,
                              Operation::sharp_union, Operation::sharp_intersection, Operation::sharp_subtraction>;
constexpr auto kImage = [] {
  ImageBuilder<Q, 128, Chosen> image;
  image.operation(Sphere<Q>{{0.1, 0.2, 0.0}, 0.3}).operation(Box<Q>{{0.5, 0.0, 0.1}, {0.3, 0.2, 0.4}});
  image.operation(SharpUnion<Q>{});
  image.enter(Pose<Q>{}).operation(Cylinder<Q>{{-0.5, -0.4, 0.0}, 0.2, 0.5}).leave().operation(SharpUnion<Q>{});
  image.operation(Capsule<Q>(Vector3<Q>{-0.3, 0.1, 0.0}, Vector3<Q>{0.4, 0.2, 0.3}, Q(0.1))).operation(SharpSubtraction<Q>{});
  image.finish();
  return image;
}();

}  // namespace

int main() {
  const int status = images::run<Chosen>(kImage);
  board::report_stack();
  return status;
}
