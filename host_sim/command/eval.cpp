#include <cstdio>

#include "command/command.hpp"
#include "command/options.hpp"
#include "model/points.hpp"
#include "model/scene_reader.hpp"
#include "simulate/evaluation.hpp"
#include "text/input_error.hpp"
#include "text/names.hpp"
#include "text/number.hpp"
#include "text/read_file.hpp"

namespace nearfield::host {
namespace {

std::vector<OptionDescription> eval_options() {
  return {{"points", "FILE",
           "comma-separated values: three numbers a line, in m; may start with x,y,z (required)"},
          {"scalar", "NAME", "number type: q27, q24, q16 or float; default: q27"},
          {"parameters", "NUMBERS", "of the field's parameter slots, from 0 on: from 0 to 1, with commas between"},
          {"output", "FILE", "where to write; default: standard output"},
          {"help", "", "this text"}};
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

std::vector<double> parameters_of(const Options& options) {
  std::vector<double> parameters;
  std::string text = options.value("parameters").value_or("");
  while (!text.empty()) {
    const std::size_t end = text.find(',');
    const std::string one = text.substr(0, end);
    const auto number = parse_number(one);
    if (!number || !(*number >= 0.0 && *number <= 1.0) || end == text.size() - 1) {
      throw UsageError("--parameters: `" + (number ? text : one) + "`: they are numbers from 0 to 1, with commas between");
    }
    parameters.push_back(*number);
    text = end == std::string::npos ? "" : text.substr(end + 1);
  }
  return parameters;
}

void print_help() {
  std::printf(
      "usage: nearfield eval SCENE --points FILE [OPTION...]\n\n"
      "Value, gradient (per m), clearance and status of a scene's field at points, as comma-separated "
      "values. The\n"
      "field may be of any kind (host_sim/FORMATS.md); robots in it are at rest: every joint 0, or as near "
      "as its\n"
      "limits allow.\n\n%s",
      describe(eval_options()).c_str());
}

}  // namespace

int run_eval(const std::vector<std::string>& arguments) {
  const Options options(eval_options(), arguments, Operand::one);
  if (options.has("help")) {
    print_help();
    return 0;
  }
  if (!options.operand()) throw UsageError("which scene? `nearfield eval SCENE --points FILE`");
  const std::string points_file = options.required("points");
  const FieldScalar scalar = scalar_of(options);
  const SceneDescription scene = read_scene_of_any_kind(*options.operand());
  const std::string text = evaluation_csv(scene, read_points(points_file), scalar, parameters_of(options));
  if (const auto output = options.value("output")) {
    write_file(*output, text);
  } else {
    std::fwrite(text.data(), 1, text.size(), stdout);
  }
  return 0;
}

}  // namespace nearfield::host
