#include <tick_costs/composed.hpp>

#include <work_cell.inc>

#include <tick_costs/composed_fields.hpp>

namespace nearfield::composed {
namespace {

using work_cell::Q;

// The numbers of the baked robots.
template <class S, class T> constexpr auto converted(T x) {
  if constexpr (ScalarTraits<S>::is_fixed) return x;
  else return static_cast<float>(x.raw()) * (1.0f / static_cast<float>(int64_t{1} << T::fraction_bits));
}
template <class S, class T> constexpr auto converted(const Vector3<T>& v) {
  return Vector3<decltype(converted<S>(v.x))>{converted<S>(v.x), converted<S>(v.y), converted<S>(v.z)};
}

template <class S, int links, int bodies, size_t joint_count, size_t body_count>
constexpr Chain<S, links, bodies> chain_of(const Joint<Q> (&joints)[joint_count], const Body<Q> (&list)[body_count]) {
  Chain<S, links, bodies> chain;
  for (const Joint<Q>& joint : joints) {
    Joint<S> made;
    made.kind = joint.kind;
    made.parent = joint.parent;
    made.variable = joint.variable;
    for (int k = 0; k < 3; ++k) made.origin.rotation.row[k] = converted<S>(joint.origin.rotation.row[k]);
    made.origin.translation = converted<S>(joint.origin.translation);
    made.axis = converted<S>(joint.axis);
    made.multiplier = converted<S>(joint.multiplier);
    made.offset = converted<S>(joint.offset);
    made.lower = converted<S>(joint.lower);
    made.upper = converted<S>(joint.upper);
    chain.add_joint(made);
  }
  for (const Body<Q>& body : list) {
    const Capsule<Q>& c = body.capsule;
    const auto from = converted<S>(c.from);
    chain.add_body({body.link, Capsule<S>(from, converted<S>(c.axis), converted<S>(c.length), converted<S>(c.radius))});
  }
  return chain;
}
template <class S>
constexpr auto kArm = chain_of<S, work_cell::kArmLinks, work_cell::kArmBodies>(work_cell::kArmJoints, work_cell::kArmBodyList);
template <class S>
constexpr auto kPerson =
    chain_of<S, work_cell::kPersonLinks, work_cell::kPersonBodies>(work_cell::kPersonJoints, work_cell::kPersonBodyList);

template <class ArmChain, class PersonChain, class Cell, class Soft>
constexpr auto monitor_of(const ArmChain& arm, const PersonChain& person, const Cell& cell, const Soft& soft) {
  using S = typename ArmChain::Scalar;
  const work_cell::WorkCell& data = work_cell::kWorkCell;
  ArmMonitor<ArmChain, PersonChain, Cell, Soft> monitor;
  monitor.arm = &arm;
  monitor.person = &person;
  monitor.cell = &cell;
  monitor.soft = &soft;
  monitor.checked_against_cell = data.checked_against_cell.data;
  monitor.self_pairs = data.self_pairs.data;
  monitor.self_pair_count = static_cast<uint16_t>(data.self_pairs.count);
  monitor.tool_link = data.tool_link;
  monitor.effort = {data.refinements, converted<S>(data.tolerance)};
  monitor.person_ramp = SpeedRamp<S>(converted<S>(data.person_stop), converted<S>(data.person_free));
  monitor.cell_ramp = SpeedRamp<S>(converted<S>(data.cell_stop), converted<S>(data.cell_free));
  return monitor;
}
template <class S> constexpr auto kMonitor = monitor_of(kArm<S>, kPerson<S>, kCell<S>, kPresence<S>);
static_assert(kArm<Q>.valid() && kPerson<Q>.valid() && kCell<Q>.valid() && kPresence<Q>.valid());
static_assert(kArm<float>.valid() && kPerson<float>.valid() && kCell<float>.valid() && kPresence<float>.valid());

}  // namespace

void tick(const Q* arm_joints, const Q* person_joints, ArmTick<Q>& out) {
  out = kMonitor<Q>.tick(arm_joints, person_joints);
}
void tick(const float* arm_joints, const float* person_joints, ArmTick<float>& out) {
  out = kMonitor<float>.tick(arm_joints, person_joints);
}

}  // namespace nearfield::composed
