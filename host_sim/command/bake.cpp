#include <cstdio>
#include <filesystem>

#include "command/command.hpp"
#include "command/work_cell_files.hpp"
#include "compile/work_cell_source.hpp"
#include "text/read_file.hpp"

namespace nearfield::host {
namespace {

std::vector<OptionDescription> bake_options() {
  std::vector<OptionDescription> options = work_cell_options();
  options.push_back({"output", "FILE", "the source file to write (required)"});
  options.push_back({"help", "", "this text"});
  return options;
}

}  // namespace

int run_bake(const std::vector<std::string>& arguments) {
  const Options options(bake_options(), arguments);
  if (options.has("help")) {
    std::printf("usage: nearfield bake --output FILE [OPTION...]\n\nWrites a work cell as C++ source for a target's flash: "
                "robot, program images, scenario.\n\n%s", describe(bake_options()).c_str());
    return 0;
  }
  const std::string output = options.required("output");
  WorkCellFiles files;
  const CompiledWorkCell cell = compile_work_cell(options, files);
  const auto name = [](const std::string& file) { return std::filesystem::path(file).filename().string(); };
  write_file(output, work_cell_source(cell, name(files.scene) + " and " + name(files.robot)));
  std::printf("%s: cell image %zu bytes, soft image %zu bytes, %zu bodies\n", output.c_str(), 4 * cell.cell.image.size(),
              4 * cell.soft.image.size(), cell.arm.bodies.size());
  return 0;
}

}  // namespace nearfield::host
