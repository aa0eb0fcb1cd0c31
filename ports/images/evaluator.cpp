// Programs of every operation, with those that take the most stack.
#include <images/evaluator.hpp>

namespace {

using namespace nearfield;
using images::Q;

constexpr auto solids() {
  ImageBuilder<Q, 320> image;
  const Vector3<Q> points[] = {{-0.3, 0.1, 0.0}, {0.1, 0.2, 0.3}, {0.3, -0.1, 0.1}, {0.5, 0.2, -0.2}};
  Vector3<Q> control[16];
  for (int i = 0; i < 16; ++i) control[i] = {Q::from_raw((i / 4) << 24), Q::from_raw((i % 4) << 24), Q::from_raw(i << 20)};
  const Q outline_x[] = {Q(1.0), Q(0.5), Q(0.1), Q(-0.4)}, outline_y[] = {Q(0.0), Q(0.4), Q(1.1), Q(0.3)};
  image.operation(CubicCurve<Q>(points, 4, Q(0.1)));
  image.enter(Pose<Q>{}).operation(BicubicPatch<Q>(control, Q(0.1))).leave().operation(SharpUnion<Q>{});
  image.operation(Polygon<Q>(outline_x, outline_y, 4, Q(0.1), Q(0.05))).operation(SharpUnion<Q>{});
  const AlgebraicPlane<Q> plane = {{0.75, -0.25, 0.125}, 0.0625}, other = {{-0.25, 0.5, 0.375}, 0.125};
  RibbonPatch<Q> patch;
  patch.side_count = 3;
  patch.exponent = 2;
  for (Q& weight : patch.side_weight) weight = Q(0.5);
  image.enter_box({4.0, 4.0, 4.0});
  for (int i = 0; i < 3; ++i) image.operation(plane).operation(other);
  image.operation(patch).operation(RaySweep<Q>({}, {0.5, 0.3, 0.4}, Rate(2.0), Rate(2.5), 1.5, 1.0, 0.7));
  image.operation(AlgebraicOfRay<Q>{Q(0.5), Q(1.0)}).operation(AlgebraicUnion<Q>{});
  image.leave_box(DeclaredBox<Q>({4.0, 4.0, 4.0}, Rate(100.0))).operation(SharpUnion<Q>{});
  image.finish();
  return image;
}
constexpr auto soft_point() {
  ImageBuilder<Q, 64> image;
  constexpr auto potential = bake<Q, 2>(over_square(potential::wyvill));
  const uint32_t table = image.table(potential);
  image.operation(SoftPoint<Q>{{}, Influence<Q>(Q(1.5), Q(1.0))}, table);
  image.operation(NoiseIntensity<Q>{{Q(0.03), Fixed<16>(1.3), 4, 17}});
  image.finish();
  return image;
}
constexpr auto kSolids = solids();
constexpr auto kSoftPoint = soft_point();

}  // namespace

int main() {
  int status = images::run<AllOperations>(kSolids);
  status += images::run<AllOperations>(kSoftPoint);
  board::report_stack();
  return status;
}
