#pragma once

#include <nearfield/shape/certificate.hpp>
#include <nearfield/shape/cubic_chords.hpp>
#include <nearfield/shape/payload.hpp>
#include <nearfield/shape/sample.hpp>
#include <nearfield/shape/skeleton_offset.hpp>

namespace nearfield {

inline constexpr uint32_t kGreatestCurveSegmentCount = 4;
inline constexpr int kCurveNewtonSteps = 2;

namespace detail {

// (a + b_share b + c_share c) / 6, rounded half up.
template <int F>
constexpr Fixed<F> sixth_of(Fixed<F> a, int b_share, Fixed<F> b, Fixed<F> c, int c_share) {
  const int64_t sum = int64_t{a.raw()} + int64_t{b_share} * b.raw() + int64_t{c_share} * c.raw() + 3;
  return Fixed<F>::from_raw(static_cast<int32_t>(sum / 6 - (sum % 6 < 0 ? 1 : 0)));
}
constexpr float sixth_of(float a, int b_share, float b, float c, int c_share) {
  return ((a + static_cast<float>(b_share) * b) + static_cast<float>(c_share) * c) / 6.0f;
}
template <class S>
constexpr Vector3<S> sixth_of(const Vector3<S>& a, int b_share, const Vector3<S>& b, const Vector3<S>& c,
                              int c_share = 1) {
  return {sixth_of(a.x, b_share, b.x, c.x, c_share), sixth_of(a.y, b_share, b.y, c.y, c_share),
          sixth_of(a.z, b_share, b.z, c.z, c_share)};
}

}  // namespace detail

// All points within `radius` of a chain of 1 to 4 cubic Bezier segments: 4, 7, 10 or 13 control points, the
// last of a segment being the first of the next. Metres: control points within the domain, coordinates of
// neighbours at most half the domain apart; radius in [0, domain]. The distance from a point of the curve,
// less the radius: never below the true one but for rounding, and above it by no more than |C''| / 512, C''
// being largest at an end of a segment; four times less when segments are halved. Searched from the nearest
// of 8 chords to a segment (cubic_chords.hpp) by 2 Newton steps, across joints, of which the nearest place
// counts: exact wherever no other place of the curve is as near within that bound. The direction is that from
// this place; none on the curve.
template <class S>
struct CubicCurve {
  using Scalar = S;
  static constexpr Kind kind = Kind::distance;
  static constexpr uint32_t greatest_control_count = 3 * kGreatestCurveSegmentCount + 1;
  using Chords = detail::ChordWalk<S>;
  uint32_t segment_count = 0;
  uint32_t shift = 0;
  S radius{};
  Vector3<S> control[greatest_control_count] = {};  // beyond the last 0, as the inverses
  typename Chords::Inverse inverse[kGreatestCurveSegmentCount][detail::kChordCount] = {};

  constexpr CubicCurve() = default;
  // Of Bezier control points. Invalid for any other number of them than 4, 7, 10 or 13.
  constexpr CubicCurve(const Vector3<S>* points, int count, S rounding_radius) : radius(rounding_radius) {
    if (count < 4 || count > static_cast<int>(greatest_control_count) || count % 3 != 1) return;
    segment_count = static_cast<uint32_t>(count / 3);
    for (int i = 0; i < count; ++i) control[i] = points[i];
    bake();
  }

  // The uniform cubic B-spline of 4 to 7 control points, which is that many less 3 segments; invalid for any
  // other number. Its Bezier control points are rounded to the nearest number. For payloads: it divides.
  static constexpr CubicCurve b_spline(const Vector3<S>* points, int count, S rounding_radius) {
    if (count < 4 || count > static_cast<int>(kGreatestCurveSegmentCount) + 3) return {};
    Vector3<S> bezier[greatest_control_count] = {};
    for (int i = 0; i + 2 < count; ++i) {
      bezier[3 * i] = detail::sixth_of(points[i], 4, points[i + 1], points[i + 2]);
      if (i + 3 == count) break;
      bezier[3 * i + 1] = detail::sixth_of({}, 4, points[i + 1], points[i + 2], 2);
      bezier[3 * i + 2] = detail::sixth_of({}, 2, points[i + 1], points[i + 2], 4);
    }
    return CubicCurve(bezier, 3 * count - 8, rounding_radius);
  }

