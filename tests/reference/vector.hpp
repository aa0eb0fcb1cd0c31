#pragma once
/// Vectors, rotations and rigid motions of the reference: long double, lengths in metres, angles in radians.

#include <array>
#include <cmath>
#include <cstddef>
#include <stdexcept>

namespace nearfield::reference {

using Real = long double;

constexpr Real pi = 3.14159265358979323846264338327950288L;

struct Vec3 {
  Real x{};
  Real y{};
  Real z{};
};

inline Vec3 operator+(const Vec3& a, const Vec3& b) {
  return {a.x + b.x, a.y + b.y, a.z + b.z};
}
inline Vec3 operator-(const Vec3& a, const Vec3& b) {
  return {a.x - b.x, a.y - b.y, a.z - b.z};
}
inline Vec3 operator-(const Vec3& a) {
  return {-a.x, -a.y, -a.z};
}
inline Vec3 operator*(Real scale, const Vec3& a) {
  return {scale * a.x, scale * a.y, scale * a.z};
}
inline Vec3 operator*(const Vec3& a, Real scale) {
  return scale * a;
}
inline Vec3 operator/(const Vec3& a, Real divisor) {
  return {a.x / divisor, a.y / divisor, a.z / divisor};
}
inline Vec3& operator+=(Vec3& a, const Vec3& b) {
  return a = a + b;
}

inline Real dot(const Vec3& a, const Vec3& b) {
  return a.x * b.x + a.y * b.y + a.z * b.z;
}
inline Vec3 cross(const Vec3& a, const Vec3& b) {
  return {a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x};
}
inline Real squared_norm(const Vec3& a) {
  return dot(a, a);
}
inline Real norm(const Vec3& a) {
  return std::sqrt(squared_norm(a));
}
inline Real distance(const Vec3& a, const Vec3& b) {
  return norm(a - b);
}

/// Unit vector along `a`; the zero vector stays zero.
inline Vec3 normalized_or_zero(const Vec3& a) {
  const Real length = norm(a);
  return length > 0 ? a / length : Vec3{};
}

/// 3 × 3 matrix, row-major: entry (row, column) is `entries[3 * row + column]`. Default: identity.
struct Mat3 {
  std::array<Real, 9> entries{1, 0, 0, 0, 1, 0, 0, 0, 1};

  Real operator()(std::size_t row, std::size_t column) const { return entries[3 * row + column]; }
  Real& operator()(std::size_t row, std::size_t column) { return entries[3 * row + column]; }
};

inline Vec3 operator*(const Mat3& m, const Vec3& v) {
  return {m(0, 0) * v.x + m(0, 1) * v.y + m(0, 2) * v.z, m(1, 0) * v.x + m(1, 1) * v.y + m(1, 2) * v.z,
          m(2, 0) * v.x + m(2, 1) * v.y + m(2, 2) * v.z};
}

inline Mat3 operator*(const Mat3& a, const Mat3& b) {
  Mat3 product;
  for (std::size_t row = 0; row < 3; ++row) {
    for (std::size_t column = 0; column < 3; ++column) {
      product(row, column) = a(row, 0) * b(0, column) + a(row, 1) * b(1, column) + a(row, 2) * b(2, column);
    }
  }
  return product;
}

inline Mat3 transposed(const Mat3& m) {
  Mat3 result;
  for (std::size_t row = 0; row < 3; ++row) {
    for (std::size_t column = 0; column < 3; ++column) result(row, column) = m(column, row);
  }
  return result;
}

/// Rotation by `angle` about `axis` (any length but zero; std::invalid_argument otherwise), right-handed.
inline Mat3 rotation_from_axis_angle(const Vec3& axis, Real angle) {
  const Real length = norm(axis);
  if (!(length > 0)) throw std::invalid_argument("rotation axis of length zero");
  const Vec3 u = axis / length;
  const Real c = std::cos(angle);
  const Real s = std::sin(angle);
  const Real k = 1 - c;
  return {{c + u.x * u.x * k, u.x * u.y * k - u.z * s, u.x * u.z * k + u.y * s,  //
           u.y * u.x * k + u.z * s, c + u.y * u.y * k, u.y * u.z * k - u.x * s,  //
           u.z * u.x * k - u.y * s, u.z * u.y * k + u.x * s, c + u.z * u.z * k}};
}

/// URDF `rpy`: roll about the fixed x, then pitch about the fixed y, then yaw about the fixed z.
inline Mat3 rotation_from_rpy(Real roll, Real pitch, Real yaw) {
  return rotation_from_axis_angle({0, 0, 1}, yaw) * rotation_from_axis_angle({0, 1, 0}, pitch) *
         rotation_from_axis_angle({1, 0, 0}, roll);
}

/// Rotation of the quaternion w + xi + yj + zk, of any length but zero (std::invalid_argument otherwise).
inline Mat3 rotation_from_quaternion(Real w, Real x, Real y, Real z) {
  const Real squared_length = w * w + x * x + y * y + z * z;
  if (!(squared_length > 0)) throw std::invalid_argument("quaternion of length zero");
  const Real k = 2 / squared_length;
  return {{1 - k * (y * y + z * z), k * (x * y - w * z), k * (x * z + w * y),  //
           k * (x * y + w * z), 1 - k * (x * x + z * z), k * (y * z - w * x),  //
           k * (x * z - w * y), k * (y * z + w * x), 1 - k * (x * x + y * y)}};
}

/// Rigid motion from a local frame to the world: world = rotation · local + translation. Default: identity.
struct Pose {
  Mat3 rotation{};
  Vec3 translation{};
};

inline Vec3 to_world(const Pose& pose, const Vec3& local) {
  return pose.rotation * local + pose.translation;
}
inline Vec3 to_local(const Pose& pose, const Vec3& world) {
  return transposed(pose.rotation) * (world - pose.translation);
}

/// First `inner`, then `outer`.
inline Pose operator*(const Pose& outer, const Pose& inner) {
  return {outer.rotation * inner.rotation, to_world(outer, inner.translation)};
}

inline Pose inverse(const Pose& pose) {
  const Mat3 back = transposed(pose.rotation);
  return {back, -(back * pose.translation)};
}

}  // namespace nearfield::reference
