#pragma once

#include <nearfield/modify/ray_scale.hpp>

namespace nearfield {

// min(r, cut) g(t), t the place on an axis from 0 at `from` to 1 `length` metres along it, outside of which g stays as it is
// there: with g = 1 / f1 baked as a table, the influence radius at t is R f1(t) (KW). About a segment: surfaces of revolution.
// The axis is a unit vector, the length as RayScaleRange has it.
template <class S> struct ScaleAlong {
  using Scalar = S;
  static constexpr Kind kind = Kind::ray;
  static constexpr int fixed_operand_count = 1;
  static constexpr bool takes_point = true;
  static constexpr bool samples_table = true;
  Vector3<S> from;
  Vector3<Unit<S>> axis;
  detail::RayScaleRange<S> range;
  S cut{};

  constexpr ScaleAlong() = default;
  constexpr ScaleAlong(const Vector3<S>& start, const Vector3<Unit<S>>& unit_axis, S length, S greatest_operand)
      : from(start), axis(unit_axis), range(length), cut(greatest_operand) {}
  // Along a capsule's own axis.
  constexpr ScaleAlong(const Capsule<S>& segment, S greatest_operand)
      : ScaleAlong(segment.from, segment.axis, segment.length, greatest_operand) {}

  template <class Out, class View> constexpr Out combine(const Vector3<S>& p, const Out& operand, const View& table) const {
    const Out r = detail::cut_off(operand, cut);
    const auto place = range.at(narrow_in_range<S>(dot(subtract_in_range(p, from), axis)));
    const TableSample<S> g = sample_table<Out::has_gradient>(table, place.argument);
    Out out;
    out.value = narrow_in_range<S>(product(r.value, g.value));
    if constexpr (Out::has_gradient) {
      const S along = place.inside ? range.over(detail::per_gradient_length<S>(product(r.value, g.slope))) : S{};
      out.gradient = detail::scaled_gradient<S>(r.gradient, g.value, axis, along);
    }
    return out;
  }
  // Of the place, rounding units: start sqrt(3)/2, product 1/2; axis (6 units of 2^-30 a component) 11 of these a metre.
  constexpr Certificate<S> certificate(OperandCertificates<S> of, const TableFacts& facts, Reach<S> reach) const {
    using T = ScalarTraits<S>;
    const S farthest = reach.radius + length_of<S>(sum_of_squares(from.x, from.y, from.z));
    const S off = T::times(T::rounding_unit(farthest), 3) + T::rotation_units_times(farthest, 11);
    Certificate<S> scaled = range.certificate(of[0], cut, facts, off);
    const Capsule<S> along_axis(from, axis, T::one(), S{});
    scaled.valid = scaled.valid && along_axis.valid() && farthest < T::greatest();
    return scaled;
  }
};

}  // namespace nearfield
