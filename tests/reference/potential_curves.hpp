#pragma once
/// Potentials P(r) of KW and Hsu by formula, with two derivatives with respect to r. Every curve is 1 below r
/// = 0 and 0 above r = 1, with derivatives of zero there; on the closed interval [0, 1] it is its formula, so
/// that at r = 0 and 1 the derivatives are those from inside. Nothing here refuses a curve for rising
/// somewhere. Curves through or near given points: spline_curves.hpp.

#include "curve_point.hpp"

#include <cmath>
#include <stdexcept>
#include <utility>

namespace nearfield::reference {

/// 1 − 3r² + 2r³.
struct CubicCurve {
  CurvePoint operator()(Real r) const {
    if (r < 0) return {1, 0, 0};
    if (r > 1) return {0, 0, 0};
    return {1 + r * r * (2 * r - 3), 6 * r * (r - 1), 12 * r - 6};
  }
};

/// The cubic in u = r² with P(0) = 1, P(1) = 0, P′(1) = 0 that passes through (r₀, F₀): (1 − u)² (1 + k u).
/// It never rises exactly when −1 ≤ k ≤ 2. r₀ in (0, 1) and F₀ finite, otherwise std::invalid_argument.
class WyvillCurve {
 public:
  /// Through (½, ½): k = −4/9.
  WyvillCurve() : WyvillCurve(0.5L, 0.5L) {}

  WyvillCurve(Real r0, Real f0) {
    if (!(r0 > 0 && r0 < 1) || !std::isfinite(f0)) {
      throw std::invalid_argument("wyvill: the point's abscissa is strictly between 0 and 1");
    }
    const Real u0 = r0 * r0;
    k_ = (f0 / ((1 - u0) * (1 - u0)) - 1) / u0;
  }

  Real k() const { return k_; }

  CurvePoint operator()(Real r) const {
    if (r < 0) return {1, 0, 0};
    if (r > 1) return {0, 0, 0};
    const Real u = r * r;
    const Real rest = 1 - u;
    const Real line = 1 + k_ * u;
    return compose_with_square({rest * rest * line, rest * (k_ * rest - 2 * line), 2 * line - 4 * k_ * rest},
                               r);
  }

 private:
  Real k_ = 0;
};

/// ½ − atan(c₁(r − c₂))/π, c₁ > 0 and c₂ finite (otherwise std::invalid_argument). Plain, it misses 1 at r =
/// 0 and 0 at r = 1 and jumps there; clamped, it is g/g(0) with g(r) = F(r) − F(1).
class ArctangentCurve {
 public:
  static ArctangentCurve plain(Real c1, Real c2) { return {c1, c2, false}; }
  static ArctangentCurve clamped(Real c1, Real c2) { return {c1, c2, true}; }

  CurvePoint operator()(Real r) const {
    if (r < 0) return {1, 0, 0};
    if (r > 1) return {0, 0, 0};
    const CurvePoint free = unclamped(r);
    return {(free.value - floor_) / span_, free.first / span_, free.second / span_};
  }

 private:
  ArctangentCurve(Real c1, Real c2, bool is_clamped) : c1_(c1), c2_(c2) {
    if (!(c1 > 0) || !std::isfinite(c1) || !std::isfinite(c2)) {
      throw std::invalid_argument("arctangent: c1 is greater than 0");
    }
    if (is_clamped) {
      floor_ = unclamped(1).value;
      span_ = unclamped(0).value - floor_;
    }
  }

  CurvePoint unclamped(Real r) const {
    const Real x = c1_ * (r - c2_);
    const Real first = -c1_ / (pi * (1 + x * x));
    return {0.5L - std::atan(x) / pi, first, first * (-2 * c1_ * x / (1 + x * x))};
  }

