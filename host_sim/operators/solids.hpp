// Solids with exact distances.
#pragma once

#include <nearfield/shape/box.hpp>
#include <nearfield/shape/capsule.hpp>
#include <nearfield/shape/cylinder.hpp>
#include <nearfield/shape/sphere.hpp>

#include "compile/field_emitter.hpp"
#include "model/field_node.hpp"
#include "operators/description.hpp"

namespace nearfield::host::operators {

// Ends of an axis, in the frame of the operation.
struct Ends {
  Vector3d from, to;
};
// Those of a node that has them as `from` and `to`, refused where no capsule of the scalar can have them.
inline Ends ends_of(const FieldEmitter& emitter, const FieldNode& node) {
  const Ends ends{transform_point(node.placement, node.vector("from")),
                  transform_point(node.placement, node.vector("to"))};
  emitter.require_coordinates(node, "from", ends.from);
  const double longest = 2.0 * emitter.limits().domain, reach = length(ends.to - ends.from);
  if (reach > longest) {
    emitter.refuse(node, "to", emitter.misfit(reach) + ": the length from `from` to `to`",
                   "at most " + format_number(longest) + " m");
  }
  return ends;
}

struct BallOperator {
  static OperatorDescription description() {
    return shape("sphere", FieldKind::distance, {required_radius("radius")}, PlacementParts::position);
  }
  static void add(FieldEmitter& emitter, const FieldNode& node) {
    const double radius = node.number("radius");
    emitter.operation([&](auto zero) {
      using S = decltype(zero);
      return Sphere<S>{quantise<S>(node.placement.position), quantise<S>(radius)};
    });
  }
};

struct CapsuleOperator {
  static OperatorDescription description() {
    return shape("capsule", FieldKind::distance,
                 {required_point("from"), required_point("to"), required_radius("radius")},
                 PlacementParts::position_and_orientation);
  }
  static void add(FieldEmitter& emitter, const FieldNode& node) {
    const Ends ends = ends_of(emitter, node);
    const double radius = node.number("radius");
    emitter.operation(
        [&](auto zero) { return quantise_capsule<decltype(zero)>(ends.from, ends.to, radius); });
  }
};

struct BoxOperator {
  static OperatorDescription description() {
    return shape("box", FieldKind::distance, {required_edges()}, PlacementParts::position_and_orientation);
  }
  static void add(FieldEmitter& emitter, const FieldNode& node) {
    const Vector3d half = 0.5 * node.vector("size");
    emitter.placed(node.placement, [&](const Vector3d& at) {
      emitter.operation([&](auto zero) {
        using S = decltype(zero);
        return Box<S>{quantise<S>(at), quantise<S>(half)};
      });
    });
  }
};

struct CylinderOperator {
  static OperatorDescription description() {
    return shape("cylinder", FieldKind::distance,
                 {required_size("radius"), fitting(Fit::edge, {"height", 1, size_range})},
                 PlacementParts::position_and_orientation);
  }
  static void add(FieldEmitter& emitter, const FieldNode& node) {
    const double radius = node.number("radius"), half_height = 0.5 * node.number("height");
    emitter.placed(node.placement, [&](const Vector3d& at) {
      emitter.operation([&](auto zero) {
        using S = decltype(zero);
        return Cylinder<S>{quantise<S>(at), quantise<S>(radius), quantise<S>(half_height)};
      });
    });
  }
};

}  // namespace nearfield::host::operators
