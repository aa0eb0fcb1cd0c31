// Algebraic fields: 0 on the surface, negative inside.
#pragma once

#include <nearfield/blend/hoffmann_hopcroft.hpp>
#include <nearfield/blend/liming.hpp>
#include <nearfield/blend/patch.hpp>
#include <nearfield/modify/convert.hpp>
#include <nearfield/shape/algebraic.hpp>

#include "compile/quantise.hpp"
#include "operators/sharp.hpp"

namespace nearfield::host::operators {

inline constexpr NumberRange coefficient_range{-16.0, 16.0, {}};

inline ParameterDescription coefficients(std::string_view key, std::size_t count,
                                         std::vector<double> default_values = {}) {
  return {key, count, coefficient_range, std::move(default_values)};
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
  template <class Emitter>
  static void add(Emitter& emitter, const FieldNode& node) {
    using S = typename Emitter::Scalar;
    emitter.operation(
        AlgebraicPlane<S>{quantise<S>(node.vector("normal")), quantise<S>(node.number("offset"))});
  }
};

struct QuadricOperator {
  static OperatorDescription description() {
    return algebraic_shape("quadric",
                           {coefficients("diagonal", 3), coefficients("off_diagonal", 3, {0.0, 0.0, 0.0}),
                            coefficients("linear", 3, {0.0, 0.0, 0.0}), coefficients("constant", 1)});
  }
  template <class Emitter>
  static void add(Emitter& emitter, const FieldNode& node) {
    using S = typename Emitter::Scalar;
    emitter.operation(Quadric<S>{quantise<S>(node.vector("diagonal")),
                                 quantise<S>(node.vector("off_diagonal")), quantise<S>(node.vector("linear")),
                                 quantise<S>(node.number("constant"))});
  }
};

struct AlgebraicOfDistanceOperator {
  static OperatorDescription description() {
    return algebraic_of("algebraic_of_distance", FieldKind::distance,
                        {"factor", 1, {-16.0, 16.0, "1/m"}, {1.0}});
  }
  template <class Emitter>
  static void add(Emitter& emitter, const FieldNode& node) {
    using S = typename Emitter::Scalar;
    emitter.operand(node.operands.front());
    emitter.operation(AlgebraicOfDistance<S>{quantise<S>(node.number("factor"))});
  }
};

struct DeclaredBoxOperator {
  static OperatorDescription description() {
    OperatorDescription description;
    description.name = "declared_box";
    description.operand_kind = FieldKind::algebraic;
    description.fewest_operands = description.most_operands = 1;
    description.parameters = {{"size", 3, size_range}};
    return description;
  }
  template <class Emitter>
  static void add(Emitter& emitter, const FieldNode& node) {
    emitter.in_declared_box(node, quantise<typename Emitter::Scalar>(0.5 * node.vector("size")));
  }
};

struct AlgebraicOfRayOperator {
  static OperatorDescription description() {
    return algebraic_of("algebraic_of_ray", FieldKind::ray, {"level", 1, {0.0, 1.0, {}, true}, {0.5}});
  }
  template <class Emitter>
  static void add(Emitter& emitter, const FieldNode& node) {
    using S = typename Emitter::Scalar;
    emitter.operand(node.operands.front());
    emitter.operation(AlgebraicOfRay<S>{quantise<S>(node.number("level"))});
  }
};

// The conic p between the ranges r1 and r2.
template <SetOperation set_operation>
struct HoffmannHopcroftOperator {
  static OperatorDescription description() {
    const NumberRange range{0.0, 16.0, {}, true};
    return blend(pick<set_operation>("hoffmann_hopcroft_union", "hoffmann_hopcroft_intersection",
                                     "hoffmann_hopcroft_difference"),
                 FieldKind::algebraic,
                 {{"r1", 1, range}, {"r2", 1, range}, {"p", 1, {-4096.0, 224.0, {}}, {0.0}}});
  }
  template <class Emitter>
  static void add(Emitter& emitter, const FieldNode& node) {
    using S = typename Emitter::Scalar;
    const double r1 = node.number("r1"), r2 = node.number("r2"), conic = node.number("p") / (r1 * r2);
    const double lowest = 1.0 - ScalarTraits<S>::to_double(ScalarTraits<S>::domain());
    if (!(conic >= lowest && conic <= 0.875)) {
      emitter.refuse(node, "p", format_number(node.number("p")) + " does not fit r1 and r2",
                     "from " + format_number(lowest) + " to 0.875 times r1 r2");
    }
    const auto blend =
        HoffmannHopcroft<S, set_operation>::of(quantise<S>(r1), quantise<S>(r2), quantise<S>(conic));
    emitter.fold(node, [&] { emitter.operation(blend); });
  }
};

// (1 - lambda) L1 L2 + lambda C^2, operands L1, L2, C.
struct LimingOperator {
  static OperatorDescription description() {
    OperatorDescription description = blend("liming", FieldKind::algebraic, {{"lambda", 1, {-1.0, 1.0, {}}}});
    description.fewest_operands = description.most_operands = 3;
    return description;
  }
  template <class Emitter>
  static void add(Emitter& emitter, const FieldNode& node) {
    for (const FieldNode& operand : node.operands) emitter.operand(operand);
    emitter.operation(liming(quantise<typename Emitter::Scalar>(node.number("lambda"))));
  }
};

// (1 - lambda) product of the primaries + lambda (product of the bounds)^exponent; the primaries come first.
struct FunctionalSplineOperator {
  static OperatorDescription description() {
    OperatorDescription description =
        blend("functional_spline", FieldKind::algebraic, {{"lambda", 1, {-1.0, 1.0, {}}}});
    description.parameters.push_back({"primaries", 1, {1.0, 8.0, {}}, {}, {}, true});
    description.parameters.push_back({"exponent", 1, {1.0, 4.0, {}}, {2.0}, {}, true});
    description.most_operands = 16;
    return description;
  }
  template <class Emitter>
  static void add(Emitter& emitter, const FieldNode& node) {
    using S = typename Emitter::Scalar;
    FunctionalSpline<S> spline;
    const auto operands = static_cast<std::uint32_t>(node.operands.size());
    spline.primary_count = static_cast<std::uint32_t>(node.number("primaries"));
    if (spline.primary_count >= operands ||
        operands - spline.primary_count > FunctionalSpline<S>::greatest_count) {
      emitter.refuse(
          node, "primaries",
          format_number(node.number("primaries")) + " primaries of " + std::to_string(operands) + " operands",
          "1 to 8 operands that are bounds follow them");
    }
    spline.bound_count = operands - spline.primary_count;
    spline.exponent = static_cast<std::uint32_t>(node.number("exponent"));
    spline.lambda = quantise<S>(node.number("lambda"));
    for (const FieldNode& operand : node.operands) emitter.operand(operand);
    emitter.operation(spline);
  }
};

// What both kinds of I-patches have: sides, half as many as operands.
inline OperatorDescription patch(std::string_view name, std::size_t fewest_sides) {
  OperatorDescription description = blend(name, FieldKind::algebraic);
  ParameterDescription weights = coefficients("side_weights", fewest_sides);
  weights.most = kGreatestSideCount;
  ParameterDescription through{"through", 3, position_range};
  through.optional = true;
  description.parameters = {std::move(weights),
                            coefficients("centre_weight", 1, {0.0}),
                            std::move(through),
                            {"exponent", 1, {2.0, 3.0, {}}, {2.0}, {}, true}};
  description.fewest_operands = 2 * fewest_sides;
  description.most_operands = std::size_t{2} * kGreatestSideCount;
  return description;
}

// Where `through` is given, the centre's weight that makes the patch 0 there replaces the one given: the
// patch is its value without it, and a share of it.
template <class Patch, class Emitter>
void add_patch(Emitter& emitter, const FieldNode& node) {
  using S = typename Emitter::Scalar;
  const std::vector<double>& weights = node.parameters.at("side_weights");
  if (2 * weights.size() != node.operands.size()) {
    emitter.refuse(
        node, "side_weights",
        std::to_string(weights.size()) + " weights for " + std::to_string(node.operands.size()) + " operands",
        "one for every two operands");
  }
  Patch patch;
  patch.side_count = static_cast<std::uint32_t>(weights.size());
  patch.exponent = static_cast<std::uint32_t>(node.number("exponent"));
  for (std::size_t i = 0; i < weights.size(); ++i) patch.side_weight[i] = quantise<S>(weights[i]);
  patch.centre_weight = quantise<S>(node.number("centre_weight"));
  if (!node.parameters.at("through").empty()) {
    const auto value_with = [&](double weight) {
      Patch trial = patch;
      trial.centre_weight = quantise<S>(weight);
      return emitter.trial_value(node, node.vector("through"), [&] { emitter.operation(trial); });
    };
    const double without = value_with(0.0), share = value_with(1.0) - without;
    const double weight = share != 0.0 ? -without / share : 0.0;
    const double limit = ScalarTraits<S>::to_double(ScalarTraits<S>::domain());
    if (!(share != 0.0 && weight >= -limit && weight <= limit)) {
      emitter.refuse(node, "through", "no weight within the number range leads the patch through this point",
                     "a point away from all bounds, near the ribbons");
    }
    patch.centre_weight = quantise<S>(weight);
  }
  for (const FieldNode& operand : node.operands) emitter.operand(operand);
  emitter.operation(patch);
}

// Operands P1, B1, P2, B2, ...
struct RibbonPatchOperator {
  static OperatorDescription description() { return patch("ribbon_patch", 2); }
  template <class Emitter>
  static void add(Emitter& emitter, const FieldNode& node) {
    add_patch<RibbonPatch<typename Emitter::Scalar>>(emitter, node);
  }
};

// Operands C1, ..., Cn, B1, ..., Bn.
struct CornerPatchOperator {
  static OperatorDescription description() { return patch("corner_patch", 3); }
  template <class Emitter>
  static void add(Emitter& emitter, const FieldNode& node) {
    add_patch<CornerPatch<typename Emitter::Scalar>>(emitter, node);
  }
};

}  // namespace nearfield::host::operators
