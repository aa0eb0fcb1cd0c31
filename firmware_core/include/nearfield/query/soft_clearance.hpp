// Clearance to a soft surface: where an intensity is 1/2.
#pragma once

#include <nearfield/query/clearance.hpp>

namespace nearfield {

// Evaluations of highest() in one query.
inline constexpr int kSoftClearanceSteps = 16;

namespace detail {

// The radii that a query tries, in ascending order: 32 octaves of 2048 each, so that any distance is within 2^-11 of one.
// For Fixed they end just below the greatest number, for float just below 64 m; code 0 is 0.
template <class S> constexpr S soft_clearance_radius(uint32_t code) {
  const uint32_t octave = code >> 11, within_octave = 2048 + (code & 2047u);
  if constexpr (ScalarTraits<S>::is_fixed) {
    const uint32_t raw = octave >= 12 ? within_octave << (octave - 12) : within_octave >> (12 - octave);
    return S::from_raw(static_cast<int32_t>(raw));
  } else {
    return code == 0 ? 0.0f : bits_as<float>((octave + 101) << 23 | (within_octave & 2047u) << 12);
  }
}

template <class AnyField, class S>
constexpr bool may_be_asked_softly(const AnyField& field, const Vector3<S>& p, const Slots<S>& slots) {
  return field.valid() && field.has_highest() && slots_given(field, slots) &&
         field.certificate().error < ScalarTraits<S>::half(ScalarTraits<S>::one()) && coordinates_in_domain(p) &&
         valid_slots(field, slots);
}

}  // namespace detail

// Worst-case instructions of a query below.
template <class AnyField> constexpr uint32_t soft_clearance_budget(const AnyField& field, const Target& target = kThisTarget) {
  const Budget of_field = field.budget(target);
  const Budget steps = static_cast<uint32_t>(kSoftClearanceSteps) * of_field;
  return detail::sum_of_costs((of_field + target.cost(QueryPart::soft_clearance)).gradient, steps.highest);
}

// A ball around p (metres, field frame, within ScalarTraits<S>::domain()) in which an intensity, a Field or a Program, is
// nowhere 1/2 or more: the greatest that highest() proves, to 2^-11 of its radius (and a unit in the last place).
// Exact but for that for a lone object. Status: clear, distance > 0; touching, for certain; undecided: nearer to the
// surface than can be told; invalid (distance the least number): the field is not a valid intensity, has operations or
// operands that tell nothing of a ball, an error that is not below 1/2; or point or poses are not acceptable. `direction`:
// minus the intensity's gradient, a unit vector; zero where there is none.
// Cost: at most soft_clearance_budget().
template <class AnyField, class S = typename AnyField::Scalar>
constexpr Clearance<S> soft_clearance(const AnyField& field, const Vector3<typename AnyField::Scalar>& p,
                                      const Slots<typename AnyField::Scalar>& slots = {}) {
  using T = ScalarTraits<S>;
  Clearance<S> answer;
  if (!detail::may_be_asked_softly(field, p, slots)) return answer;
  const Sample<S> sample = field.template evaluate<Sample<S>>(p, slots);
  const S surface = T::half(T::one()), error = field.certificate().error;
  answer.direction = -direction_of<S>(sample.gradient);
  answer.distance = S{};
  answer.status = ClearanceStatus::touching;
  if (sample.value - error >= surface) return answer;
  const S allowed = surface - error;
  uint32_t code = 0;
  for (uint32_t step = 1u << (kSoftClearanceSteps - 1); step != 0; step >>= 1) {
    const S radius = detail::soft_clearance_radius<S>(code + step);
    if (field.highest(p, radius, slots).value < allowed) code += step;
  }
  answer.distance = detail::soft_clearance_radius<S>(code);
  answer.status = answer.distance > S{} ? ClearanceStatus::clear : ClearanceStatus::undecided;
  return answer;
}

template <class AnyField, class S = typename AnyField::Scalar>
constexpr Clearance<S> soft_clearance(const AnyField& field, const Vector3<typename AnyField::Scalar>& p,
                                      const Pose<typename AnyField::Scalar>* poses, uint32_t pose_count) {
  return soft_clearance(field, p, Slots<S>(poses, pose_count));
}

}  // namespace nearfield
