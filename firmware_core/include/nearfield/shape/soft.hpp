// Soft objects: skeletons that spread an intensity (KW; Hsu).
#pragma once

#include <nearfield/shape/capsule.hpp>
#include <nearfield/table/table.hpp>

namespace nearfield {

namespace detail {

// 1 / x; 0 (of Fixed: saturated) unless x > 0.
template <int F, class R> constexpr Fixed<F, R> inverse_of(Fixed<F, R> x) {
  ArithmeticStatus ignored;
  return divide(ScalarTraits<Fixed<F, R>>::one(), x, ignored);
}
constexpr float inverse_of(float x) { return x > 0.0f ? 1.0f / x : 0.0f; }

// Bounds of rates, rounded up. A factor without a bound leaves none.
constexpr Rate multiply_rates(Rate a, Rate b) {
  return a == kNoRateBound || b == kNoRateBound ? kNoRateBound : ScalarTraits<Rate>::multiply_up(a, b);
}
// A number >= 0 as a rate.
template <int F, class R> constexpr Rate rate_up(Fixed<F, R> a) {
  ArithmeticStatus ignored;
  constexpr int finer = F > 24 ? F - 24 : 0, coarser = F < 24 ? 24 - F : 0;
  const int64_t raw = (int64_t{a.raw()} >> finer) + (finer > 0 ? 1 : 0);
  return Rate::saturate(raw * (int64_t{1} << coarser), ignored);
}
constexpr Rate rate_up(float a) {
  if (!(a < 127.0f)) return Rate::greatest();
  return a > 0.0f ? Rate::from_raw(static_cast<int32_t>(a * 16777216.0f) + 16) : Rate{};
}

// What a table says of weight * P(x), x its argument, P a potential: non-increasing, but for what the facts leave open.
struct PotentialBounds {
  bool usable = false;
  Rate steepness;  // |dF / dx|
  Rate error;      // |F of the table - F| and, further, by how much the table may rise with x or at its end

  template <class S> static constexpr PotentialBounds of(const TableFacts& facts, S weight) {
    PotentialBounds bounds;
    bounds.usable = facts.error >= 0 && facts.error < greatest_of<int32_t> && facts.slope_error >= 0;
    const Rate strength = rate_up(absolute(weight));
    const int64_t falling = magnitude_of(facts.least_slope), rising = magnitude_of(facts.greatest_slope);
    bounds.steepness = multiply_rates(strength, as_rate((falling > rising ? falling : rising) + facts.slope_error));
    int64_t error = facts.error;  // Q30
    if (facts.greatest_slope > 0) error += int64_t{facts.greatest_slope} * 64;
    if (facts.least_value < 0) error -= facts.least_value;
    bounds.error = multiply_rates(strength, as_rate((error >> 6) + 1));
    return bounds;
  }

