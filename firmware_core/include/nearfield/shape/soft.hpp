// Soft objects: skeletons that spread an intensity (KW; Hsu).
#pragma once

#include <nearfield/shape/capsule.hpp>
#include <nearfield/table/table.hpp>

namespace nearfield {

// weight * P(r^2 / R^2) of the offset to the nearest point of a skeleton; P tabulated over the squared distance, so
// that no square root is needed. Exactly 0 at and beyond the influence radius R.
template <class S> struct Influence {
  S radius{};          // R, metres
  S weight{};          // may be negative
  S gradient_factor{}; // 2 R0 / R, R0 = 1/16 m (sample.hpp)
  S inverse_radius{};  // 1 / R, 1/m
  SquareScale<S> scale;

  constexpr Influence() = default;
  constexpr Influence(S influence_radius, S influence_weight)
      : radius(influence_radius), weight(influence_weight), scale(SquareScale<S>::of(influence_radius)) {
    inverse_radius = inverse_of(influence_radius);
    gradient_factor = ScalarTraits<S>::half(ScalarTraits<S>::half(ScalarTraits<S>::half(inverse_radius)));
  }

  template <class Out> constexpr Out evaluate(const Vector3<S>& offset, const TableView<S>& potential) const {
    Out out;
    const auto squares = sum_of_squares(offset.x, offset.y, offset.z);
    if (!scale.contains(squares)) return out;
    const TableSample<S> p = sample_table<Out::has_gradient>(potential, scale.argument(squares));
    out.value = narrow<S>(product(weight, p.value));
    if constexpr (Out::has_gradient) {
      const S steepness = narrow<S>(product(narrow<S>(product(p.slope, gradient_factor)), weight));
      out.gradient = scaled(scaled_in_range(offset, inverse_radius), steepness);
    }
    return out;
  }

  constexpr bool valid() const {
    const Influence again(radius, weight);
    const S limit = ScalarTraits<S>::domain();
    return valid_length(radius) && within(weight, -limit, limit) && scale.consistent(radius) &&
           inverse_radius == again.inverse_radius && gradient_factor == again.gradient_factor &&
           inverse_radius < ScalarTraits<S>::greatest();
  }

 private:
  static constexpr S inverse_of(S x) {
    if constexpr (ScalarTraits<S>::is_fixed) {
      ArithmeticStatus ignored;
      return divide(ScalarTraits<S>::one(), x, ignored);
    } else {
      return x > 0.0f ? 1.0f / x : 0.0f;
    }
  }
};

// An intensity carries no clearance of its own: its certificate says only whether evaluation stays in range.
template <class S> constexpr Certificate<S> intensity_certificate(Reach<S> reach, S extent, bool parameters_valid) {
  return exact_distance<S>(reach, extent, parameters_valid, 0);
}

// Spreads from a point.
template <class S> struct SoftPoint {
  using Scalar = S;
  static constexpr Kind kind = Kind::intensity;
  static constexpr bool samples_table = true;
  Vector3<S> center;
  Influence<S> influence;

  template <class Out> constexpr Out evaluate(const Vector3<S>& p, const TableView<S>& potential) const {
    return influence.template evaluate<Out>(subtract_in_range(p, center), potential);
  }
  constexpr Certificate<S> certificate(Reach<S> reach) const {
    const S extent = length_of<S>(sum_of_squares(center.x, center.y, center.z));
    return intensity_certificate<S>(reach, extent, coordinates_in_domain(center) && influence.valid());
  }
};

// Spreads from a segment.
template <class S> struct SoftSegment {
  using Scalar = S;
  static constexpr Kind kind = Kind::intensity;
  static constexpr bool samples_table = true;
  Capsule<S> segment;  // of radius 0
  Influence<S> influence;

  template <class Out> constexpr Out evaluate(const Vector3<S>& p, const TableView<S>& potential) const {
    return influence.template evaluate<Out>(segment.offset_to(p), potential);
  }
  constexpr Certificate<S> certificate(Reach<S> reach) const {
    const bool valid = segment.valid() && segment.radius == S{} && influence.valid();
    return intensity_certificate<S>(reach, segment.extent(), valid);
  }
};

}  // namespace nearfield
