// Algebraic fields as compositions and as programs: the same bits.
#include "algebraic_samples.hpp"

#include <nearfield/field/builder.hpp>
#include <nearfield/field/program.hpp>

namespace {

using namespace nearfield;
using namespace nearfield::test;
using reference::announced_seed;

template <class S>
class AlgebraicProgramOf : public testing::Test {};
using ProgramScalars = testing::Types<Fixed<27>, float>;
TYPED_TEST_SUITE(AlgebraicProgramOf, ProgramScalars, );

template <class Out>
bool same_bits(const Out& a, const Out& b) {
  if constexpr (Out::has_gradient)
    return a.value == b.value && a.gradient == b.gradient;
  else
    return a.value == b.value;
}

// That a composition and the program which `write` makes of it agree to the bit at random points.
template <class S, class Node, class Write>
void expect_same_program(const Node& node, const Write& write, Random& random, Real reach) {
  ImageBuilder<S, 600> builder;
  write(builder);
  const LoadStatus status = builder.finish().status;
  ASSERT_EQ(status, LoadStatus::ok) << static_cast<int>(status);
  const Program<S> program = load<S>(builder.words(), builder.size() * 4);
  ASSERT_TRUE(program.valid());
  const Field<Node> composed(node);
  ASSERT_TRUE(composed.valid());
  EXPECT_EQ(program.kind(), Field<Node>::kind());
  EXPECT_EQ(program.certificate().lipschitz, composed.certificate().lipschitz);
  EXPECT_EQ(program.certificate().error, composed.certificate().error);
  EXPECT_EQ(program.certificate().magnitude, composed.certificate().magnitude);
  for (int i = 0; i < 200; ++i) {
    const Vector3<S> p = vector<S>(random.vector(-reach, reach));
    ASSERT_TRUE(same_bits(program.template evaluate<Sample<S>>(p, nullptr),
                          composed.template evaluate<Sample<S>>(p, nullptr)));
    ASSERT_TRUE(same_bits(program.template evaluate<Value<S>>(p, nullptr),
                          composed.template evaluate<Value<S>>(p, nullptr)));
  }
}

TYPED_TEST(AlgebraicProgramOf, SplinesAndConversions) {
  using S = TypeParam;
  Random random(announced_seed("SplinesAndConversions", 46));
  const Quadric<S> quadric = random_quadric(random).as<S>();
  const AlgebraicPlane<S> plane = random_plane(random).as<S>();
  const Sphere<S> ball = {vector<S>({0.1L, 0.2L, -0.1L}), number<S>(0.5L)};
  const AlgebraicOfDistance<S> conversion = {number<S>(0.5L)};
  FunctionalSpline<S> spline;
  spline.primary_count = 3;
  spline.bound_count = 2;
  spline.lambda = number<S>(0.25L);
  Pose<S> pose;
  pose.translation.x = number<S>(0.25L);
  const auto least = combine(AlgebraicUnion<S>{}, quadric, plane);
  const auto greatest = place(pose, combine(AlgebraicIntersection<S>{}, quadric, plane));
  const auto node = combine(spline, quadric, combine(conversion, ball), least, greatest, plane);
  expect_same_program<S>(
      node,
      [&](auto& b) {
        b.operation(quadric).operation(ball).operation(conversion);
        b.operation(quadric).operation(plane).operation(AlgebraicUnion<S>{});
        b.enter(pose).operation(quadric).operation(plane).operation(AlgebraicIntersection<S>{}).leave();
        b.operation(plane).operation(spline);
      },
      random, 2);
}

// Two-operand blends, and both patches with eight sides: the deepest stack that a program may need.
TYPED_TEST(AlgebraicProgramOf, ConicsAndPatches) {
  using S = TypeParam;
  Random random(announced_seed("ConicsAndPatches", 47));
  const S half = number<S>(0.5L);
  const Quadric<S> q = random_quadric(random).as<S>();
  const AlgebraicPlane<S> p = random_plane(random).as<S>();
  const auto united = HoffmannHopcroftUnion<S>::of(half, number<S>(0.25L), number<S>(-0.5L));
  const auto common = HoffmannHopcroftIntersection<S>::of(half, half, S{});
  const auto without = HoffmannHopcroftDifference<S>::of(half, half, half);
  const RaySegment<S> ray = {Capsule<S>({}, {half, {}, {}}, S{}), RayRadius<S>(half)};
  const AlgebraicOfRay<S> of_ray = {half, number<S>(0.25L)};
  const auto conics = combine(without, combine(common, combine(united, q, p), q), combine(of_ray, ray));
  expect_same_program<S>(
      conics,
      [&](auto& b) {
        b.operation(q).operation(p).operation(united).operation(q).operation(common);
        b.operation(ray).operation(of_ray).operation(without);
      },
      random, 1);

  RibbonPatch<S> ribbons;
  ribbons.side_count = 8;
  ribbons.exponent = 3;
  for (S& weight : ribbons.side_weight) weight = half;
  ribbons.centre_weight = half;
  CornerPatch<S> corners;
  corners.side_count = 8;
  for (S& weight : corners.side_weight) weight = half;
  AlgebraicPlane<S> bound[8] = {};
  for (AlgebraicPlane<S>& plane : bound) plane = random_plane(random).as<S>();
  const auto* b = bound;
  const auto write = [&](auto& builder, const auto& patch, bool alternating) {
    for (int i = 0; i < 8; ++i) {
      if (alternating)
        builder.operation(q).operation(bound[i]);
      else
        builder.operation(q);
    }
    for (int i = 0; i < 8 && !alternating; ++i) builder.operation(bound[i]);
    builder.operation(patch);
  };
  expect_same_program<S>(
      combine(ribbons, q, b[0], q, b[1], q, b[2], q, b[3], q, b[4], q, b[5], q, b[6], q, b[7]),
      [&](auto& builder) { write(builder, ribbons, true); }, random, 1);
  expect_same_program<S>(
      combine(corners, q, q, q, q, q, q, q, q, b[0], b[1], b[2], b[3], b[4], b[5], b[6], b[7]),
      [&](auto& builder) { write(builder, corners, false); }, random, 1);
}

// Parameters that a payload derives from others, counts, and operands of another kind.
TYPED_TEST(AlgebraicProgramOf, WhatDoesNotFitIsRefused) {
  using S = TypeParam;
  const S half = number<S>(0.5L);
  const AlgebraicPlane<S> plane = {{half, {}, {}}, {}};
  const auto status = [&](const auto& write) {
    ImageBuilder<S, 600> builder;
    write(builder);
    return builder.finish().status;
  };
  auto conic = HoffmannHopcroftUnion<S>::of(half, half, S{});
  const auto with_conic = [&](auto& b) { b.operation(plane).operation(plane).operation(conic); };
  EXPECT_EQ(status(with_conic), LoadStatus::ok);
  conic.depth = half + half;
  EXPECT_EQ(status(with_conic), LoadStatus::parameter_out_of_range);
  RibbonPatch<S> patch;
  const auto with_patch = [&](auto& b) {
    for (int i = 0; i < 6; ++i) b.operation(plane);
    b.operation(patch);
  };
  patch.side_count = 3;
  EXPECT_EQ(status(with_patch), LoadStatus::ok);
  for (const uint32_t count : {0u, 2u, 4u, 0x80000003u}) {
    patch.side_count = count;
    EXPECT_EQ(status(with_patch), LoadStatus::kind_mismatch) << count;
  }
  const Sphere<S> ball = {{}, half};
  EXPECT_EQ(status([&](auto& b) { b.operation(ball).operation(plane).operation(AlgebraicUnion<S>{}); }),
            LoadStatus::kind_mismatch);
  EXPECT_EQ(status([&](auto& b) { b.operation(plane).operation(AlgebraicOfDistance<S>{half}); }),
            LoadStatus::kind_mismatch);
  EXPECT_EQ(status([&](auto& b) { b.operation(ball).operation(AlgebraicOfRay<S>{}); }),
            LoadStatus::kind_mismatch);
  EXPECT_EQ(status([&](auto& b) { b.operation(ball).operation(AlgebraicOfDistance<S>{S{}}); }),
            LoadStatus::parameter_out_of_range);
}

}  // namespace
