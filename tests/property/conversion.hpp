#pragma once
/// Between the numbers under test and the real numbers of the reference.

#include <nearfield/modify/frame.hpp>
#include <nearfield/shape/capsule.hpp>

#include "reference/segments.hpp"
#include "reference/vector.hpp"

#include <cmath>
#include <cstddef>
#include <string>
#include <type_traits>

namespace nearfield::property {

using reference::Real;

/// What a scalar is called in a test's output.
template <class S>
struct ScalarName;
template <int F>
struct ScalarName<Fixed<F>> {
  static std::string text() { return "Fixed<" + std::to_string(F) + ">"; }
};
template <>
struct ScalarName<float> {
  static std::string text() { return "float"; }
};

/// Exact.
template <int F, class R>
Real real(Fixed<F, R> a) {
  return std::ldexp(static_cast<Real>(a.raw()), -F);
}
inline Real real(float a) { return static_cast<Real>(a); }
template <class T>
reference::Vec3 real(const Vector3<T>& a) {
  return {real(a.x), real(a.y), real(a.z)};
}

/// The unit in which observed errors are printed: in the last place for Fixed, in the last place of
/// `magnitude` for float.
template <class S>
Real last_place(Real magnitude) {
  if constexpr (ScalarTraits<S>::is_fixed) {
    return real(S::unit_in_last_place());
  } else {
    int exponent = 0;
    std::frexp(magnitude, &exponent);
    return std::ldexp(Real{1}, exponent - 24);
  }
}

/// Nearest number of type T.
template <class T>
T rounded(Real a) {
  if constexpr (std::is_same_v<T, float>) {
    return static_cast<float>(a);
  } else {
    return T(static_cast<double>(a));
  }
}
template <class T>
Vector3<T> rounded(const reference::Vec3& a) {
  return {rounded<T>(a.x), rounded<T>(a.y), rounded<T>(a.z)};
}

template <class S>
Rotation<S> rounded_rotation(const reference::Mat3& m) {
  Rotation<S> result;
  for (std::size_t row = 0; row < 3; ++row) {
    result.row[row] = rounded<Unit<S>>(reference::Vec3{m(row, 0), m(row, 1), m(row, 2)});
  }
  return result;
}
template <class S>
Pose<S> rounded_pose(const reference::Pose& pose) {
  return {rounded_rotation<S>(pose.rotation), rounded<S>(pose.translation)};
}

/// The segment of a capsule exactly as it is stored: from `from`, `length` times `axis`.
template <class S>
reference::Segment stored_segment(const Capsule<S>& capsule) {
  const reference::Vec3 start = real(capsule.from);
  return {start, start + real(capsule.length) * real(capsule.axis)};
}

}  // namespace nearfield::property
