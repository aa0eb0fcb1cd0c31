// A clearance for algebraic fields: a bound of the gradient over a declared box makes a distance of the value.
#pragma once

#include <nearfield/shape/algebraic_bounds.hpp>
#include <nearfield/shape/operands.hpp>

namespace nearfield {

// Of the field g of its operand, within the box |x| <= half.x ... about the local origin: g / L, L the Lipschitz constant
// that interval arithmetic finds over the box, but never farther from 0 than the box's surface is. Nowhere above the
// distance to g's surface, which may go on outside. Outside the box the value is 0: undecided, and no direction.
// Points are moved into the box before g is evaluated. Sharp set operations and frames take the result, other operations do
// not: blended with it, the 0 outside would count as a surface there.
template <class S> struct DeclaredBox {
  using Scalar = S;
  static constexpr Kind kind = Kind::distance;
  static constexpr Kind operand_kind = Kind::algebraic;
  Vector3<S> half;    // metres, each in (0, domain]
  Rate lipschitz;     // of g, per 1/16 m
  S inverse{};        // 1 / L, metres, rounded down

  constexpr DeclaredBox() = default;
  constexpr DeclaredBox(const Vector3<S>& half_extents, Rate rate) : half(half_extents), lipschitz(rate), inverse(inverse_of(rate)) {}

  constexpr Vector3<S> nearest_inside(const Vector3<S>& p) const {
    return {clamp(p.x, -half.x, half.x), clamp(p.y, -half.y, half.y), clamp(p.z, -half.z, half.z)};
  }

  // g at the nearest point inside, as a distance at p.
  template <class Out> constexpr Out at(const Vector3<S>& p, const Out& g) const {
    const S depths[3] = {subtract_in_range(half.x, absolute(p.x)), subtract_in_range(half.y, absolute(p.y)),
                         subtract_in_range(half.z, absolute(p.z))};
    const int axis = depths[0] < depths[1] ? (depths[0] < depths[2] ? 0 : 2) : (depths[1] < depths[2] ? 1 : 2);
    const S depth = depths[axis];
    Out out;
    if (!(depth > S{})) return out;
    const S distance = g.value * inverse;
    const bool outside = distance > S{};
    if (absolute(distance) < depth) {
      out.value = distance;
      if constexpr (Out::has_gradient) {
        out.gradient = {per_metre(g.gradient.x), per_metre(g.gradient.y), per_metre(g.gradient.z)};
      }
      return out;
    }
    out.value = outside ? depth : subtract_in_range(S{}, depth);
    if constexpr (Out::has_gradient) {
      const S one = ScalarTraits<S>::one();
      const S along = axis == 0 ? p.x : axis == 1 ? p.y : p.z;
      const S inwards = (along < S{}) == outside ? one : subtract_in_range(S{}, one);
      if (axis == 0) out.gradient.x = inwards;
      else if (axis == 1) out.gradient.y = inwards;
      else out.gradient.z = inwards;
    }
    return out;
  }

  constexpr bool half_valid() const { return valid_length(half.x) && valid_length(half.y) && valid_length(half.z); }
  constexpr bool valid() const {
    return half_valid() && lipschitz > Rate{} &&
           lipschitz != kNoRateBound && inverse == inverse_of(lipschitz) && inverse > S{};
  }
  // Of the points in the box.
  constexpr Reach<S> reach() const {
    return {length_of<S>(sum_of_squares(half.x, half.y, half.z)) + ScalarTraits<S>::rounding_unit(half.x + half.y + half.z)};
  }
  // `of`: the operand's over reach(); `around`: of the points that are asked about.
  constexpr Certificate<S> certificate(const Certificate<S>& of, Reach<S> around) const {
    Certificate<S> bounded;
    bounded.valid = of.valid && valid() && of.magnitude < algebraic_limit<S>() && of.lipschitz <= lipschitz;
    bounded.lipschitz = kUnitRate;
    bounded.partial = true;
    bounded.error = detail::sum_up(detail::product_up(of.error, inverse),
                                   ScalarTraits<S>::times(ScalarTraits<S>::rounding_unit(around.radius), 2));
    bounded.magnitude = of.valid ? greatest_of_two(half.x, greatest_of_two(half.y, half.z)) : S{};
    return bounded;
  }

 private:
  static constexpr S inverse_of(Rate rate) {
    if (!(rate > Rate{})) return {};
    if constexpr (ScalarTraits<S>::is_fixed) {
      // 1 / (16 raw / 2^24) in units of 2^-F.
      constexpr int bits = S::fraction_bits + 20;
      const int64_t quotient = (int64_t{1} << bits) / rate.raw();
      return S::from_raw(static_cast<typename S::Raw>(quotient < greatest_of<typename S::Raw> ? quotient : greatest_of<typename S::Raw>));
    } else {
      return 1048576.0f / static_cast<float>(rate.raw()) * 0.999999f;
    }
  }
  // component / L, from per 1/16 m.
  constexpr S per_metre(S component) const {
    if constexpr (ScalarTraits<S>::is_fixed) {
      ArithmeticStatus ignored;
      constexpr int shift = S::fraction_bits + kGradientLengthLog2;
      return S::saturate((product(component, inverse).raw + (int64_t{1} << (shift - 1))) >> shift, ignored);
    } else {
      return component * inverse * 16.0f;
    }
  }
};

}  // namespace nearfield
