// Noise and radii that depend on the place in scenes: what they mean, and what is refused.
#include <gtest/gtest.h>

#include <cmath>
#include <string>
#include <vector>

#include "compile/field_compiler.hpp"
#include "field_nodes.hpp"
#include "text/input_error.hpp"

namespace nearfield::host {
namespace {

const std::string line =
    ", \"operands\": [{\"type\": \"ray_segment\", \"from\": [0, 0, 0], \"to\": [0, 0, 1], "
    "\"influence_radius\": 0.5}]}";
const std::string ball = ", \"operands\": [{\"type\": \"sphere\", \"radius\": 0.5}]}";

double value_at(const std::string& text, double x, double y, double z) {
  const CompiledField<Fixed<27>> field = compile_field<Fixed<27>>(field_of(text), "scene", SlotOfLink());
  const Program<Fixed<27>> program(field.image.data(), field.inspection);
  return program.evaluate<Value<Fixed<27>>>({x, y, z}, nullptr).value.to_double();
}
// Refused with a line that goes on like this after the position.
void expect_refused(const std::string& text, const std::string& message) {
  try {
    compile_field<Fixed<27>>(field_of(text), "scene", SlotOfLink());
    ADD_FAILURE() << "accepted: " << text;
  } catch (const InputError& error) {
    const std::string whole = error.what();
    EXPECT_NE(whole.find(": " + message), std::string::npos) << whole << "\ninput: " << text;
    EXPECT_FALSE(error.allowed().empty()) << whole;
  }
}

// The soft surface, of ray value 1/2, lies at half the radius: where the profile has its values exactly.
TEST(FieldDeformations, RadiiAreTheValuesAtTheirPlaces) {
  const std::string along =
      "{\"type\": \"scale_along\", \"from\": [0, 0, 0], \"to\": [0, 0, 1], \"values\": [1, 1.5, 0.75]" + line;
  EXPECT_NEAR(value_at(along, 0.25, 0, 0), 0.5, 1e-6);
  EXPECT_NEAR(value_at(along, 0, 0.375, 0.5), 0.5, 1e-6);
  EXPECT_NEAR(value_at(along, -0.1875, 0, 1), 0.5, 1e-6);
  EXPECT_NEAR(value_at(along, -0.1875, 0, 1.5), std::hypot(0.1875, 0.5) / 0.375, 1e-6);

  const std::string about =
      "{\"type\": \"scale_about\", \"values\": [1, 1.5, 0.75, 1.25], \"core\": 0.03125, \"twist\": " +
      format_number(std::acos(-1.0)) + line;
  EXPECT_NEAR(value_at(about, 0.25, 0, 0), 0.5, 1e-5);
  EXPECT_NEAR(value_at(about, 0, 0.375, 0), 0.5, 1e-5);
  EXPECT_NEAR(value_at(about, -0.1875, 0, 0), 0.5, 1e-5);
  EXPECT_NEAR(value_at(about, 0, 0.25, 0.5), 0.5, 1e-5);  // a quarter of a turn
  EXPECT_NEAR(value_at(about, -0.375, 0, 0.5), 0.5, 1e-5);

  const std::string ring =
      "{\"type\": \"scale_about\", \"values\": [1, 1.5, 0.75, 1.25], \"core\": 0.03125, \"ring\": 0.5";
  const std::string circle =
      ", \"operands\": [{\"type\": \"ray_of_distance\", \"influence_radius\": 0.5, \"operands\": [{\"type\": "
      "\"torus\", "
      "\"ring_radius\": 0.5, \"tube_radius\": 0.0078125}]}]}";
  const double skin = 0.0078125;
  EXPECT_NEAR(value_at(ring + circle, 0.75 + skin, 0, 0), 0.5, 1e-5);
  EXPECT_NEAR(value_at(ring + circle, 0, 0.5, 0.375 + skin), 0.5, 1e-5);
  EXPECT_NEAR(value_at(ring + circle, -0.3125 + skin, 0, 0), 0.5, 1e-5);
  EXPECT_NEAR(value_at(ring + circle, 0, -0.5, -0.3125 - skin), 0.5, 1e-5);

  const std::string from_axis = "{\"type\": \"scale_from_axis\", \"limit\": 0.5, \"values\": [1, 1.5]" + line;
  EXPECT_NEAR(value_at(from_axis, 0.25, 0, 0.5), 0.5 / 1.25, 1e-6);
  EXPECT_NEAR(value_at(from_axis, 0, -0.75, 0.5), 1.0, 1e-6);
}

TEST(FieldDeformations, NoiseMovesByItsAmplitudeAtMost) {
  const std::string noise =
      "{\"type\": \"noise_distance\", \"amplitude\": 0.0625, \"frequency\": 4, \"octaves\": 2, \"seed\": ";
  double least = 1.0, greatest = -1.0;
  for (int i = 0; i < 200; ++i) {
    const double x = -1.0 + 0.01 * i,
                 moved = value_at(noise + "7" + ball, x, 0.3, 0.1) -
                         value_at("{\"type\": \"sphere\", \"radius\": 0.5}", x, 0.3, 0.1);
    least = std::min(least, moved);
    greatest = std::max(greatest, moved);
  }
  EXPECT_GE(least, -0.0625);
  EXPECT_LE(greatest, 0.0625);
  EXPECT_GT(greatest - least, 0.03);
  EXPECT_NE(value_at(noise + "7" + ball, 0.4, 0.3, 0.1), value_at(noise + "8" + ball, 0.4, 0.3, 0.1));
  EXPECT_NE(value_at(noise + "4294967295" + ball, 0.4, 0.3, 0.1),
            value_at(noise + "8" + ball, 0.4, 0.3, 0.1));
}

TEST(FieldDeformations, WrongParametersAreRefused) {
  const std::string along =
      "{\"type\": \"scale_along\", \"from\": [0, 0, 0], \"to\": [0, 0, 1], \"values\": ";
  expect_refused(along + "[1]" + line, "field.values: ");
  expect_refused(along + "[1, 0.5]" + line, "field.values[1]: ");
  expect_refused(along + "[1, -1]" + line, "field.values[1]: ");
  expect_refused(along + "[2, 0.6, 0.6, 2]" + line, "field.values: the spline through them goes from 0.3");
  expect_refused(along + "[0.6, 6]" + line,
                 "field.values: the spline through them goes from 0.6 to 6; from 0.51 to 7, the greatest at "
                 "most 7 times the least");
  expect_refused(
      "{\"type\": \"scale_along\", \"from\": [0, 0, 0], \"to\": [0, 0, 0.01], \"values\": [1, 2]" + line,
      "field.to: 0.01 m from `from`; at least 0.015625 m");
  const std::string about = "{\"type\": \"scale_about\", \"values\": [1, 2]";
  expect_refused(about + line, "field.core: missing; required");
  expect_refused(about + ", \"core\": 0.001" + line, "field.core: ");
  expect_refused(about + ", \"core\": 0.1, \"twist\": 1, \"ring\": 1" + line,
                 "field.ring: \"ring\" beside \"twist\"");
  expect_refused(about + ", \"core\": 0.1, \"twist\": 800" + line, "field.twist: ");
  expect_refused("{\"type\": \"scale_from_axis\", \"limit\": 0, \"values\": [1, 2]" + line, "field.limit: ");

  const std::string noise = "{\"type\": \"noise_distance\", \"amplitude\": 0.5, \"frequency\": ";
  expect_refused(noise + "0" + ball, "field.frequency: ");
  expect_refused(noise + "60" + ball, "field.frequency: 60 does not fit q27");
  expect_refused(noise + "4, \"octaves\": 5" + ball, "field.octaves: ");
  expect_refused(noise + "4, \"octaves\": 1.5" + ball, "field.octaves: ");
  expect_refused(noise + "4, \"seed\": -1" + ball, "field.seed: ");
  expect_refused("{\"type\": \"noise_distance\", \"amplitude\": 5, \"frequency\": 1" + ball,
                 "field.amplitude: ");
}

}  // namespace
}  // namespace nearfield::host
