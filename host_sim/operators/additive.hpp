// Additive blends of distances: max(x, y) + h(|x - y|).
#pragma once

#include <nearfield/blend/additive.hpp>
#include <nearfield/blend/log_sum_exp.hpp>
#include <nearfield/curve/kernel.hpp>

#include "operators/sharp.hpp"

namespace nearfield::host::operators {

inline const CurveDescription step_curve{"step", CurveFamily::step, "polynomial3"};
inline constexpr NumberRange rising_range{0.0, 64.0, "m", true};

// A kernel whose argument's range is `size` (m) times its own; `differ`: the table has a half for each side.
struct AdditiveKernel {
  double size = 0.0;
  const char* key = "";  // to blame when no table holds it
  TableFunction function;
  bool differ = false;
};

// The kernel of a step: its sides differ when the step is not antisymmetric.
template <class Kernel>
AdditiveKernel kernel_of_step(const FieldNode& node, double size, const std::string& identity,
                              const Kernel& kernel) {
  if (node.curves.at("step").curve.facts().antisymmetric) {
    return {size, "step", table_function(identity, kernel)};
  }
  return {size, "step", table_function("two-sided " + identity, two_sided(kernel)), true};
}

template <SetOperation set_operation, Sides sides>
void fold_additive(FieldEmitter& emitter, const FieldNode& node, const AdditiveKernel& kernel) {
  const std::uint32_t table = emitter.table(node, kernel.key, kernel.function);
  emitter.fold(node, [&] {
    emitter.operation(
        [&](auto zero) {
          using S = decltype(zero);
          Additive<S, set_operation, sides> blend;
          const auto range = product(quantise<S>(kernel.size), quantise<S>(kernel.function.range));
          blend.scale = ArgumentScale<S>::of(narrow<S>(range));
          return blend;
        },
        table);
  });
}
template <SetOperation set_operation>
void add_additive(FieldEmitter& emitter, const FieldNode& node, const AdditiveKernel& kernel) {
  if (kernel.differ) {
    fold_additive<set_operation, Sides::differ>(emitter, node, kernel);
  } else {
    fold_additive<set_operation, Sides::alike>(emitter, node, kernel);
  }
}

inline AdditiveKernel exterior_kernel(const FieldEmitter& emitter, const FieldNode& node) {
  const ConfiguredCurve& step = node.curves.at("step");
  const double radius = node.number("blend_radius"), rising = node.number("rising_range");
  const double domain = emitter.limits().domain;
  if (!(radius + rising <= domain)) {
    emitter.refuse(node, "rising_range",
                   emitter.misfit(rising) + " beside blend_radius " + format_number(radius),
                   "together at most " + format_number(domain) + " m");
  }
  return kernel_of_step(node, radius, "exterior " + format_number(rising / radius) + " " + identity_of(step),
                        exterior(step.curve, rising / radius));
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
  static void add(FieldEmitter& emitter, const FieldNode& node) {
    add_additive<set_operation>(emitter, node, exterior_kernel(emitter, node));
  }
};

inline AdditiveKernel interior_kernel(const FieldNode& node) {
  const ConfiguredCurve& step = node.curves.at("step");
  return kernel_of_step(node, node.number("rising_range"), "interior " + identity_of(step),
                        interior(step.curve));
}
template <SetOperation set_operation>
struct InteriorOperator {
  static OperatorDescription description() {
    OperatorDescription description =
        blend(pick<set_operation>("interior_union", "interior_intersection", "interior_subtraction"),
              FieldKind::distance, {required_size("rising_range")});
    description.curves = {step_curve};
    return description;
  }
  static void add(FieldEmitter& emitter, const FieldNode& node) {
    add_additive<set_operation>(emitter, node, interior_kernel(node));
  }
};

// The range of a log-sum-exp whose range times sharpness is given, in m.
inline double log_sum_exp_range(const FieldEmitter& emitter, const FieldNode& node, double times_sharpness) {
  const double sharpness = node.number("sharpness"), least = times_sharpness / emitter.limits().domain;
  emitter.require(node, "sharpness", sharpness, {std::max(1.0, least), 1e5, "1/m"});
  return times_sharpness / sharpness;
}

// Log-sum-exp with sharpness p: of two operands by a table of its own, of more by the operation that takes
// any number of them; more than that takes are blended in groups, since it is associative.
template <SetOperation set_operation>
struct LogSumExpOperator {
  static OperatorDescription description() {
    return blend(
        pick<set_operation>("log_sum_exp_union", "log_sum_exp_intersection", "log_sum_exp_subtraction"),
        FieldKind::distance, {{"sharpness", 1, {1.0, 1e5, "1/m"}}});
  }
  static void add(FieldEmitter& emitter, const FieldNode& node) {
    if (node.operands.size() == 2) {
      const double range = log_sum_exp_range(emitter, node, LogSumExpKernel::range_times_sharpness);
      return add_additive<set_operation>(
          emitter, node, {range, "sharpness", table_function("log-sum-exp", LogSumExpKernel{})});
    }
    constexpr std::uint32_t most = LogSumExp<float, set_operation>::greatest_operand_count;
    const double range =
        log_sum_exp_range(emitter, node, LogSumExp<float, set_operation>::kRangeTimesSharpness);
    std::uint32_t operands = 0;
    for (const FieldNode& operand : node.operands) {
      emitter.operand(operand);
      ++operands;
      if (operands < most && &operand != &node.operands.back()) continue;
      emitter.operation([&](auto zero) {
        using S = decltype(zero);
        return LogSumExp<S, set_operation>{ArgumentScale<S>::of(quantise<S>(range)), operands};
      });
      operands = 1;
    }
  }
};

template <SetOperation set_operation>
struct QuadraticOperator {
  static OperatorDescription description() {
    return blend(pick<set_operation>("quadratic_union", "quadratic_intersection", "quadratic_subtraction"),
                 FieldKind::distance, {required_size("blend_radius")});
  }
  static void add(FieldEmitter& emitter, const FieldNode& node) {
    add_additive<set_operation>(
        emitter, node,
        {node.number("blend_radius"), "blend_radius", table_function("quadratic", QuadraticKernel{})});
  }
};

template <SetOperation set_operation>
struct CubicOperator {
  static OperatorDescription description() {
    return blend(pick<set_operation>("cubic_union", "cubic_intersection", "cubic_subtraction"),
                 FieldKind::distance, {required_size("blend_radius")});
  }
  static void add(FieldEmitter& emitter, const FieldNode& node) {
    add_additive<set_operation>(
        emitter, node, {node.number("blend_radius"), "blend_radius", table_function("cubic", CubicKernel{})});
  }
};

}  // namespace nearfield::host::operators
