/// What budgets are made of: every operation and part of a query is stated on every target.

#include <nearfield/field/builder.hpp>
#include <nearfield/field/compose.hpp>
#include <nearfield/field/program.hpp>
#include <nearfield/query/capsule_clearance.hpp>
#include <nearfield/query/chain.hpp>
#include <nearfield/query/soft_clearance.hpp>

#include <gtest/gtest.h>

namespace nearfield {
namespace {

using S = Fixed<27>;

constexpr const Target* kTargets[] = {
#define NEARFIELD_TARGET(name) &target::name,
    NEARFIELD_TARGETS(NEARFIELD_TARGET)
#undef NEARFIELD_TARGET
};
constexpr uint32_t kLeastThatIsNone = 100000000;

bool measured(const Budget& cost) {
  return cost.value < kLeastThatIsNone && cost.gradient < kLeastThatIsNone && cost.highest < kLeastThatIsNone;
}

TEST(Budget, EveryOperationIsStatedOnEveryTarget) {
  for (const Target* target : kTargets) {
    const auto check = [&](Operation operation, const char* name, bool has_items) {
      const Budget all = target->cost(operation);
      EXPECT_TRUE(measured(all)) << name;
      EXPECT_GT(all.value, 0u) << name;
      EXPECT_GT(all.gradient, 0u) << name;
      EXPECT_EQ(measured(target->item_cost(operation)), has_items) << name;
    };
#define NEARFIELD_CHECK(code, name, type) check(Operation::name, #name, detail::has_items<type<S>>);
    NEARFIELD_OPERATIONS(NEARFIELD_CHECK)
#undef NEARFIELD_CHECK
    for (const Operation frame : {Operation::enter_pose, Operation::enter_slot, Operation::enter_box,
                                  Operation::enter_scale}) {
      EXPECT_TRUE(measured(target->cost(frame)));
      EXPECT_GT(target->cost(frame).value, 0u);
    }
  }
}

TEST(Budget, EveryPartOfAQueryIsStatedOnEveryTarget) {
  for (const Target* target : kTargets) {
    for (int part = 0; part <= static_cast<int>(QueryPart::c_pose); ++part)
      EXPECT_TRUE(measured(target->cost(static_cast<QueryPart>(part)))) << part;
    EXPECT_FALSE(measured(target->cost(static_cast<QueryPart>(static_cast<int>(QueryPart::c_pose) + 1))));
  }
}

TEST(Budget, WhatIsNotKnownCostsMoreThanAnyField) {
  EXPECT_FALSE(measured(target::cortex_m4.cost(static_cast<Operation>(0xee))));
  EXPECT_FALSE(measured(Target().cost(Operation::sphere)));
  EXPECT_FALSE(measured(target::cortex_m4.item_cost(Operation::sphere)));
}

TEST(Budget, SumsStayAtTheGreatestNumber) {
  const Budget half = {0x80000000u, 1, 0xffffffffu};
  const Budget sum = half + half, product = 3 * half;
  EXPECT_EQ(sum.value, 0xffffffffu);
  EXPECT_EQ(sum.gradient, 2u);
  EXPECT_EQ(sum.highest, 0xffffffffu);
  EXPECT_EQ(product.value, 0xffffffffu);
  EXPECT_EQ(product.gradient, 3u);
}

TEST(Budget, OfAProgramIsTheSumOfItsOperationsAndItsQuery) {
  const Vector3<S> points[] = {{0.0, 0.0, 0.0}, {0.1, 0.0, 0.0}, {0.1, 0.2, 0.0}};
  const Polyline<S> line(points, 3, S(0.05));
  ImageBuilder<S, 256> builder;
  builder.enter_slot(0).operation(Sphere<S>{{}, S(0.1)}).leave().operation(line).operation(SharpUnion<S>{});
  ASSERT_EQ(builder.finish().status, LoadStatus::ok);
  const Program<S> program = load<S>(builder.words(), builder.size() * 4);
  for (const Target* target : kTargets) {
    const Budget expected = target->query_cost(1, 0) + target->cost(Operation::enter_slot) +
                            target->cost(Operation::sphere) + target->cost(Operation::polyline) +
                            2 * target->item_cost(Operation::polyline) + target->cost(Operation::sharp_union);
    EXPECT_EQ(program.budget(*target).value, expected.value);
    EXPECT_EQ(program.budget(*target).gradient, expected.gradient);
    EXPECT_EQ(program.budget(*target).highest, expected.highest);
    const auto composed = field(combine(SharpUnion<S>{}, in_slot(0, Sphere<S>{{}, S(0.1)}), line));
    EXPECT_EQ(composed.budget(*target).gradient, expected.gradient);
  }
  EXPECT_EQ(program.budget().gradient, program.budget(target::cortex_m4).gradient);
  EXPECT_EQ(Program<S>().budget().gradient, 0u);
  // A core without a long multiplication takes longer.
  EXPECT_GT(program.budget(target::cortex_m0).gradient, 2 * program.budget(target::cortex_m4).gradient);
}

template <class Other> void expect_not_measured() {
  const auto composed = field(Sphere<Other>{{}, Other(0.1f)});
  ImageBuilder<Other, 64> builder;
  builder.operation(Sphere<Other>{{}, Other(0.1f)});
  ASSERT_EQ(builder.finish().status, LoadStatus::ok);
  const Program<Other> program = load<Other>(builder.words(), builder.size() * 4);
  for (const Budget& budget : {composed.budget(), program.budget()}) {
    EXPECT_GE(budget.value, kLeastThatIsNone);
    EXPECT_GE(budget.gradient, kLeastThatIsNone);
    EXPECT_GE(budget.highest, kLeastThatIsNone);
  }
  const Chain<Other, 2, 2> chain;
  EXPECT_GE(chain.poses_budget(), kLeastThatIsNone);
}

// Costs are of Fixed<27>: other roundings take other instructions, and float depends on whether there is an FPU.
TEST(Budget, OfOtherScalarsIsNotMeasured) {
  expect_not_measured<Fixed<24>>();
  expect_not_measured<Fixed<16>>();
  expect_not_measured<float>();
}

// Sums of what was not measured must not come round to something that looks small.
TEST(Budget, OfQueriesStaysAtTheGreatestNumber) {
  const auto composed = field(Sphere<S>{{}, S(0.1)});
  const Target unknown;
  EXPECT_GE(sweep_budget(composed, 1, 0, unknown), kLeastThatIsNone);
  for (uint32_t count = 1; count < 200; ++count)
    for (uint32_t refinements = 0; refinements < 40; ++refinements)
      EXPECT_GE(sweep_budget(composed, count, refinements, unknown), kLeastThatIsNone) << count << ' ' << refinements;
  EXPECT_GE(soft_clearance_budget(composed, unknown), kLeastThatIsNone);
}

}  // namespace
}  // namespace nearfield
