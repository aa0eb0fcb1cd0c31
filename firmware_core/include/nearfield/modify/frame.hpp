// Rigid poses: where a body or a group of shapes is.
#pragma once

#include <nearfield/shape/certificate.hpp>
#include <nearfield/shape/sample.hpp>

namespace nearfield {

// Rotation matrix by rows, entries within [-1, 1].
template <class S> struct Rotation {
  Vector3<Unit<S>> row[3] = {{ScalarTraits<S>::unit_one(), {}, {}},
                             {{}, ScalarTraits<S>::unit_one(), {}},
                             {{}, {}, ScalarTraits<S>::unit_one()}};

  constexpr Vector3<Unit<S>> column(int i) const {
    return i == 0 ? Vector3<Unit<S>>{row[0].x, row[1].x, row[2].x}
           : i == 1 ? Vector3<Unit<S>>{row[0].y, row[1].y, row[2].y}
                    : Vector3<Unit<S>>{row[0].z, row[1].z, row[2].z};
  }
};

// Point in the outer frame = rotation * point in the inner frame + translation (metres).
template <class S> struct Pose {
  Rotation<S> rotation;
  Vector3<S> translation;
};

// Rotated by R, or back by its transpose. Each component is a sum of three exact products, rounded once; in range
// when |v| is. For directions, distances and unit vectors alike.
template <class S, class T> constexpr Vector3<T> rotate(const Rotation<S>& r, const Vector3<T>& v) {
  return {narrow_in_range<T>(dot(r.row[0], v)), narrow_in_range<T>(dot(r.row[1], v)),
          narrow_in_range<T>(dot(r.row[2], v))};
}
template <class S, class T> constexpr Vector3<T> rotate_back(const Rotation<S>& r, const Vector3<T>& v) {
  return {narrow_in_range<T>(dot(r.column(0), v)), narrow_in_range<T>(dot(r.column(1), v)),
          narrow_in_range<T>(dot(r.column(2), v))};
}

template <class S> constexpr Vector3<S> to_outer(const Pose<S>& pose, const Vector3<S>& p) {
  return add_in_range(rotate(pose.rotation, p), pose.translation);
}
template <class S> constexpr Vector3<S> to_inner(const Pose<S>& pose, const Vector3<S>& p) {
  return rotate_back(pose.rotation, subtract_in_range(p, pose.translation));
}

// Whether a pose may be used: translation within the domain, rows of unit length and at right angles within
// 32 units of 2^-30 (float: 2^-19), right-handed. False for NaN.
template <class S> constexpr bool valid_pose(const Pose<S>& pose) {
  using U = Unit<S>;
  using T = ScalarTraits<U>;
  if (!coordinates_in_domain(pose.translation)) return false;
  const U one = ScalarTraits<S>::unit_one();
  const U slack = T::times(T::rounding_unit(one), ScalarTraits<S>::is_fixed ? 32 : 4);
  const U limit = one + slack;
  for (const Vector3<U>& row : pose.rotation.row) {
    if (!(within(row.x, -limit, limit) && within(row.y, -limit, limit) && within(row.z, -limit, limit))) return false;
  }
  for (int i = 0; i < 3; ++i) {
    const Vector3<U>& row = pose.rotation.row[i];
    const Vector3<U>& next = pose.rotation.row[(i + 1) % 3];
    const Vector3<U>& last = pose.rotation.row[(i + 2) % 3];
    if (!within(narrow<U>(dot(row, row)), one - slack - slack, limit + slack)) return false;
    if (!within(narrow<U>(dot(row, next)), -slack, slack)) return false;
    // Right-handed: the first component of row x next is that of the last row.
    const U cross_x = narrow<U>(product(row.y, next.z) - product(row.z, next.y));
    if (!within(cross_x - last.x, -slack - slack, slack + slack)) return false;
  }
  return true;
}

// The certificate of a child seen through a pose.
// Rounding units, at most 16 m from the pose's origin: translation sqrt(3)/2, product sqrt(3)/2, entries of a
// constant rotation (1/2 unit of 2^-30 each) 3. A pose handed in at run time may be as far from a rotation as
// valid_pose() lets pass: 128 more.
enum class PoseOrigin : uint8_t { constant, run_time };
// How far from its place in the inner frame a point may be computed.
template <class S> constexpr S moved_by_rounding(Reach<S> inner, PoseOrigin origin) {
  return ScalarTraits<S>::times(ScalarTraits<S>::rounding_unit(inner.radius), origin == PoseOrigin::constant ? 5 : 133);
}
template <class S>
constexpr Certificate<S> placed_certificate(const Certificate<S>& child, Kind kind, Reach<S> inner, PoseOrigin origin) {
  using T = ScalarTraits<S>;
  Certificate<S> placed = child;
  const S moved = moved_by_rounding(inner, origin);
  const S lengths = kind == Kind::distance ? moved : T::times(moved, 1 << -kGradientLengthLog2);
  placed.error = child.lipschitz == kNoRateBound ? T::greatest() : child.error + T::multiply_up(lengths, child.lipschitz);
  return placed;
}
// The reach inside a pose of this translation.
template <class S> constexpr Reach<S> inner_reach(Reach<S> outer, const Vector3<S>& translation) {
  return {outer.radius + length_of<S>(sum_of_squares(translation.x, translation.y, translation.z)) +
          ScalarTraits<S>::rounding_unit(outer.radius)};
}
// A ball that holds, inside a pose of this translation, what `outer` holds outside.
template <class S> constexpr Ball<S> inner_ball(const Ball<S>& outer, const Vector3<S>& translation, PoseOrigin origin) {
  const Reach<S> inner = inner_reach(Reach<S>{outer.reach}, translation);
  return {outer.radius + moved_by_rounding(inner, origin), inner.radius};
}

}  // namespace nearfield
