/// Clearances to soft surfaces in random scenes, judged by dense search: never above the true distance, and
/// not far below it.

#include <nearfield/curve/curves.hpp>
#include <nearfield/curve/tabulated_form.hpp>
#include <nearfield/field/builder.hpp>
#include <nearfield/query/soft_clearance.hpp>

#include "property/conversion.hpp"
#include "property/failures.hpp"
#include "reference/random.hpp"
#include "reference/soft_clearance.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <memory>
#include <vector>

namespace nearfield::property {
namespace {

using reference::Random;
using reference::SoftBall;
using reference::Vec3;

constexpr int scene_count = 10000;
constexpr reference::SearchDensity density{};

enum class PotentialName : std::size_t { wyvill, cubic, bezier, arctangent, count };
constexpr std::array<const char*, 4> potential_names{"wyvill", "cubic", "bezier, degree 5",
                                                     "arctangent_clamped, c1 = 20"};
constexpr double steepness = 20;

/// The potentials in double, with slopes; 1 and 0 outside of [0, 1].
struct FastPotential {
  struct Point {
    double value, first;
  };
  PotentialName name;

  Point operator()(double r) const {
    if (r >= 1) return {0, 0};
    const double u = r * r;
    switch (name) {
      case PotentialName::wyvill:
        return {1 + u * (-22 + u * (17 - 4 * u)) / 9, r * (-44 + u * (68 - 24 * u)) / 9};
      case PotentialName::cubic:
        return {1 + u * (2 * r - 3), 6 * r * (r - 1)};
      case PotentialName::bezier:
        return {1 - u * r * (10 - 15 * r + 6 * u), -30 * u * (1 - r) * (1 - r)};
      default: {
        const double x = steepness * (r - 0.5), span = 2 * std::atan(steepness / 2);
        return {0.5 - std::atan(x) / span, -steepness / ((1 + x * x) * span)};
      }
    }
  }
};

/// A part of a scene as it is stored: a ball, or a segment if the ends differ.
struct Part {
  reference::Segment segment;
  double radius = 1;
  double weight = 1;
};

enum class Frame { none, pose, slot };

template <class S>
struct Scene {
  ImageBuilder<S, 2000> builder;
  Program<S> program;
  PotentialName potential = PotentialName::wyvill;
  std::vector<Part> parts;
  Frame frame = Frame::none;
  Pose<S> pose;
  bool has_segments = false;

