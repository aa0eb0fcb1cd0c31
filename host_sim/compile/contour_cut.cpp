#include "compile/contour_cut.hpp"

#include <cmath>
#include <utility>
#include <vector>

namespace nearfield::host {
namespace {

constexpr double object_surface = 0.5, contour_surface = 1.0;
constexpr std::size_t most_cells = 400000;
constexpr int deepest = 10;  // the cells of reach / 512 are 2 reach / 2^10 wide

// How much a field may differ from its value in the middle of a cube.
double margin(const RayField& field, double half) {
  return field.error + field.rate * half * std::sqrt(3.0);
}

}  // namespace

std::optional<ContourCut> contour_cut(const RayField& object, const RayField& contour, double reach, std::size_t& allowance) {
  std::vector<Vector3d> cells{Vector3d{}};
  std::size_t looked_at = 0;
  double half = reach;
  for (int depth = 0; depth <= deepest; ++depth, half /= 2.0) {
    std::vector<Vector3d> undecided;
    for (const Vector3d& centre : cells) {
      if (++looked_at > most_cells || allowance < object.steps + contour.steps) return std::nullopt;
      allowance -= object.steps + contour.steps;
      const double inside = object.value(centre);
      if (inside - margin(object, half) > object_surface) continue;
      const double within = contour.value(centre);
      if (within + margin(contour, half) < contour_surface) continue;
      if (inside <= object_surface && within >= contour_surface) return ContourCut{centre, inside, within};
      undecided.push_back(centre);
    }
    cells.clear();
    const double step = half / 2.0;
    for (const Vector3d& centre : undecided) {
      for (int octant = 0; octant < 8; ++octant) {
        const Vector3d towards{octant & 1 ? step : -step, octant & 2 ? step : -step, octant & 4 ? step : -step};
        cells.push_back(centre + towards);
      }
    }
  }
  return std::nullopt;
}

}  // namespace nearfield::host
