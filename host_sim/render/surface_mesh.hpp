// A field's surface as triangles.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "render/parallel_rows.hpp"
#include "render/surface_box.hpp"

namespace nearfield::host {

struct SurfaceMesh {
  struct Vertex {
    Vector3d position;  // m
    Vector3d normal;    // of length 1, outwards; {0, 0, 0} where the field has no slope
  };
  std::vector<Vertex> vertices;
  std::vector<std::array<std::uint32_t, 3>> triangles;  // counter-clockwise seen from outside
};

struct MeshSettings {
  Box3 box;                     // sampled, within the field's domain
  std::size_t resolution = 64;  // cells along the longest edge of the box: 2 to 512
  bool close = false;           // where the surface leaves the box, end it with the box's faces
  unsigned threads = 0;         // 0: as many as the machine has
};

struct Meshing {
  SurfaceMesh mesh;
  bool leaves_box = false;  // the surface does, and `close` was not asked for: the mesh is empty
  std::size_t passed_over = 0, cells = 0;  // of all cells, those that were proved to hold no surface
};

// Marching cubes, whose polygons follow from the faces of each cell alone: every edge belongs to two
// triangles, once in each direction. Vertices lie on edges of the cells where the sign changes, to within the
// rounding of the scalar, but for those on faces of the box where it closes the surface. What is smaller than
// a cell may be missed. The same settings give the same mesh, whatever the number of threads.
Meshing mesh_of(const SceneField& field, const MeshSettings& settings, const ReportProgress& report = {});

}  // namespace nearfield::host
