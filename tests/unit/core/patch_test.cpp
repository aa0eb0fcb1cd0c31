// I-patches: the reference's values and partial derivatives, bounds that vanish, contact along the sides,
// weights.
#include "algebraic_samples.hpp"

#include <nearfield/curve/patch_weights.hpp>
#include <reference/implicit_patches.hpp>

namespace {

using namespace nearfield;
using namespace nearfield::test;
using reference::announced_seed;

template <class S>
class PatchOf : public testing::Test {};
TYPED_TEST_SUITE(PatchOf, AllScalars, );

// A patch's parameters, its operands by meaning, and both patches in their order of operands.
template <class S>
struct RandomPatch {
  reference::PatchCoefficients weights;
  std::vector<Sample<S>> primaries, bounds;

  std::vector<Real> primary_values() const { return values(primaries); }
  std::vector<Real> bound_values() const { return values(bounds); }
  template <class Patch>
  Patch as() const {
    Patch patch;
    patch.side_count = static_cast<uint32_t>(bounds.size());
    patch.exponent = static_cast<uint32_t>(weights.exponent);
    for (size_t i = 0; i < bounds.size(); ++i) patch.side_weight[i] = number<S>(weights.side[i]);
    patch.centre_weight = number<S>(weights.bound);
    return patch;
  }
  template <class Out>
  Out ribbon() const {
    std::vector<Out> of;
    for (size_t i = 0; i < bounds.size(); ++i) {
      of.push_back(part<Out>(primaries[i]));
      of.push_back(part<Out>(bounds[i]));
    }
    return as<RibbonPatch<S>>().template combine_all<Out>(of.data());
  }
  template <class Out>
  Out corner() const {
    std::vector<Out> of;
    for (const auto& primary : primaries) of.push_back(part<Out>(primary));
    for (const auto& bound : bounds) of.push_back(part<Out>(bound));
    return as<CornerPatch<S>>().template combine_all<Out>(of.data());
  }

 private:
  static std::vector<Real> values(const std::vector<Sample<S>>& samples) {
    std::vector<Real> reals;
    for (const auto& one : samples) reals.push_back(real(one.value));
    return reals;
  }
  template <class Out>
  static Out part(const Sample<S>& whole) {
    if constexpr (Out::has_gradient)
      return whole;
    else
      return {whole.value};
  }
};

// Bounds of all sizes and zeros among them; weights are numbers of S.
template <class S>
RandomPatch<S> random_patch(Random& random, int64_t fewest_sides, Real zero_share) {
  RandomPatch<S> patch;
  const int64_t sides = random.integer(fewest_sides, 8);
  patch.weights.exponent = static_cast<int>(random.integer(2, 3));
  patch.weights.bound = real(number<S>(random.uniform(-1, 1)));
  for (int64_t i = 0; i < sides; ++i) {
    patch.weights.side.push_back(real(number<S>(random.chance(0.3L) ? Real{1} : random.uniform(-1, 1))));
    patch.primaries.push_back(sample<S>(random, 1.5L, 0.125L));
    Sample<S> bound = sample<S>(random, 1.5L, 0.125L);
    if (random.chance(0.3L)) {
      const int halvings = static_cast<int>(random.integer(3, 12));
      bound.value = number<S>(std::ldexp(random.uniform(-1, 1), -halvings));
    }
    if (random.chance(zero_share)) bound.value = S{};
    patch.bounds.push_back(bound);
  }
  return patch;
}

// What the value may be off by: units for the means and the weights, and those of a float's terms.
template <class S>
Real value_tolerance() {
  return ScalarTraits<S>::is_fixed ? 3 * unit<S>(1) : 6 * unit<S>(1);
}

struct PatchRatios {
  Ratio value, gradient;
  int gradients = 0;

