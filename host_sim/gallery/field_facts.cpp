#include "gallery/field_facts.hpp"

#include <cstdio>

#include "simulate/budget_table.hpp"
#include "text/number.hpp"

namespace nearfield::host {
namespace {

// In four digits, not below the value.
std::string rounded_up(double value) {
  char text[32];
  std::snprintf(text, sizeof text, "%.4g", value);
  if (parse_number(text).value_or(0.0) < value) std::snprintf(text, sizeof text, "%.4g", value * 1.0005);
  return text;
}

std::string grouped(std::uint32_t number) {
  std::string text = std::to_string(number);
  for (std::size_t at = text.size(); at > 3; at -= 3) text.insert(at - 3, ",");
  return text;
}

}  // namespace

std::string certificate_in_words(const SceneField& field) {
  const FieldProof& proof = field.proof();
  const bool of_distance = field.kind() == Kind::distance;
  const std::string rate =
      !proof.rate ? ""
                  : (of_distance ? "Lipschitz constant " + rounded_up(*proof.rate)
                                 : "rate of change at most " + rounded_up(*proof.rate) + " per m") +
                        ", error at most " +
                        (of_distance ? rounded_up(1e6 * proof.error) + " µm" : rounded_up(proof.error));
  switch (field.kind()) {
    case Kind::distance:
      return proof.rate ? rate : "none: no bound of its slope is known";
    case Kind::intensity:
      if (!field.certified()) return "none: an operand's greatest value in a ball cannot be told";
      return (rate.empty() ? "" : rate + "; ") + "a clearance by the greatest value in a ball";
    case Kind::ray:
      return rate.empty() ? "none: no bound of its slope is known, and a ray function's value is no distance"
                          : rate + "; no clearance: a ray function's value is no distance";
    case Kind::algebraic:
      break;
  }
  return rate.empty() ? "none: an algebraic field's slope has no bound over the whole number range"
                      : rate + "; no clearance: an algebraic value is no distance";
}

std::string budget_in_words(const SceneDescription& scene) {
  for (const FieldBudget& budget : budgets_of(scene)) {
    if (budget.target != "cortex-m4") continue;
    std::string text =
        grouped(budget.value) + " instructions a value, " + grouped(budget.gradient) + " with its gradient";
    if (budget.soft_clearance) text += ", " + grouped(*budget.soft_clearance) + " a soft clearance";
    return text;
  }
  return "not measured";
}

}  // namespace nearfield::host
