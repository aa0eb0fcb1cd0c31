// Blends B(x, y) = max(x, y) + h(|x - y|) of distances, h a table of curve/kernel.hpp: Li's exterior and interior blends
// (Li, equations 18 to 24), log-sum-exp of two operands (AC), polynomial smooth maxima. In the distance convention: union
// -B(-x, -y), intersection B(x, y), subtraction B(x, -y).
#pragma once

#include <nearfield/blend/sharp.hpp>

namespace nearfield {

namespace detail {

// The last argument before 1, or before 1/2.
template <class Argument> constexpr Argument last_argument(bool of_half) {
  if constexpr (static_cast<Argument>(0.5f) == Argument{}) return of_half ? 0x3fffffffu : 0x7fffffffu;
  else return of_half ? 0.49999997f : 0.99999994f;
}
constexpr int64_t to_q30_units(int32_t value) { return value; }
constexpr int64_t to_q30_units(float value) {
  return value > -2.0f && value < 2.0f ? static_cast<int64_t>(value * 1073741824.0f) : int64_t{1} << 31;
}
// How far apart values may be where a table goes on: roundings of its coefficients and of the kernel.
template <class S, int degree, int bits> constexpr int64_t joint_slack(const TableView<S, degree, bits>&) {
  return !ScalarTraits<S>::is_fixed ? 4096 : bits == 32 ? 64 : 64 * 65536;
}

}  // namespace detail

// Whether h is the same for both signs of x - y; if not (Li's blends with a step that is not antisymmetric), the table's
// lower half is h of x >= y and its upper half h of x < y, x the first operand as B sees it.
enum class Sides : uint8_t { alike, differ };

// The sharp operation plus h(|x - y|) where the operands are closer than the kernel's range; exactly the sharp operation
// elsewhere. h = range * table(|x - y| / range).
template <class S, SetOperation operation, Sides sides = Sides::alike> struct Additive {
  using Scalar = S;
  static constexpr Kind kind = Kind::distance;
  static constexpr int fixed_operand_count = 2;
  static constexpr bool samples_table = true;
  static constexpr bool checks_table = true;
  ArgumentScale<S> scale;  // its limit is the range, metres

  template <class Out, class View> constexpr Out combine(const Out& a, const Out& b, const View& kernel) const {
    if constexpr (operation == SetOperation::subtract) return with_second(a, detail::negated(b), kernel);
    else return with_second(a, b, kernel);
  }

  // Whether the table's ends meet as this operation needs them: 0 at the range; and without a step in the middle, or, of a
  // table of two halves, 0 there too and both halves alike at a tie.
  template <class View> constexpr bool fits(const View& kernel) const {
    using Argument = typename TableArgument<S>::type;
    const auto value = [&kernel](Argument u) { return detail::to_q30_units(sample_raw<false>(kernel, u).value); };
    const auto slope = [&kernel](Argument u) { return detail::to_q30_units(sample_raw<true>(kernel, u).slope) / 16; };
    constexpr Argument last = detail::last_argument<Argument>(false), middle = detail::last_argument<Argument>(true);
    constexpr Argument after_middle = half_argument(Argument{}, false);
    const int64_t slack = detail::joint_slack(kernel);
    const auto near = [slack](int64_t a, int64_t b) { return a - b <= slack && b - a <= slack; };
    if (!near(value(last), 0)) return false;
    if constexpr (sides == Sides::alike) {
      if (kernel.index_bits == 0) return true;
      constexpr int64_t steep = 1 << 20;  // 1/64, and more where the table has headroom
      // Level at 0 and then at once steep: there a second half begins.
      const bool begins_again = near(value(middle), 0) && slope(middle) < steep && slope(middle) > -steep && (slope(after_middle) > steep || slope(after_middle) < -steep);
      return near(value(middle), value(after_middle)) && !begins_again;
    } else {
      return kernel.index_bits > 0 && near(value(middle), 0) && near(value(after_middle), value(Argument{}));
    }
  }

  // With d = |1 + h'| + |h'| <= 1 + 2 b: error d max(e) + range * table error + 2 rounding units.
  constexpr Certificate<S> certificate(OperandCertificates<S> of, const TableFacts& facts, Reach<S> reach) const {
    using T = ScalarTraits<S>;
    Certificate<S> both = Sharp<S, operation>{}.certificate(of, facts, reach);
    both.valid = both.valid && scale.consistent() && scale.limit <= T::domain() && facts.error >= 0 && facts.error < (1 << 24);
    const Rate spread = spread_of(facts);
    both.lipschitz = ScalarTraits<Rate>::multiply_up(both.lipschitz, spread);
    both.valid = both.valid && both.lipschitz < kSteepest && facts.greatest_slope < kGreatestSlope;
    const S added = T::multiply_up(scale.limit, rate_up(facts.greatest_value));
    const S removed = T::multiply_up(scale.limit, rate_up(-int64_t{facts.least_value}));
    both.error = T::multiply_up(both.error, spread) + T::multiply_up(scale.limit, rate_up(facts.error)) +
                 T::times(T::rounding_unit(reach.radius), 2);
    if constexpr (operation == SetOperation::unite) {
      both.inflation = both.inflation + added;
      both.erosion = both.erosion + removed;
    } else {
      both.erosion = both.erosion + added;
      both.inflation = both.inflation + removed;
    }
    return both;
  }

 private:
  // Beyond this rate gradients could leave the number range.
  static constexpr Rate kSteepest = Rate::from_raw(8 << Rate::fraction_bits);
  // Of h', Q24, so that 1 + h' fits wherever h' does.
  static constexpr int32_t kGreatestSlope = (sides == Sides::alike ? 15 : 31) << 20;

  template <class Quantity> constexpr auto argument(Quantity gap, bool first_decides) const {
    const auto whole = scale.argument(gap);
    if constexpr (sides == Sides::alike) return whole;
    else return half_argument(whole, first_decides);
  }
  static constexpr uint32_t half_argument(uint32_t whole, bool lower) { return (whole >> 1) + (lower ? 0u : 1u << 30); }
  // Below 1 for all of them.
  static constexpr float half_argument(float whole, bool lower) { return whole * 0.49999997f + (lower ? 0.0f : 0.5f); }

  template <class Out, class View> constexpr Out with_second(const Out& a, const Out& b, const View& kernel) const {
    const bool first_decides = detail::first_decides<operation>(a.value, b.value);
    const S deciding = first_decides ? a.value : b.value;
    const auto gap = first_decides ? detail::gap<operation>(a.value, b.value) : detail::gap<operation>(b.value, a.value);
    if (!scale.contains(gap)) return first_decides ? a : b;
    const auto h = sample_raw<Out::has_gradient>(kernel, argument(gap, first_decides));
    const S added = detail::scaled_by_value(scale.limit, h.value);
    Out out;
    out.value = operation == SetOperation::unite ? deciding - added : deciding + added;
    if constexpr (Out::has_gradient) {
      // The deciding operand's share is 1 + h', the other's -h'.
      const int headroom = kernel.slope_headroom;
      const auto slope = sides == Sides::alike ? h.slope : detail::half_of(h.slope);
      const auto share_of_b = first_decides ? -slope : detail::one_more(slope, headroom);
      out.gradient = {mean(a.gradient.x, b.gradient.x, share_of_b, headroom), mean(a.gradient.y, b.gradient.y, share_of_b, headroom),
                      mean(a.gradient.z, b.gradient.z, share_of_b, headroom)};
    }
    return out;
  }

  // Gradients are at most a few units long.
  template <class Slope> static constexpr S mean(S a, S b, Slope share_of_b, int headroom) {
    return add_in_range(a, detail::scaled_by_slope(subtract_in_range(b, a), share_of_b, headroom));
  }

  // A non-negative Q30 bound as a rate, rounded up; 0 for negative ones.
  static constexpr Rate rate_up(int64_t q30) {
    return Rate::from_raw(q30 <= 0 ? 0 : static_cast<int32_t>((q30 >> 6) + 1));
  }
  // |1 + h'| + |h'| at its greatest. Slopes of a table whose halves are two functions are twice h'.
  static constexpr Rate spread_of(const TableFacts& facts) {
    constexpr int64_t halves = sides == Sides::alike ? 1 : 2;
    const int64_t above = (facts.greatest_slope + halves - 1) / halves;
    const int64_t below = -int64_t{kUnitRate.raw()} - (facts.least_slope - halves + 1) / halves;
    const int64_t outside = above > below ? above : below;
    ArithmeticStatus ignored;
    return Rate::saturate(int64_t{kUnitRate.raw()} + (outside > 0 ? 2 * outside : 0), ignored);
  }
};

template <class S> using AdditiveUnion = Additive<S, SetOperation::unite>;
template <class S> using AdditiveIntersection = Additive<S, SetOperation::intersect>;
template <class S> using AdditiveSubtraction = Additive<S, SetOperation::subtract>;
template <class S> using TwoSidedUnion = Additive<S, SetOperation::unite, Sides::differ>;
template <class S> using TwoSidedIntersection = Additive<S, SetOperation::intersect, Sides::differ>;
template <class S> using TwoSidedSubtraction = Additive<S, SetOperation::subtract, Sides::differ>;

}  // namespace nearfield
