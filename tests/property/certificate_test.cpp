/// Certificates of random fields, judged by the reference: error, Lipschitz constant, erosion, inflation, and
/// the clearances and directions that follow from them.

#include <nearfield/query/clearance.hpp>

#include "property/failures.hpp"
#include "property/random_field.hpp"

#include <cstdio>

namespace nearfield::property {
namespace {

using reference::Random;
using reference::Vec3;

constexpr int fields_per_scalar = 6000;
constexpr int points_per_field = 60;
constexpr int points_in_each_ball = 30;

// Fields by the least smooth of their blends. With H_1 the kernel has kinks that a table of cubics rounds
// off.
enum Smoothness : std::size_t {
  sharp,
  with_first_order,
  with_second_order,
  with_third_order,
  smoothness_count
};
constexpr std::array<const char*, smoothness_count> smoothness_names{"sharp", "H_1", "H_2", "H_3"};

template <class S>
Smoothness smoothness_of(const RandomField<S>& field) {
  if (field.lowest_order > 3) return sharp;
  return static_cast<Smoothness>(field.lowest_order);
}

// Of a direction's difference from the reference gradient. For blended fields it is the error of a table's
// slope.
template <class S>
constexpr Real direction_tolerance(Smoothness smoothness) {
  constexpr Real of_sharp = std::is_same_v<S, Fixed<27>> ? 1e-6L : std::is_same_v<S, float> ? 1e-5L : 4e-4L;
  constexpr std::array<Real, smoothness_count> tolerance{of_sharp, 0.2L, 0.01L, 5e-4L};
  return tolerance[smoothness];
}

template <class S>
class CertificateTrial {
 public:
  explicit CertificateTrial(std::uint64_t seed) : random_(seed) {}

  void run() {
    for (int i = 0; i < fields_per_scalar; ++i) {
      FieldTaste taste;
      taste.sharp_only = random_.chance(0.25L);
      taste.unions_only = random_.chance(0.25L);
      const Real reach = real(ScalarTraits<S>::domain());
      taste.size = reach * (random_.chance(0.5L) ? 0.25L : random_.uniform(0.01L, 0.9L));
      const RandomField<S> field = random_field<S>(random_, taste);
      ASSERT_TRUE(field.program.valid()) << static_cast<int>(field.program.status());
      for (int k = 0; k < points_per_field; ++k) judge(field, point(field, taste.size), taste.size);
    }
    conclude();
  }

 private:
  // Anywhere in the domain, around the shapes, or at the surface.
  Vector3<S> point(const RandomField<S>& field, Real size) {
    const Real reach = real(ScalarTraits<S>::domain());
    const Real around = random_.chance(0.3L) ? reach : std::min(reach, 1.5L * size);
    Vec3 p = random_.vector(-around, around);
    if (random_.chance(0.5L)) {
      for (int step = 0; step < 2; ++step) {
        const reference::FieldSample f = reference::sample(field.node, p);
        p = p - random_.uniform(0.9L, 1) * f.value * f.gradient;
      }
      if (random_.chance(0.5L)) {
        p = p - random_.uniform(0, 0.1L) * size * reference::sample(field.node, p).gradient;
      }
    }
    const S limit = ScalarTraits<S>::domain();
    const Vector3<S> q = rounded<S>(p);
    return {clamp(q.x, -limit, limit), clamp(q.y, -limit, limit), clamp(q.z, -limit, limit)};
  }

