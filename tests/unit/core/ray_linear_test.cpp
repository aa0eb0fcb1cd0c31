// Ray-linear blends against the papers' formulas in long double, and what their certificates promise.
#include <golden/node_writer.hpp>
#include <nearfield/blend/ray_linear.hpp>
#include <nearfield/curve/ray_kernel.hpp>
#include <nearfield/field/program.hpp>
#include <property/conversion.hpp>
#include <reference/random.hpp>
#include <reference/ray_linear_blends.hpp>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <cstdio>
#include <functional>
#include <string>
#include <vector>

namespace {

using namespace nearfield;
using property::real;
using reference::announced_seed;
using reference::BinaryBlend;
using reference::BlendPoint;
using reference::Random;
using reference::Real;
using reference::ScaleRanges;

template <class S>
S scalar(Real x) {
  return property::rounded<S>(x);
}
template <class S>
constexpr Real last_place() {
  return ScalarTraits<S>::is_fixed
             ? 1.0L / (int64_t{1} << (ScalarTraits<S>::is_fixed ? fraction_bits_of<S> : 0))
             : 0.0L;
}

// A blend as numbers: what is evaluated, what it should be, and how far its table's facts let them differ.
struct Subject {
  std::string name;
  std::function<BlendPoint(Real, Real)> evaluated;  // of operands that the scalar holds exactly
  BinaryBlend exact;
  std::function<Real(Real)> rounded;  // to the scalar
  Real value_error = 0;               // of the table and its argument, relative to the deciding operand
  Real slope_error = 0;               // the same of a partial derivative
  Real last_place = 0;                // of the scalar; 0 for float
  Real spread = 0;                    // certified |dB/dx| + |dB/dy|
  Real certified_error = 0;
  Real edges[2] = {0, 0};  // ratios lesser / greater where the blend ends; 0 where it does not