  // 0 for a number of segments out of range.
  constexpr int item_count() const {
    return segment_count <= kGreatestCurveSegmentCount ? static_cast<int>(segment_count) : 0;
  }

  // What evaluation reads, where it is.
  struct InImage {
    const uint32_t* payload;
    uint32_t segment_count() const { return payload[offsetof(CubicCurve, segment_count) / 4]; }
    int shift() const { return static_cast<int>(payload[offsetof(CubicCurve, shift) / 4]); }
    S radius() const { return detail::words_as<S>(payload + offsetof(CubicCurve, radius) / 4); }
    Vector3<S> control(uint32_t i) const {
      return detail::vector_as<S>(payload + offsetof(CubicCurve, control) / 4 + 3 * i);
    }
    typename Chords::Inverse inverse(uint32_t i, uint32_t chord) const {
      return detail::words_as<typename Chords::Inverse>(payload + offsetof(CubicCurve, inverse) / 4 +
                                                        detail::kChordCount * i + chord);
    }
  };
  struct InMemory {
    const CubicCurve& curve;
    constexpr uint32_t segment_count() const { return curve.segment_count; }
    constexpr int shift() const { return static_cast<int>(curve.shift); }
    constexpr S radius() const { return curve.radius; }
    constexpr const Vector3<S>& control(uint32_t i) const { return curve.control[i]; }
    constexpr typename Chords::Inverse inverse(uint32_t i, uint32_t chord) const {
      return curve.inverse[i][chord];
    }
  };

  template <class Out, class Source>
  static constexpr Out evaluate_from(const Source& source, const Vector3<S>& p) {
    uint32_t nearest_segment = 0;
    int nearest_chord = 0;
    auto nearest_place = decltype(Chords::kOne){};
    auto least = Chords::kGreatestSquare;
    const uint32_t count = source.segment_count();
    const int shift = source.shift();
    for (uint32_t i = 0; i < count; ++i) {
      Chords chords(segment_of(source, i), p, shift);
      for (int chord = 0; chord < detail::kChordCount; ++chord) {
        const auto place = chords.place(source.inverse(i, static_cast<uint32_t>(chord)));
        const Vector3<S> offset = chords.offset(place);
        const auto squares = sum_of_squares(offset.x, offset.y, offset.z);
        if (squares < least) {
          least = squares;
          nearest_segment = i;
          nearest_chord = chord;
          nearest_place = place;
        }
        chords.advance();
      }
    }
    return from_offset<Out>(
        offset_near(source, p, nearest_segment, detail::curve_parameter(nearest_chord, nearest_place)),
        source.radius());
  }
  template <class Out>
  constexpr Out evaluate(const Vector3<S>& p) const {
    return evaluate_from<Out>(InMemory{*this}, p);
  }

  // Rounding units: control points sqrt(3)/2, of a spline as much again, place on the curve 2.6, the choice
  // among such places 4, radius 1/2, root 1, and what chords are off, both of the one that was found and of
  // the one that should have been.
  constexpr Certificate<S> certificate(Reach<S> reach) const {
    using T = ScalarTraits<S>;
    if (segment_count == 0 || item_count() == 0) return {};
    if (!(within(radius, S{}, T::domain()) && control_points_fit() && follows_from_control_points()))
      return {};
    const uint32_t count = 3 * segment_count + 1;
    S extent{}, bend{}, place_error{};
    for (uint32_t i = 0; i < count; ++i) extent = greatest_of_two(extent, length(control[i]));
    for (uint32_t i = 0; i < segment_count; ++i) {
      const Vector3<S>* c = control + 3 * i;
      bend = greatest_of_two(bend,
                             greatest_of_two(length(second_difference(c)), length(second_difference(c + 1))));
      Chords chords(segment(i), {}, static_cast<int>(shift));
      for (int chord = 0; chord < detail::kChordCount; ++chord) {
        place_error = greatest_of_two(place_error, chords.place_error());
        chords.advance();
      }
    }
    // |C''| / 512 = 6 |second difference| / 512.
    S deviation = bend;
    for (int i = 0; i < 8; ++i) deviation = T::half(deviation);
    deviation = T::times(deviation, 3) + T::times(T::rounding_unit(bend), 4);
    const int units = 10 + 2 * Chords::rounding_units(static_cast<int>(shift));
    Certificate<S> all = exact_distance<S>(
        reach, extent + deviation + radius + T::times(T::rounding_unit(extent), 128), true, units);
    all.error = all.error + deviation + place_error;
    return all;
  }

