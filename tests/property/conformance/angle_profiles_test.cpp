/// Influence radii that depend on the angle about an axis or a circle.

#include <nearfield/curve/radius_profile.hpp>
#include <nearfield/field/deformed.hpp>

#include "property/conformance/skeletons.hpp"
#include "reference/deformations.hpp"

namespace nearfield::property {
namespace {

/// A radius by the angle.
struct Star {
  constexpr Differentiable operator()(const Differentiable& turn) const {
    return 1.0 + 0.2 * cos(6.0 * kPi * turn) + 0.1 * sin(2.0 * kPi * turn);
  }
  static Real radius(Real angle) { return 1 + 0.2L * std::cos(3 * angle) + 0.1L * std::sin(angle); }
};
template <class S>
inline const Table<S, 256> star_table = bake<S, 256>(about_profile(Star{}));

struct Angular {
  Skeleton skeleton;
  reference::Core core;
  Real cut = 3, twist = 0, ring = 0;
};
template <class Scalar, AngleAbout about>
struct ScaleAboutRow {
  static constexpr bool rings = about == AngleAbout::ring;
  static constexpr const char* name = rings ? "scale_about, beta of a torus" : "scale_about, alpha";
  static constexpr bool exact_solid = false;
  static constexpr Real direction_tolerance = gradient_tolerance<Scalar>(4, 1e-5L);
  using Operations = OnlyOperations<Operation::ray_segment, Operation::scale_about>;
  using Parameters = Angular;
  static Parameters draw(Random& random, Real any_size) {
    const Real size = telling<Scalar>(any_size);
    Parameters p{draw_skeleton(random, size),
                 {even(random.uniform(0.3L, 0.6L) * size), random.uniform(0.8L, 1.2L)},
                 even(random.uniform(1.6L, 4))};
    p.core.radius = std::max(least_radius, p.core.radius);
    if (rings)
      p.ring = even(random.uniform(0, 1) * size);
    else if (random.chance(0.6L))
      p.twist = std::round(random.uniform(-1, 1) * std::min<Real>(0.5L / size, 3) * 65536) / 65536;
    return p;
  }
  static std::vector<Parameters> degenerate(Real size) {
    const Real least = ScalarTraits<Scalar>::is_fixed ? least_radius : 0.125L * size;
    const Skeleton segment{{}, {0, 0, 1}, size, size};
    if (rings)
      return {{segment, {least, 1}, 2},
              {segment, {8 * size, 1}, 2, 0, size},
              {segment, {0.25L * size, 0.9L}, 9, 0, 4 * size}};
    return {{segment, {least, 1}, 2},
            {segment, {8 * size, 1}, 2},
            {segment, {0.25L * size, 0.9L}, 4, std::min<Real>(1 / size, 3)}};
  }
  static std::vector<Vec3> places(const Parameters& p) {
    const Real core = p.core.radius, ring = p.ring;
    return {{},
            {ring, 0, 0},
            {0, -ring, core},
            {ring + core, 0, 0},
            {0, ring - 0.5L * core, 0},
            {-ring, 0, 0.25L * core},
            p.skeleton.from};
  }
  template <class S>
  static void tables(golden::NodeWriter<S, 4096, Operations>& writer) {
    writer.table(star_table<S>);
  }
  template <class S>
  static auto node(const Parameters& p) {
    ScaleAbout<S> scale;
    scale.cut = rounded<S>(p.cut);
    scale.core = detail::RayScaleRange<S>(rounded<S>(p.core.radius));
    scale.level = rounded<Unit<S>>(p.core.level);
    scale.twist = rounded<typename ScaleAbout<S>::Twist>(p.twist);
    scale.ring = rounded<S>(p.ring);
    scale.about = about;
    return combine(scale, star_table<S>, p.skeleton.template ray<S>());
  }
  static Real value(const Parameters& angular, const Vec3& p) {
    const Real away = reference::norm({p.x, p.y, 0}), a = rings ? away - angular.ring : away,
               b = rings ? p.z : 0;
    const Real angle = rings ? reference::angle_of(a, b)
                             : reference::angle_of(p.x, p.y) - 2 * reference::pi * angular.twist * p.z;
    return angular.skeleton.cut_off(p, angular.cut) *
           reference::with_core(1 / Star::radius(angle), reference::norm({a, b, 0}), angular.core);
  }
};
template <class S>
using AboutAxisRow = ScaleAboutRow<S, AngleAbout::axis>;
template <class S>
using AboutRingRow = ScaleAboutRow<S, AngleAbout::ring>;

TEST(AngleProfileConformance, AboutAxis) { judge_rows<AboutAxisRow>(0xAB0071ULL); }
TEST(AngleProfileConformance, AboutRing) { judge_rows<AboutRingRow>(0xAB0072ULL); }

}  // namespace
}  // namespace nearfield::property
