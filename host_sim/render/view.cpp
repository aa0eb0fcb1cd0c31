#include "render/view.hpp"

#include <algorithm>
#include <cmath>

namespace nearfield::host {
namespace {

constexpr double half_degree = 3.14159265358979323846 / 360.0;  // half of one, rad

}  // namespace

Vector3d cross(const Vector3d& a, const Vector3d& b) {
  return {a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x};
}
Vector3d normalised(const Vector3d& v) {
  const double size = length(v);
  return size > 0.0 ? 1.0 / size * v : v;
}

View::View(const Camera& camera, std::size_t width, std::size_t height)
    : from_(camera.from),
      forward_(normalised(camera.at - camera.from)),
      half_width_(0.5 * static_cast<double>(width)),
      half_height_(0.5 * static_cast<double>(height)),
      pixel_angle_(std::tan(half_degree * camera.field_of_view) / half_height_) {
  const bool along_z = std::abs(forward_.z) > 0.9999;
  right_ = normalised(cross(forward_, along_z ? Vector3d{0.0, 1.0, 0.0} : Vector3d{0.0, 0.0, 1.0}));
  up_ = cross(right_, forward_);
}

Ray View::ray(double x, double y) const {
  return {from_, normalised(forward_ + pixel_angle_ * (x - half_width_) * right_ +
                            pixel_angle_ * (half_height_ - y) * up_)};
}

Camera camera_framing(const Box3& box, double field_of_view, std::size_t width, std::size_t height) {
  const Vector3d middle = box.middle();
  const Vector3d back = normalised({0.62, -1.0, 0.58});
  // The least distance from which every corner is within 88 % of the picture.
  const View view({middle + back, middle, field_of_view}, width, height);
  const Vector3d up = cross(view.right(), view.forward());
  const double across = 0.88 * view.pixel_angle() * 0.5 * static_cast<double>(width);
  const double upwards = 0.88 * view.pixel_angle() * 0.5 * static_cast<double>(height);
  double distance = 1e-3;
  for (unsigned i = 0; i < 8; ++i) {
    const Vector3d corner{(i & 1U) != 0 ? box.high.x : box.low.x, (i & 2U) != 0 ? box.high.y : box.low.y,
                          (i & 4U) != 0 ? box.high.z : box.low.z};
    const Vector3d off = corner - middle;
    const double nearer = dot(off, back);
    distance = std::max({distance, nearer + std::abs(dot(off, view.right())) / across,
                         nearer + std::abs(dot(off, up)) / upwards});
  }
  return {middle + distance * back, middle, field_of_view};
}

}  // namespace nearfield::host
