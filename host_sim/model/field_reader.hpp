#pragma once

#include <optional>

#include "model/field_node.hpp"
#include "text/json_node.hpp"

namespace nearfield::host {

// Reads a field node and all below it, generically over all_operators(); of any kind when none is wanted.
// InputError when the node or one below yields another kind than is wanted, and on unknown, missing or
// out-of-range parameters, unknown curves, a wrong number of operands, or a link inside a placed node (a
// link's frame is given in the cell's, not in another).
FieldNode read_field(const JsonNode& node, std::optional<FieldKind> wanted);

}  // namespace nearfield::host
