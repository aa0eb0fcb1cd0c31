/// Solids of revolution.

#include "reference/revolved_solids.hpp"
#include "property/conformance/conformance.hpp"

namespace nearfield::property {
namespace {

// 0 now and then, otherwise of any size.
Real radius_of(Random& random, Real size) {
  return random.chance(0.1L) ? 0 : random.uniform(0.001L, 1) * size;
}

struct TaperedCapsuleRow {
  static constexpr const char* name = "tapered_capsule";
  static constexpr bool exact_solid = true;
  using Operations = OnlyOperations<Operation::tapered_capsule>;
  using Parameters = reference::TaperedCapsule;
  static Parameters draw(Random& random, Real size) {
    const Vec3 a = random.vector(-size, size);
    Real length = std::pow(Real{10}, random.uniform(-3, 0)) * size;
    Real first = radius_of(random, size), second = radius_of(random, size);
    if (random.chance(0.5L)) second = std::max(Real{0}, first + random.uniform(-1.05L, 1.05L) * length);
    // Just about one ball inside the other; of short ones rounding a radius would turn the side visibly.
    if (random.chance(0.2L)) {
      length = size;
      second =
          first + length * (1 + (random.chance(0.5L) ? 1 : -1) * std::pow(Real{10}, random.uniform(-5, -3)));
    }
    if (random.chance(0.5L)) std::swap(first, second);
    return {a, a + length * random.unit_vector(), first, second};
  }
  static std::vector<Parameters> degenerate(Real size) {
    return {{{}, {}, size, 0},
            {{}, {}, 0, size},
            {{}, {}, 0, 0},
            {{size, 0, 0}, {size, size, 0}, 0, 0},
            {{}, {0, 0, size}, size, 0},
            {{}, {0, 0, size}, 0, size},
            {{}, {size, 0, 0}, 0, size / 2},
            {{}, {0, 0, 1e-4L}, size, size},
            {{}, {0, size, 0}, size, 1e-8L * size},
            {{}, {0, 0, size}, 1e-6L * size, size},
            {{}, {size, 0, 0}, (1 + 1e-8L) * size, 0}};
  }
  static std::vector<Vec3> places(const Parameters& p) {
    const Vec3 middle = 0.5L * (p.a + p.b), axis = reference::normalized_or_zero(p.b - p.a);
    return {p.a,
            p.b,
            middle,
            p.a - p.radius_a * axis,
            p.b + p.radius_b * axis,
            p.b + 0.01L * p.radius_b * axis,
            p.a + Vec3{p.radius_a, 0, 0},
            middle + 2e-3L * p.radius_a * axis};
  }
  template <class S>
  static auto node(const Parameters& p) {
    return TaperedCapsule<S>(rounded<S>(p.a), rounded<S>(p.b), rounded<S>(p.radius_a),
                             rounded<S>(p.radius_b));
  }
  static Real value(const Parameters& parameters, const Vec3& p) {
    return reference::signed_distance(parameters, p);
  }
};

struct ConeFrustumRow {
  static constexpr const char* name = "cone_frustum";
  static constexpr bool exact_solid = true;
  using Operations = OnlyOperations<Operation::cone_frustum>;
  using Parameters = reference::ConeFrustum;
  static Parameters draw(Random& random, Real size) {
    Real below = radius_of(random, size), above = radius_of(random, size);
    if (below == 0 && above == 0) below = size;
    return {random.vector(-size, size), below, above, std::pow(Real{10}, random.uniform(-3, 0)) * size};
  }
  static std::vector<Parameters> degenerate(Real size) {
    return {{{}, size, 0, size},
            {{size, -size, 0}, 0, size, 1e-3L},
            {{}, size, size, size},
            {{0, 0, size}, 1e-3L, 0, size},
            {{0, 0, size}, size, 1e-3L, 1e-3L}};
  }
  static std::vector<Vec3> places(const Parameters& p) {
    const Vec3 up{0, 0, p.half_height};
    return {p.center,
            p.center + up,
            p.center - up,
            p.center + up + Vec3{p.radius_above, 0, 0},
            p.center - up + Vec3{0, p.radius_below, 0},
            p.center + Vec3{-(p.radius_above + p.radius_below) / 2, 0, 0},
            p.center + 1.5L * up};
  }
  template <class S>
  static auto node(const Parameters& p) {
    return ConeFrustum<S>(rounded<S>(p.center), rounded<S>(p.radius_below), rounded<S>(p.radius_above),
                          rounded<S>(p.half_height));
  }
  static Real value(const Parameters& parameters, const Vec3& p) {
    return reference::signed_distance(parameters, p);
  }
};

struct DiscRow {
  static constexpr const char* name = "disc";
  static constexpr bool exact_solid = true;
  using Operations = OnlyOperations<Operation::disc>;
  using Parameters = reference::Disc;
  static Parameters draw(Random& random, Real size) {
    return {random.vector(-size, size), radius_of(random, size), radius_of(random, size)};
  }
  static std::vector<Parameters> degenerate(Real size) {
    return {{{}, size, 0}, {{}, 0, size}, {{0, size, 0}, 0, 0}, {{size, 0, -size}, size, 1e-3L}};
  }
  static std::vector<Vec3> places(const Parameters& p) {
    const Vec3 edge = p.center + Vec3{p.radius, 0, 0}, up{0, 0, p.thickness};
    return {p.center,
            edge,
            edge + up,
            p.center - up,
            edge + Vec3{p.thickness, 0, 0},
            p.center + Vec3{0, p.radius / 2, 0}};
  }
  template <class S>
  static auto node(const Parameters& p) {
    return Disc<S>{rounded<S>(p.center), rounded<S>(p.radius), rounded<S>(p.thickness)};
  }
  static Real value(const Parameters& parameters, const Vec3& p) {
    return reference::signed_distance(parameters, p);
  }
};

TEST(RevolvedSolidConformance, TaperedCapsule) { judge_row<TaperedCapsuleRow>(721); }
TEST(RevolvedSolidConformance, ConeFrustum) { judge_row<ConeFrustumRow>(722); }
TEST(RevolvedSolidConformance, Disc) { judge_row<DiscRow>(723); }

}  // namespace
}  // namespace nearfield::property
