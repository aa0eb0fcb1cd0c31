#pragma once

#include <nearfield/shape/certificate.hpp>
#include <nearfield/shape/sample.hpp>

namespace nearfield {

// All points within `radius` of the segment from `from`, `length` (at most twice the domain) along `axis`. Metres;
// the axis is a unit vector
// (zero if the length is zero: then the capsule is a ball). Radius 0 is allowed: a bare segment.
// Exact signed distance; budget: operations.hpp.
template <class S> struct Capsule {
  using Scalar = S;
  static constexpr Kind kind = Kind::distance;
  static constexpr int kAxisSlack = 8;         // of a shape's axis, rounded once
  static constexpr int kMovedAxisSlack = 128;  // of an axis turned by a valid_pose()
  Vector3<S> from;
  Vector3<Unit<S>> axis;
  S length{};
  S radius{};

  constexpr Capsule() = default;
  constexpr Capsule(const Vector3<S>& a, const Vector3<Unit<S>>& unit_axis, S axis_length, S capsule_radius)
      : from(a), axis(unit_axis), length(axis_length), radius(capsule_radius) {}
  // From both ends of the segment. Precondition: |b - a| in range.
  constexpr Capsule(const Vector3<S>& a, const Vector3<S>& b, S capsule_radius) : from(a), radius(capsule_radius) {
    const Polar<S, Unit<S>> along = polar<Unit<S>>(subtract_in_range(b, a));
    axis = along.direction;
    length = along.length;
  }


  template <class Out> constexpr Out evaluate(const Vector3<S>& p) const {
    return from_offset<Out>(offset_to(p), radius);
  }

  // From the nearest point of the segment to p.
  constexpr Vector3<S> offset_to(const Vector3<S>& p) const {
    const Vector3<S> relative = subtract_in_range(p, from);
    return subtract_in_range(relative, along(on_segment(narrow_in_range<S>(dot(relative, axis)), length)));
  }

  // Rounding units: start sqrt(3)/2, axis (6 units of 2^-30 a component, at 8 m) 6, place 1/2, its product sqrt(3)/2,
  // length 1, radius 1/2, root 1.
  constexpr Certificate<S> certificate(Reach<S> reach) const {
    return exact_distance<S>(reach, extent(), valid(), 11);
  }
  // No point of the capsule is farther than this from the local origin.
  constexpr S extent() const { return length_of<S>(sum_of_squares(from.x, from.y, from.z)) + length + radius; }

  // `axis_slack`: how far the axis may be from unit length, in units of 2^-30 (float: 2^-24).
  constexpr bool valid(int axis_slack = kAxisSlack) const {
    const S limit = ScalarTraits<S>::domain();
    return coordinates_in_domain(from) && within(length, S{}, limit + limit) && within(radius, S{}, limit) &&
           valid_axis(axis_slack);
  }

  // place * axis: from the segment's start to the point `place` metres along it.
  constexpr Vector3<S> along(S place) const {
    return {narrow_in_range<S>(product(place, axis.x)), narrow_in_range<S>(product(place, axis.y)),
            narrow_in_range<S>(product(place, axis.z))};
  }

 private:
  // The place limited to the segment. Without branches: where one is taken, compilers would evaluate what follows twice.
  template <int F> static constexpr Fixed<F> on_segment(Fixed<F> place, Fixed<F> length) {
    const int32_t not_before = place.raw() & ~(place.raw() >> 31);
    const int32_t beyond = wrapping_subtract(not_before, length.raw());
    return Fixed<F>::from_raw(wrapping_add(length.raw(), beyond & (beyond >> 31)));
  }
  static constexpr float on_segment(float place, float length) { return clamp(place, 0.0f, length); }

  // Zero together with the length, otherwise of unit length within the slack.
  constexpr bool valid_axis(int axis_slack) const {
    using T = ScalarTraits<Unit<S>>;
    if (length == S{}) return is_zero(axis);
    const Unit<S> one = ScalarTraits<S>::unit_one();
    Unit<S> slack = T::times(T::rounding_unit(one), axis_slack);
    if constexpr (!ScalarTraits<S>::is_fixed) slack = slack * 0.125f;
    const Unit<S> limit = one + slack;
    if (!(within(axis.x, -limit, limit) && within(axis.y, -limit, limit) && within(axis.z, -limit, limit))) return false;
    return within(length_of<Unit<S>>(sum_of_squares(axis.x, axis.y, axis.z)), one - slack, limit);
  }
};

}  // namespace nearfield
