/// Ray functions, sweeps and the torus as a quartic.

#include <nearfield/field/metrics.hpp>

#include "property/conformance/skeletons.hpp"
#include "reference/metrics.hpp"
#include "reference/shapes.hpp"

namespace nearfield::property {
namespace {

struct Slab {
  Vec3 point, normal;
  Real radius;
};

struct RaySlabRow {
  static constexpr const char* name = "ray_slab";
  static constexpr bool exact_solid = false;
  using Operations = OnlyOperations<Operation::ray_slab>;
  using Parameters = Slab;
  static Parameters draw(Random& random, Real size) {
    return {random.vector(-size, size), random.unit_vector(), ray_radius(random, size)};
  }
  static std::vector<Parameters> degenerate(Real size) {
    return {{{}, {0, 0, 1}, size},
            {{size, 0, 0}, {-1, 0, 0}, least_radius},
            {{0, 0, size}, {0.6L, 0, 0.8L}, 4 * size}};
  }
  static std::vector<Vec3> places(const Parameters& p) { return {p.point, p.point + p.radius * p.normal}; }
  template <class S>
  static auto node(const Parameters& p) {
    return RaySlab<S>{rounded<S>(p.point), rounded<Unit<S>>(p.normal), RayRadius<S>(rounded<S>(p.radius))};
  }
  static Real value(const Parameters& slab, const Vec3& p) {
    return cut_off(std::fabs(dot(p - slab.point, slab.normal)) / slab.radius);
  }
};

struct SkeletalBox {
  reference::Box box;
  Real radius;
};

struct RayOfDistanceRow {
  static constexpr const char* name = "ray_of_distance";
  static constexpr bool exact_solid = false;
  static constexpr Real direction_tolerance = 2e-8L;  // those of the operand, in its last place
  using Operations = OnlyOperations<Operation::box, Operation::ray_of_distance>;
  using Parameters = SkeletalBox;
  static Parameters draw(Random& random, Real size) {
    return {{random.vector(-size, size), random.vector(0.001L * size, size)}, ray_radius(random, size)};
  }
  static std::vector<Parameters> degenerate(Real size) {
    return {{{{}, {size, size, size}}, size},
            {{{}, {1e-3L, size, 1e-3L}}, least_radius},
            {{{}, {size, 1e-3L, 1}}, 4 * size}};
  }
  static std::vector<Vec3> places(const Parameters& p) {
    const Vec3 half = p.box.half_extents;
    return {p.box.center, p.box.center + half, p.box.center + Vec3{half.x, 0, 0}};
  }
  template <class S>
  static auto node(const Parameters& p) {
    return combine(RayOfDistance<S>{RayRadius<S>(rounded<S>(p.radius))},
                   Box<S>{rounded<S>(p.box.center), rounded<S>(p.box.half_extents)});
  }
  static Real value(const Parameters& skeletal, const Vec3& p) {
    return cut_off(std::max<Real>(0, reference::signed_distance(skeletal.box, p)) / skeletal.radius);
  }
};

Real exponent(Random& random) {
  constexpr Real usual[] = {1, 1.1L, 1.5L, 2, 3, 8, 20, 64};
  return random.chance(0.7L) ? usual[random.integer(0, 7)] : random.uniform(1, 64);
}

struct Sweeps {
  static constexpr bool exact_solid = false;
  static constexpr Real direction_tolerance = 3e-6L;
  using Operations = OnlyOperations<Operation::ray_sweep>;
  using Parameters = reference::Sweep;
  static std::vector<Vec3> places(const Parameters& p) {
    const Vec3 end = p.from + Vec3{0, 0, p.length};
    return {p.from, p.from + p.radii, p.length > 0 ? 0.5L * (p.from + end) - Vec3{0, p.radii.y, 0} : end};
  }
  template <class S>
  static auto node(const Parameters& p) {
    return RaySweep<S>(rounded<S>(p.from), rounded<S>(p.radii), rounded<Rate>(p.section),
                       rounded<Rate>(p.ends), rounded<S>(p.length), rounded<S>(p.twist),
                       rounded<S>(p.end_scale));
  }
  static Real value(const Parameters& sweep, const Vec3& p) { return cut_off(reference::ray_of(sweep, p)); }
};

struct SuperquadricRow : Sweeps {
  static constexpr const char* name = "superquadric";
  static Parameters draw(Random& random, Real size) {
    Parameters p;
    p.from = random.vector(-size, size);
    p.radii = {ray_radius(random, size), ray_radius(random, size), ray_radius(random, size)};
    p.section = exponent(random);
    p.ends = exponent(random);
    return p;
  }
  static std::vector<Parameters> degenerate(Real size) {
    const Vec3 even{size, size, size}, thin{least_radius, 4 * size, least_radius};
    return {{{}, even, 2, 2},
            {{}, even, 1, 1},
            {{size, -size, 0}, even, 64, 64},
            {{}, thin, 1, 64},
            {{}, thin, 64, 1}};
  }
};

template <class S>
struct SweepRow : Sweeps {
  static constexpr const char* name = "ray_sweep";
  // Differences of the reference are taken as far apart as the certified error says: of floats too far to
  // settle everywhere.
  static constexpr Real direction_tolerance = ScalarTraits<S>::is_fixed ? 3e-6L : 2e-2L;
  static Parameters draw(Random& random, Real size) {
    Parameters p = SuperquadricRow::draw(random, size);
    const Real end = random.chance(0.3L) ? 1 : std::exp(random.uniform(-1, 1));
    const Real thick = std::max<Real>(end, 1), thin = std::min<Real>(end, 1);
    p.end_scale = end;
    // Differences of the reference settle only where sections are not thin and bend no faster than this.
    p.section = std::min<Real>(p.section, 20);
    p.ends = std::min<Real>(p.ends < 2 ? 2 : p.ends, 20);
    p.radii.y = std::clamp(p.radii.y, p.radii.x / 8, 8 * p.radii.x);
    p.radii.x = std::max(0.5L * p.radii.x, std::ceil(least_radius / thin * 1024 + 1) / 1024);
    p.radii.y = std::max(0.5L * p.radii.y, std::ceil(least_radius / thin * 1024 + 1) / 1024);
    p.length = random.uniform(0.01L, 2) * size;
    const Real fastest = 0.3L * p.length / (thick * std::max(p.radii.x, p.radii.y));
    p.twist = random.chance(0.3L) ? 0 : random.uniform(-1, 1) * std::min<Real>(fastest, 15);
    return p;
  }
  static std::vector<Parameters> degenerate(Real size) {
    const Vec3 even{size, size, size}, slim{0.25L * size, 0.125L * size, size};
    return {{{}, even, 2, 2, 1e-3L * size, 0, 1},
            {{}, even, 2, 2, size, 0, 4},
            {{}, slim, 20, 20, 4 * size, 4, 1},
            {{}, slim, 1, 2, 2 * size, -1, 1.5L},
            {{0, size, 0}, slim, 64, 1, 2 * size, 3, 0.25L}};
  }
};

/// So large that nothing saturates: smaller ones are for declared boxes.
template <class S>
struct AlgebraicTorusRow {
  static constexpr const char* name = "algebraic_torus";
  static constexpr bool exact_solid = false;
  using Operations = OnlyOperations<Operation::algebraic_torus>;
  using Parameters = reference::QuarticTorus;
  static Real domain() { return real(ScalarTraits<S>::domain()); }
  static Parameters draw(Random& random, Real) {
    const Real d = domain(), ring = random.uniform(0.9L, 1) * d;
    return {random.vector(-0.04L * d, 0.04L * d), ring, random.uniform(0.02L, 1) * ring,
            random.uniform(1.9L, 2) * d};
  }
  static std::vector<Parameters> degenerate(Real) {
    const Real d = domain();
    return {{{}, d, d, 2 * d}, {{}, d, least_radius, 2 * d}, {{}, 0.9L * d, 0.45L * d, 2 * d}};
  }
  static std::vector<Vec3> places(const Parameters& p) {
    return {p.center, p.center + Vec3{p.ring, 0, 0}, p.center + Vec3{0, p.ring - p.tube, 0},
            p.center + Vec3{p.ring, 0, p.tube}};
  }
  template <class T>
  static auto node(const Parameters& p) {
    return AlgebraicTorus<T>(rounded<T>(p.center), rounded<T>(p.ring), rounded<T>(p.tube),
                             rounded<T>(p.size));
  }
  static Real value(const Parameters& torus, const Vec3& p) { return reference::quartic_of(torus, p); }
};

TEST(Rays, Slab) { judge_row<RaySlabRow>(0x51AB1ULL); }
TEST(Rays, OfDistance) { judge_row<RayOfDistanceRow>(0xD157ULL); }
TEST(Rays, Superquadric) { judge_row<SuperquadricRow>(0x50BE12ULL); }
TEST(Rays, Sweep) {
  const std::uint64_t seed = reference::announced_seed("ray_sweep", 0x53EE9ULL);
  conformance::Judge<SweepRow<Fixed<27>>, Fixed<27>>(seed).run();
  conformance::Judge<SweepRow<Fixed<16>>, Fixed<16>>(seed + 1).run();
  conformance::Judge<SweepRow<float>, float>(seed + 2).run();
}
TEST(Rays, AlgebraicTorus) {
  const std::uint64_t seed = reference::announced_seed("algebraic_torus", 0x702005ULL);
  conformance::Judge<AlgebraicTorusRow<Fixed<27>>, Fixed<27>>(seed).run();
  conformance::Judge<AlgebraicTorusRow<Fixed<16>>, Fixed<16>>(seed + 1).run();
  conformance::Judge<AlgebraicTorusRow<float>, float>(seed + 2).run();
}

}  // namespace
}  // namespace nearfield::property
