// Powers with any exponent without pow: logarithms to base 2 and back, and in between the norm (x^n +
// y^n)^(1/n) of two numbers. One pair of tables, 1.5 KiB, for all scalars and exponents.
#pragma once

#include <nearfield/number/ratio.hpp>
#include <nearfield/table/bake.hpp>

namespace nearfield {

// Logarithms to base 2 are integers in Q26; this one stands for that of 0.
inline constexpr int kLog2FractionBits = 26;
inline constexpr int32_t kLog2One = 1 << kLog2FractionBits;
inline constexpr int32_t kLog2OfZero = least_of<int32_t>;

namespace detail {

inline constexpr double kLn2 = 0.693147180559945309417;
struct BinaryLogarithm {
  constexpr Differentiable operator()(const Differentiable& u) const { return log(1.0 + u) * (1.0 / kLn2); }
};
struct HalvedBinaryPower {
  constexpr Differentiable operator()(const Differentiable& u) const { return exp(kLn2 * (u - 1.0)); }
};
inline constexpr Table<Fixed<27>, 64> kBinaryLogarithm = bake<Fixed<27>, 64>(BinaryLogarithm{});
inline constexpr Table<Fixed<27>, 32> kHalvedBinaryPower = bake<Fixed<27>, 32>(HalvedBinaryPower{});

// log2(1 + fraction), Q30, of a fraction in Q31.
constexpr int32_t log2_of_one_and(uint32_t fraction) {
  return sample_raw<false>(kBinaryLogarithm.view(), fraction).value;
}
// 2^(fraction - 1), Q30, of a logarithm's fraction; below 1.
constexpr uint32_t halved_power_of(int32_t log2) {
  const uint32_t fraction = static_cast<uint32_t>(log2) & (static_cast<uint32_t>(kLog2One) - 1);
  const int32_t power =
      sample_raw<false>(kHalvedBinaryPower.view(), fraction << (31 - kLog2FractionBits)).value;
  return static_cast<uint32_t>(least_of_two<int32_t>(power, (1 << 30) - 1));
}

}  // namespace detail

// Rounding: three quarters of a unit of 2^-26. kLog2OfZero for x <= 0, and for a float below 2^-26.
// Not in line: beside each other compilers share the table's places, and then multiply by parts.
template <int F>
[[gnu::noinline]] constexpr int32_t log2_of(Fixed<F> x) {
  if (x.raw() <= 0) return kLog2OfZero;
  const uint32_t raw = static_cast<uint32_t>(x.raw());
  const int shift = leading_zeros(raw);
  const int32_t fraction = detail::log2_of_one_and((raw << shift) & 0x7fffffffu);
  return shift_left(31 - shift - F, kLog2FractionBits) + ((fraction + 8) >> (30 - kLog2FractionBits));
}
[[gnu::noinline]] constexpr int32_t log2_of(float x) {
  if (!(x >= 1.0f / (1 << 26))) return kLog2OfZero;
  const uint32_t bits = bits_as<uint32_t>(x < 2147483648.0f ? x : 2147483648.0f);
  const int32_t fraction = detail::log2_of_one_and((bits << 8) & 0x7fffffffu);
  return shift_left(static_cast<int32_t>(bits >> 23) - 127, kLog2FractionBits) +
         ((fraction + 8) >> (30 - kLog2FractionBits));
}

// 2^log2, saturating. Rounding: half a unit in the last place (float: one) and the result's 2^-28th part.
template <class To>
constexpr To exp2_of(int32_t log2) {
  const int whole = log2 >> kLog2FractionBits;
  if constexpr (ScalarTraits<To>::is_fixed) {
    constexpr int F = To::fraction_bits;
    static_assert(F <= 28, "numbers up to 4 at least");
    if (whole >= 31 - F) return To::greatest();
    const uint32_t power = detail::halved_power_of(log2);
    const int down = 29 - F - whole;
    if (down < 0) return To::from_raw(static_cast<int32_t>(power << 1));
    return down > 31 ? To() : To::from_raw(static_cast<int32_t>((power + ((1u << down) >> 1)) >> down));
  } else {
    const float scale = bits_as<float>(static_cast<uint32_t>(whole + (127 + 1 - 30)) << 23);
    return static_cast<float>(detail::halved_power_of(log2)) * scale;
  }
}
// The same of a sum of logarithms that may leave their range.
template <class To>
constexpr To exp2_of_sum(int64_t log2) {
  constexpr int64_t least = -int64_t{kLog2One} * 32, greatest = int64_t{kLog2One} * 32 - 1;
  return exp2_of<To>(static_cast<int32_t>(clamp(log2, least, greatest)));
}

// The exponent n of a norm, 0.2 to 64.
struct NormExponent {
  Rate n;
  Fixed<28> inverse;

