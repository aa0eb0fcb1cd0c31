// Arithmetic of algebraic fields: values and gradients of sums and products. Every result, also on the way, saturates
// at algebraic_limit() with its sign kept; nothing is undefined for any operand.
#pragma once

#include <nearfield/shape/algebraic_bounds.hpp>
#include <nearfield/shape/operands.hpp>

namespace nearfield {

namespace detail {

constexpr float saturated(float a) { return clamp(a, -algebraic_limit<float>(), algebraic_limit<float>()); }
template <int F> constexpr Fixed<F> saturated(Fixed<F> a) { return a; }

// a b + c d, rounded once.
template <int F> constexpr Fixed<F> sum_of_products(Fixed<F> a, Fixed<F> b, Fixed<F> c, Fixed<F> d) {
  const WideProduct<2 * F, int32_t> sum = product(a, b) + product(c, d);
  // Only 2^62 + 2^62 leaves 64 bits.
  return sum.raw == least_of<int64_t> ? Fixed<F>::greatest() : narrow<Fixed<F>>(sum);
}
constexpr float sum_of_products(float a, float b, float c, float d) { return saturated(a * b + c * d); }

}  // namespace detail

// Exact in range for Fixed.
template <class Out> constexpr Out algebraic_sum(const Out& a, const Out& b) {
  using detail::saturated;
  Out out;
  out.value = saturated(a.value + b.value);
  if constexpr (Out::has_gradient) {
    const auto &g = a.gradient, &h = b.gradient;
    out.gradient = {saturated(g.x + h.x), saturated(g.y + h.y), saturated(g.z + h.z)};
  }
  return out;
}

// a * factor; each number rounded once.
template <class Out> constexpr Out algebraic_scaled(const Out& a, typename Out::Scalar factor) {
  using detail::saturated;
  Out out;
  out.value = saturated(a.value * factor);
  if constexpr (Out::has_gradient) {
    const auto& g = a.gradient;
    out.gradient = {saturated(g.x * factor), saturated(g.y * factor), saturated(g.z * factor)};
  }
  return out;
}

// a * b; each number rounded once.
template <class Out> constexpr Out algebraic_product(const Out& a, const Out& b) {
  Out out;
  out.value = detail::saturated(a.value * b.value);
  if constexpr (Out::has_gradient) {
    using detail::sum_of_products;
    const auto &g = a.gradient, &h = b.gradient;
    out.gradient = {sum_of_products(a.value, h.x, b.value, g.x), sum_of_products(a.value, h.y, b.value, g.y),
                    sum_of_products(a.value, h.z, b.value, g.z)};
  }
  return out;
}

// a^exponent, exponent >= 1, by exponent - 1 products.
template <class Out> constexpr Out algebraic_power(const Out& a, uint32_t exponent) {
  Out power = a;
  for (uint32_t i = 1; i < exponent; ++i) power = algebraic_product(power, a);
  return power;
}

}  // namespace nearfield
