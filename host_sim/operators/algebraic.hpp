// Algebraic fields: 0 on the surface, negative inside.
#pragma once

#include <nearfield/blend/hoffmann_hopcroft.hpp>
#include <nearfield/blend/liming.hpp>
#include <nearfield/modify/convert.hpp>
#include <nearfield/shape/algebraic.hpp>

#include "operators/sharp.hpp"

namespace nearfield::host::operators {

inline constexpr NumberRange coefficient_range{-16.0, 16.0, {}};

inline ParameterDescription coefficients(std::string_view key, std::size_t count,
                                         std::vector<double> default_values = {}) {
  return fitting(Fit::number, {key, count, coefficient_range, std::move(default_values)});
}
inline OperatorDescription algebraic_shape(std::string_view name,
                                           std::vector<ParameterDescription> parameters) {
  return shape(name, FieldKind::algebraic, std::move(parameters), PlacementParts::none);
}
inline OperatorDescription algebraic_of(std::string_view name, FieldKind kind,
                                        ParameterDescription parameter) {
  OperatorDescription description;
  description.name = name;
  description.kind = FieldKind::algebraic;
  description.operand_kind = kind;
  description.fewest_operands = description.most_operands = 1;
  description.parameters = {std::move(parameter)};
  return description;
}

struct AlgebraicPlaneOperator {
  static OperatorDescription description() {
    return algebraic_shape("algebraic_plane", {coefficients("normal", 3), coefficients("offset", 1, {0.0})});
  }
  static void add(FieldEmitter& emitter, const FieldNode& node) {
    emitter.operation([&](auto zero) {
      using S = decltype(zero);
      return AlgebraicPlane<S>{quantise<S>(node.vector("normal")), quantise<S>(node.number("offset"))};
    });
  }
};

struct QuadricOperator {
  static OperatorDescription description() {
    return algebraic_shape("quadric",
                           {coefficients("diagonal", 3), coefficients("off_diagonal", 3, {0.0, 0.0, 0.0}),
                            coefficients("linear", 3, {0.0, 0.0, 0.0}), coefficients("constant", 1)});
  }
  static void add(FieldEmitter& emitter, const FieldNode& node) {
    emitter.operation([&](auto zero) {
      using S = decltype(zero);
      return Quadric<S>{quantise<S>(node.vector("diagonal")), quantise<S>(node.vector("off_diagonal")),
                        quantise<S>(node.vector("linear")), quantise<S>(node.number("constant"))};
    });
  }
};

struct AlgebraicOfDistanceOperator {
  static OperatorDescription description() {
    return algebraic_of("algebraic_of_distance", FieldKind::distance,
                        fitting(Fit::not_zero, {"factor", 1, {-16.0, 16.0, "1/m"}, {1.0}}));
  }
  static void add(FieldEmitter& emitter, const FieldNode& node) {
    emitter.operand(node.operands.front());
    const double factor = node.number("factor");
    emitter.operation([&](auto zero) {
      using S = decltype(zero);
      return AlgebraicOfDistance<S>{quantise<S>(factor)};
    });
  }
};

struct DeclaredBoxOperator {
  static OperatorDescription description() {
    OperatorDescription description;
    description.name = "declared_box";
    description.operand_kind = FieldKind::algebraic;
    description.fewest_operands = description.most_operands = 1;
    description.parameters = {required_edges()};
    return description;
  }
  static void add(FieldEmitter& emitter, const FieldNode& node) {
    emitter.in_declared_box(node, 0.5 * node.vector("size"));
  }
};

struct AlgebraicOfRayOperator {
  static OperatorDescription description() {
    return algebraic_of("algebraic_of_ray", FieldKind::ray,
                        fitting(Fit::length, {"level", 1, {0.0, 1.0, {}, true}, {0.5}}));
  }
  static void add(FieldEmitter& emitter, const FieldNode& node) {
    emitter.operand(node.operands.front());
    const double level = node.number("level");
    emitter.operation([&](auto zero) {
      using S = decltype(zero);
      return AlgebraicOfRay<S>{quantise<S>(level)};
    });
  }
};

// The conic p between the ranges r1 and r2.
struct ConicOfRanges {
  double r1 = 0.0, r2 = 0.0, conic = 0.0;  // p / (r1 r2)

