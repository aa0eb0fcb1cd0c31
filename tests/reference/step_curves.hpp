#pragma once
/// The unit steps of Li, section 2, with two derivatives. Every curve is 0 below t = -1 and 1 above t = 1,
/// with derivatives of zero there; on the closed interval [-1, 1] it is its formula, so that at t = ±1 the
/// derivatives are those from inside. Where a derivative jumps at an inner knot, the one from the right is
/// given.

#include "curve_point.hpp"
#include "sine_cosine.hpp"

#include <cmath>
#include <cstddef>
#include <stdexcept>
#include <utility>
#include <vector>

namespace nearfield::reference {

/// H₀ (Li eq. 4): ½ at t = 0; the derivatives are zero everywhere.
struct HeavisideCurve {
  CurvePoint operator()(Real t) const { return {t < 0 ? Real{0} : t > 0 ? Real{1} : Real{0.5L}, 0, 0}; }
};

/// A function on [-1, 1] of equal segments, each a polynomial of its own 0…1.
class SegmentedStep {
 public:
  /// `scale` multiplies every piece.
  SegmentedStep(std::vector<PowerPolynomial> pieces, Real scale)
      : pieces_(std::move(pieces)), scale_(scale), per_unit_(static_cast<Real>(pieces_.size()) / 2) {}

  CurvePoint operator()(Real t) const {
    if (t < -1) return {0, 0, 0};
    if (t > 1) return {1, 0, 0};
    const Real place = (t + 1) * per_unit_;
    const auto number = static_cast<std::size_t>(place);
    const std::size_t segment = number < pieces_.size() ? number : pieces_.size() - 1;
    const CurvePoint inside = pieces_[segment](place - static_cast<Real>(segment));
    const Real first_scale = scale_ * per_unit_;
    return {scale_ * inside.value, first_scale * inside.first, first_scale * per_unit_ * inside.second};
  }

 private:
  std::vector<PowerPolynomial> pieces_;
  Real scale_;
  Real per_unit_;
};

inline Real factorial(int n) { return n <= 1 ? Real{1} : static_cast<Real>(n) * factorial(n - 1); }

/// Hₙ (Li eq. 5 and 6), n = 1…8 (otherwise std::invalid_argument). The recursion is carried out on the
/// polynomial pieces of n! fₙ, whose coefficients are integers and exact.
class PolynomialStepCurve {
 public:
  explicit PolynomialStepCurve(int n) : step_(pieces(n), 1 / factorial(n)) {}

  CurvePoint operator()(Real t) const { return step_(t); }

 private:
  static std::vector<PowerPolynomial> pieces(int n) {
    if (n < 1 || n > 8) throw std::invalid_argument("polynomial step: n is 1 to 8");
    PowerPolynomial one;
    one.coefficients[0] = 1;
    const auto count = static_cast<std::size_t>(n);
    std::vector<PowerPolynomial> steps(count, one);
    for (int k = 1; k <= n; ++k) {
      // From the last segment down, so that the segment before is still that of fₖ₋₁.
      for (std::size_t i = count; i-- > 0;) {
        const Real start = static_cast<Real>(i);
        const PowerPolynomial before = i > 0 ? steps[i - 1] : PowerPolynomial{};
        steps[i] = linear_times(start, 1, steps[i]) + linear_times(static_cast<Real>(k) - start, -1, before);
      }
    }
    return steps;
  }

  SegmentedStep step_;
};

/// B_m (Li eq. 7), m = 1…8 (otherwise std::invalid_argument): the uniform B-spline of order m by the Cox–de
/// Boor recursion on its polynomial pieces, integrated piece by piece and divided by the integral over [-1,
/// 1].
class BsplineStepCurve {
 public:
  explicit BsplineStepCurve(int m) : step_(pieces(m), 1) {}

  CurvePoint operator()(Real t) const { return step_(t); }

 private:
  static std::vector<PowerPolynomial> pieces(int m) {
    if (m < 1 || m > 8) throw std::invalid_argument("B-spline step: m is 1 to 8");
    const auto count = static_cast<std::size_t>(m);
    std::vector<PowerPolynomial> bumps(count);
    bumps[0].coefficients[0] = 1;
    for (int order = 2; order <= m; ++order) {
      for (std::size_t i = count; i-- > 0;) {
        const Real start = static_cast<Real>(i);
        const PowerPolynomial before = i > 0 ? bumps[i - 1] : PowerPolynomial{};
        bumps[i] =
            linear_times(start, 1, bumps[i]) + linear_times(static_cast<Real>(order) - start, -1, before);
      }
    }
    Real integral = 0;
    for (PowerPolynomial& piece : bumps) {
      PowerPolynomial antiderivative;
      antiderivative.degree = piece.degree + 1;
      antiderivative.coefficients[0] = integral;
      for (std::size_t k = 0; k <= piece.degree; ++k) {
        antiderivative.coefficients[k + 1] = piece.coefficients[k] / static_cast<Real>(k + 1);
      }
      piece = antiderivative;
      integral = piece(1).value;
    }
    for (PowerPolynomial& piece : bumps) {
      for (Real& coefficient : piece.coefficients) coefficient /= integral;
    }
    return bumps;
  }

