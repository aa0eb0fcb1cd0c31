/// Solid noise by itself, clearances of deformed fields, and parameters that are refused.

#include <nearfield/curve/potential.hpp>
#include <nearfield/curve/radius_profile.hpp>
#include <nearfield/curve/tabulated_form.hpp>
#include <nearfield/field/deformed.hpp>
#include <nearfield/query/clearance.hpp>
#include <nearfield/query/soft_clearance.hpp>

#include "property/conversion.hpp"
#include "property/failures.hpp"
#include "reference/deformations.hpp"
#include "reference/random.hpp"

#include <algorithm>
#include <cstdio>
#include <limits>

namespace nearfield::property {
namespace {

using reference::Random;
using reference::Vec3;

/// Value and slopes of the integers against the definition; values within [-1, 1], slopes within 15/4 an
/// octave.
TEST(LatticeNoise, IsTheDefinition) {
  Random random(reference::announced_seed("lattice noise", 0x4015E));
  Real value_error = 0, slope_error = 0, greatest = 0, steepest = 0;
  for (int i = 0; i < 60000; ++i) {
    const Vec3 cells =
        random.vector(-5, 5) + static_cast<Real>(random.integer(-1, 1)) * Vec3{2e6L, 1e5L, -3e6L};
    LatticePlace place;
    const auto q32 = [&](Real x) {
      return static_cast<std::int64_t>(random.chance(0.2L) ? std::round(x) : x * 4294967296.0L);
    };
    place = {q32(cells.x), q32(cells.y), q32(cells.z)};
    if (random.chance(0.3L)) place = {place.x & ~0xffffffffLL, place.y, place.z & ~0x7fffffffLL};
    const Vec3 at{std::ldexp(static_cast<Real>(place.x), -32), std::ldexp(static_cast<Real>(place.y), -32),
                  std::ldexp(static_cast<Real>(place.z), -32)};
    const auto seed = static_cast<std::uint32_t>(random.next());
    const auto octaves = static_cast<std::uint32_t>(random.integer(1, 4));
    const LatticeNoise noise = lattice_noise<true>(place, seed, octaves);
    ASSERT_EQ(noise.value, lattice_noise<false>(place, seed, octaves).value);
    const Real sizes = 2 - std::ldexp(Real{1}, 1 - static_cast<int>(octaves));
    const reference::Noise exact{sizes, 1, static_cast<int>(octaves), seed};
    value_error =
        std::max(value_error, std::fabs(real(noise.value) - reference::noise_of(exact, at)) * 536870912);
    const Real h = 1e-6L;
    const auto slope = [&](const Vec3& unit) {
      return (reference::noise_of(exact, at + h * unit) - reference::noise_of(exact, at - h * unit)) /
             (2 * h);
    };
    const Vec3 slopes{slope({1, 0, 0}), slope({0, 1, 0}), slope({0, 0, 1})};
    slope_error = std::max(slope_error, reference::distance(real(noise.slope), slopes) * 134217728);
    greatest = std::max(greatest, std::fabs(real(noise.value)) / sizes);
    steepest = std::max(steepest, reference::norm(slopes) / static_cast<Real>(octaves));
  }
  EXPECT_LE(value_error, kNoiseErrorQ29);
  EXPECT_LE(slope_error, 2 * kNoiseSlopeErrorQ27);  // differences by themselves err by as much
  EXPECT_LE(greatest, 1);
  EXPECT_GT(greatest, 0.9L);
  EXPECT_LE(steepest, 3.75L);
  EXPECT_GT(steepest, 2.5L);
  std::printf(
      "noise off by %.1f units of 2^-29, slopes by %.1f of 2^-27; greatest %.3f, steepest %.3f a cell\n",
      static_cast<double>(value_error), static_cast<double>(slope_error), static_cast<double>(greatest),
      static_cast<double>(steepest));
}

/// The bound on slopes is met: by vertices that are -1 on one side of a cell and 1 on the other, half way. It
/// is the greatest w'^2 / (w (1 - w)).
TEST(LatticeNoise, SlopesAreBoundedByThoseOfTheWeights) {
  Real greatest = 0;
  for (int i = 1; i < 20000; ++i) {
    const Real t = i / 20000.0L, w = t * t * t * (t * (t * 6 - 15) + 10),
               slope = 30 * t * t * (1 - t) * (1 - t);
    greatest = std::max(greatest, slope * slope / (w * (1 - w)));
  }
  EXPECT_NEAR(static_cast<double>(greatest), 225.0 / 16.0, 1e-9);
}

template <class S>
inline const Table<S, 2> squared_potential = bake<S, 2>(over_square(potential::wyvill));
template <class S>
inline const Table<S, 8> potential_table = bake<S, 8>(over_range(potential::Cubic{}));
struct Waist {
  constexpr Differentiable operator()(const Differentiable& t) const { return 1.0 - 0.3 * sin(kPi * t); }
  static Real radius(Real t) { return 1 - 0.3L * std::sin(reference::pi * t); }
};
struct Flower {
  constexpr Differentiable operator()(const Differentiable& turn) const {
    return 1.0 + 0.2 * cos(10.0 * kPi * turn);
  }
  static Real radius(Real angle) { return 1 + 0.2L * std::cos(5 * angle); }
};
template <class S>
inline const Table<S, 64> waist_table = bake<S, 64>(along_profile(Waist{}));
template <class S>
inline const Table<S, 128> flower_table = bake<S, 128>(about_profile(Flower{}));

template <class S>
class DeformationsOf : public testing::Test {};
using Scalars = testing::Types<Fixed<27>, Fixed<24>, Fixed<16>, float>;
TYPED_TEST_SUITE(DeformationsOf, Scalars, );

/// No point of the surface of `level` lies nearer than the clearance that `ask` gives. Surface points lie on
/// random lines.
template <class S, class Ask, class Value>
void expect_clearances(const char* name, const Ask& ask, const Value& inside) {
  Random random(reference::announced_seed(name, 0xC1EA4));
  std::vector<Vec3> surface;
  for (int i = 0; i < 6000; ++i) {
    Vec3 out = random.uniform(1.5L, 2) * random.unit_vector(), in = random.vector(-0.4L, 0.4L);
    if (!inside(in) || inside(out)) continue;
    for (int step = 0; step < 40; ++step) {
      const Vec3 middle = 0.5L * (in + out);
      (inside(middle) ? in : out) = middle;
    }
    surface.push_back(in);
  }
  ASSERT_GT(surface.size(), 1000u) << name;
  Failures failures;
  int clear = 0;
  Real best = 0;
  for (int i = 0; i < 400; ++i) {
    const Vector3<S> p = rounded<S>(random.vector(-2, 2));
    Real nearest = 100;
    for (const Vec3& q : surface) nearest = std::min(nearest, reference::distance(real(p), q));
    const Clearance<S> answer = ask(p);
    ASSERT_NE(answer.status, ClearanceStatus::invalid) << name;
    if (answer.status != ClearanceStatus::clear) continue;
    ++clear;
    failures.check(!inside(real(p)) && real(answer.distance) <= nearest, [&](std::ostream& out) {
      out << real(answer.distance) << " but " << nearest << " at " << real(p).x << " " << real(p).y << " "
          << real(p).z;
    });
    best = std::max(best, real(answer.distance) / nearest);
  }
  failures.expect_none(name);
  EXPECT_GT(clear, 50) << name;
  std::printf("%s in %s: %d clear, up to %.3f of the distance\n", name, ScalarName<S>::text().c_str(), clear,
              static_cast<double>(best));
}

TYPED_TEST(DeformationsOf, HaveClearances) {
  using S = TypeParam;
  const Sphere<S> ball{{}, rounded<S>(0.75L)};
  const auto bumpy = field(with_noise(ball, rounded<S>(0.125L), Fixed<16>(3.0), 3, 5));
  ASSERT_TRUE(bumpy.valid());
  expect_clearances<S>(
      "bumpy ball", [&](const Vector3<S>& p) { return clearance(bumpy, p, nullptr); },
      [](const Vec3& p) {
        return reference::norm(p) - 0.75L - reference::noise_of({0.125L, 3, 3, 5}, p) < 0;
      });

  const auto glow = with_potential(SoftPoint<S>{{}, Influence<S>(rounded<S>(1.5L), rounded<S>(1.0L))},
                                   squared_potential<S>);
  const auto cloud = field(with_noise(glow, rounded<S>(0.5L), Fixed<16>(2.0), 2, 9));
  ASSERT_TRUE(cloud.valid());
  expect_clearances<S>(
      "cloud", [&](const Vector3<S>& p) { return soft_clearance(cloud, p, nullptr); },
      [](const Vec3& p) {
        const Real r = reference::norm(p) / 1.5L, u = r * r,
                   intensity = r >= 1 ? 0 : (1 - u) * (1 - u) * (1 - 4 * u / 9);
        return intensity * (1 + reference::noise_of({0.5L, 2, 2, 9}, p)) > 0.5L;
      });

  const auto hourglass = surface_of_revolution(waist_table<S>, Vector3<S>{{}, {}, -rounded<S>(0.5L)},
                                               Vector3<S>{{}, {}, rounded<S>(0.5L)}, rounded<S>(1.5L));
  const auto certified = [](const auto& node) {
    return detail::NodeTraits<std::decay_t<decltype(node)>>::certificate(node, domain_reach<S>());
  };
  const auto vase = field(combine(PotentialOfRay<S>(rounded<S>(1.0L), rounded<S>(1.0L), certified(hourglass)),
                                  potential_table<S>, hourglass));
  ASSERT_TRUE(vase.valid());
  const auto ray_along = [](const Vec3& p) {
    const Vec3 nearest{0, 0, std::clamp<Real>(p.z, -0.5L, 0.5L)};
    return reference::distance(p, nearest) / (1.5L * Waist::radius(std::clamp<Real>(p.z + 0.5L, 0, 1)));
  };
  expect_clearances<S>(
      "hourglass", [&](const Vector3<S>& p) { return soft_clearance(vase, p, nullptr); },
      [&](const Vec3& p) { return ray_along(p) < 0.5L; });

  const auto twisted = scaled_about_axis(flower_table<S>, rounded<S>(0.5L), hourglass,
                                         rounded<typename ScaleAbout<S>::Twist>(0.25L));
  const auto column = field(combine(PotentialOfRay<S>(rounded<S>(1.0L), rounded<S>(1.0L), certified(twisted)),
                                    potential_table<S>, twisted));
  ASSERT_TRUE(column.valid());
  const TableFacts& facts = flower_table<S>.facts;
  const Real level = (static_cast<Real>(facts.least_value) + facts.greatest_value) / 2147483648.0L;
  expect_clearances<S>(
      "twisted column", [&](const Vector3<S>& p) { return soft_clearance(column, p, nullptr); },
      [&](const Vec3& p) {
        const Real angle = reference::angle_of(p.x, p.y) - 2 * reference::pi * 0.25L * p.z;
        return ray_along(p) * reference::with_core(1 / Flower::radius(angle), reference::norm({p.x, p.y, 0}),
                                                   {0.5L, level}) <
               0.5L;
      });
}

// A displaced solid is known to lie within the amplitude of the sharp one.
TYPED_TEST(DeformationsOf, StateHowFarTheyMoveTheSurface) {
  using S = TypeParam;
  const Sphere<S> ball{{}, rounded<S>(0.75L)};
  const auto bumpy = field(with_noise(ball, rounded<S>(-0.25L), Fixed<16>(3.0), 4, 5));
  EXPECT_GE(real(bumpy.certificate().erosion), 0.25L);
  EXPECT_LE(real(bumpy.certificate().erosion), 0.25L + 8 * last_place<S>(0.25L));
  EXPECT_TRUE(bumpy.certificate().inflation == bumpy.certificate().erosion);
}

TYPED_TEST(DeformationsOf, RefuseBadParameters) {
  using S = TypeParam;
  const Sphere<S> ball{{}, rounded<S>(0.75L)};
  const auto is_valid = [](const auto& node) { return field(node).valid(); };
  const S c = rounded<S>(0.125L), limit = ScalarTraits<S>::domain();
  const Fixed<16> f(3.0);
  EXPECT_TRUE(is_valid(with_noise(ball, c, f, 4)));
  EXPECT_FALSE(is_valid(with_noise(ball, c, f, 0)));
  EXPECT_FALSE(is_valid(with_noise(ball, c, f, 5)));
  EXPECT_FALSE(is_valid(with_noise(ball, c, Fixed<16>(0.0005), 1)));
  EXPECT_FALSE(is_valid(with_noise(ball, c, Fixed<16>(-3.0), 1)));
  EXPECT_FALSE(is_valid(with_noise(ball, c, Fixed<16>(1025.0), 1)));
  EXPECT_FALSE(is_valid(with_noise(ball, limit + limit, f, 1)));
  EXPECT_FALSE(is_valid(with_noise(ball, c, Fixed<16>(1000.0), 4)));  // steeper than rates go
  NoiseDistance<S> inconsistent{{c, f, 1, 0}};
  inconsistent.noise.gain = rounded<S>(0.25L);
  EXPECT_FALSE(is_valid(combine(inconsistent, ball)));

  const auto weighted = [](Real weight) {
    return with_potential(SoftPoint<S>{{}, Influence<S>(rounded<S>(1.0L), rounded<S>(weight))},
                          squared_potential<S>);
  };
  EXPECT_TRUE(is_valid(with_noise(weighted(1), rounded<S>(2.0L), f, 1)));
  EXPECT_TRUE(is_valid(with_noise(weighted(-1), rounded<S>(1.0L), f, 1)));
  EXPECT_FALSE(is_valid(with_noise(weighted(-1), rounded<S>(2.0L), f, 1)));

  const RaySegment<S> ray{Capsule<S>(Vector3<S>{}, Vector3<S>{rounded<S>(1.0L), {}, {}}, S{}),
                          RayRadius<S>(rounded<S>(1.0L))};
  const S one = ScalarTraits<S>::one(), cut = ray_cut<S>(waist_table<S>.facts);
  const Vector3<Unit<S>> up{{}, {}, ScalarTraits<S>::unit_one()};
  const auto along = [&](const Vector3<Unit<S>>& axis, S length, S greatest) {
    return is_valid(combine(ScaleAlong<S>({}, axis, length, greatest), waist_table<S>, ray));
  };
  EXPECT_TRUE(along(up, one, cut));
  EXPECT_FALSE(along({}, one, cut));
  EXPECT_FALSE(along({ScalarTraits<S>::unit_one(), {}, ScalarTraits<S>::unit_one()}, one, cut));
  EXPECT_FALSE(along(up, S{}, cut));
  EXPECT_FALSE(along(up, -one, cut));
  EXPECT_FALSE(along(up, rounded<S>(1 / 128.0L), cut));
  EXPECT_FALSE(along(up, one, S{}));
  EXPECT_FALSE(along(up, one, rounded<S>(0.5L)));   // values beyond the cut would be below 1
  EXPECT_FALSE(along(up, one, rounded<S>(14.0L)));  // or above what rays may be
  EXPECT_FALSE(is_valid(scaled_from_axis(waist_table<S>, S{}, ray)));
  // A surface of revolution about a segment without a direction.
  EXPECT_FALSE(is_valid(surface_of_revolution(waist_table<S>, Vector3<S>{}, Vector3<S>{}, one)));

  EXPECT_TRUE(is_valid(scaled_about_axis(flower_table<S>, one, ray)));
  EXPECT_FALSE(is_valid(scaled_about_axis(flower_table<S>, S{}, ray)));
  EXPECT_FALSE(is_valid(scaled_about_circle(flower_table<S>, one, -one, ray)));
  static const Table<S, 64> open =
      bake<S, 64>(along_profile([](const Differentiable& t) { return 1.0 + 0.5 * t; }));
  EXPECT_TRUE(is_valid(scaled_from_axis(open, one, ray)));
  EXPECT_FALSE(is_valid(scaled_about_axis(open, one, ray)));  // does not go round
  ScaleAbout<S> scale = ScaleAbout<S>::axis(flower_table<S>.facts, one);
  scale.ring = one;
  EXPECT_FALSE(is_valid(combine(scale, flower_table<S>, ray)));
  scale = ScaleAbout<S>::axis(flower_table<S>.facts, one);
  scale.about = static_cast<AngleAbout>(2);
  EXPECT_FALSE(is_valid(combine(scale, flower_table<S>, ray)));
  scale = ScaleAbout<S>::axis(flower_table<S>.facts, one);
  scale.level = Unit<S>{};
  EXPECT_FALSE(is_valid(combine(scale, flower_table<S>, ray)));
  // Factors that are not positive, and radii too far apart for any cut.
  static const Table<S, 64> crossing = bake<S, 64>([](const Differentiable& t) { return t - 0.5; });
  EXPECT_FALSE(is_valid(scaled_from_axis(crossing, one, ray)));
  static const Table<S, 64> wide = bake<S, 64>([](const Differentiable& t) { return 0.1 + 0.9 * t; });
  EXPECT_FALSE(is_valid(scaled_from_axis(wide, one, ray)));
  if constexpr (!ScalarTraits<S>::is_fixed) {
    const float strange = std::numeric_limits<float>::quiet_NaN();
    EXPECT_FALSE(is_valid(with_noise(ball, strange, f, 1)));
    EXPECT_FALSE(along(up, strange, cut));
    EXPECT_FALSE(along(up, one, strange));
    EXPECT_FALSE(along({{}, {}, strange}, one, cut));
    EXPECT_FALSE(is_valid(scaled_about_axis(flower_table<S>, strange, ray)));
    EXPECT_FALSE(is_valid(scaled_about_axis(flower_table<S>, one, ray, strange)));
    EXPECT_FALSE(is_valid(scaled_about_circle(flower_table<S>, one, strange, ray)));
  }
}

}  // namespace
}  // namespace nearfield::property
