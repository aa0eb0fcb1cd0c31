#include "model/placement.hpp"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <cstdint>
#include <random>

namespace nearfield::host {
namespace {

void expect_near(const Vector3d& actual, const Vector3d& expected) {
  EXPECT_NEAR(actual.x, expected.x, 1e-14);
  EXPECT_NEAR(actual.y, expected.y, 1e-14);
  EXPECT_NEAR(actual.z, expected.z, 1e-14);
}

const double quarter_turn = std::acos(0.0);

TEST(Placement, EachAngleTurnsAboutItsAxis) {
  expect_near(transform_point(placement_from_rpy({}, quarter_turn, 0.0, 0.0), {0.0, 1.0, 0.0}),
              {0.0, 0.0, 1.0});
  expect_near(transform_point(placement_from_rpy({}, 0.0, quarter_turn, 0.0), {0.0, 0.0, 1.0}),
              {1.0, 0.0, 0.0});
  expect_near(transform_point(placement_from_rpy({}, 0.0, 0.0, quarter_turn), {1.0, 0.0, 0.0}),
              {0.0, 1.0, 0.0});
}

TEST(Placement, RollComesFirstAndYawLast) {
  const Placement placement = placement_from_rpy({1.0, 2.0, 3.0}, quarter_turn, quarter_turn, quarter_turn);
  expect_near(transform_point(placement, {0.0, 1.0, 0.0}), {1.0, 3.0, 3.0});
}

TEST(Placement, QuaternionAgreesWithAngles) {
  const double s = std::sin(0.3);
  const double c = std::cos(0.3);
  const auto about_x = placement_from_quaternion_xyzw({}, {s, 0.0, 0.0, c});
  const auto about_y = placement_from_quaternion_xyzw({}, {0.0, s, 0.0, c});
  const auto about_z = placement_from_quaternion_xyzw({}, {0.0, 0.0, -s, -c});
  ASSERT_TRUE(about_x && about_y && about_z);
  const Vector3d point{0.3, -0.2, 0.7};
  expect_near(transform_point(*about_x, point),
              transform_point(placement_from_rpy({}, 0.6, 0.0, 0.0), point));
  expect_near(transform_point(*about_y, point),
              transform_point(placement_from_rpy({}, 0.0, 0.6, 0.0), point));
  expect_near(transform_point(*about_z, point),
              transform_point(placement_from_rpy({}, 0.0, 0.0, 0.6), point));
}

TEST(Placement, QuaternionMustBeOfUnitLength) {
  EXPECT_TRUE(placement_from_quaternion_xyzw({}, {0.0, 0.0, 0.0, 1.0 + 0.9e-6}).has_value());
  EXPECT_FALSE(placement_from_quaternion_xyzw({}, {0.0, 0.0, 0.0, 1.0 + 1.1e-6}).has_value());
  EXPECT_FALSE(placement_from_quaternion_xyzw({}, {0.0, 0.0, 0.0, 0.0}).has_value());
  EXPECT_FALSE(placement_from_quaternion_xyzw({}, {0.0, 0.0, 0.0, std::nan("")}).has_value());
}

TEST(Placement, ComposeAndInverseUndoEachOther) {
  const std::uint32_t seed = 7;
  std::mt19937 random(seed);
  std::uniform_real_distribution<double> any(-2.0, 2.0);
  const auto any_placement = [&] {
    const Vector3d position{any(random), any(random), any(random)};
    return placement_from_rpy(position, any(random), any(random), any(random));
  };
  for (int count = 0; count < 100; ++count) {
    SCOPED_TRACE(testing::Message() << "seed " << seed << ", case " << count);
    const Placement a = any_placement();
    const Placement b = any_placement();
    const Vector3d point{any(random), any(random), any(random)};
    expect_near(transform_point(compose(a, b), point), transform_point(a, transform_point(b, point)));
    expect_near(transform_point(compose(a, inverse(a)), point), point);
  }
}

}  // namespace
}  // namespace nearfield::host
