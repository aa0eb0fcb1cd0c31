/// Separation of two capsules, judged by the exact distance of their segments: never too large, and how much
/// too small.

#include <nearfield/query/capsule_pair.hpp>

#include "property/conversion.hpp"
#include "property/failures.hpp"
#include "reference/random.hpp"
#include "reference/segments.hpp"

#include <algorithm>
#include <cstdio>
#include <string>
#include <vector>

namespace nearfield::property {
namespace {

using reference::Random;
using reference::Vec3;

struct CapsuleEnds {
  Vec3 a, b;
  Real radius;
};
struct CapsulePair {
  CapsuleEnds first, second;
};

Vec3 perpendicular(Random& random, const Vec3& direction) {
  return reference::normalized_or_zero(reference::cross(direction, random.unit_vector()));
}

// Segments whose lines make `angle`, and pass each other at `apart`; the nearest points of the lines may lie
// outside.
CapsulePair skew_pair(Random& random, Real size, Real angle, Real apart) {
  const Vec3 u = random.unit_vector(), n = perpendicular(random, u);
  const Vec3 v = std::cos(angle) * u + std::sin(angle) * reference::cross(n, u);
  const Vec3 on_first = random.vector(-size, size) * 0.3L, on_second = on_first + apart * n;
  const auto part = [&] { return size * random.uniform(-0.4L, 0.4L); };
  return {{on_first + part() * u, on_first + part() * u, 0},
          {on_second + part() * v, on_second + part() * v, 0}};
}

struct Case {
  const char* name;
  CapsulePair (*draw)(Random&, Real size);
};

const std::vector<Case>& cases() {
  static const std::vector<Case> all = {
      {"random",
       [](Random& random, Real size) {
         return CapsulePair{
             {random.vector(-size, size), random.vector(-size, size), size * random.uniform(0, 0.1L)},
             {random.vector(-size, size), random.vector(-size, size), size * random.uniform(0, 0.1L)}};
       }},
      {"far apart",
       [](Random& random, Real size) {
         const Vec3 corner{size * 0.7L, size * 0.7L, size * 0.7L};
         return CapsulePair{
             {corner + random.vector(0, 0.3L) * size, corner + random.vector(-0.3L, 0.3L) * size, 0},
             {-corner - random.vector(0, 0.3L) * size, -corner - random.vector(-0.3L, 0.3L) * size, 0}};
       }},
      {"limbs",  // like those of an arm and a person: as far apart as they are thick, or farther
       [](Random& random, Real size) {
         CapsulePair pair = skew_pair(random, size * 0.25L, random.uniform(0.01L, reference::pi / 2),
                                      size * random.uniform(0.025L, 0.5L));
         pair.first.radius = pair.second.radius = size * 0.012L;
         return pair;
       }},
      {"parallel", [](Random& random,
                      Real size) { return skew_pair(random, size, 0, size * random.uniform(0.001L, 0.5L)); }},
      {"nearly parallel",
       [](Random& random, Real size) {
         const Real angle = std::pow(Real{10}, random.uniform(-9, -2));
         return skew_pair(random, size, angle, size * std::pow(Real{10}, random.uniform(-4, 0)));
       }},
      {"close by",
       [](Random& random, Real size) {
         return skew_pair(random, size, random.uniform(0.001L, reference::pi / 2),
                          size * std::pow(Real{10}, random.uniform(-7, -2)));
       }},
      {"crossing",
       [](Random& random, Real size) { return skew_pair(random, size, random.uniform(0.001L, 1.5L), 0); }},
      {"collinear",
       [](Random& random, Real size) {
         const Vec3 start = random.vector(-size, size) * 0.3L, u = random.unit_vector() * size * 0.3L;
         return CapsulePair{{start, start + random.uniform(0, 1) * u, 0},
                            {start + random.uniform(-1, 2) * u, start + random.uniform(-1, 2) * u, 0}};
       }},
      {"touching",
       [](Random& random, Real size) {
         CapsulePair pair =
             skew_pair(random, size, random.uniform(0.01L, 1.5L), size * random.uniform(0.01L, 0.2L));
         const Real apart = reference::segment_segment_distance({pair.first.a, pair.first.b},
                                                                {pair.second.a, pair.second.b});
         pair.first.radius = apart * random.uniform(0.2L, 0.8L);
         pair.second.radius = apart - pair.first.radius;
         return pair;
       }},
      {"zero length",
       [](Random& random, Real size) {
         const Vec3 p = random.vector(-size, size), q = random.vector(-size, size);
         return CapsulePair{{p, p, 0},
                            {q, random.chance(0.5L) ? q : random.vector(-size, size), size * 0.01L}};
       }},
      {"short",
       [](Random& random, Real size) {
         const Vec3 p = random.vector(-size, size) * 0.9L;
         const Vec3 q = p + random.unit_vector() * size * std::pow(Real{10}, random.uniform(-6, -1));
         return CapsulePair{{p, p + random.vector(-size, size) * 1e-6L, 0},
                            {q, q + random.vector(-size, size) * 1e-3L, 0}};
       }},
  };
  return all;
}

struct Shortfalls {
  std::vector<Real> all;
  void print(const std::string& title, Real unit) {
    if (all.empty()) return;
    std::sort(all.begin(), all.end());
    std::printf("  %-34s %6zu pairs: shortfall median %.2Lf, 99 %% %.2Lf, greatest %.1Lf rounding units\n",
                title.c_str(), all.size(), all[all.size() / 2] / unit, all[all.size() * 99 / 100] / unit,
                all.back() / unit);
  }
};

template <class S>
class PairTrial {
 public:
  explicit PairTrial(std::uint64_t seed) : random_(seed) {}

