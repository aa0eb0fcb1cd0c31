/// Speed ramps and protective distances, judged by Li's H_3 and the formula of ISO/TS 15066 in long double.

#include <nearfield/query/zone.hpp>

#include "property/conversion.hpp"
#include "property/failures.hpp"
#include "reference/random.hpp"
#include "reference/steps.hpp"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <initializer_list>
#include <limits>
#include <vector>

namespace nearfield::property {
namespace {

using reference::Random;

template <class S>
Clearance<S> clear_by(S distance) {
  Clearance<S> c;
  c.status = ClearanceStatus::clear;
  c.distance = distance;
  return c;
}

template <class S>
S next_above(S a) {
  if constexpr (ScalarTraits<S>::is_fixed)
    return a + S::unit_in_last_place();
  else
    return std::nextafter(a, std::numeric_limits<float>::max());
}

template <class S>
class RampTrial {
 public:
  explicit RampTrial(std::uint64_t seed) : random_(seed) {}

  void run() {
    const Real reach = real(ScalarTraits<S>::domain());
    for (int i = 0; i < 300; ++i) {
      const S stop = rounded<S>(random_.uniform(0, 0.5L) * reach);
      S free = rounded<S>(real(stop) + reach * std::pow(Real{10}, random_.uniform(-6, 0)));
      if (!(stop < free)) free = next_above(stop);
      judge(stop, free);
    }
    monotone_.expect_none("more clearance never lowers the override by more than a unit");
    ends_.expect_none("0 below stop, 1 from free on");
    below_.expect_none("never above H_3");
    unclear_.expect_none("anything but clear stops");
    std::printf("%s: override at most %.2Le below H_3\n", ScalarName<S>::text().c_str(), greatest_shortfall_);
    const Real unit = real(ScalarTraits<S>::rounding_unit(ScalarTraits<S>::one()));
    EXPECT_LE(greatest_shortfall_, 16 * unit + 1e-4L) << "as slow as it need not be";
  }

 private:
  void judge(S stop, S free) {
    const SpeedRamp<S> ramp(stop, free);
    const Real width = real(free) - real(stop);
    std::vector<S> distances{stop, free, S{}, ScalarTraits<S>::greatest(), ScalarTraits<S>::least()};
    for (int i = 0; i < 1500; ++i)
      distances.push_back(rounded<S>(real(stop) + random_.uniform(-0.05L, 1.05L) * width));
    for (const Real start : {Real{0}, random_.uniform(), random_.uniform(0.97L, 1)}) {
      S at = rounded<S>(real(stop) + start * width);
      for (int i = 0; i < 300; ++i, at = next_above(at)) distances.push_back(at);
    }
    std::sort(distances.begin(), distances.end());
    S last{};
    for (const S distance : distances) {
      const S share = ramp.override_for(clear_by(distance));
      const Zone zone = ramp.zone(clear_by(distance));
      // The table's truncated products may step back by one unit.
      monotone_.check(share + ScalarTraits<S>::rounding_unit(S(1.0)) >= last, [&](std::ostream& out) {
        out << real(last) << " then " << real(share) << " at " << real(distance) << " between " << real(stop)
            << " and " << real(free);
      });
      last = share;
      const Real one = real(ScalarTraits<S>::one());
      const bool right_end = distance < stop    ? share == S{} && zone == Zone::stop
                             : distance >= free ? real(share) == one && zone == Zone::free
                                                : zone == Zone::slow && share >= S{} && real(share) <= one;
      ends_.check(right_end, [&](std::ostream& out) {
        out << real(share) << " in zone " << static_cast<int>(zone) << " at " << real(distance) << " between "
            << real(stop) << " and " << real(free);
      });
      const Real exact = reference::polynomial_step(3, 2 * (real(distance) - real(stop)) / width - 1);
      below_.check(real(share) <= exact, [&](std::ostream& out) {
        out << real(share) << " exact " << exact << " at " << real(distance) << " between " << real(stop)
            << " and " << real(free);
      });
      // Between neighbouring numbers a narrow ramp may rise a good deal.
      if (width > 1e6L * last_place<S>(real(ScalarTraits<S>::domain()))) {
        greatest_shortfall_ = std::max(greatest_shortfall_, exact - real(share));
      }
      for (const ClearanceStatus status :
           {ClearanceStatus::invalid, ClearanceStatus::touching, ClearanceStatus::undecided}) {
        Clearance<S> c = clear_by(distance);
        c.status = status;
        unclear_.check(ramp.zone(c) == Zone::stop && ramp.override_for(c) == S{},
                       [&](std::ostream& out) { out << "status " << static_cast<int>(status); });
      }
    }
  }

