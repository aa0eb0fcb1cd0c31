#pragma once

#include <nearfield/number/ratio.hpp>

namespace nearfield {

// A sum of products of two numbers over a number, given by its reciprocal: 64 by 32 bits without a division.
// Rounded half up; saturates at plus and minus the greatest number. Error: half a unit in the last place and
// the quotient's 2^-30th part. Sums below 2^62 in magnitude.
template <int F>
constexpr Fixed<F> quotient_of_products(int64_t sum, const Reciprocal<Fixed<F>>& divisor) {
  const int32_t high = static_cast<int32_t>(sum >> 32);
  const uint32_t low = static_cast<uint32_t>(static_cast<uint64_t>(sum));
  // 1 / raw = mantissa / 2^(63 - shift).
  const int64_t scaled = static_cast<int64_t>(high) * static_cast<int64_t>(divisor.mantissa) +
                         static_cast<int64_t>(multiply_high(low, divisor.mantissa));
  const int drop = static_cast<int>((31u - divisor.shift) & 31u);
  const int64_t result = (scaled + (int64_t{1} << drop >> 1)) >> drop;
  if (result > greatest_of<int32_t>) return Fixed<F>::greatest();
  if (result < -greatest_of<int32_t>) return -Fixed<F>::greatest();
  return Fixed<F>::from_raw(static_cast<int32_t>(result));
}
template <int F, int W>
constexpr Fixed<F> quotient_of_products(WideProduct<W, int32_t> sum, const Reciprocal<Fixed<F>>& divisor) {
  static_assert(W == 2 * F, "products of two numbers of the divisor's type");
  return quotient_of_products(sum.raw, divisor);
}
// One IEEE product.
constexpr float quotient_of_products(float sum, const Reciprocal<float>& divisor) {
  return sum * divisor.inverse;
}

}  // namespace nearfield