  void run() {
    std::printf("%s, rounding unit %.3Le m\n", ScalarName<S>::text().c_str(), unit_);
    for (const Case& one : cases()) {
      shortfalls_ = {};
      for (int i = 0; i < 20000; ++i) {
        const Real size = real(ScalarTraits<S>::domain()) * (random_.chance(0.5L) ? 1 : 0.25L);
        judge(one, one.draw(random_, size));
      }
      shortfalls_.print(one.name, unit_);
    }
    comfortable_.print("angle > 2^-12, apart > length / 4", unit_);
    crossing_.print("angle > 2^-12, apart < length / 4", unit_);
    EXPECT_GT(comfortable_.all.size(), 20000U);
    too_large_.expect_none("never above the true distance");
    too_small_.expect_none("shortfall of segments at an angle");
    direction_.expect_none("direction of length 1 or 0");
  }

 private:
  Capsule<S> capsule(const CapsuleEnds& ends) const {
    const S limit = ScalarTraits<S>::domain();
    const auto inside = [limit](const Vec3& p) {
      const Vector3<S> q = rounded<S>(p);
      return Vector3<S>{clamp(q.x, -limit, limit), clamp(q.y, -limit, limit), clamp(q.z, -limit, limit)};
    };
    return Capsule<S>(inside(ends.a), inside(ends.b), rounded<S>(ends.radius));
  }

  void judge(const Case& one, const CapsulePair& pair) {
    const Capsule<S> first = capsule(pair.first), second = capsule(pair.second);
    const reference::Segment a = stored_segment(first), b = stored_segment(second);
    const Real apart = reference::segment_segment_distance(a, b);
    const Real truth = apart - real(first.radius) - real(second.radius);
    const SeparatedBy<S> answer = separation(first, second);
    const Real shortfall = truth - real(answer.distance);
    too_large_.check(shortfall >= -1e-16L * (1 + apart), [&](std::ostream& out) {
      out << one.name << ": " << -shortfall / unit_ << " rounding units above " << truth << ", segments "
          << apart << " apart";
    });
    shortfalls_.all.push_back(shortfall);

    const Real length = reference::norm(real(answer.direction));
    direction_.check(length == 0 || std::fabs(length - 1) <= 4 * last_place<S>(1),
                     [&](std::ostream& out) { out << one.name << ": length " << length; });

    // Rounding turns the separating direction by about two units over the distance; each segment's support
    // feels it.
    const Vec3 u = a.b - a.a, v = b.b - b.a;
    const Real lengths = reference::norm(u) + reference::norm(v);
    const Real product = reference::norm(u) * reference::norm(v);
    if (product > 0 && reference::norm(reference::cross(u, v)) <= product / 4096) return;
    if (!(apart > 0)) return;
    const Real allowed = std::min(apart + unit_, unit_ * (14 + 4 * lengths / apart));
    too_small_.check(shortfall <= allowed + 1e-16L * (1 + apart), [&](std::ostream& out) {
      out << one.name << ": " << shortfall / unit_ << " rounding units, allowed " << allowed / unit_ << ", "
          << apart << " apart, lengths " << lengths;
    });
    (apart * 4 > lengths ? comfortable_ : crossing_).all.push_back(shortfall);
  }

  Random random_;
  const Real unit_ = real(ScalarTraits<S>::rounding_unit(ScalarTraits<S>::domain()));
  Failures too_large_, too_small_, direction_;
  Shortfalls shortfalls_, comfortable_, crossing_;
};

TEST(CapsulePair, SeparationIsNeverTooLargeInFixed27) {
  PairTrial<Fixed<27>>(reference::announced_seed("SeparationIsNeverTooLargeInFixed27", 301)).run();
}
TEST(CapsulePair, SeparationIsNeverTooLargeInFixed16) {
  PairTrial<Fixed<16>>(reference::announced_seed("SeparationIsNeverTooLargeInFixed16", 302)).run();
}
TEST(CapsulePair, SeparationIsNeverTooLargeInFloat) {
  PairTrial<float>(reference::announced_seed("SeparationIsNeverTooLargeInFloat", 303)).run();
}

}  // namespace
}  // namespace nearfield::property
