// Hoffmann and Hopcroft's blend of algebraic fields by a conic (Hsu, equation 7), made continuous.
//
// With u = x / r1, v = y / r2, w = 1 - u - v and q = 1 - p / (r1 r2) the conic is
//   B_H(x, y) = (r1 r2)^2 (w^2 - 2 q u v).
// Its inner arc, from (r1, 0) to (0, r2) in the triangle u, v, w >= 0, is tangent to both axes there; the union's
// fillet is what lies between it and the corner. This is the field
//   fillet = (r1 + r2) (u v - w^2 / 2q) = -(r1 + r2) / (2 q (r1 r2)^2) B_H,  u and v taken as 0 where negative,
//   union  = min(x, y, fillet) where u + v < 1, and min(x, y) elsewhere.
// Regions: where u + v < 1 the fillet decides as long as it is less than both operands. Beyond an axis it reaches as
// deep as x > -(r1 + r2) (1 - v)^2 / 2q; that makes the field continuous, as min(x, y) is 0 on the axes although they
// lie well inside the blended solid. Everywhere else the operands are left alone.
// Continuous: on u + v = 1 the fillet is (r1 + r2) u v >= min(r1 u, r2 v), which is what r1 + r2 is for. The surface
// has a continuous tangent and is that of B_H in the triangle; past u + v = 1 the conic has another arc, which is no
// part of it.
#pragma once

#include <nearfield/blend/polynomial.hpp>
#include <nearfield/blend/sharp.hpp>

