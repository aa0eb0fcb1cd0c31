#include "model/field_reader.hpp"

#include <algorithm>
#include <cstdint>
#include <optional>
#include <string_view>
#include <utility>

#include "model/curve_reader.hpp"
#include "model/limits.hpp"
#include "text/names.hpp"

namespace nearfield::host {
namespace {

constexpr double ratio_tolerance = 1e-9;  // relative: decimal fractions are not exact in binary

constexpr FieldKind all_kinds[] = {FieldKind::distance, FieldKind::intensity, FieldKind::ray,
                                   FieldKind::algebraic};

std::string kind_in_words(FieldKind kind) {
  switch (kind) {
    case FieldKind::distance:
      return "a distance";
    case FieldKind::intensity:
      return "an intensity";
    case FieldKind::ray:
      return "a ray value";
    case FieldKind::algebraic:
      return "an algebraic value";
  }
  return "a value";
}

// Without a wanted kind every operator will do.
const OperatorDescription& read_type(const JsonNode& node, std::optional<FieldKind> wanted) {
  std::vector<std::string_view> names;
  for (const FieldKind kind : all_kinds) {
    for (const std::string_view name : operator_names(kind)) {
      if (std::find(names.begin(), names.end(), name) == names.end()) names.push_back(name);
    }
  }
  const JsonNode type = node.required("type", "one of " + joined(wanted ? operator_names(*wanted) : names));
  const OperatorDescription& description = *find_operator(names[type.choice(names)]);
  if (wanted && !description.any_kind && description.kind != *wanted) {
    node.fail(in_quotes(description.name) + " yields " + kind_in_words(description.kind),
              kind_in_words(*wanted) + " is needed here: one of " + joined(operator_names(*wanted)));
  }
  return description;
}

std::vector<std::string_view> allowed_keys(const OperatorDescription& description) {
  std::vector<std::string_view> keys{"type", "name"};
  for (const ParameterDescription& parameter : description.parameters) keys.push_back(parameter.key);
  for (const ChoiceDescription& choice : description.choices) keys.push_back(choice.key);
  for (const CurveDescription& curve : description.curves) {
    keys.push_back(curve.key);
    if (curve.family == CurveFamily::potential) keys.push_back(range_control_key);
  }
  if (description.placement != PlacementParts::none) keys.push_back("position");
  if (description.placement == PlacementParts::position_and_orientation) {
    keys.push_back("orientation_xyzw");
    keys.push_back("rpy");
  }
  if (description.takes_link) keys.push_back("link");
  if (description.most_operands > 0) keys.push_back("operands");
  return keys;
}

std::string expectation(const ParameterDescription& parameter) {
  const std::string range = describe(parameter.range);
  if (parameter.most_points > 0) {
    return std::to_string(parameter.fewest_points) + " to " + std::to_string(parameter.most_points) + " arrays of " + std::to_string(parameter.count) +
           " numbers " + range;
  }
  if (parameter.most > 0) {
    return std::to_string(parameter.count) + " to " + std::to_string(parameter.most) + " numbers " + range;
  }
  if (parameter.count == 1) return (parameter.whole ? "a whole number " : "a number ") + range;
  return std::to_string(parameter.count) + " numbers " + range;
}

double read_number(const JsonNode& value, const ParameterDescription& parameter) {
  if (!parameter.whole) return value.number(parameter.range);
  return static_cast<double>(value.integer(static_cast<std::int64_t>(parameter.range.lowest),
                                           static_cast<std::int64_t>(parameter.range.highest)));
}

void read_parameters(const JsonNode& node, FieldNode& field) {
  for (const ParameterDescription& parameter : field.operator_->parameters) {
    std::vector<double>& values = field.parameters[std::string(parameter.key)];
    if ((parameter.optional || !parameter.default_values.empty()) && !node.has(parameter.key)) {
      values = parameter.default_values;
      continue;
    }
    const JsonNode value = node.required(parameter.key, expectation(parameter));
    for (const std::string_view other : parameter.instead_of) {
      if (!node.has(other)) continue;
      value.fail(in_quotes(parameter.key) + " beside " + in_quotes(other), "one of them, not both");
    }
    if (parameter.most_points > 0) {
      for (const JsonNode& point : value.elements(parameter.fewest_points, parameter.most_points)) {
        for (const double number : point.numbers(parameter.count, parameter.range)) values.push_back(number);
      }
    } else if (parameter.most > 0) {
      for (const JsonNode& element : value.elements(parameter.count, parameter.most)) {
        values.push_back(read_number(element, parameter));
      }
    } else if (parameter.count == 1) {
      values = {read_number(value, parameter)};
    } else {
      values = value.numbers(parameter.count, parameter.range);
    }
  }
}

void check_ratios(const JsonNode& node, const FieldNode& field) {
  for (const ParameterDescription& parameter : field.operator_->parameters) {
    if (!parameter.ratio) continue;
    const double other = field.number(std::string(parameter.ratio->other_key));
    const double value = field.number(std::string(parameter.key));
    const double lowest = parameter.ratio->lowest * other;
    const double highest = parameter.ratio->highest * other;
    if (value < lowest * (1.0 - ratio_tolerance) || value > highest * (1.0 + ratio_tolerance)) {
      node.required(parameter.key)
          .fail(format_number(value) + " does not fit " + std::string(parameter.ratio->other_key) + " " +
                    format_number(other),
                "from " + format_number(parameter.ratio->lowest) + " to " +
                    format_number(parameter.ratio->highest) + " times " +
                    std::string(parameter.ratio->other_key) + ", here " +
                    describe({lowest, highest, parameter.range.unit}));
    }
  }
}

void read_choices(const JsonNode& node, FieldNode& field) {
  for (const ChoiceDescription& choice : field.operator_->choices) {
    const auto given = node.optional(choice.key);
    const std::size_t index = given ? given->choice(choice.names) : 0;
    field.choices[std::string(choice.key)] = std::string(choice.names[index]);
  }
}

void read_curves(const JsonNode& node, FieldNode& field) {
  for (const CurveDescription& description : field.operator_->curves) {
    const std::string key(description.key);
    ReadCurve read = read_curve(node, description);
    field.choices[key] = std::move(read.name);
    field.curves.emplace(key, std::move(read.curve));
  }
}

bool gives_placement(const JsonNode& node) {
  return node.has("position") || node.has("orientation_xyzw") || node.has("rpy") || node.has("link") ||
         node.has("scale");
}

void read_link(const JsonNode& node, bool inside_placed, FieldNode& field) {
  if (!field.operator_->takes_link) return;
  const auto link = node.optional("link");
  if (!link) return;
  field.link = link->string(longest_name);
  if (*field.link == "person/") link->fail("no link name after person/", "LINK or person/LINK");
  if (inside_placed) {
    link->fail("a link inside a placed node", "links only where no node above has a placement or a link");
  }
}

FieldNode read_node(const JsonNode& node, std::optional<FieldKind> wanted, bool inside_placed) {
  FieldNode field;
  field.operator_ = &read_type(node, wanted);
  const OperatorDescription& description = *field.operator_;
  field.kind = description.kind;
  node.reject_unknown_keys(allowed_keys(description));
  field.position = node.position();
  field.path = node.path();
  for (const auto& [key, value] : node.members()) field.given[key] = value.position();
  if (const auto name = node.optional("name")) field.name = name->string(longest_name);
  read_parameters(node, field);
  check_ratios(node, field);
  read_choices(node, field);
  read_curves(node, field);
  field.placement = read_placement(node, description.placement);
  read_link(node, inside_placed, field);
  const bool placed = gives_placement(node);
  if (description.needs_placement && !placed) {
    node.fail(in_quotes(description.name) + " without a placement",
              "at least one of position, orientation_xyzw, rpy, link, scale");
  }
  if (description.most_operands > 0) {
    std::optional<FieldKind> operand_kind = description.operand_kind;
    if (description.any_kind) operand_kind = wanted;
    const JsonNode array = node.required("operands", "an array of field nodes");
    for (const JsonNode& operand : array.elements(description.fewest_operands, description.most_operands)) {
      field.operands.push_back(read_node(operand, operand_kind, inside_placed || placed));
      if (description.any_kind) operand_kind = field.kind = field.operands.back().kind;
    }
  }
  return field;
}

}  // namespace

FieldNode read_field(const JsonNode& node, std::optional<FieldKind> wanted) {
  return read_node(node, wanted, false);
}

}  // namespace nearfield::host