  void judge(const RandomField<S>& field, const Vector3<S>& p, Real size) {
    const Certificate<S>& certificate = field.program.certificate();
    const Vec3 at = real(p);
    const reference::FieldSample truth = reference::sample(field.node, at);
    const Real certified = real(certificate.error);

    const S value = field.program.template evaluate<Value<S>>(p, field.slots.data()).value;
    const Real error = std::fabs(real(value) - truth.value);
    error_.check(error <= certified, [&](std::ostream& out) {
      out << "error " << error << " certified " << certified << " true value " << truth.value;
    });
    Extremes& extremes = extremes_[smoothness_of(field)];
    ++extremes.triples;
    extremes.share = std::max(extremes.share, error / certified);
    extremes.error = std::max(extremes.error, error / last_place<S>(real(ScalarTraits<S>::domain())));

    judge_rate(field, at, truth.value, size);

    const Real sharp = reference::sharp_value(field.node, at);
    const Real slack = 1e-17L * (1 + size);
    erosion_.check(truth.value <= sharp + real(certificate.erosion) + slack, [&](std::ostream& out) {
      out << "blended " << truth.value << " sharp " << sharp << " erosion " << real(certificate.erosion);
    });
    inflation_.check(truth.value >= sharp - real(certificate.inflation) - slack, [&](std::ostream& out) {
      out << "blended " << truth.value << " sharp " << sharp << " inflation " << real(certificate.inflation);
    });
    judge_clearance(field, p, at, truth);
    ++triples_;
  }

  void judge_rate(const RandomField<S>& field, const Vec3& at, Real value, Real size) {
    const Real apart = random_.chance(0.3L) ? size : size * std::pow(Real{10}, random_.uniform(-9, -1));
    const Vec3 other = at + apart * random_.unit_vector();
    const Real other_value = reference::value(field.node, other);
    const Real between = reference::distance(at, other);
    const Real rate = (std::fabs(other_value - value) - 1e-17L * (1 + size)) / between;
    const Real allowed = real(field.program.certificate().lipschitz);
    rate_.check(rate <= allowed, [&](std::ostream& out) {
      out << "rate " << rate << " certified " << allowed << " over " << between << " m";
    });
    Extremes& extremes = extremes_[smoothness_of(field)];
    extremes.rate = std::max(extremes.rate, rate);
    extremes.rate_share = std::max(extremes.rate_share, rate / allowed);
  }

  void judge_clearance(const RandomField<S>& field, const Vector3<S>& p, const Vec3& at,
                       const reference::FieldSample& truth) {
    const Clearance<S> answer =
        clearance(field.program, p, field.slots.data(), static_cast<uint32_t>(field.slots.size()));
    answered_.check(answer.status != ClearanceStatus::invalid, [&](std::ostream& out) { out << at.x; });
    ++statuses_[static_cast<std::size_t>(answer.status)];
    clear_is_positive_.check((answer.status == ClearanceStatus::clear) == (answer.distance > S{}),
                             [&](std::ostream& out) { out << real(answer.distance); });
    if (answer.status == ClearanceStatus::touching) {
      touching_.check(truth.value <= 0, [&](std::ostream& out) { out << "true value " << truth.value; });
    }
    if (answer.status == ClearanceStatus::clear) judge_free_ball(field, at, real(answer.distance), truth);
    judge_direction(field, at, answer.direction, truth);
  }

  void judge_free_ball(const RandomField<S>& field, const Vec3& at, Real claimed,
                       const reference::FieldSample& truth) {
    if (field.unions_only) {
      const Real apart = reference::sharp_distance(field.node, at);
      distance_.check(claimed <= apart,
                      [&](std::ostream& out) { out << claimed << " claimed, " << apart << " true"; });
    }
    if (!random_.chance(0.06L)) return;
    ++balls_;
    for (int i = 0; i < points_in_each_ball; ++i) {
      const Real radius = claimed * (1 - 1e-12L) * (random_.chance(0.7L) ? Real{1} : random_.uniform());
      const Vec3 wander = random_.unit_vector();
      // A third of them straight towards what is nearest, more or less.
      const Vec3 ahead = reference::normalized_or_zero(random_.uniform(0, 0.5L) * wander - truth.gradient);
      const Vec3 q = at + radius * (i < points_in_each_ball / 3 ? ahead : wander);
      const Real blended = reference::value(field.node, q), sharp = reference::sharp_value(field.node, q);
      ball_.check(blended > 0 && sharp > 0, [&](std::ostream& out) {
        out << "claimed " << claimed << ", at " << radius << " blended " << blended << " sharp " << sharp;
      });
    }
  }

