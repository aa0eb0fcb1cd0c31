// Blends B(x, y) = max(x, y) + h(|x - y|) of distances: h = 0 gives the sharp set operations, a tabulated h Li's
// exterior blend (Li, equations 20 to 23). Union, intersection and subtraction in the distance convention:
// union -B(-x, -y), intersection B(x, y), subtraction B(x, -y).
#pragma once

#include <nearfield/shape/certificate.hpp>
#include <nearfield/shape/sample.hpp>
#include <nearfield/table/table.hpp>

namespace nearfield {

enum class SetOperation : uint8_t { unite, intersect, subtract };

namespace detail {

// The operand that decides and the other one, as B sees them: the nearer one for a union, otherwise the farther; a
// subtraction's second operand negated. On ties the first decides.
template <class Out> struct Ordered {
  Out deciding, other;
};
template <SetOperation operation, class Out> constexpr Ordered<Out> ordered(const Out& a, const Out& b) {
  Out second = b;
  if constexpr (operation == SetOperation::subtract) {
    using S = typename Out::Scalar;
    second.value = subtract_in_range(S{}, b.value);
    if constexpr (Out::has_gradient) second.gradient = subtract_in_range(Vector3<S>{}, b.gradient);
  }
  const bool first_decides = operation == SetOperation::unite ? !(second.value < a.value) : !(a.value < second.value);
  return first_decides ? Ordered<Out>{a, second} : Ordered<Out>{second, a};
}

template <class S> constexpr Certificate<S> worst_of(const Certificate<S>& a, const Certificate<S>& b) {
  Certificate<S> both;
  both.valid = a.valid && b.valid;
  both.lipschitz = greatest_of_two(a.lipschitz, b.lipschitz);
  both.erosion = greatest_of_two(a.erosion, b.erosion);
  both.inflation = greatest_of_two(a.inflation, b.inflation);
  both.error = greatest_of_two(a.error, b.error);
  return both;
}

}  // namespace detail

// Sharp set operation: the nearer (union) or farther operand as it is. Exact: no rounding of its own.
// On ties the first operand's gradient.
template <class S, SetOperation operation> struct Sharp {
  using Scalar = S;
  static constexpr Kind kind = Kind::distance;

  template <class Out> constexpr Out combine(const Out& a, const Out& b) const {
    return detail::ordered<operation>(a, b).deciding;
  }
  constexpr Certificate<S> certificate(const Certificate<S>& a, const Certificate<S>& b) const {
    Certificate<S> both = detail::worst_of(a, b);
    // What is cut away by an eroded tool is too little: the roles of erosion and inflation swap for it.
    if constexpr (operation == SetOperation::subtract) {
      both.erosion = greatest_of_two(a.erosion, b.inflation);
      both.inflation = greatest_of_two(a.inflation, b.erosion);
    }
    return both;
  }
};

// Li's exterior blend: the sharp operation plus h(|x - y|) where the operands are closer than the range
// delta + epsilon; exactly the sharp operation elsewhere. h = range * table(|x - y| / range).
template <class S, SetOperation operation> struct Exterior {
  using Scalar = S;
  static constexpr Kind kind = Kind::distance;
  ArgumentScale<S> scale;  // its limit is the range, metres

  template <class Out> constexpr Out combine(const Out& a, const Out& b, const TableView<S>& kernel) const {
    const detail::Ordered<Out> operands = detail::ordered<operation>(a, b);
    const Out& deciding = operands.deciding;
    const Out& other = operands.other;
    const auto gap = operation == SetOperation::unite ? difference_magnitude(other.value, deciding.value)
                                                      : difference_magnitude(deciding.value, other.value);
    if (!scale.contains(gap)) return deciding;
    const TableSample<S> h = sample_table<Out::has_gradient>(kernel, scale.argument(gap));
    const S added = narrow_in_range<S>(product(scale.limit, h.value));
    Out out;
    out.value = operation == SetOperation::unite ? deciding.value - added : deciding.value + added;
    if constexpr (Out::has_gradient) {
      const Vector3<S> &d = deciding.gradient, &o = other.gradient;
      out.gradient = {mixed(d.x, o.x, h.slope), mixed(d.y, o.y, h.slope), mixed(d.z, o.z, h.slope)};
    }
    return out;
  }

  // With d = |1 + h'| + |h'| <= 1 + 2 b: error d max(e) + range * table error + 2 rounding units.
  constexpr Certificate<S> certificate(const Certificate<S>& a, const Certificate<S>& b, const TableFacts& facts,
                                       S reach) const {
    using T = ScalarTraits<S>;
    const Sharp<S, operation> sharp;
    Certificate<S> both = sharp.certificate(a, b);
    both.valid = both.valid && scale.consistent() && scale.limit <= T::domain() && facts.error >= 0 && facts.error < (1 << 24);
    const Rate spread = spread_of(facts);
    both.lipschitz = multiply_rates_up(both.lipschitz, spread);
    both.valid = both.valid && both.lipschitz < kSteepest;
    const S added = T::multiply_up(scale.limit, rate_up(facts.greatest_value));
    const S removed = T::multiply_up(scale.limit, rate_up(-int64_t{facts.least_value}));
    both.error = T::multiply_up(both.error, spread) + T::multiply_up(scale.limit, rate_up(facts.error)) +
                 T::times(T::rounding_unit(reach), 2);
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

  // (1 + slope) deciding - slope other; gradients are at most a few units long.
  static constexpr S mixed(S deciding, S other, S slope) {
    return add_in_range(deciding, narrow_in_range<S>(product(slope, subtract_in_range(deciding, other))));
  }

  // high - low >= 0, exact even where S has no room for it.
  template <int F, class R> static constexpr uint32_t difference_magnitude(Fixed<F, R> high, Fixed<F, R> low) {
    return static_cast<uint32_t>(high.raw()) - static_cast<uint32_t>(low.raw());
  }
  static constexpr float difference_magnitude(float high, float low) { return high - low; }

  // A non-negative Q30 bound as a rate, rounded up; 0 for negative ones.
  static constexpr Rate rate_up(int64_t q30) {
    return Rate::from_raw(q30 <= 0 ? 0 : static_cast<int32_t>((q30 >> 6) + 1));
  }
  // |1 + h'| + |h'| at its greatest.
  static constexpr Rate spread_of(const TableFacts& facts) {
    const int64_t above = facts.greatest_slope, below = -int64_t{kUnitRate.raw()} - facts.least_slope;
    const int64_t outside = above > below ? above : below;
    ArithmeticStatus ignored;
    return Rate::saturate(int64_t{kUnitRate.raw()} + (outside > 0 ? 2 * outside : 0), ignored);
  }
  static constexpr Rate multiply_rates_up(Rate a, Rate b) { return ScalarTraits<Rate>::multiply_up(a, b); }
};

}  // namespace nearfield
