#include "draw/label_placer.hpp"

#include <algorithm>
#include <cmath>

namespace nearfield::host::draw {
namespace {

bool overlap(const Rectangle& a, const Rectangle& b) {
  return a.left < b.right() && b.left < a.right() && a.top < b.bottom() && b.top < a.bottom();
}

double squared_distance(Point p, const Rectangle& area) {
  const double dx = p.x - std::clamp(p.x, area.left, area.right());
  const double dy = p.y - std::clamp(p.y, area.top, area.bottom());
  return dx * dx + dy * dy;
}

}  // namespace

bool LabelPlacer::is_free(const Rectangle& area) const {
  if (area.left < frame_.left || area.top < frame_.top || area.right() > frame_.right() ||
      area.bottom() > frame_.bottom()) {
    return false;
  }
  for (const Rectangle& blocked : rectangles_) {
    if (overlap(area, blocked)) return false;
  }
  for (const Stadium& stadium : stadiums_) {
    const double dx = stadium.b.x - stadium.a.x;
    const double dy = stadium.b.y - stadium.a.y;
    const double steps = std::ceil(std::sqrt(dx * dx + dy * dy) / 3.0) + 1.0;
    for (double step = 0.0; step <= steps; step += 1.0) {
      const Point p{stadium.a.x + dx * (step / steps), stadium.a.y + dy * (step / steps)};
      if (squared_distance(p, area) < stadium.radius * stadium.radius) return false;
    }
  }
  return true;
}

std::optional<Point> LabelPlacer::place(const std::vector<Point>& centres, double width, double height) {
  for (const Point& centre : centres) {
    const Rectangle area{centre.x - width / 2.0, centre.y - height / 2.0, width, height};
    if (!is_free(area)) continue;
    block(area);
    return centre;
  }
  return std::nullopt;
}

}  // namespace nearfield::host::draw
