#pragma once

#include <nearfield/shape/operands.hpp>

namespace nearfield {

namespace detail {

// The certificate of a distance less up to `radius` metres, which are evaluated within `units` rounding units.
template <class S> constexpr Certificate<S> offset_certificate(const Certificate<S>& a, S radius, int units) {
  using T = ScalarTraits<S>;
  Certificate<S> moved = a;
  moved.magnitude = a.magnitude + absolute(radius);
  moved.error = a.error + T::times(T::rounding_unit(moved.magnitude), units);
  const S greatest_value = moved.magnitude + moved.erosion + moved.inflation + moved.error;
  moved.valid = a.valid && a.magnitude > S{} && greatest_value < T::greatest() && within(radius, -T::domain(), T::domain());
  return moved;
}

}  // namespace detail

// a - radius: a solid grown by `radius` metres on all sides, its edges rounded; shrunk by a negative one.
// |radius| <= domain. Exact where a is, of convex solids inside too. Elsewhere a lower bound: inside of what
// has dents, and about the edges of what was shrunk.
template <class S> struct Offset {
  using Scalar = S;
  static constexpr Kind kind = Kind::distance;
  static constexpr int fixed_operand_count = 1;
  S radius{};

  template <class Out> constexpr Out combine(const Out& a) const {
    Out out = a;
    out.value = subtract_in_range(a.value, radius);
    return out;
  }

  // Rounding units: radius 1/2; float: the difference 1/8 more.
  constexpr Certificate<S> certificate(OperandCertificates<S> operands, const TableFacts&, Reach<S>) const {
    return detail::offset_certificate(operands[0], radius, 1);
  }
};

}  // namespace nearfield
