// Directions in a plane without an arctangent.
#pragma once

#include <nearfield/number/ratio.hpp>
#include <nearfield/table/table.hpp>

namespace nearfield {

// The direction of (a, b) as a fraction of a turn, in [0, 1): how many quarters it is beyond that of (1, 0), and of its own
// quarter the part of |a| + |b| that it has passed, |b| or |a|. A C1 function of the angle, with the same values and slopes at
// both ends of every quarter. Rounding: that of ratio(), a quarter of it.
template <class S> struct DiamondAngle {
  typename TableArgument<S>::type argument{};
  // Its gradient is (across_a, across_b) / (4 size). All is 0 where a and b are 0.
  Unit<S> across_a{}, across_b{};
  Reciprocal<S> size;  // |a| + |b|

  // x / (4 size) for any x; saturates.
  constexpr S quarter_of(S x) const {
    if constexpr (ScalarTraits<S>::is_fixed) {
      // Two fraction bits less are a quarter.
      using Coarse = Fixed<S::fraction_bits - 2>;
      const int32_t quarter = quotient<Coarse>(absolute(x), size).raw();
      return S::from_raw(x < S{} ? -quarter : quarter);
    } else {
      return x * size.inverse * 0.25f;
    }
  }
};

namespace detail {

template <int F> constexpr uint32_t size_of(Fixed<F> x) {
  return x.raw() < 0 ? 0u - static_cast<uint32_t>(x.raw()) : static_cast<uint32_t>(x.raw());
}

}  // namespace detail

template <bool with_slope, class S> constexpr DiamondAngle<S> diamond_angle(S a, S b) {
  DiamondAngle<S> angle;
  const bool upper = !(b < S{}) && (b > S{} || a > S{});
  const bool odd = upper ? !(a > S{}) : !(a < S{});  // the second and the fourth quarter
  const S passed = odd ? a : b;
  if constexpr (ScalarTraits<S>::is_fixed) {
    using U = Unit<S>;
    const uint32_t size = detail::size_of(a) + detail::size_of(b);
    if (size == 0) return angle;
    const uint32_t shift = static_cast<uint32_t>(leading_zeros(size));
    angle.size.mantissa = detail::normalised_reciprocal(size << shift);
    angle.size.shift = shift;
    const uint32_t part = multiply_high(detail::size_of(passed) << shift, angle.size.mantissa);  // as ratio(), Q31
    angle.argument = (upper ? 0u : 1u << 30) + (odd ? 1u << 29 : 0u) + (part >> 2);
    if constexpr (with_slope) {
      const int32_t done = static_cast<int32_t>(part >> 1), rest = (1 << 30) - done;
      const int32_t of_a = odd ? done : rest, of_b = odd ? rest : done;
      angle.across_a = U::from_raw(b < S{} ? of_b : -of_b);
      angle.across_b = U::from_raw(a < S{} ? -of_a : of_a);
    }
  } else {
    const float size = absolute(a) + absolute(b);
    if (!(size > 0.0f)) return angle;
    angle.size = reciprocal_of(size);
    const float turns = ((upper ? 0.0f : 2.0f) + (odd ? 1.0f : 0.0f) + ratio(absolute(passed), size)) * 0.25f;
    angle.argument = least_of_two(turns, 0.99999994f);
    if constexpr (with_slope) {
      angle.across_a = -(b * angle.size.inverse);
      angle.across_b = a * angle.size.inverse;
    }
  }
  return angle;
}

}  // namespace nearfield
