// Fixed-point numbers. Exact semantics: SPEC.md, "Numbers".
#pragma once

#include <nearfield/number/integer.hpp>

namespace nearfield {

// Sticky record of what went wrong in a sequence of operations. Passed explicitly: there is no hidden state.
struct ArithmeticStatus {
  bool saturated = false;  // a result left the number range, or a division by zero, and was replaced by the nearest end
};

template <int FractionBits, class RawType> struct WideProduct;

// A number raw / 2^FractionBits, raw a two's complement integer of 8, 16 or 32 bits.
// Operators saturate at the ends of the range; products and quotients are rounded once, half up (floor(x + 1/2)).
// Nothing here is undefined for any operand, and nothing depends on the compiler, its options or the machine.
template <int FractionBits, class RawType = int32_t> class Fixed {
 public:
  static constexpr int fraction_bits = FractionBits;
  static constexpr int width = static_cast<int>(sizeof(RawType)) * 8;
  static_assert(FractionBits >= 0 && FractionBits < width, "the fraction must leave room for the sign");
  using Raw = RawType;
  using WideRaw = typename WideOf<RawType>::type;

  constexpr Fixed() = default;

  // Nearest number to a real one, half up; saturates, and NaN becomes the least number (which no validation accepts).
  // For constants: on a target use it only where the compiler evaluates it, as a `double` never belongs there.
  constexpr Fixed(double real) : raw_(raw_of(real)) {}  // NOLINT: implicit on purpose, so that {0.1, 0.2} reads well

  static constexpr Fixed from_raw(Raw raw) {
    Fixed result;
    result.raw_ = raw;
    return result;
  }
  static constexpr Fixed greatest() { return from_raw(greatest_of<Raw>); }
  static constexpr Fixed least() { return from_raw(least_of<Raw>); }
  static constexpr Fixed unit_in_last_place() { return from_raw(1); }

  constexpr Raw raw() const { return raw_; }
  constexpr double to_double() const { return static_cast<double>(raw_) / static_cast<double>(int64_t{1} << FractionBits); }

  friend constexpr bool operator==(Fixed a, Fixed b) { return a.raw_ == b.raw_; }
  friend constexpr bool operator!=(Fixed a, Fixed b) { return a.raw_ != b.raw_; }
  friend constexpr bool operator<(Fixed a, Fixed b) { return a.raw_ < b.raw_; }
  friend constexpr bool operator>(Fixed a, Fixed b) { return a.raw_ > b.raw_; }
  friend constexpr bool operator<=(Fixed a, Fixed b) { return a.raw_ <= b.raw_; }
  friend constexpr bool operator>=(Fixed a, Fixed b) { return a.raw_ >= b.raw_; }

  friend constexpr Fixed operator+(Fixed a, Fixed b) {
    ArithmeticStatus ignored;
    return add(a, b, ignored);
  }
  friend constexpr Fixed operator-(Fixed a, Fixed b) {
    ArithmeticStatus ignored;
    return subtract(a, b, ignored);
  }
  friend constexpr Fixed operator*(Fixed a, Fixed b) {
    ArithmeticStatus ignored;
    return multiply(a, b, ignored);
  }
  friend constexpr Fixed operator-(Fixed a) { return Fixed() - a; }

  // Brings an integer with FractionBits fraction bits into range; notes in `status` when it had to be clipped.
  static constexpr Fixed saturate(int64_t raw, ArithmeticStatus& status) {
    if (raw > greatest_of<Raw>) {
      status.saturated = true;
      return greatest();
    }
    if (raw < least_of<Raw>) {
      status.saturated = true;
      return least();
    }
    return from_raw(static_cast<Raw>(raw));
  }

 private:
  static constexpr Raw raw_of(double real) {
    const double scaled = real * static_cast<double>(int64_t{1} << FractionBits);
    if (!(scaled > static_cast<double>(least_of<Raw>))) return least_of<Raw>;
    if (scaled >= static_cast<double>(greatest_of<Raw>)) return greatest_of<Raw>;
    const int64_t towards_zero = static_cast<int64_t>(scaled);
    const int64_t down = towards_zero - (static_cast<double>(towards_zero) > scaled ? 1 : 0);
    return static_cast<Raw>(down + (scaled - static_cast<double>(down) >= 0.5 ? 1 : 0));
  }

  Raw raw_ = 0;
};

// The exact product of two fixed-point numbers, or a sum of such products: 64 bits for 32-bit factors.
// Sums wrap modulo 2^width; a caller adds only what its contract keeps in range.
template <int FractionBits, class RawType> struct WideProduct {
  using Raw = typename WideOf<RawType>::type;
  Raw raw = 0;

  friend constexpr WideProduct operator+(WideProduct a, WideProduct b) { return {wrapping_add(a.raw, b.raw)}; }
  friend constexpr WideProduct operator-(WideProduct a, WideProduct b) { return {wrapping_subtract(a.raw, b.raw)}; }
};

// Saturating sum, difference, product and quotient that report saturation. Sum and difference are exact in range.
template <int F, class R> constexpr Fixed<F, R> add(Fixed<F, R> a, Fixed<F, R> b, ArithmeticStatus& status) {
  R sum{};
  if (!__builtin_add_overflow(a.raw(), b.raw(), &sum)) return Fixed<F, R>::from_raw(sum);
  status.saturated = true;
  return a.raw() < 0 ? Fixed<F, R>::least() : Fixed<F, R>::greatest();
}
template <int F, class R> constexpr Fixed<F, R> subtract(Fixed<F, R> a, Fixed<F, R> b, ArithmeticStatus& status) {
  R difference{};
  if (!__builtin_sub_overflow(a.raw(), b.raw(), &difference)) return Fixed<F, R>::from_raw(difference);
  status.saturated = true;
  return a.raw() < 0 ? Fixed<F, R>::least() : Fixed<F, R>::greatest();
}
template <int F, class R> constexpr Fixed<F, R> multiply(Fixed<F, R> a, Fixed<F, R> b, ArithmeticStatus& status) {
  const int64_t exact = static_cast<int64_t>(a.raw()) * b.raw();
  if constexpr (F == 0) return Fixed<F, R>::saturate(exact, status);
  else return Fixed<F, R>::saturate((exact + (int64_t{1} << (F - 1))) >> F, status);
}
// a / b, half up. Division by zero gives the end of the range on a's side (0/0: 0) and sets the status.
// Cost: a 64-bit division, 66 to 764 instructions; not for a hot path where a reciprocal can be baked.
template <int F, class R> constexpr Fixed<F, R> divide(Fixed<F, R> a, Fixed<F, R> b, ArithmeticStatus& status) {
  if (b.raw() == 0) {
    status.saturated = true;
    return a.raw() == 0 ? Fixed<F, R>() : a.raw() > 0 ? Fixed<F, R>::greatest() : Fixed<F, R>::least();
  }
  const int64_t sign = b.raw() < 0 ? -1 : 1;
  const int64_t divisor = sign * b.raw();
  // floor((2 a + b) / 2 b) with a positive divisor is floor(a / b + 1/2).
  const int64_t doubled = sign * a.raw() * (int64_t{2} << F) + divisor;
  int64_t quotient = doubled / (2 * divisor);
  if (doubled % (2 * divisor) < 0) --quotient;
  return Fixed<F, R>::saturate(quotient, status);
}

// Sum and difference for results that are known to be representable: one instruction, wraps otherwise.
template <int F, class R> constexpr Fixed<F, R> add_in_range(Fixed<F, R> a, Fixed<F, R> b) {
  return Fixed<F, R>::from_raw(wrapping_add(a.raw(), b.raw()));
}
template <int F, class R> constexpr Fixed<F, R> subtract_in_range(Fixed<F, R> a, Fixed<F, R> b) {
  return Fixed<F, R>::from_raw(wrapping_subtract(a.raw(), b.raw()));
}

// |a|, saturating: the least number gives the greatest.
template <int F, class R> constexpr Fixed<F, R> absolute(Fixed<F, R> a) { return a.raw() < 0 ? -a : a; }

// Exact product; its fraction bits add up.
template <int FA, int FB, class R> constexpr WideProduct<FA + FB, R> product(Fixed<FA, R> a, Fixed<FB, R> b) {
  using W = typename WideOf<R>::type;
  return {static_cast<W>(static_cast<W>(a.raw()) * static_cast<W>(b.raw()))};
}

// Rounds a product or a sum of products once, half up, to To; saturates.
template <class To, int F, class R> constexpr To narrow(WideProduct<F, R> wide, ArithmeticStatus& status) {
  constexpr int shift = F - To::fraction_bits;
  static_assert(shift > 0, "narrowing drops fraction bits");
  // In two steps, so that adding the half cannot overflow.
  const int64_t halves = static_cast<int64_t>(wide.raw) >> (shift - 1);
  return To::saturate((halves >> 1) + (halves & 1), status);
}
template <class To, int F, class R> constexpr To narrow(WideProduct<F, R> wide) {
  ArithmeticStatus ignored;
  return narrow<To>(wide, ignored);
}
// The same rounding for results that are known to be representable, from products that have room for the half that
// rounding adds; wraps otherwise.
template <class To, int F, class R> constexpr To narrow_in_range(WideProduct<F, R> wide) {
  constexpr int shift = F - To::fraction_bits;
  static_assert(shift > 0, "narrowing drops fraction bits");
  using W = typename WideOf<R>::type;
  const W rounded = wrapping_add(wide.raw, static_cast<W>(W{1} << (shift - 1)));
  if constexpr (sizeof(R) == 4) return To::from_raw(shift_right_to_32<shift>(rounded));
  else return To::from_raw(static_cast<typename To::Raw>(rounded >> shift));
}

}  // namespace nearfield
