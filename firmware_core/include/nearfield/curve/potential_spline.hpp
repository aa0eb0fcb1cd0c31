// Potential functions from control points: natural cubic spline, Bezier and B-spline (KW). Each refuses control points
// that make it rise. Exact forms in `double`, for baking: never linked into a target.
#pragma once

#include <nearfield/curve/potential.hpp>

namespace nearfield::potential {

// Whether a curve rises anywhere, seen at 48 places of each of its pieces.
template <class Curve> constexpr bool rises(const Curve& curve) {
  const CurveFacts facts = curve.facts();
  for (int piece = 0; piece <= facts.break_count; ++piece) {
    const double start = piece == 0 ? 0.0 : facts.breaks[piece - 1];
    const double end = piece == facts.break_count ? 1.0 : facts.breaks[piece];
    for (int i = 0; i < 48; ++i) {
      if (curve(Differentiable::argument(start + (end - start) * ((i + 0.5) / 48))).first > 1e-9) return true;
    }
  }
  return false;
}

// The natural cubic spline through count points (r, intensity), the first at r = 0 with 1, the last at r = 1 with 0.
struct NaturalSpline {
  static constexpr int greatest_count = 10;
  static constexpr const char* name = "natural_spline";
  static constexpr CurveParameter parameters[] = {
      {"r", "places of the points, ascending from 0 to 1", 0, 1, false, 3, greatest_count, 5, {0, 0.25, 0.5, 0.75, 1}},
      {"intensity", "values there, from 1 to 0", 0, 1, false, 3, greatest_count, 5, {1, 0.85, 0.5, 0.15, 0}}};
  int count = 0;
  double r[greatest_count] = {};
  double intensity[greatest_count] = {};
  double bend[greatest_count] = {};  // second derivatives at the points

  static constexpr NaturalSpline from(const ParameterValues* values) {
    NaturalSpline spline;
    spline.count = values[0].count == values[1].count ? values[0].count : 0;
    for (int i = 0; i < spline.count && i < greatest_count; ++i) {
      spline.r[i] = values[0].values[i];
      spline.intensity[i] = values[1].values[i];
    }
    if (spline.points_in_order()) spline.solve();
    return spline;
  }
  constexpr Differentiable operator()(const Differentiable& x) const {
    if (outside(x) || count < 2) return end_value(x);
    int i = 0;
    while (i + 2 < count && x.value >= r[i + 1]) ++i;
    const double h = r[i + 1] - r[i];
    const Differentiable b = (x - r[i]) * (1.0 / h), a = 1.0 - b;
    return intensity[i] * a + intensity[i + 1] * b +
           (h * h / 6.0) * ((a * a * a - a) * bend[i] + (b * b * b - b) * bend[i + 1]);
  }
  constexpr CurveFacts facts() const {
    CurveFacts facts = potential_facts(0, is_antisymmetric(), magnitude((*this)(0.5).value - 0.5) < 1e-12);
    for (int i = 1; i + 1 < count; ++i) facts.add_break(r[i]);
    return facts;
  }
  constexpr ControlPoints control_points() const {
    ControlPoints points;
    for (int i = 0; i < count; ++i) points.add(r[i], intensity[i]);
    return points;
  }
  constexpr const char* problem() const {
    if (!points_in_order()) return "as many values as places; places ascend from 0 to 1, values go from 1 to 0";
    return rises(*this) ? "the spline through these points is not monotone" : nullptr;
  }