  // Where the reference gradient does not change within a few times the certified error.
  void judge_direction(const RandomField<S>& field, const Vec3& at, const Vector3<S>& direction,
                       const reference::FieldSample& truth) {
    if (!random_.chance(0.2L)) return;
    const Real around = 4 * real(field.program.certificate().error);
    const Smoothness smoothness = smoothness_of(field);
    const Real tolerance = direction_tolerance<S>(smoothness);
    for (const Vec3& axis : {Vec3{1, 0, 0}, Vec3{0, 1, 0}, Vec3{0, 0, 1}}) {
      for (const Real step : {-around, around}) {
        const Vec3 nearby = reference::sample(field.node, at + step * axis).gradient;
        if (reference::distance(nearby, truth.gradient) > tolerance / 4) return;
      }
    }
    ++extremes_[smoothness].directions;
    const Real off = reference::distance(real(direction), truth.gradient);
    direction_.check(off <= tolerance, [&](std::ostream& out) {
      out << "off by " << off << " (" << smoothness_names[smoothness] << ") value " << truth.value;
    });
    extremes_[smoothness].direction = std::max(extremes_[smoothness].direction, off);
  }

  void conclude() const {
    error_.expect_none("|evaluated - f(p)| <= error");
    rate_.expect_none("|f(p) - f(q)| <= lipschitz |p - q|");
    erosion_.expect_none("blended <= sharp + erosion");
    inflation_.expect_none("blended >= sharp - inflation");
    answered_.expect_none("valid questions are answered");
    clear_is_positive_.expect_none("clear exactly if positive");
    touching_.expect_none("touching only where the value is not positive");
    distance_.expect_none("never farther than the sharp solids");
    ball_.expect_none("the ball of a clearance is free");
    direction_.expect_none("direction");
    EXPECT_GT(statuses_[static_cast<std::size_t>(ClearanceStatus::clear)], triples_ / 10);
    EXPECT_GT(statuses_[static_cast<std::size_t>(ClearanceStatus::touching)], triples_ / 20);
    std::printf("%s: %lld triples; %lld clear, %lld touching, %lld undecided; %lld balls\n",
                ScalarName<S>::text().c_str(), triples_, statuses_[3], statuses_[1], statuses_[2], balls_);
    for (std::size_t i = 0; i < smoothness_count; ++i) {
      const Extremes& e = extremes_[i];
      EXPECT_GT(e.directions, e.triples / 100);
      std::printf(
          "  %-5s %7lld triples: greatest error %.3Lf of the certified, %.1Lf units in the last place%s; "
          "greatest rate %.6Lf, %.6Lf of the certified; %lld directions off by at most %.1Le\n",
          smoothness_names[i], e.triples, e.share, e.error, ScalarTraits<S>::is_fixed ? "" : " of 16", e.rate,
          e.rate_share, e.directions, e.direction);
    }
  }

  struct Extremes {
    Real share = 0, error = 0, rate = 0, rate_share = 0, direction = 0;
    long long triples = 0, directions = 0;
  };

