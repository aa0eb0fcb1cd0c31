#pragma once
/// Potentials P(r) of KW that are set by points: natural cubic spline, explicit Bézier and B-spline curves
/// and the parametric cubic Bézier curve, with two derivatives with respect to r. 1 below r = 0 and 0 above r
/// = 1, with derivatives of zero there; on the closed interval [0, 1] the curve itself, even where its ends
/// miss 1 and 0, so that at r = 0 and 1 the derivatives are those from inside. At inner knots they are those
/// from the right. Nothing here refuses a curve for rising somewhere.

#include "curve_point.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <stdexcept>
#include <vector>

namespace nearfield::reference {

/// Number of the segment of ascending `starts` (the first at 0) that holds r.
inline std::size_t segment_of(const std::vector<Real>& starts, Real r) {
  std::size_t segment = starts.size() - 1;
  while (segment > 0 && r < starts[segment]) --segment;
  return segment;
}

/// The natural cubic spline (continuous to the second derivative, which is 0 at both ends) through (abscissa,
/// ordinate) points: 3 to 10 of them, strictly ascending from 0 to 1; otherwise std::invalid_argument.
class NaturalSplineCurve {
 public:
  NaturalSplineCurve(const std::vector<Real>& abscissas, const std::vector<Real>& ordinates) {
    const std::size_t count = abscissas.size();
    if (count < 3 || count > 10 || ordinates.size() != count || abscissas.front() != 0 ||
        abscissas.back() != 1) {
      throw std::invalid_argument("natural spline: 3 to 10 points from abscissa 0 to 1");
    }
    std::vector<Real> steps(count - 1);
    std::vector<Real> slopes(count - 1);
    for (std::size_t i = 0; i + 1 < count; ++i) {
      steps[i] = abscissas[i + 1] - abscissas[i];
      if (!(steps[i] > 0)) throw std::invalid_argument("natural spline: abscissas ascend strictly");
      slopes[i] = (ordinates[i + 1] - ordinates[i]) / steps[i];
    }
    // Equal slopes at inner points: h₋ M₋ + 2 (h₋ + h₊) M + h₊ M₊ = 6 (s₊ − s₋) for the second derivatives M.
    std::vector<Real> second(count, 0);
    std::vector<Real> diagonal(count, 1);
    for (std::size_t i = 1; i + 1 < count; ++i) {
      const Real share = i > 1 ? steps[i - 1] / diagonal[i - 1] : Real{0};
      diagonal[i] = 2 * (steps[i - 1] + steps[i]) - share * steps[i - 1];
      second[i] = 6 * (slopes[i] - slopes[i - 1]) - share * second[i - 1];
    }
    for (std::size_t i = count - 1; i-- > 1;)
      second[i] = (second[i] - steps[i] * second[i + 1]) / diagonal[i];
    starts_.assign(abscissas.begin(), abscissas.end() - 1);
    for (std::size_t i = 0; i + 1 < count; ++i) {
      PowerPolynomial piece;
      piece.degree = 3;
      piece.coefficients[0] = ordinates[i];
      piece.coefficients[1] = slopes[i] - steps[i] * (2 * second[i] + second[i + 1]) / 6;
      piece.coefficients[2] = second[i] / 2;
      piece.coefficients[3] = (second[i + 1] - second[i]) / (6 * steps[i]);
      pieces_.push_back(piece);
    }
  }

  CurvePoint operator()(Real r) const {
    if (r < 0) return {1, 0, 0};
    if (r > 1) return {0, 0, 0};
    const std::size_t segment = segment_of(starts_, r);
    return pieces_[segment](r - starts_[segment]);
  }

  /// Greatest first derivative on [0, 1]; above 0, the spline rises somewhere.
  Real greatest_slope() const {
    Real greatest = -std::numeric_limits<Real>::infinity();
    for (std::size_t i = 0; i < pieces_.size(); ++i) {
      const Real end = (i + 1 < starts_.size() ? starts_[i + 1] : Real{1}) - starts_[i];
      const Real summit = -pieces_[i].coefficients[2] / (3 * pieces_[i].coefficients[3]);
      for (const Real place : {Real{0}, summit > 0 && summit < end ? summit : Real{0}, end}) {
        greatest = std::max(greatest, pieces_[i](place).first);
      }
    }
    return greatest;
  }

