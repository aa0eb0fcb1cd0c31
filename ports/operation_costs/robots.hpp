// Queries about robots: chains, capsules that move, and the tick of a monitor.
#pragma once

#include <operation_costs/queries.hpp>

namespace nearfield::costs {

using TestChain = Chain<Q, 16, 16>;
__attribute__((noinline)) inline KinematicsStatus poses_of(const TestChain& chain, const Q* values,
                                                           Pose<Q>* poses) {
  return chain.link_poses(values, poses);
}
__attribute__((noinline)) inline Capsule<Q> body_of(const TestChain& chain, uint16_t body, const Pose<Q>* poses) {
  return chain.placed_body(body, poses);
}
__attribute__((noinline)) inline SeparatedBy<Q> separation_of(const Capsule<Q>& a, const Capsule<Q>& b) {
  return separation(a, b);
}
template <class AnyField>
__attribute__((noinline)) NearestCapsule<Q> nearest_of(const AnyField& field, const MovedCapsule<Q>* capsules,
                                                       uint16_t count, Stretch<Q>* stretches, int refinements) {
  return clearance(field, capsules, count, stretches, {refinements, Q{}});
}
template <class Work>
uint32_t instructions_to(Work&& work) {
  board::start_instruction_count();
  const auto answer = work();
  const uint32_t count = board::stop_instruction_count();
  sink = static_cast<int32_t>(answer);
  return count;
}

inline TestChain chain_of(JointKind kind, uint16_t joints, uint16_t bodies) {
  TestChain chain;
  Joint<Q> joint;
  joint.axis = {0.6, 0.0, 0.8};
  joint.origin.translation = {0.1, 0.1, 0.1};
  joint.kind = kind;
  for (uint16_t i = 0; i < joints; ++i) {
    joint.parent = joint.variable = i;
    chain.add_joint(joint);
  }
  for (uint16_t i = 0; i < bodies; ++i)
    chain.add_body({static_cast<uint16_t>(joints - i), Capsule<Q>(Vector3<Q>{0.0, 0.1, 0.0}, Vector3<Q>{0.1, 0.2, 0.3}, Q(0.1))});
  return chain;
}

// Of 1 joint and of 8.
inline void report_chains() {
  static Pose<Q> poses[16];
  Random random;
  const auto worst_poses = [&](const TestChain& robot, int32_t reach) {
    return worst_over(300, [&] {
      Q values[8];
      for (Q& value : values) value = Q::from_raw(static_cast<int32_t>(random.next()) / reach);
      return instructions_to([&] { return poses_of(robot, values, poses); });
    });
  };
  static TestChain chains[4] = {chain_of(JointKind::revolute, 1, 1), chain_of(JointKind::revolute, 8, 1),
                                chain_of(JointKind::prismatic, 1, 1), chain_of(JointKind::prismatic, 8, 1)};
  const uint32_t revolute = worst_poses(chains[0], 2), revolutes = worst_poses(chains[1], 2);
  const uint32_t prismatic = worst_poses(chains[2], 64), prismatics = worst_poses(chains[3], 64);
  const uint32_t each_revolute = (revolutes - revolute + 6) / 7, each_prismatic = (prismatics - prismatic + 6) / 7;
  const auto base = [](uint32_t all, uint32_t joints) { return all > joints ? all - joints : 1; };
  uint32_t itself = greatest_of_two(base(revolute, each_revolute), base(revolutes, 8 * each_revolute));
  itself = greatest_of_two(itself, base(prismatic, each_prismatic));
  report_part("link_poses", QueryPart::link_poses, {greatest_of_two(itself, base(prismatics, 8 * each_prismatic)), 0, 0});
  report_part("revolute_joint", QueryPart::revolute_joint, {each_revolute, 0, 0});
  report_part("other_joint", QueryPart::other_joint, {each_prismatic, 0, 0});
  report_value("eight revolute joints", revolutes, chains[1].poses_budget(kTarget));
  report_value("eight prismatic joints", prismatics, chains[3].poses_budget(kTarget));
  uint32_t placed = 0;
  for (const TestChain& chain : chains) {
    board::start_instruction_count();
    const Capsule<Q> body = body_of(chain, 0, poses);
    placed = greatest_of_two(placed, board::stop_instruction_count());
    sink = body.length.raw();
  }
  report_part("placed_body", QueryPart::placed_body, {placed, 0, 0});
}

inline Capsule<Q> random_capsule(Random& random) {
  const Vector3<Q> a = random.point(), b = random.next() % 16 == 0 ? a : random.point();
  return Capsule<Q>(a, b, Q(0.1));
}

struct Sweep {
  uint16_t count;
  int refinements;
};
inline Stretch<Q> sweep_stretches[16 + kMostRefinements];
inline MovedCapsule<Q> sweep_capsules[16];

template <class AnyField>
uint32_t worst_sweep(const AnyField& field, const Sweep& sweep) {
  Random random;
  return worst_over(200, [&] {
    for (MovedCapsule<Q>& c : sweep_capsules) c.capsule = random_capsule(random);
    // All at their worst together.
    if (random.next() % 2 == 0) {
      for (MovedCapsule<Q>& c : sweep_capsules) c.capsule = sweep_capsules[0].capsule;
    }
    return instructions_of(
        [&] { return nearest_of(field, sweep_capsules, sweep.count, sweep_stretches, sweep.refinements); });
  });
}

inline void report_sweeps() {
  static const DistanceOfLittle little;
  const auto above = [](uint32_t all, uint32_t part) { return all > part ? all - part : 1; };
  const auto share = [](uint32_t all, uint32_t parts) { return (all + parts - 1) / parts; };
  const uint32_t query = measured_query;
  const uint32_t one = worst_sweep(little, {1, 0}), sixteen = worst_sweep(little, {16, 0});
  const uint32_t capsule = greatest_of_two(above(one, query), share(above(sixteen, query), 16));
  const auto refinement = [&](uint16_t count) {
    return share(above(worst_sweep(little, {count, 12}), query + count * capsule), 12);
  };
  const uint32_t of_one = refinement(1), of_sixteen = refinement(16);
  const uint32_t stretch = share(above(of_sixteen, of_one), 15);
  report_part("swept_capsule", QueryPart::swept_capsule, {capsule, 0, 0});
  report_part("refinement", QueryPart::refinement,
              {greatest_of_two(above(of_one, 13 * stretch), above(of_sixteen, 28 * stretch)), 0, 0});
  report_part("stretch", QueryPart::stretch, {stretch, 0, 0});

  Builder builder;
  builder.operation(Box<Q>{{0.1, 0.0, 0.0}, {0.3, 0.2, 0.4}})
      .operation(kOtherBall)
      .operation(SharpUnion<Q>{});
  const Program<Q> program = loaded(builder, "a box and a ball");
  const auto check = [&](const char* name, const Sweep& sweep) {
    report_value(name, worst_sweep(program, sweep),
                 sweep_budget(program, sweep.count, static_cast<uint32_t>(sweep.refinements), kTarget));
  };
  check("1 capsule", {1, 0});
  check("16 capsules", {16, 0});
  check("1 capsule, 12 refinements", {1, 12});
  check("9 capsules, 12 refinements", {9, 12});
  check("16 capsules, all refinements", {16, kMostRefinements});
}

using TestMonitor = ArmMonitor<TestChain, TestChain, DistanceOfLittle, IntensityOfLittle>;
__attribute__((noinline)) inline ArmTick<Q> tick_of(const TestMonitor& monitor, const Q* arm, const Q* person) {
  return monitor.tick(arm, person);
}

// What a tick costs besides its parts, with as many bodies on either side and as many pairs of the arm itself.
inline uint32_t rest_of_tick(uint16_t bodies, uint16_t pairs) {
  static const DistanceOfLittle cell;
  static const IntensityOfLittle soft;
  static const uint8_t checked[16] = {1, 1, 1, 1, 1, 1, 1, 1};
  static const BodyPair self_pairs[] = {{0, 1}, {1, 2}, {2, 3}, {0, 3}};
  static TestChain arm, person;
  arm = chain_of(JointKind::revolute, 8, bodies);
  person = chain_of(JointKind::revolute, 8, bodies);
  TestMonitor monitor;
  monitor.arm = &arm;
  monitor.person = &person;
  monitor.cell = &cell;
  monitor.soft = &soft;
  monitor.checked_against_cell = checked;
  monitor.self_pairs = self_pairs;
  monitor.self_pair_count = pairs;
  monitor.tool_link = 8;
  monitor.effort = {0, Q{}};
  static Pose<Q> arm_poses[16], person_poses[16];
  Random random;
  return worst_over(100, [&] {
    Q angles[8], others[8];
    for (Q& angle : angles) angle = Q::from_raw(static_cast<int32_t>(random.next()) / 4);
    for (Q& angle : others) angle = Q::from_raw(static_cast<int32_t>(random.next()) / 4);
    uint32_t parts = instructions_to([&] { return poses_of(arm, angles, arm_poses); }) +
                     instructions_to([&] { return poses_of(person, others, person_poses); });
    Capsule<Q> placed[4], limbs[4];
    const auto place = [&](const TestChain& chain, uint16_t i, const Pose<Q>* poses, Capsule<Q>& body) {
      board::start_instruction_count();
      body = body_of(chain, i, poses);
      parts += board::stop_instruction_count();
      sink = body.length.raw();
    };
    for (uint16_t i = 0; i < bodies; ++i) {
      place(arm, i, arm_poses, placed[i]);
      place(person, i, person_poses, limbs[i]);
      sweep_capsules[i] = {placed[i], arm.body_error(i), i};
    }
    const auto separate = [&](const Capsule<Q>& a, const Capsule<Q>& b) {
      parts += instructions_of([&] { return separation_of(a, b); });
    };
    for (uint16_t i = 0; i < bodies; ++i) {
      for (uint16_t j = 0; j < bodies; ++j) separate(placed[i], limbs[j]);
    }
    for (uint16_t i = 0; i < pairs; ++i) separate(placed[self_pairs[i].first], placed[self_pairs[i].second]);
    parts += instructions_of([&] { return nearest_of(cell, sweep_capsules, bodies, sweep_stretches, 0); });
    board::start_instruction_count();
    const ArmTick<Q> tick = tick_of(monitor, angles, others);
    const uint32_t all = board::stop_instruction_count();
    sink = tick.speed_override.raw();
    return all > parts ? all - parts : 1;
  });
}

inline void report_robots() {
  report_chains();
  report_sweeps();
  Random random;
  const uint32_t pair = worst_over(kPoints, [&] {
    const Capsule<Q> a = random_capsule(random), b = random_capsule(random);
    return instructions_of([&] { return separation_of(a, b); });
  });
  const uint32_t few = rest_of_tick(1, 0), many = rest_of_tick(4, 4);
  constexpr uint32_t more_pairs = 4 * 4 + 4 - 1;
  const uint32_t of_pair = many > few ? (many - few + more_pairs - 1) / more_pairs : 0;
  report_part("capsule_pair", QueryPart::capsule_pair, {pair + of_pair, 0, 0});
  report_part("tick", QueryPart::tick, {few, 0, 0});
}

}  // namespace nearfield::costs
