// Soft objects: intensities around skeletons, and their sum.
#pragma once

#include <nearfield/blend/soft.hpp>
#include <nearfield/modify/potential.hpp>
#include <nearfield/shape/soft.hpp>

#include "operators/sharp.hpp"
#include "operators/solids.hpp"

namespace nearfield::host::operators {

inline const CurveDescription potential_curve{"potential", CurveFamily::potential, "wyvill"};
inline ParameterDescription weight() { return fitting(Fit::number, {"weight", 1, weight_range, {1.0}}); }

inline OperatorDescription soft_skeleton(std::string_view name, std::vector<ParameterDescription> parameters,
                                         PlacementParts placement) {
  OperatorDescription description = shape(name, FieldKind::intensity, std::move(parameters), placement);
  description.parameters.push_back(required_size("influence_radius"));
  description.parameters.push_back(weight());
  description.curves = {potential_curve};
  return description;
}

// Where a potential of a node ends, in m: `range` times its influence radius. Refused where the factor
// `length` over that, which gradients are multiplied with, leaves the scalar's numbers.
inline double end_of_influence(const FieldEmitter& emitter, const FieldNode& node, double range,
                               double length) {
  const ScalarLimits& limits = emitter.limits();
  const double radius = node.number("influence_radius");
  const double least = length / limits.end / range, most = std::min(16.0, limits.domain / range);
  emitter.require(node, "influence_radius", radius, {least, most, "m", true});
  return range * radius;
}

// The influence of a node's potential, which ends where the potential's range does.
struct SoftInfluence {
  double radius = 0.0, weight = 0.0;
  std::uint32_t table = 0;

  SoftInfluence(FieldEmitter& emitter, const FieldNode& node) {
    const TableFunction potential = potential_over_square(node.curves.at("potential"));
    table = emitter.table(node, "potential", potential);
    radius = end_of_influence(emitter, node, potential.range, 1.0);
    weight = node.number("weight");
  }
  template <class S>
  Influence<S> in() const {
    return Influence<S>(quantise<S>(radius), quantise<S>(weight));
  }
};

struct SoftPointOperator {
  static OperatorDescription description() {
    return soft_skeleton("soft_point", {}, PlacementParts::position);
  }
  static void add(FieldEmitter& emitter, const FieldNode& node) {
    const SoftInfluence soft(emitter, node);
    emitter.operation(
        [&](auto zero) {
          using S = decltype(zero);
          return SoftPoint<S>{quantise<S>(node.placement.position), soft.in<S>()};
        },
        soft.table);
  }
};

struct SoftSegmentOperator {
  static OperatorDescription description() {
    return soft_skeleton("soft_segment", {required_point("from"), required_point("to")},
                         PlacementParts::none);
  }
  static void add(FieldEmitter& emitter, const FieldNode& node) {
    const SoftInfluence soft(emitter, node);
    const Ends ends = ends_of(emitter, node);
    emitter.operation(
        [&](auto zero) {
          using S = decltype(zero);
          return SoftSegment<S>{quantise_capsule<S>(ends.from, ends.to, 0.0), soft.in<S>()};
        },
        soft.table);
  }
};

struct SoftSumOperator {
  static OperatorDescription description() {
    OperatorDescription description = blend("soft_sum", FieldKind::intensity);
    description.fewest_operands = 1;
    return description;
  }
  static void add(FieldEmitter& emitter, const FieldNode& node) {
    emitter.fold(node, [&] { emitter.operation([](auto zero) { return SoftSum<decltype(zero)>{}; }); });
  }
};

// The potential of one field of another kind: of a union of distances, KW's groups.
template <FieldKind kind>
struct PotentialOperator {
  static OperatorDescription description() {
    OperatorDescription description;
    description.name = kind == FieldKind::distance ? "potential_of_distance" : "potential_of_ray";
    description.kind = FieldKind::intensity;
    description.operand_kind = kind;
    description.fewest_operands = description.most_operands = 1;
    if (kind == FieldKind::distance) description.parameters.push_back(required_size("influence_radius"));
    description.parameters.push_back(weight());
    description.curves = {potential_curve};
    return description;
  }
  static void add(FieldEmitter& emitter, const FieldNode& node) {
    const TableFunction potential = potential_function(node.curves.at("potential"));
    const std::uint32_t table = emitter.table(node, "potential", potential);
    double end = potential.range;
    if constexpr (kind == FieldKind::distance)
      end = end_of_influence(emitter, node, potential.range, 1.0 / 16.0);
    const double weight = node.number("weight");
    const std::size_t first = emitter.step_count();
    emitter.operand(node.operands.front());
    emitter.operation(
        [&](auto zero) {
          using S = decltype(zero);
          return PotentialOf<S, kind>(quantise<S>(end), quantise<S>(weight),
                                      emitter.certificate_since<S>(first));
        },
        table);
  }
};

}  // namespace nearfield::host::operators
