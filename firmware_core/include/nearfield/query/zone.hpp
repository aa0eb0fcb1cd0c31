// Stop, slow or go: speed and separation monitoring after ISO/TS 15066.
#pragma once

#include <nearfield/curve/step.hpp>
#include <nearfield/table/bake.hpp>
#include <nearfield/query/clearance.hpp>

namespace nearfield {

enum class Zone : uint8_t { stop = 0, slow = 1, free = 2 };

// Quantities of the protective separation distance (ISO/TS 15066, 5.5.4), metres, seconds, metres per second.
template <class S> struct Separation {
  S human_speed{};
  S robot_speed{};        // of any part of the robot at full speed
  S reaction_time{};
  S stopping_time{};      // from full speed
  S stopping_distance{};  // from full speed
  S intrusion_distance{}; // how far a person can reach in before being seen
  S human_uncertainty{};
  S robot_uncertainty{};

  // S_p at a fraction of full speed in [0, 1]: human_speed (reaction_time + fraction stopping_time)
  // + fraction robot_speed reaction_time + fraction^2 stopping_distance + intrusion_distance + uncertainties.
  // Rounded to within 8 units in the last place; callers add what they need.
  constexpr S protective_distance(S fraction) const {
    const auto times = [](S a, S b) { return narrow<S>(product(a, b)); };
    return times(human_speed, reaction_time + times(fraction, stopping_time)) +
           times(times(fraction, robot_speed), reaction_time) + times(times(fraction, fraction), stopping_distance) +
           intrusion_distance + human_uncertainty + robot_uncertainty;
  }
};

// A ramp of the speed override over a clearance: 0 up to `stop`, 1 from `free` on, between them a smooth unit step.
template <class S> struct SpeedRamp {
  S stop{};
  ArgumentScale<S> scale;  // over free - stop

  constexpr SpeedRamp() = default;
  // Precondition: stop < free, metres; otherwise the ramp is invalid and always stops.
  constexpr SpeedRamp(S stop_below, S free_from)
      : stop(stop_below), scale(ArgumentScale<S>::of(free_from - stop_below)) {}

  // Zone and override of a clearance; anything but `clear` stops.
  constexpr Zone zone(const Clearance<S>& c) const {
    if (c.status != ClearanceStatus::clear || !(c.distance >= stop) || !(scale.limit > S{})) return Zone::stop;
    return scale.contains(above_stop(c.distance)) ? Zone::slow : Zone::free;
  }
  // In [0, 1], never above the exact step H_3 of the clearance: the table's error is taken off. Rises with the clearance, but
  // for single units in the last place.
  constexpr S override_for(const Clearance<S>& c) const;

 private:
  template <int F, class R> constexpr uint32_t above_stop(Fixed<F, R> distance) const {
    return static_cast<uint32_t>(distance.raw()) - static_cast<uint32_t>(stop.raw());
  }
  constexpr float above_stop(float distance) const { return distance - stop; }
};

namespace detail {

template <class S>
inline constexpr Table<S, 32> kSpeedStep = bake<S, 32>(step::over_unit_interval(step::polynomial<3>));

}  // namespace detail

template <class S> constexpr S SpeedRamp<S>::override_for(const Clearance<S>& c) const {
  const Zone in = zone(c);
  if (in != Zone::slow) return in == Zone::free ? ScalarTraits<S>::one() : S{};
  const auto& table = detail::kSpeedStep<S>;
  const S step = ScalarTraits<S>::from_unit(sample_table<false>(table.view(), scale.argument(above_stop(c.distance))).value);
  const S error = ScalarTraits<S>::multiply_up(ScalarTraits<S>::one(), Rate::from_raw((table.facts.error >> 6) + 1));
  return clamp(step - error - ScalarTraits<S>::rounding_unit(ScalarTraits<S>::one()), S{}, ScalarTraits<S>::one());
}

}  // namespace nearfield
