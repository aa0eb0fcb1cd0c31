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
  // m. Clear: positive, a lower bound of the distance to the blended surface and to the sharp solids. Otherwise not
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

template <class AnyField, class S>
constexpr bool may_be_asked(const AnyField& field, const Vector3<S>& p, const Pose<S>* slots, uint32_t slot_count) {
  if (!field.valid() || field.kind() != Kind::distance || field.slot_count() > slot_count) return false;
  if (field.slot_count() != 0 && slots == nullptr) return false;
  return coordinates_in_domain(p);
}

// Both ends of a capsule within the domain, its axis as a pose may have turned it.
template <class S> constexpr bool in_domain(const Capsule<S>& c) {
  return c.valid(Capsule<S>::kMovedAxisSlack) && coordinates_in_domain(add_in_range(c.from, c.along(c.length)));
}

template <class S> constexpr bool valid_poses(const Pose<S>* slots, uint32_t count) {
  if (slots == nullptr) return count == 0;
  for (uint32_t i = 0; i < count; ++i) {
    if (!valid_pose(slots[i])) return false;
  }
  return true;
}

}  // namespace detail

// Clearance of a point (metres, field frame, |coordinates| within ScalarTraits<S>::domain()) to a distance field: a
// Field from compose.hpp or a Program. `slots`: the poses of the field's slots; each is checked.
// Cost: at most field.budget().gradient.
template <class AnyField, class S = typename AnyField::Scalar>
constexpr Clearance<S> clearance(const AnyField& field, const Vector3<typename AnyField::Scalar>& p,
                                 const Pose<typename AnyField::Scalar>* slots = nullptr, uint32_t slot_count = 0) {
  Clearance<S> answer;
  if (!detail::may_be_asked(field, p, slots, slot_count) || !detail::valid_poses(slots, field.slot_count())) return answer;
  const Sample<S> sample = field.template evaluate<Sample<S>>(p, slots);
  const detail::Certifier<S> certifier(field.certificate());
  answer.distance = certifier.lower_bound(sample.value);
  answer.status = certifier.status(sample.value, answer.distance);
  answer.direction = sample.gradient;
  return answer;
}

}  // namespace nearfield
