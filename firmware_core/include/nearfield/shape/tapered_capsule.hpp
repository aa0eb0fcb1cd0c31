#pragma once

#include <nearfield/number/direction.hpp>
#include <nearfield/shape/capsule.hpp>
#include <nearfield/shape/elevation.hpp>

namespace nearfield {

// Convex hull of two balls, one at the start of a segment and one at its end. Metres: as a capsule, the end's
// radius in [0, domain], the axis a baked direction. One ball inside the other: the larger alone. Exact
// signed distance outside and inside; no direction in the balls' centres; on the axis between them it is that
// of the axis in which the radius falls, none if it does not.
template <class S> struct TaperedCapsule {
  using Scalar = S;
  static constexpr Kind kind = Kind::distance;
  Capsule<S> start;  // its radius: at the start
  S end_radius{};
  // Of the side's normal, along the axis and away from it: (radius - end radius) / length, +-1 and 0 for a
  // ball alone.
  Unit<S> sine{}, cosine{};

  constexpr TaperedCapsule() = default;
  constexpr TaperedCapsule(const Capsule<S>& from_start, S radius_at_end)
      : start(from_start), end_radius(radius_at_end) {
    bake_normal();
  }
  // From both ends of the segment. Precondition: |b - a| in range.
  constexpr TaperedCapsule(const Vector3<S>& a, const Vector3<S>& b, S radius_at_a, S radius_at_b)
      : end_radius(radius_at_b) {
    const Vector3<S> along = subtract_in_range(b, a);
    start = Capsule<S>(a, baked_direction(along), length_of<S>(sum_of_squares(along.x, along.y, along.z)),
                       radius_at_a);
    bake_normal();
  }

  template <class Out> constexpr Out evaluate(const Vector3<S>& p) const {
    const Vector3<S> relative = subtract_in_range(p, start.from);
    const auto from_end = [&] { return subtract_in_range(relative, start.along(start.length)); };
    if (cosine == Unit<S>{}) {
      return sine > Unit<S>{} ? from_offset<Out>(relative, start.radius)
                              : from_offset<Out>(from_end(), end_radius);
    }
    const S height = narrow_in_range<S>(dot(relative, start.axis)),
            beyond = subtract_in_range(height, start.length);
    const Vector3<S> across = subtract_in_range(relative, start.along(height));
    const auto squares = sum_of_squares(across.x, across.y, across.z);
    const auto to_start = squares + sum_of_squares(height, S{}),
               to_end = squares + sum_of_squares(beyond, S{});
    if (is_lower(height, to_start, sine)) {
      return at_ball<Out>(to_start, start.radius, sine < Unit<S>{}, [&] { return relative; });
    }
    if (!is_lower(beyond, to_end, sine)) return at_ball<Out>(to_end, end_radius, sine > Unit<S>{}, from_end);
    return at_side<Out>(height, across);
  }

  // Rounding units, at 16 m: start sqrt(3)/2, radii and length 1, sine 1/2 (as if a radius were off by as
  // much), cosine 2, axis 1 for what it turns and 6 for the height and the place on it, root 1, product 1/2.
  constexpr Certificate<S> certificate(Reach<S> reach) const {
    using T = ScalarTraits<S>;
    const Capsule<S> around(start.from, start.axis, start.length, greatest_of_two(start.radius, end_radius));
    // And what heights and places on the axis are off.
    const S extent = around.extent() + T::times(T::rounding_unit(around.extent()), 8);
    return exact_distance<S>(reach, extent, valid(), 13);
  }

 private:
  // `squares`: of the distance from the ball's centre, `offset()` the vector. `smaller`: of the two balls.
  // Where its part of the surface, seen from the centre, is narrower than what rounds, the offset would point
  // anywhere: there the direction is that of the axis.
  template <class Out, class Squares, class Offset>
  constexpr Out at_ball(Squares squares, S radius, bool smaller, const Offset& offset) const {
    using T = ScalarTraits<S>;
    const S distance = length_of<S>(squares);
    Out out;
    out.value = subtract_in_range(distance, radius);
    if constexpr (Out::has_gradient) {
      out.gradient = direction_of<S>(offset());
      if (smaller &&
          narrow_in_range<S>(product(distance, cosine)) < T::times(T::rounding_unit(T::one()), 4)) {
        const Vector3<Unit<S>>& u = start.axis;
        out.gradient = {T::from_unit(u.x), T::from_unit(u.y), T::from_unit(u.z)};
        if (sine < Unit<S>{}) out.gradient = subtract_in_range(Vector3<S>{}, out.gradient);
      }
    }
    return out;
  }
  template <class Out> constexpr Out at_side(S height, const Vector3<S>& across) const {
    const auto value_at = [&](S away) {
      return subtract_in_range(narrow_in_range<S>(product(away, cosine) + product(height, sine)),
                               start.radius);
    };
    if constexpr (Out::has_gradient) {
      const Polar<S, Unit<S>> away = polar<Unit<S>>(across);
      const auto component = [this](Unit<S> outwards, Unit<S> along) {
        return narrow_in_range<Unit<S>>(product(outwards, cosine) + product(along, sine));
      };
      // Of unit length but close to the axis, where `across` is no longer at right angles to it.
      return {value_at(away.length),
              direction_of<S>(Vector3<Unit<S>>{component(away.direction.x, start.axis.x),
                                               component(away.direction.y, start.axis.y),
                                               component(away.direction.z, start.axis.z)})};
    } else {
      return {value_at(length_of<S>(sum_of_squares(across.x, across.y, across.z)))};
    }
  }

  constexpr void bake_normal() {
    const S taper = start.radius - end_radius;
    const Unit<S> one = ScalarTraits<S>::unit_one();
    if (absolute(taper) >= start.length) {
      sine = taper < S{} ? -one : one;
      cosine = Unit<S>{};
    } else if constexpr (ScalarTraits<S>::is_fixed) {
      sine = Unit<S>::from_raw(
          detail::rounded_share(taper.raw(), 30, static_cast<uint32_t>(start.length.raw())));
      cosine = other_leg(one, absolute(sine));
    } else {
      sine = taper / start.length;
      cosine = square_root((one - sine) * (one + sine));
    }
  }
  constexpr bool valid() const {
    const TaperedCapsule again(start, end_radius);
    return start.valid() && within(end_radius, S{}, ScalarTraits<S>::domain()) && sine == again.sine &&
           cosine == again.cosine && (start.length == S{} || is_baked_direction(start.axis));
  }
};

}  // namespace nearfield
