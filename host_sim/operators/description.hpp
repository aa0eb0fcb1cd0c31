// What the descriptions of several operators share.
#pragma once

#include <string_view>
#include <utility>
#include <vector>

#include "model/limits.hpp"
#include "model/operators.hpp"

namespace nearfield::host::operators {

inline constexpr std::size_t most_blend_operands = 64;
inline constexpr NumberRange weight_range{-10.0, 10.0, {}};

inline ParameterDescription fitting(Fit fit, ParameterDescription parameter) {
  parameter.fit = fit;
  return parameter;
}
inline ParameterDescription required_size(std::string_view key) {
  return fitting(Fit::length, {key, 1, size_range});
}
// May be 0: of a point, a segment, a circle.
inline ParameterDescription required_radius(std::string_view key) {
  return fitting(Fit::number, {key, 1, {0.0, 16.0, "m"}});
}
// Three full edges of a box about its centre.
inline ParameterDescription required_edges() { return fitting(Fit::edge, {"size", 3, size_range}); }
inline ParameterDescription required_point(std::string_view key) { return {key, 3, position_range}; }

inline OperatorDescription shape(std::string_view name, FieldKind kind,
                                 std::vector<ParameterDescription> parameters, PlacementParts placement) {
  OperatorDescription description;
  description.name = name;
  description.kind = kind;
  description.parameters = std::move(parameters);
  description.placement = placement;
  description.takes_link = true;
  return description;
}

inline OperatorDescription blend(std::string_view name, FieldKind kind,
                                 std::vector<ParameterDescription> parameters = {}) {
  OperatorDescription description;
  description.name = name;
  description.kind = description.operand_kind = kind;
  description.parameters = std::move(parameters);
  description.fewest_operands = 2;
  description.most_operands = most_blend_operands;
  return description;
}

}  // namespace nearfield::host::operators
