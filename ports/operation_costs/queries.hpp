// Queries: what they cost beyond their operations, and those above fields against their own budgets.
#pragma once

#include <nearfield/nearfield.h>
#include <nearfield/nearfield.hpp>

#include <operation_costs/blends.hpp>

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

// What a query costs by itself, for those that are made of it.
inline uint32_t measured_query = 0;

// Of fields of several rates, by which queries divide; and what a field in a slot adds.
inline void report_query() {
  const Budget itself = evaluation_cost();
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
  measured_query = worst + itself.gradient;
  report_part("query", QueryPart::query, {itself.value, measured_query, itself.highest});
  Builder builder;
  builder.enter_slot(0).operation(kBall).leave();
  const uint32_t in_slot = worst_beyond_evaluation(loaded(builder, "a ball in a slot"), clearance_in_slot);
  report_part("pose_check", QueryPart::pose_check, {0, in_slot - worst, 0});
  const auto with_parameters = [](uint32_t count) {
    Builder swelling;
    swelling.operation(kBall).operation(Swell<Q>{Q(0.5), count - 1});
    return worst_beyond_evaluation(loaded(swelling, "a swelling ball"), clearance_in_slot);
  };
  report_part("parameter_check", QueryPart::parameter_check, {0, with_parameters(2) - with_parameters(1), 0});
}

// Of a field in a slot, and through the C interface, against the budgets that they state themselves.
inline void report_slot_queries() {
  const auto direct = [](const Program<Q>& program) {
    Random random;
    return worst_over(kPoints, [&] {
      const Vector3<Q> p = random.point();
      return instructions_of([&] { return clearance_in_slot(program, p); });
    });
  };
  const auto from_c = [](Builder& builder, uint32_t pose_count) {
    nearfield_field field = {};
    nearfield_load(&field, builder.words(), builder.size() * 4);
    const nearfield_pose pose = {{1 << 30, 0, 0, 0, 1 << 30, 0, 0, 0, 1 << 30}, {0, 0, 0}};
    Random random;
    return worst_over(kPoints, [&] {
      const Vector3<Q> p = random.point();
      const int32_t point[3] = {p.x.raw(), p.y.raw(), p.z.raw()};
      board::start_instruction_count();
      const nearfield_clearance answer = nearfield_clearance_at(&field, point, &pose, pose_count);
      const uint32_t count = board::stop_instruction_count();
      sink = answer.distance;
      return count;
    });
  };
  Builder ball, in_slot;
  ball.operation(kBall);
  in_slot.enter_slot(0).operation(kBall).leave();
  const Program<Q> ball_program = loaded(ball, "a ball"), slot_program = loaded(in_slot, "a ball in a slot");
  const uint32_t ball_cost = direct(ball_program), slot_cost = direct(slot_program);
  const uint32_t ball_from_c = from_c(ball, 0), slot_from_c = from_c(in_slot, 1);
  report_part("c_interface", QueryPart::c_interface, {0, ball_from_c - ball_cost, 0});
  report_part("c_pose", QueryPart::c_pose, {0, slot_from_c - slot_cost - (ball_from_c - ball_cost), 0});
  report_gradient("query of a ball in a slot", slot_cost, slot_program.budget(kTarget).gradient);
  nearfield_field field = {};
  nearfield_load(&field, in_slot.words(), in_slot.size() * 4);
  report_gradient("the same from C", slot_from_c, nearfield_budget(&field));
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
                  soft_clearance_budget(program, kTarget));
}
// Fields that cost next to nothing, so that what queries do themselves is left.
template <Kind field_kind>
struct FieldOfLittle {
  using Scalar = Q;
  static constexpr Kind kind() { return field_kind; }
  static constexpr bool valid() { return true; }
  static constexpr bool has_highest() { return true; }
  static constexpr uint32_t slot_count() { return 0; }
  static constexpr uint32_t parameter_count() { return 0; }
  static constexpr Budget budget(const Target& = kTarget) { return {}; }
  const Certificate<Q>& certificate() const { return certificate_; }
  template <class Out>
  __attribute__((noinline)) Out evaluate(const Vector3<Q>& p, const Slots<Q>&) const {
    Out out{};
    out.value = p.x;
    if constexpr (Out::has_gradient) out.gradient = p;
    return out;
  }
  __attribute__((noinline)) Highest<Q> highest(const Vector3<Q>& p, Q radius, const Slots<Q>&) const {
    return {add_in_range(p.x, radius)};
  }

 private:
  Certificate<Q> certificate_ = kBall.certificate(domain_reach<Q>());
};
using DistanceOfLittle = FieldOfLittle<Kind::distance>;
using IntensityOfLittle = FieldOfLittle<Kind::intensity>;

inline void report_soft_clearances() {
  static const IntensityOfLittle little;
  Random random;
  const uint32_t itself = worst_over(kPoints, [&] {
    const Vector3<Q> p = random.point();
    return instructions_of([&] { return soft_clearance(little, p, kSlots); });
  });
  report_part("soft_clearance", QueryPart::soft_clearance, {0, itself, 0});
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

inline void report_queries() {
  report_query();
  report_slot_queries();
  report_soft_clearances();
}

}  // namespace nearfield::costs
