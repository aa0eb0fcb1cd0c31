// Range of algebraic values, and bounds on what is computed from them, rounded upwards, for their certificates.
#pragma once

#include <nearfield/shape/certificate.hpp>
#include <nearfield/shape/sample.hpp>

namespace nearfield {

// Algebraic values, their gradients and all intermediate results saturate at plus and minus this: the greatest number;
// of float 2^60, so that no product of two is infinite.
template <class S> constexpr S algebraic_limit() {
  if constexpr (ScalarTraits<S>::is_fixed) return S::greatest();
  else return 1.15292150460684698e18f;
}

// What is known of an algebraic field or of an intermediate result of one.
template <class S> struct AlgebraicBounds {
  S magnitude{};   // of the value, exact or evaluated; algebraic_limit(): it may saturate, and nothing is known
  Rate lipschitz;  // per 1/16 m, or kNoRateBound
  S error{};       // greatest |evaluated - exact|; twice the magnitude where lipschitz is kNoRateBound
};

namespace detail {

// Of numbers >= 0: the least that is certainly not below the exact result; saturating at algebraic_limit().
template <int F> constexpr Fixed<F> product_up(Fixed<F> a, Fixed<F> b) {
  ArithmeticStatus ignored;
  return Fixed<F>::saturate((int64_t{a.raw()} * b.raw() + ((int64_t{1} << F) - 1)) >> F, ignored);
}
constexpr float float_up(float a) {
  const float up = a * 1.000001f + 1.0e-37f;
  return a == 0.0f ? a : up < algebraic_limit<float>() ? up : algebraic_limit<float>();
}
constexpr float product_up(float a, float b) { return a == 0.0f || b == 0.0f ? 0.0f : float_up(a * b + 1.0e-37f); }
template <int F> constexpr Fixed<F> sum_up(Fixed<F> a, Fixed<F> b) { return a + b; }
constexpr float sum_up(float a, float b) { return float_up(a + b); }

// rate * factor and a number as a rate, for a factor >= 0. No bound stays none.
template <int F> constexpr Rate rate_product_up(Rate rate, Fixed<F> factor) {
  if (rate == kNoRateBound) return kNoRateBound;
  ArithmeticStatus ignored;
  return Rate::saturate((int64_t{rate.raw()} * factor.raw() + ((int64_t{1} << F) - 1)) >> F, ignored);
}
constexpr Rate rate_up_from(float rate) {
  return rate < 127.0f ? Rate::from_raw(static_cast<int32_t>(rate * 16777216.0f) + 16) : kNoRateBound;
}
constexpr Rate rate_product_up(Rate rate, float factor) {
  if (rate == kNoRateBound) return kNoRateBound;
  return rate_up_from(static_cast<float>(rate.raw()) * (1.0f / 16777216.0f) * factor);
}

// 1/16 m in metres, by which rates per metre become those of gradients.
inline constexpr Rate kGradientLength = Rate::from_raw(1 << (Rate::fraction_bits + kGradientLengthLog2));

// A distance in whole metres.
template <int F> constexpr int64_t metres_up(Fixed<F> length) { return (int64_t{length.raw()} >> F) + 1; }

// `units` roundings of results of this magnitude, and for float of the terms that they are made of.
template <class S> constexpr S roundings(S magnitude, int units) {
  return ScalarTraits<S>::times(ScalarTraits<S>::rounding_unit(magnitude), units);
}

// That many units in the last place.
template <class S> constexpr S units_up(int64_t units) {
  ArithmeticStatus ignored;
  return S::saturate(units, ignored);
}

// Length of a vector, rounded upwards.
template <class S> constexpr S length_up(const Vector3<S>& v) {
  const S length = length_of<S>(sum_of_squares(v.x, v.y, v.z));
  return sum_up(length, ScalarTraits<S>::rounding_unit(length));
}

}  // namespace detail

template <class S> constexpr AlgebraicBounds<S> settled(const AlgebraicBounds<S>& bounds) {
  AlgebraicBounds<S> result = bounds;
  if (!(bounds.magnitude < algebraic_limit<S>())) {
    result = {algebraic_limit<S>(), kNoRateBound, algebraic_limit<S>()};
  } else if (bounds.lipschitz == kNoRateBound) {
    result.error = detail::sum_up(bounds.magnitude, bounds.magnitude);
  }
  return result;
}

// Of a + b, a * b, a * factor and a^exponent, each as blend/polynomial.hpp evaluates them.
template <class S> constexpr AlgebraicBounds<S> sum_bounds(const AlgebraicBounds<S>& a, const AlgebraicBounds<S>& b) {
  const S magnitude = detail::sum_up(a.magnitude, b.magnitude);
  const S own = ScalarTraits<S>::is_fixed ? S{} : detail::roundings(magnitude, 1);
  return settled<S>({magnitude, a.lipschitz + b.lipschitz, detail::sum_up(detail::sum_up(a.error, b.error), own)});
}
template <class S>
constexpr AlgebraicBounds<S> product_bounds(const AlgebraicBounds<S>& a, const AlgebraicBounds<S>& b) {
  using namespace detail;
  const S product = product_up(a.magnitude, b.magnitude), own = roundings(product, 1);
  const bool lost = !(a.magnitude < algebraic_limit<S>() && b.magnitude < algebraic_limit<S>());
  return settled<S>({lost ? algebraic_limit<S>() : sum_up(product, own),
                     rate_product_up(a.lipschitz, b.magnitude) + rate_product_up(b.lipschitz, a.magnitude),
                     sum_up(sum_up(product_up(a.magnitude, b.error), product_up(b.magnitude, a.error)), own)});
}
// The factor was rounded, as a number of the size `rounded_at`.
template <class S> constexpr AlgebraicBounds<S> scaled_bounds(const AlgebraicBounds<S>& a, S factor, S rounded_at) {
  using namespace detail;
  const S size = absolute(factor);
  const S product = product_up(a.magnitude, size), own = roundings(product, 1);
  const bool lost = !(a.magnitude < algebraic_limit<S>());
  const S of_factor = product_up(a.magnitude, ScalarTraits<S>::rounding_unit(rounded_at));
  // The factor before it was rounded may have been greater.
  const S greatest_size = sum_up(size, ScalarTraits<S>::rounding_unit(rounded_at));
  return settled<S>({lost ? algebraic_limit<S>() : sum_up(product, own), rate_product_up(a.lipschitz, greatest_size),
                     sum_up(product_up(a.error, size), sum_up(of_factor, own))});
}
template <class S> constexpr AlgebraicBounds<S> scaled_bounds(const AlgebraicBounds<S>& a, S factor) {
  return scaled_bounds(a, factor, absolute(factor));
}
template <class S> constexpr AlgebraicBounds<S> power_bounds(const AlgebraicBounds<S>& a, uint32_t exponent) {
  AlgebraicBounds<S> power = a;
  for (uint32_t i = 1; i < exponent; ++i) power = product_bounds(power, a);
  return power;
}

template <class S> constexpr AlgebraicBounds<S> bounds_of(const Certificate<S>& certificate) {
  return settled<S>({certificate.magnitude, certificate.lipschitz, certificate.error});
}
// Algebraic fields state neither erosion nor inflation: they are not made of distances.
template <class S> constexpr Certificate<S> algebraic_certificate(const AlgebraicBounds<S>& bounds, bool valid) {
  const AlgebraicBounds<S> result = settled(bounds);
  Certificate<S> certificate;
  certificate.valid = valid;
  certificate.lipschitz = result.lipschitz;
  certificate.error = result.error;
  certificate.magnitude = result.magnitude;
  return certificate;
}

}  // namespace nearfield