 private:
  // From a place of a segment onwards, to the segments beside it where its ends are reached.
  template <class Source>
  static constexpr Vector3<S> offset_near(const Source& source, const Vector3<S>& p, uint32_t at_segment,
                                          Unit<S> t) {
    const Unit<S> start{}, end = ScalarTraits<S>::unit_one();
    const uint32_t count = source.segment_count();
    detail::NearestTried<S> nearest(p);
    for (int i = 0; i < kCurveNewtonSteps; ++i) {
      const detail::CurvePlace<S> at(segment_of(source, at_segment), p, t);
      nearest.add(at.offset);
      t = add_in_range(t, detail::step_to_nearest(at));
      if (t < start) {
        t = at_segment > 0 ? end : start;
        at_segment -= at_segment > 0 ? 1 : 0;
      } else if (end < t) {
        t = at_segment + 1 < count ? start : end;
        at_segment += at_segment + 1 < count ? 1 : 0;
      }
    }
    nearest.add(detail::CurvePlace<S>(segment_of(source, at_segment), p, t).offset);
    return detail::settled(nearest.offset());
  }
  template <class Source>
  static constexpr detail::CubicPolynomial<S> segment_of(const Source& source, uint32_t i) {
    const Vector3<S> four[] = {source.control(3 * i), source.control(3 * i + 1), source.control(3 * i + 2),
                               source.control(3 * i + 3)};
    return detail::CubicPolynomial<S>(four);
  }
  static constexpr S length(const Vector3<S>& v) { return length_of<S>(sum_of_squares(v.x, v.y, v.z)); }
  static constexpr Vector3<S> second_difference(const Vector3<S>* c) {
    return subtract_in_range(subtract_in_range(c[2], c[1]), subtract_in_range(c[1], c[0]));
  }
  constexpr detail::CubicPolynomial<S> segment(uint32_t i) const {
    return detail::CubicPolynomial<S>(control + 3 * i);
  }

  constexpr void bake() {
    S edge{};
    for (uint32_t i = 0; i < 3 * segment_count; ++i)
      edge = greatest_of_two(edge, greatest_difference(control[i], control[i + 1]));
    shift = static_cast<uint32_t>(detail::curve_shift(edge));
    for (uint32_t i = 0; i < segment_count; ++i) {
      Chords chords(segment(i), {}, static_cast<int>(shift));
      for (int chord = 0; chord < detail::kChordCount; ++chord) {
        inverse[i][chord] = chords.inverse();
        chords.advance();
      }
    }
  }
  static constexpr S greatest_difference(const Vector3<S>& a, const Vector3<S>& b) {
    return greatest_of_two(absolute(b.x - a.x), greatest_of_two(absolute(b.y - a.y), absolute(b.z - a.z)));
  }
  constexpr bool control_points_fit() const {
    const S limit = ScalarTraits<S>::domain();
    for (uint32_t i = 0; i <= 3 * segment_count; ++i) {
      if (!coordinates_in_domain(control[i])) return false;
      if (i > 0 && greatest_difference(control[i - 1], control[i]) > ScalarTraits<S>::half(limit))
        return false;
    }
    for (uint32_t i = 3 * segment_count + 1; i < greatest_control_count; ++i) {
      if (!is_zero(control[i])) return false;
    }
    return true;
  }
  constexpr bool follows_from_control_points() const {
    const CubicCurve again(control, static_cast<int>(3 * segment_count + 1), radius);
    bool same = shift == again.shift;
    for (uint32_t i = 0; i < kGreatestCurveSegmentCount; ++i) {
      for (int chord = 0; chord < detail::kChordCount; ++chord)
        same = same && inverse[i][chord] == again.inverse[i][chord];
    }
    return same;
  }
};

}  // namespace nearfield
