// I-patches: the reference's values and partial derivatives, bounds that vanish, contact along the sides,
// weights.
#include "patch_samples.hpp"

#include <nearfield/curve/patch_weights.hpp>

namespace {

using namespace nearfield;
using namespace nearfield::test;
using reference::announced_seed;

template <class S>
class PatchOf : public testing::Test {};
TYPED_TEST_SUITE(PatchOf, AllScalars, );

// Reads a wide number back: how often it makes up a large one.
template <class S>
Real size_of(const WideRange<S>& x) {
  if constexpr (ScalarTraits<S>::is_fixed)
    return std::ldexp(static_cast<Real>(x.times(1u << 20, 0)), -20);
  else
    return static_cast<Real>(x.number());
}

TYPED_TEST(PatchOf, WideNumbersAreExactEnough) {
  using S = TypeParam;
  Random random(announced_seed("WideNumbersAreExactEnough", 67));
  constexpr bool is_fixed = ScalarTraits<S>::is_fixed;
  const Real precision = std::ldexp(Real{1}, is_fixed ? -30 : -23);
  const auto expect_size = [&](const WideRange<S>& got, Real exact, int roundings) {
    const Real reading = is_fixed ? std::ldexp(Real{1}, -21) : 0;
    ASSERT_LE(std::fabs(size_of(got) - exact), exact * precision * roundings + reading);
  };
  for (int i = 0; i < 2000; ++i) {
    const int halvings = static_cast<int>(random.integer(0, 9));
    const S x = number<S>(std::ldexp(random.uniform(-4, 4), -halvings)), y = number<S>(random.uniform(-4, 4));
    if (x == S{} || y == S{}) continue;
    const Real exact_x = std::fabs(real(x)), exact_y = std::fabs(real(y));
    const auto wide_x = WideRange<S>::magnitude_of(x), wide_y = WideRange<S>::magnitude_of(y);
    expect_size(wide_x, exact_x, 0);
    expect_size(wide_x * wide_y, exact_x * exact_y, 1);
    expect_size(wide_x.reciprocal(), 1 / exact_x, 1);
    expect_size(wide_x * wide_y.reciprocal() * wide_x, exact_x * exact_x / exact_y, 3);
    EXPECT_EQ(wide_x < wide_y, exact_x < exact_y);
    WideSum<S> sum;
    sum.add(wide_x, y, x);
    sum.add(SignedWide<S>{wide_y, true}, x);
    const Real exact = exact_x * (real(y) - real(x)) - exact_y * real(x);
    if (std::fabs(exact) > 15) continue;
    ASSERT_LE(std::fabs(real(sum.result()) - exact), unit<S>(64));
    const SignedWide<S> tripled = sum.times(WideRange<S>::whole(3));
    EXPECT_TRUE(std::fabs(exact) < 0.01L || tripled.negative == (exact < 0));
    ASSERT_LE(std::fabs(size_of(tripled.size) - 3 * std::fabs(exact)), unit<S>(256) + 1e-6L);
  }
  const WideRange<S> none;
  EXPECT_TRUE(none.is_zero() && (none * WideRange<S>::whole(3)).is_zero() && none.reciprocal().is_zero());
  EXPECT_TRUE(none < WideRange<S>::whole(1));
  EXPECT_FALSE(WideRange<S>::whole(1) < none);
}

TYPED_TEST(PatchOf, AreTheReference) {
  using S = TypeParam;
  Random random(announced_seed("AreTheReference", 61));
  PatchRatios ribbons, corners;
  for (int i = 0; i < 3000; ++i) {
    const Real zero_share = random.chance(0.5L) ? 0 : random.uniform(0, 0.6L);
    const RandomPatch<S> ribbon = random_patch<S>(random, 2, zero_share);
    const Sample<S> of_ribbons = ribbon.template ribbon<Sample<S>>();
    ribbons.look(of_ribbons, ribbon,
                 reference::ribbon_patch(ribbon.weights, ribbon.primary_values(), ribbon.bound_values()));
    ASSERT_EQ(of_ribbons.value, ribbon.template ribbon<Value<S>>().value);
    const RandomPatch<S> corner = random_patch<S>(random, 3, zero_share);
    const Sample<S> of_corners = corner.template corner<Sample<S>>();
    corners.look(of_corners, corner,
                 reference::corner_patch(corner.weights, corner.primary_values(), corner.bound_values()));
    ASSERT_EQ(of_corners.value, corner.template corner<Value<S>>().value);
  }
  ribbons.expect_bounds("ribbons");
  corners.expect_bounds("corners");
}

// A patch of three sides between quadrics, its bounds three planes of a prism, at a point.
struct Prism {
  std::vector<ExactQuadric> ribbons;
  std::vector<RealPlane> bounds;

