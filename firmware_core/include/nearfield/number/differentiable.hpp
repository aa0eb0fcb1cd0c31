// A number with its first and second derivative in one argument, in `double`. Arithmetic follows the chain rule, so
// that a function written once gives all three. For baking: never linked into a target.
#pragma once

#include <nearfield/number/elementary.hpp>

namespace nearfield {

struct Differentiable {
  double value = 0.0;
  double first = 0.0;
  double second = 0.0;

  constexpr Differentiable() = default;
  constexpr Differentiable(double constant) : value(constant) {}  // NOLINT: implicit, so that 1 - x * x reads well
  constexpr Differentiable(double v, double d, double dd) : value(v), first(d), second(dd) {}
  static constexpr Differentiable argument(double x) { return {x, 1.0, 0.0}; }

  friend constexpr Differentiable operator+(const Differentiable& a, const Differentiable& b) {
    return {a.value + b.value, a.first + b.first, a.second + b.second};
  }
  friend constexpr Differentiable operator-(const Differentiable& a, const Differentiable& b) {
    return {a.value - b.value, a.first - b.first, a.second - b.second};
  }
  friend constexpr Differentiable operator-(const Differentiable& a) { return {-a.value, -a.first, -a.second}; }
  friend constexpr Differentiable operator*(const Differentiable& a, const Differentiable& b) {
    return {a.value * b.value, a.first * b.value + a.value * b.first,
            a.second * b.value + 2.0 * a.first * b.first + a.value * b.second};
  }
  friend constexpr Differentiable operator/(const Differentiable& a, const Differentiable& b) {
    const double quotient = a.value / b.value, rate = (a.first - quotient * b.first) / b.value;
    return {quotient, rate, (a.second - 2.0 * rate * b.first - quotient * b.second) / b.value};
  }
};

// f(x) from f's value and derivatives at x.value.
constexpr Differentiable chain(const Differentiable& x, double value, double first, double second) {
  return {value, first * x.first, second * x.first * x.first + first * x.second};
}

constexpr Differentiable square(const Differentiable& x) { return x * x; }
constexpr Differentiable sin(const Differentiable& x) {
  const double s = exact_sin(x.value);
  return chain(x, s, exact_cos(x.value), -s);
}
constexpr Differentiable cos(const Differentiable& x) {
  const double c = exact_cos(x.value);
  return chain(x, c, -exact_sin(x.value), -c);
}
constexpr Differentiable exp(const Differentiable& x) {
  const double e = exact_exp(x.value);
  return chain(x, e, e, e);
}
// x > 0.
constexpr Differentiable log(const Differentiable& x) {
  return chain(x, exact_log(x.value), 1.0 / x.value, -1.0 / (x.value * x.value));
}
// x > 0.
constexpr Differentiable sqrt(const Differentiable& x) {
  const double root = exact_sqrt(x.value);
  return chain(x, root, 0.5 / root, -0.25 / (root * x.value));
}
constexpr Differentiable atan(const Differentiable& x) {
  const double inverse = 1.0 / (1.0 + x.value * x.value);
  return chain(x, exact_atan(x.value), inverse, -2.0 * x.value * inverse * inverse);
}

}  // namespace nearfield
