#include "curves/curve_settings.hpp"

#include <cstddef>
#include <optional>

#include <nearfield/curve/range_control.hpp>

#include "text/input_error.hpp"
#include "text/names.hpp"
#include "text/number.hpp"

namespace nearfield::host {
namespace {

const char* const command = "nearfield curve";

[[noreturn]] void refuse(const std::string& path, const std::string& message, const std::string& allowed) {
  throw InputError(command, {}, path, message, allowed);
}

NumberRange range_of(const CurveParameter& parameter) {
  NumberRange range;
  range.lowest = parameter.least;
  range.highest = parameter.greatest;
  return range;
}

std::string one_allowed_value(const CurveParameter& parameter) {
  return (parameter.integer ? "a whole number " : "") + describe(range_of(parameter));
}

bool is_list(const CurveParameter& parameter) { return parameter.greatest_count > 1; }

std::vector<std::string> separated_by_commas(const std::string& text) {
  std::vector<std::string> parts;
  if (text.empty()) return parts;
  std::size_t at = 0;
  for (std::size_t comma = text.find(','); comma != std::string::npos; comma = text.find(',', at)) {
    parts.push_back(text.substr(at, comma - at));
    at = comma + 1;
  }
  parts.push_back(text.substr(at));
  return parts;
}

ParameterValues parsed_values(const CurveParameter& parameter, const std::string& path,
                              const std::string& text) {
  const std::vector<std::string> parts = separated_by_commas(text);
  const auto least = static_cast<std::size_t>(parameter.least_count);
  const auto greatest = static_cast<std::size_t>(parameter.greatest_count);
  if (parts.size() < least || parts.size() > greatest) {
    const std::string count = parts.size() == 1 ? "1 value" : std::to_string(parts.size()) + " values";
    refuse(path, count, allowed_values(parameter));
  }
  ParameterValues values;
  for (const std::string& part : parts) {
    const std::string place = is_list(parameter) ? path + "[" + std::to_string(values.count) + "]" : path;
    const std::optional<double> number = parse_number(part);
    if (!number) refuse(place, in_quotes(part) + " is not a number", one_allowed_value(parameter));
    if (!contains(range_of(parameter), *number)) {
      refuse(place, format_number(*number) + " is out of range", one_allowed_value(parameter));
    }
    if (parameter.integer && *number != static_cast<double>(static_cast<int>(*number))) {
      refuse(place, format_number(*number) + " is not a whole number", one_allowed_value(parameter));
    }
    // A zero without a sign.
    values.values[values.count++] = *number + 0.0;
  }
  return values;
}

const CatalogueEntry& entry_called(const std::string& name) {
  if (const CatalogueEntry* entry = find_curve(name)) return *entry;
  std::vector<std::string_view> names;
  for (const CatalogueEntry& entry : curve_catalogue()) names.push_back(entry.name);
  refuse("", unknown_name("curve", name, names), "`nearfield curve --list` names them all");
}

std::string shown_parameter(const CurveParameter& parameter, const ParameterValues& values) {
  std::string numbers;
  for (int i = 0; i < values.count; ++i) numbers += (i > 0 ? ", " : "") + format_number(values.values[i]);
  return std::string(parameter.name) + " = " + (is_list(parameter) ? "(" + numbers + ")" : numbers);
}

}  // namespace

const std::vector<CurveParameter>& range_control_parameters() {
  static const std::vector<CurveParameter> parameters = {
      number_parameter("w1", "range control: blending range outside the surface", 0.01, 3.0, 1.0),
      number_parameter("w2", "range control: inside it, at most w1", 0.01, 1.0, 1.0)};
  return parameters;
}

std::string allowed_values(const CurveParameter& parameter) {
  if (!is_list(parameter)) return one_allowed_value(parameter);
  std::string count = std::to_string(parameter.least_count);
  if (parameter.greatest_count != parameter.least_count)
    count += " to " + std::to_string(parameter.greatest_count);
  return count + (parameter.integer ? " whole numbers " : " numbers ") + describe(range_of(parameter));
}

std::string settable_text(const double* values, int count) {
  std::string text;
  for (int i = 0; i < count; ++i) text += (i > 0 ? "," : "") + format_number(values[i]);
  return text;
}

ConfiguredCurve configured_curve(const std::string& name, const std::vector<std::string>& settings) {
  const CatalogueEntry& entry = entry_called(name);
  std::vector<CurveParameter> parameters = entry.parameters;
  std::vector<ParameterValues> values = initial_values(entry);
  const std::size_t own_count = parameters.size();
  if (entry.family == CurveFamily::potential) {
    for (const CurveParameter& parameter : range_control_parameters()) {
      parameters.push_back(parameter);
      values.push_back({1, {parameter.initial[0]}});
    }
  }
  std::vector<std::string_view> names;
  for (const CurveParameter& parameter : parameters) names.emplace_back(parameter.name);

  std::vector<bool> is_set(parameters.size(), false);
  for (const std::string& setting : settings) {
    const std::size_t equals = setting.find('=');
    const std::string key = setting.substr(0, equals);
    std::size_t which = 0;
    while (which < names.size() && names[which] != key) ++which;
    if (which == names.size()) {
      refuse(name, unknown_name("parameter", key, names),
             names.empty() ? "it has none" : "it has " + joined(names));
    }
    const std::string path = name + "." + key;
    if (equals == std::string::npos)
      refuse(path, "no value", key + "=" + (is_list(parameters[which]) ? "VALUE,..." : "VALUE"));
    if (is_set[which]) refuse(path, "set twice", "each parameter is set once");
    is_set[which] = true;
    values[which] = parsed_values(parameters[which], path, setting.substr(equals + 1));
  }

  const std::vector<ParameterValues> own_values(values.begin(),
                                                values.begin() + static_cast<std::ptrdiff_t>(own_count));
  ConfiguredCurve configured{name, entry.family, "", entry.make(own_values)};
  std::size_t shown_count = own_count;
  if (own_count < parameters.size() && (is_set[own_count] || is_set[own_count + 1])) {
    const double w1 = values[own_count].number();
    // Left alone, w2 gives way to a smaller w1.
    if (!is_set[own_count + 1] && w1 < 1.0) values[own_count + 1].values[0] = w1;
    configured.curve =
        AnyCurve(potential::with_range_control(configured.curve, w1, values[own_count + 1].number()));
    shown_count = parameters.size();
  }
  if (const char* problem = configured.curve.problem()) refuse(name, problem, "");
  for (std::size_t i = 0; i < shown_count; ++i) {
    configured.parameters += (i > 0 ? ", " : "") + shown_parameter(parameters[i], values[i]);
  }
  return configured;
}

}  // namespace nearfield::host
