// Measures what each operation of a program costs at the worst, dispatch included, and checks the table of
// nearfield/field/budget.hpp against it. A program of one shape costs the query's own share plus that shape; each
// further pair of shape and blend their sum. Points are drawn around each shape so that all its branches are taken.
#include <nearfield/field/builder.hpp>
#include <nearfield/nearfield.h>
#include <nearfield/nearfield.hpp>
#include <nearfield/curve/tabulated_form.hpp>

#include <board/instruction_counter.hpp>
#include <board/semihosting.hpp>

namespace {

using namespace nearfield;
using Q = Fixed<27>;
using Builder = ImageBuilder<Q, 1024>;

constexpr int kPoints = 4000;
constexpr uint32_t kQueryShare = 60;  // of evaluate() itself; the rest of a one-shape program is the shape's

struct Random {
  uint64_t state = 88172645463325252u;
  uint32_t next() {
    state ^= state << 13;
    state ^= state >> 7;
    state ^= state << 17;
    return static_cast<uint32_t>(state >> 16);
  }
  // Within +-2^-scale of the domain, finer scales included, so that insides, faces and edges are met.
  Q coordinate(int scale) { return Q::from_raw(static_cast<int32_t>(next()) / 8 >> scale); }
  Vector3<Q> point() {
    const int scale = static_cast<int>(next() % 7);
    Vector3<Q> p = {coordinate(scale), coordinate(scale), coordinate(scale)};
    if (next() % 8 == 0) p.x = Q{};
    if (next() % 8 == 0) p.y = Q{};
    if (next() % 8 == 0) p.z = Q{};
    return p;
  }
};

__attribute__((noinline)) Value<Q> value_at(const Program<Q>& program, const Vector3<Q>& p, const Pose<Q>* slots) {
  return program.evaluate<Value<Q>>(p, slots);
}
__attribute__((noinline)) Sample<Q> sample_at(const Program<Q>& program, const Vector3<Q>& p, const Pose<Q>* slots) {
  return program.evaluate<Sample<Q>>(p, slots);
}
__attribute__((noinline)) Clearance<Q> clearance_at(const Program<Q>& program, const Vector3<Q>& p) {
  return clearance(program, p);
}

const Pose<Q> kSlot;
volatile int32_t sink;

Budget worst_of(Builder& builder) {
  const Inspection<Q> inspection = builder.finish();
  if (inspection.status != LoadStatus::ok) {
    board::write("a program does not load\n");
    board::exit_with_status(1);
  }
  const Program<Q> program = load<Q>(builder.words(), builder.size() * 4);
  Budget worst;
  Random random;
  for (int i = 0; i < kPoints; ++i) {
    const Vector3<Q> p = random.point();
    board::start_instruction_count();
    const Value<Q> value = value_at(program, p, &kSlot);
    const uint32_t value_count = board::stop_instruction_count();
    board::start_instruction_count();
    const Sample<Q> sample = sample_at(program, p, &kSlot);
    const uint32_t gradient_count = board::stop_instruction_count();
    sink = value.value.raw() + sample.value.raw();
    if (value_count > worst.value) worst.value = value_count;
    if (gradient_count > worst.gradient) worst.gradient = gradient_count;
  }
  return worst;
}

int failures = 0;

void report(const char* name, Budget measured, Budget stated) {
  board::write(name);
  board::write(": ");
  board::write_decimal(measured.value);
  board::write(" of ");
  board::write_decimal(stated.value);
  board::write(", with gradient ");
  board::write_decimal(measured.gradient);
  board::write(" of ");
  board::write_decimal(stated.gradient);
  const bool broken = measured.value > stated.value || measured.gradient > stated.gradient;
  board::write(broken ? "  EXCEEDED\n" : "\n");
  failures += broken ? 1 : 0;
}

Budget less(Budget a, Budget b) { return {a.value - b.value, a.gradient - b.gradient}; }
constexpr Budget kShare = {kQueryShare, kQueryShare};

template <class Shape, class... Table> Budget shape_cost(const char* name, const Shape& shape, Builder& builder, Table... table) {
  builder.operation(shape, table...);
  const Budget measured = less(worst_of(builder), kShare);
  report(name, measured, cortex_m4_cost(OperationOf<Shape>::value));
  return measured;
}

constexpr auto kKernel = bake<Q>(exterior(step::polynomial<3>, 0.25));
constexpr auto kPotential = bake<Q, 2>(over_square(potential::wyvill));
const Sphere<Q> kBall = {{0.1, 0.2, 0.0}, 0.3};

// Two balls close enough for their blend, less two balls alone.
template <class Blend, class... Table> void blend_cost(const char* name, const Blend& blend, Builder& builder, Table... table) {
  Builder lone;
  lone.operation(kBall);
  const Budget ball = less(worst_of(lone), kShare);
  builder.operation(kBall).operation(Sphere<Q>{{0.15, 0.25, 0.0}, 0.3}).operation(blend, table...);
  report(name, less(less(less(worst_of(builder), kShare), ball), ball), cortex_m4_cost(OperationOf<Blend>::value));
}
template <template <class> class Blend> void exterior_cost(const char* name) {
  Builder builder;
  const uint32_t table = builder.table(kKernel);
  Blend<Q> blend;
  blend.scale = ArgumentScale<Q>::of(Q(1.25));
  blend_cost(name, blend, builder, table);
}

void soft_costs() {
  const Influence<Q> influence(Q(1.5), Q(1.0));
  const Capsule<Q> segment(Vector3<Q>{-0.3, 0.1, 0.0}, Vector3<Q>{0.4, 0.2, 0.3}, Q{});
  Builder point, line, two;
  shape_cost("soft_point", SoftPoint<Q>{{0.1, 0.0, 0.2}, influence}, point, point.table(kPotential));
  shape_cost("soft_segment", SoftSegment<Q>{segment, influence}, line, line.table(kPotential));
  const uint32_t table = two.table(kPotential);
  const SoftPoint<Q> soft = {{0.1, 0.0, 0.2}, influence};
  Builder lone;
  lone.operation(soft, lone.table(kPotential));
  const Budget one = less(worst_of(lone), kShare);
  two.operation(soft, table).operation(soft, table).operation(SoftSum<Q>{});
  report("soft_sum", less(less(less(worst_of(two), kShare), one), one), cortex_m4_cost(Operation::soft_sum));
}

void frame_costs() {
  Builder lone, posed, slotted;
  lone.operation(kBall);
  const Budget ball = worst_of(lone);
  Pose<Q> pose;
  pose.rotation.row[0] = {0.0, -1.0, 0.0};
  pose.rotation.row[1] = {1.0, 0.0, 0.0};
  posed.enter(pose).operation(kBall).leave();
  report("enter_pose and leave", less(worst_of(posed), ball),
         cortex_m4_cost(Operation::enter_pose) + cortex_m4_cost(Operation::leave));
  slotted.enter_slot(0).operation(kBall).leave();
  report("enter_slot and leave", less(worst_of(slotted), ball),
         cortex_m4_cost(Operation::enter_slot) + cortex_m4_cost(Operation::leave));
}

// A query of a field in a slot, and one through the C interface, against the budgets that they state themselves.
__attribute__((noinline)) Clearance<Q> clearance_in_slot(const Program<Q>& program, const Vector3<Q>& p) {
  return clearance(program, p, &kSlot, 1);
}
void whole_query_costs() {
  Builder builder;
  builder.enter_slot(0).operation(kBall).leave();
  builder.finish();
  const Program<Q> program = load<Q>(builder.words(), builder.size() * 4);
  nearfield_field from_c = {};
  nearfield_load(&from_c, builder.words(), builder.size() * 4);
  nearfield_pose pose_from_c = {{1 << 30, 0, 0, 0, 1 << 30, 0, 0, 0, 1 << 30}, {0, 0, 0}};
  uint32_t in_slot = 0, in_c = 0;
  Random random;
  for (int i = 0; i < kPoints; ++i) {
    const Vector3<Q> p = random.point();
    board::start_instruction_count();
    const Clearance<Q> c = clearance_in_slot(program, p);
    const uint32_t count = board::stop_instruction_count();
    const int32_t point[3] = {p.x.raw(), p.y.raw(), p.z.raw()};
    board::start_instruction_count();
    const nearfield_clearance d = nearfield_clearance_at(&from_c, point, &pose_from_c, 1);
    const uint32_t count_c = board::stop_instruction_count();
    sink = c.distance.raw() + d.distance;
    if (count > in_slot) in_slot = count;
    if (count_c > in_c) in_c = count_c;
  }
  report("query of a ball in a slot", {0, in_slot}, {0, program.budget().gradient});
  report("the same from C", {0, in_c}, {0, nearfield_budget(&from_c)});
}

void query_cost() {
  Builder builder;
  builder.operation(kBall);
  const Budget evaluation = worst_of(builder);
  const Program<Q> program = load<Q>(builder.words(), builder.size() * 4);
  uint32_t worst = 0;
  Random random;
  for (int i = 0; i < kPoints; ++i) {
    const Vector3<Q> p = random.point();
    board::start_instruction_count();
    const Clearance<Q> c = clearance_at(program, p);
    const uint32_t count = board::stop_instruction_count();
    sink = c.distance.raw();
    if (count > worst) worst = count;
  }
  const uint32_t around = worst - evaluation.gradient + kQueryShare;
  report("query", {kQueryShare, around}, kCortexM4QueryCost);
}

// What the queries above fields cost: each over random inputs that meet their preconditions.
using TestChain = Chain<Q, 9, 9>;
__attribute__((noinline)) KinematicsStatus poses_of(const TestChain& chain, const Q* values, Pose<Q>* poses) {
  return chain.link_poses(values, poses);
}
__attribute__((noinline)) Capsule<Q> body_of(const TestChain& chain, const Pose<Q>* poses) { return chain.placed_body(0, poses); }
__attribute__((noinline)) SeparatedBy<Q> separation_of(const Capsule<Q>& a, const Capsule<Q>& b) { return separation(a, b); }
__attribute__((noinline)) NearestCapsule<Q> nearest_of(const Program<Q>& program, const MovedCapsule<Q>* capsules, uint16_t count,
                                                       Stretch<Q>* stretches, int refinements) {
  return clearance(program, capsules, count, stretches, {refinements, Q{}});
}

template <class Work> uint32_t worst_over(int trials, Work&& work) {
  uint32_t worst = 0;
  for (int i = 0; i < trials; ++i) {
    const uint32_t count = work();
    if (count > worst) worst = count;
  }
  return worst;
}

Capsule<Q> random_capsule(Random& random) {
  const Vector3<Q> a = random.point(), b = random.next() % 16 == 0 ? a : random.point();
  return Capsule<Q>(a, b, Q(0.1));
}

void one(const char* name, uint32_t measured, uint32_t stated) { report(name, {measured, 0}, {stated, 0}); }

void query_costs() {
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
  one("eight revolute joints", worst_poses(chain, 2), chain.poses_budget());
  one("eight prismatic joints", worst_poses(sliding, 512), sliding.poses_budget());
  one("placed body", worst_over(10, [&] {
        board::start_instruction_count();
        const Capsule<Q> body = body_of(chain, poses);
        const uint32_t count = board::stop_instruction_count();
        sink = body.length.raw();
        return count;
      }), Monitor::cost_per_placed_body);
  one("capsule pair", 25 + worst_over(20000, [&] {
        const Capsule<Q> a = random_capsule(random), b = random_capsule(random);
        board::start_instruction_count();
        const SeparatedBy<Q> apart = separation_of(a, b);
        const uint32_t count = board::stop_instruction_count();
        sink = apart.distance.raw();
        return count;
      }), kCapsulePairCost);

  Builder builder;
  builder.operation(Box<Q>{{0.1, 0.0, 0.0}, {0.3, 0.2, 0.4}}).operation(Sphere<Q>{{0.15, 0.25, 0.0}, 0.3}).operation(SharpUnion<Q>{});
  builder.finish();
  const Program<Q> program = load<Q>(builder.words(), builder.size() * 4);
  static Stretch<Q> stretches[16 + kMostRefinements];
  static MovedCapsule<Q> capsules[16];
  constexpr int efforts[] = {0, 12, kMostRefinements};
  constexpr uint16_t counts[] = {1, 9, 16};
  for (const int refinements : efforts) {
    for (const uint16_t count : counts) {
      board::write_decimal(count);
      board::write(" capsules, ");
      board::write_decimal(static_cast<uint64_t>(refinements));
      one(" refinements", worst_over(300, [&] {
            for (MovedCapsule<Q>& c : capsules) c.capsule = random_capsule(random);
            board::start_instruction_count();
            const NearestCapsule<Q> nearest = nearest_of(program, capsules, count, stretches, refinements);
            const uint32_t instructions = board::stop_instruction_count();
            sink = nearest.clearance.distance.raw();
            return instructions;
          }), sweep_budget(program, count, static_cast<uint32_t>(refinements)));
    }
  }
}

}  // namespace

