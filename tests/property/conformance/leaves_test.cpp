/// Leaves of the other kinds: points and planes as ray functions, planes and quadrics as polynomials.

#include "property/conformance/skeletons.hpp"

namespace nearfield::property {
namespace {

/// As the scalar holds it: slopes are compared as if coefficients were not rounded.
template <class S>
Real exactly(Real x) {
  return real(rounded<S>(x));
}
template <class S>
Vec3 exactly(const Vec3& v) {
  return {exactly<S>(v.x), exactly<S>(v.y), exactly<S>(v.z)};
}

struct Globe {
  Vec3 center;
  Real radius;
};

struct RayPointRow {
  static constexpr const char* name = "ray_point";
  static constexpr bool exact_solid = false;
  using Operations = OnlyOperations<Operation::ray_point>;
  using Parameters = Globe;
  static Parameters draw(Random& random, Real size) {
    return {random.vector(-size, size), ray_radius(random, size)};
  }
  static std::vector<Parameters> degenerate(Real size) {
    return {{{}, size}, {{size, 0, -size}, least_radius}, {{0, size, 0}, 4 * size}};
  }
  static std::vector<Vec3> places(const Parameters& p) {
    return {p.center, p.center + Vec3{p.radius, 0, 0}, p.center + Vec3{0, 15 * p.radius, 0}};
  }
  template <class S>
  static auto node(const Parameters& p) {
    return RayPoint<S>{rounded<S>(p.center), RayRadius<S>(rounded<S>(p.radius))};
  }
  static Real value(const Parameters& globe, const Vec3& p) {
    return cut_off(reference::distance(p, globe.center) / globe.radius);
  }
};

struct Wall {
  Vec3 point, normal;
  Real radius;
};

struct RayPlaneRow {
  static constexpr const char* name = "ray_plane";
  static constexpr bool exact_solid = false;
  using Operations = OnlyOperations<Operation::ray_plane>;
  using Parameters = Wall;
  static Parameters draw(Random& random, Real size) {
    return {random.vector(-size, size), random.unit_vector(), ray_radius(random, size)};
  }
  static std::vector<Parameters> degenerate(Real size) {
    return {{{}, {0, 0, 1}, size},
            {{size, 0, 0}, {-1, 0, 0}, least_radius},
            {{0, 0, size}, {0.6L, 0, 0.8L}, 4 * size}};
  }
  static std::vector<Vec3> places(const Parameters& p) {
    return {p.point, p.point + p.radius * p.normal, p.point - p.radius * p.normal};
  }
  template <class S>
  static auto node(const Parameters& p) {
    return RayPlane<S>{rounded<S>(p.point), rounded<Unit<S>>(p.normal), RayRadius<S>(rounded<S>(p.radius))};
  }
  static Real value(const Parameters& wall, const Vec3& p) {
    return cut_off(std::max<Real>(0, dot(p - wall.point, wall.normal)) / wall.radius);
  }
};

/// x^T A x + linear . x + constant, A by its diagonal and what is beside it.
struct Polynomial {
  Vec3 diagonal, aside, linear;
  Real constant{};

  Real at(const Vec3& p) const {
    return diagonal.x * p.x * p.x + diagonal.y * p.y * p.y + diagonal.z * p.z * p.z +
           2 * (aside.x * p.y * p.z + aside.y * p.x * p.z + aside.z * p.x * p.y) + dot(linear, p) + constant;
  }
};

template <class Scalar>
struct AlgebraicPlaneRow {
  static constexpr const char* name = "algebraic_plane";
  static constexpr bool exact_solid = false;
  using Operations = OnlyOperations<Operation::algebraic_plane>;
  using Parameters = Polynomial;
  static Polynomial plane(const Vec3& normal, Real offset) { return {{}, {}, normal, -offset}; }
  static Parameters draw(Random& random, Real size) {
    return plane(exactly<Scalar>(random.uniform(0.01L, 2) * random.unit_vector()),
                 exactly<Scalar>(random.uniform(-1, 1) * size));
  }
  static std::vector<Parameters> degenerate(Real size) {
    return {plane({}, 0), plane({}, size), plane({0, 0, 1}, 0), plane({0.25L, -0.5L, 0}, -size)};
  }
  static std::vector<Vec3> places(const Parameters&) { return {{}, {1, 0, 0}}; }
  template <class S>
  static auto node(const Parameters& p) {
    return AlgebraicPlane<S>{rounded<S>(p.linear), rounded<S>(-p.constant)};
  }
  static Real value(const Parameters& plane, const Vec3& p) { return plane.at(p); }
};

/// So flat that values stay in the number range.
template <class Scalar>
struct QuadricRow {
  static constexpr const char* name = "quadric";
  static constexpr bool exact_solid = false;
  using Operations = OnlyOperations<Operation::quadric>;
  using Parameters = Polynomial;
  static Real greatest() { return 0.05L / real(ScalarTraits<Scalar>::domain()); }
  static Parameters draw(Random& random, Real) {
    const Real a = greatest();
    return {exactly<Scalar>(random.vector(-a, a)), exactly<Scalar>(random.vector(-a, a)),
            exactly<Scalar>(random.vector(-0.25L, 0.25L)), exactly<Scalar>(random.uniform(-1, 1))};
  }
  static std::vector<Parameters> degenerate(Real size) {
    const Real a = exactly<Scalar>(greatest());
    return {{{}, {}, {}, 0},
            {{a, a, a}, {}, {}, exactly<Scalar>(-a * size * size)},
            {{}, {a, -a, a}, {}, 0},
            {{a, a, 0}, {}, {}, 0},
            {{a, a, -a}, {}, {0, 0, 0.25L}, 0}};
  }
  static std::vector<Vec3> places(const Parameters&) { return {{}, {1, 0, 0}}; }
  template <class S>
  static auto node(const Parameters& p) {
    return Quadric<S>{rounded<S>(p.diagonal), rounded<S>(p.aside), rounded<S>(p.linear),
                      rounded<S>(p.constant)};
  }
  static Real value(const Parameters& quadric, const Vec3& p) { return quadric.at(p); }
};

TEST(LeafConformance, RayPoint) { judge_row<RayPointRow>(761); }
TEST(LeafConformance, RayPlane) { judge_row<RayPlaneRow>(762); }
TEST(LeafConformance, AlgebraicPlane) { judge_rows<AlgebraicPlaneRow>(763); }
TEST(LeafConformance, Quadric) { judge_rows<QuadricRow>(764); }

}  // namespace
}  // namespace nearfield::property
