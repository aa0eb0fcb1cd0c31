#include "model/operators.hpp"

#include <utility>

#include "model/limits.hpp"

namespace nearfield::host {
namespace {

constexpr std::size_t most_blend_operands = 64;
constexpr NumberRange weight_range{-10.0, 10.0, {}};

ParameterDescription required_size(std::string_view key) { return {key, 1, size_range}; }
ParameterDescription required_point(std::string_view key) { return {key, 3, position_range}; }

OperatorDescription shape(std::string_view name, std::vector<ParameterDescription> parameters,
                          PlacementParts placement) {
  OperatorDescription row;
  row.name = name;
  row.parameters = std::move(parameters);
  row.placement = placement;
  row.takes_link = true;
  return row;
}

OperatorDescription blend(std::string_view name) {
  OperatorDescription row;
  row.name = name;
  row.fewest_operands = 2;
  row.most_operands = most_blend_operands;
  return row;
}

OperatorDescription exterior_blend(std::string_view name) {
  OperatorDescription row = blend(name);
  row.parameters = {required_size("blend_radius"),
                    {"rising_range", 1, {0.0, 64.0, "m", true}, {}, RatioRule{"blend_radius", 0.05, 4.0}}};
  row.choices = {{"step", {"polynomial3", "polynomial1", "polynomial2"}}};
  return row;
}

OperatorDescription placed() {
  OperatorDescription row;
  row.name = "place";
  row.fewest_operands = 1;
  row.most_operands = 1;
  row.placement = PlacementParts::position_and_orientation;
  row.takes_link = true;
  row.needs_placement = true;
  return row;
}

OperatorDescription soft_skeleton(std::string_view name, std::vector<ParameterDescription> parameters,
                                  PlacementParts placement) {
  OperatorDescription row = shape(name, std::move(parameters), placement);
  row.kind = FieldKind::intensity;
  row.parameters.push_back(required_size("influence_radius"));
  row.parameters.push_back({"weight", 1, weight_range, {1.0}});
  row.choices = {{"potential", {"wyvill"}}};
  return row;
}

OperatorDescription soft_sum() {
  OperatorDescription row;
  row.name = "soft_sum";
  row.kind = FieldKind::intensity;
  row.fewest_operands = 1;
  row.most_operands = most_blend_operands;
  row.operand_kind = FieldKind::intensity;
  return row;
}

}  // namespace

const std::vector<OperatorDescription>& all_operators() {
  static const std::vector<OperatorDescription> operators{
      shape("sphere", {required_size("radius")}, PlacementParts::position),
      shape("capsule", {required_point("from"), required_point("to"), required_size("radius")},
            PlacementParts::position_and_orientation),
      shape("box", {{"size", 3, size_range}}, PlacementParts::position_and_orientation),
      shape("cylinder", {required_size("radius"), required_size("height")},
            PlacementParts::position_and_orientation),
      blend("union"),
      blend("intersection"),
      blend("subtraction"),
      exterior_blend("exterior_union"),
      exterior_blend("exterior_intersection"),
      exterior_blend("exterior_subtraction"),
      placed(),
      soft_skeleton("soft_point", {}, PlacementParts::position),
      soft_skeleton("soft_segment", {required_point("from"), required_point("to")}, PlacementParts::none),
      soft_sum(),
  };
  return operators;
}

const OperatorDescription* find_operator(std::string_view name) {
  for (const OperatorDescription& candidate : all_operators()) {
    if (candidate.name == name) return &candidate;
  }
  return nullptr;
}

std::vector<std::string_view> operator_names(FieldKind kind) {
  std::vector<std::string_view> names;
  for (const OperatorDescription& candidate : all_operators()) {
    if (candidate.kind == kind) names.push_back(candidate.name);
  }
  return names;
}

}  // namespace nearfield::host
