/// Clearances of algebraic fields in declared boxes.

#include <nearfield/curve/kernel.hpp>
#include <nearfield/curve/potential.hpp>
#include <nearfield/field/builder.hpp>
#include <nearfield/field/compose.hpp>
#include <nearfield/field/program.hpp>
#include <nearfield/query/clearance.hpp>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "property/conversion.hpp"
#include "reference/random.hpp"

namespace nearfield {
namespace {

using property::real;
using property::rounded;
using reference::Random;
using reference::Real;
using reference::Vec3;

/// |p - c|^2 - r^2, a quarter of it, so that it fits into a small box.
template <class S>
Quadric<S> ball(const Vec3& c, Real r) {
  const S quarter(static_cast<S>(0.25));
  Quadric<S> quadric;
  quadric.diagonal = {quarter, quarter, quarter};
  quadric.linear = rounded<S>(-0.5L * c);
  quadric.constant = rounded<S>(0.25L * (reference::dot(c, c) - r * r));
  return quadric;
}

template <class S>
void expect_never_above(std::uint64_t seed) {
  Random random(seed);
  Real greatest = 0;
  int clear = 0;
  for (int trial = 0; trial < 400; ++trial) {
    const Vec3 half{random.uniform(0.3L, 1), random.uniform(0.3L, 1), random.uniform(0.3L, 1)};
    const Vec3 c = random.vector(-0.5L, 0.5L);
    const Real r = random.uniform(0.05L, 0.4L);
    const auto boxed = field(in_box(rounded<S>(half), ball<S>(c, r)));
    ASSERT_TRUE(boxed.valid());
    for (int k = 0; k < 60; ++k) {
      const Vector3<S> p = rounded<S>(random.vector(-1.2L, 1.2L));
      const Vec3 at = real(p);
      const Clearance<S> answer = clearance(boxed, p);
      const bool inside = std::fabs(at.x) < half.x && std::fabs(at.y) < half.y && std::fabs(at.z) < half.z;
      if (!inside) {
        ASSERT_EQ(answer.status, ClearanceStatus::undecided);
        continue;
      }
      const Real truth = reference::distance(at, c) - r;
      if (answer.status == ClearanceStatus::clear) {
        ++clear;
        ASSERT_LE(real(answer.distance), truth);
        greatest = std::max(greatest, real(answer.distance) / truth);
      }
      if (answer.status == ClearanceStatus::touching) {
        ASSERT_LE(truth, 0);
      }
    }
  }
  EXPECT_GT(clear, 3000);
  // The gradient is bounded by its greatest in the box.
  EXPECT_GT(greatest, 0.4L);
  std::printf("%d clear; greatest share of the true distance %.3Lf\n", clear, greatest);
}

TEST(DeclaredBox, IsNeverAboveTheTrueDistance) {
  const std::uint64_t seed = reference::announced_seed("IsNeverAboveTheTrueDistance", 431);
  expect_never_above<Fixed<27>>(seed);
  expect_never_above<Fixed<16>>(seed);
  expect_never_above<float>(seed);
}

TEST(DeclaredBox, HasTheGradientOfItsValue) {
  using S = Fixed<27>;
  const auto boxed = field(in_box({S(1.0), S(1.0), S(1.0)}, ball<S>({0.1L, 0, 0}, 0.3L)));
  Random random(reference::announced_seed("HasTheGradientOfItsValue", 432));
  for (int i = 0; i < 500; ++i) {
    const Vec3 at = random.vector(-0.95L, 0.95L);
    const Vector3<S> gradient = boxed.evaluate<Sample<S>>(rounded<S>(at), nullptr).gradient;
    const Vec3 step{1e-3L, 0, 0};
    const auto value = [&](const Vec3& p) {
      return real(boxed.evaluate<Value<S>>(rounded<S>(p), nullptr).value);
    };
    const Real ahead = (value(at + step) - value(at)) / 1e-3L;
    const Real behind = (value(at) - value(at - step)) / 1e-3L;
    if (std::fabs(ahead - behind) > 2e-3L) continue;  // at an edge of the box's depth
    EXPECT_NEAR(static_cast<double>(real(gradient).x), static_cast<double>(ahead + behind) / 2, 1e-3);
  }
}

TEST(DeclaredBox, IsTheSameInPrograms) {
  using S = Fixed<27>;
  const Vector3<S> half{S(0.7), S(0.8), S(0.9)};
  Pose<S> pose;
  pose.translation = {S(0.25), S(-0.5), S(0.125)};
  const Quadric<S> quadric = ball<S>({0.1L, 0.2L, 0}, 0.3L);
  const auto boxed = in_box(half, quadric);
  const auto composed = field(unite(place(pose, boxed), Sphere<S>{{S(1.0), {}, {}}, S(0.25)}));
  ImageBuilder<S, 200> builder;
  builder.enter(pose).enter_box(half).operation(quadric).leave_box(boxed.box).leave();
  builder.operation(Sphere<S>{{S(1.0), {}, {}}, S(0.25)}).operation(SharpUnion<S>{});
  ASSERT_EQ(builder.finish().status, LoadStatus::ok);
  const Program<S> program = load<S>(builder.words(), builder.size() * sizeof(uint32_t));
  ASSERT_TRUE(program.valid());
  EXPECT_EQ(program.budget().gradient, composed.budget().gradient);
  EXPECT_EQ(program.certificate().error, composed.certificate().error);
  Random random(reference::announced_seed("DeclaredBoxPrograms", 433));
  for (int i = 0; i < 2000; ++i) {
    const Vector3<S> p = rounded<S>(random.vector(-1.5L, 1.5L));
    const Clearance<S> a = clearance(composed, p), b = clearance(program, p);
    ASSERT_EQ(a.status, b.status);
    ASSERT_EQ(a.distance, b.distance);
    ASSERT_TRUE(a.direction == b.direction);
  }
}

// Without a box there is no clearance to be had, and none from a field whose gradient has no bound in it.
TEST(DeclaredBox, IsNeeded) {
  using S = Fixed<27>;
  ImageBuilder<S, 100> builder;
  ASSERT_EQ(builder.operation(ball<S>({}, 0.3L)).finish().status, LoadStatus::ok);
  const Program<S> bare = load<S>(builder.words(), builder.size() * sizeof(uint32_t));
  ASSERT_TRUE(bare.valid());
  for (const S x : {S(), S(0.5), S(1.0)}) {
    const Clearance<S> answer = clearance(bare, {x, {}, {}});
    EXPECT_EQ(answer.status, ClearanceStatus::invalid);
    EXPECT_EQ(answer.distance, S::least());
    EXPECT_TRUE(answer.direction == Vector3<S>{});
  }
  Quadric<S> steep = ball<S>({}, 0.3L);
  steep.diagonal = {S(1.0), S(1.0), S(1.0)};
  EXPECT_FALSE(field(in_box({S(4.0), S(4.0), S(4.0)}, steep)).valid()) << "it saturates there";
  EXPECT_TRUE(field(in_box({S(1.0), S(1.0), S(1.0)}, steep)).valid());
  EXPECT_TRUE(field(in_box({S(1.0), S(1.0), S(1.0)}, ball<S>({}, 0.3L))).valid());
  EXPECT_FALSE(field(in_box({S(1.0), S(), S(1.0)}, ball<S>({}, 0.3L))).valid());
  // Patches change at any rate where their bounds meet.
  const AlgebraicPlane<S> x = {{S(1.0), {}, {}}, {}}, y = {{{}, S(1.0), {}}, {}};
  RibbonPatch<S> patch;
  patch.side_count = 2;
  patch.side_weight[0] = patch.side_weight[1] = S(1.0);
  EXPECT_TRUE(field(combine(patch, x, y, y, x)).valid());
  EXPECT_FALSE(field(in_box({S(1.0), S(1.0), S(1.0)}, combine(patch, x, y, y, x))).valid());
}

TEST(DeclaredBox, RefusesWhatDoesNotFitTogether) {
  using S = Fixed<27>;
  const Vector3<S> half{S(0.7), S(0.8), S(0.9)};
  const Quadric<S> quadric = ball<S>({}, 0.3L);
  const DeclaredBox<S> box = in_box(half, quadric).box;
  const auto status = [&](const auto& write) {
    ImageBuilder<S, 200> builder;
    write(builder);
    return builder.finish().status;
  };
  EXPECT_EQ(status([&](auto& b) { b.enter_box(half).operation(quadric).leave_box(box); }), LoadStatus::ok);
  EXPECT_EQ(status([&](auto& b) { b.enter_box(half).operation(quadric).leave(); }),
            LoadStatus::frames_unbalanced);
  EXPECT_EQ(status([&](auto& b) { b.enter({}).operation(quadric).leave_box(box); }),
            LoadStatus::frames_unbalanced);
  EXPECT_EQ(status([&](auto& b) { b.operation(quadric).leave_box(box); }), LoadStatus::frames_unbalanced);
  EXPECT_EQ(status([&](auto& b) { b.enter_box(half).leave_box(box); }), LoadStatus::frames_unbalanced);
  EXPECT_EQ(status([&](auto& b) { b.enter_box(half).operation(Sphere<S>{{}, S(0.1)}).leave_box(box); }),
            LoadStatus::kind_mismatch);
  DeclaredBox<S> other = box;
  other.half.x = S(0.6);
  EXPECT_EQ(status([&](auto& b) { b.enter_box(half).operation(quadric).leave_box(other); }),
            LoadStatus::parameter_out_of_range);
  const DeclaredBox<S> bold(half, Rate::from_raw(box.lipschitz.raw() - 1));
  EXPECT_EQ(status([&](auto& b) { b.enter_box(half).operation(quadric).leave_box(bold); }),
            LoadStatus::parameter_out_of_range);
  other = box;
  other.inverse = other.inverse + S::unit_in_last_place();
  EXPECT_EQ(status([&](auto& b) { b.enter_box(half).operation(quadric).leave_box(other); }),
            LoadStatus::parameter_out_of_range);
}

// Blended with it, the 0 outside the box would count as a surface.
TEST(DeclaredBox, IsNoOperandOfSmoothBlends) {
  using S = Fixed<27>;
  static constexpr auto kernel = bake<S, 32>(exterior(step::polynomial<3>, 0.25));
  static constexpr auto potential = bake<S, 8>(potential::Cubic{});
  const auto boxed = in_box({S(1.0), S(1.0), S(1.0)}, ball<S>({}, 0.3L));
  const Sphere<S> sphere{{}, S(0.5)};
  EXPECT_TRUE(field(unite(boxed, sphere)).valid());
  EXPECT_TRUE(field(subtract(sphere, place(Pose<S>{}, boxed))).valid());
  EXPECT_FALSE(field(unite(kernel, S(0.1), boxed, sphere)).valid());
  EXPECT_FALSE(field(unite(kernel, S(0.1), sphere, unite(sphere, place(Pose<S>{}, boxed)))).valid());
  EXPECT_FALSE(field(combine(LogSumExpUnion<S>{ArgumentScale<S>::of(S(0.5)), 2}, boxed, sphere)).valid());
  const Certificate<S> of = field(boxed).certificate();
  EXPECT_FALSE(field(combine(PotentialOfDistance<S>(S(0.5), S(1.0), of), potential, boxed)).valid());
  EXPECT_FALSE(field(combine(AlgebraicOfDistance<S>{S(1.0)}, boxed)).valid());
}

// Tables of one kernel for both signs and of two halves are different things.
TEST(AdditiveTables, AreOfTheFormThatTheOperationSamples) {
  using S = Fixed<27>;
  static constexpr auto alike = bake<S, 64>(exterior(step::polynomial<3>, 0.25));
  static constexpr auto halves = bake<S, 64>(two_sided(exterior(step::polynomial<3>, 0.25)));
  static constexpr auto unlike_halves = bake<S, 64>(two_sided(interior(step::RisingCutoff{2})));
  const Sphere<S> sphere{{}, S(0.5)};
  const ArgumentScale<S> scale = ArgumentScale<S>::of(S(0.5));
  EXPECT_TRUE(field(combine(AdditiveUnion<S>{scale}, alike, sphere, sphere)).valid());
  EXPECT_TRUE(field(combine(TwoSidedUnion<S>{scale}, halves, sphere, sphere)).valid());
  EXPECT_TRUE(field(combine(TwoSidedUnion<S>{scale}, unlike_halves, sphere, sphere)).valid());
  EXPECT_FALSE(field(combine(AdditiveUnion<S>{scale}, halves, sphere, sphere)).valid());
  EXPECT_FALSE(field(combine(AdditiveUnion<S>{scale}, unlike_halves, sphere, sphere)).valid());
  EXPECT_FALSE(field(combine(TwoSidedUnion<S>{scale}, alike, sphere, sphere)).valid());
  ImageBuilder<S, 2000> builder;
  const uint32_t table = builder.table(halves);
  builder.operation(sphere).operation(sphere).operation(AdditiveUnion<S>{scale}, table);
  EXPECT_EQ(builder.finish().status, LoadStatus::bad_table);
}

TEST(OperationsOfAnyNumber, AreInvalidWithAnotherNumber) {
  using S = Fixed<27>;
  const AlgebraicPlane<S> plane{{S(1.0), {}, {}}, {}};
  const Sphere<S> sphere{{}, S(0.5)};
  RibbonPatch<S> patch;
  patch.side_count = 8;
  EXPECT_FALSE(field(combine(patch, plane, plane, plane, plane)).valid());
  EXPECT_FALSE(field(combine(LogSumExpUnion<S>{ArgumentScale<S>::of(S(0.5)), 18}, sphere, sphere)).valid());
  EXPECT_TRUE(field(combine(LogSumExpUnion<S>{ArgumentScale<S>::of(S(0.5)), 2}, sphere, sphere)).valid());
}

// A loader for a few operations refuses others, and gives the same bits for its own.
TEST(ChosenOperations, AreTheOnlyOnesThatLoad) {
  using S = Fixed<27>;
  using Few = OnlyOperations<Operation::sphere, Operation::sharp_union>;
  ImageBuilder<S, 100> balls, box;
  balls.operation(Sphere<S>{{}, S(0.25)}).operation(Sphere<S>{{S(0.5), {}, {}}, S(0.5)});
  balls.operation(SharpUnion<S>{});
  box.operation(Box<S>{{}, {S(0.25), S(0.25), S(0.25)}});
  ASSERT_EQ(balls.finish().status, LoadStatus::ok);
  ASSERT_EQ(box.finish().status, LoadStatus::ok);
  const auto few = load<S, Few>(balls.words(), balls.size() * sizeof(uint32_t));
  ASSERT_TRUE(few.valid());
  const Vector3<S> p{S(1.0), S(0.75), S(-0.5)};
  const auto all = load<S>(balls.words(), balls.size() * sizeof(uint32_t));
  EXPECT_EQ(clearance(few, p).distance, clearance(all, p).distance);
  const auto refused = load<S, Few>(box.words(), box.size() * sizeof(uint32_t));
  EXPECT_EQ(refused.status(), LoadStatus::unknown_operation);
}

}  // namespace
}  // namespace nearfield
