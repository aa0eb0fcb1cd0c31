#include <cstdio>

#include "command/command.hpp"
#include "command/field_options.hpp"
#include "command/options.hpp"
#include "model/points.hpp"
#include "model/scene_reader.hpp"
#include "simulate/evaluation.hpp"
#include "text/read_file.hpp"

namespace nearfield::host {
namespace {

std::vector<OptionDescription> eval_options() {
  return {{"points", "FILE",
           "comma-separated values: three numbers a line, in m; may start with x,y,z (required)"},
          scalar_option(),
          parameters_option(),
          {"output", "FILE", "where to write; default: standard output"},
          {"help", "", "this text"}};
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
