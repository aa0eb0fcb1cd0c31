// Clearance of capsules and balls to a field, by a bounded number of evaluations.
#pragma once

#include <nearfield/query/clearance.hpp>

namespace nearfield {

// A capsule (or ball) in the field's frame, known to within `error` metres: every point of it as given lies at most
// that far from where it really is.
template <class S> struct MovedCapsule {
  Capsule<S> capsule;
  S error{};
  uint16_t number = 0;  // the caller's own, handed back with the answer
};

// How much is spent: one evaluation of the field's value for each capsule, then up to `refinements` more where the
// bound is least, fewer when no more than `tolerance` (metres) can be gained; one evaluation with gradient at the end.
template <class S> struct SweepEffort {
  int refinements = 8;
  S tolerance{};
};
inline constexpr int kMostRefinements = 32;

// A part of a capsule's axis between two places at which the field was evaluated, or a whole axis with one evaluation
// in its middle (from == to). Working memory of clearance(); nothing in it outlives the call.
template <class S> struct Stretch {
  S from{}, to{};            // places along the axis, metres
  S free_from{}, free_to{};  // certified free radii around the two
  S bound{};                 // what is left for the whole capsule: its clearance is not below this on this stretch
  uint16_t capsule = 0;
};

// The nearest of several capsules: a lower bound that holds for all of them.
template <class S> struct NearestCapsule {
  Clearance<S> clearance;
  uint16_t number = 0;
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


// The search for the stretch with the least bound; see clearance() below.
template <class AnyField, class S> class CapsuleSweep {
 public:
  constexpr CapsuleSweep(const AnyField& field, const MovedCapsule<S>* capsules, Stretch<S>* stretches,
                         const Slots<S>& slots)
      : field_(field), certifier_(field.certificate()), capsules_(capsules), stretches_(stretches), slots_(slots) {}

  // One evaluation, in the middle of each capsule: a ball of free space that holds the whole axis.
  constexpr void start(uint16_t capsule) {
    const S length = capsules_[capsule].capsule.length;
    const S middle = ScalarTraits<S>::half(length);
    const S free_radius = evaluate(capsule, middle);
    add({middle, middle, free_radius, free_radius, rest(capsule, free_radius - subtract_in_range(length, middle)), capsule});
  }

  // Spends up to `refinements` evaluations where the bound is least.
  constexpr void refine(int refinements, S tolerance) {
    while (refinements > 0 && least_attained_ - stretches_[weakest_].bound > tolerance) {
      const Stretch<S> weak = stretches_[weakest_];
      const bool whole = weak.from == weak.to;
      if (whole && refinements < 2) break;
      refinements -= whole ? 2 : 1;
      const S length = capsules_[weak.capsule].capsule.length;
      const S low = whole ? S{} : weak.from, high = whole ? length : weak.to;
      const S middle = whole ? weak.from : add_in_range(low, ScalarTraits<S>::half(subtract_in_range(high, low)));
      const S free_low = whole ? evaluate(weak.capsule, low) : weak.free_from;
      const S free_high = whole ? evaluate(weak.capsule, high) : weak.free_to;
      const S free_middle = whole ? weak.free_from : evaluate(weak.capsule, middle);
      stretches_[weakest_] = between(weak.capsule, low, free_low, middle, free_middle);
      add(between(weak.capsule, middle, free_middle, high, free_high));
      for (int i = 0; i < count_; ++i) {
        if (stretches_[i].bound < stretches_[weakest_].bound) weakest_ = i;
      }
    }
  }

  // The least bound, with the direction at the nearest place evaluated.
  constexpr NearestCapsule<S> answer() const {
    const MovedCapsule<S>& nearest = capsules_[nearest_capsule_];
    const Sample<S> sample = field_.template evaluate<Sample<S>>(point(nearest_capsule_, nearest_place_), slots_);
    NearestCapsule<S> found;
    found.number = nearest.number;
    found.clearance.distance = stretches_[weakest_].bound;
    found.clearance.status =
        found.clearance.distance > S{}
            ? ClearanceStatus::clear
            : certifier_.status(sample.value - nearest.capsule.radius + nearest.error, found.clearance.distance);
    found.clearance.direction = sample.gradient;
    return found;
  }

 private:
  constexpr Vector3<S> point(uint16_t capsule, S place) const {
    const Capsule<S>& c = capsules_[capsule].capsule;
    return add_in_range(c.from, c.along(place));
  }
  // What a free radius around the axis leaves for the capsule.
  constexpr S rest(uint16_t capsule, S free_radius) const {
    return free_radius - capsules_[capsule].capsule.radius - capsules_[capsule].error;
  }
  constexpr S evaluate(uint16_t capsule, S place) {
    const S free_radius = certifier_.lower_bound(field_.template evaluate<Value<S>>(point(capsule, place), slots_).value);
    const S attained = rest(capsule, free_radius);
    if (count_ == 0 || attained < least_attained_) {
      least_attained_ = attained;
      nearest_capsule_ = capsule;
      nearest_place_ = place;
    }
    return free_radius;
  }
  constexpr Stretch<S> between(uint16_t capsule, S from, S free_from, S to, S free_to) const {
    const S bound = free_around_segment(free_from, free_to, subtract_in_range(to, from));
    return {from, to, free_from, free_to, rest(capsule, bound), capsule};
  }
  constexpr void add(const Stretch<S>& stretch) {
    stretches_[count_] = stretch;
    if (stretch.bound < stretches_[weakest_].bound) weakest_ = count_;
    ++count_;
  }

  const AnyField& field_;
  const Certifier<S> certifier_;
  const MovedCapsule<S>* capsules_;
  Stretch<S>* stretches_;
  const Slots<S>& slots_;
  int count_ = 0, weakest_ = 0;
  S least_attained_{}, nearest_place_{};
  uint16_t nearest_capsule_ = 0;
};

}  // namespace detail

// The least clearance over `count` capsules (at least one). `stretches`: working memory for count + refinements of
// them. `touching`: the nearest capsule's field value, less its radius, is for certain not positive.
// An invalid capsule (out of the domain, NaN) makes the answer invalid and is named by it.
// Cost: at most sweep_budget().
template <class AnyField>
constexpr uint32_t sweep_budget(const AnyField& field, uint32_t count, uint32_t refinements, const Target& target = kThisTarget) {
  const Budget of_field = field.budget(target);
  const Budget stretches = (count + refinements) * target.cost(QueryPart::stretch);
  const Budget values = count * (of_field + target.cost(QueryPart::swept_capsule)) +
                        refinements * (of_field + target.cost(QueryPart::refinement) + stretches);
  return detail::sum_of_costs(of_field.gradient, values.value);
}

template <class AnyField, class S = typename AnyField::Scalar>
constexpr NearestCapsule<S> clearance(const AnyField& field, const MovedCapsule<typename AnyField::Scalar>* capsules,
                                      uint16_t count, Stretch<typename AnyField::Scalar>* stretches,
                                      SweepEffort<typename AnyField::Scalar> effort,
                                      const Slots<typename AnyField::Scalar>& slots = {}) {
  NearestCapsule<S> invalid;
  if (count == 0 || (detail::slots_given(field, slots) && !detail::valid_slots(field, slots))) return invalid;
  for (uint16_t i = 0; i < count; ++i) {
    const Capsule<S>& c = capsules[i].capsule;
    invalid.number = capsules[i].number;
    if (!detail::may_be_asked(field, c.from, slots) || !detail::in_domain(c) || !(capsules[i].error >= S{})) {
      return invalid;
    }
  }
  detail::CapsuleSweep<AnyField, S> sweep(field, capsules, stretches, slots);
  for (uint16_t i = 0; i < count; ++i) sweep.start(i);
  sweep.refine(effort.refinements < kMostRefinements ? effort.refinements : kMostRefinements, effort.tolerance);
  return sweep.answer();
}

// The same for one capsule.
template <class AnyField, class S = typename AnyField::Scalar>
constexpr Clearance<S> clearance(const AnyField& field, const Capsule<typename AnyField::Scalar>& capsule,
                                 typename AnyField::Scalar error, SweepEffort<typename AnyField::Scalar> effort,
                                 const Slots<typename AnyField::Scalar>& slots = {}) {
  const MovedCapsule<S> moved = {capsule, error, 0};
  Stretch<S> stretches[kMostRefinements + 1] = {};
  return clearance(field, &moved, 1, stretches, effort, slots).clearance;
}

}  // namespace nearfield
