// What a scene's field costs on each target: what `nearfield budget` prints.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "model/scene_description.hpp"

namespace nearfield::host {

// Worst-case instructions of a query on a target.
struct FieldBudget {
  std::string target;  // `cortex-m4`
  std::uint32_t value = 0, gradient = 0;
  std::optional<std::uint32_t> soft_clearance;  // of intensities that have one
};

// For each target whose costs have been measured, in Fixed<27>. InputError as budget_table().
std::vector<FieldBudget> budgets_of(const SceneDescription& scene);

// A line for each target whose costs have been measured, under a heading: worst-case instructions of a value, of
// value with gradient and all checks (for distances that is a clearance), and, of intensities, of a soft clearance.
// Fixed<27>. InputError when the field does not fit that, or names links that the scene does not have.
std::string budget_table(const SceneDescription& scene);

}  // namespace nearfield::host