  explicit Prism(Random& random) {
    for (int i = 0; i < 3; ++i) {
      const Real angle = 2 * reference::pi * static_cast<Real>(i) / 3;
      bounds.push_back({{std::cos(angle), std::sin(angle), 0.1L}, -0.5L});
      ribbons.push_back(random_quadric(random));
    }
  }
  template <class S>
  RandomPatch<S> at(const Vec3& p, int exponent, Real centre) const {
    RandomPatch<S> patch;
    patch.weights = {{0.5L, 0.75L, 1}, centre, exponent};
    for (size_t i = 0; i < 3; ++i) {
      patch.primaries.push_back({number<S>(ribbons[i].value(p)), vector<S>(ribbons[i].gradient(p))});
      patch.bounds.push_back({number<S>(bounds[i].value(p)), vector<S>(bounds[i].gradient(p))});
    }
    return patch;
  }
  // A point on a bound, as far from the others as 0.3.
  Vec3 on_bound(size_t side, Random& random) const {
    for (;;) {
      Vec3 p = random.vector(-0.8L, 0.8L);
      p = p - (bounds[side].value(p) / squared_norm(bounds[side].normal)) * bounds[side].normal;
      if (bounds[(side + 1) % 3].value(p) > 0.3L && bounds[(side + 2) % 3].value(p) > 0.3L) return p;
    }
  }
};

// On a bound and next to it a patch has its ribbon's value and normal; how they part: patch_contact_test.cpp.
TYPED_TEST(PatchOf, ARibbonIsMetAtItsBound) {
  using S = TypeParam;
  Random random(announced_seed("ARibbonIsMetAtItsBound", 63));
  for (int i = 0; i < 60; ++i) {
    const Prism prism(random);
    const auto side = static_cast<size_t>(random.integer(0, 2));
    const Vec3 p = prism.on_bound(side, random);
    for (const int exponent : {2, 3}) {
      RandomPatch<S> at_bound = prism.at<S>(p, exponent, 0.5L);
      const Real weight = at_bound.weights.side[side];
      for (const Real from_bound : {Real{0}, unit<S>(1), 256 * unit<S>(1)}) {
        at_bound.bounds[side].value = number<S>(from_bound);
        const Sample<S> got = at_bound.template ribbon<Sample<S>>();
        const Sample<S>& ribbon = at_bound.primaries[side];
        EXPECT_LE(std::fabs(real(got.value) - weight * real(ribbon.value)),
                  3 * unit<S>(1) + 50 * from_bound * from_bound);
        const Real allowed = 3 * unit<S>(1) + 200 * from_bound;
        EXPECT_LE(greatest_component(real(got.gradient) - weight * real(ribbon.gradient)), allowed);
      }
    }
  }
}

// With corners, a side has the two-sided patch of its ends: value and gradient, the bound's own part left
// out.
TYPED_TEST(PatchOf, CornersOnASideAreTheTwoSidedPatch) {
  using S = TypeParam;
  Random random(announced_seed("CornersOnASideAreTheTwoSidedPatch", 64));
  for (int i = 0; i < 500; ++i) {
    RandomPatch<S> patch = random_patch<S>(random, 3, 0);
    const size_t n = patch.bounds.size(),
                 side = static_cast<size_t>(random.integer(0, static_cast<int64_t>(n) - 1));
    const size_t before = (side + n - 1) % n, after = (side + 1) % n;
    for (Sample<S>& bound : patch.bounds) bound.value = number<S>(random.uniform(0.2L, 1));
    patch.bounds[side] = {S{}, {}};
    const auto power = [&](size_t k) {
      return std::pow(real(patch.bounds[k].value), static_cast<Real>(patch.weights.exponent));
    };
    const Real b = power(before), a = power(after);
    const Real expected = (real(patch.primaries[before].value) * a + real(patch.primaries[side].value) * b +
                           patch.weights.side[side] * a * b) /
                          (a + b);
    ASSERT_LE(std::fabs(real(patch.template corner<Value<S>>().value) - expected), 4 * unit<S>(2));
  }
}

TEST(PatchWeights, AreTheReferenceAndLeadThroughThePoint) {
  using S = Fixed<24>;
  Random random(announced_seed("AreTheReferenceAndLeadThroughThePoint", 65));
  for (int i = 0; i < 500; ++i) {
    RandomPatch<S> patch = random_patch<S>(random, 3, 0);
    std::vector<double> weights, primaries, bounds;
    std::vector<reference::PatchSample> exact;
    const size_t n = patch.bounds.size(), count = random.chance(0.5L) ? 1 : 3;
    for (const Real weight : patch.weights.side) weights.push_back(static_cast<double>(weight));
    for (size_t k = 0; k < count; ++k) {
      exact.push_back({});
      for (size_t side = 0; side < n; ++side) {
        primaries.push_back(static_cast<double>(random.uniform(-0.5L, 0.5L)));
        bounds.push_back(static_cast<double>(random.uniform(0.3L, 0.9L)));
        exact.back().primaries.push_back(static_cast<Real>(primaries.back()));
        exact.back().bounds.push_back(static_cast<Real>(bounds.back()));
      }
    }
    std::vector<nearfield::PatchSample> samples;
    for (size_t k = 0; k < count; ++k) samples.push_back({primaries.data() + k * n, bounds.data() + k * n});
    const int sides = static_cast<int>(n), exponent = patch.weights.exponent;
    const PatchWeight ribbons =
        ribbon_centre_weight(sides, exponent, weights.data(), samples.data(), static_cast<int>(count));
    const PatchWeight corners =
        corner_centre_weight(sides, exponent, weights.data(), samples.data(), static_cast<int>(count));
    ASSERT_TRUE(ribbons.valid && corners.valid);
    const auto relative = [](double got, Real expected) {
      return std::fabs(static_cast<Real>(got) - expected) / std::max(Real{1}, std::fabs(expected));
    };
    ASSERT_LE(
        relative(ribbons.value, centred_bound_coefficient(reference::ribbon_patch, patch.weights, exact)),
        1e-12L);
    ASSERT_LE(
        relative(corners.value, centred_bound_coefficient(reference::corner_patch, patch.weights, exact)),
        1e-12L);
    if (count > 1 || std::fabs(ribbons.value) > 30) continue;
    // Evaluated, the patch vanishes at the point.
    for (size_t side = 0; side < n; ++side) {
      patch.primaries[side].value = S(primaries[side]);
      patch.bounds[side].value = S(bounds[side]);
    }
    patch.weights.bound = static_cast<Real>(ribbons.value);
    ASSERT_LE(std::fabs(real(patch.ribbon<Value<S>>().value)), 1e-5L);
  }
  const PatchWeight side = side_weight(3, 0.25, -0.5, 0.5, 0.75);
  EXPECT_TRUE(side.valid);
  EXPECT_LE(std::fabs(static_cast<Real>(side.value) -
                      reference::side_coefficient_through(0.25L, -0.5L, 0.5L, 0.75L, 3)),
            1e-12L);
  EXPECT_FALSE(side_weight(2, 0.25, 0.25, 0.0, 1.0).valid);
  const double ones[3] = {1, 1, 1}, on_a_bound[3] = {0, 1, 1};
  const nearfield::PatchSample lost = {ones, on_a_bound};
  EXPECT_FALSE(ribbon_centre_weight(3, 2, ones, &lost, 1).valid);
}

// |p|^2 - 1 passes through (1, 1, 1) / sqrt(3) by its centre's weight.
constexpr double kThird = 1.0 / 3.0, kRootOfThird = 0.57735026918962576;
constexpr double kCylinders[3] = {2 * kThird - 1, 2 * kThird - 1, 2 * kThird - 1}, kOnes[3] = {1, 1, 1};
constexpr double kPlanes[3] = {kRootOfThird, kRootOfThird, kRootOfThird};
constexpr nearfield::PatchSample kPoint = {kCylinders, kPlanes};
constexpr PatchWeight kSphere = ribbon_centre_weight(3, 2, kOnes, &kPoint, 1);
static_assert(kSphere.valid && kSphere.value > 2.999999 && kSphere.value < 3.000001,
              "weights are found by the compiler");

TYPED_TEST(PatchOf, CertificatesBoundTheValue) {
  using S = TypeParam;
  Random random(announced_seed("CertificatesBoundTheValue", 66));
  Ratio ribbons, corners;
  for (int i = 0; i < 2000; ++i) {
    const RandomPatch<S> patch = random_patch<S>(random, 3, 0.1L);
    const size_t n = patch.bounds.size();
    std::vector<Certificate<S>> by_side(2 * n), by_kind(2 * n);
    for (size_t k = 0; k < n; ++k) {
      Certificate<S> primary, bound;
      primary.valid = bound.valid = true;
      primary.magnitude = absolute(patch.primaries[k].value);
      bound.magnitude = absolute(patch.bounds[k].value);
      by_side[2 * k] = by_kind[k] = primary;
      by_side[2 * k + 1] = by_kind[n + k] = bound;
    }
    const Certificate<S> ribbon = patch.template as<RibbonPatch<S>>().certificate(by_side.data(), {}, {});
    const Certificate<S> corner = patch.template as<CornerPatch<S>>().certificate(by_kind.data(), {}, {});
    ASSERT_TRUE(ribbon.valid && corner.valid);
    ASSERT_EQ(ribbon.lipschitz, kNoRateBound);
    ASSERT_EQ(corner.lipschitz, kNoRateBound);
    ribbons.see(std::fabs(real(patch.template ribbon<Value<S>>().value)), real(ribbon.magnitude));
    corners.see(std::fabs(real(patch.template corner<Value<S>>().value)), real(corner.magnitude));
  }
  EXPECT_LE(ribbons.greatest(), 1);
  EXPECT_LE(corners.greatest(), 1);
  EXPECT_GT(ribbons.greatest(), 0.9L);
}

TYPED_TEST(PatchOf, ParametersOutOfRangeAreRefused) {
  using S = TypeParam;
  Certificate<S> good;
  good.valid = true;
  good.magnitude = number<S>(1);
  std::vector<Certificate<S>> of(16, good);
  const auto check = [&](auto patch, uint32_t fewest) {
    using Patch = decltype(patch);
    const auto valid = [&](const Patch& it) { return it.certificate(of.data(), {}, {}).valid; };
    const auto changed = [&](const auto& change) {
      Patch other = patch;
      change(other);
      return valid(other);
    };
    patch.side_count = 5;
    for (int i = 0; i < 5; ++i) patch.side_weight[i] = number<S>(1);
    EXPECT_TRUE(valid(patch));
    EXPECT_EQ(patch.operand_count(), 10);
    Patch smallest;
    smallest.side_count = fewest;
    EXPECT_TRUE(valid(smallest));
    smallest.side_count = fewest - 1;
    EXPECT_FALSE(valid(smallest));
    EXPECT_FALSE(changed([](Patch& it) { it.side_count = 9; }));
    EXPECT_FALSE(changed([](Patch& it) { it.side_count = 4; })) << "a weight of no side";
    EXPECT_FALSE(changed([](Patch& it) { it.exponent = 1; }));
    EXPECT_FALSE(changed([](Patch& it) { it.exponent = 4; }));
    EXPECT_FALSE(changed([](Patch& it) { it.side_weight[2] = ScalarTraits<S>::domain() + number<S>(1); }));
    EXPECT_FALSE(
        changed([](Patch& it) { it.centre_weight = S{} - ScalarTraits<S>::domain() - number<S>(1); }));
    Patch absurd = patch;
    absurd.side_count = 0x80000003u;
    EXPECT_EQ(absurd.operand_count(), 0);
    of[9].valid = false;
    EXPECT_FALSE(valid(patch));
    of[9].valid = true;
  };
  check(RibbonPatch<S>{}, 2);
  check(CornerPatch<S>{}, 3);
}

}  // namespace
