// Clearance of a whole capsule to a field, by a fixed number of evaluations.
#pragma once

#include <nearfield/query/clearance.hpp>

namespace nearfield {

// How a capsule is sampled: `evaluations` of the field's value along its axis, at the worst, plus one with gradient.
// Fewer are made when more cannot raise the answer by `tolerance` (metres).
template <class S> struct SweepEffort {
  int evaluations = 8;  // 2 ... 16; a ball needs none of them
  S tolerance{};
};

namespace detail {

// Whatever is outside both of two balls of free space, `first` and `second` in radius and `apart` between centres, is
// at least this far from the segment between the centres. Rounded down. Valid for negative radii, too.
// Two bounds: the ring where two balls of the lesser radius meet; and the rate 1 at which distance can change.
template <class S> constexpr S free_around_segment(S first, S second, S apart) {
  const S low = least_of_two(first, second), high = greatest_of_two(first, second);
  const S half = ScalarTraits<S>::half(apart);
  // Twice, for `apart` may be odd: the rounding of `half` is undone by taking half a unit more.
  const S half_up = subtract_in_range(apart, half);
  S bound = ScalarTraits<S>::half(low - (apart - high));
  if (low > half_up) {
    const S ring = other_leg(low, half_up);
    if (bound < ring) bound = ring;
  }
  return least_of_two(bound, low);
}

}  // namespace detail

// Clearance of a capsule that is given in the field's frame with its position known to within `body_error`.
// `touching`: for certain the field's value, less the radius, is not positive somewhere on the axis.
// Cost: effort.evaluations * (field.budget().value + 330) + field.budget().gradient at the most, on Cortex-M4.
template <class AnyField, class S = typename AnyField::Scalar>
constexpr Clearance<S> clearance(const AnyField& field, const Capsule<typename AnyField::Scalar>& capsule,
                                 typename AnyField::Scalar body_error, SweepEffort<typename AnyField::Scalar> effort,
                                 const Pose<typename AnyField::Scalar>* slots = nullptr, uint32_t slot_count = 0) {
  constexpr int capacity = 16;
  Clearance<S> answer;
  const Vector3<S> end = add_in_range(capsule.from, capsule.along(capsule.length));
  if (!detail::may_be_asked(field, capsule.from, slots, slot_count) || !coordinates_in_domain(end) ||
      !detail::valid_poses(slots, field.slot_count()) || !capsule.valid(Capsule<S>::kMovedAxisSlack) || body_error < S{}) {
    return answer;
  }
  const detail::Certifier<S> certifier(field.certificate());
  const S zero{};

  S best_value{}, best_place{}, least_bound{};
  if (capsule.length > zero) {
    const int limit = effort.evaluations < 2 ? 2 : effort.evaluations > capacity ? capacity : effort.evaluations;
    // Places along the axis in ascending order, the free radius around each, and the bound of the stretch after it.
    S place[capacity] = {}, free_radius[capacity] = {}, stretch[capacity] = {};
    const auto evaluate = [&](int i) {
      const Vector3<S> p = add_in_range(capsule.from, capsule.along(place[i]));
      const S value = field.template evaluate<Value<S>>(p, slots).value;
      free_radius[i] = certifier.lower_bound(value);
      if (i == 0 || value < best_value) {
        best_value = value;
        best_place = place[i];
      }
    };
    evaluate(0);
    place[1] = capsule.length;
    evaluate(1);
    int count = 2, weakest = 0;
    stretch[0] = detail::free_around_segment(free_radius[0], free_radius[1], capsule.length);
    while (true) {
      least_bound = stretch[weakest];
      const S attained = certifier.lower_bound(best_value);
      if (count == limit || attained - least_bound <= effort.tolerance) break;
      // Split the stretch with the least bound in the middle.
      for (int i = count; i > weakest + 1; --i) {
        place[i] = place[i - 1];
        free_radius[i] = free_radius[i - 1];
        stretch[i] = stretch[i - 1];
      }
      const int middle = weakest + 1;
      place[middle] = add_in_range(place[weakest],
                                   ScalarTraits<S>::half(subtract_in_range(place[middle + 1], place[weakest])));
      ++count;
      evaluate(middle);
      for (int i = weakest; i <= middle; ++i) {
        stretch[i] = detail::free_around_segment(free_radius[i], free_radius[i + 1],
                                                 subtract_in_range(place[i + 1], place[i]));
      }
      weakest = 0;
      for (int i = 1; i + 1 < count; ++i) {
        if (stretch[i] < stretch[weakest]) weakest = i;
      }
    }
  }
  const Vector3<S> nearest = add_in_range(capsule.from, capsule.along(best_place));
  const Sample<S> sample = field.template evaluate<Sample<S>>(nearest, slots);
  if (!(capsule.length > zero)) least_bound = certifier.lower_bound(sample.value);
  answer.distance = least_bound - capsule.radius - body_error;
  answer.status = answer.distance > zero ? ClearanceStatus::clear
                                         : certifier.status(sample.value - capsule.radius + body_error, answer.distance);
  answer.direction = sample.gradient;
  return answer;
}

}  // namespace nearfield
