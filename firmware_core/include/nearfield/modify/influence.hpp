// Hsu's variable influential radius: an object's ray value, remapped so that its influence ends at a contour of any shape.
#pragma once

#include <nearfield/number/ratio.hpp>
#include <nearfield/shape/operands.hpp>
#include <nearfield/shape/soft.hpp>

namespace nearfield {

// T(d; w1, w2) (Hsu, equations 13 to 15) with w1 = 2 d / f - 1, d the ray value of the object (first operand) and f that
// of the contour, both >= 0 (less counts as 0). In terms of k = f / (2 d - f) = 1 / w1 and t = 1/2 - d, u = 2 t / w2:
//   d >= 1/2   1/2 - k t inside the contour; 1 beyond it, f > 1, also where w1 is not positive: the contour cuts the object
//   d < 1/2    (1 - u^2) / 2 - k t (1 - u), but at least 0; 0 from u = 1 on, and where w1 is not positive
// T lies in [0, 1]. It jumps only where the contour touches the object, f = 1 and d = 1/2, and where f = d = 0; so no
// certificate bounds its rate. Given the operands, T is within 2 units in the last place (float: 2^-22); its derivatives
// by d and f saturate where k or t / (2 d - f) leave the number range.
template <class S> struct VariableInfluence {
  using Scalar = S;
  static constexpr Kind kind = Kind::ray;
  static constexpr int fixed_operand_count = 2;
  S w2{};          // inner range, 1/8 to 1
  S inverse_w2{};  // 1 / w2

  constexpr VariableInfluence() = default;
  constexpr explicit VariableInfluence(S inner_range) : w2(inner_range), inverse_w2(detail::inverse_of(inner_range)) {}

  template <class Out> constexpr Out combine(const Out& object, const Out& contour) const {
    const Remapped t = remapped<Out::has_gradient>(not_negative(object.value), not_negative(contour.value));
    Out out;
    out.value = t.value;
    if constexpr (Out::has_gradient) out.gradient = scaled(object.gradient, t.by_d) + scaled(contour.gradient, t.by_f);
    return out;
  }
  constexpr Certificate<S> certificate(OperandCertificates<S> of, const TableFacts&, Reach<S>) const {
    using T = ScalarTraits<S>;
    Certificate<S> both = worst_of(of[0], of[1]);
    const S least = T::half(T::half(T::half(T::one())));
    both.valid = both.valid && within(w2, least, T::one()) && inverse_w2 == detail::inverse_of(w2);
    both.lipschitz = kNoRateBound;
    both.error = T::one();  // T and what is evaluated lie in [0, 1]
    return both;
  }

 private:
  struct Remapped {
    S value{}, by_d{}, by_f{};
  };
  static constexpr S not_negative(S x) { return x > S{} ? x : S{}; }

  template <bool with_slopes> constexpr Remapped remapped(S d, S f) const {
    using T = ScalarTraits<S>;
    const S half = T::half(T::one());
    if (d > half && f > T::one()) return {T::one(), {}, {}};
    if (d == half && f >= T::one()) return {half, {}, {}};
    const auto width = width_of(d, f);
    if (!(width > 0)) return {};
    return d < half ? inside<with_slopes>(subtract_in_range(half, d), f, width)
                    : outside<with_slopes>(subtract_in_range(d, half), f, width);
  }

  // 2 d - f, in units of the last place for Fixed.
  template <int F, class R> static constexpr int64_t width_of(Fixed<F, R> d, Fixed<F, R> f) {
    return int64_t{2} * d.raw() - f.raw();
  }
  static constexpr float width_of(float d, float f) { return (d + d) - f; }

  // 1 / width for Fixed, a width below 2^32: x / width = x * mantissa * 2^(shift - 63), in units of the last place.
  struct InverseWidth {
    uint32_t mantissa;
    int shift;
  };
  static constexpr InverseWidth inverse_of_width(int64_t width) {
    const uint32_t w = static_cast<uint32_t>(width);
    const int shift = leading_zeros(w);
    return {detail::normalised_reciprocal(w << shift), shift};
  }
  static constexpr int64_t at_most(uint64_t x) {
    return x > static_cast<uint64_t>(greatest_of<int32_t>) ? greatest_of<int32_t> : static_cast<int64_t>(x);
  }
  static constexpr S saturated(int64_t raw) {
    ArithmeticStatus ignored;
    return S::saturate(raw, ignored);
  }

  // d = 1/2 + s, f <= 1: T = 1/2 + n f / 2 with n = 2 s / width in [0, 1]; dT/dd = k (1 - n), dT/df = n (1 + k) / 2.
  template <bool with_slopes, class Width> static constexpr Remapped outside(S s, S f, Width width) {
    using T = ScalarTraits<S>;
    const S half = T::half(T::one());
    Remapped result;
    if constexpr (T::is_fixed) {
      constexpr int F = S::fraction_bits;
      const InverseWidth inverse = inverse_of_width(width);
      const uint64_t twice = uint64_t{2} * static_cast<uint32_t>(s.raw());
      const int64_t n = at_most((twice * inverse.mantissa) >> (32 - inverse.shift));  // Q31
      result.value = S::from_raw(static_cast<int32_t>(half.raw() + ((f.raw() * n + (int64_t{1} << 31)) >> 32)));
      if constexpr (with_slopes) {
        const int64_t k = at_most((static_cast<uint64_t>(f.raw()) * inverse.mantissa) >> (63 - F - inverse.shift));
        const int64_t rest = (int64_t{1} << 31) - n;
        result.by_d = saturated((k * rest + (int64_t{1} << 30)) >> 31);
        result.by_f = saturated(((k + T::one().raw()) * n + (int64_t{1} << 31)) >> 32);
      }
    } else {
      const float n = (s + s) / width;
      result.value = half + 0.5f * (f * n);
      if constexpr (with_slopes) {
        const float k = f / width;
        result.by_d = k * ((1.0f - f) / width);
        result.by_f = n * (0.5f * (1.0f + k));
      }
    }
    return result;
  }

  // d = 1/2 - t: T = (1 - u) (1 + u - h) / 2 with h = 2 t k;
  // dT/dd = 2 u / w2 + k (1 - 2 u) + (h / width) (1 - u), dT/df = -(t / width) (1 - u) (1 + k).
  template <bool with_slopes, class Width> constexpr Remapped inside(S t, S f, Width width) const {
    using T = ScalarTraits<S>;
    Remapped result;
    if constexpr (T::is_fixed) {
      constexpr int F = S::fraction_bits;
      constexpr uint64_t one = uint64_t{1} << 31;
      const uint64_t twice = uint64_t{2} * static_cast<uint32_t>(t.raw());
      const uint64_t u = (twice * static_cast<uint32_t>(inverse_w2.raw())) >> (2 * F - 31);  // Q31, like h
      if (u >= one) return result;
      const InverseWidth inverse = inverse_of_width(width);
      // k below 2^59 in Q31; as many of its bits as leave room for the product.
      const uint64_t k = (static_cast<uint64_t>(f.raw()) * inverse.mantissa) >> (32 - inverse.shift);
      const int excess = leading_zeros(k) < 29 ? 29 - leading_zeros(k) : 0;
      const uint64_t h = ((k >> excess) * twice) >> (F - excess);
      if (h >= one + u) return result;
      const uint64_t rest = one - u;
      result.value = S::from_raw(static_cast<int32_t>((rest * (one + u - h) + (uint64_t{1} << (62 - F))) >> (63 - F)));
      if constexpr (with_slopes) {
        const int64_t rate = at_most(k >> (31 - F));
        // The rest first: without it the quotient would leave the number range where the product does not.
        const int64_t rise = at_most((((h * rest) >> 31) * inverse.mantissa) >> (94 - 2 * F - inverse.shift));
        const int64_t part = static_cast<int64_t>(rest);
        const int64_t by_u = (static_cast<int64_t>(u) * inverse_w2.raw()) >> 30;
        const int64_t by_k = (rate * (part - static_cast<int64_t>(u))) >> 31;
        result.by_d = saturated(by_u + by_k + rise);
        const uint64_t share = ((twice >> 1) * inverse.mantissa) >> (63 - F - inverse.shift);
        const int64_t steep = (at_most(share) * part) >> 31;
        const int64_t reach = at_most(static_cast<uint64_t>(rate + T::one().raw()));
        result.by_f = saturated(-((steep * reach) >> F));
      }
    } else {
      const float u = (t + t) * inverse_w2;
      if (!(u < 1.0f)) return result;
      const float k = f / width, h = (t + t) * k, rest = 1.0f - u;
      if (!(h < 1.0f + u)) return result;
      result.value = 0.5f * (rest * ((1.0f + u) - h));
      if constexpr (with_slopes) {
        result.by_d = (2.0f * (u * inverse_w2) + k * (1.0f - (u + u))) + (h / width) * rest;
        result.by_f = -((t / width) * rest) * (1.0f + k);
      }
    }
    return result;
  }
};

}  // namespace nearfield
