#include "model/field_reader.hpp"

#include <string_view>

#include "model/limits.hpp"
#include "text/names.hpp"

namespace nearfield::host {
namespace {

constexpr double ratio_tolerance = 1e-9;  // relative: decimal fractions are not exact in binary

std::string_view kind_in_words(FieldKind kind) {
  return kind == FieldKind::distance ? "a distance" : "an intensity";
}

const OperatorDescription& read_type(const JsonNode& node, FieldKind wanted) {
  std::vector<std::string_view> names = operator_names(FieldKind::distance);
  for (const std::string_view name : operator_names(FieldKind::intensity)) names.push_back(name);
  const JsonNode type = node.required("type", "one of " + joined(operator_names(wanted)));
  const OperatorDescription& description = *find_operator(names[type.choice(names)]);
  if (description.kind != wanted) {
    node.fail(in_quotes(description.name) + " yields " + std::string(kind_in_words(description.kind)),
              std::string(kind_in_words(wanted)) + " is needed here: one of " +
                  joined(operator_names(wanted)));
  }
  return description;
}

std::vector<std::string_view> allowed_keys(const OperatorDescription& description) {
  std::vector<std::string_view> keys{"type", "name"};
  for (const ParameterDescription& parameter : description.parameters) keys.push_back(parameter.key);
  for (const ChoiceDescription& choice : description.choices) keys.push_back(choice.key);
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
  if (parameter.count == 1) return "a number " + describe(parameter.range);
  return std::to_string(parameter.count) + " numbers " + describe(parameter.range);
}

void read_parameters(const JsonNode& node, FieldNode& field) {
  for (const ParameterDescription& parameter : field.operator_->parameters) {
    std::vector<double>& values = field.parameters[std::string(parameter.key)];
    if (!parameter.default_values.empty() && !node.has(parameter.key)) {
      values = parameter.default_values;
      continue;
    }
    const JsonNode value = node.required(parameter.key, expectation(parameter));
    if (parameter.count == 1) {
      values = {value.number(parameter.range)};
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

bool gives_placement(const JsonNode& node) {
  return node.has("position") || node.has("orientation_xyzw") || node.has("rpy") || node.has("link");
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

FieldNode read_node(const JsonNode& node, FieldKind wanted, bool inside_placed) {
  FieldNode field;
  field.operator_ = &read_type(node, wanted);
  const OperatorDescription& description = *field.operator_;
  node.reject_unknown_keys(allowed_keys(description));
  field.position = node.position();
  field.path = node.path();
  if (const auto name = node.optional("name")) field.name = name->string(longest_name);
  read_parameters(node, field);
  check_ratios(node, field);
  read_choices(node, field);
  field.placement = read_placement(node, description.placement);
  read_link(node, inside_placed, field);
  const bool placed = gives_placement(node);
  if (description.needs_placement && !placed) {
    node.fail(in_quotes(description.name) + " without a placement",
              "at least one of position, orientation_xyzw, rpy, link");
  }
  if (description.most_operands > 0) {
    const JsonNode array = node.required("operands", "an array of field nodes");
    for (const JsonNode& operand : array.elements(description.fewest_operands, description.most_operands)) {
      field.operands.push_back(read_node(operand, description.operand_kind, inside_placed || placed));
    }
  }
  return field;
}

}  // namespace

FieldNode read_field(const JsonNode& node, FieldKind wanted) { return read_node(node, wanted, false); }

}  // namespace nearfield::host
