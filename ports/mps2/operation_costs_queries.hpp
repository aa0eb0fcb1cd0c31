// Queries: what they cost beyond their operations, and those above fields against their own budgets.
#pragma once

#include <nearfield/nearfield.h>
#include <nearfield/nearfield.hpp>

#include <operation_costs_blends.hpp>

namespace nearfield::costs {

template <class Work>
uint32_t worst_over(int trials, Work&& work) {
  uint32_t worst = 0;
  for (int i = 0; i < trials; ++i) {
    const uint32_t count = work();
    if (count > worst) worst = count;
  }
  return worst;
}

inline void report_value(const char* name, uint32_t measured, uint32_t stated) {
  report(name, {measured}, {stated});
}
inline void report_gradient(const char* name, uint32_t measured, uint32_t stated) {
  report(name, {0, measured}, {0, stated});
}

__attribute__((noinline)) inline Clearance<Q> clearance_at(const Program<Q>& program, const Vector3<Q>& p) {
  return clearance(program, p);
}
__attribute__((noinline)) inline Clearance<Q> clearance_in_slot(const Program<Q>& program,
                                                                const Vector3<Q>& p) {
  return clearance(program, p, kSlots);
}
__attribute__((noinline)) inline Clearance<Q> soft_clearance_at(const Program<Q>& program,
                                                                const Vector3<Q>& p) {
  return soft_clearance(program, p, kSlots);
}
template <class Answer>
Q distance_of(const Answer& answer) {
  return answer.distance;
}
inline Q distance_of(const NearestCapsule<Q>& nearest) { return nearest.clearance.distance; }
template <class Query>
uint32_t instructions_of(Query&& query) {
  board::start_instruction_count();
  const auto answer = query();
  const uint32_t count = board::stop_instruction_count();
  sink = distance_of(answer).raw();
  return count;
}

// Beyond the evaluation of the same field at the same point.
template <class Query>
uint32_t worst_beyond_evaluation(const Program<Q>& program, Query&& query) {
  Random random;
  return worst_over(kPoints, [&] {
    const Vector3<Q> p = random.point();
    const uint32_t evaluation = instructions_at<Sample<Q>>(program, {p});
    return instructions_of([&] { return query(program, p); }) - evaluation;
  });
}

// Of fields of several rates, by which queries divide; and what a field in a slot adds.
inline void report_query() {
  const Cost itself = evaluation_cost();
  uint32_t worst = 0;
  for (int blends = 0; blends < 12; ++blends) {
    Builder builder;
    const uint32_t table = builder.table(kKernel);
    builder.operation(kBall);
    for (int i = 0; i < blends; ++i) {
      builder.operation(kOtherBall).operation(AdditiveUnion<Q>{ArgumentScale<Q>::of(Q(0.25))}, table);
    }
    worst = greatest_of_two(worst, worst_beyond_evaluation(loaded(builder, "query"), clearance_at));
  }
  report("query", {itself.value, worst + itself.gradient},
         {kCortexM4QueryCost.value, kCortexM4QueryCost.gradient});
  Builder builder;
  builder.enter_slot(0).operation(kBall).leave();
  const uint32_t in_slot = worst_beyond_evaluation(loaded(builder, "a ball in a slot"), clearance_in_slot);
  report_gradient("check of a pose", in_slot - worst, kCortexM4PoseCheckCost);
  const auto with_parameters = [](uint32_t count) {
    Builder swelling;
    swelling.operation(kBall).operation(Swell<Q>{Q(0.5), count - 1});
    return worst_beyond_evaluation(loaded(swelling, "a swelling ball"), clearance_in_slot);
  };
  report_gradient("check of a parameter", with_parameters(2) - with_parameters(1), kCortexM4ParameterCheckCost);
}

// Of a field in a slot, and through the C interface, against the budgets that they state themselves.
inline void report_slot_queries() {
  Builder builder;
  builder.enter_slot(0).operation(kBall).leave();
  const Program<Q> program = loaded(builder, "a ball in a slot");
  nearfield_field from_c = {};
  nearfield_load(&from_c, builder.words(), builder.size() * 4);
  const nearfield_pose pose_from_c = {{1 << 30, 0, 0, 0, 1 << 30, 0, 0, 0, 1 << 30}, {0, 0, 0}};
  Random random, again;
  report_gradient("query of a ball in a slot",
                  worst_over(kPoints,
                             [&] {
                               const Vector3<Q> p = random.point();
                               return instructions_of([&] { return clearance_in_slot(program, p); });
                             }),
                  program.budget().gradient);
  report_gradient("the same from C",
                  worst_over(kPoints,
                             [&] {
                               const Vector3<Q> p = again.point();
                               const int32_t point[3] = {p.x.raw(), p.y.raw(), p.z.raw()};
                               board::start_instruction_count();
                               const nearfield_clearance answer =
                                   nearfield_clearance_at(&from_c, point, &pose_from_c, 1);
                               const uint32_t count = board::stop_instruction_count();
                               sink = answer.distance;
                               return count;
                             }),
                  nearfield_budget(&from_c));
}

inline void report_soft_clearance(const char* name, Builder& builder) {
  const Program<Q> program = loaded(builder, name);
  Random random;
  report_gradient(name,
                  worst_over(kPoints,
                             [&] {
                               const Vector3<Q> p = random.point();
                               return instructions_of([&] { return soft_clearance_at(program, p); });
                             }),
                  soft_clearance_budget(program));
}
inline void report_soft_clearances() {
  const Influence<Q> influence(Q(1.5), Q(1.0));
  Builder points;
  const uint32_t squared = points.table(kSquaredPotential);
  points.operation(SoftPoint<Q>{kPlace, influence}, squared)
      .operation(SoftPoint<Q>{{0.4, 0.1, 0.0}, influence}, squared);
  points.operation(SoftSum<Q>{});
  report_soft_clearance("soft clearance of two points", points);

  // A union of balls as one skeleton, in a slot, less a segment.
  Builder skeleton;
  const uint32_t table = skeleton.table(kPotential), squared_again = skeleton.table(kSquaredPotential);
  const Certificate<Q> of_balls = kOtherBall.certificate(domain_reach<Q>());
  const Certificate<Q> doubled = {
      true, of_balls.lipschitz, {}, {}, ScalarTraits<Q>::times(of_balls.error, 16)};
  skeleton.enter_slot(0).operation(kBall).operation(kOtherBall).operation(SharpUnion<Q>{});
  skeleton.operation(PotentialOfDistance<Q>(Q(1.0), Q(1.0), doubled), table).leave();
  skeleton.operation(SoftSegment<Q>{kSegment, Influence<Q>(Q(1.5), Q(-0.5))}, squared_again)
      .operation(SoftSum<Q>{});
  report_soft_clearance("soft clearance of a skeleton in a slot", skeleton);
}

using TestChain = Chain<Q, 9, 9>;
__attribute__((noinline)) inline KinematicsStatus poses_of(const TestChain& chain, const Q* values,
                                                           Pose<Q>* poses) {
  return chain.link_poses(values, poses);
}
__attribute__((noinline)) inline Capsule<Q> body_of(const TestChain& chain, const Pose<Q>* poses) {
  return chain.placed_body(0, poses);
}
__attribute__((noinline)) inline SeparatedBy<Q> separation_of(const Capsule<Q>& a, const Capsule<Q>& b) {
  return separation(a, b);
}
__attribute__((noinline)) inline NearestCapsule<Q> nearest_of(const Program<Q>& program,
                                                              const MovedCapsule<Q>* capsules, uint16_t count,
                                                              Stretch<Q>* stretches, int refinements) {
  return clearance(program, capsules, count, stretches, {refinements, Q{}});
}

inline void report_chains() {
  using Monitor = ArmMonitor<TestChain, TestChain, Program<Q>, Program<Q>>;
  Random random;
  static TestChain chain, sliding;
  Joint<Q> joint;
  joint.axis = {0.6, 0.0, 0.8};
  joint.origin.translation = {0.1, 0.1, 0.1};
  for (uint16_t i = 0; i < 8; ++i) {
    joint.parent = joint.variable = i;
    joint.kind = JointKind::revolute;
    chain.add_joint(joint);
    joint.kind = JointKind::prismatic;
    sliding.add_joint(joint);
  }
  chain.add_body({8, Capsule<Q>(Vector3<Q>{0.0, 0.1, 0.0}, Vector3<Q>{0.1, 0.2, 0.3}, Q(0.1))});
  static Pose<Q> poses[9];
  const auto worst_poses = [&](const TestChain& robot, int32_t reach) {
    return worst_over(500, [&] {
      Q values[8];
      for (Q& value : values) value = Q::from_raw(static_cast<int32_t>(random.next()) / reach);
      board::start_instruction_count();
      const KinematicsStatus status = poses_of(robot, values, poses);
      const uint32_t count = board::stop_instruction_count();
      sink = static_cast<int32_t>(status);
      return count;
    });
  };
  report_value("eight revolute joints", worst_poses(chain, 2), chain.poses_budget());
  report_value("eight prismatic joints", worst_poses(sliding, 64), sliding.poses_budget());
  report_value("placed body",
               worst_over(10,
                          [&] {
                            board::start_instruction_count();
                            const Capsule<Q> body = body_of(chain, poses);
                            const uint32_t count = board::stop_instruction_count();
                            sink = body.length.raw();
                            return count;
                          }),
               Monitor::cost_per_placed_body);
}

inline Capsule<Q> random_capsule(Random& random) {
  const Vector3<Q> a = random.point(), b = random.next() % 16 == 0 ? a : random.point();
  return Capsule<Q>(a, b, Q(0.1));
}

inline void report_capsules() {
  Random random;
  report_value("capsule pair",
               25 + worst_over(20000,
                               [&] {
                                 const Capsule<Q> a = random_capsule(random), b = random_capsule(random);
                                 return instructions_of([&] { return separation_of(a, b); });
                               }),
               kCapsulePairCost);

  Builder builder;
  builder.operation(Box<Q>{{0.1, 0.0, 0.0}, {0.3, 0.2, 0.4}})
      .operation(kOtherBall)
      .operation(SharpUnion<Q>{});
  const Program<Q> program = loaded(builder, "a box and a ball");
  static Stretch<Q> stretches[16 + kMostRefinements];
  static MovedCapsule<Q> capsules[16];
  struct Sweep {
    const char* name;
    uint16_t count;
    int refinements;
  };
  constexpr Sweep sweeps[] = {{"1 capsule", 1, 0},
                              {"9 capsules", 9, 0},
                              {"16 capsules", 16, 0},
                              {"1 capsule, 12 refinements", 1, 12},
                              {"9 capsules, 12 refinements", 9, 12},
                              {"16 capsules, 12 refinements", 16, 12},
                              {"1 capsule, all refinements", 1, kMostRefinements},
                              {"9 capsules, all refinements", 9, kMostRefinements},
                              {"16 capsules, all refinements", 16, kMostRefinements}};
  for (const Sweep& sweep : sweeps) {
    report_value(sweep.name,
                 worst_over(300,
                            [&] {
                              for (MovedCapsule<Q>& c : capsules) c.capsule = random_capsule(random);
                              // All at their worst together.
                              if (random.next() % 2 == 0) {
                                for (MovedCapsule<Q>& c : capsules) c.capsule = capsules[0].capsule;
                              }
                              return instructions_of([&] {
                                return nearest_of(program, capsules, sweep.count, stretches,
                                                  sweep.refinements);
                              });
                            }),
                 sweep_budget(program, sweep.count, static_cast<uint32_t>(sweep.refinements)));
  }
}

inline void report_queries() {
  report_query();
  report_slot_queries();
  report_soft_clearances();
  report_chains();
  report_capsules();
}

}  // namespace nearfield::costs
