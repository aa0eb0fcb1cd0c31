// I-patches where bounds vanish, alone and together: every value and gradient is defined, and the limit.
#include "patch_samples.hpp"

namespace {

using namespace nearfield;
using namespace nearfield::test;
using reference::announced_seed;

template <class S>
class DegeneratePatchOf : public testing::Test {};
TYPED_TEST_SUITE(DegeneratePatchOf, AllScalars, );

// What the value of a patch may be off by, primaries' and weights' own rounding apart: RibbonPatch's and
// CornerPatch's contract. `spread`: the greatest difference between primaries, `term` the greatest term.
template <class S>
Real stated_error(Real spread, Real term) {
  if constexpr (ScalarTraits<S>::is_fixed) return unit<S>(1) + std::ldexp(spread, -28);
  else return 6 * unit<S>(term);
}

// Fields made of quadrics that are (|p|^2 - 1) / 2 on paper, at points in all eight octants, on all axes and
// planes and next to them.
template <class S, class Sphere>
void expect_sphere(const Sphere& sphere, const char* name, Random& random) {
  Ratio value, gradient;
  const Real u = unit<S>(1);
  const auto look = [&](const Vec3& at) {
    const Vector3<S> rounded = vector<S>(at);
    const Vec3 p = real(rounded);
    const Sample<S> got = sphere.template evaluate<Sample<S>>(rounded, nullptr);
    ASSERT_EQ(got.value, sphere.template evaluate<Value<S>>(rounded, nullptr).value);
    const Real square = squared_norm(p), radius = std::sqrt(square), term = (square + 1) / 2;
    // Of the quadrics, halved, and rounding the halves: 0.9 R + 0.5 units.
    const Real leaves = ScalarTraits<S>::is_fixed ? (0.45L * radius + 0.75L) * u : 2 * unit<S>(term);
    value.see(std::fabs(real(got.value) - (square - 1) / 2), leaves + stated_error<S>(square, term));
    // Rounding of the primaries is divided by the bounds that are neither 0 nor alone.
    Real sum = 0, conditioned = 0;
    for (const Real b : {p.x, p.y, p.z}) sum += b != 0 ? 1 / (b * b) : 0;
    for (const Real b : {p.x, p.y, p.z}) {
      const Real share = b != 0 ? 1 / (b * b) / sum : 0;
      if (b != 0) conditioned += share * (1 - share) / std::fabs(b);
    }
    gradient.see(greatest_component(real(got.gradient) - p / 16), (2 + conditioned) * u);
  };
  for (int i = -6; i <= 6; ++i) {
    for (int j = -6; j <= 6; ++j) {
      for (int k = -6; k <= 6; ++k) {
        const Vec3 p{0.25L * i, 0.25L * j, 0.25L * k};
        look(p);
        if (i == 0) look({u, p.y, p.z});
        if (j == 0) look({p.x, -16 * u, p.z});
        if (i == 0 && k == 0) look({-u, p.y, u});
      }
    }
  }
  for (int i = 0; i < 3000; ++i) {
    Vec3 p = random.vector(-1.5L, 1.5L);
    if (random.chance(0.3L)) p.x = std::ldexp(p.x, -static_cast<int>(random.integer(3, 9)));
    if (random.chance(0.3L)) p.y = std::ldexp(p.y, -static_cast<int>(random.integer(3, 9)));
    look(p);
  }
  std::printf("%s: value %.3Lf, gradient %.3Lf of what is stated\n", name, value.greatest(),
              gradient.greatest());
  EXPECT_LE(value.greatest(), 1) << name;
  EXPECT_LE(gradient.greatest(), 1) << name;
}

template <class S>
Quadric<S> square_less_one(Real x, Real y, Real z, Real scale) {
  Quadric<S> quadric;
  quadric.diagonal = vector<S>(scale * Vec3{x, y, z});
  quadric.constant = number<S>(-scale);
  return quadric;
}

// Bounds x, y, z. By ribbons: cylinders about the axes, weights 1/2, 1/2, 1/2 and 3/2. By corners: pairs of
// planes across the axes, z^2 - 1 at the corner of x and y, weights 1, 1, 1 and 0, all of it halved.
TYPED_TEST(DegeneratePatchOf, ThreeCylindersOrThreePairsOfPlanesMakeASphere) {
  using S = TypeParam;
  Random random(announced_seed("ThreeCylindersOrThreePairsOfPlanesMakeASphere", 62));
  const S one = number<S>(1), half = number<S>(0.5L);
  const AlgebraicPlane<S> x = {{one, {}, {}}, {}}, y = {{{}, one, {}}, {}}, z = {{{}, {}, one}, {}};
  RibbonPatch<S> ribbons;
  ribbons.side_count = 3;
  for (int i = 0; i < 3; ++i) ribbons.side_weight[i] = half;
  ribbons.centre_weight = one + half;
  const auto of_cylinders =
      Field(combine(ribbons, square_less_one<S>(0, 1, 1, 1), x, square_less_one<S>(1, 0, 1, 1), y,
                    square_less_one<S>(1, 1, 0, 1), z));
  ASSERT_TRUE(of_cylinders.valid());
  expect_sphere<S>(of_cylinders, "cylinders as ribbons", random);
  CornerPatch<S> corners;
  corners.side_count = 3;
  for (int i = 0; i < 3; ++i) corners.side_weight[i] = one;
  const auto of_planes =
      Field(combine(corners, square_less_one<S>(0, 0, 1, 0.5L), square_less_one<S>(1, 0, 0, 0.5L),
                    square_less_one<S>(0, 1, 0, 0.5L), x, y, z));
  ASSERT_TRUE(of_planes.valid());
  expect_sphere<S>(of_planes, "planes at corners", random);
}

// Planes as bounds, all through one point or not, so that any number of them vanish together; primaries that
// fall short of |p|^2 - 1 by multiples of the bounds' powers, which the weights make up for: the patch is
// |p|^2 - 1 everywhere.
struct SphereOfSides {
  static constexpr int directions[8][3] = {{1, 0, 0}, {0, 1, 0}, {0, 0, 1},  {1, 1, 0},
                                           {1, -1, 0}, {0, 1, 1}, {1, 0, -1}, {1, 1, 1}};
  size_t count;
  int exponent;
  bool by_corners, apart;

