// Fields that change while they run: parameters that come with each query, by the number of their slot.
#pragma once

#include <nearfield/modify/parameter.hpp>

#include "operators/sharp.hpp"

namespace nearfield::host::operators {

inline ParameterDescription parameter_slot() {
  ParameterDescription slot{"parameter_slot", 1, {0.0, double{kParameterLimit - 1}, {}}};
  slot.whole = true;
  return slot;
}
inline std::uint32_t slot_in(const FieldNode& node) {
  return static_cast<std::uint32_t>(node.number("parameter_slot"));
}
inline OperatorDescription of_one(OperatorDescription description) {
  description.fewest_operands = description.most_operands = 1;
  return description;
}

template <FieldKind kind>
struct MorphOperator {
  static OperatorDescription description() {
    constexpr std::string_view name = kind == FieldKind::distance    ? "morph"
                                      : kind == FieldKind::intensity ? "intensity_morph"
                                                                     : "ray_morph";
    OperatorDescription description = blend(name, kind, {parameter_slot()});
    description.most_operands = 2;
    return description;
  }
  static void add(FieldEmitter& emitter, const FieldNode& node) {
    for (const FieldNode& operand : node.operands) emitter.operand(operand);
    emitter.operation([&](auto zero) { return MorphOf<decltype(zero), kind>{slot_in(node)}; });
  }
};

struct SwellOperator {
  static OperatorDescription description() {
    return of_one(blend("swell", FieldKind::distance,
                        {fitting(Fit::number, {"radius", 1, {-16.0, 16.0, "m"}}), parameter_slot()}));
  }
  static void add(FieldEmitter& emitter, const FieldNode& node) {
    emitter.operand(node.operands.front());
    const double radius = node.number("radius");
    emitter.operation([&](auto zero) {
      using S = decltype(zero);
      return Swell<S>{quantise<S>(radius), slot_in(node)};
    });
  }
};

struct FadeOperator {
  static OperatorDescription description() {
    return of_one(blend("fade", FieldKind::intensity, {parameter_slot()}));
  }
  static void add(FieldEmitter& emitter, const FieldNode& node) {
    emitter.operand(node.operands.front());
    emitter.operation([&](auto zero) { return Fade<decltype(zero)>{slot_in(node)}; });
  }
};

}  // namespace nearfield::host::operators
