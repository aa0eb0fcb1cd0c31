#pragma once
/// Skeletons whose nearest points are found by Newton steps, of any shape: values everywhere, and directions where the
/// nearest point leads by more than is certified.

#include "property/conformance/conformance.hpp"

namespace nearfield::property {

struct WildTaste {
  const char* name;
  int skeletons, points_each = 100;
  Real reach;            ///< of points, in steps of the skeleton
  Real exact_within;     ///< units in the last place
  Real greatest_strayed; ///< share of directions off by more than 0.003
};

/// `Wild` has draw(random, domain, step), which gives a skeleton, and of one rounded_to<S>(), on(skeleton, random), a place
/// on it, nearest(skeleton, p), and `radius`.
template <class S, class Wild>
void judge_wild_skeletons(const WildTaste& taste, std::uint64_t seed) {
  Random random(seed);
  Failures error, below;
  const Real domain = real(ScalarTraits<S>::domain()), unit = last_place<S>(domain);
  Real worst = 0, worst_share = 0, worst_direction = 0;
  long long points = 0, exact = 0, directions = 0, strayed = 0;
  for (int i = 0; i < taste.skeletons; ++i) {
    const Real step = std::pow(Real{10}, random.uniform(-3, -1)) * domain;
    const auto skeleton = Wild::draw(random, domain, step);
    const auto shape = skeleton.template rounded_to<S>();
    const Certificate<S> certificate = shape.certificate(domain_reach<S>());
    if (!certificate.valid) continue;
    const Real certified = real(certificate.error);
    for (int j = 0; j < taste.points_each; ++j) {
      const Vec3 away = random.uniform(0, 1) * random.uniform(0, taste.reach) * step * random.unit_vector();
      const Vector3<S> p = rounded<S>(Wild::on(skeleton, random) + away);
      if (!coordinates_in_domain(p)) continue;
      ++points;
      const Sample<S> sample = shape.template evaluate<Sample<S>>(p);
      const auto nearest = Wild::nearest(skeleton, real(p));
      const Real off = real(sample.value) - (nearest.distance - skeleton.radius);
      if (std::fabs(off) < taste.exact_within * unit) ++exact;
      worst = std::max(worst, off);
      worst_share = std::max(worst_share, off / certified);
      error.check(off <= certified, [&](std::ostream& out) { out << off << " certified " << certified; });
      below.check(off >= -16 * unit, [&](std::ostream& out) { out << off / unit << " units"; });
      if (nearest.runner_up - nearest.distance < 2 * certified || nearest.distance < 1e-3L * step) continue;
      ++directions;
      const Real turned =
          reference::norm(real(sample.gradient) - (real(p) - nearest.place) / nearest.distance);
      worst_direction = std::max(worst_direction, turned);
      if (turned > 3e-3L + 32 * unit / nearest.distance) ++strayed;
    }
  }
  const std::string name = ScalarName<S>::text();
  std::printf("wild %s in %s: %lld points, %lld exact; worst %.3g m, %.3g of what is certified; of %lld directions "
              "%lld strayed, by up to %.3g\n",
              taste.name, name.c_str(), points, exact, static_cast<double>(worst), static_cast<double>(worst_share),
              directions, strayed, static_cast<double>(worst_direction));
  error.expect_none(name + ": within the certified error");
  below.expect_none(name + ": not below the distance");
  EXPECT_GT(points, taste.skeletons * taste.points_each / 3);
  EXPECT_GT(exact, points * 9 / 10);
  EXPECT_GT(directions, points / 3);
  // Where a centre of curvature is near, Newton steps converge slowly.
  EXPECT_LE(static_cast<Real>(strayed), taste.greatest_strayed * static_cast<Real>(directions));
}

template <class Wild>
void judge_wild_skeletons(const WildTaste& taste, std::uint64_t seed) {
  judge_wild_skeletons<Fixed<27>, Wild>(taste, seed);
  judge_wild_skeletons<Fixed<16>, Wild>(taste, seed);
  judge_wild_skeletons<float, Wild>(taste, seed);
}

}  // namespace nearfield::property
