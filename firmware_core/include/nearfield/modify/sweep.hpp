// Sweep objects: a planar ray function carried along a path (Hsu; Crespin, Blanc, Schlick, Implicit Sweep
// Objects, 1996).
#pragma once

#include <nearfield/modify/sine.hpp>
#include <nearfield/shape/algebraic_bounds.hpp>
#include <nearfield/shape/ray.hpp>
#include <nearfield/table/binary_powers.hpp>

namespace nearfield {

namespace detail {

// Slopes of a sweep before they are rounded to the scalar, per 1/16 m: up to 16.
template <class S>
struct SweepSlope {
  using type = Fixed<27>;
};
template <>
struct SweepSlope<float> {
  using type = float;
};

}  // namespace detail

// A superellipse carried along a straight path, `length` metres from `from` along the local z axis. At the
// part t = z / length of it the section is turned by twist t (rad, from x to y) and enlarged s = 1 +
// (end_scale - 1) t times; beyond the ends it goes on as it is there, and the excess e over the path counts
// as the third coordinate:
//   d = N2(N1(|x'| / a, |y'| / b) / s, e / c),   Ni(u, v) = (u^ni + v^ni)^(1/ni),
// (x', y') the point in the turned section. Of length 0, without twist and with end_scale 1: superquadrics
// (Hsu, equation 3), and Lp metrics if n1 = n2. Metres: 1/64 <= a, b, c <= domain, of a and b also times s;
// 1/8 <= end_scale <= 8; 0 <= length <= 2 domain, with a twist or a scale at least 16 units in the last
// place; |twist| <= 15 and |twist| max(a, b) s <= 2 length. Others fold, or turn faster than sections can be
// told apart. Evaluated by logarithms: relative error about 2^-24, of gradients (16 + 2 n) 2^-26. Where an
// exponent is below 1 the slope across the planes in which a coordinate is 0 is infinite: the gradient
// saturates, no certificate bounds the rate, and the error that it states is what a rounding of coordinates
// can move there: large.
template <class S>
struct RaySweep {
  using Scalar = S;
  using PathInverse = decltype(ArgumentScale<S>::inverse);
  static constexpr Kind kind = Kind::ray;
  Vector3<S> from;
  int32_t log_radii[3] = {};  // log2 of a, b and c, Q26
  NormExponent section;       // n1
  NormExponent ends;          // n2
  S twist{};
  S end_scale = ScalarTraits<S>::one();
  S length{};
  PathInverse inverse_length{};       // that of ArgumentScale
  int32_t log_turning = kLog2OfZero;  // log2 of |twist| / length and of |end_scale - 1| / length
  int32_t log_growing = kLog2OfZero;

  constexpr RaySweep() = default;
  constexpr RaySweep(const Vector3<S>& start, const Vector3<S>& semi_axes, NormExponent n1, NormExponent n2,
                     S path_length = S{}, S path_twist = S{}, S scale_at_the_end = ScalarTraits<S>::one())
      : from(start),
        log_radii{log2_of(semi_axes.x), log2_of(semi_axes.y), log2_of(semi_axes.z)},
        section(n1),
        ends(n2),
        twist(path_twist),
        end_scale(scale_at_the_end),
        length(path_length),
        inverse_length(ArgumentScale<S>::of(path_length).inverse) {
    log_turning = over(log2_of(absolute(twist)), log2_of(path_length));
    log_growing = over(log2_of(absolute(grown())), log2_of(path_length));
  }

  // What the path adds to the cost: a twist as much as five of these, a scale as much as two.
  constexpr int item_count() const {
    return (twist == S{} ? 0 : 5) + (end_scale == ScalarTraits<S>::one() ? 0 : 2);
  }

