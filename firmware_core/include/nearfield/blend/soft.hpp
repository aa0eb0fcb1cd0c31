// Sum of intensities (KW; Hsu): F = sum of c_i P_i. The weights are in the operands.
#pragma once

#include <nearfield/shape/operands.hpp>

namespace nearfield {

// Saturating sum; exact in range for Fixed. Where no weight is negative, a sum that leaves the number range is the
// greatest number; where some are, saturating would depend on the order, and the certificate is not valid.
template <class S> struct SoftSum {
  using Scalar = S;
  static constexpr Kind kind = Kind::intensity;
  static constexpr int fixed_operand_count = 2;
  static constexpr bool has_highest = true;

  template <class Out> constexpr Out combine(const Out& a, const Out& b) const {
    Out out;
    out.value = a.value + b.value;
    if constexpr (Out::has_gradient) out.gradient = a.gradient + b.gradient;
    return out;
  }
  constexpr Highest<S> highest(const Highest<S>& a, const Highest<S>& b, const Ball<S>&) const { return combine(a, b); }
  constexpr Certificate<S> certificate(OperandCertificates<S> of, const TableFacts&, Reach<S>) const {
    using T = ScalarTraits<S>;
    Certificate<S> sum = worst_of(of[0], of[1]);
    sum.lipschitz = of[0].lipschitz + of[1].lipschitz;
    sum.error = of[0].error + of[1].error;
    sum.magnitude = of[0].magnitude + of[1].magnitude;
    sum.below_zero = of[0].below_zero + of[1].below_zero;
    if (sum.below_zero > S{} && sum.magnitude >= T::greatest()) sum.valid = false;
    // The error of a float potential is at least 2^-18 of its greatest value (shape/soft.hpp), a sum's rounding at most
    // 2^-24 of its own.
    if constexpr (!T::is_fixed) sum.error = sum.error * 1.015625f;
    return sum;
  }
};

}  // namespace nearfield