 private:
  std::vector<Real> starts_;
  std::vector<PowerPolynomial> pieces_;
};

/// Σ bⱼ Bⱼⁿ(r) of degree n = 1…9; any other number of ordinates: std::invalid_argument.
class BezierCurve {
 public:
  explicit BezierCurve(const std::vector<Real>& ordinates) : polynomial_(ordinates) {}

  CurvePoint operator()(Real r) const {
    if (r < 0) return {1, 0, 0};
    if (r > 1) return {0, 0, 0};
    return polynomial_(r);
  }

 private:
  BernsteinPolynomial polynomial_;
};

/// Σ cᵢ Nᵢ(r), Nᵢ the B-spline basis function of degree p = 1…9 over knots i…i + p + 1. There are p + 1 more
/// knots than coefficients; knots never descend; knot p is 0 and knot number (coefficients) is 1, between
/// which every inner knot appears at most p times. Otherwise: std::invalid_argument.
class ExplicitBsplineCurve {
 public:
  ExplicitBsplineCurve(int degree, const std::vector<Real>& knots, const std::vector<Real>& coefficients) {
    const auto p = static_cast<std::size_t>(degree);
    if (degree < 1 || p > greatest_degree || coefficients.size() < p + 1 ||
        knots.size() != coefficients.size() + p + 1) {
      throw std::invalid_argument(
          "explicit B-spline: degree 1 to 9, degree + 1 more knots than coefficients");
    }
    if (!std::is_sorted(knots.begin(), knots.end()) || knots[p] != 0 || knots[coefficients.size()] != 1) {
      throw std::invalid_argument("explicit B-spline: knots ascend, from 0 to 1 without the outer ones");
    }
    for (std::size_t i = 1; i < coefficients.size(); ++i) {
      if (knots[i] > 0 && knots[i] < 1 && knots[i] == knots[i + p]) {
        throw std::invalid_argument("explicit B-spline: an inner knot is repeated too often");
      }
    }
    for (std::size_t span = p; span < coefficients.size(); ++span) {
      if (!(knots[span] < knots[span + 1])) continue;
      std::vector<Real> ordinates;
      for (std::size_t j = 0; j <= p; ++j) ordinates.push_back(blossom(p, knots, coefficients, span, j));
      starts_.push_back(knots[span]);
      lengths_.push_back(knots[span + 1] - knots[span]);
      pieces_.emplace_back(ordinates);
    }
  }

  CurvePoint operator()(Real r) const {
    if (r < 0) return {1, 0, 0};
    if (r > 1) return {0, 0, 0};
    const std::size_t segment = segment_of(starts_, r);
    const Real length = lengths_[segment];
    const CurvePoint inside = pieces_[segment]((r - starts_[segment]) / length);
    return {inside.value, inside.first / length, inside.second / (length * length)};
  }

 private:
  /// Bézier ordinate number j of the span: de Boor's algorithm with the span's end for j of its p arguments
  /// and the span's start for the others.
  static Real blossom(std::size_t p, const std::vector<Real>& knots, const std::vector<Real>& coefficients,
                      std::size_t span, std::size_t j) {
    std::array<Real, greatest_degree + 1> points{};
    for (std::size_t i = 0; i <= p; ++i) points[i] = coefficients[span - p + i];
    for (std::size_t level = 1; level <= p; ++level) {
      const Real argument = level <= j ? knots[span + 1] : knots[span];
      for (std::size_t i = p; i >= level; --i) {
        const Real low = knots[span - p + i];
        const Real high = knots[span + 1 + i - level];
        const Real share = (argument - low) / (high - low);
        points[i] = (1 - share) * points[i - 1] + share * points[i];
      }
    }
    return points[p];
  }

