#include "simulate/budget_table.hpp"

#include <algorithm>

#include <nearfield/query/soft_clearance.hpp>

#include "simulate/field_at_rest.hpp"

namespace nearfield::host {
namespace {

struct NamedTarget {
  const char* name;
  const Target& target;
};
const NamedTarget all_targets[] = {
#define NEARFIELD_NAMED_TARGET(name) {#name, target::name},
    NEARFIELD_TARGETS(NEARFIELD_NAMED_TARGET)
#undef NEARFIELD_NAMED_TARGET
};

std::string right_aligned(const std::string& text, std::size_t width) {
  return std::string(width - std::min(width, text.size()), ' ') + text;
}

}  // namespace

std::vector<FieldBudget> budgets_of(const SceneDescription& scene) {
  using S = Fixed<27>;
  RestingSlots<S> links(scene);
  const CompiledField<S> compiled = compile_field<S>(
      scene.field, scene.file,
      [&links](const FieldNode& node, const std::string& link) { return links.slot_of(node, link); });
  const Program<S> program(compiled.image.data(), compiled.inspection);
  // As soft_clearance() asks.
  const bool soft = program.has_highest() && program.certificate().error < S(0.5);
  std::vector<FieldBudget> budgets;
  for (const NamedTarget& each : all_targets) {
    const Budget budget = program.budget(each.target);
    FieldBudget field{each.name, budget.value, budget.gradient, std::nullopt};
    std::replace(field.target.begin(), field.target.end(), '_', '-');
    if (soft) field.soft_clearance = soft_clearance_budget(program, each.target);
    budgets.push_back(std::move(field));
  }
  return budgets;
}

std::string budget_table(const SceneDescription& scene) {
  const std::vector<FieldBudget> budgets = budgets_of(scene);
  std::string text = "target         value  gradient";
  text += budgets.front().soft_clearance ? "  soft clearance\n" : "\n";
  for (const FieldBudget& each : budgets) {
    text += each.target + std::string(12 - std::min<std::size_t>(12, each.target.size()), ' ') +
            right_aligned(std::to_string(each.value), 8) + right_aligned(std::to_string(each.gradient), 10);
    if (each.soft_clearance) text += right_aligned(std::to_string(*each.soft_clearance), 16);
    text += "\n";
  }
  return text;
}

}  // namespace nearfield::host
