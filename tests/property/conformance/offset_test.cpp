/// Solids grown and shrunk.

#include <nearfield/field/solids.hpp>

#include "property/conformance/conformance.hpp"
#include "reference/revolved_solids.hpp"

namespace nearfield::property {
namespace {

// 0 now and then, otherwise of any size.
Real radius_of(Random& random, Real size) {
  return random.chance(0.1L) ? 0 : random.uniform(0.001L, 1) * size;
}

struct TorusRow {
  static constexpr const char* name = "torus";
  static constexpr bool exact_solid = true;
  using Operations = OnlyOperations<Operation::torus>;
  using Parameters = reference::Torus;
  static Parameters draw(Random& random, Real size) {
    const Real ring = random.uniform(0.001L, 1) * size;
    return {random.vector(-size, size), ring, radius_of(random, ring)};
  }
  static std::vector<Parameters> degenerate(Real size) {
    return {{{}, size, 0}, {{}, size, size}, {{size, 0, -size}, 1e-3L, 0}};
  }
  static std::vector<Vec3> places(const Parameters& p) {
    return {p.center, p.center + Vec3{p.ring_radius, 0, 0},
            p.center + Vec3{0, p.ring_radius - p.tube_radius, 0},
            p.center + Vec3{p.ring_radius, 0, -p.tube_radius}, p.center + Vec3{0, 0, p.ring_radius}};
  }
  template <class S>
  static auto node(const Parameters& p) {
    return Torus<S>{rounded<S>(p.center), rounded<S>(p.ring_radius), rounded<S>(p.tube_radius)};
  }
  static Real value(const Parameters& parameters, const Vec3& p) {
    return reference::signed_distance(parameters, p);
  }
};

struct RoundedBoxRow {
  static constexpr const char* name = "rounded_box";
  static constexpr bool exact_solid = true;
  using Operations = OnlyOperations<Operation::box, Operation::offset>;
  struct Parameters {
    reference::Box outer;
    Real radius{};
  };
  static Parameters draw(Random& random, Real size) {
    const Vec3 half = random.vector(0.01L * size, size);
    const Real least = std::min({half.x, half.y, half.z});
    return {{random.vector(-size, size), half}, random.chance(0.1L) ? 0 : random.uniform(0, 0.99L) * least};
  }
  static std::vector<Parameters> degenerate(Real size) {
    return {{{{}, {size, size, size}}, 0}, {{{size, 0, 0}, {size, size / 2, 2e-3L}}, 1e-3L}};
  }
  static std::vector<Vec3> places(const Parameters& p) {
    const Vec3 core = p.outer.half_extents - Vec3{p.radius, p.radius, p.radius};
    return {p.outer.center, p.outer.center + core, p.outer.center - Vec3{core.x, 0, core.z},
            p.outer.center + Vec3{0, p.outer.half_extents.y, 0}};
  }
  template <class S>
  static auto node(const Parameters& p) {
    return rounded_box(rounded<S>(p.outer.center), rounded<S>(p.outer.half_extents), rounded<S>(p.radius));
  }
  static Real value(const Parameters& parameters, const Vec3& p) {
    const Vec3& half = parameters.outer.half_extents;
    const Real r = parameters.radius;
    return reference::signed_distance(
               reference::Box{parameters.outer.center, {half.x - r, half.y - r, half.z - r}}, p) -
           r;
  }
};

// A torus grown to one with a thicker tube, and shrunk to a thinner one.
struct OffsetRow {
  static constexpr const char* name = "offset";
  static constexpr bool exact_solid = true;
  using Operations = OnlyOperations<Operation::torus, Operation::offset>;
  struct Parameters {
    reference::Torus torus;
    Real radius{};
  };
  static Parameters draw(Random& random, Real size) {
    const reference::Torus torus = TorusRow::draw(random, size);
    return {torus, random.uniform(-torus.tube_radius, torus.ring_radius - torus.tube_radius)};
  }
  static std::vector<Parameters> degenerate(Real size) {
    return {{{{}, size, 0}, size}, {{{}, size, size}, -size}};
  }
  static std::vector<Vec3> places(const Parameters& p) { return TorusRow::places(p.torus); }
  template <class S>
  static auto node(const Parameters& p) {
    return offset(TorusRow::node<S>(p.torus), rounded<S>(p.radius));
  }
  static Real value(const Parameters& parameters, const Vec3& p) {
    reference::Torus moved = parameters.torus;
    moved.tube_radius += parameters.radius;
    return reference::signed_distance(moved, p);
  }
};

TEST(OffsetConformance, Torus) { judge_row<TorusRow>(741); }
TEST(OffsetConformance, RoundedBox) { judge_row<RoundedBoxRow>(742); }
TEST(OffsetConformance, Offset) { judge_row<OffsetRow>(743); }

}  // namespace
}  // namespace nearfield::property
