// Metrics, sweeps and named algebraic surfaces in scenes: what is refused, by its key, and what they mean.
#include <gtest/gtest.h>

#include <cmath>
#include <string>

#include "compile/field_compiler.hpp"
#include "field_nodes.hpp"
#include "text/input_error.hpp"

namespace nearfield::host {
namespace {

// `text` is part of the error, which names a key of the node.
void expect_refused(const std::string& node, const std::string& text) {
  try {
    compile_field<Fixed<27>>(parse_scene_of_any_kind(scene_of("{\"type\": " + node + "}"), "file").field,
                             "file", SlotOfLink());
    ADD_FAILURE() << "accepted: " << node;
  } catch (const InputError& error) {
    EXPECT_NE(std::string(error.what()).find(": field." + text), std::string::npos) << error.what();
    EXPECT_FALSE(error.allowed().empty()) << error.what();
  }
}

class Value27 {
 public:
  explicit Value27(const std::string& node)
      : field_(compile_field<Fixed<27>>(field_of("{\"type\": " + node + "}"), "scene", SlotOfLink())),
        program_(field_.image.data(), field_.inspection) {}
  double at(double x, double y, double z) const {
    return program_.evaluate<Value<Fixed<27>>>({x, y, z}, nullptr).value.to_double();
  }

 private:
  CompiledField<Fixed<27>> field_;
  Program<Fixed<27>> program_;
};

TEST(MetricsOfScenes, RefuseBadParameters) {
  const std::string sweep = "\"ray_sweep\", \"semi_axes\": [0.5, 0.25, 0.5], \"exponents\": [4, 2], ";
  expect_refused(sweep + "\"length\": 0", "length: ");
  expect_refused(sweep + "\"length\": 9", "length: ");
  expect_refused(sweep + "\"length\": 1, \"end_scale\": 0", "end_scale: ");
  expect_refused(sweep + "\"length\": 1, \"end_scale\": -1", "end_scale: ");
  expect_refused(sweep + "\"length\": 1, \"end_scale\": 8", "");  // within the range, but not within 4 m
  expect_refused(sweep + "\"length\": 1, \"twist\": 4.1", "twist: 4.1");
  expect_refused(sweep + "\"length\": 1, \"twist\": -3, \"end_scale\": 2", "twist: -3");
  expect_refused(sweep + "\"length\": 7.5, \"twist\": 2.1", "twist: 2.1");
  expect_refused(
      "\"ray_sweep\", \"semi_axes\": [0.5, 0.02, 0.5], \"exponents\": [4, 2], \"length\": 1, "
      "\"end_scale\": 0.5",
      "end_scale: 0.5");
  expect_refused("\"superquadric\", \"semi_axes\": [1, 1, 1], \"exponents\": [0.1, 2]", "exponents");
  expect_refused("\"superquadric\", \"semi_axes\": [1, 1, 1], \"exponents\": [2, 65]", "exponents");
  expect_refused("\"superquadric\", \"semi_axes\": [1, 1, -1], \"exponents\": [2, 2]", "semi_axes");
  expect_refused("\"superquadric\", \"semi_axes\": [1, 5, 1], \"exponents\": [2, 2]", "semi_axes");
  expect_refused("\"box_metric\", \"semi_axes\": [1, 1, 0]", "semi_axes");
  expect_refused("\"ray_slab\", \"normal\": [0, 0, 0], \"influence_radius\": 1",
                 "normal: a zero vector has no direction; any other");
  const std::string generalised = "\"generalised_distance\", \"exponent\": 3, \"influence_radius\": 1, ";
  expect_refused(generalised + "\"normals\": [[1, 0, 0]]", "normals: 1 of them; 2 to 8");
  expect_refused(generalised + "\"normals\": [[1, 0, 0], [0, 0, 0]]",
                 "normals[1]: a zero vector has no direction; any other");
  expect_refused(generalised + "\"normals\": [[1, 0, 0], [0, 1]]", "normals[1]");
  expect_refused(
      "\"generalised_distance\", \"exponent\": 0.5, \"influence_radius\": 1, "
      "\"normals\": [[1, 0, 0], [0, 1, 0]]",
      "exponent: ");
  expect_refused("\"algebraic_torus\", \"ring_radius\": 0.5, \"tube_radius\": 0.6", "tube_radius: ");
  expect_refused("\"algebraic_torus\", \"ring_radius\": 0.5, \"tube_radius\": 0", "tube_radius: ");
  expect_refused("\"algebraic_sphere\", \"radius\": 0.5, \"size\": 0.1", "size: ");
  expect_refused("\"algebraic_sphere\", \"radius\": 3", "size: ");
  expect_refused("\"algebraic_cone\", \"half_angle\": 1.6", "half_angle: ");
}

TEST(MetricsOfScenes, SweepsTurnAndGrowAlongTheirPath) {
  const Value27 sweep(
      "\"ray_sweep\", \"semi_axes\": [0.5, 0.25, 0.125], \"exponents\": [2, 2], \"length\": 2, \"twist\": "
      "0.5, "
      "\"end_scale\": 2, \"position\": [0.5, 0, -1]");
  EXPECT_NEAR(sweep.at(1.0, 0, -1.0), 1.0, 1e-6);
  EXPECT_NEAR(sweep.at(0.5, 0.25, -1.0), 1.0, 1e-6);
  EXPECT_NEAR(sweep.at(0.5 + std::cos(1.0), std::sin(1.0), 1.0), 1.0, 1e-6);
  EXPECT_NEAR(sweep.at(0.5 + 0.75 * std::cos(0.5), 0.75 * std::sin(0.5), 0.0), 1.0, 1e-6);
  EXPECT_NEAR(sweep.at(0.5, 0, 1.0625), 0.5, 1e-6);
  EXPECT_NEAR(sweep.at(0.5, 0, 0.3), 0.0, 1e-6);
}

TEST(MetricsOfScenes, AlgebraicSurfacesAreWhereTheyArePlaced) {
  const Value27 bar(
      "\"algebraic_cylinder\", \"radius\": 0.25, \"size\": 0.5, \"position\": [0.5, 0.25, 0], "
      "\"rpy\": [1.5707963267948966, 0, 0]");
  EXPECT_NEAR(bar.at(0.75, 3.0, 0.0), 0.0, 1e-6);
  EXPECT_NEAR(bar.at(0.5, -1.0, 0.25), 0.0, 1e-6);
  EXPECT_NEAR(bar.at(0.5, 1.0, 0.0), -0.125, 1e-6);
  // Too far away for coefficients of this number type: in a frame of its own.
  const Value27 far("\"algebraic_sphere\", \"radius\": 0.5, \"position\": [3, 3, 3]");
  EXPECT_NEAR(far.at(3.0, 3.5, 3.0), 0.0, 1e-6);
  EXPECT_NEAR(far.at(3.0, 3.0, 3.0), -0.25, 1e-6);
  const Value27 torus(
      "\"algebraic_torus\", \"ring_radius\": 0.5, \"tube_radius\": 0.25, \"size\": 0.5, "
      "\"rpy\": [1.5707963267948966, 0, 0]");
  EXPECT_NEAR(torus.at(0.75, 0, 0), 0.0, 1e-6);
  EXPECT_NEAR(torus.at(0, 0.25, 0.5), 0.0, 1e-6);
  EXPECT_NEAR(torus.at(0, 0, 0.5), -0.1171875, 1e-6);
}

}  // namespace
}  // namespace nearfield::host