namespace nearfield {

namespace detail {

// The parameters of all three operations.
template <class S> struct HoffmannHopcroftConic {
  ArgumentScale<S> first, second;  // limits r1, r2
  S conic{};
  S sum{};           // r1 + r2
  S depth{};         // (r1 + r2) / 2q
  S sharpness{};     // 1 / q
  S first_slope{};   // (r1 + r2) / r1
  S second_slope{};  // (r1 + r2) / r2

  constexpr void set(S first_range, S second_range, S conic_of_ranges) {
    first = ArgumentScale<S>::of(first_range);
    second = ArgumentScale<S>::of(second_range);
    conic = conic_of_ranges;
    sum = first_range + second_range;
    const S one = ScalarTraits<S>::one(), q = one - conic;
    depth = quotient(sum, q + q);
    sharpness = quotient(one, q);
    first_slope = quotient(sum, first_range);
    second_slope = quotient(sum, second_range);
  }

  // The fillet's gradient by the operands is a mean with weights u, v, w of (0, s2), (s1, 0) and (s1, s2) / q, s the
  // slopes, or less where one operand is beyond its axis. Slopes are greater than 1.
  constexpr Certificate<S> certificate(OperandCertificates<S> of, const TableFacts&, Reach<S>) const {
    if (!parameters_valid()) return {};
    const AlgebraicBounds<S> a = bounds_of(of[0]), b = bounds_of(of[1]);
    const S first_error = product_up(first_slope, a.error), second_error = product_up(second_slope, b.error);
    const S corner_error = product_up(sharpness, sum_up(first_error, second_error));
    const S carried = greatest_of_two(greatest_of_two(first_error, second_error), corner_error);
    const Rate first_rate = rate_product_up(a.lipschitz, before_rounding(first_slope, first.limit));
    const Rate second_rate = rate_product_up(b.lipschitz, before_rounding(second_slope, second.limit));
    const Rate corner_rate =
        rate_product_up(first_rate + second_rate, before_rounding(sharpness, ScalarTraits<S>::one() - conic));
    const Rate steepest = greatest_of_two(greatest_of_two(first_rate, second_rate), corner_rate);
    const S own = own_error();
    const S magnitude = greatest_of_two(greatest_of_two(a.magnitude, b.magnitude), sum_up(depth, own));
    return algebraic_certificate<S>({magnitude, steepest, sum_up(carried, own)}, of[0].valid && of[1].valid);
  }

 private:
  static constexpr S quotient(S a, S b) {
    if constexpr (ScalarTraits<S>::is_fixed) {
      ArithmeticStatus ignored;
      return divide(a, b, ignored);
    } else {
      return b == 0.0f ? 0.0f : a / b;
    }
  }
  constexpr bool parameters_valid() const {
    using T = ScalarTraits<S>;
    const S r1 = first.limit, r2 = second.limit, one = T::one();
    if (!(valid_length(r1) && valid_length(r2) && first.consistent() && second.consistent())) return false;
    if (!within(one - conic, T::half(T::half(T::half(one))), T::domain())) return false;
    HoffmannHopcroftConic again;
    again.set(r1, r2, conic);
    const S limit = T::greatest();
    return sum == again.sum && depth == again.depth && sharpness == again.sharpness &&
           first_slope == again.first_slope && second_slope == again.second_slope && sum < limit && depth < limit &&
           first_slope < limit && second_slope < limit;
  }
  // A bound of the quotient that it is of numbers before they were rounded, `divisor` the rounded one.
  static constexpr S before_rounding(S of, S divisor) {
    if constexpr (ScalarTraits<S>::is_fixed) {
      return divisor.raw() > 1 ? sum_up(of, units_up<S>(of.raw() / (divisor.raw() - 1) + 2)) : algebraic_limit<S>();
    } else {
      return sum_up(of, roundings(of, 2));
    }
  }
  // An exact product in units of the last place, rounded up.
  static constexpr int64_t up(int64_t exact) {
    constexpr int F = fraction_bits_of<S>;
    return (exact + ((int64_t{1} << F) - 1)) >> F;
  }
  // Of the blend itself, parameters included. With m = max(1, 1/q), in units: ranges (s1 + s2) m / 2 and 1/2, conic
  // depth / 2q, depth 1/2, value 1/2; shares and their products 2^-27 of (r1 + r2) m and of depth.
  constexpr S own_error() const {
    const S m = greatest_of_two(sharpness, ScalarTraits<S>::one());
    if constexpr (ScalarTraits<S>::is_fixed) {
      // Numbers of units, which have more room than S.
      constexpr int F = S::fraction_bits, spare = 27 - F;
      const int64_t both_slopes = int64_t{first_slope.raw()} + second_slope.raw();
      const int64_t slopes = up(both_slopes * m.raw()) >> F, conics = up(int64_t{depth.raw()} * sharpness.raw()) >> F;
      const int64_t whole = (up(int64_t{sum.raw()} * m.raw()) + depth.raw()) >> F;
      return units_up<S>(slopes + conics + 5 + ((whole + 1) >> spare));
    } else {
      const S whole = sum_up(product_up(sum, m), depth);
      const S slopes = product_up(sum_up(first_slope, second_slope), m);
      return roundings(sum_up(whole, product_up(slopes, sum)), 4);
    }
  }
};

}  // namespace detail

// Intersection -union(-x, -y), difference -union(-x, y). Ranges r1, r2 within (0, domain], in the operands' unit;
// conic = p / (r1 r2) in [1 - domain, 7/8]: 0 gives a quarter of an ellipse, larger ones flatter fillets, negative ones
// sharper. (r1 + r2) / r1, (r1 + r2) / r2 and (r1 + r2) / 2q are below the greatest number. Rounding: certificate().
template <class S, SetOperation operation> struct HoffmannHopcroft : detail::HoffmannHopcroftConic<S> {
  using Scalar = S;
  static constexpr Kind kind = Kind::algebraic;
  static constexpr int fixed_operand_count = 2;

  static constexpr HoffmannHopcroft of(S first_range, S second_range, S conic) {
    HoffmannHopcroft blend;
    blend.set(first_range, second_range, conic);
    return blend;
  }

  template <class Out> constexpr Out combine(const Out& a, const Out& b) const {
    const bool turned = operation != SetOperation::unite;
    const S x = turned ? -a.value : a.value, y = operation == SetOperation::intersect ? -b.value : b.value;
    const bool first_decides = !(y < x);
    const S nearer = first_decides ? x : y;
    const U u = share(this->first, x), v = share(this->second, y), one = ScalarTraits<S>::unit_one();
    const U w = subtract_in_range(subtract_in_range(one, u), v);
    if (w > U{}) {
      const U uv = narrow<U>(product(u, v)), ww = narrow<U>(product(w, w));
      const S fillet = narrow<S>(product(this->sum, uv) - product(this->depth, ww));
      if (fillet < nearer) {
        Out out;
        out.value = turned ? -fillet : fillet;
        if constexpr (Out::has_gradient) {
          // By x: (r1 + r2) / r1 (v + w / q) where u > 0, and so for y. Both sides of a turning cancel out.
          const S bent = narrow<S>(product(this->sharpness, w));
          const S by_x = u > U{} ? bent + ScalarTraits<S>::from_unit(v) : S{};
          const S by_y = v > U{} ? bent + ScalarTraits<S>::from_unit(u) : S{};
          const Out of_first = algebraic_scaled(algebraic_scaled(a, this->first_slope), by_x);
          const Out of_second = algebraic_scaled(algebraic_scaled(b, this->second_slope), by_y);
          const bool negative = operation == SetOperation::subtract;
          out.gradient = algebraic_sum(of_first, negative ? negated(of_second) : of_second).gradient;
        }
        return out;
      }
    }
    if (first_decides) return a;
    return operation == SetOperation::subtract ? negated(b) : b;
  }

 private:
  using U = Unit<S>;

  template <class Out> static constexpr Out negated(const Out& a) {
    Out out;
    out.value = -a.value;
    if constexpr (Out::has_gradient) out.gradient = -a.gradient;
    return out;
  }
  // value / range, at least 0; 1 from the range on. Rounded down, less than 2^-28 below.
  template <int F, class R> static constexpr Fixed<30> share(const ArgumentScale<S>& range, Fixed<F, R> value) {
    if (value.raw() <= 0) return {};
    const uint32_t quantity = static_cast<uint32_t>(value.raw());
    if (!range.contains(quantity)) return ScalarTraits<S>::unit_one();
    return Fixed<30>::from_raw(static_cast<int32_t>(range.argument(quantity) >> 1));
  }
  static constexpr float share(const ArgumentScale<float>& range, float value) {
    return value <= 0.0f ? 0.0f : range.contains(value) ? range.argument(value) : 1.0f;
  }
};

template <class S> using HoffmannHopcroftUnion = HoffmannHopcroft<S, SetOperation::unite>;
template <class S> using HoffmannHopcroftIntersection = HoffmannHopcroft<S, SetOperation::intersect>;
template <class S> using HoffmannHopcroftDifference = HoffmannHopcroft<S, SetOperation::subtract>;

}  // namespace nearfield
