// Solids with exact distances.
#pragma once

#include <nearfield/shape/box.hpp>
#include <nearfield/shape/capsule.hpp>
#include <nearfield/shape/cylinder.hpp>
#include <nearfield/shape/sphere.hpp>

#include "compile/quantise.hpp"
#include "model/field_node.hpp"
#include "operators/description.hpp"

namespace nearfield::host::operators {

struct BallOperator {
  static OperatorDescription description() {
    return shape("sphere", FieldKind::distance, {required_size("radius")}, PlacementParts::position);
  }
  template <class Emitter>
  static void add(Emitter& emitter, const FieldNode& node) {
    using S = typename Emitter::Scalar;
    emitter.operation(Sphere<S>{quantise<S>(node.placement.position), quantise<S>(node.number("radius"))});
  }
};

struct CapsuleOperator {
  static OperatorDescription description() {
    return shape("capsule", FieldKind::distance,
                 {required_point("from"), required_point("to"), required_size("radius")},
                 PlacementParts::position_and_orientation);
  }
  template <class Emitter>
  static void add(Emitter& emitter, const FieldNode& node) {
    emitter.operation(quantise_capsule<typename Emitter::Scalar>(
        transform_point(node.placement, node.vector("from")),
        transform_point(node.placement, node.vector("to")), node.number("radius")));
  }
};

struct BoxOperator {
  static OperatorDescription description() {
    return shape("box", FieldKind::distance, {{"size", 3, size_range}},
                 PlacementParts::position_and_orientation);
  }
  template <class Emitter>
  static void add(Emitter& emitter, const FieldNode& node) {
    using S = typename Emitter::Scalar;
    emitter.placed(node.placement, [&](const Vector3d& at) {
      emitter.operation(Box<S>{quantise<S>(at), quantise<S>(0.5 * node.vector("size"))});
    });
  }
};

struct CylinderOperator {
  static OperatorDescription description() {
    return shape("cylinder", FieldKind::distance, {required_size("radius"), required_size("height")},
                 PlacementParts::position_and_orientation);
  }
  template <class Emitter>
  static void add(Emitter& emitter, const FieldNode& node) {
    using S = typename Emitter::Scalar;
    emitter.placed(node.placement, [&](const Vector3d& at) {
      emitter.operation(Cylinder<S>{quantise<S>(at), quantise<S>(node.number("radius")),
                                    quantise<S>(0.5 * node.number("height"))});
    });
  }
};

}  // namespace nearfield::host::operators