  std::vector<Real> starts_;
  std::vector<Real> lengths_;
  std::vector<BernsteinPolynomial> pieces_;
};

/// The cubic Bézier curve (r(t), F(t)) as a function of r. std::invalid_argument unless the first control
/// point has r = 0, the last r = 1, and r′(t) > 0 on all of [0, 1] (no fold, no vertical slope).
class ParametricBezierCurve {
 public:
  struct ControlPoint {
    Real r{};
    Real f{};
  };

  explicit ParametricBezierCurve(const std::array<ControlPoint, 4>& points) {
    const auto powers = [](Real p0, Real p1, Real p2, Real p3) {
      return PowerPolynomial{{p0, 3 * (p1 - p0), 3 * (p0 - 2 * p1 + p2), p3 - p0 + 3 * (p1 - p2)}, 3};
    };
    abscissa_ = powers(points[0].r, points[1].r, points[2].r, points[3].r);
    ordinate_ = powers(points[0].f, points[1].f, points[2].f, points[3].f);
    const Real summit = -abscissa_.coefficients[2] / (3 * abscissa_.coefficients[3]);
    const Real least = summit > 0 && summit < 1 ? abscissa_(summit).first : abscissa_(0).first;
    const bool rises = least > 0 && abscissa_(0).first > 0 && abscissa_(1).first > 0;
    if (points[0].r != 0 || points[3].r != 1 || !rises) {
      throw std::invalid_argument(
          "parametric Bezier: r runs from 0 to 1 and rises strictly with the parameter");
    }
    parameters_.back() = 1;
    for (std::size_t i = 1; i + 1 < parameters_.size(); ++i) {
      parameters_[i] = solve(static_cast<Real>(i) / cells, parameters_[i - 1], 1);
    }
  }

  /// The curve of KW Fig. 11 with control points (0, 1), (c, 1), (1 − c, 0), (1, 0): 0 < c < 1.
  explicit ParametricBezierCurve(Real c) : ParametricBezierCurve({{{0, 1}, {c, 1}, {1 - c, 0}, {1, 0}}}) {}

  /// The t in [0, 1] with r(t) = r, for r in [0, 1].
  Real parameter(Real r) const {
    const auto cell = std::min(static_cast<std::size_t>(r * cells), parameters_.size() - 2);
    return solve(r, parameters_[cell], parameters_[cell + 1]);
  }

  CurvePoint operator()(Real r) const {
    if (r < 0) return {1, 0, 0};
    if (r > 1) return {0, 0, 0};
    const Real t = parameter(r);
    const CurvePoint across = abscissa_(t);
    const CurvePoint up = ordinate_(t);
    const Real slope = up.first / across.first;
    return {up.value, slope, (up.second - slope * across.second) / (across.first * across.first)};
  }

 private:
  static constexpr int cells = 256;

  /// Newton's method from the chord of a bracket, halving the bracket whenever a step would leave it; done
  /// when the error that a step leaves, r″ δ²/(2 r′), is below rounding.
  Real solve(Real r, Real low, Real high) const {
    const Real low_r = abscissa_(low).value;
    const Real high_r = abscissa_(high).value;
    if (r <= low_r) return low;
    if (r >= high_r) return high;
    Real t = low + (high - low) * (r - low_r) / (high_r - low_r);
    for (int round = 0; round < 200; ++round) {
      const CurvePoint here = abscissa_(t);
      const Real step = (r - here.value) / here.first;
      (step < 0 ? high : low) = t;
      const Real next = t + step;
      const bool bracketed = next >= low && next <= high;
      const Real remaining = std::fabs(step * step * here.second);
      if (bracketed && remaining <= std::numeric_limits<Real>::epsilon() * here.first * t) return next;
      t = bracketed ? next : (low + high) / 2;
    }
    return t;
  }

  PowerPolynomial abscissa_;
  PowerPolynomial ordinate_;
  std::array<Real, cells + 1> parameters_{};
};

}  // namespace nearfield::reference
