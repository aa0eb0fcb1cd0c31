// A camera's rays.
#pragma once

#include "render/renderer.hpp"

namespace nearfield::host {

Vector3d cross(const Vector3d& a, const Vector3d& b);
Vector3d normalised(const Vector3d& v);  // {0, 0, 0} stays

class View {
 public:
  View(const Camera& camera, std::size_t width, std::size_t height);

  // Through a place of the picture, pixels from the upper left corner.
  Ray ray(double x, double y) const;
  const Vector3d& forward() const { return forward_; }
  const Vector3d& right() const { return right_; }
  double pixel_angle() const { return pixel_angle_; }  // rad, in the middle

 private:
  Vector3d from_, forward_, right_, up_;
  double half_width_, half_height_, pixel_angle_;
};

}  // namespace nearfield::host
