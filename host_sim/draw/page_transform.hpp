#pragma once

#include "draw/geometry.hpp"

namespace nearfield::host::draw {

/// The part of a plane of the world that a panel shows, metres, y up. left < right and bottom < top.
struct WorldWindow {
  double left = 0.0;
  double right = 1.0;
  double bottom = 0.0;
  double top = 1.0;
};

/// Maps a window of the world onto the page, with the same scale along both axes and y turned over.
class WorldToPage {
 public:
  WorldToPage(const WorldWindow& window, Point top_left, double pixels_per_metre)
      : window_(window), top_left_(top_left), scale_(pixels_per_metre) {}

  Point operator()(Point world) const {
    return {top_left_.x + (world.x - window_.left) * scale_, top_left_.y + (window_.top - world.y) * scale_};
  }
  double pixels(double metres) const { return metres * scale_; }
  const WorldWindow& window() const { return window_; }
  Rectangle frame() const {
    return {top_left_.x, top_left_.y, pixels(window_.right - window_.left),
            pixels(window_.top - window_.bottom)};
  }
  Polyline operator()(const Polyline& world) const {
    Polyline page;
    page.closed = world.closed;
    page.points.reserve(world.points.size());
    for (const Point& p : world.points) page.points.push_back((*this)(p));
    return page;
  }

 private:
  WorldWindow window_;
  Point top_left_;
  double scale_;
};

}  // namespace nearfield::host::draw
