#pragma once

#include <cstddef>
#include <optional>
#include <string_view>
#include <vector>

#include "model/json_values.hpp"
#include "text/number.hpp"

namespace nearfield::host {

// What a field's value means: a distance in m, negative inside; or an intensity, 0.5 on the soft surface.
enum class FieldKind { distance, intensity };

// A parameter whose value must lie between two multiples of another one's.
struct RatioRule {
  std::string_view other_key;
  double lowest = 0.0;
  double highest = 0.0;
};

struct ParameterDescription {
  std::string_view key;
  std::size_t count = 1;  // a number when 1, otherwise an array of so many
  NumberRange range;      // of each number
  std::vector<double> default_values = {};  // empty: the parameter is required
  std::optional<RatioRule> ratio = {};
};

// A parameter that is one of several names; the first is the default.
struct ChoiceDescription {
  std::string_view key;
  std::vector<std::string_view> names;
};

// All that a reader needs to know of one kind of field node.
struct OperatorDescription {
  std::string_view name;  // its "type"
  FieldKind kind = FieldKind::distance;
  std::vector<ParameterDescription> parameters = {};
  std::vector<ChoiceDescription> choices = {};
  std::size_t fewest_operands = 0;
  std::size_t most_operands = 0;  // 0: the key "operands" is not allowed
  FieldKind operand_kind = FieldKind::distance;
  PlacementParts placement = PlacementParts::none;
  bool takes_link = false;
  bool needs_placement = false;  // a position, an orientation or a link must be given
};

// Every operator there is. Adding one is adding a row.
const std::vector<OperatorDescription>& all_operators();

// The operator of that name, or null. Pointers stay valid for the whole program.
const OperatorDescription* find_operator(std::string_view name);

// The names of the operators of one kind.
std::vector<std::string_view> operator_names(FieldKind kind);

}  // namespace nearfield::host
