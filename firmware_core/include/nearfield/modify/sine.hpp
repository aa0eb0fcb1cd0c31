// Sine and cosine of joint angles, from one quarter of a sine in a table.
#pragma once

#include <nearfield/table/bake.hpp>

namespace nearfield {

namespace detail {

struct QuarterSine {
  constexpr Differentiable operator()(const Differentiable& u) const { return sin((0.5 * kPi) * u); }
};

template <class S> inline constexpr Table<S, 64> kQuarterSine = bake<S, 64>(QuarterSine{});

// Angle (radians) as a fraction of a turn, Q32, wrapping.
template <int F, class R> constexpr uint32_t phase_of(Fixed<F, R> angle) {
  constexpr int64_t per_turn = 2734261102;  // 2^34 / (2 pi)
  return static_cast<uint32_t>((angle.raw() * per_turn + (int64_t{1} << (F + 1))) >> (F + 2));
}
constexpr uint32_t phase_of(float angle) {
  if (!(angle >= -16.0f && angle <= 16.0f)) return 0;
  const float turns = angle * 0.15915494309f;
  const float rest = turns - static_cast<float>(static_cast<int32_t>(turns));  // within (-1, 1)
  return static_cast<uint32_t>(static_cast<int32_t>(rest * 2147483648.0f)) << 1;
}

// Below 1: the last place before it stands for a whole quarter.
constexpr uint32_t quarter_argument(uint32_t q30, Fixed<30>) { return q30 < 0x40000000u ? q30 << 1 : 0x7fffffffu; }
constexpr float quarter_argument(uint32_t q30, float) {
  const float argument = static_cast<float>(q30) * (1.0f / 1073741824.0f);
  return argument < 1.0f ? argument : 0.99999994f;
}

}  // namespace detail

template <class S> struct SineCosine {
  Unit<S> sine{};
  Unit<S> cosine{};
};

// Greatest error of each of the two against the exact value at the angle as given, in units of 2^-30 (float: 2^-21):
// the table's 5, the reduction's 3.
inline constexpr uint32_t kSineErrorUnits = 8;

// Of a fraction of a turn in Q32.
template <class S> constexpr SineCosine<S> sine_cosine_of_phase(uint32_t phase) {
  const uint32_t rest = phase & 0x3fffffffu;
  const TableView<S> table = detail::kQuarterSine<S>.view();
  const Unit<S> rising = sample_table<false>(table, detail::quarter_argument(rest, Unit<S>{})).value;
  const Unit<S> falling = sample_table<false>(table, detail::quarter_argument(0x40000000u - rest, Unit<S>{})).value;
  switch (phase >> 30) {
    case 0: return {rising, falling};
    case 1: return {falling, -rising};
    case 2: return {-rising, -falling};
    default: return {-falling, rising};
  }
}

// For |angle| <= 16 rad; beyond, Fixed with wider range lose accuracy, and a float (NaN as well) counts as 0. Cost on Cortex-M4: about 50 instructions.
template <class S> constexpr SineCosine<S> sine_cosine(S angle) { return sine_cosine_of_phase<S>(detail::phase_of(angle)); }

}  // namespace nearfield
