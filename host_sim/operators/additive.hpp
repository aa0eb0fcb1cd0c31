// Additive blends of distances: max(x, y) + h(|x - y|).
#pragma once

#include <nearfield/blend/additive.hpp>
#include <nearfield/blend/log_sum_exp.hpp>
#include <nearfield/curve/kernel.hpp>

#include "compile/quantise.hpp"
#include "compile/table_baker.hpp"
#include "operators/sharp.hpp"

namespace nearfield::host::operators {

inline const CurveDescription step_curve{"step", CurveFamily::step, "polynomial3"};
inline constexpr NumberRange rising_range{0.0, 64.0, "m", true};

// Adds the blend of a kernel; `size` (m): what its argument's range is a multiple of. `key` names the
// parameter to blame when no table can hold the kernel.
template <SetOperation set_operation, Sides sides = Sides::alike, class Emitter>
void add_additive(Emitter& emitter, const FieldNode& node, double size, const char* key,
                  const TableFunction& kernel) {
  using S = typename Emitter::Scalar;
  const auto table = emitter.table(node, key, kernel);
  Additive<S, set_operation, sides> blend;
  blend.scale = ArgumentScale<S>::of(narrow<S>(product(quantise<S>(size), table.range)));
  emitter.fold(node, [&] { emitter.operation(blend, table.reference); });
}

// The same for a kernel of a step: one whose sides differ when the step is not antisymmetric.
template <SetOperation set_operation, class Emitter, class Kernel>
void add_additive_of_step(Emitter& emitter, const FieldNode& node, double size, const std::string& identity,
                          const Kernel& kernel) {
  if (node.curves.at("step").curve.facts().antisymmetric) {
    add_additive<set_operation>(emitter, node, size, "step", table_function(identity, kernel));
  } else {
    add_additive<set_operation, Sides::differ>(emitter, node, size, "step",
                                               table_function("two-sided " + identity, two_sided(kernel)));
  }
}

template <SetOperation set_operation>
struct ExteriorOperator {
  static OperatorDescription description() {
    OperatorDescription description =
        blend(pick<set_operation>("exterior_union", "exterior_intersection", "exterior_subtraction"),
              FieldKind::distance,
              {required_size("blend_radius"),
               {"rising_range", 1, rising_range, {}, RatioRule{"blend_radius", 0.05, 4.0}}});
    description.curves = {step_curve};
    return description;
  }
  template <class Emitter>
  static void add(Emitter& emitter, const FieldNode& node) {
    const ConfiguredCurve& step = node.curves.at("step");
    const double ratio = node.number("rising_range") / node.number("blend_radius");
    add_additive_of_step<set_operation>(emitter, node, node.number("blend_radius"),
                                        "exterior " + format_number(ratio) + " " + identity_of(step),
                                        exterior(step.curve, ratio));
  }
};

template <SetOperation set_operation>
struct InteriorOperator {
  static OperatorDescription description() {
    OperatorDescription description =
        blend(pick<set_operation>("interior_union", "interior_intersection", "interior_subtraction"),
              FieldKind::distance, {{"rising_range", 1, size_range}});
    description.curves = {step_curve};
    return description;
  }
  template <class Emitter>
  static void add(Emitter& emitter, const FieldNode& node) {
    const ConfiguredCurve& step = node.curves.at("step");
    add_additive_of_step<set_operation>(emitter, node, node.number("rising_range"),
                                        "interior " + identity_of(step), interior(step.curve));
  }
};

// Log-sum-exp with sharpness p: of two operands by a table of its own, of more by the operation that takes
// any number of them; more than that takes are blended in groups, since it is associative.
template <SetOperation set_operation>
struct LogSumExpOperator {
  static OperatorDescription description() {
    return blend(
        pick<set_operation>("log_sum_exp_union", "log_sum_exp_intersection", "log_sum_exp_subtraction"),
        FieldKind::distance, {{"sharpness", 1, {1.0, 1e5, "1/m"}}});
  }
  template <class Emitter>
  static void add(Emitter& emitter, const FieldNode& node) {
    using S = typename Emitter::Scalar;
    using Blend = LogSumExp<S, set_operation>;
    const double sharpness = node.number("sharpness");
    if (node.operands.size() == 2) {
      return add_additive<set_operation>(emitter, node, LogSumExpKernel::range_times_sharpness / sharpness,
                                         "sharpness", table_function("log-sum-exp", LogSumExpKernel{}));
    }
    Blend blend;
    blend.scale = ArgumentScale<S>::of(quantise<S>(Blend::kRangeTimesSharpness / sharpness));
    for (const FieldNode& operand : node.operands) {
      emitter.operand(operand);
      ++blend.operands;
      if (blend.operands < Blend::greatest_operand_count && &operand != &node.operands.back()) continue;
      emitter.operation(blend);
      blend.operands = 1;
    }
  }
};

template <SetOperation set_operation>
struct QuadraticOperator {
  static OperatorDescription description() {
    return blend(pick<set_operation>("quadratic_union", "quadratic_intersection", "quadratic_subtraction"),
                 FieldKind::distance, {required_size("blend_radius")});
  }
  template <class Emitter>
  static void add(Emitter& emitter, const FieldNode& node) {
    add_additive<set_operation>(emitter, node, node.number("blend_radius"), "blend_radius",
                                table_function("quadratic", QuadraticKernel{}));
  }
};

template <SetOperation set_operation>
struct CubicOperator {
  static OperatorDescription description() {
    return blend(pick<set_operation>("cubic_union", "cubic_intersection", "cubic_subtraction"),
                 FieldKind::distance, {required_size("blend_radius")});
  }
  template <class Emitter>
  static void add(Emitter& emitter, const FieldNode& node) {
    add_additive<set_operation>(emitter, node, node.number("blend_radius"), "blend_radius",
                                table_function("cubic", CubicKernel{}));
  }
};

}  // namespace nearfield::host::operators
