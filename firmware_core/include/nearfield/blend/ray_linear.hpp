// Ray-linear blends B(x, y) = m + m h(u) of ray functions, h a table of curve/ray_kernel.hpp: super-
// ellipsoidal union, intersection and difference (Ricci), Hsu's scale union and scale intersection. More
// operands are blended one after the other; norms are associative.
#pragma once

#include <nearfield/blend/sharp.hpp>
#include <nearfield/shape/ray.hpp>

namespace nearfield {

namespace detail {

// Factors of a table's argument: Q24, or float.
template <class S> struct RayFactor { using type = Rate; };
template <> struct RayFactor<float> { using type = float; };

}  // namespace detail

// From the ratio t = 1 - lesser / greater of two operands to the argument of a profile's table.
template <class S> struct RaySides {
  using Factor = typename detail::RayFactor<S>::type;
  using Argument = typename TableArgument<S>::type;
  // u = t * first where the first operand decides, t * second where the second one does; from u = 1 on the
  // blend is sharp.
  Factor first{};
  Factor second{};
  uint32_t differ = 0;  // 0: both sides share the table; 1: it has a half for each, the first one's below

  // Of a profile of curve/ray_kernel.hpp.
  template <class Profile> static constexpr RaySides of(const Profile& profile) {
    const auto both = profile.factors();
    return {static_cast<Factor>(both.first), static_cast<Factor>(both.second), both.differ ? 1u : 0u};
  }
  constexpr Factor factor(bool first_decides) const { return first_decides ? first : second; }
  // False where the blend is sharp. If true, `place` is an argument of the table, whatever the factors are.
  constexpr bool find(Argument t, bool first_decides, Argument& place) const {
    if constexpr (ScalarTraits<S>::is_fixed) {
      const uint64_t scaled = static_cast<uint64_t>(t) * static_cast<uint32_t>(factor(first_decides).raw());
      const uint32_t whole = static_cast<uint32_t>(scaled >> Rate::fraction_bits);
      place = differ == 0 ? whole : (whole >> 1) + (first_decides ? 0u : 1u << 30);
      return scaled < uint64_t{1} << (31 + Rate::fraction_bits);
    } else {
      const float whole = t * factor(first_decides);
      place = differ == 0 ? whole : whole * 0.49999997f + (first_decides ? 0.0f : 0.5f);
      return whole >= 0.0f && whole < 1.0f;
    }
  }
  constexpr bool valid() const {
    const Factor one = ScalarTraits<Factor>::one(), most = ScalarTraits<Factor>::times(one, 64);
    return within(first, one, most) && within(second, one, most) && differ <= 1;
  }
};

// The complement of a ray function b about the surface b = c (Hsu: c = 1): c^2 / b, by which the first solid
// without the second is their intersection. It has a pole where b = 0, and no Lipschitz constant there: below
// `least` it goes on along its tangent, up to 2 c^2 / least, so that it is C1 with |slope| <= (c / least)^2.
// The surface c does not notice.
template <class S> struct RayComplement {
  S surface_square{};  // c^2
  S least{};           // in (0, 1]; 2 c^2 / least <= kGreatestRay and c^2 / least^2 < 64

  template <class Out> constexpr Out of(const Out& b) const {
    const S x = greatest_of_two(b.value, least);
    const Reciprocal<S> inverse = reciprocal_of(x);
    const S value = quotient<S>(surface_square, inverse);
    const auto slope = quotient<typename detail::RayFactor<S>::type>(value, inverse);
    Out out;
    out.value = add_in_range(value, narrow_in_range<S>(product(slope, subtract_in_range(x, b.value))));
    if constexpr (Out::has_gradient) {
      const Vector3<S> g = subtract_in_range(Vector3<S>{}, b.gradient);
      out.gradient = {narrow_in_range<S>(product(slope, g.x)), narrow_in_range<S>(product(slope, g.y)),
                      narrow_in_range<S>(product(slope, g.z))};
    }
    return out;
  }
  // Rounding units: c^2 8, quotient 2, the tangent's slope and product 5.
  constexpr Certificate<S> certificate(const Certificate<S>& b) const {
    using T = ScalarTraits<S>;
    using W = ScalarTraits<Rate>;
    Certificate<S> result = b;
    result.valid = b.valid && surface_square > S{} && surface_square <= greatest_ray<S>();
    result.valid = result.valid && least > S{} && least <= T::one();
    const Reciprocal<S> inverse = reciprocal_of(least);
    const S most = quotient<S>(surface_square, inverse);
    result.valid = result.valid && most + most <= greatest_ray<S>();
    const Rate slope = steepest(quotient<typename detail::RayFactor<S>::type>(most, inverse));
    result.valid = result.valid && slope < Rate::from_raw(64 << Rate::fraction_bits);
    result.lipschitz = W::multiply_up(b.lipschitz, slope);
    const S rounding = T::rounding_unit(greatest_ray<S>());
    result.error = T::multiply_up(b.error, slope) + T::times(rounding, T::is_fixed ? 15 : 3);
    return result;
  }

 private:
  static constexpr Rate steepest(Rate slope) { return slope + Rate::from_raw(64); }
  static constexpr Rate steepest(float slope) {
    if (!(slope >= 0.0f && slope < 100.0f)) return Rate::greatest();
    return Rate::from_raw(static_cast<int32_t>(slope * 16777216.0f) + 4096);
  }
};

template <class S, SetOperation operation> struct RayLinearPayload {
  RaySides<S> sides;
};
template <class S> struct RayLinearPayload<S, SetOperation::subtract> {
  RaySides<S> sides;
  RayComplement<S> complement;
};

// The lesser (union) or greater (intersection) operand m, and m times what the table says of their ratio
// where they are close; exactly m elsewhere. Difference: the intersection of the first operand with the
// complement of the second. Operands below 0 count as 0, those above kGreatestRay and results above it as
// that; both are constants, of gradient 0.
template <class S, SetOperation operation> struct RayLinear : RayLinearPayload<S, operation> {
  using Scalar = S;
  static constexpr Kind kind = Kind::ray;
  static constexpr int fixed_operand_count = 2;
  static constexpr bool samples_table = true;

  template <class Out, class View>
  constexpr Out combine(const Out& a, const Out& b, const View& profile) const {
    if constexpr (operation == SetOperation::subtract) {
      return blended(bounded(a), this->complement.of(bounded(b)), profile);
    } else {
      return blended(bounded(a), bounded(b), profile);
    }
  }

  // Error: spread * max(e), kGreatestRay times the error of the table and of its argument, 2 rounding units.
  constexpr Certificate<S> certificate(OperandCertificates<S> of, const TableFacts& facts, Reach<S>) const {
    using T = ScalarTraits<S>;
    Certificate<S> second = of[1];
    if constexpr (operation == SetOperation::subtract) second = this->complement.certificate(of[1]);
    Certificate<S> both = worst_of(of[0], second);
    both.valid = both.valid && this->sides.valid() && usable(facts);
    if (!both.valid) return both;
    const Rate spread = spread_of(facts);
    both.lipschitz = ScalarTraits<Rate>::multiply_up(both.lipschitz, spread);
    both.valid = both.lipschitz < kSteepest;
    both.error = T::multiply_up(both.error, spread) + greatest_ray_times(table_error(facts)) +
                 T::times(T::rounding_unit(greatest_ray<S>()), 2);
    return both;
  }

 private:
  // Beyond this rate, per 1/16 m, gradients could leave the number range.
  static constexpr Rate kSteepest =
      Rate::from_raw((ScalarTraits<S>::is_fixed && fraction_bits_of<S> >= 25 ? 15 : 127) << Rate::fraction_bits);
  static constexpr bool is_union = operation == SetOperation::unite;
  static constexpr int64_t kUnit = int64_t{1} << Rate::fraction_bits;

  template <class Out> static constexpr Out bounded(const Out& ray) {
    Out out;
    if (ray.value < S{}) return out;
    if (ray.value <= greatest_ray<S>()) return ray;
    out.value = greatest_ray<S>();
    return out;
  }

  // Operands in [0, kGreatestRay].
  template <class Out, class View>
  constexpr Out blended(const Out& a, const Out& b, const View& profile) const {
    const auto operands = detail::ordered<is_union ? SetOperation::unite : SetOperation::intersect>(a, b);
    const Out &deciding = operands.deciding, &other = operands.other;
    const S greater = is_union ? other.value : deciding.value;
    const S lesser = is_union ? deciding.value : other.value;
    const auto t = ratio(magnitude_of(subtract_in_range(greater, lesser)), magnitude_of(greater));
    typename TableArgument<S>::type place{};
    if (!this->sides.find(t, operands.first_decides, place)) return deciding;
    const TableSample<S> h = sample_table<Out::has_gradient>(profile, place);
    const S added = narrow_in_range<S>(product(deciding.value, h.value));
    Out out;
    out.value = greatest_ray<S>();
    if (!(added < subtract_in_range(greatest_ray<S>(), deciding.value))) return out;
    out.value = greatest_of_two(add_in_range(deciding.value, added), S{});
    if constexpr (Out::has_gradient) {
      const S slope = this->sides.differ == 0 ? h.slope : ScalarTraits<S>::half(h.slope);
      const auto factor = this->sides.factor(operands.first_decides);
      const S by_ratio = narrow_in_range<S>(product(slope, factor));  // dh / dt
      const Unit<S> q = lesser_part(t);
      const S moved = narrow_in_range<S>(product(by_ratio, q));
      const S whole = add_in_range(ScalarTraits<S>::one(), ScalarTraits<S>::from_unit(h.value));
      // Partial derivatives: union T - q T'(t) and q^2 T'(t), intersection T + q T'(t) and -T'(t).
      const S own = is_union ? subtract_in_range(whole, moved) : add_in_range(whole, moved);
      const S others = is_union ? narrow_in_range<S>(product(moved, q)) : subtract_in_range(S{}, by_ratio);
      const Vector3<S> &d = deciding.gradient, &o = other.gradient;
      out.gradient = {narrow_in_range<S>(product(own, d.x) + product(others, o.x)),
                      narrow_in_range<S>(product(own, d.y) + product(others, o.y)),
                      narrow_in_range<S>(product(own, d.z) + product(others, o.z))};
    }
    return out;
  }

  template <int F> static constexpr uint32_t magnitude_of(Fixed<F> x) {
    return static_cast<uint32_t>(x.raw());
  }
  static constexpr float magnitude_of(float x) { return x; }
  // lesser / greater = 1 - t.
  static constexpr Unit<S> lesser_part(uint32_t t) {
    return Unit<S>::from_raw(static_cast<int32_t>((0x80000000u - t) >> 1));
  }
  static constexpr float lesser_part(float t) { return 1.0f - t; }

  static constexpr int64_t q24(Rate factor) { return factor.raw(); }
  static constexpr int64_t q24(float factor) { return static_cast<int64_t>(factor * 16777216.0f); }
  constexpr int64_t greatest_factor() const {
    return q24(greatest_of_two(this->sides.first, this->sides.second));
  }
  constexpr int64_t least_factor() const { return q24(least_of_two(this->sides.first, this->sides.second)); }
  // A slope of the table, if positive, per unit of u.
  constexpr int64_t per_side(int64_t slope) const {
    return slope <= 0 ? 0 : (slope + this->sides.differ) >> this->sides.differ;
  }
  // The same per unit of t, of the side where that is more, rounded up.
  constexpr int64_t per_ratio(int64_t slope) const {
    return ((per_side(slope) * greatest_factor()) >> Rate::fraction_bits) + 1;
  }

  static constexpr int64_t steepest_slope(const TableFacts& facts) {
    return greatest_of_two(int64_t{facts.greatest_slope}, -int64_t{facts.least_slope});
  }
  // How far the table's derivative by t may be from the exact one, and so from being monotone.
  constexpr int64_t slack_of(const TableFacts& facts) const {
    return per_ratio(facts.slope_error) + (facts.error >> 6) + 1;
  }

  // Values within +-1 and derivatives below 8, so that nothing can leave the number range.
  constexpr bool usable(const TableFacts& facts) const {
    constexpr int32_t one = 1 << 30, slack = 1 << 24;
    if (!(facts.error >= 0 && facts.error < slack && facts.slope_error >= 0)) return false;
    if (!(facts.least_value > -one - slack && facts.greatest_value < one + slack)) return false;
    return steepest_of(facts) < 8 * kUnit && spread_of(facts) < Rate::greatest();
  }

  // The greatest |dh/dt|. A table of two sides says only how steep the steeper one is per unit of its own
  // argument. That B is monotone, q |dh/dt| <= T, says more: of the union at the least ratio q of the region,
  // of the intersection, whose derivatives add up to T + t |dh/dt|, either at q or at t above 1/2.
  constexpr int64_t steepest_of(const TableFacts& facts) const {
    const int64_t by_slope = per_ratio(steepest_slope(facts));
    const int64_t monotone = convex_spread(facts) + slack_of(facts);
    if constexpr (!is_union) return least_of_two(by_slope, 2 * monotone);
    const int64_t widest = least_factor();
    if (widest <= kUnit) return by_slope;
    const int64_t inverse_ratio = (widest << 8) / (widest - kUnit) + 1;  // Q8
    return least_of_two(by_slope, (monotone * inverse_ratio) >> 8);
  }

  // The greatest |dB/da| + |dB/db| of a profile that is monotone and 0 at the end of its range. With
  // T = 1 + h and k = dB/d(other) >= 0, B's homogeneity makes dB/d(deciding) T - q k of the
  // intersection, T - k / q of the union. The sum is T + t k of the intersection, which the steepest
  // descent to T = 1 at the range's end bounds by 1 + max |dh/du|, and at most T of the union.
  constexpr int64_t convex_spread(const TableFacts& facts) const {
    if constexpr (is_union) return kUnit + (int64_t{facts.greatest_value} >> 6) + 1;
    else return kUnit + (facts.error >> 6) + 1 + per_side(-int64_t{facts.least_slope});
  }
  // The same of a table, which is off by its slack: one of the two may be negative by that.
  constexpr Rate spread_of(const TableFacts& facts) const {
    const int64_t least = kUnit + (int64_t{facts.least_value} >> 6);
    const int64_t rises = facts.greatest_slope, falls = -int64_t{facts.least_slope};
    const int64_t convex = convex_spread(facts), slack = slack_of(facts);
    const int64_t overshooting = 2 * per_ratio(is_union ? rises : falls) - least;
    const int64_t backwards = per_ratio(is_union ? falls : rises);
    ArithmeticStatus ignored;
    return Rate::saturate(greatest_of_two(convex, least_of_two(overshooting, convex + 2 * slack)) +
                              2 * least_of_two(backwards, slack),
                          ignored);
  }

  // Of T, Q30: the table's, and that of an argument which ratio and factor moved by at most 1.5 (factor + 1)
  // units of 2^-30 (float: 256 of them), and a unit for a knot between.
  constexpr int64_t table_error(const TableFacts& facts) const {
    const int64_t steepest = steepest_slope(facts), factors = greatest_factor() + kUnit;
    const int64_t moved = ScalarTraits<S>::is_fixed ? (3 * factors) >> 1 : 256 * factors;
    return facts.error + ((((steepest >> 12) + 1) * ((moved >> 12) + 1)) >> Rate::fraction_bits) + 2;
  }
  static constexpr S greatest_ray_times(int64_t q30) {
    if constexpr (ScalarTraits<S>::is_fixed) {
      ArithmeticStatus ignored;
      return S::saturate(((q30 * kGreatestRay) >> (30 - S::fraction_bits)) + 1, ignored);
    } else {
      return static_cast<float>(q30) * (static_cast<float>(kGreatestRay) / 1073741824.0f) * 1.000001f;
    }
  }
};

template <class S> using RayLinearUnion = RayLinear<S, SetOperation::unite>;
template <class S> using RayLinearIntersection = RayLinear<S, SetOperation::intersect>;
template <class S> using RayLinearDifference = RayLinear<S, SetOperation::subtract>;

}  // namespace nearfield
