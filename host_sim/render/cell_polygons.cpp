#include "render/cell_polygons.hpp"

#include <algorithm>

namespace nearfield::host {
namespace {

constexpr unsigned none = 12;

unsigned edge_between(unsigned a, unsigned b) {
  for (unsigned edge = 0; edge < none; ++edge) {
    const CellEdge ends = cell_edge(edge);
    if ((ends.from == a && ends.to == b) || (ends.from == b && ends.to == a)) return edge;
  }
  return none;
}

// The corners of a face, counter-clockwise seen from outside of the cell.
std::array<unsigned, 4> face_corners(unsigned face) {
  const unsigned axis = face / 2, u = 1U << (axis + 1) % 3, v = 1U << (axis + 2) % 3;
  const unsigned base = face % 2 == 0 ? 0U : 1U << axis;
  if (face % 2 == 0) return {base, base + v, base + u + v, base + u};
  return {base, base + u, base + u + v, base + v};
}

// Walking round a face, the surface's line goes from where the walk enters the inside to where it leaves it
// next: so each inside corner across from another is cut off by itself, and lines of neighbouring faces join
// head to tail. `next[edge]`: where the line goes on.
void link_face(unsigned face, std::uint8_t inside, std::array<unsigned, none>& next) {
  const std::array<unsigned, 4> corners = face_corners(face);
  const auto is_inside = [&](unsigned i) {
    return (static_cast<unsigned>(inside) >> corners[i % 4] & 1U) != 0;
  };
  for (unsigned i = 0; i < 4; ++i) {
    if (is_inside(i) || !is_inside(i + 1)) continue;
    unsigned last = i + 1;
    while (is_inside(last + 1)) ++last;
    next[edge_between(corners[i], corners[(i + 1) % 4])] =
        edge_between(corners[last % 4], corners[(last + 1) % 4]);
  }
}

std::vector<CellPolygon> polygons_of(std::uint8_t inside) {
  std::array<unsigned, none> next{};
  next.fill(none);
  for (unsigned face = 0; face < 6; ++face) link_face(face, inside, next);
  std::vector<CellPolygon> polygons;
  for (unsigned start = 0; start < none; ++start) {
    CellPolygon polygon;
    for (unsigned edge = start; next[edge] != none;) {
      polygon.push_back(edge);
      const unsigned following = next[edge];
      next[edge] = none;
      edge = following;
    }
    if (!polygon.empty()) polygons.push_back(polygon);
  }
  return polygons;
}

}  // namespace

CellEdge cell_edge(unsigned edge) {
  const unsigned axis = edge / 4, first = axis == 0 ? 1 : 0, second = axis == 2 ? 1 : 2;
  const unsigned from = (edge & 1U) << first | (edge >> 1 & 1U) << second;
  return {from, from | 1U << axis};
}

bool share_face(unsigned edge, unsigned other) {
  const CellEdge a = cell_edge(edge), b = cell_edge(other);
  const unsigned all = a.from & a.to & b.from & b.to, any = a.from | a.to | b.from | b.to;
  return all != 0 || any != 7;
}

const std::vector<CellPolygon>& cell_polygons(std::uint8_t inside) {
  static const std::vector<std::vector<CellPolygon>> table = [] {
    std::vector<std::vector<CellPolygon>> all;
    for (unsigned i = 0; i < 256; ++i) all.push_back(polygons_of(static_cast<std::uint8_t>(i)));
    return all;
  }();
  return table[inside];
}

}  // namespace nearfield::host
