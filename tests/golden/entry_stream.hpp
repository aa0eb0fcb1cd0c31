// Every entry of a field's vocabulary in a fixed stream of points, and a digest of every bit of the results.
// Freestanding: the same on the host and on a target.
#pragma once

#include <golden/query_stream.hpp>
#include <nearfield/curve/radius_profile.hpp>
#include <nearfield/curve/ray_kernel.hpp>
#include <nearfield/field/deformed.hpp>
#include <nearfield/field/metrics.hpp>
#include <nearfield/field/solids.hpp>

namespace nearfield::golden {

// Adds what fields give, each at the next points of one stream.
template <class S>
class EntryDigest {
 public:
  // Counts fields that are not valid, of which there should be none.
  template <class Node>
  [[gnu::noinline]] void add(const Node& node) {
    constexpr int points = 200;
    const auto composed = field(node);
    add_facts<S>(digest_, composed);
    if (!composed.valid()) ++invalid_;
    const S parameters[] = {Scene<S>::metres(0.375)};
    const Slots<S> slots(nullptr, 0, parameters, 1);
    for (int i = 0; composed.valid() && i < points; ++i) {
      Vector3<S> p = point_from<S>(stream_);
      while (!coordinates_in_domain(p)) p = point_from<S>(stream_);
      add_number(composed.template evaluate<Value<S>>(p, slots).value);
      const Sample<S> sample = composed.template evaluate<Sample<S>>(p, slots);
      add_number(sample.value);
      add_number(sample.gradient.x);
      add_number(sample.gradient.y);
      add_number(sample.gradient.z);
    }
  }
  uint64_t value() { return digest_.value(); }
  int invalid() const { return invalid_; }

 private:
  void add_number(S number) { digest_.add(ScalarTraits<S>::word(number)); }

  Stream stream_{0x656e7472u};
  Digest digest_;
  int invalid_ = 0;
};

template <class S>
constexpr BicubicPatch<S> draped_patch() {
  const double heights[] = {0.0, 0.25, -0.125, 0.0625, 0.125, 0.375, 0.0};
  Vector3<S> control[16] = {};
  for (int i = 0; i < 16; ++i)
    control[i] = Scene<S>::at(0.25 * (i / 4) - 0.375, 0.1875 * (i % 4) - 0.25, heights[i * i % 7]);
  return BicubicPatch<S>(control, Scene<S>::metres(0.0625));
}

// Parameters as a scene has them.
template <class S>
struct Entries {
  using At = Scene<S>;
  static constexpr auto metres = At::metres;
  static constexpr auto at = At::at;

  static constexpr Table<S, 64> two_sided_kernel = bake<S, 64>(two_sided(exterior(step::polynomial<3>, 0.25)));
  static constexpr Table<S, 8> over_r = bake<S, 8>(over_range(potential::Cubic{}));
  static constexpr auto round_union = profile::super_ellipsoidal_union(2.0);
  static constexpr auto round_intersection = profile::super_ellipsoidal_intersection(2.0);
  static constexpr Table<S, 32> round_union_table = bake<S, 32>(round_union);
  static constexpr Table<S, 32> round_intersection_table = bake<S, 32>(round_intersection);

  static constexpr Sphere<S> ball{at(0.25, -0.5, 0.125), metres(0.3)};
  static constexpr Box<S> block{at(-0.25, 0.5, 0.375), at(0.2, 0.1, 0.4)};
  static constexpr Capsule<S> rod{at(-0.5, -0.25, 0.0), at(0.5, 0.5, 0.25), metres(0.0)};

  static void add_solids(EntryDigest<S>& digest) {
    digest.add(ball);
    digest.add(Sphere<S>{at(0.25, -0.5, 0.125), {}});
    digest.add(Capsule<S>(at(-0.5, -0.25, 0.0), at(0.5, 0.5, 0.25), metres(0.0625)));
    digest.add(block);
    digest.add(Cylinder<S>{at(0.125, 0.25, -0.5), metres(0.15), metres(0.45)});
    digest.add(TaperedCapsule<S>(at(-0.5, -0.25, 0.0), at(0.5, 0.5, 0.25), metres(0.25), metres(0.125)));
    digest.add(ConeFrustum<S>(at(0.125, 0.25, -0.5), metres(0.5), metres(0.25), metres(0.375)));
    digest.add(Torus<S>{at(0.125, 0.25, -0.25), metres(0.5), metres(0.125)});
    digest.add(Disc<S>{at(0.125, 0.25, -0.25), metres(0.5), metres(0.0625)});
    digest.add(HalfSpace<S>{at(0.125, 0.25, -0.25), {At::unit(0.6), At::unit(0.0), At::unit(0.8)}});
    digest.add(InfiniteCylinder<S>{metres(0.25), metres(-0.5), metres(0.375)});
    digest.add(InfiniteCone<S>{at(0.125, 0.25, -0.25), At::unit(0.6), At::unit(0.8)});
    digest.add(rounded_box(at(-0.25, 0.5, 0.375), at(0.25, 0.125, 0.5), metres(0.0625)));
  }