  Real c1_;
  Real c2_;
  Real floor_ = 0;
  Real span_ = 1;
};

/// Blanc and Schlick's potential (Hsu eq. 11), s ≥ 0 and finite (otherwise std::invalid_argument): with u =
/// r², 1 − 9u²/(s + (4.5 − 4s)u) up to r = ½, (1 − u)²/(0.75 − s + (1.5 + 4s)u) beyond. At ½ the second
/// derivative jumps; the one from the left is given. For s = 0 the first piece is 1 − 2u, at r = 0 too.
class BlancCurve {
 public:
  explicit BlancCurve(Real s) : s_(s) {
    if (!(s >= 0) || !std::isfinite(s)) throw std::invalid_argument("blanc: s is at least 0");
  }

  CurvePoint operator()(Real r) const {
    if (r < 0) return {1, 0, 0};
    if (r > 1) return {0, 0, 0};
    const Real u = r * r;
    if (r > 0.5L) {
      const Real rest = 1 - u;
      const Real slope = 1.5L + 4 * s_;
      return compose_with_square(quotient({rest * rest, -2 * rest, 2}, 0.75L - s_ + slope * u, slope), r);
    }
    if (s_ == 0) return compose_with_square({1 - 2 * u, -2, 0}, r);
    const Real slope = 4.5L - 4 * s_;
    const CurvePoint loss = quotient({9 * u * u, 18 * u, 18}, s_ + slope * u, slope);
    return compose_with_square({1 - loss.value, -loss.first, -loss.second}, r);
  }

 private:
  /// By a denominator that is linear with the given slope.
  static CurvePoint quotient(const CurvePoint& numerator, Real denominator, Real slope) {
    const Real value = numerator.value / denominator;
    const Real first = (numerator.first - value * slope) / denominator;
    return {value, first, (numerator.second - 2 * first * slope) / denominator};
  }

  Real s_;
};

/// Hsu's range remap T(d; w₁, w₂) (Hsu eq. 13), 0 < w₂ ≤ 1, w₂ ≤ w₁ (otherwise std::invalid_argument): 0
/// below (1 − w₂)/2, a parabola up to ½, a line up to (1 + w₁)/2, 1 beyond. At the joints the derivatives are
/// those of the line at ½ and at its end, and those of the parabola at its start.
class RangeRemap {
 public:
  RangeRemap(Real w1, Real w2) : w1_(w1), w2_(w2) {
    if (!(w1 > 0) || !std::isfinite(w1) || !(w2 > 0 && w2 <= 1 && w2 <= w1)) {
      throw std::invalid_argument(
          "range remap: w1 is greater than 0, w2 greater than 0, at most 1 and at most w1");
    }
    a_ = 2 * (1 / w1 - 1 / w2) / w2;
    b_ = 1 / w1 - a_;
    c_ = 0.5L - b_ / 2 - a_ / 4;
  }

  CurvePoint operator()(Real d) const {
    if (d > (1 + w1_) / 2) return {1, 0, 0};
    if (d >= 0.5L) return {(d - 0.5L) / w1_ + 0.5L, 1 / w1_, 0};
    if (d >= (1 - w2_) / 2) return {(a_ * d + b_) * d + c_, 2 * a_ * d + b_, 2 * a_};
    return {0, 0, 0};
  }

 private:
  Real w1_;
  Real w2_;
  Real a_ = 0;
  Real b_ = 0;
  Real c_ = 0;
};

/// P(T(d)) of any potential P. Unlike the plain potentials it ends at d = (1 + w₁)/2, which is beyond 1 for
/// w₁ > 1. The ends of T give P(0) and P(1) with derivatives of zero; below d = 0 it is 1.
template <class Potential>
class RemappedCurve {
 public:
  RemappedCurve(const RangeRemap& remap, Potential potential)
      : remap_(remap), potential_(std::move(potential)) {}

  CurvePoint operator()(Real d) const {
    if (d < 0) return {1, 0, 0};
    const CurvePoint ranged = remap_(d);
    // Rounding may take T a unit in the last place outside [0, 1], where the potential has no slope.
    const Real inside = ranged.value < 0 ? Real{0} : ranged.value > 1 ? Real{1} : ranged.value;
    return compose(potential_(inside), ranged);
  }

 private:
  RangeRemap remap_;
  Potential potential_;
};

}  // namespace nearfield::reference
