// A compiled work cell as C++ source, to be compiled into a target's flash.
#pragma once

#include <string>

#include "compile/work_cell_compiler.hpp"

namespace nearfield::host {

// Defines, in namespace nearfield::work_cell, `kWorkCell` and the capacities `kArmLinks`, `kArmBodies`, `kPersonLinks`
// and `kPersonBodies`, all constant-initialised. Includes nothing: work_cell/work_cell.hpp must come before it.
std::string work_cell_source(const CompiledWorkCell& cell, const std::string& made_from);

}  // namespace nearfield::host