 private:
  static constexpr Rate as_rate(int64_t raw) {
    ArithmeticStatus ignored;
    return Rate::saturate(raw, ignored);
  }
};

// Lipschitz constant and error of weight * P(x), where x changes by at most `argument_rate` per 1/16 m and is evaluated
// within `operand_error` of its operand's unit, in which x changes by at most `operand_rate`.
template <class S>
constexpr void state_potential_bounds(Certificate<S>& certificate, const PotentialBounds& bounds, S weight,
                                      Rate argument_rate, S operand_error, Rate operand_rate) {
  using T = ScalarTraits<S>;
  certificate.valid = certificate.valid && bounds.usable;
  certificate.lipschitz = multiply_rates(bounds.steepness, argument_rate);
  const Rate moved = multiply_rates(bounds.steepness, operand_rate);
  // Arguments are off by less than 2^-29 (float: 2^-20), products by less than 2 units (float: 2^-20); a float's error
  // is stated as at least 2^-18 of its greatest value, for sums to build on.
  const S argument_unit = T::is_fixed ? T::rounding_unit(T::one()) : T::rounding_unit(T::one() + T::one());
  const S products =
      T::is_fixed ? T::times(T::rounding_unit(T::one()), 2) : T::times(T::rounding_unit(absolute(weight)), 8);
  // Both potentials lie in [0, 1], whatever the operand is.
  const bool bounded = bounds.steepness != kNoRateBound && moved != kNoRateBound;
  const S of_argument = T::multiply_up(operand_error, moved) + T::multiply_up(argument_unit, bounds.steepness);
  certificate.error = T::multiply_up(T::one(), bounds.error) + products +
                      (bounded ? least_of_two(of_argument, absolute(weight)) : absolute(weight));
  if (bounds.error == kNoRateBound) certificate.error = T::greatest();
  certificate.magnitude = absolute(weight) + certificate.error;
  certificate.below_zero = weight < S{} ? certificate.magnitude : S{};
}

// A distance that is at most `spread` off, towards where weight * P is greatest.
template <class S> constexpr S towards_highest(S away, S spread, S weight) {
  if (weight < S{}) return away + spread;
  const S nearest = away - spread;
  return nearest > S{} ? nearest : S{};
}

}  // namespace detail

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
    inverse_radius = detail::inverse_of(influence_radius);
    gradient_factor = ScalarTraits<S>::half(ScalarTraits<S>::half(ScalarTraits<S>::half(inverse_radius)));
  }

  template <class Out, class View> constexpr Out evaluate(const Vector3<S>& offset, const View& potential) const {
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

  // The greatest value within `spread` of the place with this offset, rounding included.
  template <class View> constexpr Highest<S> highest(const Vector3<S>& offset, S spread, const View& potential) const {
    const S away = length_of<S>(sum_of_squares(offset.x, offset.y, offset.z));
    const S r = detail::towards_highest(away, spread, weight);
    const auto squares = sum_of_squares(r, S{});
    if (!scale.contains(squares)) return {};
    return {narrow<S>(product(weight, sample_table<false>(potential, scale.argument(squares)).value))};
  }
  // `units`: rounding units by which the distance may be off, but for the root.
  constexpr Certificate<S> certificate(Reach<S> reach, S extent, bool skeleton_valid, int units,
                                       const TableFacts& facts) const {
    using T = ScalarTraits<S>;
    Certificate<S> result;
    result.valid = exact_distance<S>(reach, extent, skeleton_valid && valid(), 0).valid;
    // x = r^2 / R^2 changes by at most 2 R0 / R per R0; by 16 times as much per metre.
    const Rate per_length = detail::rate_up(gradient_factor + T::rounding_unit(gradient_factor));
    const S moved = T::times(T::rounding_unit(reach.radius + extent), units << -kGradientLengthLog2);
    const auto bounds = detail::PotentialBounds::of(facts, weight);
    detail::state_potential_bounds(result, bounds, weight, per_length, moved, per_length);
    return result;
  }

  constexpr bool valid() const {
    const Influence again(radius, weight);
    const S limit = ScalarTraits<S>::domain();
    return valid_length(radius) && within(weight, -limit, limit) && scale.consistent(radius) &&
           inverse_radius == again.inverse_radius && gradient_factor == again.gradient_factor &&
           inverse_radius < ScalarTraits<S>::greatest();
  }
};

// Spreads from a point.
template <class S> struct SoftPoint {
  using Scalar = S;
  static constexpr Kind kind = Kind::intensity;
  static constexpr bool samples_table = true;
  static constexpr bool has_highest = true;
  Vector3<S> center;
  Influence<S> influence;

  template <class Out, class View> constexpr Out evaluate(const Vector3<S>& p, const View& potential) const {
    return influence.template evaluate<Out>(subtract_in_range(p, center), potential);
  }
  template <class View>
  constexpr Highest<S> highest(const Vector3<S>& p, const Ball<S>& ball, const View& potential) const {
    using T = ScalarTraits<S>;
    const S rounding = T::times(T::rounding_unit(ball.reach + extent()), kUnits + 1);
    return influence.highest(subtract_in_range(p, center), ball.radius + rounding, potential);
  }
  constexpr Certificate<S> certificate(Reach<S> reach, const TableFacts& facts) const {
    return influence.certificate(reach, extent(), coordinates_in_domain(center), kUnits, facts);
  }

 private:
  // Rounding units of the distance: centre sqrt(3)/2, influence radius 1/2.
  static constexpr int kUnits = 2;
  constexpr S extent() const { return length_of<S>(sum_of_squares(center.x, center.y, center.z)); }
};

// Spreads from a segment.
template <class S> struct SoftSegment {
  using Scalar = S;
  static constexpr Kind kind = Kind::intensity;
  static constexpr bool samples_table = true;
  static constexpr bool has_highest = true;
  Capsule<S> segment;  // of radius 0
  Influence<S> influence;

  template <class Out, class View> constexpr Out evaluate(const Vector3<S>& p, const View& potential) const {
    return influence.template evaluate<Out>(segment.offset_to(p), potential);
  }
  template <class View>
  constexpr Highest<S> highest(const Vector3<S>& p, const Ball<S>& ball, const View& potential) const {
    using T = ScalarTraits<S>;
    const S rounding = T::times(T::rounding_unit(ball.reach + segment.extent()), kUnits + 1);
    return influence.highest(segment.offset_to(p), ball.radius + rounding, potential);
  }
  constexpr Certificate<S> certificate(Reach<S> reach, const TableFacts& facts) const {
    const bool valid = segment.valid() && segment.radius == S{};
    return influence.certificate(reach, segment.extent(), valid, kUnits, facts);
  }

 private:
  static constexpr int kUnits = 10;  // as a capsule, but for the root
};

}  // namespace nearfield
