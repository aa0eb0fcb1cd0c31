// I-patches: surfaces that meet given ones, the ribbons or those at the corners, along the sides.
#pragma once

#include <algorithm>
#include <array>

#include <nearfield/blend/patch.hpp>
#include <nearfield/curve/patch_weights.hpp>

#include "operators/algebraic.hpp"

namespace nearfield::host::operators {

inline constexpr std::size_t most_samples = 64;  // points that a patch may be centred among

// A patch's parameters, in real numbers, and its operands by what they are to it.
struct PatchShape {
  int side_count = 0, exponent = 0;
  bool has_corners = false;
  std::vector<double> side_weights;
  double centre_weight = 0.0;

  explicit PatchShape(const FieldNode& node, bool corners)
      : side_count(static_cast<int>(node.operands.size() / 2)),
        exponent(static_cast<int>(node.number("exponent"))),
        has_corners(corners),
        side_weights(node.parameters.at("side_weights")),
        centre_weight(node.number("centre_weight")) {}

  const FieldNode& primary(const FieldNode& node, int side) const {
    return node.operands[static_cast<std::size_t>(has_corners ? side : 2 * side)];
  }
  const FieldNode& bound(const FieldNode& node, int side) const {
    return node.operands[static_cast<std::size_t>(has_corners ? side_count + side : 2 * side + 1)];
  }
  template <class Patch>
  Patch in() const {
    using S = typename Patch::Scalar;
    Patch patch;
    patch.side_count = static_cast<std::uint32_t>(side_count);
    patch.exponent = static_cast<std::uint32_t>(exponent);
    for (std::size_t i = 0; i < side_weights.size(); ++i) patch.side_weight[i] = quantise<S>(side_weights[i]);
    patch.centre_weight = quantise<S>(centre_weight);
    return patch;
  }
};

// What both kinds of I-patches have: sides, half as many as operands.
inline OperatorDescription patch(std::string_view name, std::size_t fewest_sides) {
  OperatorDescription description = blend(name, FieldKind::algebraic);
  ParameterDescription weights = coefficients("side_weights", fewest_sides);
  weights.most = kGreatestSideCount;
  weights.optional = true;
  ParameterDescription through = fitting(Fit::number, {"through", 3, position_range});
  through.optional = true;
  through.instead_of = {"centre_weight"};
  ParameterDescription among = fitting(Fit::number, {"centred_among", 3, position_range});
  among.most_points = most_samples;
  among.optional = true;
  among.instead_of = {"centre_weight", "through"};
  description.parameters = {std::move(weights),
                            coefficients("centre_weight", 1, {0.0}),
                            std::move(through),
                            std::move(among),
                            {"exponent", 1, {2.0, 3.0, {}}, {2.0}, {}, true}};
  description.fewest_operands = 2 * fewest_sides;
  description.most_operands = std::size_t{2} * kGreatestSideCount;
  return description;
}

// Refuses a weight that was found, because of the key that it was found for, unless the scalar has it.
inline void require_weight(const FieldEmitter& emitter, const FieldNode& node, const std::string& key,
                           const PatchWeight& weight) {
  if (!weight.valid) {
    emitter.refuse(node, key, "no weight has any effect here",
                   "a point away from all bounds but its own side's");
  }
  if (!fits(emitter.limits(), Fit::number, weight.value)) {
    emitter.refuse(node, key, emitter.misfit(weight.value) + ": the weight that follows from it",
                   "a point farther from the bounds, or nearer to the ribbons");
  }
}

// The centre's weight that makes the patch 0 at a point, or least in squares at several.
inline void set_centre_weight(FieldEmitter& emitter, const FieldNode& node, const std::string& key,
                              PatchShape& shape) {
  const std::vector<Vector3d> points = node.points(key);
  if (points.empty()) return;
  std::vector<std::array<double, kGreatestSideCount>> primaries(points.size()), bounds(points.size());
  for (int side = 0; side < shape.side_count; ++side) {
    const std::vector<double> of_primary = emitter.values_of(node, key, shape.primary(node, side), points);
    const std::vector<double> of_bound = emitter.values_of(node, key, shape.bound(node, side), points);
    for (std::size_t i = 0; i < points.size(); ++i) {
      primaries[i][static_cast<std::size_t>(side)] = of_primary[i];
      bounds[i][static_cast<std::size_t>(side)] = of_bound[i];
    }
  }
  std::vector<PatchSample> samples;
  for (std::size_t i = 0; i < points.size(); ++i) samples.push_back({primaries[i].data(), bounds[i].data()});
  const auto centre_weight = shape.has_corners ? corner_centre_weight : ribbon_centre_weight;
  const PatchWeight weight = centre_weight(shape.side_count, shape.exponent, shape.side_weights.data(),
                                           samples.data(), static_cast<int>(samples.size()));
  require_weight(emitter, node, key, weight);
  shape.centre_weight = weight.value;
}

// The weights of a corner patch's sides that lead it through a point on each.
inline void set_side_weights(FieldEmitter& emitter, const FieldNode& node, PatchShape& shape) {
  constexpr double on_the_side = 1.0 / 1024.0;  // of the bound's value
  const std::vector<Vector3d> points = node.points("side_points");
  const int count = shape.side_count;
  shape.side_weights.clear();
  for (int side = 0; side < count; ++side) {
    const std::string key = "side_points[" + std::to_string(side) + "]";
    const auto value = [&](const FieldNode& operand) {
      return emitter.values_of(node, key, operand, {points[static_cast<std::size_t>(side)]}).front();
    };
    const int before = (side + count - 1) % count, after = (side + 1) % count;
    const double own_bound = value(shape.bound(node, side));
    if (!(own_bound >= -on_the_side && own_bound <= on_the_side)) {
      emitter.refuse(
          node, key,
          "not on side " + std::to_string(side + 1) + ": its bound is " + format_number(own_bound) + " here",
          "a point where it is 0");
    }
    const PatchWeight weight =
        side_weight(shape.exponent, value(shape.primary(node, before)), value(shape.primary(node, side)),
                    value(shape.bound(node, before)), value(shape.bound(node, after)));
    require_weight(emitter, node, key, weight);
    shape.side_weights.push_back(weight.value);
  }
}

// Refuses an array that has not one element for every side.
inline void require_count(const FieldEmitter& emitter, const FieldNode& node, const std::string& key,
                          const std::string& elements, std::size_t count) {
  if (2 * count == node.operands.size()) return;
  emitter.refuse(
      node, key,
      std::to_string(count) + " " + elements + " for " + std::to_string(node.operands.size()) + " operands",
      "one for every two operands");
}

inline void require_pairs(const FieldEmitter& emitter, const FieldNode& node) {
  if (node.operands.size() % 2 == 0) return;
  emitter.refuse(node, "operands", std::to_string(node.operands.size()), "an even number: two for each side");
}

template <template <class> class Patch>
void add_patch(FieldEmitter& emitter, const FieldNode& node, PatchShape& shape) {
  require_count(emitter, node, "side_weights", "weights", shape.side_weights.size());
  set_centre_weight(emitter, node, "through", shape);
  set_centre_weight(emitter, node, "centred_among", shape);
  for (const FieldNode& operand : node.operands) emitter.operand(operand);
  emitter.operation([&](auto zero) { return shape.in<Patch<decltype(zero)>>(); });
}

// Operands P1, B1, P2, B2, ...; the weights of their sides are 1 when none are given.
struct RibbonPatchOperator {
  static OperatorDescription description() { return patch("ribbon_patch", 2); }
  static void add(FieldEmitter& emitter, const FieldNode& node) {
    require_pairs(emitter, node);
    PatchShape shape(node, false);
    if (shape.side_weights.empty())
      shape.side_weights.assign(static_cast<std::size_t>(shape.side_count), 1.0);
    add_patch<RibbonPatch>(emitter, node, shape);
  }
};

// Operands C1, ..., Cn, B1, ..., Bn; the weights of their sides are given or follow from a point on each.
struct CornerPatchOperator {
  static OperatorDescription description() {
    OperatorDescription description = patch("corner_patch", 3);
    ParameterDescription points = fitting(Fit::number, {"side_points", 3, position_range});
    points.most_points = kGreatestSideCount;
    points.optional = true;
    points.instead_of = {"side_weights"};
    description.parameters.push_back(std::move(points));
    return description;
  }
  static void add(FieldEmitter& emitter, const FieldNode& node) {
    require_pairs(emitter, node);
    PatchShape shape(node, true);
    const std::size_t point_count = node.points("side_points").size();
    if (point_count > 0) {
      require_count(emitter, node, "side_points", "points", point_count);
      set_side_weights(emitter, node, shape);
    } else if (shape.side_weights.empty()) {
      emitter.refuse(node, "side_weights", "missing", "one number for each side, or `side_points`");
    }
    add_patch<CornerPatch>(emitter, node, shape);
  }
};

}  // namespace nearfield::host::operators