  Real value_tolerance(Real deciding) const {
    return deciding * (value_error + (last_place > 0 ? 0 : 3e-7L)) + 2 * last_place;
  }
  Real slope_tolerance(Real steepness) const {
    return slope_error + 4 * steepness * (last_place > 0 ? last_place : 2e-7L);
  }
};

template <class S, class Blend, class Profile, int segments>
[[gnu::noinline]] void describe(Subject& subject, const Blend& blend, const Profile& profile,
                                const Table<S, segments>& table, Real steepness = 1) {
  subject.evaluated = [blend, &table, steepness](Real x, Real y) {
    const S g = scalar<S>(steepness);
    const Sample<S> a{scalar<S>(x), {g, {}, {}}}, b{scalar<S>(y), {{}, g, {}}};
    const Sample<S> out = blend.combine(a, b, table.view());
    const Value<S> value = blend.combine(Value<S>{a.value}, Value<S>{b.value}, table.view());
    EXPECT_EQ(ScalarTraits<S>::word(value.value), ScalarTraits<S>::word(out.value));
    return BlendPoint{real(out.value), real(out.gradient.x) / steepness, real(out.gradient.y) / steepness};
  };
  subject.rounded = [](Real x) { return real(scalar<S>(x)); };
  subject.last_place = last_place<S>();
  const RayFactors factors = profile.factors();
  const Real factor = static_cast<Real>(std::max(factors.first, factors.second)),
             halves = factors.differ ? 2 : 1;
  const TableFacts& facts = table.facts;
  const Real steepest = std::ldexp(
      static_cast<Real>(std::max(std::abs(facts.least_slope), std::abs(facts.greatest_slope))), -24);
  const Real moved =
      (factor + 1) * (ScalarTraits<S>::is_fixed ? std::ldexp(1.5L, -30) : std::ldexp(1.0L, -22));
  subject.value_error =
      std::ldexp(static_cast<Real>(facts.error), -30) + steepest * moved + std::ldexp(2.0L, -30);
  // A table's second derivative is less than twice its slope's range for each of its segments.
  const Real bend = 2 * steepest * segments;
  // The table's slope is rounded to the scalar before the factor enlarges it.
  const Real of_slope = std::ldexp(static_cast<Real>(facts.slope_error), -24) + bend * moved;
  subject.slope_error = factor * (2 * of_slope / halves + subject.last_place) + subject.value_error;
  Certificate<S> of[2];
  of[0].valid = of[1].valid = true;
  of[0].lipschitz = of[1].lipschitz = Rate(1.0 / 16.0);
  const Certificate<S> certificate = blend.certificate(of, facts, domain_reach<S>());
  EXPECT_TRUE(certificate.valid) << subject.name;
  subject.spread = 16 * static_cast<Real>(certificate.lipschitz.to_double());
  subject.certified_error = real(certificate.error);
}

// Operands of all sizes, most of them close to each other or to an edge of the blend's region.
struct Operands {
  Real x, y;
};
Operands random_operands(const Subject& subject, Random& random) {
  const Real size = std::exp(random.uniform(-4, 2));
  Real ratio = random.uniform();
  const Real edge = subject.edges[random.integer(0, 1)];
  if (random.chance(0.4L)) ratio = edge + (1 - edge) * random.uniform();
  if (edge > 0 && random.chance(0.1L)) ratio = edge * (1 + random.uniform(-1e-4L, 1e-4L));
  if (random.chance(0.05L)) ratio = std::exp(random.uniform(-18, 0));
  const Operands operands = {subject.rounded(size), subject.rounded(size * std::min<Real>(ratio, 1))};
  return random.chance(0.5L) ? operands : Operands{operands.y, operands.x};
}

struct Worst {
  Real of_value = 0, of_slope = 0, of_certificate = 0;
  void report(const char* what) const {
    std::printf("%s: greatest error / bound: value %.3Lf, derivatives %.3Lf, certificate %.3Lf\n", what,
                of_value, of_slope, of_certificate);
  }
};

// A partial derivative along which the exact one is not continuous is not compared: at 0 and where both are
// equal to 0.
void expect_equal(const Subject& subject, const Operands& operands, Worst& worst) {
  const auto [x, y] = operands;
  const BlendPoint found = subject.evaluated(x, y), exact = subject.exact(x, y);
  const std::string what = subject.name + " of " + std::to_string(x) + " and " + std::to_string(y);
  if (exact.value > kGreatestRay - 0.01L) {
    EXPECT_LE(std::fabs(found.value - std::min<Real>(exact.value, kGreatestRay)), subject.certified_error)
        << what;
    return;
  }
  const Real deciding = std::max(std::min(x, y), exact.value), error = std::fabs(found.value - exact.value);
  EXPECT_LE(error, subject.value_tolerance(deciding)) << what;
  EXPECT_LE(error, subject.certified_error) << what;
  worst.of_value = std::max(worst.of_value, error / subject.value_tolerance(deciding));
  worst.of_certificate = std::max(worst.of_certificate, error / subject.certified_error);
  if (x == 0 || y == 0) return;
  const Real steepness = std::max({std::fabs(exact.by_x), std::fabs(exact.by_y), 1.0L});
  const Real off = std::max(std::fabs(found.by_x - exact.by_x), std::fabs(found.by_y - exact.by_y));
  EXPECT_LE(off, subject.slope_tolerance(steepness)) << what << ": " << found.by_x << ", " << found.by_y
                                                     << " instead of " << exact.by_x << ", " << exact.by_y;
  worst.of_slope = std::max(worst.of_slope, off / subject.slope_tolerance(steepness));
}

constexpr Real exponents[] = {1, 1.5L, 2, 3, 4, 8, 16, 64};

// A table of 64 segments for each of the exponents, intersections before unions.
template <class S>
struct NormTables {
  std::vector<profile::SuperEllipsoid> profiles;
  std::vector<Table<S, 64>> tables;

  NormTables() {
    for (const Real n : exponents) add(profile::super_ellipsoidal_intersection(static_cast<double>(n)));
    for (const Real n : exponents) add(profile::super_ellipsoidal_union(static_cast<double>(n)));
  }
  static const NormTables& instance() {
    static const NormTables tables;
    return tables;
  }

