// I-patches (Sipos): surfaces that meet given ones, the ribbons, along given curves, on the bounds. Normalised, so that
// the field has the size of its primaries and no zeros but the patch.
//
// Bounds enter by their magnitude: outside, |B| stands for B. With s_i = |B_i|^-e, e the exponent, which is 2 for
// tangents that agree along the sides (G1) and 3 for curvatures (G2):
//   ribbons  (sum w_i P_i s_i + w) / sum s_i
//   corners  (sum C_k s_k s_k+1 + sum w_k s_k + w) / sum s_k s_k+1,  C_k at the corner of the sides k, k + 1 (cyclic)
// Where bounds vanish (float: below 2^-60), the values are the limits for all of these equally small: the even mean of
// the sides (ribbons), or of the corners by their other bounds; the gradient is then that of the primaries and of the
// bounds that do not vanish, which is exact where a single one does.
#pragma once

#include <nearfield/blend/polynomial.hpp>
#include <nearfield/number/wide_range.hpp>

namespace nearfield {

inline constexpr uint32_t kGreatestSideCount = 8;

namespace detail {

template <class S> constexpr WideRange<S> power(const WideRange<S>& x, uint32_t exponent) {
  WideRange<S> result = x;
  for (uint32_t i = 1; i < exponent; ++i) result = result * x;
  return result;
}

// Bounds of a patch and their reciprocals.
template <class S> struct PatchSides {
  uint32_t count = 0;
  WideRange<S> bound[kGreatestSideCount];
  WideRange<S> inverse[kGreatestSideCount];  // 0 where a bound is

  constexpr void set(uint32_t side, S value) {
    bound[side] = WideRange<S>::magnitude_of(value);
    inverse[side] = bound[side].reciprocal();
  }
  constexpr bool vanishes(uint32_t side) const { return bound[side].is_zero(); }
  constexpr uint32_t next(uint32_t side) const { return side + 1 < count ? side + 1 : 0; }
  constexpr uint32_t previous(uint32_t side) const { return side > 0 ? side - 1 : count - 1; }
};

// Gradients of primaries and bounds, added up.
template <class Out> struct GradientSum {
  using S = typename Out::Scalar;
  WideSum<S> x, y, z;

  template <class Weight> constexpr void add(const Weight& weight, const Vector3<S>& gradient) {
    x.add(weight, gradient.x);
    y.add(weight, gradient.y);
    z.add(weight, gradient.z);
  }
  constexpr Vector3<S> result() const {
    return {saturated(x.result()), saturated(y.result()), saturated(z.result())};
  }
};

// What both patches have in common.
template <class S> struct PatchParameters {
  uint32_t side_count = 0;  // to 8
  uint32_t exponent = 2;    // 2 or 3
  S side_weight[kGreatestSideCount] = {};
  S centre_weight{};

  constexpr bool valid(uint32_t fewest) const {
    const S limit = ScalarTraits<S>::domain();
    if (side_count < fewest || side_count > kGreatestSideCount || exponent < 2 || exponent > 3) return false;
    bool within_limits = within(centre_weight, -limit, limit);
    for (uint32_t i = 0; i < kGreatestSideCount; ++i) {
      within_limits = within_limits && (i < side_count ? within(side_weight[i], -limit, limit) : side_weight[i] == S{});
    }
    return within_limits;
  }
};

// Where several bounds vanish together, patches change at any rate. `magnitude` without the roundings of the patch.
template <class S> constexpr Certificate<S> patch_certificate(S magnitude) {
  const S rounded = sum_up(magnitude, roundings(magnitude, ScalarTraits<S>::is_fixed ? 32 : 4));
  return algebraic_certificate<S>({rounded, kNoRateBound, rounded}, true);
}

template <class S> constexpr S power_up(S x, uint32_t exponent) {
  S result = x;
  for (uint32_t i = 1; i < exponent; ++i) result = product_up(result, x);
  return result;
}

}  // namespace detail

// Operands: P_1, B_1, ..., P_n, B_n; n from 2 to 8. Weights within the domain's number, those of sides beyond n 0.
// On side i the patch is w_i P_i. Rounding: w_i P_i half a unit in the last place each, the mean one unit and 2^-28 of
// the greatest difference between them; float: 6 units in the last place of the greatest term.
template <class S> struct RibbonPatch : detail::PatchParameters<S> {
  using Scalar = S;
  static constexpr Kind kind = Kind::algebraic;
  static constexpr int fixed_operand_count = kAnyNumber;

  // 0 for a number of sides out of range.
  constexpr int operand_count() const {
    return this->side_count <= kGreatestSideCount ? static_cast<int>(2 * this->side_count) : 0;
  }

  template <class Out, class Operands> constexpr Out combine_all(const Operands& of) const {
    const uint32_t n = this->side_count;
    detail::PatchSides<S> sides;
    sides.count = n;
    S ribbon[kGreatestSideCount] = {};
    uint32_t nearest = 0;
    for (uint32_t i = 0; i < n; ++i) {
      ribbon[i] = detail::saturated(Out(of[primary_of(i)]).value * this->side_weight[i]);
      sides.set(i, Out(of[primary_of(i) + 1]).value);
      if (sides.bound[i] < sides.bound[nearest]) nearest = i;
    }
    WideRange<S> share[kGreatestSideCount];
    const WideRange<S> nearest_share = shares_of(sides, nearest, share);
    const WideRange<S> centre = detail::power(sides.bound[nearest], this->exponent) * nearest_share;

    WideSum<S> value;
    for (uint32_t i = 0; i < n; ++i) value.add(share[i], ribbon[i], ribbon[nearest]);
    value.add(centre, this->centre_weight);
    Out out;
    out.value = detail::saturated(value.result(ribbon[nearest]));
    if constexpr (Out::has_gradient) {
      // d/dB_i = -e share_i / B_i (w_i P_i - F); of the nearest side F - w_i P_i is the sum above, term by term.
      detail::GradientSum<Out> gradient;
      for (uint32_t i = 0; i < n; ++i) {
        const Out primary = of[primary_of(i)], bound = of[primary_of(i) + 1];
        gradient.add(share[i], algebraic_scaled(primary, this->side_weight[i]).gradient);
        if (sides.vanishes(i)) continue;
        const WideRange<S>& inverse = sides.inverse[i];
        WideSum<S> by_bound;
        if (i != nearest) {
          by_bound.add(inverse, out.value, ribbon[i]);
        } else {
          for (uint32_t j = 0; j < n; ++j) by_bound.add(share[j] * inverse, ribbon[j], ribbon[nearest]);
          by_bound.add(centre * inverse, this->centre_weight);
        }
        SignedWide<S> slope = by_bound.times(share[i] * WideRange<S>::whole(this->exponent));
        slope.negative = slope.negative != (bound.value < S{});
        gradient.add(slope, bound.gradient);
      }
      out.gradient = gradient.result();
    }
    return out;
  }

  constexpr Certificate<S> certificate(OperandCertificates<S> of, const TableFacts&, Reach<S>) const {
    using namespace detail;
    if (!this->valid(2)) return {};
    S ribbon{}, bound = algebraic_limit<S>();
    bool valid = true;
    for (uint32_t i = 0; i < this->side_count; ++i) {
      const AlgebraicBounds<S> primary = scaled_bounds(bounds_of(of[primary_of(i)]), this->side_weight[i]);
      ribbon = greatest_of_two(ribbon, primary.magnitude);
      bound = least_of_two(bound, of[primary_of(i) + 1].magnitude);
      valid = valid && of[primary_of(i)].valid && of[primary_of(i) + 1].valid;
    }
    if (!valid) return {};
    const S centre = product_up(power_up(bound, this->exponent), absolute(this->centre_weight));
    return patch_certificate(sum_up(ribbon, centre));
  }

 private:
  static constexpr int primary_of(uint32_t side) { return static_cast<int>(2 * side); }

  // (B_nearest / B_i)^e over the sum of them all; returns that of the nearest side.
  constexpr WideRange<S> shares_of(const detail::PatchSides<S>& sides, uint32_t nearest, WideRange<S>* share) const {
    const bool on_a_side = sides.vanishes(nearest);
    for (uint32_t i = 0; i < sides.count; ++i) {
      if (i == nearest || (on_a_side && sides.vanishes(i))) share[i] = WideRange<S>::whole(1);
      else share[i] = detail::power(sides.bound[nearest] * sides.inverse[i], this->exponent);
    }
    const WideRange<S> inverse = WideRange<S>::sum(share, sides.count).reciprocal();
    for (uint32_t i = 0; i < sides.count; ++i) share[i] = share[i] * inverse;
    return inverse;
  }
};

// Operands: C_1, ..., C_n, B_1, ..., B_n with C_k at the corner of the sides k and k + 1 (C_n: n and 1); n from 3 to 8.
// Weights as for ribbons. On side k the patch is the two-sided one of the corners at its ends with the side's weight
// w_k; at a corner it is C_k. Rounding: as for ribbons, and 2^-28 of what the weights add.
template <class S> struct CornerPatch : detail::PatchParameters<S> {
  using Scalar = S;
  static constexpr Kind kind = Kind::algebraic;
  static constexpr int fixed_operand_count = kAnyNumber;

  constexpr int operand_count() const {
    return this->side_count <= kGreatestSideCount ? static_cast<int>(2 * this->side_count) : 0;
  }

  template <class Out, class Operands> constexpr Out combine_all(const Operands& of) const {
    const uint32_t n = this->side_count;
    detail::PatchSides<S> sides;
    sides.count = n;
    S corner[kGreatestSideCount] = {};
    for (uint32_t k = 0; k < n; ++k) {
      corner[k] = Out(of[static_cast<int>(k)]).value;
      sides.set(k, Out(of[static_cast<int>(n + k)]).value);
    }
    Shares shares;
    shares.set(sides, this->exponent);
    const uint32_t nearest = shares.nearest;

    WideSum<S> value;
    for (uint32_t k = 0; k < n; ++k) {
      value.add(shares.corner[k], corner[k], corner[nearest]);
      value.add(shares.side[k], this->side_weight[k]);
    }
    value.add(shares.centre, this->centre_weight);
    Out out;
    out.value = detail::saturated(value.result(corner[nearest]));
    if constexpr (Out::has_gradient) {
      detail::GradientSum<Out> gradient;
      for (uint32_t k = 0; k < n; ++k) {
        const Out primary = of[static_cast<int>(k)], bound = of[static_cast<int>(n + k)];
        gradient.add(shares.corner[k], primary.gradient);
        if (sides.vanishes(k)) continue;
        const WideSum<S> by_one = by_bound(k, sides, shares, corner, out.value);
        SignedWide<S> slope = by_one.times(WideRange<S>::whole(this->exponent));
        slope.negative = slope.negative != (bound.value < S{});
        gradient.add(slope, bound.gradient);
      }
      out.gradient = gradient.result();
    }
    return out;
  }

  constexpr Certificate<S> certificate(OperandCertificates<S> of, const TableFacts&, Reach<S>) const {
    using namespace detail;
    if (!this->valid(3)) return {};
    const uint32_t n = this->side_count;
    S magnitude{}, added{}, bound_power[kGreatestSideCount] = {};
    bool valid = true;
    for (uint32_t k = 0; k < n; ++k) {
      magnitude = greatest_of_two(magnitude, of[k].magnitude);
      bound_power[k] = power_up(of[n + k].magnitude, this->exponent);
      valid = valid && of[k].valid && of[n + k].valid;
    }
    if (!valid) return {};
    S centre = algebraic_limit<S>();
    for (uint32_t k = 0; k < n; ++k) {
      const S before = bound_power[k > 0 ? k - 1 : n - 1], after = bound_power[k + 1 < n ? k + 1 : 0];
      added = sum_up(added, product_up(least_of_two(before, after), absolute(this->side_weight[k])));
      centre = least_of_two(centre, product_up(bound_power[k], after));
    }
    added = sum_up(added, product_up(centre, absolute(this->centre_weight)));
    return patch_certificate(sum_up(magnitude, added));
  }

 private:
  // What the corners, the sides' weights and the centre's weight are multiplied with.
  struct Shares {
    WideRange<S> corner[kGreatestSideCount];
    WideRange<S> side[kGreatestSideCount];
    WideRange<S> centre;
    uint32_t nearest = 0;  // the corner with the greatest share

    constexpr void set(const detail::PatchSides<S>& sides, uint32_t exponent) {
      // The reciprocal of both bounds' product, but for those that vanish; more of these go before.
      WideRange<S> inverse[kGreatestSideCount];
      uint32_t vanishing[kGreatestSideCount] = {};
      for (uint32_t k = 0; k < sides.count; ++k) {
        const uint32_t next = sides.next(k);
        vanishing[k] = (sides.vanishes(k) ? 1u : 0u) + (sides.vanishes(next) ? 1u : 0u);
        inverse[k] = without_zero(sides.inverse[k]) * without_zero(sides.inverse[next]);
        const bool nearer = vanishing[k] != vanishing[nearest] ? vanishing[k] > vanishing[nearest]
                                                               : inverse[nearest] < inverse[k];
        if (nearer) nearest = k;
      }
      const uint32_t after = sides.next(nearest);
      const WideRange<S> product = without_zero(sides.bound[nearest]) * without_zero(sides.bound[after]);
      for (uint32_t k = 0; k < sides.count; ++k) {
        if (k == nearest) corner[k] = WideRange<S>::whole(1);
        else if (vanishing[k] == vanishing[nearest]) corner[k] = detail::power(product * inverse[k], exponent);
      }
      const WideRange<S> inverse_sum = WideRange<S>::sum(corner, sides.count).reciprocal();
      for (uint32_t k = 0; k < sides.count; ++k) corner[k] = corner[k] * inverse_sum;
      // s_k over the sum: that of a corner at the side's end times the bound beyond it to the power e.
      for (uint32_t k = 0; k < sides.count; ++k) {
        const uint32_t before = sides.previous(k), next = sides.next(k);
        const bool by_previous = sides.bound[before] < sides.bound[next];
        side[k] = (by_previous ? corner[before] : corner[k]) *
                  detail::power(sides.bound[by_previous ? before : next], exponent);
      }
      if (vanishing[nearest] == 0) centre = corner[nearest] * detail::power(product, exponent);
    }
    static constexpr WideRange<S> without_zero(const WideRange<S>& x) {
      return x.is_zero() ? WideRange<S>::whole(1) : x;
    }
  };

  // dF/d|B_i| / e = -(share of the corners at its ends (C - F) + that of the side w_i) / B_i; where one of them is the
  // nearest, so that this cancels, the same of all others, which adds up to its negative.
  constexpr WideSum<S> by_bound(uint32_t i, const detail::PatchSides<S>& sides, const Shares& shares,
                                const S* corner, S value) const {
    const WideRange<S>& inverse = sides.inverse[i];
    const uint32_t before = sides.previous(i);
    WideSum<S> sum;
    if (shares.nearest == i || shares.nearest == before) {
      for (uint32_t k = 0; k < sides.count; ++k) {
        if (k != i && k != before) sum.add(shares.corner[k] * inverse, corner[k], value);
        if (k != i) sum.add(shares.side[k] * inverse, this->side_weight[k]);
      }
      sum.add(shares.centre * inverse, this->centre_weight);
    } else {
      sum.add(shares.corner[before] * inverse, value, corner[before]);
      sum.add(shares.corner[i] * inverse, value, corner[i]);
      sum.add(shares.side[i] * inverse, S{} - this->side_weight[i]);
    }
    return sum;
  }
};

}  // namespace nearfield
