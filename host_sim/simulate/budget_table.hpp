// What a scene's field costs on each target: what `nearfield budget` prints.
#pragma once

#include <string>

#include "model/scene_description.hpp"

namespace nearfield::host {

// A line for each target whose costs have been measured, under a heading: worst-case instructions of a value, of
// value with gradient and all checks (for distances that is a clearance), and, of intensities, of a soft clearance.
// Fixed<27>. InputError when the field does not fit that, or names links that the scene does not have.
std::string budget_table(const SceneDescription& scene);

}  // namespace nearfield::host
