// Sum of intensities (KW; Hsu): F = sum of c_i P_i. The weights are in the operands.
#pragma once

#include <nearfield/blend/additive.hpp>

namespace nearfield {

// Saturating sum; exact in range.
template <class S> struct SoftSum {
  using Scalar = S;
  static constexpr Kind kind = Kind::intensity;

  template <class Out> constexpr Out combine(const Out& a, const Out& b) const {
    Out out;
    out.value = a.value + b.value;
    if constexpr (Out::has_gradient) out.gradient = a.gradient + b.gradient;
    return out;
  }
  constexpr Certificate<S> certificate(const Certificate<S>& a, const Certificate<S>& b) const {
    return detail::worst_of(a, b);
  }
};

}  // namespace nearfield
