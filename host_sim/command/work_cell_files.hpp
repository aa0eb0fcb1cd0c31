// Which scene, robot and SRDF a command works on.
#pragma once

#include "command/options.hpp"
#include "compile/work_cell_compiler.hpp"

namespace nearfield::host {

struct WorkCellFiles {
  std::string scene, robot, srdf;  // srdf: empty if there is none
};

// --scene, --robot and --srdf, for Options.
std::vector<OptionDescription> work_cell_options();

// Reads and compiles what the options name. Without --scene: the work cell that comes with Nearfield. Without
// --robot: the scene's. Without --srdf: the file beside the robot that differs in its ending only, if there is one.
CompiledWorkCell compile_work_cell(const Options& options, WorkCellFiles& files);

}  // namespace nearfield::host
