// What every mesh of a surface must be.
#pragma once

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <set>
#include <utility>

#include "render/surface_mesh.hpp"

namespace nearfield::host {

// Every edge once in each direction. Returns the Euler characteristic.
inline long expect_closed(const SurfaceMesh& mesh) {
  std::map<std::pair<std::uint32_t, std::uint32_t>, int> edges;
  std::set<std::uint32_t> used;
  for (const auto& triangle : mesh.triangles) {
    for (std::size_t i = 0; i < 3; ++i) {
      ++edges[{triangle[i], triangle[(i + 1) % 3]}];
      used.insert(triangle[i]);
    }
  }
  std::size_t faults = 0;
  for (const auto& [edge, count] : edges) {
    const auto back = edges.find({edge.second, edge.first});
    if (count != 1 || back == edges.end() || back->second != 1) ++faults;
  }
  EXPECT_EQ(faults, 0U);
  EXPECT_EQ(used.size(), mesh.vertices.size());
  return static_cast<long>(mesh.vertices.size()) - static_cast<long>(edges.size() / 2) +
         static_cast<long>(mesh.triangles.size());
}

// What moving by the rounding of the scalar changes is added to the certificate's error.
inline void expect_on_surface(const SceneField& field, const SurfaceMesh& mesh) {
  const double unit = 7.5e-9;  // of q27, m
  const double allowed = field.proof().error + 4.0 * unit * (1.0 + field.proof().rate.value_or(0.0));
  double worst = 0.0;
  for (const SurfaceMesh::Vertex& vertex : mesh.vertices)
    worst = std::max(worst, std::abs(field.outward(vertex.position)));
  EXPECT_LE(worst, allowed);
}

}  // namespace nearfield::host
