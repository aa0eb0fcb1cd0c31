// Fields of a scene or a problem as program images.
#pragma once

#include <string>
#include <vector>

#include "compile/field_emitter.hpp"
#include "compile/field_steps.hpp"
#include "model/field_node.hpp"
#include "model/robot_description.hpp"

namespace nearfield::host {

// Builds, checks and returns the image of a field. InputError, with the node's place in `file`, for a node
// whose numbers do not fit the scalar type, and for a field too deep or too large for an image.
template <class S>
CompiledField<S> compile_field(const FieldNode& root, const std::string& file,
                               const SlotOfLink& slot_of_link);

// The sharp union of solids, each where its origin says. At least one.
template <class S>
CompiledField<S> compile_obstacles(const std::vector<CollisionShape>& solids, const std::string& file,
                                   const std::string& path);

}  // namespace nearfield::host
