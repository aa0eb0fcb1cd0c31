// The question that Nearfield answers: how far is it at least, and which way is away?
#pragma once

#include <nearfield/field/compose.hpp>
#include <nearfield/field/program.hpp>

namespace nearfield {

// Only `clear` permits anything. The zero of the type is the most careful answer.
enum class ClearanceStatus : uint8_t {
  invalid = 0,    // no answer: field not valid or not a distance, point outside the domain (or NaN), bad or missing pose
  touching = 1,   // touching or inside, for certain
  undecided = 2,  // the surface is closer than the certified error, or the budget did not suffice to tell
  clear = 3,      // nothing nearer than `distance`
};

template <class S> struct Clearance {
  ClearanceStatus status = ClearanceStatus::invalid;
  // m. Clear: positive, a lower bound of the distance to the blended surface and to the sharp solids (of a morph between
  // solids that are not the same to its own surface alone). Otherwise not
  // positive: the field's value less its error, which is how deep the point is in a lone shape; where solids overlap it
  // may be deeper. Invalid: the least number.
  S distance = ScalarTraits<S>::least();
  Vector3<S> direction{};  // away from what is nearest: the field's gradient, a unit vector for a lone shape, shorter
                           // within a blend; zero where there is no direction
};

// The nearer of two answers: invalid before everything else, then the lesser distance.
template <class S> constexpr const Clearance<S>& nearer(const Clearance<S>& a, const Clearance<S>& b) {
  if (b.status == ClearanceStatus::invalid || a.status == ClearanceStatus::invalid) {
    return a.status == ClearanceStatus::invalid ? a : b;
  }
  return b.distance < a.distance ? b : a;
}

namespace detail {

// Turns a field value into a clearance: (value - error - erosion) / lipschitz, not divided when negative.
template <class S> class Certifier {
 public:
  constexpr explicit Certifier(const Certificate<S>& certificate)
      : margin_(certificate.error + certificate.erosion), error_(certificate.error),
        inverse_lipschitz_(reciprocal_down(certificate.lipschitz)) {}

  constexpr S lower_bound(S value) const {
    const S least = value - margin_;
    return least > S{} ? ScalarTraits<S>::divide_down(least, inverse_lipschitz_) : least;
  }
  constexpr ClearanceStatus status(S value, S bound) const {
    return bound > S{} ? ClearanceStatus::clear
           : value + error_ <= S{} ? ClearanceStatus::touching : ClearanceStatus::undecided;
  }

 private:
  S margin_, error_;
  Fixed<30> inverse_lipschitz_;
};

// Whether a field has the slots that it asks for; they may still be bad.
template <class AnyField, class S> constexpr bool slots_given(const AnyField& field, const Slots<S>& slots) {
  return field.slot_count() <= slots.pose_count && (field.slot_count() == 0 || slots.poses != nullptr) &&
         field.parameter_count() <= slots.parameter_count && (field.parameter_count() == 0 || slots.parameters != nullptr);
}
// False for a static field of another kind; programs tell at run time.
template <class AnyField> inline constexpr bool may_be_distance = true;
template <class Node> inline constexpr bool may_be_distance<Field<Node>> = Node::kind == Kind::distance;

template <class AnyField, class S>
constexpr bool may_be_asked(const AnyField& field, const Vector3<S>& p, const Slots<S>& slots) {
  static_assert(may_be_distance<AnyField>,
                "only distances have a clearance: declare a box for an algebraic field, ask soft_clearance() of intensities");
  return field.valid() && field.kind() == Kind::distance && slots_given(field, slots) && coordinates_in_domain(p);
}

// Both ends of a capsule within the domain, its axis as a pose may have turned it.
template <class S> constexpr bool in_domain(const Capsule<S>& c) {
  return c.valid(Capsule<S>::kMovedAxisSlack) && coordinates_in_domain(add_in_range(c.from, c.along(c.length)));
}

// Of a field's slots that are given. False for NaN.
template <class AnyField, class S> constexpr bool valid_slots(const AnyField& field, const Slots<S>& slots) {
  for (uint32_t i = 0; i < field.slot_count(); ++i) {
    if (!valid_pose(slots.poses[i])) return false;
  }
  for (uint32_t i = 0; i < field.parameter_count(); ++i) {
    if (!within(slots.parameters[i], S{}, ScalarTraits<S>::one())) return false;
  }
  return true;
}

}  // namespace detail

// Clearance of a point (metres, field frame, |coordinates| within ScalarTraits<S>::domain()) to a distance field: a
// Field from compose.hpp or a Program. `slots`: those of the field, all of which are checked.
// Cost: at most field.budget().gradient.
template <class AnyField, class S = typename AnyField::Scalar>
constexpr Clearance<S> clearance(const AnyField& field, const Vector3<typename AnyField::Scalar>& p,
                                 const Slots<typename AnyField::Scalar>& slots = {}) {
  Clearance<S> answer;
  if (!detail::may_be_asked(field, p, slots) || !detail::valid_slots(field, slots)) return answer;
  const Sample<S> sample = field.template evaluate<Sample<S>>(p, slots);
  const detail::Certifier<S> certifier(field.certificate());
  answer.distance = certifier.lower_bound(sample.value);
  answer.status = certifier.status(sample.value, answer.distance);
  answer.direction = sample.gradient;
  return answer;
}
// The same of a field with poses alone.
template <class AnyField, class S = typename AnyField::Scalar>
constexpr Clearance<S> clearance(const AnyField& field, const Vector3<typename AnyField::Scalar>& p,
                                 const Pose<typename AnyField::Scalar>* poses, uint32_t pose_count) {
  return clearance(field, p, Slots<S>(poses, pose_count));
}

}  // namespace nearfield
