/// Clearance of a whole capsule to random fields of unions, judged by the exact least distance along its
/// axis.

#include <nearfield/query/capsule_clearance.hpp>

#include "property/failures.hpp"
#include "property/random_field.hpp"

#include <algorithm>
#include <array>
#include <cstdio>
#include <vector>

namespace nearfield::property {
namespace {

using reference::Node;
using reference::NodeKind;
using reference::Random;
using reference::Vec3;

constexpr std::array<int, 3> efforts{4, 8, 12};

// Least signed distance of a segment to a convex solid, whose signed distance is convex along it: golden
// section.
Real least_along(const Node& leaf, const reference::Segment& segment) {
  const Real golden = (std::sqrt(Real{5}) - 1) / 2;
  const auto at = [&](Real t) { return reference::value(leaf, reference::point_at(segment, t)); };
  Real low = 0, high = 1, left = high - golden * (high - low), right = low + golden * (high - low);
  Real at_left = at(left), at_right = at(right);
  Real least = std::min(at(0), at(1));
  for (int i = 0; i < 60; ++i) {
    least = std::min({least, at_left, at_right});
    if (at_left <= at_right) {
      high = right;
      right = left;
      at_right = at_left;
      left = high - golden * (high - low);
      at_left = at(left);
    } else {
      low = left;
      left = right;
      at_left = at_right;
      right = low + golden * (high - low);
      at_right = at(right);
    }
  }
  return least;
}

// The same for the sharp union of all leaves of a tree of unions and placements.
Real least_sharp_distance(const Node& node, const reference::Segment& segment) {
  if (node.kind == NodeKind::placed) {
    return least_sharp_distance(node.operands.at(0), {reference::to_local(node.pose, segment.a),
                                                      reference::to_local(node.pose, segment.b)});
  }
  if (node.kind == NodeKind::sphere) {
    return reference::point_segment_distance(node.sphere.center, segment) - node.sphere.radius;
  }
  if (node.kind == NodeKind::capsule) {
    return reference::segment_segment_distance({node.capsule.a, node.capsule.b}, segment) -
           node.capsule.radius;
  }
  if (node.operands.empty()) return least_along(node, segment);
  Real least = least_sharp_distance(node.operands[0], segment);
  for (const Node& operand : node.operands) least = std::min(least, least_sharp_distance(operand, segment));
  return least;
}

template <class S>
class SweepTrial {
 public:
  explicit SweepTrial(std::uint64_t seed) : random_(seed) {}

  void random_fields() {
    for (int i = 0; i < 1500; ++i) {
      FieldTaste taste;
      taste.unions_only = true;
      taste.sharp_only = random_.chance(0.6L);
      taste.greatest_depth = 4;
      const Real reach = real(ScalarTraits<S>::domain());
      taste.size = reach * (random_.chance(0.5L) ? 0.25L : random_.uniform(0.02L, 0.7L));
      const RandomField<S> field = random_field<S>(random_, taste);
      ASSERT_TRUE(field.program.valid());
      for (int k = 0; k < 6; ++k) judge(field, capsule(std::min(reach, 1.4L * taste.size)), taste.size);
    }
    conclude();
    for (std::size_t i = 0; i < efforts.size(); ++i) {
      std::vector<Real>& all = shortfalls_[i];
      ASSERT_FALSE(all.empty());
      std::sort(all.begin(), all.end());
      const auto share = [&all](std::size_t percent) { return all[(all.size() - 1) * percent / 100]; };
      std::printf(
          "%s, %2d refinements: %zu clear; shortfall in parts of the capsule's length: median %.2Le, 90 %% "
          "%.4Lf, 99 %% %.4Lf, greatest %.4Lf\n",
          ScalarName<S>::text().c_str(), efforts[i], all.size(), share(50), share(90), share(99), all.back());
    }
  }

