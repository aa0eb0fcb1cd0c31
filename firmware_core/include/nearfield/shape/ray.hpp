// Skeletons of ray functions (Hsu): distance / influence radius; 1 on the influence boundary, 0.5 on the soft
// surface.
#pragma once

#include <nearfield/number/ratio.hpp>
#include <nearfield/shape/capsule.hpp>

namespace nearfield {

// Ray functions are cut off here, far outside every influence, and constant beyond: their errors are bounded
// by it.
inline constexpr int kGreatestRay = 15;
template <class S> constexpr S greatest_ray() {
  return ScalarTraits<S>::times(ScalarTraits<S>::one(), kGreatestRay);
}

// Divides distances by an influence radius R, metres, 1/64 m to the domain.
template <class S> struct RayRadius {
  S radius{};
  S gradient_factor{};    // R0 / R, R0 = 1/16 m (sample.hpp)
  Reciprocal<S> inverse;  // 1 / R

  constexpr RayRadius() = default;
  constexpr explicit RayRadius(S influence_radius)
      : radius(influence_radius), inverse(reciprocal_of(influence_radius)) {
    gradient_factor = quotient<S>(sixteenth(ScalarTraits<S>::one()), inverse);
  }

  // distance / R and its gradient, `direction` that of the distance. Beyond the greatest ray value constant.
  template <class Out> constexpr Out ray(S distance, const Vector3<Unit<S>>& direction) const {
    Out out;
    out.value = least_of_two(quotient<S>(distance, inverse), greatest_ray<S>());
    if constexpr (Out::has_gradient) {
      if (out.value < greatest_ray<S>()) {
        out.gradient = {narrow_in_range<S>(product(direction.x, gradient_factor)),
                        narrow_in_range<S>(product(direction.y, gradient_factor)),
                        narrow_in_range<S>(product(direction.z, gradient_factor))};
      }
    }
    return out;
  }
  template <class Out> constexpr Out ray_of(const Vector3<S>& offset) const {
    if constexpr (Out::has_gradient) {
      const Polar<S, Unit<S>> away = polar<Unit<S>>(offset);
      return ray<Out>(away.length, away.direction);
    } else {
      return ray<Out>(length_of<S>(sum_of_squares(offset.x, offset.y, offset.z)), {});
    }
  }

  constexpr bool valid() const {
    const S least = sixteenth(sixteenth(ScalarTraits<S>::times(ScalarTraits<S>::one(), 4)));
    if (!(radius >= least && valid_length(radius))) return false;
    const RayRadius again(radius);
    return gradient_factor == again.gradient_factor && inverse == again.inverse;
  }
  // 1 / R of the R that was rounded, rounded up; the greatest rate, which no certificate may have, if R is too small.
  constexpr Rate rate() const {
    if (!valid()) return Rate::greatest();
    if constexpr (ScalarTraits<S>::is_fixed) {
      const S least = radius - ScalarTraits<S>::rounding_unit(radius);
      return quotient<Rate>(ScalarTraits<S>::one(), reciprocal_of(least)) + Rate::from_raw(32);
    } else {
      return Rate::from_raw(static_cast<int32_t>(inverse.inverse * 16777216.0f) + 256);
    }
  }
  // Of a distance that is off by at most `units` rounding units besides. R's own rounding moves the result by
  // as much as kGreatestRay / 2 units of distance do; dividing rounds by less than two units.
  constexpr Certificate<S> certificate(Reach<S> reach, S extent, bool parameters_valid, int units) const {
    using T = ScalarTraits<S>;
    const int all = T::is_fixed ? units + (kGreatestRay + 1) / 2 : units;
    Certificate<S> ray = exact_distance<S>(reach, extent, parameters_valid && valid(), all);
    ray.lipschitz = Rate::from_raw((rate().raw() >> -kGradientLengthLog2) + 1);
    ray.error = T::multiply_up(ray.error, rate()) + T::times(T::rounding_unit(greatest_ray<S>()), 2);
    return ray;
  }

 private:
  static constexpr S sixteenth(S x) {
    using T = ScalarTraits<S>;
    return T::half(T::half(T::half(T::half(x))));
  }
};

// |p - center| / R.
template <class S> struct RayPoint {
  using Scalar = S;
  static constexpr Kind kind = Kind::ray;
  Vector3<S> center;
  RayRadius<S> influence;

  template <class Out> constexpr Out evaluate(const Vector3<S>& p) const {
    return influence.template ray_of<Out>(subtract_in_range(p, center));
  }
  // Rounding units: centre sqrt(3)/2, root 1.
  constexpr Certificate<S> certificate(Reach<S> reach) const {
    const S extent = length_of<S>(sum_of_squares(center.x, center.y, center.z));
    return influence.certificate(reach, extent, coordinates_in_domain(center), 3);
  }
};

// The distance from a segment / R.
template <class S> struct RaySegment {
  using Scalar = S;
  static constexpr Kind kind = Kind::ray;
  Capsule<S> segment;  // of radius 0
  RayRadius<S> influence;

  template <class Out> constexpr Out evaluate(const Vector3<S>& p) const {
    return influence.template ray_of<Out>(segment.offset_to(p));
  }
  constexpr Certificate<S> certificate(Reach<S> reach) const {
    return influence.certificate(reach, segment.extent(), segment.valid() && segment.radius == S{}, 11);
  }
};

// max(0, (p - point) . normal) / R, the half-space below the plane being inside everything.
template <class S> struct RayPlane {
  using Scalar = S;
  static constexpr Kind kind = Kind::ray;
  Vector3<S> point;
  Vector3<Unit<S>> normal;  // a unit vector
  RayRadius<S> influence;

  template <class Out> constexpr Out evaluate(const Vector3<S>& p) const {
    const S height = narrow_in_range<S>(dot(subtract_in_range(p, point), normal));
    if (!(height > S{})) return {};
    return influence.template ray<Out>(height, normal);
  }
  // Rounding units: point sqrt(3)/2, normal (half a unit of 2^-30 a component, at 16 m) 2, product 1/2.
  constexpr Certificate<S> certificate(Reach<S> reach) const {
    const S extent = length_of<S>(sum_of_squares(point.x, point.y, point.z));
    const Capsule<S> along_normal(point, normal, ScalarTraits<S>::one(), S{});
    return influence.certificate(reach, extent, along_normal.valid(), 4);
  }
};

}  // namespace nearfield