  Random random_;
  Failures error_, rate_, erosion_, inflation_, answered_, clear_is_positive_, touching_, distance_, ball_,
      direction_;
  std::array<Extremes, smoothness_count> extremes_{};
  std::array<long long, 4> statuses_{};
  long long triples_ = 0, balls_ = 0;
};

TEST(Certificate, HoldsForRandomFieldsInFixed27) {
  CertificateTrial<Fixed<27>>(reference::announced_seed("HoldsForRandomFieldsInFixed27", 101)).run();
}
TEST(Certificate, HoldsForRandomFieldsInFixed16) {
  CertificateTrial<Fixed<16>>(reference::announced_seed("HoldsForRandomFieldsInFixed16", 102)).run();
}
TEST(Certificate, HoldsForRandomFieldsInFloat) {
  CertificateTrial<float>(reference::announced_seed("HoldsForRandomFieldsInFloat", 103)).run();
}

// The farthest that a point and a frame's origin can be apart, and poses handed in at run time that are as
// far from a rotation as valid_pose() lets pass: stretched by 31 units and sheared by 15, where 32 are
// allowed in lengths and products of rows.
template <class S>
void judge_far_frames(std::uint64_t seed) {
  Random random(seed);
  const Real reach = real(ScalarTraits<S>::domain());
  const Real unit = ScalarTraits<S>::is_fixed ? std::ldexp(Real{1}, -30) : std::ldexp(Real{1}, -19) / 33;
  std::array<Real, 2> greatest{}, certified{};
  Failures error;
  std::array<long long, 2> trials{};
  for (int i = 0; i < 60000; ++i) {
    const std::size_t in_slot = random.chance(0.5L) ? 1 : 0;
    const Vec3 corner{random.chance(0.5L) ? reach : -reach, random.chance(0.5L) ? reach : -reach, reach};
    const reference::Pose pose{random.rotation(), -random.uniform(0.97L, 0.999L) * corner};
    Pose<S> rounded_one = rounded_pose<S>(pose);
    const Vector3<S> p = rounded<S>(random.uniform(0.97L, 0.999L) * corner);
    if (in_slot == 1) {
      // Along the direction in which the point is seen.
      const std::array<Real, 3> sign{std::copysign(Real{1}, corner.x), std::copysign(Real{1}, corner.y), 1};
      const Real way = random.chance(0.5L) ? 1 : -1;
      reference::Mat3 stretch;
      for (std::size_t row = 0; row < 3; ++row) {
        for (std::size_t column = 0; column < 3; ++column) {
          stretch(row, column) += way * sign[row] * sign[column] * unit * (row == column ? 30 : 14);
        }
      }
      rounded_one.rotation = rounded_rotation<S>(stretch * pose.rotation);
      if (!valid_pose(rounded_one)) continue;
    }
    const Vec3 center = random.vector(-0.01L, 0.01L) * reach;
    RandomField<S> field;
    if (in_slot == 1)
      field.image->enter_slot(0);
    else
      field.image->enter(rounded_one);
    field.image->operation(Sphere<S>{rounded<S>(center), rounded<S>(0.01L * reach)}).leave();
    ASSERT_EQ(field.image->finish().status, LoadStatus::ok);
    field.program = load<S>(field.image->words(), field.image->size() * sizeof(uint32_t));
    const Real truth =
        reference::value(reference::placed(pose, reference::sphere(center, 0.01L * reach)), real(p));
    const Real off =
        std::fabs(real(field.program.template evaluate<Value<S>>(p, &rounded_one).value) - truth);
    certified[in_slot] = real(field.program.certificate().error);
    greatest[in_slot] = std::max(greatest[in_slot], off);
    ++trials[in_slot];
    error.check(off <= certified[in_slot], [&](std::ostream& out) {
      out << (in_slot == 1 ? "slot: " : "frame: ") << off << " certified " << certified[in_slot];
    });
  }
  error.expect_none(ScalarName<S>::text() + ": far frames");
  EXPECT_GT(trials[0], 10000);
  EXPECT_GT(trials[1], 1000);
  std::printf(
      "%s: %lld fixed frames, greatest error %.3Lf of the certified; %lld slots, %.3Lf of the certified\n",
      ScalarName<S>::text().c_str(), trials[0], greatest[0] / certified[0], trials[1],
      greatest[1] / certified[1]);
}

TEST(Certificate, HoldsForTheFarthestFrames) {
  const std::uint64_t seed = reference::announced_seed("HoldsForTheFarthestFrames", 104);
  judge_far_frames<Fixed<27>>(seed);
  judge_far_frames<Fixed<16>>(seed);
  judge_far_frames<float>(seed);
}

}  // namespace
}  // namespace nearfield::property
