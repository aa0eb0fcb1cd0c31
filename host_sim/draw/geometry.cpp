#include "draw/geometry.hpp"

#include <cstddef>
#include <utility>

namespace nearfield::host::draw {
namespace {

double squared_distance_to_segment(Point p, Point a, Point b) {
  const double along_x = b.x - a.x;
  const double along_y = b.y - a.y;
  const double length_squared = along_x * along_x + along_y * along_y;
  double t = 0.0;
  if (length_squared > 0.0) {
    t = ((p.x - a.x) * along_x + (p.y - a.y) * along_y) / length_squared;
    t = t < 0.0 ? 0.0 : (t > 1.0 ? 1.0 : t);
  }
  const double dx = p.x - (a.x + t * along_x);
  const double dy = p.y - (a.y + t * along_y);
  return dx * dx + dy * dy;
}

}  // namespace

Polyline simplified(const Polyline& line, double tolerance) {
  std::vector<Point> points = line.points;
  if (line.closed && !points.empty()) points.push_back(points.front());
  if (points.size() < 3) return line;

  std::vector<bool> kept(points.size(), false);
  kept.front() = true;
  kept.back() = true;
  std::vector<std::pair<std::size_t, std::size_t>> spans{{0, points.size() - 1}};
  while (!spans.empty()) {
    const auto [first, last] = spans.back();
    spans.pop_back();
    double farthest = tolerance * tolerance;
    std::size_t split = first;
    for (std::size_t i = first + 1; i < last; ++i) {
      const double distance = squared_distance_to_segment(points[i], points[first], points[last]);
      if (distance > farthest) {
        farthest = distance;
        split = i;
      }
    }
    if (split == first) continue;
    kept[split] = true;
    spans.emplace_back(first, split);
    spans.emplace_back(split, last);
  }

  Polyline result;
  result.closed = line.closed;
  const std::size_t count = line.closed ? points.size() - 1 : points.size();
  for (std::size_t i = 0; i < count; ++i) {
    if (kept[i]) result.points.push_back(points[i]);
  }
  return result;
}

}  // namespace nearfield::host::draw
