/// Solid noise.

#include <nearfield/curve/potential.hpp>
#include <nearfield/curve/tabulated_form.hpp>
#include <nearfield/field/deformed.hpp>

#include "property/conformance/rows_of_scalars.hpp"
#include "reference/deformations.hpp"
#include "reference/potentials.hpp"

namespace nearfield::property {
namespace {

reference::Noise draw_noise(Random& random, Real size, Real amplitude) {
  const Real frequency = std::min<Real>(512, random.uniform(0.1L, 10) / size);
  return {random.uniform(-1, 1) * amplitude,
          std::max<Real>(1.0L / 1024, std::round(frequency * 65536) / 65536),
          static_cast<int>(random.chance(0.5L) ? 1 : random.integer(2, 4)),
          static_cast<std::uint32_t>(random.next())};
}
template <class S, Kind kind>
SolidNoise<S, kind> solid_noise(const reference::Noise& noise) {
  return {rounded<S>(noise.amplitude), Fixed<16>(static_cast<double>(noise.frequency)),
          static_cast<std::uint32_t>(noise.octaves), noise.seed};
}

struct NoisyPoint {
  Vec3 center;
  Real radius = 1;
  reference::Noise noise;
};

/// As an algebraic field: its gradients are no unit vectors.
template <class Scalar>
struct NoiseDistanceRow {
  static constexpr const char* name = "noise_distance";
  static constexpr bool exact_solid = false;
  static constexpr Real direction_tolerance = gradient_tolerance<Scalar>(4, 1e-6L);
  using Operations =
      OnlyOperations<Operation::sphere, Operation::noise_distance, Operation::algebraic_of_distance>;
  using Parameters = NoisyPoint;
  static Parameters draw(Random& random, Real size) {
    return {random.vector(-0.5L * size, 0.5L * size), random.uniform(0.01L, 1) * size,
            draw_noise(random, size, 0.1L * size)};
  }
  static std::vector<Parameters> degenerate(Real size) {
    return {{{}, size, {0, 1, 1, 0}},
            {{}, 0, {0.25L * size, std::max<Real>(1 / size, 1.0L / 1024), 4, 7}},
            {{}, size, {-size, 1.0L / 1024, 2, 0xffffffffu}}};
  }
  static std::vector<Vec3> places(const Parameters& p) {
    const Real cell = 1 / p.noise.frequency;
    return {p.center,
            {},
            {cell, 0, 0},
            {-cell, cell, 0.5L * cell},
            {0.5L * cell, -0.25L * cell, 0},
            p.center + Vec3{p.radius, 0, 0}};
  }
  template <class S>
  static auto node(const Parameters& p) {
    const Sphere<S> ball{rounded<S>(p.center), rounded<S>(p.radius)};
    return combine(AlgebraicOfDistance<S>{ScalarTraits<S>::one()},
                   combine(NoiseDistance<S>{solid_noise<S, Kind::distance>(p.noise)}, ball));
  }
  static Real value(const Parameters& noisy, const Vec3& p) {
    return reference::distance(p, noisy.center) - noisy.radius - reference::noise_of(noisy.noise, p);
  }
};

template <class S>
inline const Table<S, 2> potential_table = bake<S, 2>(over_square(potential::wyvill));

template <class Scalar>
struct NoiseIntensityRow {
  static constexpr const char* name = "noise_intensity";
  static constexpr bool exact_solid = false;
  static constexpr Real direction_tolerance = gradient_tolerance<Scalar>(4, 1e-6L);
  using Operations = OnlyOperations<Operation::soft_point, Operation::noise_intensity>;
  using Parameters = NoisyPoint;
  static Parameters draw(Random& random, Real size) {
    return {random.vector(-size, size), even(random.uniform(0.25L, 1.5L) * size),
            draw_noise(random, size, random.chance(0.3L) ? 3 : 1)};
  }
  static std::vector<Parameters> degenerate(Real size) {
    return {{{}, size, {0, 1, 1, 0}},
            {{size, 0, 0}, size, {1, std::max<Real>(1 / size, 1.0L / 1024), 4, 7}},
            {{}, size, {-3, 1.0L / 1024, 2, 0xffffffffu}}};
  }
  static std::vector<Vec3> places(const Parameters& p) {
    const Real cell = 1 / p.noise.frequency;
    return {p.center,
            p.center + Vec3{p.radius, 0, 0},
            p.center + Vec3{0.5L * p.radius, 0, 0},
            {},
            {cell, 0, -cell}};
  }
  template <class S>
  static void tables(golden::NodeWriter<S, 4096, Operations>& writer) {
    writer.table(potential_table<S>);
  }
  template <class S>
  static auto node(const Parameters& p) {
    const SoftPoint<S> glow{rounded<S>(p.center), Influence<S>(rounded<S>(p.radius), ScalarTraits<S>::one())};
    return combine(NoiseIntensity<S>{solid_noise<S, Kind::intensity>(p.noise)},
                   with_potential(glow, potential_table<S>));
  }
  static Real value(const Parameters& noisy, const Vec3& p) {
    const Real intensity = reference::wyvill_potential(reference::distance(p, noisy.center) / noisy.radius);
    return intensity * (1 + reference::noise_of(noisy.noise, p));
  }
};

TEST(NoiseConformance, Distance) { judge_rows<NoiseDistanceRow>(0x401D15ULL); }
TEST(NoiseConformance, Intensity) { judge_rows<NoiseIntensityRow>(0x40117ULL); }

}  // namespace
}  // namespace nearfield::property
