// A scene's field at points: what `nearfield eval` prints.
#pragma once

#include <string>
#include <vector>

#include "model/scene_description.hpp"
#include "model/vector3d.hpp"

namespace nearfield::host {

enum class FieldScalar { q27, q24, q16, single };  // Fixed<27>, Fixed<24>, Fixed<16>, float

// Comma-separated values, a line for each point: the point, the field's value and its gradient per metre,
// clearance and status. Status is clear, touching, undecided, invalid (outside the number range; nothing but
// the point is given) or no_clearance (of that field there is none: it is a ray function or algebraic, or
// nothing is certified). Nodes with a link are where the scene's robot or person carries them at rest
// (rest_pose.hpp). InputError when the field does not fit the scalar, and for links of a robot or person that
// the scene does not have.
std::string evaluation_csv(const SceneDescription& scene, const std::vector<Vector3d>& points,
                           FieldScalar scalar);

}  // namespace nearfield::host