 private:
  constexpr bool points_in_order() const {
    if (count < 3 || count > greatest_count || r[0] != 0.0 || r[count - 1] != 1.0) return false;
    for (int i = 1; i < count; ++i) {
      if (!(r[i] - r[i - 1] >= 1e-6)) return false;
    }
    return intensity[0] == 1.0 && intensity[count - 1] == 0.0;
  }
  constexpr bool is_antisymmetric() const {
    for (int i = 0; i < count; ++i) {
      if (magnitude(r[i] + r[count - 1 - i] - 1.0) > 1e-15) return false;
      if (magnitude(intensity[i] + intensity[count - 1 - i] - 1.0) > 1e-15) return false;
    }
    return true;
  }
  // The tridiagonal system of the second derivatives, which are 0 at both ends.
  constexpr void solve() {
    double diagonal[greatest_count] = {}, right[greatest_count] = {};
    for (int i = 1; i + 1 < count; ++i) {
      const double before = r[i] - r[i - 1], after = r[i + 1] - r[i];
      const double factor = i > 1 ? before / diagonal[i - 1] : 0.0;
      diagonal[i] = 2.0 * (before + after) - factor * (i > 1 ? before : 0.0);
      right[i] = 6.0 * ((intensity[i + 1] - intensity[i]) / after - (intensity[i] - intensity[i - 1]) / before) -
                 factor * (i > 1 ? right[i - 1] : 0.0);
    }
    for (int i = count - 2; i >= 1; --i) bend[i] = (right[i] - (r[i + 1] - r[i]) * bend[i + 1]) / diagonal[i];
  }
};

// Coefficients from 1 to 0: how many at each end equal it.
constexpr int end_multiplicity(const double* coefficients, int count) {
  int first = 0, last = 0;
  while (first < count && coefficients[first] == 1.0) ++first;
  while (last < count && coefficients[count - 1 - last] == 0.0) ++last;
  return first < last ? first : last;
}
constexpr bool descend(const double* coefficients, int count) {
  for (int i = 1; i < count; ++i) {
    if (coefficients[i] > coefficients[i - 1]) return false;
  }
  return true;
}
constexpr bool mirrored(const double* coefficients, int count) {
  for (int i = 0; i < count; ++i) {
    if (magnitude(coefficients[i] + coefficients[count - 1 - i] - 1.0) > 1e-15) return false;
  }
  return true;
}

// The non-parametric Bezier curve sum b_j B_j^n(r); k + 1 ones first and k + 1 zeros last give order k.
struct Bezier {
  static constexpr int greatest_degree = 9;
  static constexpr const char* name = "bezier";
  static constexpr CurveParameter parameters[] = {
      {"b", "coefficients, the first 1, the last 0", 0, 1, false, 2, greatest_degree + 1, 6, {1, 1, 1, 0, 0, 0}}};
  int degree = 0;
  double b[greatest_degree + 1] = {};

  static constexpr Bezier from(const ParameterValues* values) {
    Bezier curve;
    curve.degree = values[0].count - 1;
    for (int i = 0; i <= curve.degree && i <= greatest_degree; ++i) curve.b[i] = values[0].values[i];
    return curve;
  }
  // De Casteljau.
  constexpr Differentiable operator()(const Differentiable& r) const {
    if (outside(r)) return end_value(r);
    Differentiable row[greatest_degree + 1] = {};
    for (int i = 0; i <= degree; ++i) row[i] = b[i];
    for (int n = degree; n > 0; --n) {
      for (int i = 0; i < n; ++i) row[i] = row[i] + r * (row[i + 1] - row[i]);
    }
    return row[0];
  }
  constexpr CurveFacts facts() const {
    const bool antisymmetric = mirrored(b, degree + 1);
    return potential_facts(end_multiplicity(b, degree + 1) - 1, antisymmetric, magnitude((*this)(0.5).value - 0.5) < 1e-12);
  }
  constexpr ControlPoints control_points() const {
    ControlPoints points;
    for (int i = 0; i <= degree; ++i) points.add(static_cast<double>(i) / degree, b[i]);
    return points;
  }
  constexpr const char* problem() const {
    if (degree < 1 || degree > greatest_degree) return "there are 2 to 10 coefficients";
    if (b[0] != 1.0 || b[degree] != 0.0) return "the first coefficient is 1, the last 0";
    return descend(b, degree + 1) || !rises(*this) ? nullptr : "the curve of these coefficients is not monotone";
  }
};

// The non-parametric B-spline sum b_j N_j(r) of a degree over the knots 0 (degree + 1 times), `knots`, 1 (degree + 1
// times): degree + 1 + knot_count coefficients.
struct BSpline {
  static constexpr int greatest_degree = 5, greatest_knot_count = 8;
  static constexpr int greatest_count = greatest_degree + 1 + greatest_knot_count;
  static constexpr const char* name = "bspline";
  static constexpr CurveParameter parameters[] = {
      integer_parameter("degree", "degree of the pieces", 1, greatest_degree, 3),
      {"knots", "interior knots, ascending", 0, 1, false, 0, greatest_knot_count, 3, {0.25, 0.5, 0.75}},
      {"b", "coefficients, the first 1, the last 0", 0, 1, false, 2, greatest_count, 7, {1, 1, 0.9, 0.5, 0.1, 0, 0}}};
  int degree = 0;
  int knot_count = 0;
  int count = 0;
  double knots[greatest_knot_count] = {};
  double b[greatest_count] = {};

