// Exact solids in scenes: what is refused, by its key, and what sizes mean.
#include <gtest/gtest.h>

#include <cmath>
#include <string>

#include "compile/field_compiler.hpp"
#include "field_nodes.hpp"
#include "text/input_error.hpp"

namespace nearfield::host {
namespace {

void compile_text(const std::string& text, const std::string& file) {
  compile_field<Fixed<27>>(parse_scene_of_any_kind(text, file).field, file, SlotOfLink());
}
// `text` is part of the error, which names a key of the node.
void expect_refused(const std::string& node, const std::string& text) {
  try {
    compile_text(scene_of("{\"type\": " + node + "}"), "file");
    ADD_FAILURE() << "accepted: " << node;
  } catch (const InputError& error) {
    EXPECT_NE(std::string(error.what()).find(": field." + text), std::string::npos) << error.what();
    EXPECT_FALSE(error.allowed().empty()) << error.what();
  }
}

TEST(ExactSolidsOfScenes, RefuseBadParameters) {
  const std::string axis = "\"tapered_capsule\", \"from\": [0, 0, 0], \"to\": [0, 0, 1], ";
  expect_refused(axis + "\"radius_from\": 0.1", "radius_to: missing; ");
  expect_refused("\"cone_frustum\", \"radius_below\": 0, \"radius_above\": 0, \"height\": 1",
                 "radius_above: both radii are 0; one of them above 0");
  expect_refused("\"half_space\", \"normal\": [0, 0, 0]",
                 "normal: a zero vector has no direction; any other");
  expect_refused("\"rounded_box\", \"size\": [1, 0.2, 1], \"radius\": 0.1",
                 "radius: 0.1 leaves nothing of the least edge; below half of it, 0.1 m");
  expect_refused(axis + "\"radius_from\": 0.1, \"radius_to\": -0.1", "radius_to: ");
  expect_refused(axis + "\"radius_to\": 0.1, \"radius_from\": 1e300", "radius_from: ");
  expect_refused("\"cone_frustum\", \"radius_below\": 0.1, \"radius_above\": 0.1, \"height\": 0", "height: ");
  expect_refused("\"torus\", \"ring_radius\": 0.5, \"tube_radius\": 0.6", "tube_radius: ");
  expect_refused("\"torus\", \"ring_radius\": 0, \"tube_radius\": 0", "ring_radius: ");
  expect_refused("\"disc\", \"radius\": 0.5, \"thickness\": -1", "thickness: ");
  expect_refused("\"infinite_cylinder\", \"radius\": 5", "radius: ");
  expect_refused("\"infinite_cone\", \"half_angle\": 1.6", "half_angle: ");
  expect_refused("\"infinite_cone\", \"half_angle\": -0.1", "half_angle: ");
  expect_refused("\"offset\", \"operands\": [{\"type\": \"sphere\", \"radius\": 1}], \"radius\": 17",
                 "radius: ");
}

TEST(ExactSolidsOfScenes, TheSizeOfARoundedBoxIsTheOuterOne) {
  const CompiledField<Fixed<27>> field = compile_field<Fixed<27>>(
      field_of(
          "{\"type\": \"rounded_box\", \"size\": [1, 0.5, 0.25], \"radius\": 0.0625, \"rpy\": [0, 0, 0.5]}"),
      "scene", SlotOfLink());
  const Program<Fixed<27>> program(field.image.data(), field.inspection);
  const auto value = [&](double along, double across) {
    const double c = std::cos(0.5), s = std::sin(0.5);
    const nearfield::Vector3<Fixed<27>> p = {c * along - s * across, s * along + c * across, 0.0};
    return program.evaluate<Value<Fixed<27>>>(p, nullptr).value.to_double();
  };
  EXPECT_NEAR(value(0.75, 0), 0.25, 1e-7);
  EXPECT_NEAR(value(0, -0.5), 0.25, 1e-7);
  EXPECT_NEAR(value(0.5, 0.25), (std::sqrt(2.0) - 1.0) * 0.0625, 1e-7) << "its corner is round";
}

}  // namespace
}  // namespace nearfield::host
