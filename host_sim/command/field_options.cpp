#include "command/field_options.hpp"

#include <algorithm>
#include <cmath>
#include <string_view>

#include "draw/png.hpp"
#include "model/scene_reader.hpp"
#include "text/names.hpp"

namespace nearfield::host {
namespace {

// The numbers of a list with commas; nothing unless there are `count`.
std::optional<std::vector<double>> numbers_in(const std::string& text, char between, std::size_t count) {
  std::vector<double> numbers;
  for (std::size_t at = 0; at <= text.size();) {
    const std::size_t end = std::min(text.find(between, at), text.size());
    const auto number = parse_number(text.substr(at, end - at));
    if (!number) return std::nullopt;
    numbers.push_back(*number);
    at = end + 1;
  }
  if (numbers.size() != count) return std::nullopt;
  return numbers;
}

}  // namespace

OptionDescription scalar_option() {
  return {"scalar", "NAME", "number type: q27, q24, q16 or float; default: q27"};
}

FieldScalar scalar_of(const Options& options) {
  const std::vector<std::string_view> names = {"q27", "q24", "q16", "float"};
  constexpr FieldScalar scalars[] = {FieldScalar::q27, FieldScalar::q24, FieldScalar::q16,
                                     FieldScalar::single};
  const std::string name = options.value("scalar").value_or("q27");
  for (std::size_t i = 0; i < names.size(); ++i) {
    if (names[i] == name) return scalars[i];
  }
  throw UsageError("--scalar: " + unknown_name("name", name, names) + ": it is one of " + joined(names));
}

OptionDescription parameters_option() {
  return {"parameters", "NUMBERS",
          "of the field's parameter slots, from 0 on: from 0 to 1, with commas between"};
}

std::vector<double> parameters_of(const Options& options) {
  std::vector<double> parameters;
  std::string text = options.value("parameters").value_or("");
  while (!text.empty()) {
    const std::size_t end = text.find(',');
    const std::string one = text.substr(0, end);
    const auto number = parse_number(one);
    if (!number || !(*number >= 0.0 && *number <= 1.0) || end == text.size() - 1) {
      throw UsageError("--parameters: `" + (number ? text : one) +
                       "`: they are numbers from 0 to 1, with commas between");
    }
    parameters.push_back(*number);
    text = end == std::string::npos ? "" : text.substr(end + 1);
  }
  return parameters;
}

OptionDescription level_option() {
  return {"level", "NUMBER", "value on the surface; default: 0, of intensities and rays 0.5"};
}

SceneDescription scene_of(const Options& options, const std::string& usage) {
  if (!options.operand()) throw UsageError("which scene? `" + usage + "`");
  return read_scene_of_any_kind(*options.operand());
}

std::unique_ptr<SceneField> field_of(const Options& options, const SceneDescription& scene) {
  return scene_field(scene, scalar_of(options), parameters_of(options),
                     number_of(options, "level", {-1000.0, 1000.0}));
}

std::optional<double> number_of(const Options& options, const std::string& name, const NumberRange& range) {
  const auto text = options.value(name);
  if (!text) return std::nullopt;
  const auto number = parse_number(*text);
  if (!number || !contains(range, *number))
    throw UsageError("--" + name + " " + *text + ": a number " + describe(range));
  return number;
}

std::optional<Vector3d> vector_of(const Options& options, const std::string& name) {
  const auto text = options.value(name);
  if (!text) return std::nullopt;
  const auto numbers = numbers_in(*text, ',', 3);
  if (!numbers || std::abs((*numbers)[0]) > 1e6 || std::abs((*numbers)[1]) > 1e6 ||
      std::abs((*numbers)[2]) > 1e6) {
    throw UsageError("--" + name + " " + *text + ": three numbers with commas between, such as 0.5,-1,0");
  }
  return Vector3d{(*numbers)[0], (*numbers)[1], (*numbers)[2]};
}

OptionDescription box_option(const std::string& help) { return {"box", "NUMBERS", help}; }

std::optional<Box3> box_of(const Options& options, const SceneField& field) {
  const auto text = options.value("box");
  if (!text) return std::nullopt;
  const auto numbers = numbers_in(*text, ',', 6);
  if (numbers) {
    const std::vector<double>& n = *numbers;
    const Box3 box{{n[0], n[1], n[2]}, {n[3], n[4], n[5]}};
    const bool ordered = n[0] < n[3] && n[1] < n[4] && n[2] < n[5];
    if (ordered && field.in_domain(box.low) && field.in_domain(box.high)) return box;
  }
  throw UsageError("--box " + *text + ": six numbers, the least x, y, z and then the greatest, from -" +
                   format_number(field.domain()) + " to " + format_number(field.domain()) + " m");
}

std::size_t whole_number_of(const Options& options, const std::string& name, std::size_t least,
                            std::size_t greatest, std::size_t initial) {
  const auto text = options.value(name);
  if (!text) return initial;
  const auto number = parse_number(*text);
  if (!number || *number != std::floor(*number) || !(*number >= static_cast<double>(least)) ||
      !(*number <= static_cast<double>(greatest))) {
    throw UsageError("--" + name + " " + *text + " is not a whole number from " + std::to_string(least) +
                     " to " + std::to_string(greatest));
  }
  return static_cast<std::size_t>(*number);
}

OptionDescription size_option() { return {"size", "WxH", "pixels, 16 to 4096 each; default: 640x480"}; }

PictureSize size_of(const Options& options) {
  const auto text = options.value("size");
  if (!text) return {};
  const auto sides = numbers_in(*text, 'x', 2);
  const auto allowed = [](double side) { return side >= 16.0 && side <= 4096.0 && side == std::floor(side); };
  if (!sides || !allowed((*sides)[0]) || !allowed((*sides)[1])) {
    throw UsageError("--size " + *text + ": two whole numbers from 16 to 4096, such as 640x480");
  }
  return {static_cast<std::size_t>((*sides)[0]), static_cast<std::size_t>((*sides)[1])};
}

OptionDescription threads_option() {
  return {"threads", "N", "1 to 256; the output is the same; default: as many as the machine has"};
}

unsigned threads_of(const Options& options) {
  return static_cast<unsigned>(whole_number_of(options, "threads", 1, 256, 0));
}

bool ends_with(const std::string& text, const std::string& ending) {
  return text.size() >= ending.size() &&
         text.compare(text.size() - ending.size(), ending.size(), ending) == 0;
}

std::string output_of(const Options& options, const std::vector<std::string>& endings) {
  const std::string name = options.required("output");
  std::string allowed;
  for (const std::string& ending : endings) {
    if (ends_with(name, ending)) return name;
    allowed += (allowed.empty() ? "" : " or ") + ending;
  }
  throw UsageError("--output " + name + ": the name must end in " + allowed);
}

}  // namespace nearfield::host
