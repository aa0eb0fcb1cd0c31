#pragma once

#include <string>

#include "render/surface_mesh.hpp"

namespace nearfield::host {

// PLY 1.0, binary, little-endian: positions as double, normals as float.
std::string ply_of(const SurfaceMesh& mesh, const std::string& comment);
// Wavefront OBJ: the shortest decimals that read back as the same numbers.
std::string obj_of(const SurfaceMesh& mesh, const std::string& comment);

}  // namespace nearfield::host
