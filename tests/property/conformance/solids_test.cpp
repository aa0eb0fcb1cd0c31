/// The solids that robots are made of.

#include "property/conformance/conformance.hpp"
#include "reference/shapes.hpp"

namespace nearfield::property {
namespace {

/// So short that the square of its length has few digits in a float.
constexpr Vec3 no_way{3e-21L, -2e-22L, 1e-21L};

struct SphereRow {
  static constexpr const char* name = "sphere";
  static constexpr bool exact_solid = true;
  using Operations = OnlyOperations<Operation::sphere>;
  using Parameters = reference::Sphere;
  static Parameters draw(Random& random, Real size) {
    return {random.vector(-size, size), random.uniform(0.001L, 1) * size};
  }
  static std::vector<Parameters> degenerate(Real size) { return {{{}, size}, {{size, -size, 0}, 1e-3L}, {{0, size, 0}, 0}}; }
  static std::vector<Vec3> places(const Parameters& p) {
    return {p.center, p.center + no_way, p.center + Vec3{p.radius, 0, 0}};
  }
  template <class S>
  static auto node(const Parameters& p) {
    return Sphere<S>{rounded<S>(p.center), rounded<S>(p.radius)};
  }
  static Real value(const Parameters& parameters, const Vec3& p) { return reference::signed_distance(parameters, p); }
};

struct BoxRow {
  static constexpr const char* name = "box";
  static constexpr bool exact_solid = true;
  using Operations = OnlyOperations<Operation::box>;
  using Parameters = reference::Box;
  static Parameters draw(Random& random, Real size) {
    return {random.vector(-size, size), random.vector(0.001L * size, size)};
  }
  static std::vector<Parameters> degenerate(Real size) {
    return {{{}, {size, size, size}}, {{size, 0, -size}, {1e-3L, size, 0.5L * size}}};
  }
  static std::vector<Vec3> places(const Parameters& p) {
    const Vec3& h = p.half_extents;
    return {p.center, p.center + h, p.center + Vec3{h.x, -h.y, 0}, p.center + Vec3{0, 0, -h.z}};
  }
  template <class S>
  static auto node(const Parameters& p) {
    return Box<S>{rounded<S>(p.center), rounded<S>(p.half_extents)};
  }
  static Real value(const Parameters& parameters, const Vec3& p) { return reference::signed_distance(parameters, p); }
};

struct CylinderRow {
  static constexpr const char* name = "cylinder";
  static constexpr bool exact_solid = true;
  using Operations = OnlyOperations<Operation::cylinder>;
  using Parameters = reference::Cylinder;
  static Parameters draw(Random& random, Real size) {
    return {random.vector(-size, size), random.uniform(0.001L, 1) * size, random.uniform(0.001L, 1) * size};
  }
  static std::vector<Parameters> degenerate(Real size) {
    return {{{}, size, size}, {{size, 0, -size}, 1e-3L, size}, {{0, size, 0}, size, 1e-3L}};
  }
  static std::vector<Vec3> places(const Parameters& p) {
    return {p.center, p.center + Vec3{p.radius, 0, p.half_height}, p.center + Vec3{0, -p.radius, 0},
            p.center + Vec3{0, 0, p.half_height}};
  }
  template <class S>
  static auto node(const Parameters& p) {
    return Cylinder<S>{rounded<S>(p.center), rounded<S>(p.radius), rounded<S>(p.half_height)};
  }
  static Real value(const Parameters& parameters, const Vec3& p) { return reference::signed_distance(parameters, p); }
};

struct CapsuleRow {
  static constexpr const char* name = "capsule";
  static constexpr bool exact_solid = true;
  using Operations = OnlyOperations<Operation::capsule>;
  using Parameters = reference::Capsule;
  static Parameters draw(Random& random, Real size) {
    const Vec3 a = random.vector(-size, size);
    const Real length = std::pow(Real{10}, random.uniform(-3, 0)) * size;
    return {a, a + length * random.unit_vector(), random.uniform(0, 1) * size};
  }
  static std::vector<Parameters> degenerate(Real size) {
    return {{{}, {}, size}, {{}, {}, 0}, {{size, 0, 0}, {size, size, 0}, 0}, {{}, {0, 0, 1e-4L}, size}};
  }
  static std::vector<Vec3> places(const Parameters& p) {
    return {p.a, p.b, p.a - no_way, 0.5L * (p.a + p.b), p.a + Vec3{p.radius, 0, 0}};
  }
  template <class S>
  static auto node(const Parameters& p) {
    return Capsule<S>(rounded<S>(p.a), rounded<S>(p.b), rounded<S>(p.radius));
  }
  static Real value(const Parameters& parameters, const Vec3& p) { return reference::signed_distance(parameters, p); }
};

TEST(SolidConformance, Sphere) { judge_row<SphereRow>(701); }
TEST(SolidConformance, Box) { judge_row<BoxRow>(702); }
TEST(SolidConformance, Cylinder) { judge_row<CylinderRow>(703); }
TEST(SolidConformance, Capsule) { judge_row<CapsuleRow>(704); }

}  // namespace
}  // namespace nearfield::property
