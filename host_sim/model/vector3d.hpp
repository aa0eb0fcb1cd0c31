#pragma once

#include <cmath>

namespace nearfield::host {

struct Vector3d {
  double x = 0.0;
  double y = 0.0;
  double z = 0.0;
};

inline Vector3d operator+(const Vector3d& a, const Vector3d& b) { return {a.x + b.x, a.y + b.y, a.z + b.z}; }
inline Vector3d operator-(const Vector3d& a, const Vector3d& b) { return {a.x - b.x, a.y - b.y, a.z - b.z}; }
inline Vector3d operator*(double factor, const Vector3d& a) {
  return {factor * a.x, factor * a.y, factor * a.z};
}
inline double dot(const Vector3d& a, const Vector3d& b) { return a.x * b.x + a.y * b.y + a.z * b.z; }
inline double length(const Vector3d& a) { return std::hypot(a.x, a.y, a.z); }
// Of any vector but 0, however short.
inline Vector3d unit_of(const Vector3d& a) {
  const double size = length(a);
  const Vector3d divided{a.x / size, a.y / size, a.z / size};
  return 1.0 / length(divided) * divided;
}

}  // namespace nearfield::host
