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
    return description;
  }
  static void add(FieldEmitter& emitter, const FieldNode& node) {
    emitter.in_frame(node.placement, [&] { emitter.operand(node.operands.front()); });
  }
};

}  // namespace nearfield::host::operators
