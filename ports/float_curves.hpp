// The papers' functions as straightforward C++ in float: what a user would write instead of a table. Value and, where
// asked for, slope. Sine, exponential and arctangent are polynomials good to about 1e-6, shorter than a libm's.
#pragma once

#include <board/worst_instruction_count.hpp>

#include <nearfield/number/integer.hpp>

namespace nearfield::straightforward {

using board::ValueAndSlope;

struct Jet {
  float value, slope;
};

// The step H_3 over u in [0, 1] in its three pieces.
template <bool with_slope> [[gnu::always_inline]] inline Jet polynomial_step(float u) {
  const float x = 3.0f * u;
  if (x <= 0.0f) return {0.0f, 0.0f};
  if (x < 1.0f) return {x * x * x * (1.0f / 6.0f), with_slope ? 1.5f * x * x : 0.0f};
  if (x < 2.0f) {
    const float y = x - 1.5f;
    return {0.5f + y * (0.75f - y * y * (1.0f / 3.0f)), with_slope ? 3.0f * (0.75f - y * y) : 0.0f};
  }
  if (x < 3.0f) {
    const float y = 3.0f - x;
    return {1.0f - y * y * y * (1.0f / 6.0f), with_slope ? 1.5f * y * y : 0.0f};
  }
  return {1.0f, 0.0f};
}

// The rising cutoff R_2 over u in [0, 1]: sin(pi/4 (1 + sin(pi/2 t))), t = 2 u - 1.
[[gnu::always_inline]] inline float sine(float x) {
  const float z = x * x;
  return x * (1.0f + z * (-1.0f / 6.0f + z * (1.0f / 120.0f + z * (-1.0f / 5040.0f + z * (1.0f / 362880.0f)))));
}
[[gnu::always_inline]] inline float cosine(float x) {
  const float z = x * x;
  return 1.0f + z * (-0.5f + z * (1.0f / 24.0f + z * (-1.0f / 720.0f + z * (1.0f / 40320.0f - z * (1.0f / 3628800.0f)))));
}
template <bool with_slope> [[gnu::always_inline]] inline Jet rising_cutoff(float u) {
  constexpr float quarter_pi = 0.785398163f;
  const float angle = 2.0f * quarter_pi * (2.0f * u - 1.0f), outer = quarter_pi * (1.0f + sine(angle));
  return {sine(outer), with_slope ? cosine(outer) * quarter_pi * cosine(angle) * 4.0f * quarter_pi : 0.0f};
}

// The logistic step with alpha = 16 over u in [0, 1].
[[gnu::always_inline]] inline float exponential(float x) {
  const float scaled = x * 1.44269504f;
  const int32_t whole = static_cast<int32_t>(scaled < 0.0f ? scaled - 0.5f : scaled + 0.5f);
  const float r = (scaled - static_cast<float>(whole)) * 0.693147181f;
  const float power = 1.0f + r * (1.0f + r * (0.5f + r * (1.0f / 6.0f + r * (1.0f / 24.0f + r * (1.0f / 120.0f)))));
  return power * bits_as<float>(static_cast<uint32_t>(whole + 127) << 23);
}
template <bool with_slope> [[gnu::always_inline]] inline Jet logistic(float u) {
  const float s = 1.0f / (1.0f + exponential(-16.0f * (2.0f * u - 1.0f)));
  return {s, with_slope ? 32.0f * s * (1.0f - s) : 0.0f};
}

// Potentials of r in [0, 1], or of u = r^2 where that is their nature.
template <bool with_slope> [[gnu::always_inline]] inline Jet cubic(float r) {
  return {1.0f - r * r * (3.0f - 2.0f * r), with_slope ? 6.0f * r * (r - 1.0f) : 0.0f};
}
template <bool with_slope> [[gnu::always_inline]] inline Jet wyvill(float u) {
  return {((-4.0f / 9.0f * u + 17.0f / 9.0f) * u - 22.0f / 9.0f) * u + 1.0f,
          with_slope ? (-12.0f / 9.0f * u + 34.0f / 9.0f) * u - 22.0f / 9.0f : 0.0f};
}
template <bool with_slope> [[gnu::always_inline]] inline Jet blanc(float u) {
  // Softness 1.
  if (u <= 0.25f) {
    const float bottom = 1.0f + 0.5f * u, quotient = 9.0f * u * u / bottom;
    return {1.0f - quotient, with_slope ? -(18.0f * u - 0.5f * quotient) / bottom : 0.0f};
  }
  const float rest = 1.0f - u, bottom = 5.5f * u - 0.25f, quotient = rest * rest / bottom;
  return {quotient, with_slope ? -(2.0f * rest + 5.5f * quotient) / bottom : 0.0f};
}
template <bool with_slope> [[gnu::always_inline]] inline Jet arctangent(float r) {
  const float x = 10.0f * (r - 0.5f), size = x < 0.0f ? -x : x;
  const bool steep = size > 1.0f;
  const float y = steep ? 1.0f / size : size, z = y * y;
  float angle = y * (0.99997726f + z * (-0.33262347f + z * (0.19354346f + z * (-0.11643287f + z * (0.05265332f - z * 0.0117212f)))));
  if (steep) angle = 1.57079633f - angle;
  return {0.5f - (x < 0.0f ? -angle : angle) * 0.318309886f, with_slope ? -3.18309886f / (1.0f + x * x) : 0.0f};
}

// Bezier of degree 5 with coefficients 1, 1, 1, 0, 0, 0, by de Casteljau.
template <bool with_slope> [[gnu::always_inline]] inline Jet bezier(float r) {
  float row[6] = {1.0f, 1.0f, 1.0f, 0.0f, 0.0f, 0.0f};
  for (int n = 5; n > 1; --n) {
    for (int i = 0; i < n; ++i) row[i] += r * (row[i + 1] - row[i]);
  }
  return {row[0] + r * (row[1] - row[0]), with_slope ? 5.0f * (row[1] - row[0]) : 0.0f};
}

// B-spline of degree 3, knots 1/4, 1/2, 3/4, coefficients 1, 1, 0.9, 0.5, 0.1, 0, 0, by de Boor.
template <bool with_slope> [[gnu::always_inline]] inline Jet bspline(float r) {
  static constexpr float knots[] = {0, 0, 0, 0, 0.25f, 0.5f, 0.75f, 1, 1, 1, 1};
  static constexpr float b[] = {1, 1, 0.9f, 0.5f, 0.1f, 0, 0};
  int span = 3;
  while (span < 6 && r >= knots[span + 1]) ++span;
  float row[4] = {b[span - 3], b[span - 2], b[span - 1], b[span]};
  for (int level = 1; level <= 3; ++level) {
    for (int i = 3; i >= level; --i) {
      const float low = knots[span - 3 + i], high = knots[span + i + 1 - level];
      if (level == 3 && with_slope) {
        const float rise = row[i] - row[i - 1];
        return {row[i - 1] + (r - low) / (high - low) * rise, 3.0f * rise / (high - low)};
      }
      row[i] = row[i - 1] + (r - low) / (high - low) * (row[i] - row[i - 1]);
    }
  }
  return {row[3], 0.0f};
}

// Natural cubic spline through five points, second derivatives known.
template <bool with_slope> [[gnu::always_inline]] inline Jet natural_spline(float r) {
  static constexpr float values[] = {1.0f, 0.85f, 0.5f, 0.15f, 0.0f};
  static constexpr float bends[] = {0.0f, -4.8f, 0.0f, 4.8f, 0.0f};
  const int i = r < 0.25f ? 0 : r < 0.5f ? 1 : r < 0.75f ? 2 : 3;
  const float b = (r - 0.25f * static_cast<float>(i)) * 4.0f, a = 1.0f - b;
  const float value = values[i] * a + values[i + 1] * b +
                      (1.0f / 96.0f) * ((a * a - 1.0f) * a * bends[i] + (b * b - 1.0f) * b * bends[i + 1]);
  const float slope = with_slope ? 4.0f * (values[i + 1] - values[i]) +
                                       (1.0f / 24.0f) * ((3.0f * b * b - 1.0f) * bends[i + 1] - (3.0f * a * a - 1.0f) * bends[i])
                                 : 0.0f;
  return {value, slope};
}

// Parametric cubic Bezier with c = 0.6: five steps of Newton for the parameter.
template <bool with_slope> [[gnu::always_inline]] inline Jet parametric_bezier(float r) {
  float t = r, s = 1.0f - r, rate = 1.0f;
  for (int i = 0; i < 5; ++i) {
    const float off = t * (1.8f * s * s + t * (1.2f * s + t)) - r;
    rate = 1.8f * s * s - 1.2f * s * t + 1.8f * t * t;
    t -= off / rate;
    s = 1.0f - t;
  }
  return {s * s * (s + 3.0f * t), with_slope ? -6.0f * s * t / rate : 0.0f};
}

}  // namespace nearfield::straightforward