  Random random_;
  Failures monotone_, ends_, below_, unclear_;
  Real greatest_shortfall_ = 0;
};

TEST(Zone, RampIsMonotoneAndNeverAboveTheStepInFixed27) {
  RampTrial<Fixed<27>>(reference::announced_seed("RampIsMonotoneAndNeverAboveTheStepInFixed27", 601)).run();
}
TEST(Zone, RampIsMonotoneAndNeverAboveTheStepInFixed16) {
  RampTrial<Fixed<16>>(reference::announced_seed("RampIsMonotoneAndNeverAboveTheStepInFixed16", 602)).run();
}
TEST(Zone, RampIsMonotoneAndNeverAboveTheStepInFloat) {
  RampTrial<float>(reference::announced_seed("RampIsMonotoneAndNeverAboveTheStepInFloat", 603)).run();
}

template <class S>
void expect_invalid_ramps_stop() {
  const S one = ScalarTraits<S>::one();
  for (const SpeedRamp<S>& ramp : {SpeedRamp<S>(), SpeedRamp<S>(one, one), SpeedRamp<S>(one + one, one)}) {
    for (const S distance : {S{}, one, one + one, ScalarTraits<S>::greatest()}) {
      EXPECT_EQ(ramp.zone(clear_by(distance)), Zone::stop);
      EXPECT_EQ(ramp.override_for(clear_by(distance)), S{});
    }
  }
}

TEST(Zone, InvalidRampsAndNanStop) {
  expect_invalid_ramps_stop<Fixed<27>>();
  expect_invalid_ramps_stop<Fixed<16>>();
  expect_invalid_ramps_stop<float>();
  const float nan = std::numeric_limits<float>::quiet_NaN();
  EXPECT_EQ(SpeedRamp<float>(0.1f, 0.2f).override_for(clear_by(nan)), 0.0f);
  for (const float strange : {nan, -nan}) {
    EXPECT_EQ(SpeedRamp<float>(strange, 0.2f).override_for(clear_by(1.0f)), 0.0f);
    EXPECT_EQ(SpeedRamp<float>(0.1f, strange).override_for(clear_by(1.0f)), 0.0f);
  }
}

// A separation's quantities as they really are.
struct TrueSeparation {
  Real human_speed, robot_speed, reaction_time, stopping_time, stopping_distance, intrusion_distance,
      human_uncertainty, robot_uncertainty;

  Real protective_distance(Real fraction) const {
    return human_speed * (reaction_time + fraction * stopping_time) + fraction * robot_speed * reaction_time +
           fraction * fraction * stopping_distance + intrusion_distance + human_uncertainty +
           robot_uncertainty;
  }
  template <class S>
  Separation<S> as() const {
    return {rounded<S>(human_speed),       rounded<S>(robot_speed),       rounded<S>(reaction_time),
            rounded<S>(stopping_time),     rounded<S>(stopping_distance), rounded<S>(intrusion_distance),
            rounded<S>(human_uncertainty), rounded<S>(robot_uncertainty)};
  }
};

constexpr TrueSeparation usual{1.6L, 1, 0.08L, 0.2L, 0.1L, 0.05L, 0.03L, 0.02L};
constexpr Real slow_override = 0.2L, slow_margin = 0.3L;

template <class S>
void expect_protective_distance_is_close(Random& random) {
  // Fixed: eight units in the last place. float: eight units at the size of the result.
  Real greatest = 0;
  Failures close;
  for (int i = 0; i < 100000; ++i) {
    const TrueSeparation truth{random.uniform(0, 2),    random.uniform(0, 2),    random.uniform(0, 0.3L),
                               random.uniform(0, 0.5L), random.uniform(0, 0.5L), random.uniform(0, 0.2L),
                               random.uniform(0, 0.1L), random.uniform(0, 0.1L)};
    const S fraction = rounded<S>(random.uniform());
    const Real exact = truth.protective_distance(real(fraction));
    const Real off =
        std::fabs(real(truth.as<S>().protective_distance(fraction)) - exact) / last_place<S>(exact);
    greatest = std::max(greatest, off);
    close.check(off <= 8, [&](std::ostream& out) { out << off << " units in the last place"; });
  }
  close.expect_none("protective_distance");
  std::printf("%s: protective distance within %.2Lf units in the last place\n", ScalarName<S>::text().c_str(),
              greatest);
}

TEST(Zone, ProtectiveDistanceIsThatOfTheStandard) {
  Random random(reference::announced_seed("ProtectiveDistanceIsThatOfTheStandard", 604));
  expect_protective_distance_is_close<Fixed<27>>(random);
  expect_protective_distance_is_close<Fixed<16>>(random);
  expect_protective_distance_is_close<float>(random);
}

// The robot may always be as fast as it is: the protective distance at the override that a clearance allows
// is no more than the clearance. The ramp starts where the slowed robot is safe and ends a margin beyond
// where the fast one is.
template <class S>
void expect_allowed_speed_is_safe() {
  const Separation<S> separation = usual.as<S>();
  const S stop = separation.protective_distance(rounded<S>(slow_override));
  const S free = separation.protective_distance(ScalarTraits<S>::one()) + rounded<S>(slow_margin);
  const SpeedRamp<S> ramp(stop, free);
  Failures safe;
  Real least_reserve = 1;
  const int steps = 400000;
  for (int i = 0; i <= steps; ++i) {
    const S c = rounded<S>(real(stop) + (real(free) + 0.1L - real(stop)) * i / steps);
    const Real share = real(ramp.override_for(clear_by(c)));
    const Real needed = usual.protective_distance(share);
    least_reserve = std::min(least_reserve, real(c) - needed);
    safe.check(needed <= real(c), [&](std::ostream& out) {
      out << "clearance " << real(c) << " override " << share << " needs " << needed;
    });
  }
  safe.expect_none("protective_distance(override(c)) <= c");
  std::printf("%s: least reserve %.4Lf m between %.4Lf and %.4Lf m\n", ScalarName<S>::text().c_str(),
              least_reserve, real(stop), real(free));
}

TEST(Zone, AllowedSpeedIsSafe) {
  expect_allowed_speed_is_safe<Fixed<27>>();
  expect_allowed_speed_is_safe<Fixed<16>>();
  expect_allowed_speed_is_safe<float>();
}

}  // namespace
}  // namespace nearfield::property
