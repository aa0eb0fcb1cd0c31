// Numbers >= 0 of any size with 32 significant bits, for quotients and powers of quotients that no fixed-point format
// holds; and sums of what they multiply.
#pragma once

#include <nearfield/number/scalar.hpp>

namespace nearfield {

// Nothing here overflows, and every result is rounded down, by less than 2^-30 of its size. For float: a float of at
// most 2^120 with its own rounding, saturating at both ends.
template <class S> class WideRange;

template <int F> class WideRange<Fixed<F>> {
 public:
  constexpr WideRange() = default;

  // |x|, exact.
  static constexpr WideRange magnitude_of(Fixed<F> x) {
    return of(x.raw() < 0 ? 0u - static_cast<uint32_t>(x.raw()) : static_cast<uint32_t>(x.raw()), -F);
  }
  // x * 2^exponent, x of 64 bits.
  static constexpr WideRange scaled(uint64_t x, int exponent) {
    const int surplus = 32 - leading_zeros(x);
    if (surplus <= 0) return of(static_cast<uint32_t>(x), exponent);
    return of(static_cast<uint32_t>(x >> surplus), exponent + surplus);
  }
  static constexpr WideRange whole(uint32_t count) { return of(count, 0); }

  constexpr bool is_zero() const { return mantissa_ == 0; }
  friend constexpr bool operator<(const WideRange& a, const WideRange& b) {
    if (a.is_zero() || b.is_zero()) return a.is_zero() && !b.is_zero();
    return a.exponent_ != b.exponent_ ? a.exponent_ < b.exponent_ : a.mantissa_ < b.mantissa_;
  }
  friend constexpr WideRange operator*(const WideRange& a, const WideRange& b) {
    if (a.is_zero() || b.is_zero()) return {};
    const uint32_t high = multiply_high(a.mantissa_, b.mantissa_);
    return of(high, a.exponent_ + b.exponent_ + 32);
  }
  // 0 for 0. Cost: a division of 64 bits.
  constexpr WideRange reciprocal() const {
    if (is_zero()) return {};
    const uint64_t inverse = (uint64_t{1} << 63) / mantissa_;
    if (inverse > 0xffffffffu) return of(0x80000000u, -exponent_ - 62);
    return of(static_cast<uint32_t>(inverse), -exponent_ - 63);
  }
  // Of numbers of at most 1, not all 0.
  static constexpr WideRange sum(const WideRange* parts, uint32_t count) {
    uint64_t total = 0;  // Q48
    for (uint32_t i = 0; i < count; ++i) total += shifted(parts[i].mantissa_, parts[i].exponent_ + 48);
    return scaled(total, -48);
  }

  // this * factor * 2^fraction_bits, rounded to nearest; at most 2^55.
  constexpr int64_t times(uint32_t factor, int fraction_bits) const {
    const uint64_t exact = uint64_t{mantissa_} * factor;
    const int shift = exponent_ + fraction_bits;
    if (shift < 0 && shift > -64) return limited(((exact >> (-shift - 1)) + 1) >> 1);
    return limited(shifted(exact, shift));
  }

 private:
  static constexpr uint64_t kLimit = uint64_t{1} << 55;

  static constexpr int64_t limited(uint64_t x) { return static_cast<int64_t>(x < kLimit ? x : kLimit); }
  static constexpr WideRange of(uint32_t mantissa, int exponent) {
    WideRange result;
    if (mantissa == 0) return result;
    const int lead = leading_zeros(mantissa);
    result.mantissa_ = mantissa << lead;
    result.exponent_ = exponent - lead;
    return result;
  }
  // x * 2^shift, rounded down; saturating.
  static constexpr uint64_t shifted(uint64_t x, int shift) {
    if (shift <= 0) return shift > -64 ? x >> -shift : 0;
    return x == 0 ? 0 : shift <= leading_zeros(x) ? x << shift : ~uint64_t{0};
  }

  uint32_t mantissa_ = 0;  // in [2^31, 2^32), or 0
  int exponent_ = 0;
};

template <> class WideRange<float> {
 public:
  constexpr WideRange() = default;

  // Below 2^-60: 0.
  static constexpr WideRange magnitude_of(float x) {
    const float size = absolute(x);
    return of(size < 8.67361737988403547e-19f ? 0.0f : size);
  }
  static constexpr WideRange whole(uint32_t count) { return of(static_cast<float>(count)); }

  constexpr bool is_zero() const { return number_ == 0.0f; }
  constexpr float number() const { return number_; }
  friend constexpr bool operator<(const WideRange& a, const WideRange& b) { return a.number_ < b.number_; }
  friend constexpr WideRange operator*(const WideRange& a, const WideRange& b) { return of(a.number_ * b.number_); }
  constexpr WideRange reciprocal() const { return is_zero() ? WideRange() : of(1.0f / number_); }
  static constexpr WideRange sum(const WideRange* parts, uint32_t count) {
    float total = 0.0f;
    for (uint32_t i = 0; i < count; ++i) total += parts[i].number_;
    return of(total);
  }

 private:
  static constexpr WideRange of(float x) {
    WideRange result;
    result.number_ = x < 1.32922799578491588e36f ? x : 1.32922799578491588e36f;
    return result;
  }

  float number_ = 0.0f;
};

// A number of either sign.
template <class S> struct SignedWide {
  WideRange<S> size;
  bool negative = false;
};

// A sum of products of wide numbers with ordinary ones, which saturates only at its end.
template <class S> class WideSum;

template <int F> class WideSum<Fixed<F>> {
 public:
  using S = Fixed<F>;

  // Adds weight * (x - y), rounded to 2^-8 units in the last place; at most 128 of them.
  constexpr void add(const WideRange<S>& weight, S x, S y = S{}) {
    const bool negative = x < y;
    const uint32_t a = static_cast<uint32_t>(x.raw()), b = static_cast<uint32_t>(y.raw());
    add(negative, weight.times(negative ? b - a : a - b, kSpare));
  }
  constexpr void add(const SignedWide<S>& weight, S x) {
    const uint32_t a = static_cast<uint32_t>(x.raw());
    add(weight.negative != (x.raw() < 0), weight.size.times(x.raw() < 0 ? 0u - a : a, kSpare));
  }
  // base + the sum, rounded once.
  constexpr S result(S base = S{}) const {
    ArithmeticStatus ignored;
    return S::saturate(base.raw() + ((total_ + (int64_t{1} << (kSpare - 1))) >> kSpare), ignored);
  }
  // The sum times a number.
  constexpr SignedWide<S> times(const WideRange<S>& factor) const {
    const uint64_t size = static_cast<uint64_t>(total_ < 0 ? -total_ : total_);
    return {WideRange<S>::scaled(size, -kSpare - F) * factor, total_ < 0};
  }

 private:
  static constexpr int kSpare = 8;  // fraction bits beyond those of S

  constexpr void add(bool negative, int64_t size) { total_ += negative ? -size : size; }

  int64_t total_ = 0;
};

template <> class WideSum<float> {
 public:
  constexpr void add(const WideRange<float>& weight, float x, float y = 0.0f) {
    total_ += limited(weight.number() * (x - y));
  }
  constexpr void add(const SignedWide<float>& weight, float x) {
    const float size = limited(weight.size.number() * x);
    total_ += weight.negative ? -size : size;
  }
  constexpr float result(float base = 0.0f) const { return base + total_; }
  constexpr SignedWide<float> times(const WideRange<float>& factor) const {
    return {WideRange<float>::magnitude_of(total_) * factor, total_ < 0.0f};
  }

 private:
  static constexpr float kLimit = 1.26765060022822940e30f;  // 2^100

  static constexpr float limited(float x) { return clamp(x, -kLimit, kLimit); }

  float total_ = 0.0f;
};

}  // namespace nearfield
