// Measures what each operation of a program costs at the worst, dispatch included, and checks the table of
// nearfield/field/budget.hpp against it. A program of one shape costs the query's own share plus that shape; each
// further pair of shape and blend their sum. Points are drawn around each shape so that all its branches are taken.
#include <nearfield/field/builder.hpp>
#include <nearfield/nearfield.hpp>

#include <mps2/instruction_counter.hpp>
#include <mps2/semihosting.hpp>

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
    mps2::write("a program does not load\n");
    mps2::exit_with_status(1);
  }
  const Program<Q> program = load<Q>(builder.words(), builder.size() * 4);
  Budget worst;
  Random random;
  for (int i = 0; i < kPoints; ++i) {
    const Vector3<Q> p = random.point();
    mps2::start_instruction_count();
    const Value<Q> value = value_at(program, p, &kSlot);
    const uint32_t value_count = mps2::stop_instruction_count();
    mps2::start_instruction_count();
    const Sample<Q> sample = sample_at(program, p, &kSlot);
    const uint32_t gradient_count = mps2::stop_instruction_count();
    sink = value.value.raw() + sample.value.raw();
    if (value_count > worst.value) worst.value = value_count;
    if (gradient_count > worst.gradient) worst.gradient = gradient_count;
  }
  return worst;
}

int failures = 0;

void report(const char* name, Budget measured, Budget stated) {
  mps2::write(name);
  mps2::write(": ");
  mps2::write_decimal(measured.value);
  mps2::write(" of ");
  mps2::write_decimal(stated.value);
  mps2::write(", with gradient ");
  mps2::write_decimal(measured.gradient);
  mps2::write(" of ");
  mps2::write_decimal(stated.gradient);
  const bool broken = measured.value > stated.value || measured.gradient > stated.gradient;
  mps2::write(broken ? "  EXCEEDED\n" : "\n");
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
constexpr auto kPotential = bake<Q, 3>(potential::wyvill);
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

void query_cost() {
  Builder builder;
  builder.operation(kBall);
  const Budget evaluation = worst_of(builder);
  const Program<Q> program = load<Q>(builder.words(), builder.size() * 4);
  uint32_t worst = 0;
  Random random;
  for (int i = 0; i < kPoints; ++i) {
    const Vector3<Q> p = random.point();
    mps2::start_instruction_count();
    const Clearance<Q> c = clearance_at(program, p);
    const uint32_t count = mps2::stop_instruction_count();
    sink = c.distance.raw();
    if (count > worst) worst = count;
  }
  const uint32_t around = worst - evaluation.gradient + kQueryShare;
  report("query", {kQueryShare, around}, kCortexM4QueryCost);
}

}  // namespace

int main() {
  if (!mps2::prepare_instruction_counter()) return 1;
  mps2::write("worst instructions of each operation on this core, of those stated in budget.hpp\n");
  Builder sphere, capsule, box, cylinder, sum;
  shape_cost("sphere", kBall, sphere);
  shape_cost("capsule", Capsule<Q>(Vector3<Q>{-0.3, 0.1, 0.0}, Vector3<Q>{0.4, 0.2, 0.3}, Q(0.1)), capsule);
  shape_cost("box", Box<Q>{{0.1, 0.0, 0.0}, {0.3, 0.2, 0.4}}, box);
  shape_cost("cylinder", Cylinder<Q>{{0.1, 0.0, 0.0}, 0.3, 0.4}, cylinder);
  Builder unite, intersect, subtract;
  blend_cost("sharp_union", SharpUnion<Q>{}, unite);
  blend_cost("sharp_intersection", SharpIntersection<Q>{}, intersect);
  blend_cost("sharp_subtraction", SharpSubtraction<Q>{}, subtract);
  exterior_cost<ExteriorUnion>("exterior_union");
  exterior_cost<ExteriorIntersection>("exterior_intersection");
  exterior_cost<ExteriorSubtraction>("exterior_subtraction");
  soft_costs();
  frame_costs();
  query_cost();
  return failures == 0 ? 0 : 1;
}
