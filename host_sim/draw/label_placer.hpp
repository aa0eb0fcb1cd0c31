#pragma once

#include <optional>
#include <vector>

#include "draw/geometry.hpp"

namespace nearfield::host::draw {

/// Keeps labels inside a frame, off one another and off what has been blocked. All lengths in pixels.
class LabelPlacer {
 public:
  explicit LabelPlacer(const Rectangle& frame) : frame_(frame) {}

  /// Keeps labels off a rectangle, or off all points within `radius` of a segment.
  void block(const Rectangle& area) { rectangles_.push_back(area); }
  void block(Point a, Point b, double radius) { stadiums_.push_back({a, b, radius}); }

  /// Whether a rectangle lies in the frame and clear of everything blocked.
  bool is_free(const Rectangle& area) const;

  /// The first of the centres at which a label of this size is free; that place is then blocked.
  std::optional<Point> place(const std::vector<Point>& centres, double width, double height);

 private:
  struct Stadium {
    Point a;
    Point b;
    double radius;
  };
  Rectangle frame_;
  std::vector<Rectangle> rectangles_;
  std::vector<Stadium> stadiums_;
};

}  // namespace nearfield::host::draw
