// Sharp set operations: min and max of fields.
#pragma once

#include <nearfield/shape/operands.hpp>

namespace nearfield {

enum class SetOperation : uint8_t { unite, intersect, subtract };

namespace detail {

// The operand that decides and the other one, as a maximum B sees them: the nearer one for a union, otherwise the
// farther; a subtraction's second operand negated. On ties the first decides.
template <class Out> struct Ordered {
  Out deciding, other;
  bool first_decides;
};
template <SetOperation operation, class Out> constexpr Ordered<Out> ordered(const Out& a, const Out& b) {
  Out second = b;
  if constexpr (operation == SetOperation::subtract) {
    using S = typename Out::Scalar;
    second.value = subtract_in_range(S{}, b.value);
    if constexpr (Out::has_gradient) second.gradient = subtract_in_range(Vector3<S>{}, b.gradient);
  }
  const bool first_decides = operation == SetOperation::unite ? !(second.value < a.value) : !(a.value < second.value);
  return first_decides ? Ordered<Out>{a, second, true} : Ordered<Out>{second, a, false};
}

// Whether the first operand decides: the nearer one for a union, otherwise the farther. On ties it does.
template <SetOperation operation, class S> constexpr bool first_decides(S a, S b) {
  return operation == SetOperation::unite ? !(b < a) : !(a < b);
}

// A subtraction's second operand as a maximum sees it.
template <class Out> constexpr Out negated(Out x) {
  using S = typename Out::Scalar;
  x.value = subtract_in_range(S{}, x.value);
  if constexpr (Out::has_gradient) x.gradient = subtract_in_range(Vector3<S>{}, x.gradient);
  return x;
}

// high - low >= 0 in units of the last place, exact even where S has no room for it.
template <int F, class R> constexpr uint32_t difference_magnitude(Fixed<F, R> high, Fixed<F, R> low) {
  return static_cast<uint32_t>(high.raw()) - static_cast<uint32_t>(low.raw());
}
constexpr float difference_magnitude(float high, float low) { return high - low; }

// How far the deciding operand is ahead of another.
template <SetOperation operation, class S> constexpr auto gap(S deciding, S other) {
  return operation == SetOperation::unite ? difference_magnitude(other, deciding) : difference_magnitude(deciding, other);
}

}  // namespace detail

// The nearer (union) or farther operand as it is. Exact: no rounding of its own. On ties the first operand's gradient.
// Intensities are larger inside: their union is the larger. Only distances can be subtracted.
template <class S, SetOperation operation, Kind field_kind = Kind::distance> struct Sharp {
  static_assert(operation != SetOperation::subtract || field_kind == Kind::distance, "only distances change sign inside");
  using Scalar = S;
  static constexpr Kind kind = field_kind;
  static constexpr int fixed_operand_count = 2;
  static constexpr bool takes_partial = kind == Kind::distance;
  static constexpr bool has_highest = kind == Kind::intensity;

  template <class Out> constexpr Out combine(const Out& a, const Out& b) const {
    constexpr bool larger_inside = kind == Kind::intensity;
    constexpr SetOperation by_value = !larger_inside                         ? operation
                                      : operation == SetOperation::unite ? SetOperation::intersect
                                                                             : SetOperation::unite;
    if constexpr (operation == SetOperation::subtract) {
      const Out second = detail::negated(b);
      return detail::first_decides<by_value>(a.value, second.value) ? a : second;
    } else {
      const bool first = detail::first_decides<by_value>(a.value, b.value);
      if constexpr (Out::has_gradient) return first ? a : b;
      else return {first ? a.value : b.value};
    }
  }
  constexpr Highest<S> highest(const Highest<S>& a, const Highest<S>& b, const Ball<S>&) const { return combine(a, b); }
  constexpr Certificate<S> certificate(OperandCertificates<S> of, const TableFacts&, Reach<S>) const {
    Certificate<S> both = worst_of(of[0], of[1]);
    const bool bounded = kind == Kind::algebraic || (of[0].magnitude > S{} && of[1].magnitude > S{});
    both.magnitude = bounded ? greatest_of_two(of[0].magnitude, of[1].magnitude) : S{};
    // What is cut away by an eroded tool is too little: the roles of erosion and inflation swap for it.
    if constexpr (operation == SetOperation::subtract) {
      both.erosion = greatest_of_two(of[0].erosion, of[1].inflation);
      both.inflation = greatest_of_two(of[0].inflation, of[1].erosion);
    }
    return both;
  }
};

template <class S> using SharpUnion = Sharp<S, SetOperation::unite>;
template <class S> using SharpIntersection = Sharp<S, SetOperation::intersect>;
template <class S> using SharpSubtraction = Sharp<S, SetOperation::subtract>;
template <class S> using IntensityUnion = Sharp<S, SetOperation::unite, Kind::intensity>;
template <class S> using IntensityIntersection = Sharp<S, SetOperation::intersect, Kind::intensity>;
template <class S> using RayUnion = Sharp<S, SetOperation::unite, Kind::ray>;
template <class S> using RayIntersection = Sharp<S, SetOperation::intersect, Kind::ray>;
template <class S> using AlgebraicUnion = Sharp<S, SetOperation::unite, Kind::algebraic>;
template <class S> using AlgebraicIntersection = Sharp<S, SetOperation::intersect, Kind::algebraic>;

}  // namespace nearfield