  // Where the bounds are exact, so that there is no slack but the certified error's: a ball beside the middle
  // of a stretch between two evaluations, here of half a capsule, and a ball straight ahead of its end.
  void tightest_obstacle() {
    Real least_shortfall_aside = 1, least_shortfall_ahead = 1;
    for (int i = 0; i < 40000; ++i) {
      const Real size = real(ScalarTraits<S>::domain()) * random_.uniform(0.05L, 0.4L);
      const Vec3 middle = random_.vector(-size, size), u = random_.unit_vector();
      const Vec3 n = reference::normalized_or_zero(reference::cross(u, random_.unit_vector()));
      const Real half = size * random_.uniform(0.1L, 0.9L);
      const bool ahead = random_.chance(0.5L);
      const Real aside = size * std::pow(Real{10}, random_.uniform(-3, 0));
      const Vec3 center = ahead ? middle + (half + aside) * u : middle - half / 2 * u + aside * n;
      const Real radius = last_place<S>(size) * random_.uniform(1, 8);
      RandomField<S> field;
      field.image->operation(Sphere<S>{rounded<S>(center), rounded<S>(radius)});
      field.node = reference::sphere(center, radius);
      field.image->finish();
      field.program = load<S>(field.image->words(), field.image->size() * sizeof(uint32_t));
      const Capsule<S> body(rounded<S>(middle - half * u), rounded<S>(middle + half * u), S{});
      if (!field.program.valid()) continue;
      const Clearance<S> answer = clearance(field.program, body, S{}, SweepEffort<S>{ahead ? 0 : 2, S{}});
      const Real truth = least_sharp_distance(field.node, stored_segment(body));
      too_large_.check(real(answer.distance) <= truth, [&](std::ostream& out) {
        out << real(answer.distance) << " claimed, " << truth << " true, length " << 2 * half;
      });
      answered_.check(answer.status != ClearanceStatus::invalid,
                      [](std::ostream& out) { out << "one ball"; });
      if (answer.status != ClearanceStatus::clear) continue;
      Real& least = ahead ? least_shortfall_ahead : least_shortfall_aside;
      least = std::min(least, truth - real(answer.distance));
    }
    conclude();
    const Real unit = real(ScalarTraits<S>::rounding_unit(ScalarTraits<S>::domain()));
    std::printf("%s: least shortfall with a ball beside %.2Lf, ahead %.2Lf rounding units\n",
                ScalarName<S>::text().c_str(), least_shortfall_aside / unit, least_shortfall_ahead / unit);
    EXPECT_LT(std::max(least_shortfall_aside, least_shortfall_ahead), 10 * unit) << "the trial is not tight";
  }

 private:
  // No longer than a valid capsule may be: twice the domain.
  Capsule<S> capsule(Real around) {
    const Vec3 a = random_.vector(-around, around);
    Vec3 b = random_.chance(0.5L) ? random_.vector(-around, around)
                                  : a + random_.unit_vector() * around * random_.uniform(0, 0.3L);
    if (random_.chance(0.05L)) b = a;
    const Real limit = real(ScalarTraits<S>::domain()) * 0.9999L;
    b = {std::clamp(b.x, -limit, limit), std::clamp(b.y, -limit, limit), std::clamp(b.z, -limit, limit)};
    const Real longest = 2 * limit;
    if (reference::distance(a, b) > longest) b = a + (b - a) * (longest / reference::distance(a, b));
    return Capsule<S>(rounded<S>(a * 0.999L), rounded<S>(b * 0.999L),
                      rounded<S>(around * random_.uniform(0, 0.1L)));
  }

