// Fields of a scene or a problem as program images.
#pragma once

#include <functional>
#include <string>
#include <vector>

#include <nearfield/field/image.hpp>

#include "model/field_node.hpp"
#include "model/robot_description.hpp"

namespace nearfield::host {

// The slot whose pose carries a link, by the name that a node gives; InputError's text when there is none.
using SlotOfLink = std::function<std::uint32_t(const FieldNode& node, const std::string& link)>;

template <class S> struct CompiledField {
  std::vector<std::uint32_t> image;
  nearfield::Inspection<S> inspection;  // status ok
};

// Builds, checks and returns the image of a field. InputError, with the node's place in `file`, for a node whose
// numbers do not fit the scalar type's domain, and for a field too deep or too large for an image.
template <class S>
CompiledField<S> compile_field(const FieldNode& root, const std::string& file, const SlotOfLink& slot_of_link);

// The sharp union of solids, each where its origin says. At least one.
template <class S>
CompiledField<S> compile_obstacles(const std::vector<CollisionShape>& solids, const std::string& file,
                                   const std::string& path);

}  // namespace nearfield::host