  /// As the parts see it.
  Vec3 inner(const Vector3<S>& p) const {
    const Vec3 moved = real(p) - real(pose.translation);
    return {reference::dot(real(pose.rotation.column(0)), moved),
            reference::dot(real(pose.rotation.column(1)), moved),
            reference::dot(real(pose.rotation.column(2)), moved)};
  }
  bool all_positive = true;
};

/// Wyvill's over the squared distance, the others over the distance.
Differentiable tabulated(PotentialName name, const Differentiable& u) {
  switch (name) {
    case PotentialName::wyvill:
      return over_square(potential::wyvill)(u);
    case PotentialName::cubic:
      return potential::Cubic{}(u);
    case PotentialName::bezier: {
      potential::Bezier bezier;
      bezier.degree = 5;
      for (int i = 0; i < 3; ++i) bezier.b[i] = 1;
      return bezier(u);
    }
    default:
      return potential::ArctangentClamped{steepness, 0.5}(u);
  }
}
template <class S>
const Table<S, 64>& table_of(PotentialName name) {
  static const std::array<Table<S, 64>, 4> tables = [] {
    std::array<Table<S, 64>, 4> baked;
    for (std::size_t i = 0; i < baked.size(); ++i) {
      baked[i] =
          bake<S, 64>([i](const Differentiable& u) { return tabulated(static_cast<PotentialName>(i), u); });
    }
    return baked;
  }();
  return tables[static_cast<std::size_t>(name)];
}

template <class S>
std::unique_ptr<Scene<S>> random_scene(Random& random) {
  auto scene = std::make_unique<Scene<S>>();
  scene->potential = static_cast<PotentialName>(random.integer(0, 3));
  scene->has_segments = random.chance(0.25L);
  const bool over_r = scene->potential != PotentialName::wyvill;
  const bool may_be_negative = random.chance(0.4L);
  const uint32_t table = scene->builder.table(table_of<S>(scene->potential));
  if (random.chance(0.3L)) {
    scene->pose = rounded_pose<S>({random.rotation(), random.vector(-0.5L, 0.5L)});
    scene->frame = random.chance(0.5L) ? Frame::slot : Frame::pose;
  }
  if (scene->frame == Frame::pose) scene->builder.enter(scene->pose);
  if (scene->frame == Frame::slot) scene->builder.enter_slot(0);
  const int count = static_cast<int>(random.integer(2, 4));
  const S domain = ScalarTraits<S>::domain();
  for (int i = 0; i < count; ++i) {
    // In a slot there is less room: the frame may be anywhere in the domain.
    const Real spread = scene->frame == Frame::slot ? 0.4L : 0.5L;
    const Vector3<S> a = rounded<S>(random.vector(-spread, spread));
    const bool is_segment = scene->has_segments && random.chance(0.6L);
    const Capsule<S> skeleton(a, is_segment ? rounded<S>(random.vector(-spread, spread)) : a, S{});
    const bool negative = i > 0 && may_be_negative && random.chance(0.5L);
    const S radius = rounded<S>(random.uniform(0.2L, 1));
    const S weight = rounded<S>(negative ? random.uniform(-1, -0.1L) : random.uniform(0.6L, 1.6L));
    scene->all_positive = scene->all_positive && !negative;
    scene->parts.push_back(
        {stored_segment(skeleton), static_cast<double>(real(radius)), static_cast<double>(real(weight))});
    if (over_r) {
      // The frame is not farther than the end of the domain.
      const Certificate<S> bare =
          skeleton.certificate(inner_reach(domain_reach<S>(), Vector3<S>{domain, domain, domain}));
      scene->builder.operation(skeleton).operation(PotentialOfDistance<S>(radius, weight, bare), table);
    } else if (is_segment) {
      scene->builder.operation(SoftSegment<S>{skeleton, Influence<S>(radius, weight)}, table);
    } else {
      scene->builder.operation(SoftPoint<S>{a, Influence<S>(radius, weight)}, table);
    }
    if (i > 0) scene->builder.operation(SoftSum<S>{});
  }
  if (scene->frame != Frame::none) scene->builder.leave();
  scene->builder.finish();
  scene->program = load<S>(scene->builder.words(), scene->builder.size() * sizeof(uint32_t));
  return scene;
}

std::array<double, 3> coordinates(const Vec3& p) {
  return {static_cast<double>(p.x), static_cast<double>(p.y), static_cast<double>(p.z)};
}

/// Distance to the first surface along the best of many rays: what a scene with segments is judged by.
class RaySearch {
 public:
  RaySearch(const std::vector<Part>& parts, FastPotential potential) : parts_(parts), potential_(potential) {}

  double intensity(const Vec3& p) const {
    double sum = 0;
    for (const Part& part : parts_) {
      const Vec3 along = part.segment.b - part.segment.a, from = p - part.segment.a;
      const Real squared = reference::dot(along, along);
      const Real place =
          squared > 0 ? std::clamp(reference::dot(from, along) / squared, Real{0}, Real{1}) : 0;
      const double r = static_cast<double>(reference::norm(from - place * along));
      sum += part.weight * potential_(r / part.radius).value;
    }
    return sum;
  }
  double nearest(const Vec3& p, Random& random) const {
    double best = 4;
    for (const Part& part : parts_) {
      for (const Real place : {0.0L, 0.25L, 0.5L, 0.75L, 1.0L}) {
        const Vec3 target = part.segment.a + place * (part.segment.b - part.segment.a);
        for (int i = 0; i < 4; ++i) {
          cast(p, target + static_cast<Real>(0.1 * i * part.radius) * random.unit_vector(), best);
        }
      }
    }
    return best;
  }

 private:
  void cast(const Vec3& p, const Vec3& target, double& best) const {
    const Vec3 direction = reference::normalized_or_zero(target - p);
    const double step = best / 24;
    for (int i = 1; i <= 24; ++i) {
      double inside = i * step, outside = inside - step;
      if (intensity(p + static_cast<Real>(inside) * direction) < 0.5) continue;
      for (int k = 0; k < 24; ++k) {
        const double middle = (inside + outside) / 2;
        (intensity(p + static_cast<Real>(middle) * direction) >= 0.5 ? inside : outside) = middle;
      }
      best = inside;
      return;
    }
  }

