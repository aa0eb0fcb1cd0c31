#pragma once

#include <vector>

namespace nearfield::host::draw {

/// A point of a plane: metres in the world (y up), or pixels on the page (y down).
struct Point {
  double x = 0.0;
  double y = 0.0;
};

/// An upright rectangle on the page, in pixels.
struct Rectangle {
  double left = 0.0;
  double top = 0.0;
  double width = 0.0;
  double height = 0.0;

  double right() const { return left + width; }
  double bottom() const { return top + height; }
};

/// A chain of points. A closed one joins its last point to its first, which is not repeated.
struct Polyline {
  std::vector<Point> points;
  bool closed = false;
};

/// The line with fewer points that stays within `tolerance` (>= 0, in the points' own unit) of the original:
/// Douglas-Peucker, first and last point kept. A closed line keeps its first point and stays closed.
Polyline simplified(const Polyline& line, double tolerance);

}  // namespace nearfield::host::draw
