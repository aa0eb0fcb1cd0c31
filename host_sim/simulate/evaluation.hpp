// A scene's field at points: what `nearfield eval` prints.
#pragma once

#include <string>
#include <vector>

#include "compile/field_scalar.hpp"
#include "model/scene_description.hpp"
#include "model/vector3d.hpp"

namespace nearfield::host {

// Comma-separated values, a line for each point: the point, the field's value and its gradient per metre,
// clearance and status. Status is clear, touching, undecided, invalid (outside the number range; nothing but
// the point is given), no_clearance (of that field there is none: it is a ray function or algebraic, or
// nothing is certified) or saturated (the same, and value or gradient are wrong: a number on the way to them
// left the number range). Nodes with a link are where the scene's robot or person carries them at rest
// (rest_pose.hpp). InputError when the field does not fit the scalar, and for links of a robot or person that
// the scene does not have. `parameters`: those of the field's parameter slots, from 0 on, each in [0, 1].
std::string evaluation_csv(const SceneDescription& scene, const std::vector<Vector3d>& points,
                           FieldScalar scalar, const std::vector<double>& parameters = {});

}  // namespace nearfield::host
