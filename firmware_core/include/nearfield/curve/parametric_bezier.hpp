// Potential functions as parametric cubic Bezier curves (r(t), F(t)), solved for t while a table is baked (KW).
// Exact forms in `double`: never linked into a target.
#pragma once

#include <nearfield/curve/potential.hpp>

namespace nearfield::potential {

// Control points (0, 1), (r1, f1), (r2, f2), (1, 0). It must be a function of r: dr/dt > 0 everywhere.
struct ParametricBezierPoints {
  static constexpr const char* name = "parametric_bezier_points";
  static constexpr CurveParameter parameters[] = {
      {"first", "r and intensity of the second control point", 0, 1, false, 2, 2, 2, {0.6, 1}},
      {"second", "r and intensity of the third control point", 0, 1, false, 2, 2, 2, {0.4, 0}}};
  double r1 = 0.6, f1 = 1.0;
  double r2 = 0.4, f2 = 0.0;

  static constexpr ParametricBezierPoints from(const ParameterValues* values) {
    return {values[0].values[0], values[0].values[1], values[1].values[0], values[1].values[1]};
  }
  constexpr Differentiable operator()(const Differentiable& r) const {
    if (outside(r)) return end_value(r);
    const Differentiable t = Differentiable::argument(parameter_at(r.value));
    const Differentiable x = component(0.0, r1, r2, 1.0, t), y = component(1.0, f1, f2, 0.0, t);
    const double slope = y.first / x.first;
    const Differentiable here = chain(r, y.value, slope, (y.second - slope * x.second) / (x.first * x.first));
    // What is left of r - x(t) after the last step.
    return {here.value + slope * (r.value - x.value), here.first, here.second};
  }
  constexpr CurveFacts facts() const {
    const bool antisymmetric = magnitude(r1 + r2 - 1.0) < 1e-15 && magnitude(f1 + f2 - 1.0) < 1e-15;
    return potential_facts(f1 == 1.0 && f2 == 0.0 ? 1 : 0, antisymmetric, magnitude((*this)(0.5).value - 0.5) < 1e-12);
  }
  constexpr ControlPoints control_points() const {
    ControlPoints points;
    points.add(0.0, 1.0);
    points.add(r1, f1);
    points.add(r2, f2);
    points.add(1.0, 0.0);
    return points;
  }
  constexpr const char* problem() const {
    // dr/dt / 3 = r1 (1-t)^2 + 2 (r2 - r1) t (1-t) + (1 - r2) t^2 is positive when its ends are and, where the middle
    // coefficient is negative, that one stays above -sqrt of their product.
    const double a = r1, b = r2 - r1, c = 1.0 - r2;
    if (!(a > 0.0 && c > 0.0)) return "a vertical slope at an end: the first r is above 0, the second below 1";
    if (b < 0.0 && b * b >= a * c) return "the curve folds back or is vertical inside: it is no function of r";
    const double u = 1.0 - f1, v = f1 - f2, w = f2;
    if (!(u >= 0.0 && w >= 0.0) || (v < 0.0 && v * v > u * w)) return "the curve of these points is not monotone";
    return nullptr;
  }

 private:
  static constexpr Differentiable component(double a, double b, double c, double d, const Differentiable& t) {
    const Differentiable s = 1.0 - t;
    return s * s * s * a + 3.0 * s * s * t * b + 3.0 * s * t * t * c + t * t * t * d;
  }
  // Newton's steps within a bracket, to the last bit but a few.
  constexpr double parameter_at(double r) const {
    double low = 0.0, high = 1.0, t = r;
    for (int i = 0; i < 24; ++i) {
      const double s = 1.0 - t;
      const double off = 3.0 * s * s * t * r1 + 3.0 * s * t * t * r2 + t * t * t - r;
      if (off > 0.0) high = t;
      else low = t;
      const double next = t - off / (3.0 * (s * s * r1 + 2.0 * s * t * (r2 - r1) + t * t * (1.0 - r2)));
      const double taken = next >= low && next <= high ? next : 0.5 * (low + high);
      if (magnitude(taken - t) < 1e-16) break;
      t = taken;
    }
    return t;
  }
};

// The curve of KW, figure 11: control points (0, 1), (c, 1), (1 - c, 0), (1, 0). c = 1/3 gives the cubic, c
// towards 1 hard blending.
struct ParametricBezier {
  static constexpr const char* name = "parametric_bezier";
  static constexpr CurveParameter parameters[] = {number_parameter("c", "r of the second control point", 1.0 / 3.0, 0.98, 0.6)};
  double c = 0.6;

  constexpr ParametricBezierPoints points() const { return {c, 1.0, 1.0 - c, 0.0}; }
  constexpr Differentiable operator()(const Differentiable& r) const { return points()(r); }
  constexpr CurveFacts facts() const { return points().facts(); }
  static constexpr ParametricBezier from(const ParameterValues* values) { return {values[0].number()}; }
  constexpr ControlPoints control_points() const { return points().control_points(); }
  constexpr const char* problem() const { return c >= 1.0 / 3.0 && c < 1.0 ? points().problem() : "c is 1/3 or more and below 1"; }
};

}  // namespace nearfield::potential
