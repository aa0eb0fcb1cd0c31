// The baked work cell as straightforward code takes it: robots, pairs and limits in float.
#pragma once

#include <work_cell/work_cell.hpp>

#include <work_cell.inc>

#include <tick_costs/straightforward.hpp>

namespace nearfield::in_float {

using work_cell::Q;

constexpr float number(Q x) { return static_cast<float>(x.raw()) * (1.0f / 134217728.0f); }
constexpr float number(Unit<Q> x) { return static_cast<float>(x.raw()) * (1.0f / 1073741824.0f); }
template <class T> constexpr straightforward::Point point(const Vector3<T>& v) {
  return {number(v.x), number(v.y), number(v.z)};
}

template <int count> struct Hinges {
  straightforward::Hinge all[size_t{count}];
};
template <int count> constexpr Hinges<count> hinges_of(const Joint<Q> (&joints)[size_t{count}]) {
  Hinges<count> made{};
  for (int i = 0; i < count; ++i) {
    const Joint<Q>& joint = joints[i];
    straightforward::Hinge& hinge = made.all[i];
    hinge.motion = joint.kind == JointKind::revolute    ? straightforward::Motion::turn
                   : joint.kind == JointKind::prismatic ? straightforward::Motion::slide
                                                        : straightforward::Motion::none;
    hinge.parent = joint.parent;
    hinge.variable = joint.variable;
    for (int k = 0; k < 3; ++k) {
      const straightforward::Point row = point(joint.origin.rotation.row[k]);
      hinge.origin.m[3 * k] = row.x;
      hinge.origin.m[3 * k + 1] = row.y;
      hinge.origin.m[3 * k + 2] = row.z;
    }
    hinge.origin.t = point(joint.origin.translation);
    hinge.axis = point(joint.axis);
  }
  return made;
}
template <int count> struct Limbs {
  straightforward::Limb all[size_t{count}];
};
template <int count> constexpr Limbs<count> limbs_of(const Body<Q> (&bodies)[size_t{count}]) {
  Limbs<count> made{};
  for (int i = 0; i < count; ++i) {
    const Capsule<Q>& c = bodies[i].capsule;
    made.all[i] = {bodies[i].link, {point(c.from), point(c.axis), number(c.length), number(c.radius)}};
  }
  return made;
}
template <int count> struct LimbPairs {
  straightforward::LimbPair all[size_t{count}];
};
template <int count> constexpr LimbPairs<count> pairs_of(const BodyPair (&pairs)[size_t{count}]) {
  LimbPairs<count> made{};
  for (int i = 0; i < count; ++i) made.all[i] = {pairs[i].first, pairs[i].second};
  return made;
}
template <class T, size_t size> constexpr int length_of_array(const T (&)[size]) { return static_cast<int>(size); }

inline constexpr auto kArmHinges = hinges_of<length_of_array(work_cell::kArmJoints)>(work_cell::kArmJoints);
inline constexpr auto kPersonHinges = hinges_of<length_of_array(work_cell::kPersonJoints)>(work_cell::kPersonJoints);
inline constexpr auto kArmLimbs = limbs_of<length_of_array(work_cell::kArmBodyList)>(work_cell::kArmBodyList);
inline constexpr auto kPersonLimbs = limbs_of<length_of_array(work_cell::kPersonBodyList)>(work_cell::kPersonBodyList);
inline constexpr auto kLimbPairs = pairs_of<length_of_array(work_cell::kSelfPairs)>(work_cell::kSelfPairs);
inline constexpr const work_cell::WorkCell& kData = work_cell::kWorkCell;
inline constexpr straightforward::Cell kCell = {
    {kArmHinges.all, length_of_array(kArmHinges.all), kArmLimbs.all, length_of_array(kArmLimbs.all)},
    {kPersonHinges.all, length_of_array(kPersonHinges.all), kPersonLimbs.all, length_of_array(kPersonLimbs.all)},
    work_cell::kCheckedAgainstCell,
    kLimbPairs.all,
    length_of_array(kLimbPairs.all),
    kData.tool_link,
    kData.refinements,
    number(kData.tolerance),
    {number(kData.person_stop), number(kData.person_free)},
    {number(kData.cell_stop), number(kData.cell_free)}};
static_assert(length_of_array(kArmLimbs.all) <= straightforward::most_bodies);
static_assert(kData.refinements <= straightforward::most_refinements);

}  // namespace nearfield::in_float
