// One control tick of an arm: poses, clearances, zone, speed and a direction to flee, each from the layers below.
#pragma once

#include <nearfield/query/capsule_clearance.hpp>
#include <nearfield/query/capsule_pair.hpp>
#include <nearfield/query/chain.hpp>
#include <nearfield/query/zone.hpp>

namespace nearfield {

// A clearance and what it is between. Body numbers of the arm (`body`) and of the person or the arm (`other`);
// none where the answer is not about one.
inline constexpr uint16_t kNoBody = 0xffff;
template <class S> struct NearestBodies {
  Clearance<S> clearance;
  uint16_t body = kNoBody;
  uint16_t other = kNoBody;
};

template <class S> struct ArmTick {
  KinematicsStatus kinematics = KinematicsStatus::invalid;         // of the arm
  KinematicsStatus person_kinematics = KinematicsStatus::invalid;  // ok if nobody is there
  NearestBodies<S> cell, person, itself;
  Zone zone = Zone::stop;
  S speed_override{};      // 0 ... 1
  S intensity{};           // of the soft field at the tool, 1
  Vector3<S> repulsion{};  // unit vector down the soft field's gradient at the tool, or zero
};

// The fixed part. `Cell` and `Soft` are fields (Field or Program): Cell of distances, evaluated without slots; Soft of
// intensities, whose slots are the person's links. Pointers must stay valid.
template <class ArmChain, class PersonChain, class Cell, class Soft> struct ArmMonitor {
  using S = typename ArmChain::Scalar;

  const ArmChain* arm = nullptr;
  const PersonChain* person = nullptr;  // null: nobody
  const Cell* cell = nullptr;
  const Soft* soft = nullptr;           // null: no repulsion
  const uint8_t* checked_against_cell = nullptr;  // one flag per arm body
  const BodyPair* self_pairs = nullptr;           // arm bodies that must be kept apart
  uint16_t self_pair_count = 0;
  uint16_t tool_link = 0;
  SweepEffort<S> effort;
  SpeedRamp<S> person_ramp;
  SpeedRamp<S> cell_ramp;

  // Joint values of arm and person: radians, metres. Everything that goes wrong stops the arm and says what it was.
  // Cost: budget().
  constexpr ArmTick<S> tick(const S* arm_joints, const S* person_joints) const {
    ArmTick<S> out;
    if (!consistent()) return out;
    Pose<S> arm_poses[ArmChain::max_links] = {};
    Pose<S> person_poses[PersonChain::max_links] = {};
    out.kinematics = arm->link_poses(arm_joints, arm_poses);
    out.person_kinematics = person == nullptr ? KinematicsStatus::ok : person->link_poses(person_joints, person_poses);
    if (out.kinematics != KinematicsStatus::ok || out.person_kinematics != KinematicsStatus::ok) return out;

    Capsule<S> bodies[ArmChain::max_bodies] = {};
    for (uint16_t i = 0; i < arm->body_count(); ++i) bodies[i] = arm->placed_body(i, arm_poses);
    to_cell(bodies, out.cell);
    to_person(bodies, person_poses, out.person);
    to_itself(bodies, out.itself);

    out.zone = least_of_two(person_ramp.zone(out.person.clearance), cell_ramp.zone(out.cell.clearance));
    out.speed_override =
        least_of_two(person_ramp.override_for(out.person.clearance), cell_ramp.override_for(out.cell.clearance));
    if (out.itself.clearance.status != ClearanceStatus::clear) {
      out.zone = Zone::stop;
      out.speed_override = S{};
    }
    repel(arm_poses[tool_link].translation, person_poses, out);
    return out;
  }

  // Worst-case instructions of a tick, of a monitor with chains of at most `capacity` links and bodies each.
  constexpr uint32_t budget(const Target& target = kThisTarget, uint32_t capacity = greatest_capacity) const {
    const uint32_t bodies = arm->body_count(), person_bodies = person == nullptr ? 0 : person->body_count();
    uint32_t near_cell = 0;
    for (uint32_t i = 0; i < bodies; ++i) near_cell += checked_against_cell[i] != 0 ? 1 : 0;
    // QueryPart::tick is what a tick costs besides its parts, of chains of up to 16 links and bodies.
    const Budget own = (capacity + 15) / 16 * target.cost(QueryPart::tick) +
                       (bodies + person_bodies) * target.cost(QueryPart::placed_body) +
                       (bodies * person_bodies + self_pair_count) * target.cost(QueryPart::capsule_pair);
    // Poses from link_poses() are not checked again.
    const uint32_t of_soft =
        soft == nullptr ? 0
                        : soft->budget(target).gradient - soft->slot_count() * target.cost(QueryPart::pose_check).gradient;
    uint32_t sum = detail::sum_of_costs(own.value, arm->poses_budget(target));
    if (person != nullptr) sum = detail::sum_of_costs(sum, person->poses_budget(target));
    sum = detail::sum_of_costs(sum, sweep_budget(*cell, near_cell, static_cast<uint32_t>(effort.refinements), target));
    return detail::sum_of_costs(sum, of_soft);
  }

 private:
  static constexpr uint32_t greatest_capacity =
      greatest_of_two<uint32_t>(greatest_of_two<uint32_t>(ArmChain::max_links, ArmChain::max_bodies),
                                PersonChain::max_links);

  // Everything that a tick refers to is there, and every number names something.
  constexpr bool consistent() const {
    if (arm == nullptr || cell == nullptr || checked_against_cell == nullptr || arm->body_count() == 0) return false;
    if (tool_link >= arm->link_count() || (self_pair_count != 0 && self_pairs == nullptr)) return false;
    for (uint16_t k = 0; k < self_pair_count; ++k) {
      if (self_pairs[k].first >= arm->body_count() || self_pairs[k].second >= arm->body_count()) return false;
    }
    return true;
  }

  // The nearest pair so far; its clearance is made of it only at the end.
  struct NearestPair {
    SeparatedBy<S> apart;
    S error{}, distance{};
    uint16_t first = kNoBody, second = kNoBody;

    constexpr void consider(const SeparatedBy<S>& candidate, S candidate_error, uint16_t i, uint16_t j) {
      const S candidate_distance = candidate.distance - candidate_error;
      if (first != kNoBody && !(candidate_distance < distance)) return;
      apart = candidate;
      error = candidate_error;
      distance = candidate_distance;
      first = i;
      second = j;
    }
    constexpr NearestBodies<S> result() const {
      if (first == kNoBody) return {nothing_there(), kNoBody, kNoBody};
      return {clearance_of(apart, error), first, second};
    }
  };
  static constexpr Clearance<S> nothing_there() {
    return {ClearanceStatus::clear, ScalarTraits<S>::greatest(), {}};
  }

  constexpr void to_cell(const Capsule<S>* bodies, NearestBodies<S>& least) const {
    MovedCapsule<S> moved[ArmChain::max_bodies] = {};
    Stretch<S> stretches[ArmChain::max_bodies + kMostRefinements] = {};
    uint16_t count = 0;
    for (uint16_t i = 0; i < arm->body_count(); ++i) {
      if (checked_against_cell[i] != 0) moved[count++] = {bodies[i], arm->body_error(i), i};
    }
    least.clearance = nothing_there();
    if (count == 0) return;
    const NearestCapsule<S> nearest = clearance(*cell, moved, count, stretches, effort);
    least = {nearest.clearance, nearest.number, kNoBody};
  }
  constexpr void to_person(const Capsule<S>* bodies, const Pose<S>* person_poses, NearestBodies<S>& least) const {
    NearestPair nearest;
    for (uint16_t j = 0; person != nullptr && j < person->body_count(); ++j) {
      const Capsule<S> limb = person->placed_body(j, person_poses);
      const S error = person->body_error(j);
      for (uint16_t i = 0; i < arm->body_count(); ++i) {
        nearest.consider(separation(bodies[i], limb), add_in_range(arm->body_error(i), error), i, j);
      }
    }
    least = nearest.result();
  }
  constexpr void to_itself(const Capsule<S>* bodies, NearestBodies<S>& least) const {
    NearestPair nearest;
    for (uint16_t k = 0; k < self_pair_count; ++k) {
      const uint16_t i = self_pairs[k].first, j = self_pairs[k].second;
      nearest.consider(separation(bodies[i], bodies[j]), add_in_range(arm->body_error(i), arm->body_error(j)), i, j);
    }
    least = nearest.result();
  }
  constexpr void repel(const Vector3<S>& tool, const Pose<S>* person_poses, ArmTick<S>& out) const {
    if (soft == nullptr || !soft->valid() || soft->kind() != Kind::intensity || !coordinates_in_domain(tool)) return;
    const uint32_t poses = person == nullptr ? 0u : person->link_count();
    if (soft->slot_count() > poses || soft->parameter_count() != 0) return;  // those there are come from link_poses(), and are valid
    const Sample<S> sample = soft->template evaluate<Sample<S>>(tool, person_poses);
    out.intensity = sample.value;
    out.repulsion = -polar<S>(sample.gradient).direction;
  }
};

}  // namespace nearfield
