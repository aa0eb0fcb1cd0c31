// Blends of two distances as straightforward C++ in float: what a user would write instead of a table. Value and, where
// asked for, gradient.
#pragma once

#include <float_curves.hpp>

namespace nearfield::straightforward {

// A distance with its gradient.
struct Distance {
  float value;
  float x, y, z;
};

template <bool with_gradient>
[[gnu::always_inline]] inline Distance mean(float value, const Distance& a, const Distance& b, float share_of_b) {
  if constexpr (!with_gradient) return {value, 0.0f, 0.0f, 0.0f};
  else return {value, a.x + share_of_b * (b.x - a.x), a.y + share_of_b * (b.y - a.y), a.z + share_of_b * (b.z - a.z)};
}

// ln(x), x in [1, 2]: 2 artanh((x - 1) / (x + 1)).
[[gnu::always_inline]] inline float logarithm(float x) {
  const float q = (x - 1.0f) / (x + 1.0f), z = q * q;
  return 2.0f * q * (1.0f + z * (1.0f / 3.0f + z * (0.2f + z * (1.0f / 7.0f + z * (1.0f / 9.0f + z * (1.0f / 11.0f))))));
}

// -ln(e^(-p a) + e^(-p b)) / p, stabilised.
template <bool with_gradient> [[gnu::always_inline]] inline Distance log_sum_exp_union(const Distance& a, const Distance& b, float p) {
  const float gap = b.value - a.value, magnitude = gap < 0.0f ? -gap : gap;
  const float power = p * magnitude > 80.0f ? 0.0f : exponential(-p * magnitude);
  const float value = (gap < 0.0f ? b.value : a.value) - logarithm(1.0f + power) / p;
  if constexpr (!with_gradient) return {value, 0.0f, 0.0f, 0.0f};
  const float lesser = power / (1.0f + power);
  return mean<with_gradient>(value, a, b, gap < 0.0f ? 1.0f - lesser : lesser);
}

// Li's exterior blend with H_3 (Li, equations 18 to 21).
template <bool with_gradient>
[[gnu::always_inline]] inline Distance exterior_union(const Distance& a, const Distance& b, float delta, float epsilon) {
  const float t = b.value - a.value;
  const Jet g1 = polynomial_step<with_gradient>(0.5f * ((t + delta) / epsilon + 1.0f));
  const Jet g2 = polynomial_step<with_gradient>(0.5f * ((t - delta) / epsilon + 1.0f));
  const float parabola = t * t / (2.0f * delta) + 0.5f * delta;
  const float smooth = (g1.value + g2.value - 1.0f) * t + g1.value * (1.0f - g2.value) * parabola;
  const float value = 0.5f * (a.value + b.value - smooth);
  if constexpr (!with_gradient) return {value, 0.0f, 0.0f, 0.0f};
  const float g1_slope = 0.5f / epsilon * g1.slope, g2_slope = 0.5f / epsilon * g2.slope;
  const float slope = (g1_slope + g2_slope) * t + (g1.value + g2.value - 1.0f) +
                      (g1_slope * (1.0f - g2.value) - g1.value * g2_slope) * parabola +
                      g1.value * (1.0f - g2.value) * t / delta;
  return mean<with_gradient>(value, a, b, 0.5f - 0.5f * slope);
}

// The polynomial smooth minimum that graphics people know.
template <bool with_gradient> [[gnu::always_inline]] inline Distance quadratic_union(const Distance& a, const Distance& b, float k) {
  float share = 0.5f + 0.5f * (a.value - b.value) / k;  // of b
  share = share < 0.0f ? 0.0f : share > 1.0f ? 1.0f : share;
  return mean<with_gradient>(a.value + share * (b.value - a.value) - k * share * (1.0f - share), a, b, share);
}

}  // namespace nearfield::straightforward