int main() {
  if (!board::prepare_instruction_counter()) return 1;
  board::write("worst instructions of each operation on this core, of those stated in field/operations.hpp\n");
  Builder sphere, capsule, box, cylinder, sum;
  shape_cost("sphere", kBall, sphere);
  shape_cost("capsule", Capsule<Q>(Vector3<Q>{-0.3, 0.1, 0.0}, Vector3<Q>{0.4, 0.2, 0.3}, Q(0.1)), capsule);
  shape_cost("box", Box<Q>{{0.1, 0.0, 0.0}, {0.3, 0.2, 0.4}}, box);
  shape_cost("cylinder", Cylinder<Q>{{0.1, 0.0, 0.0}, 0.3, 0.4}, cylinder);
  Builder unite, intersect, subtract;
  blend_cost("sharp_union", SharpUnion<Q>{}, unite);
  blend_cost("sharp_intersection", SharpIntersection<Q>{}, intersect);
  blend_cost("sharp_subtraction", SharpSubtraction<Q>{}, subtract);
  exterior_cost<AdditiveUnion>("exterior_union");
  exterior_cost<AdditiveIntersection>("exterior_intersection");
  exterior_cost<AdditiveSubtraction>("exterior_subtraction");
  soft_costs();
  frame_costs();
  query_cost();
  whole_query_costs();
  query_costs();
  return failures == 0 ? 0 : 1;
}
