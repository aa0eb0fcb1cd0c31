#pragma once

#include <nearfield/number/direction.hpp>
#include <nearfield/shape/certificate.hpp>
#include <nearfield/shape/payload.hpp>
#include <nearfield/shape/sample.hpp>
#include <nearfield/shape/skeleton_offset.hpp>

namespace nearfield {

inline constexpr uint32_t kGreatestSegmentCount = 7;

// All points within `radius` of a chain of segments through 2 to 8 points. Metres: points within the domain,
// two or more of which may be the same; radius in [0, domain]. Each segment as in a Capsule, its axis a baked
// direction. Exact distance less the radius; where several segments are equally near, the first has the
// direction. No direction on the chain. Segments beyond the last one are 0.
template <class S>
struct Polyline {
  using Scalar = S;
  static constexpr Kind kind = Kind::distance;
  struct Segment {
    Vector3<S> from;
    Vector3<Unit<S>> axis;
    S length{};
  };
  uint32_t segment_count = 0;
  S radius{};
  Segment segment[kGreatestSegmentCount] = {};

  constexpr Polyline() = default;
  // Through points[0] ... points[count - 1]. Invalid for any other number of points than 2 to 8.
  constexpr Polyline(const Vector3<S>* points, int count, S rounding_radius) : radius(rounding_radius) {
    if (count < 2 || count > static_cast<int>(kGreatestSegmentCount) + 1) return;
    segment_count = static_cast<uint32_t>(count) - 1;
    for (int i = 0; i + 1 < count; ++i) segment[i] = between(points[i], points[i + 1]);
  }

  // 0 for a number of segments out of range.
  constexpr int item_count() const {
    return segment_count <= kGreatestSegmentCount ? static_cast<int>(segment_count) : 0;
  }

  // What evaluation reads, where it is.
  struct InImage {
    const uint32_t* payload;
    uint32_t segment_count() const { return payload[offsetof(Polyline, segment_count) / 4]; }
    S radius() const { return detail::words_as<S>(payload + offsetof(Polyline, radius) / 4); }
    Segment segment(uint32_t i) const {
      const uint32_t* words = payload + offsetof(Polyline, segment) / 4 + i * (sizeof(Segment) / 4);
      return {detail::vector_as<S>(words), detail::vector_as<Unit<S>>(words + 3),
              detail::words_as<S>(words + 6)};
    }
  };
  struct InMemory {
    const Polyline& polyline;
    constexpr uint32_t segment_count() const { return polyline.segment_count; }
    constexpr S radius() const { return polyline.radius; }
    constexpr const Segment& segment(uint32_t i) const { return polyline.segment[i]; }
  };

  template <class Out, class Source>
  static constexpr Out evaluate_from(const Source& source, const Vector3<S>& p) {
    Vector3<S> nearest = offset_from(source.segment(0), p);
    auto least = sum_of_squares(nearest.x, nearest.y, nearest.z);
    const uint32_t count = source.segment_count();
    for (uint32_t i = 1; i < count; ++i) {
      const Vector3<S> offset = offset_from(source.segment(i), p);
      const auto squares = sum_of_squares(offset.x, offset.y, offset.z);
      if (squares < least) {
        least = squares;
        nearest = offset;
      }
    }
    return from_offset<Out>(detail::settled(nearest), source.radius());
  }
  template <class Out>
  constexpr Out evaluate(const Vector3<S>& p) const {
    return evaluate_from<Out>(InMemory{*this}, p);
  }

  // Rounding units, at 14 m along a segment: points sqrt(3)/2, axis (1.4 units of 2^-30, in the place and in
  // the point) 5, place 1/2, its product sqrt(3)/2, length 1, radius 1/2, root 1.
  constexpr Certificate<S> certificate(Reach<S> reach) const {
    if (segment_count == 0 || item_count() == 0) return {};
    using T = ScalarTraits<S>;
    const Segment& last = segment[segment_count - 1];
    bool valid = within(radius, S{}, T::domain()) && valid_last(last);
    S extent{};
    for (uint32_t i = 0; i < segment_count; ++i) {
      valid = valid && coordinates_in_domain(segment[i].from);
      extent = greatest_of_two(extent, distance_of(segment[i].from));
      if (i + 1 < segment_count)
        valid = valid && same(segment[i], between(segment[i].from, segment[i + 1].from));
    }
    for (uint32_t i = segment_count; i < kGreatestSegmentCount; ++i)
      valid = valid && same(segment[i], Segment{});
    if (!valid) return {};
    extent = greatest_of_two(extent, distance_of(last.from + point_along(last, last.length)));
    // Points at 4 units from where they belong.
    extent = extent + T::times(T::rounding_unit(extent), 4);
    return exact_distance<S>(reach, extent + radius, true, 11);
  }

 private:
  static constexpr Segment between(const Vector3<S>& a, const Vector3<S>& b) {
    const Vector3<S> along = subtract_in_range(b, a);
    return {a, baked_direction(along), distance_of(along)};
  }
  static constexpr S distance_of(const Vector3<S>& v) { return length_of<S>(sum_of_squares(v.x, v.y, v.z)); }
  static constexpr bool same(const Segment& a, const Segment& b) {
    return a.from == b.from && a.axis == b.axis && a.length == b.length;
  }
  static constexpr bool valid_last(const Segment& last) {
    using T = ScalarTraits<S>;
    if (!within(last.length, S{}, T::times(T::half(T::domain()), 7))) return false;
    return last.length == S{} ? is_zero(last.axis) : is_baked_direction(last.axis);
  }

  static constexpr Vector3<S> point_along(const Segment& of, S place) {
    return {narrow_in_range<S>(product(place, of.axis.x)), narrow_in_range<S>(product(place, of.axis.y)),
            narrow_in_range<S>(product(place, of.axis.z))};
  }
  // From the nearest point of the segment to p.
  [[gnu::always_inline]] static constexpr Vector3<S> offset_from(const Segment& of, const Vector3<S>& p) {
    const Vector3<S> relative = subtract_in_range(p, of.from);
    const S place = detail::place_on_segment(narrow_in_range<S>(dot(relative, of.axis)), of.length);
    return subtract_in_range(relative, point_along(of, place));
  }
};

}  // namespace nearfield
