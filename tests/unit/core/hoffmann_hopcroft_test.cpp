// Hoffmann and Hopcroft's blend: its formula, its surface against the reference's conic, its regions and
// duality.
#include "algebraic_samples.hpp"

#include <reference/algebraic_blends.hpp>

namespace {

using namespace nearfield;
using namespace nearfield::test;
using reference::announced_seed;
using reference::BlendPoint;

template <class S>
class HoffmannHopcroftOf : public testing::Test {};
TYPED_TEST_SUITE(HoffmannHopcroftOf, AllScalars, );

// The union as its header defines it.
struct Exact {
  Real r1, r2, conic;

  Real q() const { return 1 - conic; }
  Real share(Real value, Real range) const { return std::min(Real{1}, std::max(Real{0}, value / range)); }
  Real rest(Real x, Real y) const { return 1 - share(x, r1) - share(y, r2); }
  Real fillet(Real x, Real y) const {
    return (r1 + r2) * (share(x, r1) * share(y, r2) - rest(x, y) * rest(x, y) / (2 * q()));
  }
  bool in_fillet(Real x, Real y) const { return rest(x, y) > 0 && fillet(x, y) < std::min(x, y); }
  // How far an edge between two regions is, at least.
  Real clearance_of_edges(Real x, Real y) const {
    const Real to_fillet = std::fabs(fillet(x, y) - std::min(x, y));
    return std::min({rest(x, y) > 0 ? to_fillet : Real{1}, std::fabs(rest(x, y)), std::fabs(x), std::fabs(y),
                     in_fillet(x, y) ? Real{1} : std::fabs(x - y)});
  }
  BlendPoint unite(Real x, Real y) const {
    if (!in_fillet(x, y)) return {std::min(x, y), x <= y ? Real{1} : Real{0}, x <= y ? Real{0} : Real{1}};
    const Real u = share(x, r1), v = share(y, r2), w = rest(x, y);
    return {fillet(x, y), x > 0 ? (r1 + r2) / r1 * (v + w / q()) : 0,
            y > 0 ? (r1 + r2) / r2 * (u + w / q()) : 0};
  }
  BlendPoint intersect(Real x, Real y) const {
    const BlendPoint turned = unite(-x, -y);
    return {-turned.value, turned.by_x, turned.by_y};
  }
  BlendPoint subtract(Real x, Real y) const {
    const BlendPoint point = intersect(x, -y);
    return {point.value, point.by_x, -point.by_y};
  }