  template <class Out>
  constexpr Out evaluate(const Vector3<S>& p) const {
    const Vector3<S> q = subtract_in_range(p, from);
    const S along = clamp(q.z, S{}, length), excess = subtract_in_range(q.z, along);
    const bool turns = !(twist == S{}), grows = !(end_scale == ScalarTraits<S>::one());
    const Unit<S> part = turns || grows ? part_of_path(along) : Unit<S>{};
    SineCosine<S> turn{};
    S x = q.x, y = q.y;
    if (turns) {
      turn = sine_cosine<S>(narrow_in_range<S>(product(twist, part)));
      x = narrow<S>(product(q.x, turn.cosine) + product(q.y, turn.sine));
      y = narrow<S>(product(q.y, turn.cosine) - product(q.x, turn.sine));
    }
    const int32_t log_x = log2_of(absolute(x)), log_y = log2_of(absolute(y)),
                  log_e = log2_of(absolute(excess));
    const LogarithmOfNorm plane = log2_of_norm(over(log_x, log_radii[0]), over(log_y, log_radii[1]), section);
    const int32_t log_scale = grows ? log2_of(scale_at(part)) : 0;
    Out out;
    out.value = greatest_ray<S>();
    const int32_t in_plane = over(plane.log2, log_scale);
    if (in_plane >= kLog2OfGreatest) return out;
    const LogarithmOfNorm whole = log2_of_norm(in_plane, over(log_e, log_radii[2]), ends);
    if (whole.log2 == kLog2OfZero) return {};
    if (whole.log2 >= kLog2OfGreatest) return out;
    out.value = least_of_two(exp2_of<S>(whole.log2), greatest_ray<S>());
    if constexpr (Out::has_gradient) {
      // Per 1/16 m. A partial derivative by a coordinate is the value times its share over the coordinate.
      const int64_t level = int64_t{whole.log2} + kGradientLengthLog2 * kLog2One;
      const auto size_of = [](int64_t log2) { return exp2_of_sum<Slope>(log2); };
      const auto slope = [&](int64_t log2, S sign) { return sign < S{} ? -size_of(log2) : size_of(log2); };
      const bool by_e = log_e != kLog2OfZero && whole.second_share != kLog2OfZero;
      if (by_e) out.gradient.z = rounded(slope(level + whole.second_share - log_e, excess));
      if (plane.log2 == kLog2OfZero || whole.first_share == kLog2OfZero) return out;
      const int64_t in_section = level + whole.first_share;
      const bool by_x = log_x != kLog2OfZero && plane.first_share != kLog2OfZero;
      const bool by_y = log_y != kLog2OfZero && plane.second_share != kLog2OfZero;
      const int64_t along_x = in_section + plane.first_share - log_x,
                    along_y = in_section + plane.second_share - log_y;
      const Slope across_x = by_x ? slope(along_x, x) : Slope{},
                  across_y = by_y ? slope(along_y, y) : Slope{};
      if (excess == S{} && (turns || grows)) {
        Slope along_path{};
        if (turns && log_x != kLog2OfZero && log_y != kLog2OfZero) {
          // x' y' (share of x' / x'^2 - share of y' / y'^2) a radian.
          const Slope forwards = by_x ? size_of(along_x + log_y + log_turning) : Slope{};
          const Slope backwards = by_y ? size_of(along_y + log_x + log_turning) : Slope{};
          along_path =
              ((x < S{}) == (y < S{})) == (twist > S{}) ? forwards - backwards : backwards - forwards;
        }
        if (grows) {
          const Slope falling = size_of(level - log_scale + log_growing);
          along_path = grown() > S{} ? along_path - falling : along_path + falling;
        }
        out.gradient.z = rounded(along_path);
      }
      if (turns) {
        out.gradient.x = narrow<S>(product(across_x, turn.cosine) - product(across_y, turn.sine));
        out.gradient.y = narrow<S>(product(across_x, turn.sine) + product(across_y, turn.cosine));
      } else {
        out.gradient.x = rounded(across_x);
        out.gradient.y = rounded(across_y);
      }
    }
    return out;
  }

  constexpr Certificate<S> certificate(Reach<S> reach) const {
    using T = ScalarTraits<S>;
    const S farthest = reach.radius + length_of<S>(sum_of_squares(from.x, from.y, from.z));
    Certificate<S> result;
    if (!(valid() && farthest < T::greatest())) return result;
    result.valid = true;
    result.magnitude = greatest_ray<S>();
    const S least_scale = least_of_two(T::one(), end_scale), unit = T::rounding_unit(farthest);
    const RayRadius<S> thinnest = narrowed(least_of_two(log_radii[0], log_radii[1]), least_scale),
                       cap(radius(log_radii[2]));
    const Rate per_width = thinnest.rate(), per_cap = cap.rate();
    const S reached = farthest_from_axis(farthest);
    const Rate turning = per_length(absolute(twist)), growing = per_length(absolute(grown()));
    result.lipschitz = lipschitz_of(per_width, per_cap, turning, growing, reached, least_scale);

    // Absolute: a coordinate and its product 1 and 1/2 units, the angle; an end 1.
    S off = T::times(unit, 2);
    if (turning > Rate()) {
      off = off + T::rotation_units_times(reached, angle_error_units()) +
            T::multiply_up(T::times(unit, 2), detail::rate_product_up(turning, reached));
    }
    const S in_plane =
        norm_of_errors(section, T::multiply_up(off, per_width), T::multiply_up(off, per_width));
    const S moved = norm_of_errors(ends, in_plane, T::multiply_up(T::times(unit, 2), per_cap));
    // Relative, at the greatest value: logarithms; radii by half a unit; the scale by its own roundings and
    // by what an end moves.
    const int32_t units = 4 + section.error_units() + ends.error_units();
    S relative = T::multiply_up(greatest_ray<S>(), Rate::from_raw(units * 3 / 16 + 1));
    const S of_radius = T::is_fixed ? T::times(unit, (kGreatestRay + 1) / 2) : S{};
    relative = relative + T::multiply_up(of_radius, greatest_of_two(per_width, per_cap));
    if (growing > Rate()) {
      const S of_scale =
          T::times(T::rounding_unit(T::times(T::one(), 8)), 4) + T::multiply_up(T::times(unit, 2), growing);
      relative =
          relative + T::times(T::multiply_up(of_scale, RayRadius<S>(least_scale).rate()), kGreatestRay);
    }
    const S all = moved + relative + T::times(T::rounding_unit(greatest_ray<S>()), 2);
    result.error = least_of_two(all, greatest_ray<S>() + T::one());
    return result;
  }