  const std::vector<Part>& parts_;
  FastPotential potential_;
};

class SoftTrial {
 public:
  explicit SoftTrial(std::uint64_t seed) : random_(seed) {}

  void run() {
    for (int i = 0; i < scene_count; ++i) {
      if (i % 10 < 8)
        judge<Fixed<27>>();
      else if (i % 10 == 8)
        judge<Fixed<16>>();
      else
        judge<float>();
    }
    conclude();
  }

 private:
  template <class S>
  void judge() {
    const std::unique_ptr<Scene<S>> scene = random_scene<S>(random_);
    loaded_.check(scene->program.valid(), [&](std::ostream& out) {
      out << ScalarName<S>::text() << ", " << potential_names[static_cast<std::size_t>(scene->potential)]
          << ": status " << static_cast<int>(scene->program.status()) << ", frame "
          << static_cast<int>(scene->frame);
    });
    if (!scene->program.valid()) return;
    const FastPotential potential{scene->potential};
    const RaySearch rays(scene->parts, potential);
    Vector3<S> p;
    do {
      p = rounded<S>(random_.vector(-1.2L, 1.2L));
    } while (rays.intensity(scene->inner(p)) >= 0.4999);
    const Clearance<S> found = soft_clearance(scene->program, p, &scene->pose, 1);
    const Vec3 place = scene->inner(p);
    const double claimed = static_cast<double>(real(found.distance));
    const auto where = [&](std::ostream& out) {
      out << ScalarName<S>::text() << ", " << potential_names[static_cast<std::size_t>(scene->potential)]
          << ", claimed " << claimed << ", intensity " << rays.intensity(place);
    };
    answered_.check(found.status == ClearanceStatus::clear || found.status == ClearanceStatus::undecided,
                    where);
    ++(found.status == ClearanceStatus::clear ? clear_ : undecided_);
    double truth = 0;
    if (scene->has_segments) {
      truth = rays.nearest(place, random_);
    } else {
      std::vector<SoftBall> balls;
      for (const Part& part : scene->parts)
        balls.push_back({coordinates(part.segment.a), part.radius, part.weight});
      truth = reference::soft_clearance(balls, potential, coordinates(place), density);
    }
    // The search itself is good to 1e-9.
    never_above_.check(claimed <= truth + 1e-9, [&](std::ostream& out) {
      where(out);
      out << ", found at " << truth;
    });
    if (!std::isfinite(truth) || scene->has_segments) return;
    const double ratio = claimed / truth;
    greatest_ = std::max(greatest_, ratio);
    auto& ratios = scene->all_positive ? positive_ : mixed_;
    ratios[static_cast<std::size_t>(scene->potential)].push_back(ratio);
  }

  static double median(std::vector<double> values) {
    if (values.empty()) return 0;
    const auto middle = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
    std::nth_element(values.begin(), middle, values.end());
    return *middle;
  }

  void conclude() const {
    loaded_.expect_none("scenes are valid");
    answered_.expect_none("points outside are clear or undecided");
    never_above_.expect_none("never above the true distance");
    EXPECT_GT(clear_, scene_count * 9 / 10);
    std::vector<double> all;
    for (std::size_t i = 0; i < potential_names.size(); ++i) {
      all.insert(all.end(), positive_[i].begin(), positive_[i].end());
      std::printf("  %-28s median ratio %.4f of %zu scenes of positive weights, %.4f of %zu of both signs\n",
                  potential_names[i], median(positive_[i]), positive_[i].size(), median(mixed_[i]),
                  mixed_[i].size());
      EXPECT_GT(positive_[i].size(), 500U);
      EXPECT_GT(mixed_[i].size(), 200U);
    }
    std::printf("  %d clear, %d undecided; positive weights: median ratio %.4f; greatest ratio of all %.9f\n",
                clear_, undecided_, median(all), greatest_);
    EXPECT_GE(median(all), 0.95);
    EXPECT_GT(greatest_, 0.99);
  }

  Random random_;
  Failures loaded_, answered_, never_above_;
  std::array<std::vector<double>, 4> positive_{}, mixed_{};
  double greatest_ = 0;
  int clear_ = 0, undecided_ = 0;
};

TEST(SoftClearance, IsNeverAboveTheTrueDistance) {
  SoftTrial(reference::announced_seed("IsNeverAboveTheTrueDistance", 531)).run();
}

}  // namespace
}  // namespace nearfield::property
