// Sharp set operations.
#pragma once

#include <nearfield/blend/sharp.hpp>

#include "compile/field_emitter.hpp"
#include "model/field_node.hpp"
#include "operators/description.hpp"

namespace nearfield::host::operators {

// Names by operation: of one family `union`, `intersection`, `subtraction` with what goes before.
template <SetOperation set_operation>
constexpr std::string_view pick(std::string_view unite, std::string_view intersect,
                                std::string_view subtract) {
  return set_operation == SetOperation::unite       ? unite
         : set_operation == SetOperation::intersect ? intersect
                                                    : subtract;
}

template <SetOperation set_operation, FieldKind kind>
struct SharpOperator {
  static OperatorDescription description() {
    switch (kind) {
      case FieldKind::intensity:
        return blend(pick<set_operation>("intensity_union", "intensity_intersection", ""), kind);
      case FieldKind::algebraic:
        return blend(pick<set_operation>("algebraic_union", "algebraic_intersection", ""), kind);
      case FieldKind::ray:
        return blend(pick<set_operation>("ray_union", "ray_intersection", ""), kind);
      case FieldKind::distance:
        break;
    }
    return blend(pick<set_operation>("union", "intersection", "subtraction"), kind);
  }
  static void add(FieldEmitter& emitter, const FieldNode& node) {
    emitter.fold(node, [&] {
      emitter.operation([](auto zero) { return Sharp<decltype(zero), set_operation, kind>{}; });
    });
  }
};

}  // namespace nearfield::host::operators
