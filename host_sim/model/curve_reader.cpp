#include "model/curve_reader.hpp"

#include <cstdint>
#include <optional>
#include <utility>

#include "text/input_error.hpp"

namespace nearfield::host {
namespace {

struct ShortForm {
  std::string_view name;
  std::string_view curve;
  const char* setting;
};
constexpr ShortForm short_forms[] = {{"polynomial3", "polynomial", "n=3"},
                                     {"polynomial1", "polynomial", "n=1"},
                                     {"polynomial2", "polynomial", "n=2"}};

std::vector<std::string_view> names_of(const std::vector<CurveParameter>& parameters) {
  std::vector<std::string_view> names;
  for (const CurveParameter& parameter : parameters) names.emplace_back(parameter.name);
  return names;
}

double read_value(const JsonNode& value, const CurveParameter& parameter) {
  if (parameter.integer) {
    return static_cast<double>(value.integer(static_cast<std::int64_t>(parameter.least),
                                             static_cast<std::int64_t>(parameter.greatest)));
  }
  return value.number({parameter.least, parameter.greatest, {}});
}

// Appends a setting as configured_curve() takes it; texts of numbers read back the same.
void add_setting(const JsonNode& value, const CurveParameter& parameter, std::vector<std::string>& settings) {
  std::vector<double> numbers;
  if (parameter.greatest_count > 1) {
    for (const JsonNode& element : value.elements(static_cast<std::size_t>(parameter.least_count),
                                                  static_cast<std::size_t>(parameter.greatest_count))) {
      numbers.push_back(read_value(element, parameter));
    }
  } else {
    numbers.push_back(read_value(value, parameter));
  }
  settings.push_back(std::string(parameter.name) + "=" +
                     settable_text(numbers.data(), static_cast<int>(numbers.size())));
}

void add_settings(const JsonNode& object, const std::vector<CurveParameter>& parameters,
                  std::vector<std::string>& settings) {
  for (const CurveParameter& parameter : parameters) {
    if (const auto value = object.optional(parameter.name)) add_setting(*value, parameter, settings);
  }
}

// The curve's name as given; its settings are appended.
std::string read_settings(const JsonNode& value, CurveFamily family, std::vector<std::string>& settings) {
  const std::vector<std::string_view> names = curve_names(family);
  if (value.kind() != JsonKind::object) {
    if (value.kind() != JsonKind::string) {
      value.fail(
          "neither a curve's name nor an object",
          "a name or {\"curve\": NAME, PARAMETER: VALUE, ...}; `nearfield curve --list` names them all");
    }
    return std::string(names[value.choice(names)]);
  }
  const JsonNode curve = value.required("curve", "a curve's name");
  const std::string name(names[curve.choice(names)]);
  const CatalogueEntry* entry = find_curve(name);
  const std::vector<CurveParameter> parameters =
      entry != nullptr ? entry->parameters : std::vector<CurveParameter>{};
  std::vector<std::string_view> keys = names_of(parameters);
  keys.insert(keys.begin(), "curve");
  value.reject_unknown_keys(keys);
  add_settings(value, parameters, settings);
  return name;
}

}  // namespace

std::vector<std::string_view> curve_names(CurveFamily family) {
  std::vector<std::string_view> names;
  if (family == CurveFamily::step) {
    for (const ShortForm& form : short_forms) names.push_back(form.name);
  }
  for (const CatalogueEntry& entry : curve_catalogue()) {
    if (entry.family == family) names.push_back(entry.name);
  }
  return names;
}

ReadCurve read_curve(const JsonNode& node, const CurveDescription& description) {
  const auto given = node.optional(description.key);
  std::vector<std::string> settings;
  const std::string name =
      given ? read_settings(*given, description.family, settings) : std::string(description.default_name);
  std::string curve = name;
  for (const ShortForm& form : short_forms) {
    if (form.name != name) continue;
    curve = form.curve;
    settings.emplace_back(form.setting);
  }
  std::optional<JsonNode> range_control;
  if (description.family == CurveFamily::potential) range_control = node.optional(range_control_key);
  if (range_control) {
    range_control->reject_unknown_keys(names_of(range_control_parameters()));
    add_settings(*range_control, range_control_parameters(), settings);
  }
  try {
    return {name, configured_curve(curve, settings)};
  } catch (const InputError& error) {
    // Each value is in its range: they do not fit each other.
    const JsonNode& place = range_control ? *range_control : given ? *given : node;
    place.fail(error.message(), error.allowed().empty() ? "values that fit each other" : error.allowed());
  }
}

}  // namespace nearfield::host
