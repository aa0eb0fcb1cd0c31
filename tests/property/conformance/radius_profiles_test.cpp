/// Influence radii that depend on the place along a skeleton and on the distance from an axis.

#include <nearfield/curve/radius_profile.hpp>
#include <nearfield/field/deformed.hpp>

#include "property/conformance/skeletons.hpp"
#include "reference/deformations.hpp"

namespace nearfield::property {
namespace {

/// A radius along a skeleton.
struct Vase {
  constexpr Differentiable operator()(const Differentiable& t) const {
    return 1.0 + 0.3 * sin(2.0 * kPi * t) + 0.2 * t;
  }
  static Real radius(Real t) { return 1 + 0.3L * std::sin(2 * reference::pi * t) + 0.2L * t; }
};
template <class S>
inline const Table<S, 256> vase_table = bake<S, 256>(along_profile(Vase{}));

template <class Scalar>
struct ScaleAlongRow {
  static constexpr const char* name = "scale_along";
  static constexpr bool exact_solid = false;
  static constexpr Real direction_tolerance = gradient_tolerance<Scalar>(4, 1e-5L);
  using Operations = OnlyOperations<Operation::ray_segment, Operation::scale_along>;
  struct Parameters {
    Skeleton skeleton;
    Vec3 from, axis;
    Real length, cut;
  };
  static Parameters draw(Random& random, Real any_size) {
    const Real size = telling<Scalar>(any_size);
    Parameters p{draw_skeleton(random, size),
                 {},
                 {},
                 std::max(2 * least_radius, even(random.uniform(0.3L, 1) * size)),
                 even(random.uniform(1.6L, 4))};
    p.skeleton.length = p.length;
    p.from = p.skeleton.from;
    p.axis = p.skeleton.axis;
    if (random.chance(0.5L)) p.axis = random.unit_vector();
    return p;
  }
  static std::vector<Parameters> degenerate(Real size) {
    const Real least = ScalarTraits<Scalar>::is_fixed ? least_radius : 0.125L * size;
    return {{{{}, {0, 0, 1}, size, size}, {}, {0, 0, 1}, size, 2},
            {{{}, {0, 0, 1}, 0, size}, {}, {1, 0, 0}, least, 1.6L},
            {{{}, {0, 0, 1}, 0, least}, {}, {1, 0, 0}, size, 9},
            {{{size, size, 0}, {0, 1, 0}, size, 0.5L * size}, {}, {0.6L, -0.8L, 0}, 8 * size, 3}};
  }
  static std::vector<Vec3> places(const Parameters& p) {
    const Vec3 end = p.from + p.length * p.axis, middle = 0.5L * (p.from + end);
    return {p.from, end, middle, middle + Vec3{0.5L * p.skeleton.radius, 0, 0},
            end + Vec3{0, 0, p.skeleton.radius}};
  }
  template <class S>
  static void tables(golden::NodeWriter<S, 4096, Operations>& writer) {
    writer.table(vase_table<S>);
  }
  template <class S>
  static auto node(const Parameters& p) {
    const ScaleAlong<S> scale(rounded<S>(p.from), rounded<Unit<S>>(p.axis), rounded<S>(p.length),
                              rounded<S>(p.cut));
    return combine(scale, vase_table<S>, p.skeleton.template ray<S>());
  }
  static Real value(const Parameters& along, const Vec3& p) {
    const Real t = std::clamp<Real>(dot(p - along.from, along.axis) / along.length, 0, 1);
    return along.skeleton.cut_off(p, along.cut) / Vase::radius(t);
  }
};

template <class Scalar>
struct ScaleFromAxisRow {
  static constexpr const char* name = "scale_from_axis";
  static constexpr bool exact_solid = false;
  static constexpr Real direction_tolerance = gradient_tolerance<Scalar>(4, 1e-5L);
  using Operations = OnlyOperations<Operation::ray_segment, Operation::scale_from_axis>;
  struct Parameters {
    Skeleton skeleton;
    Real limit, cut;
  };
  static Parameters draw(Random& random, Real any_size) {
    const Real size = telling<Scalar>(any_size);
    return {draw_skeleton(random, size), std::max(2 * least_radius, even(random.uniform(0.3L, 1) * size)),
            even(random.uniform(1.6L, 4))};
  }
  static std::vector<Parameters> degenerate(Real size) {
    const Real least = ScalarTraits<Scalar>::is_fixed ? least_radius : 0.125L * size;
    return {{{{}, {0, 0, 1}, 0, size}, size, 2},
            {{{}, {0, 0, 1}, size, size}, least, 1.6L},
            {{{}, {0, 0, 1}, size, least}, size, 9},
            {{{}, {1, 0, 0}, size, size}, 8 * size, 3}};
  }
  static std::vector<Vec3> places(const Parameters& p) {
    return {{},
            {p.limit, 0, 0},
            {0, -0.5L * p.limit, p.limit},
            p.skeleton.from,
            {0, 0, p.limit},
            {0.6L * p.limit, 0.8L * p.limit, 0}};
  }
  template <class S>
  static void tables(golden::NodeWriter<S, 4096, Operations>& writer) {
    writer.table(vase_table<S>);
  }
  template <class S>
  static auto node(const Parameters& p) {
    return combine(ScaleFromAxis<S>(rounded<S>(p.limit), rounded<S>(p.cut)), vase_table<S>,
                   p.skeleton.template ray<S>());
  }
  static Real value(const Parameters& disc, const Vec3& p) {
    const Real part = std::min<Real>(reference::norm({p.x, p.y, 0}) / disc.limit, 1);
    return disc.skeleton.cut_off(p, disc.cut) / Vase::radius(part);
  }
};

TEST(RadiusProfileConformance, Along) { judge_rows<ScaleAlongRow>(0xA1046ULL); }
TEST(RadiusProfileConformance, FromAxis) { judge_rows<ScaleFromAxisRow>(0xF4035ULL); }

}  // namespace
}  // namespace nearfield::property
