#pragma once

#include <nearfield/modify/ray_scale.hpp>
#include <nearfield/modify/sine.hpp>
#include <nearfield/table/diamond_angle.hpp>

namespace nearfield {

namespace detail {

// Turns per metre: Q24, or float.
template <class S> struct TwistNumber { using type = Rate; };
template <> struct TwistNumber<float> { using type = float; };

// twist * z as a fraction of a turn, Q32, wrapping; rounded down. A float of 2^22 turns and more counts as 0.
template <int F> constexpr uint32_t twist_phase(Fixed<F> z, Rate twist) {
  return static_cast<uint32_t>((int64_t{z.raw()} * twist.raw()) >> (F + Rate::fraction_bits - 32));
}
constexpr uint32_t twist_phase(float z, float twist) {
  const float turns = twist * z;
  if (!(turns > -4194304.0f && turns < 4194304.0f)) return 0;
  const float rest = turns - static_cast<float>(static_cast<int32_t>(turns));  // within (-1, 1)
  return static_cast<uint32_t>(static_cast<int32_t>(rest * 2147483648.0f)) << 1;
}

// 2 pi, rounded down.
template <class S> constexpr S full_turn() {
  constexpr int64_t q30 = 6746518852;
  if constexpr (ScalarTraits<S>::is_fixed) return S::from_raw(static_cast<int32_t>(q30 >> (30 - S::fraction_bits)));
  else return 6.2831853f;
}

}  // namespace detail

enum class AngleAbout : uint32_t { axis = 0, ring = 1 };

// min(r, cut) G, G = g(u) a factor for an angle u as diamond_angle() has it: with g(u) = 1 / f3(angle) baked as a table, the
// influence radius is R f3 (KW); f3 is periodic.
//   axis: the angle alpha of (a, b) = (x, y) about the local z axis; what it counts from turns by `twist` turns per metre of z
//   ring: the angle beta of (a, b) = (|(x, y)| - ring, z), from outwards to upwards, about the circle of that radius (KW, torus)
// Where a = b = 0 the angle is not defined, and KW's function jumps. So that there is a rate, within `core` metres of there G
// goes over to `level`: G = level + q^2 (3 - 2 q) (g(u) - level), q = (a^2 + b^2) / core^2: C1 as g is, and without a slope at
// a = b = 0. A core inside the object leaves its surface as it is.
// 1/64 m <= core <= 2 domain; |twist| <= 127; 0 <= ring <= domain; level from the least to the greatest g.
template <class S> struct ScaleAbout {
  using Scalar = S;
  using Twist = typename detail::TwistNumber<S>::type;
  static constexpr Kind kind = Kind::ray;
  static constexpr int fixed_operand_count = 1;
  static constexpr bool takes_point = true;
  static constexpr bool samples_table = true;
  static constexpr bool checks_table = true;
  S cut{};
  detail::RayScaleRange<S> core;
  Unit<S> level{};
  Twist twist{};
  S ring{};
  AngleAbout about = AngleAbout::axis;

  // The level halfway between the least and the greatest g.
  static constexpr ScaleAbout axis(const TableFacts& facts, S core_radius, Twist turns_per_metre = {}) {
    return {ray_cut<S>(facts), detail::RayScaleRange<S>(core_radius), middle_of(facts), turns_per_metre, S{}, AngleAbout::axis};
  }
  static constexpr ScaleAbout circle(const TableFacts& facts, S core_radius, S ring_radius) {
    return {ray_cut<S>(facts), detail::RayScaleRange<S>(core_radius), middle_of(facts), Twist{}, ring_radius, AngleAbout::ring};
  }

  template <class Out, class View> constexpr Out combine(const Vector3<S>& p, const Out& operand, const View& table) const {
    return about == AngleAbout::axis ? about_axis(p, operand, table) : about_ring(p, operand, table);
  }

  // Whether values go round: g as great at the end of the turn as at its start, within 64 units of 2^-30 (float: 2^-18).
  template <class View> constexpr bool fits(const View& table) const {
    const auto first = sample_raw<false>(table, typename TableArgument<S>::type{}).value;
    const auto last = sample_raw<false>(table, detail::end_argument<S>()).value;
    const auto apart = first < last ? last - first : first - last;
    if constexpr (ScalarTraits<S>::is_fixed) return apart <= 64;
    else return apart <= 1.0f / 262144.0f;
  }
  constexpr Certificate<S> certificate(OperandCertificates<S> of, const TableFacts& facts, Reach<S> reach) const {
    using T = ScalarTraits<S>;
    using W = ScalarTraits<Twist>;
    const auto bounds = detail::RayScaleBounds<S>::of(facts, cut);
    const Twist limit = W::times(W::one(), 127);
    const bool turns = about == AngleAbout::axis && ring == S{} && within(twist, -limit, limit);
    const bool rings = about == AngleAbout::ring && twist == Twist{} && within(ring, S{}, T::domain());
    const S farthest = reach.radius + ring + T::times(T::rounding_unit(reach.radius), 4);
    const bool valid = (turns || rings) && farthest < T::greatest() && core.valid() && bounds.usable &&
                       within(level, q30(facts.least_value), q30(facts.greatest_value));
    if (!valid) return {};
    // Slopes of G per core: across, q^2 (3 - 2 q) / (4 sqrt q) <= 0.2562 of |dg/du|; outwards 12 sqrt q q (1 - q) <= 2.2309 of
    // |g - level|. Along z pi/2 twist |dg/du|.
    const Rate variation = Rate::from_raw(static_cast<int32_t>(bounds.variation >> 6) + 1);
    const Rate across = part(bounds.steepness, 263), outwards = part(variation, 2285);
    const Rate in_plane = detail::multiply_rates(root(across, outwards, Rate{}), core.rate());
    const Rate upwards = detail::multiply_rates(part(bounds.steepness, 101), detail::rate_up(absolute(twist)));
    const Rate rate = in_plane == kNoRateBound || upwards == kNoRateBound ? kNoRateBound : root(in_plane, upwards, Rate{});
    // G by 2^-28 (float: 2^-21) of the steepness and eight times that of the variation; a turn by an angle moves it by less than
    // angle (|dg/du| / 4 + 2 variation); a place by rounding units: root or product 1, core and ring 1/2 each.
    const int64_t units = T::is_fixed ? 4 : 512, turned = int64_t{turn_units(reach)} * (T::is_fixed ? 1 : 512);
    const int64_t of_angle = (int64_t{bounds.steepness.raw()} * (units + turned / 4 + 1)) >> Rate::fraction_bits;
    const int64_t of_core = (int64_t{variation.raw()} * (8 * units + 2 * turned)) >> Rate::fraction_bits;
    const int64_t error = bounds.error + of_angle + of_core + 2;
    const S moved = T::times(T::rounding_unit(reach.radius + ring), 2 << -kGradientLengthLog2);
    const S factor_moved = T::multiply_up(moved, in_plane);
    Certificate<S> scaled = detail::scaled_ray_certificate<S>(of[0], cut, bounds, rate, error, factor_moved);
    if (rate == kNoRateBound) scaled.valid = false;
    return scaled;
  }

 private:
  // G at (a, b), and the slopes of r G per 1/16 m by a, by b and by the angle in turns of the reference per metre.
  struct Plane {
    Unit<S> factor{};
    S by_a{}, by_b{}, by_turn{};
  };
  template <bool with_slope, class View> constexpr Plane plane(S a, S b, S r, bool turns, const View& table) const {
    const auto angle = diamond_angle<with_slope>(a, b);
    const TableSample<S> g = sample_table<with_slope>(table, angle.argument);
    Plane result;
    result.factor = g.value;
    Unit<S> q{};
    if (in_core(a, b, q)) {
      const Unit<S> square = narrow_in_range<Unit<S>>(product(q, q)), cube = narrow_in_range<Unit<S>>(product(square, q));
      const Unit<S> share = add_in_range(square, times_two(subtract_in_range(square, cube)));
      const Unit<S> difference = subtract_in_range(g.value, level);
      result.factor = add_in_range(level, narrow_in_range<Unit<S>>(product(difference, share)));
      if constexpr (with_slope) {
        set_slopes(result, angle, narrow_in_range<S>(product(steepness_of(r, g), share)), turns);
        // r (g - level) 12 q (1 - q) / 16, over the core.
        const Unit<S> fall = subtract_in_range(q, square), rising = subtract_in_range(fall, quarter(fall));
        const S pull = core.over(narrow_in_range<S>(product(narrow_in_range<S>(product(r, difference)), rising)));
        result.by_a = result.by_a + narrow<S>(product(pull, of_core(a)));
        result.by_b = result.by_b + narrow<S>(product(pull, of_core(b)));
      }
    } else if constexpr (with_slope) {
      set_slopes(result, angle, steepness_of(r, g), turns);
    }
    return result;
  }
  static constexpr void set_slopes(Plane& result, const DiamondAngle<S>& angle, S steepness, bool turns) {
    using T = ScalarTraits<S>;
    const S along = angle.quarter_of(steepness);
    result.by_a = narrow_in_range<S>(product(along, angle.across_a));
    result.by_b = narrow_in_range<S>(product(along, angle.across_b));
    if (!turns) return;
    // (a, b) falls back by (a^2 + b^2) / size^2 quarters of a radian.
    const Unit<S> squares =
        narrow_in_range<Unit<S>>(product(angle.across_a, angle.across_a) + product(angle.across_b, angle.across_b));
    const S quarters = narrow_in_range<S>(product(steepness, squares));
    result.by_turn = narrow<S>(product(T::half(T::half(quarters)), detail::full_turn<S>()));
  }
  static constexpr S steepness_of(S r, const TableSample<S>& g) { return detail::per_gradient_length<S>(product(r, g.slope)); }
  static constexpr Unit<S> times_two(Unit<S> x) { return add_in_range(x, x); }
  static constexpr Unit<S> quarter(Unit<S> x) { return ScalarTraits<Unit<S>>::half(ScalarTraits<Unit<S>>::half(x)); }

  // x / core, for |x| < core.
  constexpr Unit<S> of_core(S x) const {
    if constexpr (ScalarTraits<S>::is_fixed) {
      const int32_t part = static_cast<int32_t>(core.scale.argument(detail::size_of(x)) >> 1);
      return Unit<S>::from_raw(x < S{} ? -part : part);
    } else {
      return x * core.scale.inverse;
    }
  }
  // Whether (a, b) is within the core; q then.
  constexpr bool in_core(S a, S b, Unit<S>& q) const {
    if constexpr (ScalarTraits<S>::is_fixed) {
      const uint32_t size_a = detail::size_of(a), size_b = detail::size_of(b);
      if (!(core.scale.contains(size_a) && core.scale.contains(size_b))) return false;
      const uint32_t u = core.scale.argument(size_a), v = core.scale.argument(size_b);
      q = Unit<S>::from_raw(static_cast<int32_t>(multiply_high(u, u) + multiply_high(v, v)));
    } else {
      const float u = a * core.scale.inverse, v = b * core.scale.inverse;
      q = u * u + v * v;
    }
    return q < ScalarTraits<S>::unit_one();
  }

  template <class Out, class View> constexpr Out about_axis(const Vector3<S>& p, const Out& operand, const View& table) const {
    const Out r = detail::cut_off(operand, cut);
    const bool turns = !(twist == Twist{});
    SineCosine<S> turn{};
    S a = p.x, b = p.y;
    if (turns) {
      turn = sine_cosine_of_phase<S>(detail::twist_phase(p.z, twist));
      a = narrow_in_range<S>(product(p.x, turn.cosine) + product(p.y, turn.sine));
      b = narrow_in_range<S>(product(p.y, turn.cosine) - product(p.x, turn.sine));
    }
    const Plane scale = plane<Out::has_gradient>(a, b, r.value, turns, table);
    Out out;
    out.value = narrow_in_range<S>(product(r.value, scale.factor));
    if constexpr (Out::has_gradient) {
      Vector3<S> of_factor = {scale.by_a, scale.by_b, S{}};
      if (turns) {
        of_factor.x = narrow<S>(product(scale.by_a, turn.cosine) - product(scale.by_b, turn.sine));
        of_factor.y = narrow<S>(product(scale.by_a, turn.sine) + product(scale.by_b, turn.cosine));
        of_factor.z = -narrow<S>(product(scale.by_turn, twist));
      }
      out.gradient = scaled(r.gradient, scale.factor) + of_factor;
    }
    return out;
  }
  template <class Out, class View> constexpr Out about_ring(const Vector3<S>& p, const Out& operand, const View& table) const {
    const Out r = detail::cut_off(operand, cut);
    Out out;
    if constexpr (Out::has_gradient) {
      const Polar<S, Unit<S>> away = polar<Unit<S>>(Vector3<S>{p.x, p.y, S{}});
      const Plane scale = plane<true>(subtract_in_range(away.length, ring), p.z, r.value, false, table);
      out.value = narrow_in_range<S>(product(r.value, scale.factor));
      const auto outwards = [&scale](Unit<S> part) { return narrow<S>(product(scale.by_a, part)); };
      const Vector3<S> of_factor = {outwards(away.direction.x), outwards(away.direction.y), scale.by_b};
      out.gradient = scaled(r.gradient, scale.factor) + of_factor;
    } else {
      const S away = length_of<S>(sum_of_squares(p.x, p.y));
      const Plane scale = plane<false>(subtract_in_range(away, ring), p.z, r.value, false, table);
      out.value = narrow_in_range<S>(product(r.value, scale.factor));
    }
    return out;
  }

  static constexpr Unit<S> q30(int64_t value) {
    if constexpr (ScalarTraits<S>::is_fixed) return Unit<S>::from_raw(static_cast<int32_t>(value));
    else return static_cast<float>(value) * (1.0f / 1073741824.0f);
  }
  static constexpr Unit<S> middle_of(const TableFacts& facts) {
    return q30((int64_t{facts.least_value} + facts.greatest_value) / 2);
  }
  // a * parts / 1024, rounded up.
  static constexpr Rate part(Rate a, int64_t parts) {
    ArithmeticStatus ignored;
    return Rate::saturate(((a.raw() * parts) >> 10) + 1, ignored);
  }
  static constexpr Rate root(Rate a, Rate b, Rate c) {
    if (a == kNoRateBound || b == kNoRateBound) return kNoRateBound;
    return length_of<Rate>(sum_of_squares(a, b, c)) + Rate::from_raw(1);
  }
  // Of a rotation by twist z: sine and cosine, and the angle by half a unit of the twist at the reach; 0 without a twist.
  constexpr uint32_t turn_units(Reach<S> reach) const {
    if (twist == Twist{}) return 0;
    constexpr uint32_t sine = 2 * kSineErrorUnits;
    if constexpr (ScalarTraits<S>::is_fixed) {
      return sine + 8 + 202 * ((static_cast<uint32_t>(reach.radius.raw()) >> S::fraction_bits) + 1);
    } else {
      return sine + 8 + 2 * static_cast<uint32_t>(absolute(twist) * reach.radius + 1.0f);
    }
  }
};

}  // namespace nearfield
