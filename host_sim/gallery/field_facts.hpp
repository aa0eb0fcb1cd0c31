// What is proved of a field and what it costs, in a line each.
#pragma once

#include <string>

#include "render/scene_field.hpp"

namespace nearfield::host {

// `Lipschitz constant 1.01, error 0.21 um: ...`, or that there is no certificate, and why.
std::string certificate_in_words(const SceneField& field);

// Of the scene's field on a Cortex-M4, in Fixed<27>, as `nearfield budget` has it. InputError as that.
std::string budget_in_words(const SceneDescription& scene);

}  // namespace nearfield::host