  static constexpr BicubicPatch<S> patch = draped_patch<S>();
  static void add_skeletons(EntryDigest<S>& digest) {
    const Vector3<S> points[] = {at(-0.5, -0.25, 0.0), at(0.25, 0.5, 0.25), at(0.5, -0.25, 0.5), at(0.0, -0.5, 0.25),
                                 at(-0.25, 0.0, 0.5)};
    digest.add(Polyline<S>(points, 5, metres(0.0625)));
    const S x[] = {metres(-0.5), metres(0.5), metres(0.0), metres(0.25)};
    const S y[] = {metres(-0.25), metres(-0.5), metres(0.125), metres(0.75)};
    digest.add(Polygon<S>(x, y, 4, metres(0.25), metres(0.0625)));
    digest.add(CubicCurve<S>(points, 4, metres(0.0625)));
    digest.add(CubicCurve<S>::b_spline(points, 5, metres(0.0625)));
    digest.add(patch);
  }

  static constexpr double radii[] = {1.0, 1.4, 0.8, 1.2};
  static constexpr auto along_table = bake<S, 8>(along_profile(ValueSpline(radii, 4, false)));
  static constexpr auto about_table = bake<S, 8>(about_profile(ValueSpline(radii, 4, true)));
  static void add_deformations(EntryDigest<S>& digest) {
    const RayPoint<S> point{at(0.25, 0.25, 0.0), RayRadius<S>(metres(0.5))};
    digest.add(surface_of_revolution(along_table, at(-0.5, -0.25, 0.0), at(0.5, 0.5, 0.25), metres(0.25)));
    digest.add(scaled_about_axis(about_table, metres(0.25), point));
    digest.add(scaled_about_axis(about_table, metres(0.25), point, static_cast<typename ScaleAbout<S>::Twist>(0.75)));
    digest.add(scaled_about_circle(about_table, metres(0.25), metres(0.5), point));
    digest.add(scaled_from_axis(along_table, metres(0.75), point));
    digest.add(with_noise(ball, metres(0.0625), Fixed<16>(3.5), 3, 7));
    digest.add(with_noise(with_potential(SoftPoint<S>{at(0.25, 0.25, 0.0), Influence<S>(metres(0.9), metres(1.0))},
                                         At::potential),
                          metres(0.5), Fixed<16>(2.0), 2, 7));
  }

  template <template <class> class Blend, class A, class B, int segments>
  static constexpr auto blended(const Table<S, segments>& table, double limit, const A& a, const B& b) {
    Blend<S> blend;
    blend.scale = ArgumentScale<S>::of(metres(limit));
    return combine(blend, table, a, b);
  }
  static void add_distance_blends(EntryDigest<S>& digest) {
    digest.add(unite(ball, block));
    digest.add(intersect(ball, block));
    digest.add(subtract(ball, block));
    digest.add(blended<AdditiveUnion>(At::kernel, 0.75, ball, block));
    digest.add(blended<AdditiveIntersection>(At::kernel, 0.75, ball, block));
    digest.add(blended<AdditiveSubtraction>(At::kernel, 0.75, ball, block));
    digest.add(blended<TwoSidedUnion>(two_sided_kernel, 0.75, ball, block));
    digest.add(blended<TwoSidedIntersection>(two_sided_kernel, 0.75, ball, block));
    digest.add(blended<TwoSidedSubtraction>(two_sided_kernel, 0.75, ball, block));
    const ArgumentScale<S> range = ArgumentScale<S>::of(metres(1.5));
    digest.add(combine(LogSumExpUnion<S>{range, 3}, ball, block, rod));
    digest.add(combine(LogSumExpIntersection<S>{range, 3}, ball, block, rod));
    digest.add(combine(LogSumExpSubtraction<S>{range, 3}, ball, block, rod));
    digest.add(combine(Morph<S>{0}, ball, block));
    digest.add(combine(Swell<S>{metres(0.25), 0}, block));
  }

  static void add_intensities(EntryDigest<S>& digest) {
    const auto bright = with_potential(SoftPoint<S>{at(0.25, 0.25, 0.0), Influence<S>(metres(0.9), metres(1.0))},
                                       At::potential);
    const auto dark = with_potential(SoftSegment<S>{rod, Influence<S>(metres(0.7), metres(-0.75))}, At::potential);
    digest.add(bright);
    digest.add(dark);
    digest.add(soft_sum(bright, dark));
    digest.add(combine(IntensityUnion<S>{}, bright, dark));
    digest.add(combine(IntensityIntersection<S>{}, bright, dark));
    digest.add(combine(PotentialOfDistance<S>(metres(0.75), metres(1.0), kUnitRate, metres(0.001)), over_r, block));
    const RayPoint<S> ray{at(0.25, 0.25, 0.0), RayRadius<S>(metres(0.75))};
    digest.add(combine(PotentialOfRay<S>(metres(1.0), metres(1.0), ray.certificate(domain_reach<S>())), over_r, ray));
    digest.add(combine(IntensityMorph<S>{0}, bright, dark));
    digest.add(combine(Fade<S>{0}, bright));
  }

