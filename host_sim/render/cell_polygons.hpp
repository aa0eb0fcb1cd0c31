// The polygons in which a surface passes through one cubic cell.
#pragma once

#include <array>
#include <cstdint>
#include <vector>

namespace nearfield::host {

// Corner i of a cell lies at (i & 1, i >> 1 & 1, i >> 2 & 1). Edge e runs along axis e / 4 (0: x) from the
// corner at which the two other coordinates, in the order x, y, z without the axis, are e & 1 and e >> 1 & 1.
struct CellEdge {
  unsigned from, to;  // corners
};
CellEdge cell_edge(unsigned edge);
// Whether two edges belong to a common face.
bool share_face(unsigned edge, unsigned other);

using CellPolygon = std::vector<unsigned>;  // edges, counter-clockwise seen from outside

// Of a cell whose corner i is inside where bit i of `inside` is set. On a face with two inside corners across
// from each other the outside ones are joined, on either side of the face alike. Cost: a look into a table of
// 256.
const std::vector<CellPolygon>& cell_polygons(std::uint8_t inside);

}  // namespace nearfield::host
