// Solid noise on an integer lattice (Perlin 1985; KW, "Random Deformations"), in integer arithmetic alone: the same bits for
// every scalar.
#pragma once

#include <nearfield/number/vector.hpp>

namespace nearfield {

// A place in cells of the lattice, Q32.
struct LatticePlace {
  int64_t x = 0, y = 0, z = 0;
};

// Value, and slopes per cell of the first octave (0 where they are not asked for).
struct LatticeNoise {
  Fixed<29> value;
  Vector3<Fixed<27>> slope;
};

// Octave o = 0, 1, ... is noise of 2^-o times the size at 2^o times the place: values within 2 - 2^(1 - octaves), one alone
// within 1. A slope of one octave is at most 15/4 long: with w the weights of the interpolation and N the value, w' its slope,
// the sum of w (1 - w) (dN/dw)^2 over x, y, z is at most 1 (Bessel's inequality for a vertex that is drawn with these
// weights), and w'^2 at most (15/4)^2 w (1 - w). An octave's size and frequency cancel: of n octaves n times that.
inline constexpr int kGreatestOctaveCount = 4;
// How far value and slopes may be off, for places as given.
inline constexpr int32_t kNoiseErrorQ29 = 64;
inline constexpr int32_t kNoiseSlopeErrorQ27 = 128;

namespace detail {

inline constexpr uint32_t kLatticeStrideX = 0xef02843bu, kLatticeStrideY = 0x78a59887u, kLatticeStrideZ = 0x5ecfd9bbu;
inline constexpr uint32_t kLatticeStrideOctave = 0x51f2c6adu;

// In [-1, 1), Q29. No two vertices that are less than 800 cells apart have the same key.
constexpr int32_t lattice_value(uint32_t key) {
  key = (key ^ (key >> 15)) * 0x8962904du;
  key = (key ^ (key >> 13)) * 0xb9ad7cdbu;
  return static_cast<int32_t>(key) >> 2;
}

// 6 t^5 - 15 t^4 + 10 t^3, Q31, in (0, 2^31), and its slope, Q30; t in Q32.
struct LatticeFade {
  int32_t weight = 0;
  int32_t slope = 0;
};
template <bool with_slope> constexpr LatticeFade lattice_fade(uint32_t t) {
  // About the middle, s = t - 1/2: 1/2 + s (15/8 - s^2 (5 - 6 s^2)), slope 30 (1/4 - s^2)^2.
  const int32_t s = static_cast<int32_t>(t ^ 0x80000000u);
  const uint32_t square = static_cast<uint32_t>(multiply_high(s, s));  // Q32
  const uint32_t bend = multiply_high(square << 1, (5u << 29) - 3 * (square >> 2));
  // Less 4, so that the weight cannot reach 1.
  const int32_t steepness = (15 << 27) - 4 - static_cast<int32_t>(bend);
  LatticeFade fade;
  fade.weight = (1 << 30) + shift_left(multiply_high(s, steepness), 1);
  if constexpr (with_slope) {
    const uint32_t room = ((1u << 30) - square) << 1;  // Q33
    fade.slope = static_cast<int32_t>(15 * (multiply_high(room, room) >> 3));
  }
  return fade;
}

constexpr int32_t between(int32_t a, int32_t b, int32_t weight) {
  return wrapping_add(a, shift_left(multiply_high(wrapping_subtract(b, a), weight), 1));
}

// Of one octave; slopes in Q27.
struct LatticeSample {
  int32_t value = 0, x = 0, y = 0, z = 0;
};
template <bool with_slope> constexpr LatticeSample one_octave(const LatticePlace& at, uint32_t seed) {
  const auto cell = [](int64_t place) { return static_cast<uint32_t>(static_cast<uint64_t>(place) >> 32); };
  const auto part = [](int64_t place) { return static_cast<uint32_t>(static_cast<uint64_t>(place)); };
  const uint32_t key = cell(at.x) * kLatticeStrideX + cell(at.y) * kLatticeStrideY + cell(at.z) * kLatticeStrideZ + seed;
  const LatticeFade fx = lattice_fade<with_slope>(part(at.x)), fy = lattice_fade<with_slope>(part(at.y)),
                    fz = lattice_fade<with_slope>(part(at.z));
  // An edge along x: its value at the place, and the difference of its ends.
  struct Edge {
    int32_t value, rise;
  };
  const auto edge = [&fx](uint32_t start) {
    const int32_t first = lattice_value(start), second = lattice_value(start + kLatticeStrideX);
    return Edge{between(first, second, fx.weight), second - first};
  };
  const Edge e00 = edge(key), e10 = edge(key + kLatticeStrideY);
  const int32_t near = between(e00.value, e10.value, fy.weight);
  const int32_t near_by_y = e10.value - e00.value, near_by_x = between(e00.rise, e10.rise, fy.weight);
  const Edge e01 = edge(key + kLatticeStrideZ), e11 = edge(key + kLatticeStrideZ + kLatticeStrideY);
  const int32_t far = between(e01.value, e11.value, fy.weight);
  LatticeSample sample;
  sample.value = between(near, far, fz.weight);
  if constexpr (with_slope) {
    const int32_t far_by_y = e11.value - e01.value, far_by_x = between(e01.rise, e11.rise, fy.weight);
    sample.x = multiply_high(between(near_by_x, far_by_x, fz.weight), fx.slope);
    sample.y = multiply_high(between(near_by_y, far_by_y, fz.weight), fy.slope);
    sample.z = multiply_high(far - near, fz.slope);
  }
  return sample;
}

}  // namespace detail

// Cost grows with the octaves, of which there are 1 to kGreatestOctaveCount; others count as that many. Apart from what calls
// it, so that what it needs does not weigh on programs without noise.
template <bool with_slope>
[[gnu::noinline]] constexpr LatticeNoise lattice_noise(const LatticePlace& place, uint32_t seed, uint32_t octaves) {
  LatticePlace at = place;
  detail::LatticeSample sum;
  const int count = octaves < kGreatestOctaveCount ? static_cast<int>(octaves) : kGreatestOctaveCount;
  for (int octave = 0; octave < count; ++octave) {
    const detail::LatticeSample one = detail::one_octave<with_slope>(at, seed);
    sum.value += one.value >> octave;
    sum.x += one.x;
    sum.y += one.y;
    sum.z += one.z;
    at = {wrapping_add(at.x, at.x), wrapping_add(at.y, at.y), wrapping_add(at.z, at.z)};
    seed += detail::kLatticeStrideOctave;
  }
  return {Fixed<29>::from_raw(sum.value),
          {Fixed<27>::from_raw(sum.x), Fixed<27>::from_raw(sum.y), Fixed<27>::from_raw(sum.z)}};
}

}  // namespace nearfield
