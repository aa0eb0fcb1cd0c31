/// Solids without an end.

#include "property/conformance/conformance.hpp"
#include "reference/revolved_solids.hpp"

namespace nearfield::property {
namespace {

// 0 now and then, otherwise of any size.
Real radius_of(Random& random, Real size) {
  return random.chance(0.1L) ? 0 : random.uniform(0.001L, 1) * size;
}

struct HalfSpaceRow {
  static constexpr const char* name = "half_space";
  static constexpr bool exact_solid = true;
  using Operations = OnlyOperations<Operation::half_space>;
  using Parameters = reference::HalfSpace;
  static Parameters draw(Random& random, Real size) {
    return {random.vector(-size, size), random.unit_vector()};
  }
  static std::vector<Parameters> degenerate(Real size) {
    return {{{}, {0, 0, 1}}, {{size, 0, 0}, {-1, 0, 0}}, {{0, size, 0}, {0.6L, 0, -0.8L}}};
  }
  static std::vector<Vec3> places(const Parameters& p) { return {p.point, p.point + p.normal}; }
  template <class S>
  static auto node(const Parameters& p) {
    return HalfSpace<S>{rounded<S>(p.point), rounded<Unit<S>>(p.normal)};
  }
  static Real value(const Parameters& parameters, const Vec3& p) {
    return reference::signed_distance(parameters, p);
  }
};

struct InfiniteCylinderRow {
  static constexpr const char* name = "infinite_cylinder";
  static constexpr bool exact_solid = true;
  using Operations = OnlyOperations<Operation::infinite_cylinder>;
  using Parameters = reference::InfiniteCylinder;
  static Parameters draw(Random& random, Real size) {
    return {random.vector(-size, size), radius_of(random, size)};
  }
  static std::vector<Parameters> degenerate(Real size) {
    return {{{}, size}, {{size, -size, 0}, 0}, {{}, 1e-3L}};
  }
  static std::vector<Vec3> places(const Parameters& p) {
    return {p.point, {p.point.x, p.point.y, 0.1L}, p.point + Vec3{0, p.radius, 0}};
  }
  template <class S>
  static auto node(const Parameters& p) {
    return InfiniteCylinder<S>{rounded<S>(p.point.x), rounded<S>(p.point.y), rounded<S>(p.radius)};
  }
  static Real value(const Parameters& parameters, const Vec3& p) {
    return reference::signed_distance(parameters, p);
  }
};

struct InfiniteConeRow {
  static constexpr const char* name = "infinite_cone";
  static constexpr bool exact_solid = true;
  using Operations = OnlyOperations<Operation::infinite_cone>;
  using Parameters = reference::InfiniteCone;
  static Parameters draw(Random& random, Real size) {
    const Real angle = random.chance(0.2L) ? std::pow(Real{10}, random.uniform(-10, -1))
                                           : random.uniform(0, reference::pi / 2);
    return {random.vector(-size, size), random.chance(0.1L) ? reference::pi / 2 - angle : angle};
  }
  static std::vector<Parameters> degenerate(Real size) {
    return {{{}, 0}, {{size, 0, -size}, reference::pi / 2}, {{}, reference::pi / 4}, {{}, 1e-9L}};
  }
  static std::vector<Vec3> places(const Parameters& p) {
    const Vec3 generator{std::sin(p.half_angle), 0, std::cos(p.half_angle)};
    return {p.apex, p.apex + Vec3{0, 0, 1}, p.apex - Vec3{0, 0, 1}, p.apex + generator,
            p.apex + Vec3{generator.z, 0, -generator.x}};
  }
  template <class S>
  static auto node(const Parameters& p) {
    return InfiniteCone<S>{rounded<S>(p.apex), rounded<Unit<S>>(std::sin(p.half_angle)),
                           rounded<Unit<S>>(std::max(Real{0}, std::cos(p.half_angle)))};
  }
  static Real value(const Parameters& parameters, const Vec3& p) {
    return reference::signed_distance(parameters, p);
  }
};

TEST(UnboundedSolidConformance, HalfSpace) { judge_row<HalfSpaceRow>(731); }
TEST(UnboundedSolidConformance, InfiniteCylinder) { judge_row<InfiniteCylinderRow>(732); }
TEST(UnboundedSolidConformance, InfiniteCone) { judge_row<InfiniteConeRow>(733); }

}  // namespace
}  // namespace nearfield::property