  template <class S>
  void look(const Sample<S>& got, const RandomPatch<S>& patch, const reference::PatchPoint& expected) {
    value.see(std::fabs(real(got.value) - expected.value), value_tolerance<S>());
    // Slopes by bounds carry the value's rounding divided by the bound, and all of it is relative to what
    // cancels.
    const Vec3 exact =
        chained(patch.primaries, expected.by_primaries) + chained(patch.bounds, expected.by_bounds);
    Real allowed = 3 * unit<S>(1), size = 0;
    for (size_t i = 0; i < patch.bounds.size(); ++i) {
      const Real bound = std::fabs(real(patch.bounds[i].value));
      const Real slope = greatest_component(real(patch.bounds[i].gradient));
      if (bound > 0) allowed += 4 * unit<S>(1) * slope / bound;
      size += slope * std::fabs(expected.by_bounds[i]);
    }
    allowed += size * std::ldexp(Real{1}, ScalarTraits<S>::is_fixed ? -28 : -21);
    if (greatest_component(exact) > 0.9L * real(algebraic_limit<S>())) return;
    gradient.see(greatest_component(real(got.gradient) - exact), allowed);
    ++gradients;
  }
  void expect_bounds(const char* name) const {
    std::printf("%s: value %.3Lf, gradient %.3Lf of what is allowed\n", name, value.greatest(),
                gradient.greatest());
    EXPECT_LE(value.greatest(), 1);
    EXPECT_LE(gradient.greatest(), 1);
    EXPECT_GT(gradients, 1000);
  }
};

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

// Bounds x, y, z and cylinders about the axes: weights 1/2, 1/2, 1/2 and 3/2 make it (|p|^2 - 1) / 2, and the
// sphere's gradient, where bounds vanish too.
TYPED_TEST(PatchOf, ThreeCylindersMakeASphere) {
  using S = TypeParam;
  const S one = number<S>(1), half = number<S>(0.5L);
  const Quadric<S> about_x = {{{}, one, one}, {}, {}, S{} - one};
  const Quadric<S> about_y = {{one, {}, one}, {}, {}, S{} - one};
  const Quadric<S> about_z = {{one, one, {}}, {}, {}, S{} - one};
  const AlgebraicPlane<S> x = {{one, {}, {}}, {}}, y = {{{}, one, {}}, {}}, z = {{{}, {}, one}, {}};
  RibbonPatch<S> patch;
  patch.side_count = 3;
  for (int i = 0; i < 3; ++i) patch.side_weight[i] = half;
  patch.centre_weight = one + half;
  const auto sphere = Field(combine(patch, about_x, x, about_y, y, about_z, z));
  ASSERT_TRUE(sphere.valid());
  const auto expect_sphere = [&](const Vec3& at) {
    const Vector3<S> p = vector<S>(at);
    const Sample<S> got = sphere.template evaluate<Sample<S>>(p, nullptr);
    ASSERT_LE(std::fabs(real(got.value) - (squared_norm(real(p)) - 1) / 2), 4 * unit<S>(2));
    ASSERT_LE(greatest_component(real(got.gradient) - real(p) / 16), 6 * unit<S>(1));
  };
  for (int i = -6; i <= 6; ++i) {
    for (int j = -6; j <= 6; ++j) {
      for (int k = -6; k <= 6; ++k) expect_sphere({0.25L * i, 0.25L * j, 0.25L * k});
    }
  }
  Random random(announced_seed("ThreeCylindersMakeASphere", 62));
  for (int i = 0; i < 3000; ++i) {
    Vec3 p = random.vector(-1.5L, 1.5L);
    // Next to the coordinate planes and axes as well.
    if (random.chance(0.3L)) p.x = std::ldexp(p.x, -static_cast<int>(random.integer(3, 9)));
    if (random.chance(0.3L)) p.y = std::ldexp(p.y, -static_cast<int>(random.integer(3, 9)));
    const Vector3<S> rounded = vector<S>(p);
    const Sample<S> got = sphere.template evaluate<Sample<S>>(rounded, nullptr);
    ASSERT_LE(std::fabs(real(got.value) - (squared_norm(real(rounded)) - 1) / 2), 4 * unit<S>(2));
    const Real nearest = std::min({std::fabs(p.x), std::fabs(p.y), std::fabs(p.z)});
    ASSERT_LE(greatest_component(real(got.gradient) - real(rounded) / 16), (6 + 4 / nearest) * unit<S>(1));
  }
}

// All combinations of vanishing, tiny, ordinary and the greatest values: results in range, within the
// primaries' hull when no weight adds to it.
TYPED_TEST(PatchOf, NothingIsUndefined) {
  using S = TypeParam;
  const S limit = algebraic_limit<S>(),
          tiny = ScalarTraits<S>::is_fixed ? number<S>(unit<S>(1)) : number<S>(1e-41L);
  const std::vector<S> ends = {S{}, tiny, S{} - tiny, number<S>(-1), number<S>(0.25L), limit, S{} - limit};
  const S least = ScalarTraits<S>::is_fixed ? ScalarTraits<S>::least() : S{} - limit;
  const auto in_range = [&](S x) { return x >= least && x <= limit; };
  const size_t choices = ends.size();
  for (const uint32_t exponent : {2u, 3u}) {
    for (const S centre : {S{}, number<S>(-1.5L), ScalarTraits<S>::domain()}) {
      for (size_t code = 0; code < choices * choices * choices * choices; ++code) {
        RandomPatch<S> patch;
        patch.weights = {{1, 1, 1}, real(centre), static_cast<int>(exponent)};
        size_t rest = code;
        for (int i = 0; i < 3; ++i) {
          const S bound = ends[rest % choices];
          rest /= choices;
          patch.bounds.push_back({bound, {limit, number<S>(-0.0625L), {}}});
        }
        const S first = ends[rest];
        patch.primaries = {
            {first, {limit, {}, limit}}, {number<S>(0.5L), {S{} - limit, {}, {}}}, {S{}, {{}, limit, {}}}};
        const S low = least_of_two(first, S{}), high = greatest_of_two(first, number<S>(0.5L));
        const Sample<S> ribbon = patch.template ribbon<Sample<S>>(),
                        corner = patch.template corner<Sample<S>>();
        for (const Sample<S>& got : {ribbon, corner}) {
          ASSERT_TRUE(in_range(got.value) && in_range(got.gradient.x) && in_range(got.gradient.y) &&
                      in_range(got.gradient.z));
        }
        if (centre != S{}) continue;
        const Real slack = 2 * unit<S>(std::max(std::fabs(real(low)), std::fabs(real(high))));
        ASSERT_GE(real(ribbon.value), real(low) - slack);
        ASSERT_LE(real(ribbon.value), real(high) + slack);
      }
    }
  }
}

// A patch of three sides between quadrics, its bounds three planes of a prism, at a point.
struct Prism {
  std::vector<RealQuadric> ribbons;
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

// On a bound a patch has its ribbon's value and gradient; the difference from it closes as the power of the
// exponent, so that with 3 the curvatures agree and with 2 they need not.
TYPED_TEST(PatchOf, ContactAlongARibbon) {
  using S = TypeParam;
  Random random(announced_seed("ContactAlongARibbon", 63));
  Ratio second_of_two, second_of_three;
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
        // The normal: the ribbon's, to rounding, at the bound and next to it.
        const Real allowed = 3 * unit<S>(1) + 200 * from_bound;
        EXPECT_LE(greatest_component(real(got.gradient) - weight * real(ribbon.gradient)), allowed);
      }
      const auto difference_at = [&](Real distance) {
        const RandomPatch<S> patch = prism.at<S>(p + distance * prism.bounds[side].normal, exponent, 0.5L);
        return real(patch.template ribbon<Value<S>>().value) - weight * real(patch.primaries[side].value);
      };
      // Second differences of the patch less its ribbon, of a step wide enough for the rounding.
      const Real step = std::cbrt(64 * unit<S>(1));
      const Real second = (difference_at(step) + difference_at(-step) - 2 * difference_at(0)) / (step * step);
      (exponent == 2 ? second_of_two : second_of_three).see(std::fabs(second), 1);
      EXPECT_LE(std::fabs(second), exponent == 2 ? 200 : 1200 * step);
    }
  }
  std::printf("greatest difference of curvatures: exponent 2: %.4Lf, exponent 3: %.4Lf\n",
              second_of_two.greatest(), second_of_three.greatest());
  EXPECT_GT(second_of_two.greatest(), 1);
  const Real share = unit<S>(1) < 1e-6L ? 0.1L : 1;  // coarse numbers need wide steps
  EXPECT_LT(second_of_three.greatest(), share * second_of_two.greatest());
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