  Vec3 normal(size_t i) const {
    const auto& d = directions[i];
    return {static_cast<Real>(d[0]), static_cast<Real>(d[1]), static_cast<Real>(d[2])};
  }
  Real bound(size_t i, const Vec3& p) const { return dot(normal(i), p) - (apart && i % 2 == 1 ? 0.5L : 0); }
  // |B|^exponent and its gradient.
  Real power(size_t i, const Vec3& p) const {
    return std::pow(std::fabs(bound(i, p)), static_cast<Real>(exponent));
  }
  Vec3 slope(size_t i, const Vec3& p) const {
    const Real b = bound(i, p), less = exponent == 2 ? 1 : std::fabs(b);
    return static_cast<Real>(exponent) * less * b * normal(i);
  }
  Real of_one() const { return by_corners ? 0.0625L : 0.125L; }
  Real of_two() const { return exponent == 2 ? 1 / 64.0L : 1 / 1024.0L; }

  template <class S>
  RandomPatch<S> at(const Vec3& p) const {
    RandomPatch<S> patch;
    const Real sides = static_cast<Real>(count);
    patch.weights = {std::vector<Real>(count, by_corners ? 2 * of_one() : 1),
                     sides * (by_corners ? of_two() : of_one()), exponent};
    for (size_t i = 0; i < count; ++i) {
      const size_t next = i + 1 < count ? i + 1 : 0;
      Real value = squared_norm(p) - 1 - of_one() * power(i, p);
      Vec3 gradient = 2 * p - of_one() * slope(i, p);
      if (by_corners) {
        value = value - of_one() * power(next, p) - of_two() * power(i, p) * power(next, p);
        gradient = gradient - (of_one() + of_two() * power(i, p)) * slope(next, p) -
                   of_two() * power(next, p) * slope(i, p);
      }
      patch.primaries.push_back({number<S>(value), vector<S>(gradient / 16)});
      patch.bounds.push_back({number<S>(bound(i, p)), vector<S>(normal(i) / 16)});
    }
    return patch;
  }
  // How much more than once gradients carry the primaries' rounding: what each bound moves of the shares,
  // divided by it.
  Real conditioned(const std::vector<Real>& bounds) const {
    size_t zeros = 0;
    const auto reciprocal = [&](size_t i) {
      return std::pow(std::fabs(bounds[i]), -static_cast<Real>(exponent));
    };
    std::vector<Real> shares;
    std::vector<size_t> vanishing;
    Real sum = 0;
    for (size_t k = 0; k < count; ++k) {
      const size_t next = k + 1 < count ? k + 1 : 0;
      size_t of_this = bounds[k] == 0;
      Real share = bounds[k] == 0 ? 1 : reciprocal(k);
      if (by_corners) {
        of_this += bounds[next] == 0;
        share *= bounds[next] == 0 ? 1 : reciprocal(next);
      }
      zeros = std::max(zeros, of_this);
      shares.push_back(share);
      vanishing.push_back(of_this);
    }
    for (size_t k = 0; k < count; ++k) sum += vanishing[k] == zeros ? shares[k] : 0;
    const auto share_of = [&](size_t k) { return vanishing[k] == zeros ? shares[k] / sum : 0; };
    Real total = 0;
    for (size_t i = 0; i < count; ++i) {
      if (bounds[i] == 0) continue;
      const Real moved = share_of(i) + (by_corners ? share_of(i > 0 ? i - 1 : count - 1) : 0);
      total += std::min(moved, 8 * std::max(1 - moved, Real{0})) / std::fabs(bounds[i]);
    }
    return total * static_cast<Real>(exponent);
  }
};

// What is seen of such patches.
struct SphereLook {
  Ratio value, gradient;
  int together = 0, steep = 0, looks = 0;

