#pragma once
// Ray-linear blends as numbers, next to the papers' formulas in long double.
#include <nearfield/blend/ray_linear.hpp>
#include <nearfield/curve/ray_kernel.hpp>
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

namespace nearfield::ray_linear_tests {

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

// A profile whose type does not matter, so that what bakes it is compiled once.
struct AnyProfile {
  std::function<Differentiable(const Differentiable&)> exact;
  RayFactors both;
  nearfield::detail::Breaks places;

  template <class Profile>
  static AnyProfile of(const Profile& profile) {
    return {[profile](const Differentiable& u) { return profile(u); }, profile.factors(), profile.breaks()};
  }
  Differentiable operator()(const Differentiable& u) const { return exact(u); }
  const RayFactors& factors() const { return both; }
  const nearfield::detail::Breaks& breaks() const { return places; }
};

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
  Real exponent = 0;       // of norms
  ScaleRanges ranges;      // of scale blends

  Real value_tolerance(Real deciding) const {
    return deciding * (value_error + (last_place > 0 ? 0 : 3e-7L)) + 2 * last_place;
  }
  Real slope_tolerance(Real steepness) const {
    return slope_error + 4 * steepness * (last_place > 0 ? last_place : 2e-7L);
  }
};

template <class S, class Blend>
[[gnu::noinline]] void describe(Subject& subject, const Blend& blend, const RayFactors& factors,
                                const Table<S, 64>& table, Real steepness = 1) {
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
  const Real bend = 2 * steepest * 64;
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
inline Operands random_operands(const Subject& subject, Random& random) {
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
inline void expect_equal(const Subject& subject, const Operands& operands, Worst& worst) {
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

/// From the least to the greatest that there are, many of them close to 1, and some drawn at random.
inline const std::vector<Real>& exponents() {
  static const std::vector<Real> all = [] {
    Random random(announced_seed("RayLinearExponents", 320));
    std::vector<Real> list = {1, 1.0001L, 1.05L, 1.25L, 1.5L, 2, 3, 4, 8, 16, 64};
    for (int i = 0; i < 5; ++i) list.push_back(random.uniform(1, 1.5L));
    for (int i = 0; i < 5; ++i) list.push_back(1.5L * std::pow(64 / 1.5L, random.uniform()));
    for (Real& n : list) n = static_cast<Real>(static_cast<double>(n));
    return list;
  }();
  return all;
}

// A table of 64 segments for each of the exponents, intersections before unions.
template <class S>
struct NormTables {
  std::vector<AnyProfile> profiles;
  std::vector<Table<S, 64>> tables;

  NormTables() {
    for (const Real n : exponents()) add(profile::super_ellipsoidal_intersection(static_cast<double>(n)));
    for (const Real n : exponents()) add(profile::super_ellipsoidal_union(static_cast<double>(n)));
  }
  static const NormTables& instance() {
    static const NormTables tables;
    return tables;
  }

 private:
  void add(const profile::SuperEllipsoid& profile) {
    EXPECT_EQ(profile.problem(), nullptr);
    profiles.push_back(AnyProfile::of(profile));
    tables.push_back(bake<S, 64>(profiles.back()));
  }
};

template <class S>
std::vector<Subject> norms(SetOperation operation) {
  std::vector<Subject> subjects;
  const NormTables<S>& all = NormTables<S>::instance();
  for (size_t i = 0; i < exponents().size(); ++i) {
    const Real n = exponents()[i];
    const bool is_union = operation == SetOperation::unite;
    const size_t which = is_union ? i + exponents().size() : i;
    Subject subject;
    subject.name = (is_union ? "union, n " : "intersection, n ") + std::to_string(n);
    subject.exact = [n, is_union](Real x, Real y) {
      const auto point = is_union ? reference::super_ellipsoidal_union(n, {x, y})
                                  : reference::super_ellipsoidal_intersection(n, {x, y});
      return BlendPoint{point.value, point.partials[0], point.partials[1]};
    };
    const auto& profile = all.profiles[which];
    if (is_union)
      describe<S>(subject, RayLinearUnion<S>{{RaySides<S>::of(profile)}}, profile.factors(),
                  all.tables[which]);
    else
      describe<S>(subject, RayLinearIntersection<S>{{RaySides<S>::of(profile)}}, profile.factors(),
                  all.tables[which]);
    const Real factor = static_cast<Real>(profile.factors().first);
    subject.exponent = n;
    subject.edges[0] = subject.edges[1] = factor > 1 ? 1 - 1 / factor : 0;
    subjects.push_back(subject);
  }
  return subjects;
}

inline constexpr Real ranges[][2] = {{0.05L, 0.05L}, {0.3L, 0.3L},  {0.95L, 0.95L},
                                     {0.05L, 0.95L}, {0.6L, 0.25L}, {0.7L, 0.08L}};
inline constexpr Real hollows[] = {-3, -0.2L, 0};  // p; and a half and nine tenths of r1 r2

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
    tables.push_back(bake<S, 64>(AnyProfile::of(profile)));
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
    subject.ranges = exact_ranges;
    subject.exact = [exact_ranges, is_union](Real x, Real y) {
      return is_union ? reference::scale_union(exact_ranges, x, y)
                      : reference::scale_intersection(exact_ranges, x, y);
    };
    if (is_union)
      describe<S>(subject, RayLinearUnion<S>{{RaySides<S>::of(profile)}}, profile.factors(), all.tables[i]);
    else
      describe<S>(subject, RayLinearIntersection<S>{{RaySides<S>::of(profile)}}, profile.factors(),
                  all.tables[i]);
    subject.edges[0] = is_union ? 1 / (1 + r1) : 1 - r1;
    subject.edges[1] = is_union ? 1 / (1 + r2) : 1 - r2;
    subjects.push_back(subject);
  }
  return subjects;
}

using Scalars = testing::Types<Fixed<27>, Fixed<24>, Fixed<16>, float>;

// The same by a number, for tests whose code does not depend on the scalar: they are compiled once.
enum class AnyScalar { fixed27, fixed24, fixed16, floating };
template <class Function>
auto with_scalar(AnyScalar scalar, const Function& function) {
  if (scalar == AnyScalar::fixed27) return function(Fixed<27>{});
  if (scalar == AnyScalar::fixed24) return function(Fixed<24>{});
  if (scalar == AnyScalar::fixed16) return function(Fixed<16>{});
  return function(float{});
}
inline std::vector<Subject> norms(AnyScalar scalar, SetOperation operation) {
  return with_scalar(scalar, [&](auto zero) { return norms<decltype(zero)>(operation); });
}
inline std::vector<Subject> scale_blends(AnyScalar scalar, bool is_union) {
  return with_scalar(scalar, [&](auto zero) { return scale_blends<decltype(zero)>(is_union); });
}
inline std::vector<Subject> all_subjects(AnyScalar scalar) {
  std::vector<Subject> subjects = norms(scalar, SetOperation::intersect);
  for (const Subject& subject : norms(scalar, SetOperation::unite)) subjects.push_back(subject);
  for (const bool is_union : {true, false}) {
    for (const Subject& subject : scale_blends(scalar, is_union)) subjects.push_back(subject);
  }
  return subjects;
}

class ByScalar : public testing::TestWithParam<AnyScalar> {};
inline auto all_scalars() {
  return testing::Values(AnyScalar::fixed27, AnyScalar::fixed24, AnyScalar::fixed16, AnyScalar::floating);
}
inline std::string scalar_name(const testing::TestParamInfo<AnyScalar>& info) {
  constexpr const char* names[] = {"Fixed27", "Fixed24", "Fixed16", "Float"};
  return names[static_cast<size_t>(info.param)];
}

}  // namespace nearfield::ray_linear_tests
