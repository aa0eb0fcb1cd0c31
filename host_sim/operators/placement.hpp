// Frames of their own.
#pragma once

#include "compile/field_emitter.hpp"
#include "model/field_node.hpp"
#include "operators/description.hpp"

namespace nearfield::host::operators {

struct PlaceOperator {
  static OperatorDescription description() {
    OperatorDescription description;
    description.name = "place";
    description.any_kind = true;
    description.fewest_operands = 1;
    description.most_operands = 1;
    description.placement = PlacementParts::position_and_orientation;
    description.takes_link = true;
    description.needs_placement = true;
    description.parameters = {{"scale", 1, {0.125, 8.0, {}}, {1.0}}};
    return description;
  }
  static void add(FieldEmitter& emitter, const FieldNode& node) {
    const double scale = node.number("scale");
    const auto operand = [&] { emitter.operand(node.operands.front()); };
    const auto sized = [&] { scale == 1.0 ? operand() : emitter.scaled(scale, operand); };
    is_identity(node.placement) ? sized() : emitter.in_frame(node.placement, sized);
  }
};

}  // namespace nearfield::host::operators