  static constexpr BSpline from(const ParameterValues* values) {
    BSpline curve;
    curve.degree = values[0].integer();
    curve.knot_count = values[1].count;
    curve.count = values[2].count;
    for (int i = 0; i < curve.knot_count && i < greatest_knot_count; ++i) curve.knots[i] = values[1].values[i];
    for (int i = 0; i < curve.count && i < greatest_count; ++i) curve.b[i] = values[2].values[i];
    return curve;
  }
  // De Boor.
  constexpr Differentiable operator()(const Differentiable& r) const {
    if (outside(r)) return end_value(r);
    int span = degree;
    while (span + 1 < count && r.value >= knot(span + 1)) ++span;
    Differentiable row[greatest_degree + 1] = {};
    for (int i = 0; i <= degree; ++i) row[i] = b[span - degree + i];
    for (int level = 1; level <= degree; ++level) {
      for (int i = degree; i >= level; --i) {
        const double low = knot(span - degree + i), high = knot(span + i + 1 - level);
        row[i] = row[i - 1] + (r - low) * (1.0 / (high - low)) * (row[i] - row[i - 1]);
      }
    }
    return row[degree];
  }
  constexpr CurveFacts facts() const {
    bool antisymmetric = mirrored(b, count);
    int multiplicity = 0, greatest_multiplicity = 0;
    for (int i = 0; i < knot_count; ++i) {
      multiplicity = i > 0 && knots[i] == knots[i - 1] ? multiplicity + 1 : 1;
      greatest_multiplicity = multiplicity > greatest_multiplicity ? multiplicity : greatest_multiplicity;
      if (magnitude(knots[i] + knots[knot_count - 1 - i] - 1.0) > 1e-15) antisymmetric = false;
    }
    CurveFacts facts = potential_facts(end_multiplicity(b, count) - 1, antisymmetric, magnitude((*this)(0.5).value - 0.5) < 1e-12);
    // An order above the degree would need more equal coefficients than one piece has.
    if (facts.vanishing_derivatives > degree) facts.vanishing_derivatives = degree;
    const int inside = degree - greatest_multiplicity;
    facts.continuous_derivatives = knot_count > 0 && inside < facts.vanishing_derivatives ? inside : facts.vanishing_derivatives;
    for (int i = 0; i < knot_count; ++i) {
      if (i == 0 || knots[i] != knots[i - 1]) facts.add_break(knots[i]);
    }
    return facts;
  }
  constexpr ControlPoints control_points() const {
    ControlPoints points;
    // At the means of the knots that each coefficient spans.
    for (int i = 0; i < count; ++i) {
      double sum = 0.0;
      for (int j = 1; j <= degree; ++j) sum += knot(i + j);
      points.add(sum / degree, b[i]);
    }
    return points;
  }
  constexpr const char* problem() const {
    if (degree < 1 || degree > greatest_degree) return "the degree is 1 to 5";
    if (knot_count < 0 || knot_count > greatest_knot_count) return "there are at most 8 interior knots";
    if (count != degree + 1 + knot_count) return "there are degree + 1 + (number of knots) coefficients";
    for (int i = 0; i < knot_count; ++i) {
      if (!(knots[i] > 0.0 && knots[i] < 1.0) || (i > 0 && knots[i] < knots[i - 1])) return "the knots ascend between 0 and 1";
      if (i >= degree && knots[i] == knots[i - degree]) return "a knot is repeated at most as often as the degree";
    }
    if (b[0] != 1.0 || b[count - 1] != 0.0) return "the first coefficient is 1, the last 0";
    return descend(b, count) || !rises(*this) ? nullptr : "the curve of these coefficients is not monotone";
  }

 private:
  constexpr double knot(int i) const { return i <= degree ? 0.0 : i >= count ? 1.0 : knots[i - degree - 1]; }
};

}  // namespace nearfield::potential
