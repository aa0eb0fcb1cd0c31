// Ray functions times a factor g from a table: their influence radius R becomes R / g (KW, "Modifications to Blending
// Functions"). The value is min(r, cut) g: beyond the cut, where it is above the influence, it would only cost accuracy.
#pragma once

#include <nearfield/shape/algebraic.hpp>
#include <nearfield/shape/operands.hpp>
#include <nearfield/shape/ray.hpp>
#include <nearfield/shape/soft.hpp>

namespace nearfield {

// The cut that leaves every value up to 2 as it is, by the least g. A certificate is valid if least g * cut is at least 1 and
// greatest g * cut at most kGreatestRay: with this cut, if radii are within a ratio of 7.5.
template <class S> constexpr S ray_cut(const TableFacts& facts) {
  if (facts.least_value <= 0) return greatest_ray<S>();
  if constexpr (ScalarTraits<S>::is_fixed) {
    const int64_t cut = (int64_t{1} << (31 + S::fraction_bits)) / facts.least_value;
    return cut < greatest_ray<S>().raw() ? S::from_raw(static_cast<int32_t>(cut)) : greatest_ray<S>();
  } else {
    return least_of_two(2147483648.0f / static_cast<float>(facts.least_value), greatest_ray<S>());
  }
}

namespace detail {

// The value limited to the cut, from which on it is constant.
template <class Out, class S> constexpr Out cut_off(const Out& r, S cut) {
  if (r.value < cut) return r;
  Out out;
  out.value = cut;
  return out;
}

template <class S> constexpr typename TableArgument<S>::type end_argument() {
  if constexpr (ScalarTraits<S>::is_fixed) return 0x7fffffffu;
  else return 0.99999994f;
}

// x * q30 / 2^30, rounded up, for x >= 0 and q30 >= 0.
template <int F> constexpr Fixed<F> times_q30_up(Fixed<F> x, int64_t q30) {
  ArithmeticStatus ignored;
  const int64_t limited = q30 < int64_t{1} << 32 ? q30 : int64_t{1} << 32;
  return Fixed<F>::saturate(((x.raw() * limited) >> 30) + 1, ignored);
}
constexpr float times_q30_up(float x, int64_t q30) { return x * (static_cast<float>(q30) * (1.0f / 1073741824.0f)) * 1.000001f; }

// What a table's facts say of g.
template <class S> struct RayScaleBounds {
  bool usable = false;
  Rate greatest;           // of g
  Rate steepness;          // |dg / du|
  int64_t error = 0;       // of g as the table has it, Q30
  int64_t variation = 0;   // greatest less least g, Q30

  static constexpr RayScaleBounds of(const TableFacts& facts, S cut) {
    RayScaleBounds bounds;
    const int64_t least = facts.least_value, most = facts.greatest_value;
    const bool known = facts.error >= 0 && facts.error < (1 << 24) && facts.slope_error >= 0 && least > 0 && most >= least;
    bounds.usable = known && cut > S{} && cut <= greatest_ray<S>() && reaches(cut, least) && !reaches_end(cut, most);
    if (!bounds.usable) return bounds;
    bounds.error = facts.error;
    bounds.variation = most - least + facts.error;
    bounds.greatest = Rate::from_raw(static_cast<int32_t>((most + bounds.error) >> 6) + 1);
    const int64_t falling = -int64_t{facts.least_slope}, rising = facts.greatest_slope;
    ArithmeticStatus ignored;
    bounds.steepness = Rate::saturate(greatest_of_two(greatest_of_two(falling, rising), int64_t{0}) + facts.slope_error, ignored);
    return bounds;
  }

 private:
  template <int F> static constexpr bool reaches(Fixed<F> cut, int64_t least) {
    return cut.raw() * least >= int64_t{1} << (30 + F);
  }
  static constexpr bool reaches(float cut, int64_t least) { return cut * static_cast<float>(least) >= 1073741824.0f; }
  template <int F> static constexpr bool reaches_end(Fixed<F> cut, int64_t most) {
    return cut.raw() * most > int64_t{kGreatestRay} << (30 + F);
  }
  static constexpr bool reaches_end(float cut, int64_t most) {
    return cut * static_cast<float>(most) > static_cast<float>(kGreatestRay) * 1073741824.0f;
  }
};

// Of min(r, cut) g, where g changes by at most `factor_rate` per 1/16 m and is off by at most `factor_error`, Q30, and
// `factor_moved` besides. Rounding units, at kGreatestRay: cut 1, product 1/2.
template <class S>
constexpr Certificate<S> scaled_ray_certificate(const Certificate<S>& r, S cut, const RayScaleBounds<S>& bounds, Rate factor_rate,
                                                int64_t factor_error, S factor_moved = S{}) {
  using T = ScalarTraits<S>;
  Certificate<S> scaled;
  scaled.valid = r.valid && bounds.usable;
  scaled.magnitude = greatest_ray<S>();
  if (!scaled.valid) return scaled;
  scaled.lipschitz = kNoRateBound;
  const Rate of_factor = rate_product_up(factor_rate, cut + T::rounding_unit(cut));
  const Rate of_ray = multiply_rates(r.lipschitz, bounds.greatest);
  if (of_ray != kNoRateBound && of_factor != kNoRateBound) scaled.lipschitz = of_ray + of_factor;
  const S rounding = T::times(T::rounding_unit(greatest_ray<S>()), 2);
  const S of_g = times_q30_up(cut, factor_error) + product_up(cut, factor_moved);
  scaled.error = T::multiply_up(r.error, bounds.greatest) + of_g + rounding;
  return scaled;
}

// 0 to `limit` metres as 0 to 1. The limit is 1/64 m to twice the domain.
template <class S> struct RayScaleRange {
  ArgumentScale<S> scale;

  constexpr RayScaleRange() = default;
  constexpr explicit RayScaleRange(S limit) : scale(ArgumentScale<S>::of(limit)) {}

  // Outside the range its nearer end.
  struct Place {
    typename TableArgument<S>::type argument{};
    bool inside = false;
  };
  constexpr Place at(S x) const {
    if (!(x > S{})) return {};
    if (!scale.contains(quantity(x))) return {end_argument<S>(), false};
    return {scale.argument(quantity(x)), true};
  }
  // x / limit, saturating.
  constexpr S over(S x) const {
    Reciprocal<S> inverse;
    if constexpr (ScalarTraits<S>::is_fixed) inverse = {scale.inverse, scale.shift};
    else inverse = {scale.inverse};
    const S size = quotient<S>(absolute(x), inverse);
    return x < S{} ? -size : size;
  }

  constexpr bool valid() const {
    using T = ScalarTraits<S>;
    const S least = T::half(T::half(T::half(T::half(T::half(T::half(T::one()))))));
    return scale.consistent() && scale.limit >= least && scale.limit <= T::domain() + T::domain();
  }
  // 1 / limit of the limit before it was rounded, per 1/16 m, rounded up.
  constexpr Rate rate() const {
    if (!valid()) return kNoRateBound;
    if constexpr (ScalarTraits<S>::is_fixed) {
      constexpr int bits = Rate::fraction_bits + kGradientLengthLog2 + S::fraction_bits;
      return Rate::from_raw(static_cast<int32_t>((int64_t{1} << bits) / (scale.limit.raw() - 1)) + 1);
    } else {
      return Rate::from_raw(static_cast<int32_t>(1048576.0f / scale.limit) + 16);
    }
  }
  // Of min(r, cut) g(x / limit), where x changes by at most a metre a metre and is off by at most `off`.
  constexpr Certificate<S> certificate(const Certificate<S>& r, S cut, const TableFacts& facts, S off) const {
    const auto bounds = RayScaleBounds<S>::of(facts, cut);
    const int64_t moved = ((int64_t{bounds.steepness.raw()} * error_q30(off)) >> Rate::fraction_bits) + 1;
    Certificate<S> scaled = scaled_ray_certificate<S>(r, cut, bounds, multiply_rates(bounds.steepness, rate()),
                                                      bounds.error + least_of_two(moved, bounds.variation));
    scaled.valid = scaled.valid && valid();
    return scaled;
  }

 private:
  // Of the argument of an x that is off by that much, Q30: the limit's rounding, the argument's own (2^-29; float 2^-21).
  constexpr int64_t error_q30(S off) const {
    using T = ScalarTraits<S>;
    if (!valid()) return int64_t{1} << 30;
    if constexpr (T::is_fixed) {
      const int64_t part = (int64_t{(off + T::rounding_unit(off)).raw()} << 30) / scale.limit.raw() + 4;
      return part < int64_t{1} << 30 ? part : int64_t{1} << 30;
    } else {
      const float part = off / scale.limit * 1073741824.0f + 512.0f;
      return part < 1073741824.0f ? static_cast<int64_t>(part) : int64_t{1} << 30;
    }
  }
  template <int F, class R> static constexpr uint32_t quantity(Fixed<F, R> x) { return static_cast<uint32_t>(x.raw()); }
  static constexpr float quantity(float x) { return x; }
};

// r's gradient times g, and `along` in a direction.
template <class S>
constexpr Vector3<S> scaled_gradient(const Vector3<S>& r, Unit<S> g, const Vector3<Unit<S>>& direction, S along) {
  return {narrow<S>(product(r.x, g) + product(direction.x, along)), narrow<S>(product(r.y, g) + product(direction.y, along)),
          narrow<S>(product(r.z, g) + product(direction.z, along))};
}

}  // namespace detail

}  // namespace nearfield
