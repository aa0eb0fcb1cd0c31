// Functional splines: (1 - lambda) P1 ... Pn + lambda (B1 ... Bm)^exponent; Liming's blend is that of two primaries and
// one bound (Hsu; Sipos).
#pragma once

#include <nearfield/blend/polynomial.hpp>

namespace nearfield {

// Operands: the primaries P, then the bounds B; 1 to 8 of either. Exponent k + 1 gives contact of order k with the
// primaries where the bounds vanish; 1 to 4. lambda in [-1, 1], not 0. For 0 < lambda < 1 and an even exponent the
// surface lies where the primaries' product is <= 0: negate one of two primaries, or lambda, to blend where it is >= 0.
// Products are taken in the operands' order. Rounding: certificate().
template <class S> struct FunctionalSpline {
  using Scalar = S;
  static constexpr Kind kind = Kind::algebraic;
  static constexpr int fixed_operand_count = kAnyNumber;
  static constexpr uint32_t greatest_count = 8, greatest_exponent = 4;
  uint32_t primary_count = 0;
  uint32_t bound_count = 0;
  uint32_t exponent = 2;
  S lambda{};

  // 0 for counts out of range.
  constexpr int operand_count() const {
    return counts_valid() ? static_cast<int>(primary_count + bound_count) : 0;
  }
  template <class Out, class Operands> constexpr Out combine_all(const Operands& of) const {
    const Out primaries = product_of<Out>(of, 0, primary_count);
    const Out bounds = algebraic_power(product_of<Out>(of, primary_count, bound_count), exponent);
    return algebraic_sum(algebraic_scaled(primaries, rest()), algebraic_scaled(bounds, lambda));
  }
  constexpr Certificate<S> certificate(OperandCertificates<S> of, const TableFacts&, Reach<S>) const {
    const S one = ScalarTraits<S>::one();
    if (!counts_valid()) return {};
    bool valid = exponent >= 1 && exponent <= greatest_exponent && within(lambda, -one, one) && !(lambda == S{});
    for (int i = 0; i < operand_count(); ++i) valid = valid && of[i].valid;
    if (!valid) return {};
    const AlgebraicBounds<S> primaries = bounds_of_product(of, primary_count);
    const AlgebraicBounds<S> bounds = power_bounds(bounds_of_product(of + primary_count, bound_count), exponent);
    const AlgebraicBounds<S> first = scaled_bounds(primaries, rest(), one), second = scaled_bounds(bounds, lambda);
    return algebraic_certificate(sum_bounds(first, second), valid);
  }

 private:
  constexpr S rest() const { return ScalarTraits<S>::one() - lambda; }
  constexpr bool counts_valid() const {
    return primary_count >= 1 && primary_count <= greatest_count && bound_count >= 1 && bound_count <= greatest_count;
  }
  template <class Out, class Operands>
  static constexpr Out product_of(const Operands& of, uint32_t first, uint32_t count) {
    Out all = of[static_cast<int>(first)];
    for (uint32_t i = 1; i < count; ++i) all = algebraic_product(all, Out(of[static_cast<int>(first + i)]));
    return all;
  }
  static constexpr AlgebraicBounds<S> bounds_of_product(OperandCertificates<S> of, uint32_t count) {
    AlgebraicBounds<S> all = bounds_of(of[0]);
    for (uint32_t i = 1; i < count; ++i) all = product_bounds(all, bounds_of(of[i]));
    return all;
  }
};

// (1 - lambda) L1 L2 + lambda C^2, operands L1, L2, C.
template <class S> constexpr FunctionalSpline<S> liming(S lambda) { return {2, 1, 2, lambda}; }

}  // namespace nearfield
