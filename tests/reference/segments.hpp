#pragma once
/// Distances between points and segments. Segments of length zero are points; nothing here divides by zero.
/// Accuracy: a few units of rounding of the coordinates' size, however close to parallel the segments are.

#include "vector.hpp"

#include <algorithm>
#include <array>

namespace nearfield::reference {

struct Segment {
  Vec3 a;
  Vec3 b;
};

inline Vec3 point_at(const Segment& segment, Real parameter) {
  return (1 - parameter) * segment.a + parameter * segment.b;
}

/// Parameter in [0, 1] of the point of `segment` nearest to `p`; 0 for a segment of length zero.
inline Real closest_parameter(const Vec3& p, const Segment& segment) {
  const Vec3 along = segment.b - segment.a;
  const Real squared_length = squared_norm(along);
  if (!(squared_length > 0)) return 0;
  return std::clamp(dot(p - segment.a, along) / squared_length, Real{0}, Real{1});
}

inline Vec3 closest_point(const Vec3& p, const Segment& segment) {
  return point_at(segment, closest_parameter(p, segment));
}

inline Real squared_point_segment_distance(const Vec3& p, const Segment& segment) {
  return squared_norm(p - closest_point(p, segment));
}

inline Real point_segment_distance(const Vec3& p, const Segment& segment) {
  return distance(p, closest_point(p, segment));
}

/// A nearest pair of points of two segments (one of many where the segments are parallel).
struct ClosestPair {
  Vec3 on_first;
  Vec3 on_second;
  Real distance{};
};

/// The squared distance is a convex quadratic over the parameter square, so its least value is taken at an
/// end of one of the segments, or inside both, where the connecting line is perpendicular to both. All five
/// candidates are tried; every one is a true pair of points, so the answer is never below the distance.
inline ClosestPair closest_pair(const Segment& first, const Segment& second) {
  ClosestPair best{first.a, second.a, distance(first.a, second.a)};
  const auto consider = [&best](const Vec3& on_first, const Vec3& on_second) {
    const Real candidate = distance(on_first, on_second);
    if (candidate < best.distance) best = {on_first, on_second, candidate};
  };
  for (const Vec3& end : {first.a, first.b}) consider(end, closest_point(end, second));
  for (const Vec3& end : {second.a, second.b}) consider(closest_point(end, first), end);

  const Vec3 along_first = first.b - first.a;
  const Vec3 along_second = second.b - second.a;
  const Vec3 normal = cross(along_first, along_second);
  const Real squared_normal = squared_norm(normal);
  if (squared_normal > 0) {
    // The cross-product form errs by rounding / sin(angle) along the segment, hence by rounding in distance.
    const Real parameter = dot(cross(second.a - first.a, along_second), normal) / squared_normal;
    const Vec3 start = point_at(first, std::clamp(parameter, Real{0}, Real{1}));
    const Vec3 on_second = closest_point(start, second);
    consider(start, on_second);
    consider(closest_point(on_second, first), on_second);
  }
  return best;
}

inline Real segment_segment_distance(const Segment& first, const Segment& second) {
  return closest_pair(first, second).distance;
}

/// Distance between the surfaces of two capsules; negative: they overlap, by at least that much.
inline Real capsule_capsule_clearance(const Segment& first, Real first_radius, const Segment& second,
                                      Real second_radius) {
  return segment_segment_distance(first, second) - first_radius - second_radius;
}

}  // namespace nearfield::reference