 private:
  using Slope = typename detail::SweepSlope<S>::type;
  static constexpr int32_t kLog2OfGreatest = 262186989;  // log2(15), down

  static constexpr S rounded(Slope slope) {
    if constexpr (__is_same(S, Slope))
      return slope;
    else
      return narrow<S>(product(slope, ScalarTraits<S>::unit_one()));
  }
  static constexpr int32_t over(int32_t log2, int32_t divisor) {
    return log2 == kLog2OfZero ? kLog2OfZero : wrapping_subtract(log2, divisor);
  }
  constexpr ArgumentScale<S> along_path() const {
    if constexpr (ScalarTraits<S>::is_fixed) {
      return {length, static_cast<uint32_t>(leading_zeros(static_cast<uint32_t>(length.raw()))),
              inverse_length};
    } else {
      return {length, inverse_length};
    }
  }
  // z / length, rounded down, by less than 2^-29 and a unit of 2^-30 (float: 2^-22).
  constexpr Unit<S> part_of_path(S along) const {
    const ArgumentScale<S> path = along_path();
    if constexpr (ScalarTraits<S>::is_fixed) {
      const uint32_t quantity = static_cast<uint32_t>(along.raw());
      if (!path.contains(quantity)) return ScalarTraits<S>::unit_one();
      return Unit<S>::from_raw(static_cast<int32_t>(path.argument(quantity) >> 1));
    } else {
      return path.contains(along) ? path.argument(along) : 1.0f;
    }
  }
  constexpr S grown() const { return end_scale - ScalarTraits<S>::one(); }
  constexpr S scale_at(Unit<S> part) const {
    return ScalarTraits<S>::one() + narrow_in_range<S>(product(grown(), part));
  }
  // How far a point may be turned amiss, in units of 2^-30 (float: 2^-21) of its distance: the part of the
  // path by 2^-29 and its last place (float: 2^-22), the twist and its product by half a unit each, sine and
  // cosine.
  constexpr uint32_t angle_error_units() const {
    uint32_t radians = 1;
    for (S rest = absolute(twist); rest >= ScalarTraits<S>::one() && radians < 16;
         rest = rest - ScalarTraits<S>::one()) {
      ++radians;
    }
    const uint32_t roundings = ScalarTraits<S>::is_fixed ? ScalarTraits<S>::angle_units(
                                                               ScalarTraits<S>::one(), ScalarTraits<S>::one())
                                                         : radians;
    return 3 * radians + roundings + kSineErrorUnits + kSineErrorUnits / 2;
  }
  // x / length of both before they were rounded, rounded up.
  constexpr Rate per_length(S x) const {
    if (!(x > S{})) return {};
    if constexpr (ScalarTraits<S>::is_fixed) {
      const S unit = S::unit_in_last_place();
      return quotient<Rate>(x + unit, reciprocal_of(length - unit)) + Rate::from_raw(32);
    } else {
      return detail::rate_up_from((x / length) * 1.00001f);
    }
  }
  // At least 1/64 m, as that is what they are compared with.
  static constexpr S radius(int32_t log2) {
    using T = ScalarTraits<S>;
    return greatest_of_two(exp2_of<S>(log2), T::half(T::half(T::half(T::half(T::half(T::half(T::one())))))));
  }
  static constexpr RayRadius<S> narrowed(int32_t log_radius, S scale) {
    const S exact = radius(log_radius);
    if (scale == ScalarTraits<S>::one()) return RayRadius<S>(exact);
    return RayRadius<S>(narrow<S>(product(exact, scale)) - ScalarTraits<S>::rounding_unit(exact));
  }
  // The greatest half width of a section.
  constexpr S widest() const {
    const S scale = greatest_of_two(ScalarTraits<S>::one(), end_scale);
    return narrow<S>(product(radius(greatest_of_two(log_radii[0], log_radii[1])), scale));
  }

