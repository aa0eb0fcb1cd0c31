#pragma once
/// Solid noise by its definition, and radii that depend on the place, as factors of ray functions (KW).

#include "vector.hpp"

#include <algorithm>
#include <cmath>
#include <cstdint>

namespace nearfield::reference {

/// The value at a vertex of the lattice, in [-1, 1): 30 bits of a hash of 32-bit numbers.
inline Real vertex_value(std::int64_t i, std::int64_t j, std::int64_t k, std::uint32_t seed) {
  constexpr std::uint64_t low_word = 0xffffffffu;
  const auto times = [](std::uint64_t a, std::uint64_t b) { return (a * b) & low_word; };
  const auto word = [](std::int64_t a) { return static_cast<std::uint64_t>(a) & low_word; };
  std::uint64_t x =
      (times(word(i), 0xef02843bu) + times(word(j), 0x78a59887u) + times(word(k), 0x5ecfd9bbu) + seed) &
      low_word;
  x = times(x ^ (x / 32768), 0x8962904du);
  x = times(x ^ (x / 8192), 0xb9ad7cdbu);
  const std::int64_t signed_word =
      static_cast<std::int64_t>(x) - (x >= 0x80000000u ? std::int64_t{1} << 32 : 0);
  return std::floor(static_cast<Real>(signed_word) / 4) / 536870912;
}

/// 6t⁵ − 15t⁴ + 10t³ between the vertices.
inline Real octave_of_noise(const Vec3& cells, std::uint32_t seed) {
  const auto fade = [](Real t) { return t * t * t * (t * (t * 6 - 15) + 10); };
  const Vec3 corner{std::floor(cells.x), std::floor(cells.y), std::floor(cells.z)}, part = cells - corner;
  const Real weights[3][2] = {
      {1 - fade(part.x), fade(part.x)}, {1 - fade(part.y), fade(part.y)}, {1 - fade(part.z), fade(part.z)}};
  Real sum = 0;
  for (int vertex = 0; vertex < 8; ++vertex) {
    const int i = vertex & 1, j = vertex >> 1 & 1, k = vertex >> 2;
    sum += weights[0][i] * weights[1][j] * weights[2][k] *
           vertex_value(static_cast<std::int64_t>(corner.x) + i, static_cast<std::int64_t>(corner.y) + j,
                        static_cast<std::int64_t>(corner.z) + k, seed);
  }
  return sum;
}

struct Noise {
  Real amplitude = 0, frequency = 1;
  int octaves = 1;
  std::uint32_t seed = 0;
};
/// c N(p): octaves of half the size and twice the frequency each, over the sum of their sizes.
inline Real noise_of(const Noise& noise, const Vec3& p) {
  Real sum = 0, sizes = 0, size = 1;
  for (int octave = 0; octave < noise.octaves; ++octave, size /= 2) {
    sum += size * octave_of_noise(noise.frequency / size * p,
                                  noise.seed + static_cast<std::uint32_t>(octave) * 0x51f2c6adu);
    sizes += size;
  }
  return noise.amplitude * (sum / sizes);
}

/// What a factor goes over to about the place where its angle is not defined.
struct Core {
  Real radius = 1, level = 1;
};
inline Real with_core(Real factor, Real away, const Core& core) {
  if (away >= core.radius) return factor;
  const Real q = away * away / (core.radius * core.radius);
  return core.level + q * q * (3 - 2 * q) * (factor - core.level);
}

/// An angle in [0, 2π).
inline Real angle_of(Real a, Real b) {
  const Real angle = std::atan2(b, a);
  return angle < 0 ? angle + 2 * pi : angle;
}

}  // namespace nearfield::reference