  static void add_rays(EntryDigest<S>& digest) {
    const RayRadius<S> near(metres(0.5)), far(metres(0.75));
    const RayPoint<S> point{at(0.25, 0.25, 0.0), near};
    const RaySegment<S> segment{rod, far};
    digest.add(point);
    digest.add(segment);
    digest.add(RayPlane<S>{at(0.125, 0.25, -0.25), {At::unit(0.6), At::unit(0.0), At::unit(0.8)}, near});
    digest.add(combine(RayUnion<S>{}, point, segment));
    digest.add(combine(RayIntersection<S>{}, point, segment));
    RayLinearUnion<S> round;
    round.sides = RaySides<S>::of(round_union);
    digest.add(combine(round, round_union_table, point, segment));
    RayLinearIntersection<S> norm;
    norm.sides = RaySides<S>::of(round_intersection);
    digest.add(combine(norm, round_intersection_table, point, segment));
    RayLinearDifference<S> difference;
    difference.sides = norm.sides;
    difference.complement = {metres(1.0), metres(0.5)};
    digest.add(combine(difference, round_intersection_table, point, segment));
    digest.add(combine(VariableInfluence<S>(metres(0.75)), point, segment));
    digest.add(combine(RayMorph<S>{0}, point, segment));
    digest.add(RaySlab<S>{at(0.125, 0.25, -0.25), {At::unit(0.6), At::unit(0.0), At::unit(0.8)}, near});
    digest.add(combine(RayOfDistance<S>{near}, block));
    digest.add(superquadric(at(0.125, 0.25, -0.25), at(0.25, 0.5, 0.375), Rate(0.75), Rate(2.5)));
    digest.add(RaySweep<S>(at(0.125, 0.25, -0.25), at(0.25, 0.375, 0.5), Rate(4.0), Rate(1.5), metres(0.75), metres(0.5),
                           metres(0.5)));
  }

  static constexpr AlgebraicPlane<S> plane(double x, double y, double z, double offset) {
    return {at(x, y, z), metres(offset)};
  }
  static void add_algebraic(EntryDigest<S>& digest) {
    const AlgebraicPlane<S> a = plane(0.75, -0.25, 0.125, 0.0625), b = plane(-0.25, 0.5, 0.375, 0.125),
                            c = plane(0.125, 0.25, -0.75, 0.25), d = plane(0.5, 0.5, 0.25, -0.125);
    digest.add(a);
    digest.add(Quadric<S>{at(0.25, 0.125, -0.125), at(0.0625, 0.0, 0.03125), at(0.25, 0.0, 0.125), metres(-0.25)});
    digest.add(AlgebraicTorus<S>(at(0.125, 0.25, -0.25), metres(0.5), metres(0.125), metres(0.5)));
    digest.add(combine(AlgebraicUnion<S>{}, a, b));
    digest.add(combine(AlgebraicIntersection<S>{}, a, b));
    digest.add(combine(AlgebraicOfDistance<S>{metres(1.5)}, ball));
    digest.add(combine(AlgebraicOfRay<S>{metres(0.5), metres(1.5)},
                       RayPoint<S>{at(0.25, 0.25, 0.0), RayRadius<S>(metres(0.5))}));
    digest.add(combine(HoffmannHopcroftUnion<S>::of(metres(0.5), metres(0.75), metres(0.25)), a, b));
    digest.add(combine(HoffmannHopcroftIntersection<S>::of(metres(0.5), metres(0.75), metres(0.25)), a, b));
    digest.add(combine(HoffmannHopcroftDifference<S>::of(metres(0.5), metres(0.75), metres(0.25)), a, b));
    digest.add(combine(FunctionalSpline<S>{2, 1, 2, metres(0.3)}, a, b, c));
    RibbonPatch<S> ribbons;
    ribbons.side_count = 3;
    ribbons.exponent = 2;
    for (uint32_t i = 0; i < 3; ++i) ribbons.side_weight[i] = metres(1.0);
    ribbons.centre_weight = metres(0.25);
    digest.add(combine(ribbons, a, b, c, d, b, a));
    CornerPatch<S> corners;
    corners.side_count = 3;
    corners.exponent = 3;
    for (uint32_t i = 0; i < 3; ++i) corners.side_weight[i] = metres(0.5);
    corners.centre_weight = metres(-0.25);
    digest.add(combine(corners, a, b, c, d, b, a));
    digest.add(scaled(metres(1.5), combine(AlgebraicUnion<S>{}, a, c)));
    digest.add(in_box(at(0.5, 0.75, 0.5), combine(HoffmannHopcroftUnion<S>::of(metres(0.5), metres(0.75), metres(0.25)), a, b)));
  }
};

// Of all families, in this order. `invalid`: how many fields were not valid.
template <class S>
uint64_t entry_digest(int& invalid) {
  EntryDigest<S> digest;
  Entries<S>::add_solids(digest);
  Entries<S>::add_skeletons(digest);
  Entries<S>::add_distance_blends(digest);
  Entries<S>::add_intensities(digest);
  Entries<S>::add_rays(digest);
  Entries<S>::add_algebraic(digest);
  Entries<S>::add_deformations(digest);
  invalid = digest.invalid();
  return digest.value();
}

}  // namespace nearfield::golden
