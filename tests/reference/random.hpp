#pragma once
/// Deterministic random numbers for tests: the same seed gives the same stream on every machine (only integer
/// arithmetic, IEEE basic operations and square roots are used).

#include "vector.hpp"

#include <cmath>
#include <cstdint>
#include <cstdio>
#include <cstdlib>

namespace nearfield::reference {

/// The SplitMix64 generator.
class Random {
 public:
  explicit Random(std::uint64_t seed) : state_(seed) {}

  std::uint64_t next() {
    state_ += 0x9E3779B97F4A7C15u;
    std::uint64_t mixed = state_;
    mixed = (mixed ^ (mixed >> 30)) * 0xBF58476D1CE4E5B9u;
    mixed = (mixed ^ (mixed >> 27)) * 0x94D049BB133111EBu;
    return mixed ^ (mixed >> 31);
  }

  /// In [0, 1), a multiple of 2⁻⁵³.
  Real uniform() { return std::ldexp(static_cast<Real>(next() >> 11), -53); }

  /// In [low, high).
  Real uniform(Real low, Real high) { return low + (high - low) * uniform(); }

  /// In low … high, both included, low ≤ high; every value equally likely.
  std::int64_t integer(std::int64_t low, std::int64_t high) {
    const std::uint64_t last = static_cast<std::uint64_t>(high) - static_cast<std::uint64_t>(low);
    if (last == UINT64_MAX) return static_cast<std::int64_t>(next());
    const std::uint64_t count = last + 1;
    const std::uint64_t unfair = (UINT64_MAX % count + 1) % count;
    std::uint64_t drawn = next();
    while (drawn > UINT64_MAX - unfair) drawn = next();
    return static_cast<std::int64_t>(static_cast<std::uint64_t>(low) + drawn % count);
  }

  bool chance(Real probability) { return uniform() < probability; }

  /// Every coordinate in [low, high).
  Vec3 vector(Real low, Real high) {
    const Real x = uniform(low, high);
    const Real y = uniform(low, high);
    const Real z = uniform(low, high);
    return {x, y, z};
  }

  /// Evenly distributed on the unit sphere.
  Vec3 unit_vector() {
    for (;;) {
      const Vec3 drawn = vector(-1, 1);
      const Real squared_length = squared_norm(drawn);
      if (squared_length > 0.01L && squared_length <= 1) return drawn / std::sqrt(squared_length);
    }
  }

  /// Evenly distributed over all rotations.
  Mat3 rotation() {
    for (;;) {
      const Vec3 imaginary = vector(-1, 1);
      const Real real = uniform(-1, 1);
      const Real squared_length = squared_norm(imaginary) + real * real;
      if (squared_length > 0.01L && squared_length <= 1) {
        return rotation_from_quaternion(real, imaginary.x, imaginary.y, imaginary.z);
      }
    }
  }

  /// Any rotation, and a translation with every coordinate in [-reach, reach).
  Pose pose(Real reach) {
    const Mat3 turned = rotation();
    return {turned, vector(-reach, reach)};
  }

 private:
  std::uint64_t state_;
};

/// The seed of a random test: `usual`, or the value of the environment variable NEARFIELD_TEST_SEED (decimal,
/// 0x hexadecimal). Prints it with the test's name, so that a failure can be repeated.
inline std::uint64_t announced_seed(const char* test_name, std::uint64_t usual) {
  const char* wanted = std::getenv("NEARFIELD_TEST_SEED");
  const std::uint64_t seed = wanted != nullptr ? std::strtoull(wanted, nullptr, 0) : usual;
  std::printf("%s: seed %llu\n", test_name, static_cast<unsigned long long>(seed));
  return seed;
}

}  // namespace nearfield::reference