  SegmentedStep step_;
};

inline CurvePoint squared(const CurvePoint& root) {
  return {root.value * root.value, 2 * root.value * root.first,
          2 * (root.first * root.first + root.value * root.second)};
}

/// Rₙ (Li eq. 16): R₁ after n - 1 times t → sin(π/2 · t). n at least 1, otherwise std::invalid_argument.
class RisingCutoffCurve {
 public:
  explicit RisingCutoffCurve(int n) : n_(n) {
    if (n < 1) throw std::invalid_argument("rising cutoff: n is at least 1");
  }

  CurvePoint operator()(Real t) const {
    if (t < -1) return {0, 0, 0};
    if (t > 1) return {1, 0, 0};
    CurvePoint warped{t, 1, 0};
    for (int k = 1; k < n_; ++k) warped = compose(sine(pi / 2, pi / 2 * warped.value), warped);
    return compose(sine(pi / 4, pi / 4 * (1 + warped.value)), warped);
  }

 private:
  static CurvePoint sine(Real rate, Real angle) {
    const SineCosine turned = sine_cosine(angle);
    return {turned.sine, rate * turned.cosine, -rate * rate * turned.sine};
  }

  int n_;
};

/// Rₙ². n at least 1, otherwise std::invalid_argument.
class RisingCutoffSquaredCurve {
 public:
  explicit RisingCutoffSquaredCurve(int n) : root_(n) {}

  CurvePoint operator()(Real t) const {
    if (t > 1) return {1, 0, 0};
    return squared(root_(t));
  }

 private:
  RisingCutoffCurve root_;
};

/// θ₀ of Li eq. 15.
struct LinearAngle {
  CurvePoint operator()(Real t) const { return {pi / 4 * (1 + t), pi / 4, 0}; }
};

/// μₙ of the general iteration (Li eq. 14): μₖ = sin θₖ₋₁, θₖ = (π/2) μₖ², from `Angle`, a callable that
/// gives the CurvePoint of θ₀ on [-1, 1]. std::invalid_argument: n below 1, or θ₀ seen (on 129 points, to
/// 1e-12) to decrease or to miss θ₀(-1) = 0 or θ₀(t) + θ₀(-t) = π/2.
template <class Angle>
class IteratedRisingCutoffCurve {
 public:
  IteratedRisingCutoffCurve(int n, Angle angle) : n_(n), angle_(std::move(angle)) {
    if (n < 1) throw std::invalid_argument("iterated rising cutoff: n is at least 1");
    constexpr Real tolerance = 1e-12L;
    Real before = 0;
    for (int i = -64; i <= 64; ++i) {
      const Real t = static_cast<Real>(i) / 64;
      const Real here = angle_(t).value;
      const bool starts = i > -64 || std::fabs(here) <= tolerance;
      if (!starts || !(here >= before - tolerance) ||
          !(std::fabs(here + angle_(-t).value - pi / 2) <= tolerance)) {
        throw std::invalid_argument("iterated rising cutoff: the starting angle is not a rising cutoff's");
      }
      before = here;
    }
  }

  CurvePoint operator()(Real t) const {
    if (t < -1) return {0, 0, 0};
    if (t > 1) return {1, 0, 0};
    CurvePoint theta = angle_(t);
    for (int k = 1; k < n_; ++k) {
      const CurvePoint square = squared(sine(theta));
      theta = {pi / 2 * square.value, pi / 2 * square.first, pi / 2 * square.second};
    }
    return sine(theta);
  }

 private:
  static CurvePoint sine(const CurvePoint& theta) {
    const SineCosine turned = sine_cosine(theta.value);
    return compose({turned.sine, turned.cosine, -turned.sine}, theta);
  }

  int n_;
  Angle angle_;
};

/// S_α (Li eq. 17), α > 0 (otherwise std::invalid_argument). It is only approximately a unit step: at t = ±1
/// it jumps by tail().
class LogisticCurve {
 public:
  explicit LogisticCurve(Real alpha) : alpha_(alpha) {
    if (!(alpha > 0)) throw std::invalid_argument("logistic: alpha is greater than 0");
  }

  /// S_α(-1) = 1 - S_α(1); below ε exactly when α > ln((1 - ε) / ε).
  Real tail() const { return 1 / (1 + std::exp(alpha_)); }

  CurvePoint operator()(Real t) const {
    if (t < -1) return {0, 0, 0};
    if (t > 1) return {1, 0, 0};
    const Real decay = std::exp(-alpha_ * t);
    const Real rise = 1 / (1 + decay);
    const Real rest = decay * rise;
    return {rise, alpha_ * rise * rest, alpha_ * alpha_ * rise * rest * (rest - rise)};
  }

 private:
  Real alpha_;
};

}  // namespace nearfield::reference
