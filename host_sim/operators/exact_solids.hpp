// Solids of revolution, solids without an end, and solids grown or shrunk.
#pragma once

#include <nearfield/modify/offset.hpp>
#include <nearfield/shape/cone_frustum.hpp>
#include <nearfield/shape/disc.hpp>
#include <nearfield/shape/tapered_capsule.hpp>
#include <nearfield/shape/torus.hpp>
#include <nearfield/shape/unbounded.hpp>

#include <algorithm>
#include <cmath>

#include "operators/solids.hpp"

namespace nearfield::host::operators {

struct TaperedCapsuleOperator {
  static OperatorDescription description() {
    return shape("tapered_capsule", FieldKind::distance,
                 {required_point("from"), required_point("to"), required_radius("radius_from"),
                  required_radius("radius_to")},
                 PlacementParts::position_and_orientation);
  }
  static void add(FieldEmitter& emitter, const FieldNode& node) {
    const Ends ends = ends_of(emitter, node);
    const double radius_from = node.number("radius_from"), radius_to = node.number("radius_to");
    emitter.operation([&](auto zero) {
      using S = decltype(zero);
      return TaperedCapsule<S>(quantise_capsule<S>(ends.from, ends.to, radius_from), quantise<S>(radius_to));
    });
  }
};

struct ConeFrustumOperator {
  static OperatorDescription description() {
    return shape("cone_frustum", FieldKind::distance,
                 {required_radius("radius_below"), required_radius("radius_above"),
                  fitting(Fit::edge, {"height", 1, size_range})},
                 PlacementParts::position_and_orientation);
  }
  static void add(FieldEmitter& emitter, const FieldNode& node) {
    const double below = node.number("radius_below"), above = node.number("radius_above"),
                 half_height = 0.5 * node.number("height");
    if (!(std::max(below, above) > emitter.limits().least)) {
      emitter.refuse(node, "radius_above", "both radii are 0", "one of them above 0");
    }
    emitter.placed(node.placement, [&](const Vector3d& at) {
      emitter.operation([&](auto zero) {
        using S = decltype(zero);
        return ConeFrustum<S>(quantise<S>(at), quantise<S>(below), quantise<S>(above),
                              quantise<S>(half_height));
      });
    });
  }
};

struct TorusOperator {
  static OperatorDescription description() {
    ParameterDescription tube = required_radius("tube_radius");
    tube.ratio = RatioRule{"ring_radius", 0.0, 1.0};
    return shape("torus", FieldKind::distance, {required_size("ring_radius"), std::move(tube)},
                 PlacementParts::position_and_orientation);
  }
  static void add(FieldEmitter& emitter, const FieldNode& node) {
    const double ring = node.number("ring_radius"), tube = node.number("tube_radius");
    emitter.placed(node.placement, [&](const Vector3d& at) {
      emitter.operation([&](auto zero) {
        using S = decltype(zero);
        return Torus<S>{quantise<S>(at), quantise<S>(ring), quantise<S>(tube)};
      });
    });
  }
};

struct DiscOperator {
  static OperatorDescription description() {
    ParameterDescription thickness = required_radius("thickness");
    thickness.default_values = {0.0};
    return shape("disc", FieldKind::distance, {required_radius("radius"), std::move(thickness)},
                 PlacementParts::position_and_orientation);
  }
  static void add(FieldEmitter& emitter, const FieldNode& node) {
    const double radius = node.number("radius"), thickness = node.number("thickness");
    emitter.placed(node.placement, [&](const Vector3d& at) {
      emitter.operation([&](auto zero) {
        using S = decltype(zero);
        return Disc<S>{quantise<S>(at), quantise<S>(radius), quantise<S>(thickness)};
      });
    });
  }
};

struct HalfSpaceOperator {
  static OperatorDescription description() {
    return shape("half_space", FieldKind::distance, {{"normal", 3, {-1e6, 1e6, {}}}},
                 PlacementParts::position);
  }
  static void add(FieldEmitter& emitter, const FieldNode& node) {
    const Vector3d normal = node.vector("normal");
    const double size = length(normal);
    if (!(size > 0.0)) emitter.refuse(node, "normal", "a zero vector has no direction", "any other");
    emitter.operation([&](auto zero) {
      using S = decltype(zero);
      return HalfSpace<S>{quantise<S>(node.placement.position), quantise_unit<S>(unit_of(normal))};
    });
  }
};

struct InfiniteCylinderOperator {
  static OperatorDescription description() {
    return shape("infinite_cylinder", FieldKind::distance, {required_radius("radius")},
                 PlacementParts::position_and_orientation);
  }
  static void add(FieldEmitter& emitter, const FieldNode& node) {
    const double radius = node.number("radius");
    emitter.placed(node.placement, [&](const Vector3d& at) {
      emitter.operation([&](auto zero) {
        using S = decltype(zero);
        return InfiniteCylinder<S>{quantise<S>(at.x), quantise<S>(at.y), quantise<S>(radius)};
      });
    });
  }
};

struct InfiniteConeOperator {
  static constexpr double right_angle = 1.5707963267948966;
  static OperatorDescription description() {
    return shape("infinite_cone", FieldKind::distance, {{"half_angle", 1, {0.0, right_angle, "rad"}}},
                 PlacementParts::position_and_orientation);
  }
  static void add(FieldEmitter& emitter, const FieldNode& node) {
    const double sine = std::sin(node.number("half_angle")), cosine = std::cos(node.number("half_angle"));
    emitter.placed(node.placement, [&](const Vector3d& at) {
      emitter.operation([&](auto zero) {
        using S = decltype(zero);
        return InfiniteCone<S>{quantise<S>(at), quantise<Unit<S>>(sine), quantise<Unit<S>>(cosine)};
      });
    });
  }
};

struct OffsetOperator {
  static OperatorDescription description() {
    OperatorDescription description =
        blend("offset", FieldKind::distance, {fitting(Fit::number, {"radius", 1, {-16.0, 16.0, "m"}})});
    description.fewest_operands = description.most_operands = 1;
    return description;
  }
  static void add(FieldEmitter& emitter, const FieldNode& node) {
    emitter.operand(node.operands.front());
    add_offset(emitter, node);
  }
  // By the node's `radius`.
  static void add_offset(FieldEmitter& emitter, const FieldNode& node) {
    const double radius = node.number("radius");
    emitter.operation([&](auto zero) {
      using S = decltype(zero);
      return Offset<S>{quantise<S>(radius)};
    });
  }
};

// `size` is the outer one.
struct RoundedBoxOperator {
  static OperatorDescription description() {
    return shape("rounded_box", FieldKind::distance, {required_edges(), required_radius("radius")},
                 PlacementParts::position_and_orientation);
  }
  static void add(FieldEmitter& emitter, const FieldNode& node) {
    const double radius = node.number("radius");
    const Vector3d half = 0.5 * node.vector("size");
    const double least = std::min({half.x, half.y, half.z});
    if (!(least - radius > emitter.limits().least)) {
      emitter.refuse(node, "radius", format_number(radius) + " leaves nothing of the least edge",
                     "below half of it, " + format_number(least) + " m");
    }
    emitter.placed(node.placement, [&](const Vector3d& at) {
      emitter.operation([&](auto zero) {
        using S = decltype(zero);
        return Box<S>{quantise<S>(at), quantise<S>(half - Vector3d{radius, radius, radius})};
      });
      OffsetOperator::add_offset(emitter, node);
    });
  }
};

}  // namespace nearfield::host::operators
