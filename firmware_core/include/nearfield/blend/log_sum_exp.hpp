// Log-sum-exp of any number of distances (AC): w_p(x_1 ... x_n) = ln(sum of e^(p x_i)) / p, in the stabilised form
// max + ln(sum of e^(p (x_i - max))) / p. In the distance convention: union -w_p(-x_i), intersection w_p(x_i), subtraction
// w_p(x_1, -x_2, ..., -x_n).
#pragma once

#include <nearfield/blend/sharp.hpp>
#include <nearfield/table/bake.hpp>

namespace nearfield {

namespace detail {

// Two functions in one table: 2^(-2u) in the lower half of the argument, log2(2u) in the upper one.
struct BinaryExponential {
  constexpr Differentiable operator()(const Differentiable& u) const {
    return u.value < 0.5 ? exp((-2.0 * kLn2) * u) : log(2.0 * u) * (1.0 / kLn2);
  }
  static constexpr double kLn2 = 0.693147180559945309417;
};
template <class S> inline constexpr Table<S, 64> kBinaryExponential = bake<S, 64>(BinaryExponential{});

// A number of [1/2, 1) in Q31 or float, from Q30 bits below the first one.
constexpr uint32_t upper_half_argument(uint32_t fraction, Fixed<30>) { return (1u << 30) + fraction; }
constexpr float upper_half_argument(uint32_t fraction, float) {
  return static_cast<float>((1u << 23) + (fraction >> 7)) * (1.0f / 16777216.0f);
}
constexpr uint32_t lower_half_argument(uint32_t fraction, Fixed<30>) { return fraction; }
constexpr float lower_half_argument(uint32_t fraction, float) {
  return static_cast<float>(fraction >> 7) * (1.0f / 16777216.0f);
}
constexpr int32_t to_q30(Fixed<30> x) { return x.raw(); }
constexpr int32_t to_q30(float x) { return static_cast<int32_t>(x * 1073741824.0f); }
constexpr Fixed<30> from_q30(int32_t q30, Fixed<30>) { return Fixed<30>::from_raw(q30); }
constexpr float from_q30(int32_t q30, float) { return static_cast<float>(q30) * (1.0f / 1073741824.0f); }

// In Q31, for a quantity in the scale's range.
template <class S> constexpr uint32_t q31_argument(const ArgumentScale<S>& scale, uint32_t quantity) {
  return scale.argument(quantity);
}
constexpr uint32_t q31_argument(const ArgumentScale<float>& scale, float quantity) {
  return static_cast<uint32_t>(scale.argument(quantity) * 2147483648.0f);
}

}  // namespace detail

// The sum is one of integers, so that the value does not depend on the operands' order, not even in the last bit.
// Operands farther than the range from the one that decides do not count: each is below 2^-31 of it there.
// 1 to 18 operands. Without a table of its own: all sharpnesses share one of 1 KiB.
template <class S, SetOperation operation> struct LogSumExp {
  using Scalar = S;
  static constexpr Kind kind = Kind::distance;
  static constexpr int fixed_operand_count = kAnyNumber;
  static constexpr int greatest_operand_count = 18;
  static constexpr double kRangeTimesSharpness = 32.0 * detail::BinaryExponential::kLn2;  // range = 22.18 / p

  ArgumentScale<S> scale;  // its limit is the range, metres
  uint32_t operands = 0;

  constexpr int operand_count() const { return operands <= greatest_operand_count ? static_cast<int>(operands) : 0; }

  template <class Out, class Operands> constexpr Out combine_all(const Operands& of) const {
    const int count = operand_count();
    int first = 0;
    Out deciding = seen(of[0], 0);
    for (int i = 1; i < count; ++i) {
      const Out x = seen(of[i], i);
      if (decides_over(x.value, deciding.value)) {
        deciding = x;
        first = i;
      }
    }
    uint32_t shares[greatest_operand_count] = {};  // Q30
    uint64_t others = 0;
    for (int i = 0; i < count; ++i) {
      if (i != first) shares[i] = share_of(seen(of[i], i).value, deciding.value);
      others += shares[i];
    }
    if (others == 0) return deciding;
    const uint64_t sum = kOne + others;
    const int doublings = 33 - leading_zeros(sum);
    const uint32_t fraction = static_cast<uint32_t>(sum >> doublings) - kOne;
    const auto table = detail::kBinaryExponential<S>.view();
    const TableSample<S> logarithm =
        sample_table<Out::has_gradient>(table, detail::upper_half_argument(fraction, Unit<S>{}));
    const int32_t log2 = static_cast<int32_t>(((static_cast<int64_t>(doublings) << 30) + detail::to_q30(logarithm.value)) >> 5);
    const S added = narrow_in_range<S>(product(scale.limit, detail::from_q30(log2, Unit<S>{})));
    Out out;
    out.value = operation == SetOperation::unite ? deciding.value - added : deciding.value + added;
    if constexpr (Out::has_gradient) {
      // Of log2(2u), the slope is 1 / (u ln 2): the reciprocal of the sum.
      const int32_t reciprocal = detail::to_q30(narrow_in_range<Unit<S>>(product(logarithm.slope, kHalfLn2)));
      out.gradient = mean<Out>(of, shares, deciding, reciprocal, doublings);
    }
    return out;
  }

  // A mean of the operands that decide: error that of the worst, and 2^-27 of the range, and 2 units.
  constexpr Certificate<S> certificate(OperandCertificates<S> of, const TableFacts&, Reach<S> reach) const {
    using T = ScalarTraits<S>;
    const int count = operand_count();
    Certificate<S> all = of[0];
    for (int i = 1; i < count; ++i) {
      const Certificate<S> two[2] = {all, of[i]};
      all = Sharp<S, operation>{}.certificate(two, {}, reach);
    }
    all.valid = all.valid && count >= 1 && scale.consistent() && scale.limit <= T::domain();
    all.lipschitz = T_rate::multiply_up(all.lipschitz, Rate::from_raw(kUnitRate.raw() + 2));
    all.error = all.error + T::multiply_up(scale.limit, Rate::from_raw(1)) + T::times(T::rounding_unit(reach.radius), 2);
    const S added = T::multiply_up(scale.limit, log2_of_count(count));
    if constexpr (operation == SetOperation::unite) all.inflation = all.inflation + added;
    else all.erosion = all.erosion + added;
    return all;
  }

 private:
  using T_rate = ScalarTraits<Rate>;
  static constexpr uint32_t kOne = 1u << 30;
  static constexpr Unit<S> kHalfLn2 = detail::from_q30(372130559, Unit<S>{});

  // As the maximum sees it, but for unions, where the least decides.
  template <class Out> static constexpr Out seen(const Out& x, int i) {
    return operation == SetOperation::subtract && i != 0 ? detail::negated(x) : x;
  }
  static constexpr bool decides_over(S a, S b) { return operation == SetOperation::unite ? a < b : b < a; }

  // e^(p (x - max)) in Q30, 2^(-32 gap / range).
  constexpr uint32_t share_of(S value, S deciding) const {
    const auto gap = detail::gap<operation>(deciding, value);
    if (!scale.contains(gap)) return 0;
    const uint32_t halvings = detail::q31_argument(scale, gap);  // Q26
    const uint32_t fraction = (halvings << 4) & (kOne - 1);
    const auto table = detail::kBinaryExponential<S>.view();
    const auto share = sample_table<false>(table, detail::lower_half_argument(fraction, Unit<S>{})).value;
    return static_cast<uint32_t>(detail::to_q30(share)) >> (halvings >> 26);
  }

  // Sum of weight * gradient; the weights are shares over the sum, that of the deciding operand what is left to 1.
  template <class Out, class Operands>
  constexpr Vector3<S> mean(const Operands& of, const uint32_t* shares, const Out& deciding, int32_t reciprocal, int doublings) const {
    Vector3<S> sum = deciding.gradient;
    for (int i = 0; i < operand_count(); ++i) {
      if (shares[i] == 0) continue;
      const int64_t exact = static_cast<int64_t>(shares[i]) * reciprocal;
      const Unit<S> weight = detail::from_q30(static_cast<int32_t>(exact >> (30 + doublings)), Unit<S>{});
      sum = add_in_range(sum, scaled_in_range(subtract_in_range(seen(of[i], i).gradient, deciding.gradient), weight));
    }
    return sum;
  }

  // log2(count) / 32, rounded up.
  static constexpr Rate log2_of_count(int count) {
    constexpr int32_t rounded_up[greatest_operand_count] = {0, 524288, 830977, 1048576, 1217360, 1355265,
                                                            1471863, 1572865, 1661954, 1741648, 1813739, 1879553,
                                                            1940097, 1996151, 2048336, 2097152, 2143008, 2186242};
    return count < 1 ? Rate{} : Rate::from_raw(rounded_up[count - 1]);
  }
};

template <class S> using LogSumExpUnion = LogSumExp<S, SetOperation::unite>;
template <class S> using LogSumExpIntersection = LogSumExp<S, SetOperation::intersect>;
template <class S> using LogSumExpSubtraction = LogSumExp<S, SetOperation::subtract>;

}  // namespace nearfield