 private:
  void add(const profile::SuperEllipsoid& profile) {
    EXPECT_EQ(profile.problem(), nullptr);
    profiles.push_back(profile);
    tables.push_back(bake<S, 64>(profile));
  }
};
constexpr size_t exponent_count = sizeof exponents / sizeof exponents[0];

template <class S>
std::vector<Subject> norms(SetOperation operation) {
  std::vector<Subject> subjects;
  const NormTables<S>& all = NormTables<S>::instance();
  for (size_t i = 0; i < exponent_count; ++i) {
    const Real n = exponents[i];
    const bool is_union = operation == SetOperation::unite;
    const size_t which = is_union ? i + exponent_count : i;
    Subject subject;
    subject.name = (is_union ? "union, n " : "intersection, n ") + std::to_string(n);
    subject.exact = [n, is_union](Real x, Real y) {
      const auto point = is_union ? reference::super_ellipsoidal_union(n, {x, y})
                                  : reference::super_ellipsoidal_intersection(n, {x, y});
      return BlendPoint{point.value, point.partials[0], point.partials[1]};
    };
    const auto& profile = all.profiles[which];
    if (is_union)
      describe<S>(subject, RayLinearUnion<S>{{RaySides<S>::of(profile)}}, profile, all.tables[which]);
    else
      describe<S>(subject, RayLinearIntersection<S>{{RaySides<S>::of(profile)}}, profile, all.tables[which]);
    const Real factor = static_cast<Real>(profile.factor);
    subject.edges[0] = subject.edges[1] = factor > 1 ? 1 - 1 / factor : 0;
    subjects.push_back(subject);
  }
  return subjects;
}

constexpr Real ranges[][2] = {{0.05L, 0.05L}, {0.3L, 0.3L},  {0.95L, 0.95L},
                              {0.05L, 0.95L}, {0.6L, 0.25L}, {0.7L, 0.08L}};
constexpr Real hollows[] = {-3, -0.2L, 0};  // p; and a half and nine tenths of r1 r2

template <class S>
struct ScaleTables {
  std::vector<profile::ScaleBlend> profiles;
  std::vector<Table<S, 64>> tables;

  explicit ScaleTables(bool is_union) {
    for (const auto& [r1, r2] : ranges) {
      for (const Real p : hollows) add(is_union, r1, r2, p);
      add(is_union, r1, r2, 0.5L * r1 * r2);
      add(is_union, r1, r2, 0.9L * r1 * r2);
    }
  }
  static const ScaleTables& instance(bool is_union) {
    static const ScaleTables unions(true), intersections(false);
    return is_union ? unions : intersections;
  }

