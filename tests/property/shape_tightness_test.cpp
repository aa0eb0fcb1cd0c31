/// Where the exact solids are hardest to evaluate: far beyond the ends of long capsules, and where there is no direction.
/// Fixed<27>.

#include <nearfield/shape/box.hpp>
#include <nearfield/shape/cylinder.hpp>
#include <nearfield/shape/sphere.hpp>

#include "property/conversion.hpp"
#include "property/failures.hpp"
#include "reference/field.hpp"
#include "reference/random.hpp"

#include <algorithm>
#include <cstdio>
#include <vector>

namespace nearfield::property {
namespace {

using reference::Random;
using reference::Vec3;
using S = Fixed<27>;

constexpr Real unit = 1.0L / 134217728;

Vector3<S> clamped_to_domain(const Vec3& p) {
  const S limit = ScalarTraits<S>::domain();
  const Vector3<S> q = rounded<S>(p);
  return {clamp(q.x, -limit, limit), clamp(q.y, -limit, limit), clamp(q.z, -limit, limit)};
}

// The longest capsules that a field takes, seen from beyond their ends: the axis's rounding counts most.
TEST(ShapeTightness, LongCapsulesStayWithinTheirCertificate) {
  Random random(reference::announced_seed("LongCapsulesStayWithinTheirCertificate", 202));
  Failures error;
  Real greatest = 0;
  for (int i = 0; i < 200000; ++i) {
    Vec3 a = random.vector(-0.6L, 0.1L), b = random.vector(3, 3.9L);
    if (random.chance(0.5L)) {
      a = random.vector(-0.01L, 0.01L);
      b = random.vector(-0.01L, 0.01L) + Vec3{3.98L, 0, 0};
    }
    const Real radius = random.uniform(0.001L, 0.2L);
    const Capsule<S> capsule(rounded<S>(a), rounded<S>(b), rounded<S>(radius));
    const Certificate<S> certificate = capsule.certificate(domain_reach<S>());
    if (!certificate.valid) continue;
    for (int k = 0; k < 4; ++k) {
      const Vec3 beyond = random.uniform(0, 0.1L) * reference::normalized_or_zero(b - a);
      const Vector3<S> p = clamped_to_domain(b + beyond + random.vector(-0.01L, 0.01L));
      const Real truth = reference::value(reference::capsule(a, b, radius), real(p));
      const Real off = std::fabs(real(capsule.evaluate<Value<S>>(p).value) - truth);
      greatest = std::max(greatest, off);
      error.check(off <= real(certificate.error), [&](std::ostream& out) {
        out << off / unit << " units, certified " << real(certificate.error) / unit << ", length "
            << reference::distance(a, b);
      });
    }
  }
  std::printf("long capsules: %.2Lf units in the last place\n", greatest / unit);
  error.expect_none("observed within certified");
}

template <class Shape>
void judge_place(const char* name, const Shape& shape, const Vec3& place) {
  const Sample<S> sample = shape.template evaluate<Sample<S>>(rounded<S>(place));
  const Real length = reference::norm(real(sample.gradient));
  EXPECT_TRUE(is_zero(sample.gradient) || std::fabs(length - 1) <= 4 * unit)
      << name << " at " << static_cast<double>(place.x) << " " << static_cast<double>(place.y) << " "
      << static_cast<double>(place.z) << ": |direction| - 1 is " << static_cast<double>((length - 1) / unit)
      << " units";
  EXPECT_EQ(sample.value, shape.template evaluate<Value<S>>(rounded<S>(place)).value) << name;
}

// All combinations of the given offsets from a point, each also a unit in the last place to either side.
std::vector<Vec3> places_around(const Vec3& center, const std::vector<Real>& offsets) {
  std::vector<Real> all;
  for (const Real offset : offsets) {
    for (const Real sign : {-1.0L, 1.0L}) {
      for (const Real nudge : {-unit, Real{0}, unit}) all.push_back(sign * offset + nudge);
    }
  }
  std::vector<Vec3> places;
  for (const Real x : all) {
    for (const Real y : all) {
      for (const Real z : all) places.push_back(center + Vec3{x, y, z});
    }
  }
  return places;
}

TEST(ShapeTightness, DegeneratePlacesAreDefined) {
  const Vec3 center{0.25L, -0.5L, 1};
  const Vector3<S> c = rounded<S>(center);
  for (const Vec3& place : places_around(center, {0, 0.25L, 0.5L, 1})) {
    judge_place("sphere", Sphere<S>{c, S(0.5)}, place);
    judge_place("box", Box<S>{c, {S(0.25), S(0.5), S(1.0)}}, place);
    judge_place("cube", Box<S>{c, {S(0.5), S(0.5), S(0.5)}}, place);
    judge_place("cylinder", Cylinder<S>{c, S(0.5), S(0.25)}, place);
    judge_place("capsule", Capsule<S>(c, c + Vector3<S>{S(1.0), S{}, S{}}, S(0.25)), place);
    judge_place("slanted capsule", Capsule<S>(c, c + Vector3<S>{S(0.5), S(0.25), S(-0.25)}, S(0.25)), place);
    judge_place("shortest capsule", Capsule<S>(c, c + Vector3<S>{S{}, S::unit_in_last_place(), S{}}, S(0.25)),
                place);
    judge_place("ball as capsule", Capsule<S>(c, c, S(0.25)), place);
    judge_place("bare point", Capsule<S>(c, c, S{}), place);
  }
  // No direction is favoured at these places.
  EXPECT_TRUE(is_zero((Sphere<S>{c, S(0.5)}.evaluate<Sample<S>>(c).gradient)));
  EXPECT_TRUE(is_zero((Capsule<S>(c, c, S(0.5)).evaluate<Sample<S>>(c).gradient)));
  EXPECT_EQ((Sphere<S>{c, S(0.5)}.evaluate<Sample<S>>(c).value), S(-0.5));
  EXPECT_EQ((Capsule<S>(c, c, S(0.5)).evaluate<Sample<S>>(c).value), S(-0.5));
  EXPECT_TRUE((Capsule<S>(c, c, S(0.5)).certificate(domain_reach<S>()).valid));
}

}  // namespace
}  // namespace nearfield::property