  constexpr NormExponent() = default;
  constexpr NormExponent(Rate exponent)  // NOLINT: implicit, so that exponents read as numbers
      : n(exponent), inverse(Fixed<28>::from_raw(inverse_of(exponent))) {}
  constexpr bool valid() const {
    return n.raw() >= kLeast && n.raw() <= 64 << Rate::fraction_bits && inverse.raw() == inverse_of(n);
  }
  constexpr bool is_convex() const { return n.raw() >= 1 << Rate::fraction_bits; }
  // How far a norm's logarithm may be off, in units of 2^-26, beyond what its operands' are: roundings 2 and
  // 1/n, the exponent's own 3.1 / n^2.
  constexpr int32_t error_units() const {
    const int32_t up = ((inverse.raw() - 1) >> 28) + 1;
    return 2 + up + 4 * up * up;
  }

 private:
  static constexpr int32_t kLeast = 3355443;  // 0.2
  static constexpr int32_t inverse_of(Rate n) {
    return n.raw() < kLeast ? 0 : static_cast<int32_t>((((int64_t{1} << 53) / n.raw()) + 1) >> 1);
  }
};

// The logarithm of the norm N(x, y) = (x^n + y^n)^(1/n) of two numbers, and those of x dN/dx / N and y dN/dy
// / N.
struct LogarithmOfNorm {
  int32_t log2 = kLog2OfZero;
  int32_t first_share = kLog2OfZero;
  int32_t second_share = kLog2OfZero;
};
// Of the logarithms of x and y, each within +-24 or kLog2OfZero.
constexpr LogarithmOfNorm log2_of_norm(int32_t x, int32_t y, const NormExponent& exponent) {
  const bool first_is_greater = y <= x;
  const int32_t greater = first_is_greater ? x : y, lesser = first_is_greater ? y : x;
  LogarithmOfNorm norm;
  norm.log2 = greater;
  int32_t of_greater = 0, of_lesser = kLog2OfZero;
  const uint32_t gap = static_cast<uint32_t>(greater) - static_cast<uint32_t>(lesser);
  const uint64_t halvings =
      (static_cast<uint64_t>(gap) * static_cast<uint32_t>(exponent.n.raw()) + (1u << 23)) >>
      Rate::fraction_bits;
  if (lesser != kLog2OfZero && halvings < uint64_t{31} << kLog2FractionBits) {
    const int32_t fallen = -static_cast<int32_t>(halvings);  // log2 of (lesser / greater)^n
    const uint32_t power = (detail::halved_power_of(fallen) << 2) >> -(fallen >> kLog2FractionBits);
    const int32_t sum = detail::log2_of_one_and(least_of_two<uint32_t>(power, 0x7fffffffu));  // Q30
    norm.log2 = wrapping_add(
        greater,
        shift_right_to_32<32>(static_cast<int64_t>(sum) * exponent.inverse.raw() + (int64_t{1} << 31)));
    of_greater = -((sum + 8) >> (30 - kLog2FractionBits));
    of_lesser = fallen + of_greater;
  }
  norm.first_share = first_is_greater ? of_greater : of_lesser;
  norm.second_share = first_is_greater ? of_lesser : of_greater;
  return norm;
}

}  // namespace nearfield
