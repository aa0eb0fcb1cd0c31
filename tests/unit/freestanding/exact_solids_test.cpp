// Exact solids: parameters that none can have, places that have no direction, and solids that are others at
// the limit.
#include <nearfield/field/solids.hpp>

#include <gtest/gtest.h>

namespace nearfield {
namespace {

template <class S>
class ExactSolids : public testing::Test {};
using Scalars = testing::Types<Fixed<27>, Fixed<24>, Fixed<16>, float>;
TYPED_TEST_SUITE(ExactSolids, Scalars, );

template <class S>
S metres(double length) {
  if constexpr (ScalarTraits<S>::is_fixed)
    return S(length);
  else
    return static_cast<float>(length);
}
template <class S>
Vector3<S> point(double x, double y, double z) {
  return {metres<S>(x), metres<S>(y), metres<S>(z)};
}
template <class Node>
bool is_valid(const Node& node) {
  return field(node).valid();
}
template <class S, class Node>
Sample<S> at(const Node& node, const Vector3<S>& p) {
  const auto composed = field(node);
  EXPECT_TRUE(composed.valid());
  return composed.template evaluate<Sample<S>>(p, nullptr);
}

TYPED_TEST(ExactSolids, RefuseBadParameters) {
  using S = TypeParam;
  using U = Unit<S>;
  const S half = metres<S>(0.5), zero{}, beyond = ScalarTraits<S>::domain() + half;
  const U one = ScalarTraits<S>::unit_one(), rather_less = metres<U>(0.9);
  const Vector3<S> origin{}, end = point<S>(1, 0, 0), far = {beyond, zero, zero};

  EXPECT_TRUE(is_valid(Sphere<S>{origin, zero}));
  EXPECT_FALSE(is_valid(Sphere<S>{origin, -half}));

  EXPECT_TRUE(is_valid(TaperedCapsule<S>(origin, end, half, zero)));
  EXPECT_FALSE(is_valid(TaperedCapsule<S>(origin, end, -half, half)));
  EXPECT_FALSE(is_valid(TaperedCapsule<S>(origin, end, half, -half)));
  EXPECT_FALSE(is_valid(TaperedCapsule<S>(origin, end, half, beyond)));
  EXPECT_FALSE(is_valid(TaperedCapsule<S>(far, far, half, half)));
  EXPECT_FALSE(is_valid(TaperedCapsule<S>(Capsule<S>(origin, {rather_less, {}, {}}, half, half), half)));
  EXPECT_FALSE(is_valid(TaperedCapsule<S>(Capsule<S>(origin, {one, {}, {}}, -half, half), half)));
  TaperedCapsule<S> other_normal(origin, end, half, zero);
  other_normal.sine = other_normal.cosine;
  EXPECT_FALSE(is_valid(other_normal));

  EXPECT_TRUE(is_valid(ConeFrustum<S>(origin, half, zero, half)));
  EXPECT_FALSE(is_valid(ConeFrustum<S>(origin, zero, zero, half)));
  EXPECT_FALSE(is_valid(ConeFrustum<S>(origin, -half, half, half)));
  EXPECT_FALSE(is_valid(ConeFrustum<S>(origin, half, -half, half)));
  EXPECT_FALSE(is_valid(ConeFrustum<S>(origin, half, half, zero)));
  EXPECT_FALSE(is_valid(ConeFrustum<S>(origin, half, beyond, half)));
  ConeFrustum<S> other_side(origin, half, half, half);
  other_side.along = one;
  EXPECT_FALSE(is_valid(other_side));

  EXPECT_TRUE(is_valid(Torus<S>{origin, half, half}));
  EXPECT_FALSE(is_valid(Torus<S>{origin, zero, zero}));
  EXPECT_FALSE(is_valid(Torus<S>{origin, half, half + half})) << "it would overlap itself";
  EXPECT_FALSE(is_valid(Torus<S>{origin, half, -half}));

  EXPECT_TRUE(is_valid(Disc<S>{origin, zero, zero}));
  EXPECT_FALSE(is_valid(Disc<S>{origin, -half, half}));
  EXPECT_FALSE(is_valid(Disc<S>{origin, half, -half}));
  EXPECT_FALSE(is_valid(Disc<S>{origin, beyond, half}));

  EXPECT_TRUE(is_valid(HalfSpace<S>{origin, {one, {}, {}}}));
  EXPECT_FALSE(is_valid(HalfSpace<S>{origin, {}}));
  EXPECT_FALSE(is_valid(HalfSpace<S>{origin, {rather_less, {}, {}}}));
  EXPECT_FALSE(is_valid(HalfSpace<S>{origin, {one, one, {}}}));

  EXPECT_TRUE(is_valid(InfiniteCylinder<S>{zero, zero, zero}));
  EXPECT_FALSE(is_valid(InfiniteCylinder<S>{zero, beyond, half}));
  EXPECT_FALSE(is_valid(InfiniteCylinder<S>{zero, zero, -half}));

  EXPECT_TRUE(is_valid(InfiniteCone<S>{origin, one, {}}));
  EXPECT_FALSE(is_valid(InfiniteCone<S>{origin, -one, {}}));
  EXPECT_FALSE(is_valid(InfiniteCone<S>{origin, {}, -one}));
  EXPECT_FALSE(is_valid(InfiniteCone<S>{origin, rather_less, {}}));

  const Sphere<S> ball = {origin, half};
  EXPECT_TRUE(is_valid(offset(ball, -half)));
  EXPECT_FALSE(is_valid(offset(ball, beyond)));
  EXPECT_FALSE(is_valid(offset(Sphere<S>{origin, -half}, half)));
  EXPECT_TRUE(is_valid(rounded_box(origin, {half, half, half}, zero)));
  EXPECT_FALSE(is_valid(rounded_box(origin, {half, half, half}, half)));
  EXPECT_FALSE(is_valid(rounded_box(origin, {half, half, half}, -half)));

  if constexpr (!ScalarTraits<S>::is_fixed) {
    const float nan = __builtin_nanf("");
    EXPECT_FALSE(is_valid(Sphere<S>{origin, nan}));
    EXPECT_FALSE(is_valid(TaperedCapsule<S>(origin, end, nan, half)));
    EXPECT_FALSE(is_valid(TaperedCapsule<S>(origin, end, half, nan)));
    EXPECT_FALSE(is_valid(TaperedCapsule<S>(origin, {nan, nan, nan}, half, half)));
    EXPECT_FALSE(is_valid(ConeFrustum<S>(origin, half, nan, half)));
    EXPECT_FALSE(is_valid(ConeFrustum<S>(origin, half, half, nan)));
    EXPECT_FALSE(is_valid(Torus<S>{origin, half, nan}));
    EXPECT_FALSE(is_valid(Torus<S>{origin, nan, half}));
    EXPECT_FALSE(is_valid(Disc<S>{origin, nan, half}));
    EXPECT_FALSE(is_valid(HalfSpace<S>{origin, {nan, 0, 0}}));
    EXPECT_FALSE(is_valid(InfiniteCylinder<S>{nan, zero, half}));
    EXPECT_FALSE(is_valid(InfiniteCone<S>{origin, nan, 0}));
    EXPECT_FALSE(is_valid(offset(ball, nan)));
    EXPECT_FALSE(is_valid(rounded_box(origin, {half, half, half}, nan)));
  }
}

TYPED_TEST(ExactSolids, DirectionsOnSkeletonsAndAxes) {
  using S = TypeParam;
  using U = Unit<S>;
  const S half = metres<S>(0.5), zero{}, one = ScalarTraits<S>::one();
  const Vector3<S> origin{}, up = {zero, zero, one}, down = {zero, zero, -one}, none{};
  const auto direction = [](const auto& node, const Vector3<S>& p) { return at<S>(node, p).gradient; };

  EXPECT_EQ(direction(Sphere<S>{origin, zero}, origin), none);
  EXPECT_EQ(direction(Sphere<S>{origin, zero}, point<S>(0, 0, 2)), up);

  const TaperedCapsule<S> tapered(point<S>(0, 0, -1), point<S>(0, 0, 1), metres<S>(1), half);
  EXPECT_EQ(direction(tapered, point<S>(0, 0, -1)), none) << "the centre of the larger ball";
  EXPECT_EQ(direction(tapered, origin), up) << "where the radius falls";
  EXPECT_EQ(direction(TaperedCapsule<S>(point<S>(0, 0, -1), point<S>(0, 0, 1), half, half), origin), none);
  EXPECT_EQ(direction(TaperedCapsule<S>(origin, origin, half, zero), origin), none);
  EXPECT_EQ(at<S>(TaperedCapsule<S>(origin, origin, zero, half), origin).value, -half)
      << "the larger ball alone";

  EXPECT_EQ(direction(ConeFrustum<S>(origin, half, half, metres<S>(2)), origin), none);
  EXPECT_EQ(direction(ConeFrustum<S>(origin, half, zero, metres<S>(2)), point<S>(0, 0, 2.5)), up)
      << "beyond a tip";
  EXPECT_EQ(direction(ConeFrustum<S>(origin, half, zero, metres<S>(2)), point<S>(0, 0, 1.5)), up)
      << "within it";
  EXPECT_EQ(direction(ConeFrustum<S>(origin, zero, half, metres<S>(2)), point<S>(0, 0, -1.5)), down);

  EXPECT_EQ(direction(Torus<S>{origin, half, zero}, origin), none);
  EXPECT_EQ(direction(Torus<S>{origin, half, zero}, point<S>(0.5, 0, 0)), none);
  EXPECT_EQ(direction(Torus<S>{origin, half, zero}, point<S>(0, 0, -1)), down);

  EXPECT_EQ(direction(Disc<S>{origin, half, zero}, origin), none);
  EXPECT_EQ(direction(Disc<S>{origin, half, half}, point<S>(0.25, 0, 0)), none);
  EXPECT_EQ(direction(Disc<S>{origin, half, half}, point<S>(0.25, 0, -0.25)), down);
  EXPECT_EQ(direction(Disc<S>{origin, zero, half}, origin), none);

  EXPECT_EQ(direction(InfiniteCylinder<S>{zero, zero, half}, up), none);
  const InfiniteCone<S> half_line = {origin, {}, ScalarTraits<S>::unit_one()};
  EXPECT_EQ(direction(half_line, up), none);
  EXPECT_EQ(direction(half_line, origin), none);
  EXPECT_EQ(direction(half_line, down), down);
  const InfiniteCone<S> cone = {origin, metres<U>(0.6), metres<U>(0.8)};
  EXPECT_EQ(direction(cone, up), down) << "towards the apex it becomes shallower";
  const InfiniteCone<S> all_above = {origin, ScalarTraits<S>::unit_one(), {}};
  EXPECT_EQ(direction(all_above, point<S>(1, 1, -1)), down);
  EXPECT_EQ(at<S>(all_above, point<S>(1, 1, 2)).value, metres<S>(-2));
}

// Derived numbers are those of the exact quotients, rounded.
TEST(ExactSolids, NormalsAreBakedToTheUnit) {
  using S = Fixed<27>;
  const TaperedCapsule<S> tapered(Vector3<S>{}, Vector3<S>{0.0, 0.0, 1.0}, S(0.75), S(0.15));
  EXPECT_NEAR(tapered.sine.to_double(), 0.6, 1e-8);
  EXPECT_NEAR(tapered.cosine.to_double(), 0.8, 1e-8);
  for (const int32_t end : {1, 3, 1000, 1 << 28}) {
    const Vector3<Fixed<30>> u =
        baked_direction(Vector3<S>{S::from_raw(3 * end), S::from_raw(-4 * end), S{}});
    EXPECT_NEAR(u.x.to_double(), 0.6, 1.0 / (1 << 30));
    EXPECT_NEAR(u.y.to_double(), -0.8, 1.0 / (1 << 30));
    EXPECT_TRUE(is_baked_direction(u));
  }
  EXPECT_TRUE(is_zero(baked_direction(Vector3<S>{})));
  EXPECT_FALSE(is_baked_direction(Vector3<Fixed<30>>{}));
  constexpr auto box = field(rounded_box(Vector3<S>{}, Vector3<S>{0.5, 0.5, 0.5}, S(0.125)));
  static_assert(box.valid(), "as a constant expression");
  EXPECT_EQ(box.evaluate<Value<S>>({S(1.0), S{}, S{}}, nullptr).value, S(0.5));
}

}  // namespace
}  // namespace nearfield