  void judge(const RandomField<S>& field, const Capsule<S>& body, Real size) {
    const reference::Segment axis = stored_segment(body);
    const Real length = real(body.length);
    const S body_error = random_.chance(0.5L) ? S{} : rounded<S>(size * random_.uniform(0, 0.01L));
    const Real nearest = least_sharp_distance(field.node, axis) - real(body.radius);
    const S tolerance = random_.chance(0.7L) ? S{} : rounded<S>(size * 0.001L);
    for (std::size_t i = 0; i < efforts.size(); ++i) {
      const Clearance<S> answer =
          clearance(field.program, body, body_error, SweepEffort<S>{efforts[i], tolerance},
                    Slots<S>(field.slots.data(), static_cast<uint32_t>(field.slots.size())));
      answered_.check(answer.status != ClearanceStatus::invalid, [&](std::ostream& out) { out << length; });
      positive_.check((answer.status == ClearanceStatus::clear) == (answer.distance > S{}),
                      [&](std::ostream& out) { out << real(answer.distance); });
      // The body itself may be anywhere within its error.
      const Real truth = nearest - real(body_error);
      too_large_.check(real(answer.distance) <= std::max(truth, Real{0}), [&](std::ostream& out) {
        out << real(answer.distance) << " claimed, " << truth << " true, " << efforts[i]
            << " refinements, length " << length;
      });
      if (answer.status == ClearanceStatus::touching && field.lowest_order > 3) {
        touching_.check(nearest <= 0, [&](std::ostream& out) { out << nearest; });
      }
      if (answer.status != ClearanceStatus::clear) continue;
      if (field.lowest_order > 3 && tolerance == S{} && length > size / 10) {
        shortfalls_[i].push_back((truth - real(answer.distance)) / length);
      }
      judge_surroundings(field, axis, real(body.radius) + real(answer.distance) + real(body_error));
    }
  }

  // No point within the claimed distance of the capsule may belong to the blended solid.
  void judge_surroundings(const RandomField<S>& field, const reference::Segment& axis, Real within) {
    if (field.lowest_order > 3 || !random_.chance(0.2L)) return;
    for (int i = 0; i < 30; ++i) {
      const Vec3 on_axis = reference::point_at(axis, static_cast<Real>(i) / 29);
      const Vec3 towards = reference::normalized_or_zero(reference::sample(field.node, on_axis).gradient);
      const Vec3 q = on_axis - within * (1 - 1e-12L) * towards;
      const Real blended = reference::value(field.node, q);
      surroundings_.check(blended > 0,
                          [&](std::ostream& out) { out << blended << " at " << within << " m"; });
    }
  }

  void conclude() const {
    too_large_.expect_none("never above the true least distance");
    touching_.expect_none("touching only where something is touched");
    answered_.expect_none("valid questions are answered");
    positive_.expect_none("clear exactly if positive");
    surroundings_.expect_none("nothing within the clearance");
  }

  Random random_;
  Failures too_large_, touching_, answered_, positive_, surroundings_;
  std::array<std::vector<Real>, efforts.size()> shortfalls_;
};

TEST(CapsuleClearance, IsNeverTooLargeInFixed27) {
  SweepTrial<Fixed<27>>(reference::announced_seed("IsNeverTooLargeInFixed27", 401)).random_fields();
}
TEST(CapsuleClearance, IsNeverTooLargeInFixed16) {
  SweepTrial<Fixed<16>>(reference::announced_seed("IsNeverTooLargeInFixed16", 402)).random_fields();
}
TEST(CapsuleClearance, IsNeverTooLargeInFloat) {
  SweepTrial<float>(reference::announced_seed("IsNeverTooLargeInFloat", 403)).random_fields();
}
TEST(CapsuleClearance, IsNeverTooLargeBesideTheTightestObstacleInFixed27) {
  SweepTrial<Fixed<27>>(reference::announced_seed("IsNeverTooLargeBesideTheTightestObstacleInFixed27", 404))
      .tightest_obstacle();
}
TEST(CapsuleClearance, IsNeverTooLargeBesideTheTightestObstacleInFixed16) {
  SweepTrial<Fixed<16>>(reference::announced_seed("IsNeverTooLargeBesideTheTightestObstacleInFixed16", 405))
      .tightest_obstacle();
}
TEST(CapsuleClearance, IsNeverTooLargeBesideTheTightestObstacleInFloat) {
  SweepTrial<float>(reference::announced_seed("IsNeverTooLargeBesideTheTightestObstacleInFloat", 406))
      .tightest_obstacle();
}

}  // namespace
}  // namespace nearfield::property
