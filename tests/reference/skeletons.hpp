#pragma once
/// Distances to skeletons: chains of segments and filled polygons.

#include "segments.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <vector>

namespace nearfield::reference {

/// From a chain of segments through at least two points.
inline Real polyline_distance(const std::vector<Vec3>& points, const Vec3& p) {
  Real least = distance(p, points.front());
  for (std::size_t i = 0; i + 1 < points.size(); ++i) {
    least = std::min(least, point_segment_distance(p, Segment{points[i], points[i + 1]}));
  }
  return least;
}

/// How often a closed polygon in a plane z = constant goes round (x, y), in quarters of a turn: from one
/// vertex to the next by at most two of them.
inline int quarter_turns_about(const std::vector<Vec3>& vertices, Real x, Real y) {
  const auto quadrant = [x, y](const Vec3& v) { return v.y >= y ? (v.x >= x ? 0 : 1) : (v.x < x ? 2 : 3); };
  int sum = 0;
  for (std::size_t i = 0; i < vertices.size(); ++i) {
    const Vec3 &a = vertices[i], &b = vertices[(i + 1) % vertices.size()];
    int turned = (quadrant(b) - quadrant(a) + 4) % 4;
    if (turned == 3) turned = -1;
    if (turned == 2 && (a.x - x) * (b.y - y) < (a.y - y) * (b.x - x)) turned = -2;
    sum += turned;
  }
  return sum;
}

/// From a filled simple polygon in a plane z = constant.
inline Real polygon_distance(const std::vector<Vec3>& vertices, const Vec3& p) {
  std::vector<Vec3> edges = vertices;
  edges.push_back(vertices.front());
  const Real from_edges = polyline_distance(edges, p);
  if (quarter_turns_about(vertices, p.x, p.y) == 0) return from_edges;
  return std::min(from_edges, std::fabs(p.z - vertices.front().z));
}

}  // namespace nearfield::reference