 private:
  void add(bool is_union, Real r1, Real r2, Real p) {
    const auto make = is_union ? profile::scale_union : profile::scale_intersection;
    const profile::ScaleBlend profile =
        make(static_cast<double>(r1), static_cast<double>(r2), static_cast<double>(p));
    EXPECT_EQ(profile.problem(), nullptr);
    profiles.push_back(profile);
    tables.push_back(bake<S, 64>(profile));
  }
};

template <class S>
std::vector<Subject> scale_blends(bool is_union) {
  std::vector<Subject> subjects;
  const ScaleTables<S>& all = ScaleTables<S>::instance(is_union);
  for (size_t i = 0; i < all.profiles.size(); ++i) {
    const profile::ScaleBlend& profile = all.profiles[i];
    const ScaleRanges exact_ranges{static_cast<Real>(profile.r1), static_cast<Real>(profile.r2),
                                   static_cast<Real>(profile.p)};
    const auto& [r1, r2, p] = exact_ranges;
    Subject subject;
    subject.name = (is_union ? "scale union " : "scale intersection ") + std::to_string(r1) + " " +
                   std::to_string(r2) + " " + std::to_string(p);
    subject.exact = [exact_ranges, is_union](Real x, Real y) {
      return is_union ? reference::scale_union(exact_ranges, x, y)
                      : reference::scale_intersection(exact_ranges, x, y);
    };
    if (is_union)
      describe<S>(subject, RayLinearUnion<S>{{RaySides<S>::of(profile)}}, profile, all.tables[i]);
    else
      describe<S>(subject, RayLinearIntersection<S>{{RaySides<S>::of(profile)}}, profile, all.tables[i]);
    subject.edges[0] = is_union ? 1 / (1 + r1) : 1 - r1;
    subject.edges[1] = is_union ? 1 / (1 + r2) : 1 - r2;
    subjects.push_back(subject);
  }
  return subjects;
}

void expect_all_equal(const std::vector<Subject>& subjects, const char* test, uint64_t seed, int count) {
  Random random(announced_seed(test, seed));
  Worst worst;
  for (const Subject& subject : subjects) {
    for (int i = 0; i < count && !testing::Test::HasFailure(); ++i)
      expect_equal(subject, random_operands(subject, random), worst);
  }
  worst.report(test);
  EXPECT_GT(worst.of_certificate, 0.01L);
}

template <class S>
class RayLinearBlends : public testing::Test {};
using Scalars = testing::Types<Fixed<27>, Fixed<24>, Fixed<16>, float>;
TYPED_TEST_SUITE(RayLinearBlends, Scalars, );

TYPED_TEST(RayLinearBlends, NormsEqualTheirFormulas) {
  expect_all_equal(norms<TypeParam>(SetOperation::intersect), "RayLinearBlends.NormsEqualTheirFormulas", 321,
                   2000);
  expect_all_equal(norms<TypeParam>(SetOperation::unite), "RayLinearBlends.NormsEqualTheirFormulas", 322,
                   2000);
}
TYPED_TEST(RayLinearBlends, ScaleUnionsEqualTheirFormula) {
  expect_all_equal(scale_blends<TypeParam>(true), "RayLinearBlends.ScaleUnionsEqualTheirFormula", 323, 200);
}
TYPED_TEST(RayLinearBlends, ScaleIntersectionsEqualTheirFormula) {
  expect_all_equal(scale_blends<TypeParam>(false), "RayLinearBlends.ScaleIntersectionsEqualTheirFormula", 324,
                   200);
}

template <class S>
std::vector<Subject> all_subjects() {
  std::vector<Subject> subjects = norms<S>(SetOperation::intersect);
  for (const Subject& subject : norms<S>(SetOperation::unite)) subjects.push_back(subject);
  for (const bool is_union : {true, false}) {
    for (const Subject& subject : scale_blends<S>(is_union)) subjects.push_back(subject);
  }
  return subjects;
}

// From one ratio to the next in steps of the last place, value and derivatives go on without a jump: across
// the edges of the region, across equal operands, across knots.
void expect_smooth(const Subject& subject, Real ratio) {
  const Real step = subject.last_place > 0 ? subject.last_place : 2e-7L, x = subject.rounded(1.25L);
  const Real steepness = std::max<Real>(subject.spread, 1);
  for (const bool swapped : {false, true}) {
    BlendPoint before{};
    for (int i = -3; i <= 3; ++i) {
      const Real y = subject.rounded(x * ratio) + static_cast<Real>(i) * step;
      const BlendPoint here = swapped ? subject.evaluated(y, x) : subject.evaluated(x, y);
      if (i > -3) {
        // The sharpest blends turn from one operand to the other within a 500th of them.
        const Real bend = 500 * step + subject.slope_error;
        EXPECT_LE(std::fabs(here.value - before.value), steepness * step + 3 * step + 1e-8L)
            << subject.name << " at " << ratio;
        EXPECT_LE(std::fabs(here.by_x - before.by_x), bend) << subject.name << " at " << ratio;
        EXPECT_LE(std::fabs(here.by_y - before.by_y), bend) << subject.name << " at " << ratio;
      }
      before = here;
    }
  }
}

TYPED_TEST(RayLinearBlends, AreSmoothAcrossEdgesTiesAndKnots) {
  for (const Subject& subject : all_subjects<TypeParam>()) {
    expect_smooth(subject, 1);
    for (const Real edge : subject.edges) {
      if (edge <= 0) continue;
      expect_smooth(subject, edge);
      for (int knot = 1; knot < 64; knot += 7)
        expect_smooth(subject, 1 - (1 - edge) * static_cast<Real>(knot) / 64);
    }
  }
}

TYPED_TEST(RayLinearBlends, GoThroughTheAxes) {
  for (const Subject& subject : norms<TypeParam>(SetOperation::intersect)) {
    for (const Real x : {0.125L, 1.0L, 3.5L}) {
      EXPECT_LE(std::fabs(subject.evaluated(x, 0).value - x), subject.value_tolerance(x)) << subject.name;
      EXPECT_EQ(subject.evaluated(x, 0).value, subject.evaluated(0, x).value);
    }
    EXPECT_EQ(subject.evaluated(0, 0).value, 0);
  }
  for (const Subject& subject : norms<TypeParam>(SetOperation::unite)) {
    EXPECT_LE(std::fabs(subject.evaluated(0.001L, 15).value - subject.rounded(0.001L)),
              15e-7L + 2 * subject.last_place)
        << subject.name;
    EXPECT_EQ(subject.evaluated(0, 1).value, 0);
    EXPECT_EQ(subject.evaluated(0, 0).value, 0);
    EXPECT_EQ(subject.evaluated(0, 0).by_x, subject.evaluated(1, 1).by_x);
  }
  for (const bool is_union : {true, false}) {
    for (const Subject& subject : scale_blends<TypeParam>(is_union)) {
      EXPECT_EQ(subject.evaluated(1, 0).value, is_union ? 0 : 1) << subject.name;
      EXPECT_EQ(subject.evaluated(0, 1).value, is_union ? 0 : 1) << subject.name;
    }
  }
}

// Sums of absolute derivatives, and changes between two places, stay within the certified rate.
TYPED_TEST(RayLinearBlends, NeverChangeFasterThanCertified) {
  Random random(announced_seed("RayLinearBlends.NeverChangeFasterThanCertified", 325));
  Real loosest = 1;
  std::string which;
  for (const Subject& subject : all_subjects<TypeParam>()) {
    Real steepest = 0;
    for (int i = 0; i < 150; ++i) {
      const Operands a = random_operands(subject, random);
      const BlendPoint here = subject.evaluated(a.x, a.y);
      const Real sum = std::fabs(here.by_x) + std::fabs(here.by_y);
      const Real allowed = subject.spread + 8 * (subject.last_place > 0 ? subject.last_place : 2e-7L);
      EXPECT_LE(sum, allowed) << subject.name << " of " << a.x << " and " << a.y;
      steepest = std::max(steepest, sum / subject.spread);
      const Operands b = {subject.rounded(a.x * random.uniform(0.7L, 1.3L)),
                          subject.rounded(a.y * random.uniform(0.7L, 1.3L))};
      const Real change = std::fabs(subject.evaluated(b.x, b.y).value - here.value);
      EXPECT_LE(change, subject.spread * std::max(std::fabs(a.x - b.x), std::fabs(a.y - b.y)) +
                            2 * subject.certified_error)
          << subject.name;
    }
    if (steepest < loosest) {
      loosest = steepest;
      which = subject.name;
    }
  }
  std::printf("the loosest rate, of %s: %.3Lf of it attained\n", which.c_str(), loosest);
  EXPECT_GT(loosest, 0.4L);
}

TYPED_TEST(RayLinearBlends, SymmetricOnesDoNotCareForTheOrder) {
  Random random(announced_seed("RayLinearBlends.SymmetricOnesDoNotCareForTheOrder", 326));
  for (const SetOperation operation : {SetOperation::unite, SetOperation::intersect}) {
    for (const Subject& subject : norms<TypeParam>(operation)) {
      for (int i = 0; i < 200; ++i) {
        const auto [x, y] = random_operands(subject, random);
        const BlendPoint one = subject.evaluated(x, y), other = subject.evaluated(y, x);
        EXPECT_EQ(one.value, other.value) << subject.name;
        if (x == y) continue;
        EXPECT_EQ(one.by_x, other.by_y) << subject.name;
        EXPECT_EQ(one.by_y, other.by_x) << subject.name;
      }
    }
  }
}

TYPED_TEST(RayLinearBlends, SequencesEqualHsus) {
  Random random(announced_seed("RayLinearBlends.SequencesEqualHsus", 327));
  for (const bool is_union : {true, false}) {
    const ScaleTables<TypeParam>& all = ScaleTables<TypeParam>::instance(is_union);
    const std::vector<Subject> subjects = scale_blends<TypeParam>(is_union);
    for (size_t i = 0; i < subjects.size(); ++i) {
      const Subject& subject = subjects[i];
      const ScaleRanges exact_ranges{static_cast<Real>(all.profiles[i].r1),
                                     static_cast<Real>(all.profiles[i].r2),
                                     static_cast<Real>(all.profiles[i].p)};
      for (int trial = 0; trial < 30; ++trial) {
        std::vector<Real> x(4);
        for (Real& operand : x) operand = subject.rounded(random.uniform(0.7L, 1.3L));
        Real found = x[0];
        for (size_t k = 1; k < x.size(); ++k) found = subject.evaluated(found, x[k]).value;
        const Real exact = is_union ? reference::sequential_scale_union(exact_ranges, x).value
                                    : reference::sequential_scale_intersection(exact_ranges, x).value;
        EXPECT_LE(std::fabs(found - exact), 10 * subject.value_tolerance(2 * exact)) << subject.name;
      }
    }
  }
}

TYPED_TEST(RayLinearBlends, OperandsOutOfRangeAreConstants) {
  for (const Subject& subject : all_subjects<TypeParam>()) {
    const BlendPoint below = subject.evaluated(-2, 1), at_zero = subject.evaluated(0, 1);
    EXPECT_EQ(below.value, at_zero.value) << subject.name;
    EXPECT_EQ(below.by_x, 0) << subject.name;
    const BlendPoint above = subject.evaluated(15.5L, 1), at_limit = subject.evaluated(15, 1);
    EXPECT_EQ(above.value, at_limit.value) << subject.name;
    EXPECT_EQ(above.by_x, 0) << subject.name;
    EXPECT_LE(subject.evaluated(15, 15).value, 15) << subject.name;
    EXPECT_GE(subject.evaluated(15, 15).value, 7) << subject.name;
  }
  const Subject sum = norms<TypeParam>(SetOperation::intersect)[0];
  EXPECT_EQ(sum.evaluated(10, 10).value, 15);
  EXPECT_EQ(sum.evaluated(10, 10).by_x, 0);
}

// Hsu's difference, with the surface at 1 and at 1/2, wherever the second operand is not deep inside its
// solid.
TYPED_TEST(RayLinearBlends, DifferencesEqualTheirFormula) {
  using S = TypeParam;
  Random random(announced_seed("RayLinearBlends.DifferencesEqualTheirFormula", 328));
  const NormTables<S>& all = NormTables<S>::instance();
  Worst worst;
  for (size_t i = 0; i < exponent_count; ++i) {
    for (const Real surface : {1.0L, 0.5L}) {
      const Real least = surface / 4, n = exponents[i];
      Subject subject;
      subject.name = "difference, n " + std::to_string(n);
      subject.exact = [n, surface, least](Real x, Real y) {
        // Below `least` the complement goes on along its tangent.
        const Real reached = std::max(y, least), beyond = reached - y;
        if (beyond == 0) {
          const auto point = reference::super_ellipsoidal_difference(n, {x, y}, surface);
          return BlendPoint{point.value, point.partials[0], point.partials[1]};
        }
        const Real slope = surface * surface / (reached * reached);
        const auto point =
            reference::super_ellipsoidal_intersection(n, {x, slope * reached + slope * beyond});
        return BlendPoint{point.value, point.partials[0], -slope * point.partials[1]};
      };
      RayLinearDifference<S> blend{
          {RaySides<S>::of(all.profiles[i]), {scalar<S>(surface * surface), scalar<S>(least)}}};
      describe<S>(subject, blend, all.profiles[i], all.tables[i], 1.0L / 16);
      // Roundings of the complement.
      const Real unit = subject.last_place > 0 ? subject.last_place : 1e-6L;
      subject.value_error *= 4;
      subject.slope_error = subject.slope_error * 18 + 1e-7L;
      for (int trial = 0; trial < 500; ++trial) {
        const Operands operands{
            subject.rounded(random.uniform(0, 3)),
            subject.rounded(random.chance(0.3L) ? random.uniform(0, 0.3L) : random.uniform(0, 3))};
        const BlendPoint found = subject.evaluated(operands.x, operands.y),
                         exact = subject.exact(operands.x, operands.y);
        const std::string what =
            subject.name + " of " + std::to_string(operands.x) + " and " + std::to_string(operands.y);
        const Real error = std::fabs(found.value - exact.value),
                   off = std::max(std::fabs(found.by_x - exact.by_x), std::fabs(found.by_y - exact.by_y));
        const Real allowed = subject.value_tolerance(std::max<Real>(exact.value, 1)) + 8 * unit;
        EXPECT_LE(error, allowed) << what;
        worst.of_value = std::max(worst.of_value, error / allowed);
        EXPECT_LE(error, subject.certified_error) << what;
        worst.of_certificate = std::max(worst.of_certificate, error / subject.certified_error);
        // How the ratio of operands moves with the complement's roundings, and by how much that turns
        // derivatives.
        const Real turned = 200 * static_cast<Real>(n) * unit / std::max<Real>(exact.value, 0.1L);
        if (operands.x > 0.05L) {
          EXPECT_LE(off, subject.slope_tolerance(64) + turned) << what;
          worst.of_slope = std::max(worst.of_slope, off / (subject.slope_tolerance(64) + turned));
        }
        EXPECT_LE(std::fabs(found.by_x) + std::fabs(found.by_y), subject.spread + 100 * unit) << what;
      }
    }
  }
  worst.report("RayLinearBlends.DifferencesEqualTheirFormula");
}

template <class S>
Certificate<S> operand_certificate(double lipschitz) {
  Certificate<S> certificate;
  certificate.valid = true;
  certificate.lipschitz = Rate(lipschitz);
  return certificate;
}

TYPED_TEST(RayLinearBlends, RefuseWhatTheyCannotAnswerFor) {
  using S = TypeParam;
  const profile::SuperEllipsoid exact = profile::super_ellipsoidal_intersection(2);
  const Table<S, 64> table = bake<S, 64>(exact);
  const auto certificate = [&table](const auto& blend, double lipschitz) {
    const Certificate<S> of[2] = {operand_certificate<S>(lipschitz), operand_certificate<S>(lipschitz)};
    return blend.certificate(of, table.facts, domain_reach<S>());
  };
  using Factor = typename RaySides<S>::Factor;
  const RaySides<S> sides = RaySides<S>::of(exact);
  EXPECT_TRUE(certificate(RayLinearIntersection<S>{{sides}}, 4).valid);
  EXPECT_FALSE(certificate(RayLinearIntersection<S>{{sides}}, 100).valid);  // 1.7 times as steep
  EXPECT_FALSE(certificate(RayLinearIntersection<S>{}, 1).valid);
  RaySides<S> forged = sides;
  forged.first = Factor(static_cast<Factor>(0.5));
  EXPECT_FALSE(certificate(RayLinearIntersection<S>{{forged}}, 1).valid);
  forged = sides;
  forged.second = Factor(static_cast<Factor>(65));
  EXPECT_FALSE(certificate(RayLinearIntersection<S>{{forged}}, 1).valid);
  forged = sides;
  forged.differ = 2;
  EXPECT_FALSE(certificate(RayLinearIntersection<S>{{forged}}, 1).valid);

  const auto difference = [&](Real surface_square, Real least, double lipschitz) {
    return certificate(RayLinearDifference<S>{{sides, {scalar<S>(surface_square), scalar<S>(least)}}},
                       lipschitz)
        .valid;
  };
  // 16 * 1.7 times as steep: less than 127, and less than 15 where gradients end at 16.
  const double part = fraction_bits_of<S> == 27 ? 0.125 : 1.0;
  EXPECT_TRUE(difference(1, 0.25L, 4 * part));
  EXPECT_TRUE(difference(0.25L, 0.125L, 4 * part));
  EXPECT_FALSE(difference(1, 0.25L, 5 * part));
  EXPECT_FALSE(difference(1, 0.125L, 0.5));  // up to 16
  EXPECT_FALSE(difference(1, 0, 0.5));
  EXPECT_FALSE(difference(1, -0.25L, 0.5));
  EXPECT_FALSE(difference(1, 1.5L, 0.5));
  EXPECT_FALSE(difference(0, 0.25L, 0.5));
}

TEST(RayProfiles, RefuseParametersWithoutABlend) {
  EXPECT_EQ(profile::super_ellipsoidal_union(1).problem(), nullptr);
  EXPECT_NE(profile::super_ellipsoidal_union(0.99).problem(), nullptr);
  EXPECT_NE(profile::super_ellipsoidal_intersection(65).problem(), nullptr);
  EXPECT_NE(profile::super_ellipsoidal_intersection(std::nan("")).problem(), nullptr);
  EXPECT_EQ(profile::scale_union(4, 0.02, 0).problem(), nullptr);
  EXPECT_NE(profile::scale_union(0.01, 0.5, 0).problem(), nullptr);
  EXPECT_NE(profile::scale_union(0.5, 4.1, 0).problem(), nullptr);
  EXPECT_EQ(profile::scale_intersection(1, 1, 0).problem(), nullptr);
  EXPECT_NE(profile::scale_intersection(1.01, 0.5, 0).problem(), nullptr);
  EXPECT_EQ(profile::scale_intersection(0.5, 0.5, 0.2475).problem(), nullptr);
  EXPECT_NE(profile::scale_intersection(0.5, 0.5, 0.25).problem(), nullptr);
  EXPECT_NE(profile::scale_union(0.5, 0.5, -501).problem(), nullptr);
  EXPECT_NE(profile::scale_union(0.5, 0.5, std::nan("")).problem(), nullptr);
}

// At the ends of the allowed parameters a table of 256 segments still exists, says how good it is, and is
// accepted.
TEST(RayProfiles, HaveTablesUpToTheEndsOfTheirParameters) {
  using S = Fixed<27>;
  Real worst = 0, widest = 0;
  const Certificate<S> of[2] = {operand_certificate<S>(1), operand_certificate<S>(1)};
  for (const bool is_union : {true, false}) {
    const double greatest = is_union ? 4.0 : 1.0;
    for (const double r1 : {0.02, greatest}) {
      for (const double r2 : {0.02, greatest}) {
        for (const double p : {-2000 * r1 * r2, 0.0, 0.99 * r1 * r2}) {
          const profile::ScaleBlend exact =
              is_union ? profile::scale_union(r1, r2, p) : profile::scale_intersection(r1, r2, p);
          EXPECT_EQ(exact.problem(), nullptr);
          const Table<S, 256> table = bake<S, 256>(exact);
          const RaySides<S> sides = RaySides<S>::of(exact);
          const Certificate<S> certificate =
              is_union ? RayLinearUnion<S>{{sides}}.certificate(of, table.facts, {})
                       : RayLinearIntersection<S>{{sides}}.certificate(of, table.facts, {});
          EXPECT_TRUE(certificate.valid) << is_union << " " << r1 << " " << r2 << " " << p;
          worst = std::max(worst, std::ldexp(static_cast<Real>(table.facts.error), -30));
          widest = std::max(widest, static_cast<Real>(certificate.lipschitz.to_double()));
        }
      }
    }
  }
  std::printf("greatest error of 256 segments %.2Le, greatest rate %.3Lf\n", worst, widest);
  EXPECT_LT(worst, 1e-3L);
}

// Static composition and program: the same bits.
TYPED_TEST(RayLinearBlends, AreTheSameInPrograms) {
  using S = TypeParam;
  Random random(announced_seed("RayLinearBlends.AreTheSameInPrograms", 329));
  const auto norm = profile::super_ellipsoidal_intersection(2.5);
  const auto crease = profile::scale_union(0.6, 0.25, -0.1);
  const Table<S, 64> norm_table = bake<S, 64>(norm), crease_table = bake<S, 64>(crease);
  const RayRadius<S> influence(scalar<S>(0.5L));
  const auto point = [&] {
    return RayPoint<S>{{scalar<S>(random.uniform(-1, 1)), scalar<S>(random.uniform(-1, 1)), {}}, influence};
  };
  const auto joined = combine(RayLinearUnion<S>{{RaySides<S>::of(crease)}}, crease_table, point(), point());
  const auto common = combine(RayLinearIntersection<S>{{RaySides<S>::of(norm)}}, norm_table, joined, point());
  const RayLinearDifference<S> difference{{RaySides<S>::of(norm), {scalar<S>(1), scalar<S>(0.25L)}}};
  const auto whole = field(combine(difference, norm_table, common, point()));
  const auto node = combine(difference, norm_table, common, point());
  const auto composed = field(node);
  EXPECT_TRUE(whole.valid());

  golden::NodeWriter<S, 1000> writer;
  writer.table(norm_table);
  writer.table(crease_table);
  writer.write(node);
  ASSERT_EQ(writer.builder().finish().status, LoadStatus::ok);
  const Program<S> program = load<S>(writer.builder().words(), writer.builder().size() * 4u);
  ASSERT_TRUE(program.valid());
  EXPECT_EQ(program.kind(), Kind::ray);
  EXPECT_EQ(program.certificate().lipschitz, composed.certificate().lipschitz);
  EXPECT_EQ(ScalarTraits<S>::word(program.certificate().error),
            ScalarTraits<S>::word(composed.certificate().error));
  int blended = 0;
  for (int i = 0; i < 300; ++i) {
    const Vector3<S> p{scalar<S>(random.uniform(-2, 2)), scalar<S>(random.uniform(-2, 2)),
                       scalar<S>(random.uniform(-1, 1))};
    const auto here = composed.template evaluate<Sample<S>>(p, nullptr);
    const auto there = program.template evaluate<Sample<S>>(p, nullptr);
    EXPECT_EQ(ScalarTraits<S>::word(here.value), ScalarTraits<S>::word(there.value));
    EXPECT_TRUE(here.gradient == there.gradient);
    blended += here.value < greatest_ray<S>() ? 1 : 0;
  }
  EXPECT_GT(blended, 250);
}

}  // namespace
