// Sum of intensities (KW; Hsu): F = sum of c_i P_i. The weights are in the operands.
#pragma once

#include <nearfield/shape/operands.hpp>

namespace nearfield {

// Saturating sum; exact in range.
template <class S> struct SoftSum {
  using Scalar = S;
  static constexpr Kind kind = Kind::intensity;
  static constexpr int fixed_operand_count = 2;

  template <class Out> constexpr Out combine(const Out& a, const Out& b) const {
    Out out;
    out.value = a.value + b.value;
    if constexpr (Out::has_gradient) out.gradient = a.gradient + b.gradient;
    return out;
  }
  constexpr Certificate<S> certificate(OperandCertificates<S> of, const TableFacts&, Reach<S>) const {
    return worst_of(of[0], of[1]);
  }
};

}  // namespace nearfield
