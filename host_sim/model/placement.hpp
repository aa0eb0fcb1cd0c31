#pragma once

#include <array>
#include <cmath>
#include <optional>

#include "model/vector3d.hpp"

namespace nearfield::host {

using Rotation = std::array<double, 9>;  // row-major; its columns are the local axes seen from the parent

// Where a local frame lies in its parent: parent point = rotation · local point + position.
struct Placement {
  Vector3d position;  // m
  Rotation rotation{1.0, 0.0, 0.0, 0.0, 1.0, 0.0, 0.0, 0.0, 1.0};
};

inline bool is_identity(const Placement& placement) {
  const Vector3d& at = placement.position;
  return at.x == 0.0 && at.y == 0.0 && at.z == 0.0 && placement.rotation == Placement{}.rotation;
}

inline Vector3d rotate(const Rotation& r, const Vector3d& v) {
  return {r[0] * v.x + r[1] * v.y + r[2] * v.z, r[3] * v.x + r[4] * v.y + r[5] * v.z,
          r[6] * v.x + r[7] * v.y + r[8] * v.z};
}

// A local point in parent coordinates.
inline Vector3d transform_point(const Placement& placement, const Vector3d& local) {
  return rotate(placement.rotation, local) + placement.position;
}

// The frame `child`, given in `parent`'s frame, in the frame that `parent` is given in.
inline Placement compose(const Placement& parent, const Placement& child) {
  Placement result;
  for (std::size_t row = 0; row < 3; ++row) {
    for (std::size_t column = 0; column < 3; ++column) {
      double sum = 0.0;
      for (std::size_t k = 0; k < 3; ++k) {
        sum += parent.rotation[3 * row + k] * child.rotation[3 * k + column];
      }
      result.rotation[3 * row + column] = sum;
    }
  }
  result.position = transform_point(parent, child.position);
  return result;
}

inline Placement inverse(const Placement& placement) {
  const Rotation& r = placement.rotation;
  Placement result;
  result.rotation = {r[0], r[3], r[6], r[1], r[4], r[7], r[2], r[5], r[8]};
  result.position = -1.0 * rotate(result.rotation, placement.position);
  return result;
}

// Roll, pitch, yaw in rad about the parent's fixed x, y, z axes, as URDF has it: Rz(yaw) Ry(pitch) Rx(roll).
inline Placement placement_from_rpy(const Vector3d& position, double roll, double pitch, double yaw) {
  const double cr = std::cos(roll);
  const double sr = std::sin(roll);
  const double cp = std::cos(pitch);
  const double sp = std::sin(pitch);
  const double cy = std::cos(yaw);
  const double sy = std::sin(yaw);
  return {position,
          {cy * cp, cy * sp * sr - sy * cr, cy * sp * cr + sy * sr,  //
           sy * cp, sy * sp * sr + cy * cr, sy * sp * cr - cy * sr,  //
           -sp, cp * sr, cp * cr}};
}

inline constexpr double quaternion_norm_tolerance = 1e-6;

// A quaternion x, y, z, w, normalised; nothing when its norm differs from 1 by more than the tolerance.
inline std::optional<Placement> placement_from_quaternion_xyzw(const Vector3d& position,
                                                               const std::array<double, 4>& quaternion) {
  const double norm = std::hypot(std::hypot(quaternion[0], quaternion[1], quaternion[2]), quaternion[3]);
  if (!(std::abs(norm - 1.0) <= quaternion_norm_tolerance)) return std::nullopt;
  const double x = quaternion[0] / norm;
  const double y = quaternion[1] / norm;
  const double z = quaternion[2] / norm;
  const double w = quaternion[3] / norm;
  return Placement{position,
                   {1.0 - 2.0 * (y * y + z * z), 2.0 * (x * y - z * w), 2.0 * (x * z + y * w),  //
                    2.0 * (x * y + z * w), 1.0 - 2.0 * (x * x + z * z), 2.0 * (y * z - x * w),  //
                    2.0 * (x * z - y * w), 2.0 * (y * z + x * w), 1.0 - 2.0 * (x * x + y * y)}};
}

}  // namespace nearfield::host
