#pragma once

#include <nearfield/modify/ray_scale.hpp>

namespace nearfield {

// min(r, cut) g(q), q the distance from the local z axis over `limit` metres, 1 beyond: KW's parameter |CQ| of a disc of that
// radius about the origin. On the axis, where the distance has no direction, g adds nothing to the gradient.
template <class S> struct ScaleFromAxis {
  using Scalar = S;
  static constexpr Kind kind = Kind::ray;
  static constexpr int fixed_operand_count = 1;
  static constexpr bool takes_point = true;
  static constexpr bool samples_table = true;
  detail::RayScaleRange<S> range;
  S cut{};

  constexpr ScaleFromAxis() = default;
  constexpr ScaleFromAxis(S limit, S greatest_operand) : range(limit), cut(greatest_operand) {}

  template <class Out, class View> constexpr Out combine(const Vector3<S>& p, const Out& operand, const View& table) const {
    const Out r = detail::cut_off(operand, cut);
    Out out;
    if constexpr (Out::has_gradient) {
      const Polar<S, Unit<S>> away = polar<Unit<S>>(Vector3<S>{p.x, p.y, S{}});
      const auto place = range.at(away.length);
      const TableSample<S> g = sample_table<true>(table, place.argument);
      out.value = narrow_in_range<S>(product(r.value, g.value));
      const S along = place.inside ? range.over(detail::per_gradient_length<S>(product(r.value, g.slope))) : S{};
      out.gradient = detail::scaled_gradient<S>(r.gradient, g.value, away.direction, along);
    } else {
      const auto place = range.at(length_of<S>(sum_of_squares(p.x, p.y)));
      out.value = narrow_in_range<S>(product(r.value, sample_table<false>(table, place.argument).value));
    }
    return out;
  }
  // Of the distance, rounding units: root 1.
  constexpr Certificate<S> certificate(OperandCertificates<S> of, const TableFacts& facts, Reach<S> reach) const {
    using T = ScalarTraits<S>;
    Certificate<S> scaled = range.certificate(of[0], cut, facts, T::rounding_unit(reach.radius));
    scaled.valid = scaled.valid && reach.radius < T::greatest();
    return scaled;
  }
};

}  // namespace nearfield