  constexpr bool valid() const {
    using T = ScalarTraits<S>;
    const S one = T::one(), limit = T::domain(), fifteen = T::times(one, 15), eight = T::times(one, 8);
    bool good = coordinates_in_domain(from) && section.valid() && ends.valid();
    for (const int32_t log2 : log_radii) good = good && within(log2, -6 * kLog2One, log2_of(limit));
    good = good && within(length, S{}, limit + limit) && within(twist, -fifteen, fifteen) &&
           within(end_scale, T::half(T::half(T::half(one))), eight);
    if (!good) return false;
    const RaySweep again(from, {one, one, one}, section.n, ends.n, length, twist, end_scale);
    if (!(inverse_length == again.inverse_length && log_turning == again.log_turning &&
          log_growing == again.log_growing)) {
      return false;
    }
    const bool is_straight = twist == S{} && end_scale == one;
    if (length < T::times(T::rounding_unit(length), 16) || length == S{}) return is_straight;
    if (!narrowed(least_of_two(log_radii[0], log_radii[1]), least_of_two(one, end_scale)).valid())
      return false;
    // |twist| widest <= 2 length. Both products are exact in 64 bits.
    return widest() <= limit && !(is_greater(product(absolute(twist), widest()), product(one + one, length)));
  }
  template <int F, class R>
  static constexpr bool is_greater(WideProduct<F, R> a, WideProduct<F, R> b) {
    return a.raw > b.raw;
  }
  static constexpr bool is_greater(float a, float b) { return a > b; }

  // Beyond it the value is kGreatestRay: 15 sqrt(2) times the widest section.
  constexpr S farthest_from_axis(S farthest) const {
    return least_of_two(farthest, ScalarTraits<S>::times(widest(), 23));
  }

  // A norm's gradient is at most 1 long by n >= 2, 2^(1/n - 1/2) by n from 1 to 2.
  static constexpr Rate steepness_of(const NormExponent& exponent) {
    if (exponent.n.raw() >= 2 << Rate::fraction_bits) return kUnitRate;
    const int32_t log2 = (exponent.inverse.raw() >> (28 - kLog2FractionBits)) - kLog2One / 2;
    return exp2_of<Rate>(log2) + Rate::from_raw(64);
  }
  // Of the path: that of the section, and along it what the twist and the scale add; of the ends that of the
  // norm.
  constexpr Rate lipschitz_of(Rate per_width, Rate per_cap, Rate turning, Rate growing, S reached,
                              S least_scale) const {
    using W = ScalarTraits<Rate>;
    if (!section.is_convex() || !ends.is_convex()) return kNoRateBound;
    const auto sixteenth = [](Rate rate) { return Rate::from_raw((rate.raw() >> -kGradientLengthLog2) + 1); };
    const Rate across = W::multiply_up(sixteenth(per_width), steepness_of(section));
    Rate along = W::multiply_up(across, detail::rate_product_up(turning, reached));
    if (growing > Rate()) {
      const Rate of_scale = W::multiply_up(sixteenth(RayRadius<S>(least_scale).rate()), growing);
      along = along + detail::rate_product_up(of_scale, greatest_ray<S>());
    }
    const Rate inside = length_of<Rate>(sum_of_squares(across, along)) + Rate::from_raw(1);
    const Rate outside = W::multiply_up(greatest_of_two(across, sixteenth(per_cap)), steepness_of(ends));
    return greatest_of_two(inside, outside);
  }

  // How far a norm may be off whose operands are off by that, for values up to kGreatestRay.
  static constexpr S norm_of_errors(const NormExponent& exponent, S a, S b) {
    using T = ScalarTraits<S>;
    if (exponent.is_convex()) return a + b;
    // For n < 1 it is concave in either operand: at the most what the first step from 0 adds, next to a great
    // one, twice.
    const S step = greatest_of_two(greatest_of_two(a, b), T::rounding_unit(T::one()));
    if (!(step < T::one())) return greatest_ray<S>();
    const int32_t sixteen = 4 * kLog2One;
    const int32_t log2 =
        log2_of_norm(sixteen, log2_of(step) + 2, exponent).log2 - sixteen + exponent.error_units();
    // 16 (2^x - 1) <= 16 ln 2 x 2^x, twice.
    const Rate factor = exp2_of<Rate>(log2) + Rate::from_raw(64);
    const Rate growing = Rate::from_raw((log2 >> (kLog2FractionBits - Rate::fraction_bits)) + 1);
    const Rate both = ScalarTraits<Rate>::multiply_up(growing, factor);
    const S twice_sixteen_ln2 = T::times(T::multiply_up(T::one(), Rate::from_raw(11629080)), 32);
    if (!(both < Rate::from_raw(1 << Rate::fraction_bits))) return greatest_ray<S>();
    return least_of_two(T::multiply_up(twice_sixteen_ln2, both), greatest_ray<S>());
  }
};

}  // namespace nearfield