  template <class S, SetOperation operation>
  HoffmannHopcroft<S, operation> as() const {
    return HoffmannHopcroft<S, operation>::of(number<S>(r1), number<S>(r2), number<S>(conic));
  }
  reference::ScaleRanges ranges() const { return {r1, r2, conic * r1 * r2}; }
};
Exact random_blend(Random& random) {
  const Real r1 = random.uniform(0.1L, 0.9L);
  return {r1, r1 * random.uniform(0.5L, 2), random.chance(0.2L) ? Real{0} : random.uniform(-2.5L, 0.8L)};
}
// A pair of operands' values, of which many lie in the fillet and next to its edges.
struct Pair {
  Real x, y;
};
Pair random_pair(Random& random, const Exact& blend) {
  if (random.chance(0.2L)) return {random.uniform(-2, 2), random.uniform(-2, 2)};
  return {blend.r1 * random.uniform(-0.5L, 1.1L), blend.r2 * random.uniform(-0.5L, 1.1L)};
}
template <class S>
Certificate<S> exact_operand(S greatest) {
  Certificate<S> certificate;
  certificate.valid = true;
  certificate.magnitude = greatest;
  return certificate;
}

TYPED_TEST(HoffmannHopcroftOf, IsItsFormula) {
  using S = TypeParam;
  Random random(announced_seed("IsItsFormula", 51));
  Ratio error, gradient_error;
  int in_fillet = 0;
  for (int i = 0; i < 20000; ++i) {
    const Exact exact = random_blend(random);
    const auto check = [&](auto blend, const auto& formula, Real x, Real y, Real sign_x, Real sign_y) {
      Sample<S> a = sample<S>(random, 1, 0.125L), b = sample<S>(random, 1, 0.125L);
      a.value = number<S>(x);
      b.value = number<S>(y);
      const Certificate<S> of[2] = {exact_operand(number<S>(4)), exact_operand(number<S>(4))};
      const Certificate<S> certificate = blend.certificate(of, {}, {});
      ASSERT_TRUE(certificate.valid);
      const BlendPoint expected = formula(real(a.value), real(b.value));
      const Sample<S> got = blend.combine(a, b);
      EXPECT_EQ(got.value, blend.combine(Value<S>{a.value}, Value<S>{b.value}).value);
      error.see(std::fabs(real(got.value) - expected.value), real(certificate.error));
      in_fillet += exact.in_fillet(sign_x * x, sign_y * y) ? 1 : 0;
      if (exact.clearance_of_edges(sign_x * real(a.value), sign_y * real(b.value)) <
          real(certificate.error) * 2)
        return;
      const Vec3 gradient = chained<S>({a, b}, {expected.by_x, expected.by_y});
      const Real slopes = std::max(exact.r1 / exact.r2, exact.r2 / exact.r1) + 1;
      gradient_error.see(greatest_component(real(got.gradient) - gradient),
                         unit<S>(1) * (1 + slopes) * std::max(Real{1}, 1 / exact.q()));
    };
    const Pair at = random_pair(random, exact);
    check(
        exact.as<S, SetOperation::unite>(), [&](Real x, Real y) { return exact.unite(x, y); }, at.x, at.y, 1,
        1);
    check(
        exact.as<S, SetOperation::intersect>(), [&](Real x, Real y) { return exact.intersect(x, y); }, -at.x,
        -at.y, -1, -1);
    check(
        exact.as<S, SetOperation::subtract>(), [&](Real x, Real y) { return exact.subtract(x, y); }, -at.x,
        at.y, -1, 1);
  }
  std::printf("error %.3Lf of the bound, gradient %.3Lf of its bound, %d in the fillet\n", error.greatest(),
              gradient_error.greatest(), in_fillet);
  EXPECT_LE(error.greatest(), 1);
  EXPECT_LE(gradient_error.greatest(), 1);
  EXPECT_GT(in_fillet, 10000);
}

// The blended solid is the reference's, and its field that of the conic but for a factor in the fillet.
TYPED_TEST(HoffmannHopcroftOf, SurfaceIsThatOfTheConic) {
  using S = TypeParam;
  Random random(announced_seed("SurfaceIsThatOfTheConic", 52));
  int inside = 0, outside = 0, scaled = 0;
  for (int i = 0; i < 20000; ++i) {
    const Exact exact = random_blend(random);
    const auto blend = exact.as<S, SetOperation::unite>();
    const Certificate<S> of[2] = {exact_operand(number<S>(4)), exact_operand(number<S>(4))};
    const Real allowed = real(blend.certificate(of, {}, {}).error);
    const Pair at = random_pair(random, exact);
    // Gradients that tell the operands apart.
    const S slope = number<S>(0.125L);
    const Sample<S> a = {number<S>(at.x), {slope, {}, {}}}, b = {number<S>(at.y), {{}, slope, {}}};
    const Sample<S> sample = blend.combine(a, b);
    const Real got = real(sample.value), x = real(a.value), y = real(b.value);
    const BlendPoint point = reference::hoffmann_union(exact.ranges(), x, y);
    const Real expected = point.value;
    if (std::fabs(got) > allowed) {
      ASSERT_EQ(got < 0, expected < 0) << static_cast<double>(x) << ", " << static_cast<double>(y);
      (got < 0 ? inside : outside) += 1;
    }
    if (!exact.in_fillet(x, y) || x < 0 || y < 0) continue;
    const Real product = exact.r1 * exact.r2,
               factor = (exact.r1 + exact.r2) / (2 * exact.q() * product * product);
    ASSERT_LE(std::fabs(got - factor * expected), allowed);
    if (exact.clearance_of_edges(x, y) < 2 * allowed) continue;
    const Real rounding = 8 * unit<S>(1) * std::max(Real{1}, 1 / exact.q());
    ASSERT_LE(std::fabs(real(sample.gradient.x) - 0.125L * factor * point.by_x), rounding);
    ASSERT_LE(std::fabs(real(sample.gradient.y) - 0.125L * factor * point.by_y), rounding);
    ++scaled;
  }
  EXPECT_GT(inside, 1000);
  EXPECT_GT(outside, 1000);
  EXPECT_GT(scaled, 1000);
}

// Exactly the operands elsewhere.
TYPED_TEST(HoffmannHopcroftOf, LeavesTheOperandsAloneOutsideItsRegion) {
  using S = TypeParam;
  Random random(announced_seed("LeavesTheOperandsAloneOutsideItsRegion", 53));
  const Exact exact = {0.5L, 0.25L, -0.5L};
  const auto united = exact.as<S, SetOperation::unite>();
  const auto intersection = exact.as<S, SetOperation::intersect>();
  const auto difference = exact.as<S, SetOperation::subtract>();
  const Real depth = (exact.r1 + exact.r2) / (2 * exact.q());
  for (int i = 0; i < 5000; ++i) {
    Sample<S> a = sample<S>(random, 2, 0.125L), b = sample<S>(random, 2, 0.125L);
    const Real x = real(a.value), y = real(b.value);
    const bool beyond_the_chord = std::max(x, Real{0}) / exact.r1 + std::max(y, Real{0}) / exact.r2 > 1.0001L;
    const bool deep = std::min(x, y) < -depth * 1.0001L;
    if (!beyond_the_chord && !deep) continue;
    ASSERT_TRUE(same(united.combine(a, b), y < x ? b : a));
    const Sample<S> minus_a = {S{} - a.value, -a.gradient}, minus_b = {S{} - b.value, -b.gradient};
    ASSERT_TRUE(same(intersection.combine(minus_a, minus_b), y < x ? minus_b : minus_a));
    ASSERT_TRUE(same(difference.combine(minus_a, b), y < x ? minus_b : minus_a));
  }
}

TYPED_TEST(HoffmannHopcroftOf, IsDual) {
  using S = TypeParam;
  Random random(announced_seed("IsDual", 54));
  for (int i = 0; i < 5000; ++i) {
    const Exact exact = random_blend(random);
    const Pair at = random_pair(random, exact);
    Sample<S> a = sample<S>(random, 1, 0.125L), b = sample<S>(random, 1, 0.125L);
    a.value = number<S>(at.x);
    b.value = number<S>(at.y);
    const Value<S> minus_a = {S{} - a.value}, minus_b = {S{} - b.value};
    const Sample<S> united = exact.as<S, SetOperation::unite>().combine(a, b);
    const auto intersection = exact.as<S, SetOperation::intersect>();
    ASSERT_EQ(intersection.combine(minus_a, minus_b).value, S{} - united.value);
    ASSERT_EQ((exact.as<S, SetOperation::subtract>().combine(minus_a, Value<S>{b.value}).value),
              S{} - united.value);
    // The same gradient when both turn.
    const Sample<S> turned =
        intersection.combine(Sample<S>{minus_a.value, a.gradient}, Sample<S>{minus_b.value, b.gradient});
    ASSERT_TRUE(turned.gradient == united.gradient);
  }
}

// Between planes: the field is continuous and as steep as its certificate says, and its error as large.
TYPED_TEST(HoffmannHopcroftOf, CertificatesHold) {
  using S = TypeParam;
  Random random(announced_seed("CertificatesHold", 55));
  CertificateCheck check;
  for (int i = 0; i < 200; ++i) {
    const Exact exact = random_blend(random);
    const RealPlane first = {random.unit_vector(), random.uniform(-0.2L, 0.2L)},
                    second = {random.unit_vector(), 0};
    const auto node = combine(exact.as<S, SetOperation::unite>(), first.as<S>(), second.as<S>());
    look_at_node<S>(
        check, node, [&](const Vec3& p) { return exact.unite(first.value(p), second.value(p)).value; },
        random, 1);
  }
  check.expect_bounds("unions of planes");
}

// The surface has a continuous tangent where the fillet meets the operands: the gap closes faster than
// linearly.
TYPED_TEST(HoffmannHopcroftOf, SurfaceIsSmoothWhereTheFilletEnds) {
  using S = TypeParam;
  Random random(announced_seed("SurfaceIsSmoothWhereTheFilletEnds", 56));
  for (int i = 0; i < 50; ++i) {
    const Exact exact = random_blend(random);
    const auto blend = exact.as<S, SetOperation::unite>();
    const auto height_at = [&](Real x, bool swapped) {
      Real low = -0.5L, high = 2;
      for (int step = 0; step < 60; ++step) {
        const Real middle = (low + high) / 2;
        const Value<S> a = {number<S>(swapped ? middle : x)}, b = {number<S>(swapped ? x : middle)};
        (blend.combine(a, b).value < S{} ? low : high) = middle;
      }
      return high;
    };
    for (const bool swapped : {false, true}) {
      const Real range = swapped ? exact.r2 : exact.r1;
      const Real slope = height_at(0.5L * range, swapped) / (0.5L * range);
      const Real near_slope = height_at(0.96875L * range, swapped) / (0.03125L * range);
      EXPECT_LT(near_slope, 0.25L * slope);
      EXPECT_LE(std::fabs(height_at(1.25L * range, swapped)), 2 * unit<S>(1));
      EXPECT_GT(slope, 0.01L);
    }
  }
}

TYPED_TEST(HoffmannHopcroftOf, ParametersThatDoNotFitAreRefused) {
  using S = TypeParam;
  using Blend = HoffmannHopcroftUnion<S>;
  const Certificate<S> of[2] = {exact_operand(number<S>(4)), exact_operand(number<S>(4))};
  const auto valid = [&](const Blend& blend) { return blend.certificate(of, {}, {}).valid; };
  const S half = number<S>(0.5L);
  const Blend good = Blend::of(half, half, S{});
  EXPECT_TRUE(valid(good));
  EXPECT_TRUE(valid(Blend::of(half, half, number<S>(0.875L))));
  EXPECT_FALSE(valid(Blend::of(half, half, number<S>(0.876L))));
  EXPECT_FALSE(valid(Blend::of(half, half, number<S>(1))));
  EXPECT_FALSE(valid(Blend::of(half, half, number<S>(2))));
  EXPECT_FALSE(valid(Blend::of(S{}, half, S{})));
  EXPECT_FALSE(valid(Blend::of(half, S{} - half, S{})));
  for (S Blend::*derived : {&Blend::conic, &Blend::sum, &Blend::depth, &Blend::sharpness, &Blend::first_slope,
                            &Blend::second_slope}) {
    Blend other = good;
    other.*derived = other.*derived + number<S>(0.001L);
    EXPECT_FALSE(valid(other));
  }
  Blend other = good;
  other.first.inverse = decltype(other.first.inverse)(other.first.inverse + decltype(other.first.inverse)(1));
  EXPECT_FALSE(valid(other));
  if constexpr (!ScalarTraits<S>::is_fixed) {
    const float nan = std::numeric_limits<float>::quiet_NaN();
    EXPECT_FALSE(valid(Blend::of(nan, half, 0)));
    EXPECT_FALSE(valid(Blend::of(half, half, nan)));
  }
}

}  // namespace
