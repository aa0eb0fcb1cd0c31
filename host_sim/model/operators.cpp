#include "model/operators.hpp"

#include "operators/list.hpp"

namespace nearfield::host {

const std::vector<OperatorDescription>& all_operators() {
  static const std::vector<OperatorDescription> operators = operators::All::descriptions();
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
    if (candidate.any_kind || candidate.kind == kind) names.push_back(candidate.name);
  }
  return names;
}

}  // namespace nearfield::host