  template <class S>
  void at(const SphereOfSides& sphere, const Vec3& p) {
    const RandomPatch<S> patch = sphere.at<S>(p);
    const Sample<S> got =
        sphere.by_corners ? patch.template corner<Sample<S>>() : patch.template ribbon<Sample<S>>();
    const Real exact = squared_norm(p) - 1;
    Real spread = 0;
    for (const Real primary : patch.primary_values()) spread = std::max(spread, std::fabs(primary - exact));
    const std::vector<Real> bounds = patch.bound_values();
    ++looks;
    together += std::count(bounds.begin(), bounds.end(), 0) >= 2;
    constexpr bool is_fixed = ScalarTraits<S>::is_fixed;
    const Real term = spread + std::fabs(exact), leaves = is_fixed ? unit<S>(1) / 2 : unit<S>(term);
    value.see(std::fabs(real(got.value) - exact), leaves + stated_error<S>(2 * spread, term));
    // Next to sides that do not meet, several bounds are tiny and what is divided by them is rounded.
    const Real carried = stated_error<S>(spread + 1, term + 1) * sphere.conditioned(bounds);
    if (carried > 1 / 64.0L) ++steep;
    else gradient.see(greatest_component(real(got.gradient) - p / 8), 2 * unit<S>(1) + carried);
  }
};

TYPED_TEST(DegeneratePatchOf, AnyNumberOfSidesMakesASphere) {
  using S = TypeParam;
  Random random(announced_seed("AnyNumberOfSidesMakesASphere", 71));
  for (const bool by_corners : {false, true}) {
    SphereLook look;
    for (int code = 0; code < 6 * 4 * 125; ++code) {
      const auto count = static_cast<size_t>(code / 500 + 3);
      const SphereOfSides sphere{count, code % 2 == 0 ? 2 : 3, by_corners, code / 2 % 2 == 1};
      const int cell = code / 4 % 125;
      const Vec3 p{0.5L * (cell % 5 - 2), 0.5L * (cell / 5 % 5 - 2), 0.5L * (cell / 25 - 2)};
      look.at<S>(sphere, p);
      look.at<S>(sphere, real(vector<S>(p + random.vector(-0.25L, 0.25L))));
      // One unit or some aside, one or more bounds are tiny.
      const Real units = random.chance(0.5L) ? 1 : 1000;
      const auto aside = [&] { return units * unit<S>(2) * static_cast<Real>(random.integer(-1, 1)); };
      look.at<S>(sphere, real(vector<S>(p + Vec3{aside(), aside(), aside()})));
    }
    std::printf("%s: value %.3Lf, gradient %.3Lf of what is allowed; ", by_corners ? "corners" : "ribbons",
                look.value.greatest(), look.gradient.greatest());
    std::printf("of %d points bounds vanish together at %d, nearly at %d\n", look.looks, look.together,
                look.steep);
    EXPECT_LE(look.value.greatest(), 1);
    EXPECT_LE(look.gradient.greatest(), 1);
    EXPECT_GT(look.together, 500);
    EXPECT_LT(look.steep, look.looks / 20);
  }
}

// All combinations of vanishing, tiny, ordinary and the greatest values: results in range, within the
// primaries' hull when no weight adds to it.
TYPED_TEST(DegeneratePatchOf, NothingIsUndefined) {
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

// Every choice of bounds that vanish, of any number of sides, gives the reference's limits.
TYPED_TEST(DegeneratePatchOf, EveryChoiceOfVanishingBoundsHasItsLimit) {
  using S = TypeParam;
  Random random(announced_seed("EveryChoiceOfVanishingBoundsHasItsLimit", 72));
  PatchRatios ribbons, corners;
  for (size_t count = 3; count <= 8; ++count) {
    for (size_t vanishing = 0; vanishing < size_t{1} << count; ++vanishing) {
      for (const int exponent : {2, 3}) {
        RandomPatch<S> patch;
        patch.weights = {std::vector<Real>(count, 0.75L), 0.5L, exponent};
        for (size_t i = 0; i < count; ++i) {
          patch.primaries.push_back(sample<S>(random, 1.5L, 0.125L));
          patch.bounds.push_back(sample<S>(random, 1.5L, 0.125L));
          if ((vanishing >> i & 1) != 0) patch.bounds.back().value = S{};
        }
        const auto primaries = patch.primary_values(), bounds = patch.bound_values();
        ribbons.look(patch.template ribbon<Sample<S>>(), patch,
                     reference::ribbon_patch(patch.weights, primaries, bounds));
        corners.look(patch.template corner<Sample<S>>(), patch,
                     reference::corner_patch(patch.weights, primaries, bounds));
      }
    }
  }
  ribbons.expect_bounds("ribbons");
  corners.expect_bounds("corners");
}

// With tiny and the greatest bounds and the steepest gradients results are in range, and lie between the
// primaries.
TYPED_TEST(DegeneratePatchOf, NothingIsUndefinedWithAnyNumberOfSides) {
  using S = TypeParam;
  Random random(announced_seed("NothingIsUndefinedWithAnyNumberOfSides", 73));
  constexpr bool is_fixed = ScalarTraits<S>::is_fixed;
  const S limit = algebraic_limit<S>(), least = is_fixed ? ScalarTraits<S>::least() : S{} - limit;
  const S tiny = is_fixed ? number<S>(unit<S>(1)) : number<S>(1e-41L);
  const S sizes[5] = {S{}, tiny, S{} - tiny, number<S>(0.25L), limit};
  const auto in_range = [&](S x) { return x >= least && x <= limit; };
  for (size_t count = 3; count <= 8; ++count) {
    for (int trial = 0; trial < 600; ++trial) {
      RandomPatch<S> patch;
      patch.weights = {std::vector<Real>(count, 1), 0, static_cast<int>(random.integer(2, 3))};
      S low = limit, high = least;
      for (size_t i = 0; i < count; ++i) {
        const S ordinary = number<S>(random.uniform(-1, 1));
        const S value = random.chance(0.1L) ? limit : random.chance(0.1L) ? least : ordinary;
        low = least_of_two(low, value);
        high = greatest_of_two(high, value);
        patch.primaries.push_back({value, {limit, least, number<S>(0.0625L)}});
        patch.bounds.push_back({sizes[random.integer(0, 4)], {least, limit, {}}});
      }
      const Sample<S> ribbon = patch.template ribbon<Sample<S>>();
      const Real slack = 2 * unit<S>(std::max(std::fabs(real(low)), std::fabs(real(high))));
      ASSERT_TRUE(real(ribbon.value) >= real(low) - slack && real(ribbon.value) <= real(high) + slack);
      const Sample<S> corner = patch.template corner<Sample<S>>();
      for (const Sample<S>& got : {ribbon, corner}) {
        ASSERT_TRUE(in_range(got.value) && in_range(got.gradient.x) && in_range(got.gradient.y) &&
                    in_range(got.gradient.z));
      }
      // Without what sides add, by corners too.
      patch.weights.side.assign(count, 0);
      const S by_corners = patch.template corner<Value<S>>().value;
      ASSERT_TRUE(real(by_corners) >= real(low) - slack && real(by_corners) <= real(high) + slack);
    }
  }
}

}  // namespace
