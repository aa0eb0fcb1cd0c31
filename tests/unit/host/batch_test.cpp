// Many points at once against one after the other: the same bits, for every operation.
#include <gtest/gtest.h>

#include <algorithm>
#include <cstring>
#include <string>
#include <vector>

#include <nearfield/query/batch.hpp>

#include "compile/field_compiler.hpp"
#include "field_nodes.hpp"
#include "property/random_field.hpp"

namespace nearfield::host {
namespace {

constexpr int points_of_a_field = 150;  // of which the last block is not full

template <class S>
std::vector<Vector3<S>> random_points(reference::Random& random, reference::Real reach) {
  std::vector<Vector3<S>> points;
  for (int i = 0; i < points_of_a_field; ++i) points.push_back(property::rounded<S>(random.vector(-reach, reach)));
  return points;
}

template <class S>
void expect_same_values(const std::string& name, const Program<S>& program, const Slots<S>& slots, reference::Random& random) {
  ASSERT_TRUE(program.valid()) << name;
  const std::vector<Vector3<S>> points = random_points<S>(random, 2.0L);
  std::vector<S> values(points.size());
  nearfield::detail::BlockMachine<S> machine(program.image(), slots);
  for (std::size_t first = 0; first < points.size(); first += machine.lanes) {
    const auto here = std::min<std::size_t>(machine.lanes, points.size() - first);
    machine.run(points.data() + first, static_cast<std::uint32_t>(here), values.data() + first);
  }
  int different = 0;
  for (std::size_t i = 0; i < points.size(); ++i) {
    const S one = program.template evaluate<Value<S>>(points[i], slots).value;
    if (std::memcmp(&one, &values[i], sizeof(S)) != 0) ++different;
  }
  EXPECT_EQ(different, 0) << name << " of " << points.size();
}

template <class S>
void check_every_operator() {
  reference::Random random(reference::announced_seed("EveryOperation", 841));
  const S parameter = property::rounded<S>(0.3L);
  for (const OperatorDescription& row : all_operators()) {
    const FieldKind kind = row.any_kind ? FieldKind::intensity : row.operand_kind;
    const std::size_t most = row.most_operands == 64 ? row.fewest_operands + 1 : row.fewest_operands;
    for (std::size_t count = row.fewest_operands; count <= most; ++count) {
      const std::vector<std::uint32_t> image =
          compile_field<S>(field_of(node_text(row, count, kind)), "scene", SlotOfLink()).image;
      const Program<S> program = load<S>(image.data(), image.size() * sizeof(std::uint32_t));
      expect_same_values(std::string(row.name), program, Slots<S>(nullptr, 0, &parameter, 1), random);
    }
  }
}

TEST(Batch, EveryOperationInFixedPoint) { check_every_operator<Fixed<24>>(); }
TEST(Batch, EveryOperationInFloat) { check_every_operator<float>(); }

template <class S>
void check_clearances() {
  reference::Random random(reference::announced_seed("Clearances", 842));
  for (int i = 0; i < 60; ++i) {
    property::FieldTaste taste;
    taste.family = property::BlendFamily::count;
    taste.size = 0.5L * property::real(ScalarTraits<S>::domain());
    const property::RandomField<S> field = property::random_field<S>(random, taste);
    ASSERT_TRUE(field.program.valid());
    std::vector<Vector3<S>> points = random_points<S>(random, 2 * taste.size);
    points[70].y = ScalarTraits<S>::greatest();  // outside the domain
    const Slots<S> slots(field.slots.data(), static_cast<std::uint32_t>(field.slots.size()));
    std::vector<S> distances(points.size());
    clearance_distances(field.program, points.data(), static_cast<std::uint32_t>(points.size()), distances.data(), slots);
    for (std::size_t k = 0; k < points.size(); ++k) {
      const S one = clearance(field.program, points[k], slots).distance;
      ASSERT_EQ(std::memcmp(&one, &distances[k], sizeof(S)), 0) << i << " " << k;
    }
  }
}

TEST(Batch, ClearancesInFixedPoint) { check_clearances<Fixed<27>>(); }
TEST(Batch, ClearancesInFloat) { check_clearances<float>(); }

TEST(Batch, WhatMayNotBeAskedIsInvalid) {
  using S = Fixed<27>;
  const S least = ScalarTraits<S>::least();
  const Vector3<S> points[3] = {};
  S distances[3] = {};
  clearance_distances(Program<S>(), points, 3, distances);
  for (const S distance : distances) EXPECT_EQ(distance, least) << "no program";
  const auto check = [&](const std::string& node, const Slots<S>& slots, const char* what) {
    const std::vector<std::uint32_t> image = compile_field<S>(field_of(node), "scene", SlotOfLink()).image;
    const Program<S> program = load<S>(image.data(), image.size() * sizeof(std::uint32_t));
    ASSERT_TRUE(program.valid()) << what;
    distances[0] = {};
    clearance_distances(program, points, 1, distances, slots);
    EXPECT_EQ(distances[0], least) << what;
  };
  check("{\"type\": \"ray_point\", \"influence_radius\": 1}", {}, "a ray");
  const std::string swell =
      "{\"type\": \"swell\", \"radius\": 0.1, \"parameter_slot\": 0, \"operands\": [{\"type\": \"sphere\", \"radius\": 1}]}";
  check(swell, {}, "no parameter");
  const S beyond = ScalarTraits<S>::times(ScalarTraits<S>::one(), 2);
  check(swell, Slots<S>(nullptr, 0, &beyond, 1), "a parameter above 1");
}

}  // namespace
}  // namespace nearfield::host
