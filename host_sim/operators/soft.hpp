// Soft objects: intensities around skeletons, and their sum.
#pragma once

#include <nearfield/blend/soft.hpp>
#include <nearfield/modify/potential.hpp>
#include <nearfield/shape/soft.hpp>

#include "compile/quantise.hpp"
#include "compile/table_baker.hpp"
#include "model/field_node.hpp"
#include "operators/description.hpp"

namespace nearfield::host::operators {

inline const CurveDescription potential_curve{"potential", CurveFamily::potential, "wyvill"};
inline ParameterDescription weight() { return {"weight", 1, weight_range, {1.0}}; }

inline OperatorDescription soft_skeleton(std::string_view name, std::vector<ParameterDescription> parameters,
                                         PlacementParts placement) {
  OperatorDescription description = shape(name, FieldKind::intensity, std::move(parameters), placement);
  description.parameters.push_back(required_size("influence_radius"));
  description.parameters.push_back(weight());
  description.curves = {potential_curve};
  return description;
}

// The influence of a node's potential, which ends where the potential's range does.
template <class Emitter>
struct SoftInfluence {
  using S = typename Emitter::Scalar;
  Influence<S> influence;
  std::uint32_t table = 0;

  SoftInfluence(Emitter& emitter, const FieldNode& node) {
    const TableFunction potential = potential_over_square(node.curves.at("potential"));
    table = emitter.table(node, "potential", potential).reference;
    influence = Influence<S>(quantise<S>(potential.range * node.number("influence_radius")),
                             quantise<S>(node.number("weight")));
  }
};

struct SoftPointOperator {
  static OperatorDescription description() {
    return soft_skeleton("soft_point", {}, PlacementParts::position);
  }
  template <class Emitter>
  static void add(Emitter& emitter, const FieldNode& node) {
    using S = typename Emitter::Scalar;
    const SoftInfluence<Emitter> soft(emitter, node);
    emitter.operation(SoftPoint<S>{quantise<S>(node.placement.position), soft.influence}, soft.table);
  }
};

struct SoftSegmentOperator {
  static OperatorDescription description() {
    return soft_skeleton("soft_segment", {required_point("from"), required_point("to")},
                         PlacementParts::none);
  }
  template <class Emitter>
  static void add(Emitter& emitter, const FieldNode& node) {
    using S = typename Emitter::Scalar;
    const SoftInfluence<Emitter> soft(emitter, node);
    emitter.operation(
        SoftSegment<S>{quantise_capsule<S>(node.vector("from"), node.vector("to"), 0.0), soft.influence},
        soft.table);
  }
};

struct SoftSumOperator {
  static OperatorDescription description() {
    OperatorDescription description = blend("soft_sum", FieldKind::intensity);
    description.fewest_operands = 1;
    return description;
  }
  template <class Emitter>
  static void add(Emitter& emitter, const FieldNode& node) {
    emitter.fold(node, [&] { emitter.operation(SoftSum<typename Emitter::Scalar>{}); });
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
  template <class Emitter>
  static void add(Emitter& emitter, const FieldNode& node) {
    using S = typename Emitter::Scalar;
    const TableFunction potential = potential_function(node.curves.at("potential"));
    const std::uint32_t table = emitter.table(node, "potential", potential).reference;
    const double radius = kind == FieldKind::distance ? node.number("influence_radius") : 1.0;
    const Certificate<S> operand = emitter.certified_operand(node.operands.front());
    emitter.operation(PotentialOf<S, kind>(quantise<S>(potential.range * radius),
                                           quantise<S>(node.number("weight")), operand),
                      table);
  }
};

}  // namespace nearfield::host::operators
