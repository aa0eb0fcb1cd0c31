#include <cstdio>

#include "command/command.hpp"
#include "command/options.hpp"
#include "model/scene_reader.hpp"
#include "simulate/budget_table.hpp"

namespace nearfield::host {

int run_budget(const std::vector<std::string>& arguments) {
  const std::vector<OptionDescription> descriptions = {{"help", "", "this text"}};
  const Options options(descriptions, arguments, Operand::one);
  if (options.has("help")) {
    std::printf(
        "usage: nearfield budget SCENE\n\n"
        "Worst-case instructions of a scene's field on each target whose costs have been measured, in\n"
        "Fixed<27>: of a value, of a query with gradient and all checks (a clearance, where the field is a\n"
        "distance), and of a soft clearance, where it is an intensity.\n\n%s",
        describe(descriptions).c_str());
    return 0;
  }
  if (!options.operand()) throw UsageError("which scene? `nearfield budget SCENE`");
  const std::string text = budget_table(read_scene_of_any_kind(*options.operand()));
  std::fwrite(text.data(), 1, text.size(), stdout);
  return 0;
}

}  // namespace nearfield::host
