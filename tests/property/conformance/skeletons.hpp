#pragma once
/// Segments whose ray functions are scaled.

#include "property/conformance/rows_of_scalars.hpp"
#include "reference/segments.hpp"

namespace nearfield::property {

inline constexpr Real least_radius = 1.0L / 64;
inline Real ray_radius(Random& random, Real size) {
  return std::max(least_radius, even(random.uniform(0.2L, 1) * size));
}

inline Real cut_off(Real ray) { return std::min<Real>(ray, kGreatestRay); }

/// Slopes of smaller things leave the number range; floats err by so much far from the origin that slopes of
/// small things cannot be told from differences.
template <class S>
Real telling(Real size) {
  return std::max(size, (ScalarTraits<S>::is_fixed ? 0.05L : 0.4L) * real(ScalarTraits<S>::domain()));
}

struct Skeleton {
  Vec3 from, axis{0, 0, 1};
  Real length = 0, radius = 1;
  template <class S>
  Capsule<S> capsule(Real thickness) const {
    const auto unit = length > 0 ? rounded<Unit<S>>(axis) : Vector3<Unit<S>>{};
    return Capsule<S>(rounded<S>(from), unit, rounded<S>(length), rounded<S>(thickness));
  }
  template <class S>
  RaySegment<S> ray() const {
    return {capsule<S>(0), RayRadius<S>(rounded<S>(radius))};
  }
  Real cut_off(const Vec3& p, Real cut) const {
    return std::min(cut, reference::point_segment_distance(p, {from, from + length * axis}) / radius);
  }
};
inline Skeleton draw_skeleton(Random& random, Real size) {
  return {random.vector(-size, size), random.unit_vector(), even(random.uniform(0, 1) * size),
          ray_radius(random, size)};
}

}  // namespace nearfield::property