  // Those of a node, refused where (r1 + r2) / r, 1 - conic or (r1 + r2) / (2 - 2 conic) leaves the scalar's
  // numbers.
  ConicOfRanges(const FieldEmitter& emitter, const FieldNode& node)
      : r1(node.number("r1")), r2(node.number("r2")), conic(node.number("p") / (r1 * r2)) {
    const ScalarLimits& limits = emitter.limits();
    const char* const lesser_key = r1 < r2 ? "r1" : "r2";
    const double lesser = std::min(r1, r2), greater = std::max(r1, r2), least = greater / (limits.end - 1.0);
    if (!(lesser > least)) {
      emitter.refuse(node, lesser_key, emitter.misfit(lesser) + " beside " + format_number(greater),
                     "above " + format_number(least));
    }
    // (r1 + r2) / (2 - 2 conic) stays below the end of the number range.
    const double lowest = 1.0 - limits.domain;
    const double highest = std::min(0.875, 1.0 - 0.5 * (r1 + r2) / limits.end);
    if (!(conic >= lowest && conic <= highest)) {
      emitter.refuse(node, "p", emitter.misfit(node.number("p")) + " beside these r1 and r2",
                     "from " + format_number(lowest) + " to " + format_number(highest) + " times r1 r2");
    }
  }
};
template <SetOperation set_operation>
struct HoffmannHopcroftOperator {
  static OperatorDescription description() {
    const NumberRange range{0.0, 16.0, {}, true};
    return blend(pick<set_operation>("hoffmann_hopcroft_union", "hoffmann_hopcroft_intersection",
                                     "hoffmann_hopcroft_difference"),
                 FieldKind::algebraic,
                 {fitting(Fit::length, {"r1", 1, range}),
                  fitting(Fit::length, {"r2", 1, range}),
                  {"p", 1, {-4096.0, 224.0, {}}, {0.0}}});
  }
  static void add(FieldEmitter& emitter, const FieldNode& node) {
    const ConicOfRanges conic(emitter, node);
    emitter.fold(node, [&] {
      emitter.operation([&](auto zero) {
        using S = decltype(zero);
        return HoffmannHopcroft<S, set_operation>::of(quantise<S>(conic.r1), quantise<S>(conic.r2),
                                                      quantise<S>(conic.conic));
      });
    });
  }
};

inline ParameterDescription lambda() { return fitting(Fit::not_zero, {"lambda", 1, {-1.0, 1.0, {}}}); }

// (1 - lambda) L1 L2 + lambda C^2, operands L1, L2, C.
struct LimingOperator {
  static OperatorDescription description() {
    OperatorDescription description = blend("liming", FieldKind::algebraic, {lambda()});
    description.fewest_operands = description.most_operands = 3;
    return description;
  }
  static void add(FieldEmitter& emitter, const FieldNode& node) {
    for (const FieldNode& operand : node.operands) emitter.operand(operand);
    const double share = node.number("lambda");
    emitter.operation([&](auto zero) { return liming(quantise<decltype(zero)>(share)); });
  }
};

// (1 - lambda) product of the primaries + lambda (product of the bounds)^exponent; the primaries come first.
struct FunctionalSplineOperator {
  static OperatorDescription description() {
    OperatorDescription description = blend("functional_spline", FieldKind::algebraic, {lambda()});
    description.parameters.push_back({"primaries", 1, {1.0, 8.0, {}}, {}, {}, true});
    description.parameters.push_back({"exponent", 1, {1.0, 4.0, {}}, {2.0}, {}, true});
    description.most_operands = 16;
    return description;
  }
  static void add(FieldEmitter& emitter, const FieldNode& node) {
    const auto operands = static_cast<std::uint32_t>(node.operands.size());
    const auto primaries = static_cast<std::uint32_t>(node.number("primaries"));
    const auto exponent = static_cast<std::uint32_t>(node.number("exponent"));
    if (primaries >= operands || operands - primaries > FunctionalSpline<float>::greatest_count) {
      emitter.refuse(
          node, "primaries",
          format_number(node.number("primaries")) + " primaries of " + std::to_string(operands) + " operands",
          "1 to 8 operands that are bounds follow them");
    }
    for (const FieldNode& operand : node.operands) emitter.operand(operand);
    const double share = node.number("lambda");
    emitter.operation([&](auto zero) {
      using S = decltype(zero);
      return FunctionalSpline<S>{primaries, operands - primaries, exponent, quantise<S>(share)};
    });
  }
};

}  // namespace nearfield::host::operators
