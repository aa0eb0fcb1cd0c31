#pragma once
/// Signed distances of more solids, in metres, negative inside, by way of nearest points. Written from
/// geometry alone.

#include "shapes.hpp"
#include "vector.hpp"

#include <algorithm>
#include <cmath>

namespace nearfield::reference {

/// Convex hull of a ball about `a` and one about `b`.
struct TaperedCapsule {
  Vec3 a;
  Vec3 b;
  Real radius_a{};
  Real radius_b{};
};

/// Frustum about z: a disc at -half_height, a disc at half_height and all between them.
struct ConeFrustum {
  Vec3 center;
  Real radius_below{};
  Real radius_above{};
  Real half_height{};
};

/// Ring about z.
struct Torus {
  Vec3 center;
  Real ring_radius{};
  Real tube_radius{};
};

/// All points within `thickness` of a filled disc in the xy plane.
struct Disc {
  Vec3 center;
  Real radius{};
  Real thickness{};
};

/// What lies below the plane through `point`; the normal may have any length but zero.
struct HalfSpace {
  Vec3 point;
  Vec3 normal;
};

/// All points within `radius` of a line along z.
struct InfiniteCylinder {
  Vec3 point;
  Real radius{};
};

/// Opens towards +z from its apex; half angle in radians, from 0 to pi/2.
struct InfiniteCone {
  Vec3 apex;
  Real half_angle{};
};

namespace detail {

/// In the half plane through a point and the z axis.
struct Planar {
  Real x{};
  Real z{};
};
inline Planar in_half_plane(const Vec3& q) { return {std::sqrt(q.x * q.x + q.y * q.y), q.z}; }
inline Real planar_distance(const Planar& p, const Planar& q) {
  const Real x = p.x - q.x;
  const Real z = p.z - q.z;
  return std::sqrt(x * x + z * z);
}
inline Real planar_segment_distance(const Planar& p, const Planar& a, const Planar& b) {
  const Real x = b.x - a.x;
  const Real z = b.z - a.z;
  const Real squares = x * x + z * z;
  const Real place =
      squares > 0 ? std::clamp(((p.x - a.x) * x + (p.z - a.z) * z) / squares, Real{0}, Real{1}) : Real{0};
  return planar_distance(p, {a.x + place * x, a.z + place * z});
}

}  // namespace detail

/// The hull is the union of balls whose centres and radii go evenly from one to the other; the distance from
/// the ball at place t is a convex function of t, whose only place without a slope has the closed form below.
inline Real signed_distance(const TaperedCapsule& c, const Vec3& p) {
  const Real length = distance(c.a, c.b);
  const auto from_ball = [&](Real t) {
    return norm(p - (c.a + t * (c.b - c.a))) - (c.radius_a + t * (c.radius_b - c.radius_a));
  };
  Real least = std::min(from_ball(0), from_ball(1));
  const Real taper = c.radius_a - c.radius_b;
  if (length > std::fabs(taper)) {
    const Vec3 axis = (c.b - c.a) / length;
    const Real along = dot(p - c.a, axis);
    const Real across = norm(p - c.a - along * axis);
    // There the slope of the radius is that of the distance from the centre: (along - t) / distance.
    const Real place = along - across * taper / std::sqrt((length - taper) * (length + taper));
    if (place > 0 && place < length) least = std::min(least, from_ball(place / length));
  }
  return least;
}

inline Real signed_distance(const ConeFrustum& c, const Vec3& p) {
  const detail::Planar q = detail::in_half_plane(p - c.center);
  const detail::Planar below{c.radius_below, -c.half_height};
  const detail::Planar above{c.radius_above, c.half_height};
  const Real nearest = std::min({detail::planar_segment_distance(q, {0, below.z}, below),
                                 detail::planar_segment_distance(q, below, above),
                                 detail::planar_segment_distance(q, above, {0, above.z})});
  const Real share = (q.z + c.half_height) / (2 * c.half_height);
  const bool inside =
      share >= 0 && share <= 1 && q.x <= c.radius_below + share * (c.radius_above - c.radius_below);
  return inside ? -nearest : nearest;
}

inline Real signed_distance(const Torus& t, const Vec3& p) {
  const detail::Planar q = detail::in_half_plane(p - t.center);
  return detail::planar_distance(q, {t.ring_radius, 0}) - t.tube_radius;
}

inline Real signed_distance(const Disc& d, const Vec3& p) {
  const detail::Planar q = detail::in_half_plane(p - d.center);
  return detail::planar_segment_distance(q, {0, 0}, {d.radius, 0}) - d.thickness;
}

inline Real signed_distance(const HalfSpace& h, const Vec3& p) {
  return dot(p - h.point, h.normal) / norm(h.normal);
}

inline Real signed_distance(const InfiniteCylinder& c, const Vec3& p) {
  return detail::in_half_plane(p - c.point).x - c.radius;
}

inline Real signed_distance(const InfiniteCone& c, const Vec3& p) {
  const detail::Planar q = detail::in_half_plane(p - c.apex);
  const detail::Planar generator{std::sin(c.half_angle), std::cos(c.half_angle)};
  const Real place = std::max(Real{0}, q.x * generator.x + q.z * generator.z);
  const Real nearest = detail::planar_distance(q, {place * generator.x, place * generator.z});
  return q.x * generator.z < q.z * generator.x ? -nearest : nearest;
}

}  // namespace nearfield::reference
