#pragma once
/// Exact signed Euclidean distances of solids, in metres, negative inside, and their gradients.
/// Gradients are unit vectors away from the solid. Where the distance has no gradient (centres, axes,
/// diagonal planes inside) they return one of the one-sided limits, or zero where no direction is favoured.

#include "segments.hpp"
#include "vector.hpp"

#include <algorithm>
#include <cmath>

namespace nearfield::reference {

struct Sphere {
  Vec3 center;
  Real radius{};
};

/// All points within `radius` of the segment a–b; a = b is a sphere.
struct Capsule {
  Vec3 a;
  Vec3 b;
  Real radius{};
};

struct Box {
  Vec3 center;
  Vec3 half_extents;
};

/// Finite solid cylinder, its axis along z.
struct Cylinder {
  Vec3 center;
  Real radius{};
  Real half_height{};
};

inline Real signed_distance(const Sphere& s, const Vec3& p) {
  return distance(p, s.center) - s.radius;
}

inline Vec3 distance_gradient(const Sphere& s, const Vec3& p) {
  return normalized_or_zero(p - s.center);
}

inline Real signed_distance(const Capsule& c, const Vec3& p) {
  return point_segment_distance(p, {c.a, c.b}) - c.radius;
}

inline Vec3 distance_gradient(const Capsule& c, const Vec3& p) {
  return normalized_or_zero(p - closest_point(p, {c.a, c.b}));
}

inline Real signed_distance(const Box& b, const Vec3& p) {
  const Vec3 local = p - b.center;
  const Vec3 excess{std::fabs(local.x) - b.half_extents.x, std::fabs(local.y) - b.half_extents.y,
                    std::fabs(local.z) - b.half_extents.z};
  const Real deepest = std::max({excess.x, excess.y, excess.z});
  if (deepest <= 0) return deepest;
  return norm({std::max(excess.x, Real{0}), std::max(excess.y, Real{0}), std::max(excess.z, Real{0})});
}

inline Vec3 distance_gradient(const Box& b, const Vec3& p) {
  const Vec3 local = p - b.center;
  const Vec3& h = b.half_extents;
  const Vec3 excess{std::fabs(local.x) - h.x, std::fabs(local.y) - h.y, std::fabs(local.z) - h.z};
  if (std::max({excess.x, excess.y, excess.z}) > 0) {
    const Vec3 nearest{std::clamp(local.x, -h.x, h.x), std::clamp(local.y, -h.y, h.y),
                       std::clamp(local.z, -h.z, h.z)};
    return normalized_or_zero(local - nearest);
  }
  if (excess.x >= excess.y && excess.x >= excess.z) return {std::copysign(Real{1}, local.x), 0, 0};
  if (excess.y >= excess.z) return {0, std::copysign(Real{1}, local.y), 0};
  return {0, 0, std::copysign(Real{1}, local.z)};
}

inline Real signed_distance(const Cylinder& c, const Vec3& p) {
  const Vec3 local = p - c.center;
  const Real beyond_side = std::sqrt(local.x * local.x + local.y * local.y) - c.radius;
  const Real beyond_cap = std::fabs(local.z) - c.half_height;
  if (beyond_side <= 0 || beyond_cap <= 0) return std::max(beyond_side, beyond_cap);
  return std::sqrt(beyond_side * beyond_side + beyond_cap * beyond_cap);
}

inline Vec3 distance_gradient(const Cylinder& c, const Vec3& p) {
  const Vec3 local = p - c.center;
  const Real beyond_side = std::sqrt(local.x * local.x + local.y * local.y) - c.radius;
  const Real beyond_cap = std::fabs(local.z) - c.half_height;
  const Vec3 outward = normalized_or_zero({local.x, local.y, 0});
  const Vec3 upward{0, 0, std::copysign(Real{1}, local.z)};
  if (beyond_side > 0 && beyond_cap > 0) {
    return normalized_or_zero(beyond_side * outward + beyond_cap * upward);
  }
  return beyond_side >= beyond_cap ? outward : upward;
}

}  // namespace nearfield::reference
