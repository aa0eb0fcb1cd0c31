// From an exact function to the polynomial of one segment of a table, and how far off that is. All of it is `double`
// and runs in the compiler or on the host: never linked into a target.
#pragma once

#include <nearfield/number/differentiable.hpp>
#include <nearfield/table/table.hpp>

namespace nearfield {

// A uniform partition of a function's range [0, 1].
struct TableShape {
  int degree = 3;
  int segments = 32;
  int bits = 32;            // of a coefficient: 32 or 16
  bool over_square = false; // the argument is the square of the function's own

  constexpr int bytes() const { return (degree + 1) * bits / 8 * segments; }
};

namespace detail {

// Value and slope at both ends of a segment: what its polynomial takes over.
struct SegmentEnds {
  double value[2] = {};
  double slope[2] = {};
};

// f at x as the limit from x + step; kinks and jumps at knots belong to the segments on either side.
template <class Function>
constexpr Differentiable limit_from(const Function& f, double x, double step) {
  const double beside = x + step, moved = beside - x;
  const Differentiable there = f(Differentiable::argument(beside));
  const double first = there.first - moved * there.second;
  return {there.value - moved * (first + 0.5 * moved * there.second), first, there.second};
}
// Steps of the limit: far above the rounding of x, far below a segment.
inline constexpr double kBeside = 1.0 / 17179869184.0;

constexpr double least_magnitude(double a, double b) { return magnitude(a) < magnitude(b) ? a : b; }

// A slope at a knot no steeper than three times the gentler chord beside it: enough for a cubic to be monotone
// wherever the function is.
constexpr double limited_slope(double slope, double chord, double chord_beside) {
  const double limit = 3.0 * least_magnitude(chord, chord_beside);
  if (chord * chord_beside <= 0.0) return 0.0;
  return limit > 0.0 ? (slope > limit ? limit : slope < 0.0 ? 0.0 : slope) : (slope < limit ? limit : slope > 0.0 ? 0.0 : slope);
}

template <class Function>
constexpr SegmentEnds exact_ends(const Function& f, int segment, int segments, bool monotone) {
  const double h = 1.0 / segments, left = segment * h, right = (segment + 1) * h;
  const Differentiable a = limit_from(f, left, h * kBeside), b = limit_from(f, right, -h * kBeside);
  SegmentEnds ends{{a.value, b.value}, {a.first, b.first}};
  if (monotone) {
    const double chord = (b.value - a.value) / h;
    const double before = segment > 0 ? (a.value - f(Differentiable(left - h)).value) / h : chord;
    const double after = segment + 1 < segments ? (f(Differentiable(right + h)).value - b.value) / h : chord;
    ends.slope[0] = limited_slope(a.first, chord, before);
    ends.slope[1] = limited_slope(b.first, chord, after);
  }
  return ends;
}

// Ends of a segment of the given degree. Two segments of degree 2 share the ends of the stretch that they cover and
// meet in its middle with the slope that makes them fit; degree 1 keeps the values alone.
template <class Function>
constexpr SegmentEnds segment_ends(const Function& f, const TableShape& shape, int segment, bool monotone) {
  if (shape.degree != 2) return exact_ends(f, segment, shape.segments, monotone && shape.degree == 3);
  const double h = 1.0 / shape.segments;
  const SegmentEnds pair = exact_ends(f, segment / 2, shape.segments / 2, false);
  const double middle_slope = (pair.value[1] - pair.value[0]) / h - 0.5 * (pair.slope[0] + pair.slope[1]);
  const double middle_value = pair.value[0] + 0.5 * h * (pair.slope[0] + middle_slope);
  return segment % 2 == 0 ? SegmentEnds{{pair.value[0], middle_value}, {pair.slope[0], middle_slope}}
                          : SegmentEnds{{middle_value, pair.value[1]}, {middle_slope, pair.slope[1]}};
}

// c0 + s (c1 + s (c2 + s c3)) h on s in [-1/2, 1/2], h the segment's width.
struct Polynomial {
  double c[4] = {};
  double h = 1.0;

  constexpr double value(double s) const { return c[0] + s * (c[1] + s * (c[2] + s * c[3])) * h; }
  constexpr double slope(double s) const { return c[1] + s * (2 * c[2] + s * 3 * c[3]); }
  constexpr double bend(double s) const { return (2 * c[2] + 6 * s * c[3]) / h; }
  // Bounds the slope and every intermediate result of the kernel.
  constexpr double steepest() const { return magnitude(c[1]) + magnitude(c[2]) + magnitude(c[3]); }
  constexpr double sharpest() const { return (2 * magnitude(c[2]) + 3 * magnitude(c[3])) / h; }
};

constexpr Polynomial polynomial_of(const SegmentEnds& ends, int degree, double h) {
  const double chord = (ends.value[1] - ends.value[0]) / h;
  const double mean_slope = 0.5 * (ends.slope[0] + ends.slope[1]), bend = ends.slope[1] - ends.slope[0];
  Polynomial p;
  p.h = h;
  p.c[0] = 0.5 * (ends.value[0] + ends.value[1]);
  p.c[1] = chord;
  if (degree >= 2) {
    p.c[0] -= 0.125 * h * bend;
    p.c[2] = 0.5 * bend;
  }
  if (degree == 3) {
    p.c[1] = 1.5 * chord - 0.5 * mean_slope;
    p.c[3] = 2 * (mean_slope - chord);
  }
  return p;
}

// How far a segment's polynomial is from the function.
struct Deviation {
  double value = 0.0;
  double slope = 0.0;
  double argument = 0.0;  // what rounding the argument adds to the value

  constexpr double total() const { return value + argument; }
  constexpr void include(double v, double s, double a = 0.0) {
    if (!(v <= value)) value = v;
    if (!(s <= slope)) slope = s;
    if (!(a <= argument)) argument = a;
  }
};

// Places at which a segment is compared with its function, its ends included: eight steps, and more where a table has
// so few segments that they would be far apart.
constexpr int compared_steps(int segments) {
  int steps = 8;
  while (steps * segments < 512) steps *= 2;
  return steps;
}

// Where a function may have kinks or jumps of a derivative, in [0, 1], ascending.
struct Breaks {
  static constexpr int greatest_count = 40;
  int count = 0;
  double places[greatest_count] = {};

  // In order; not what is outside.
  constexpr void add(double place) {
    if (!(place > 0.0 && place < 1.0) || count == greatest_count) return;
    int i = count++;
    for (; i > 0 && places[i - 1] > place; --i) places[i] = places[i - 1];
    places[i] = place;
  }
};
template <class Function> constexpr auto breaks_of(const Function& f, int) -> decltype(f.breaks()) { return f.breaks(); }
template <class Function> constexpr Breaks breaks_of(const Function&, long) { return {}; }

// Compares a segment's polynomial with its function from place to place.
class Comparison {
 public:
  constexpr Comparison(const Polynomial& polynomial, int segment) : polynomial_(polynomial), segment_(segment) {}

  // The next place x, up to which nothing was known to break, with the exact function there as seen from before it.
  constexpr void reach(double x, const Differentiable& exact) {
    const Differentiable here = deviation_at(x, exact);
    const double w = x - x_;
    const double kink = magnitude(here.first - before_.first - 0.5 * w * (here.second + before_.second));
    const double bend = greatest_of_two(magnitude(here.second), magnitude(before_.second));
    worst_.include(greatest_of_two(magnitude(here.value), magnitude(before_.value)) + 0.25 * w * (kink + w * bend),
                   greatest_of_two(magnitude(here.first), magnitude(before_.first)) + kink +
                       0.25 * w * magnitude(here.second - before_.second));
    start(x, exact);
  }
  // Starts anew at x, with the exact function as seen from behind it.
  constexpr void start(double x, const Differentiable& exact) {
    x_ = x;
    before_ = deviation_at(x, exact);
  }
  constexpr const Deviation& worst() const { return worst_; }

 private:
  constexpr Differentiable deviation_at(double x, const Differentiable& exact) const {
    const double s = x / polynomial_.h - segment_ - 0.5;
    return {polynomial_.value(s) - exact.value, polynomial_.slope(s) - exact.first, polynomial_.bend(s) - exact.second};
  }

  const Polynomial& polynomial_;
  int segment_;
  double x_ = 0.0;
  Differentiable before_;
  Deviation worst_;
};

// The greatest deviation of `polynomial` from f, from the deviation e and its derivatives at steps + 1 places and on both
// sides of f's breaks. Between two places w apart e leaves its chord by at most w / 4 times the variation of e' there.
// That is how far e' goes by its second derivative, plus what that does not explain: a kink between the places. The
// slope e' is bounded likewise.
template <class Function>
constexpr Deviation deviation_of(const Polynomial& polynomial, const Function& f, int segment, int segments, int steps) {
  const double h = 1.0 / segments, beside = h * kBeside;
  const Breaks breaks = breaks_of(f, 0);
  Comparison comparison(polynomial, segment);
  comparison.start(segment * h, limit_from(f, segment * h, beside));
  int next_break = 0;
  for (int place = 1; place <= steps; ++place) {
    const double before = (segment + (place - 1.0) / steps) * h, x = (segment + static_cast<double>(place) / steps) * h;
    for (; next_break < breaks.count && breaks.places[next_break] < x - beside; ++next_break) {
      const double at = breaks.places[next_break];
      if (at <= before + beside) continue;
      comparison.reach(at, limit_from(f, at, -beside));
      comparison.start(at, limit_from(f, at, beside));
    }
    const bool last = place == steps;
    comparison.reach(x, last ? limit_from(f, x, -beside) : f(Differentiable::argument(x)));
  }
  return comparison.worst();
}

// What storing a segment's coefficients and the kernel's rounding add to its deviation, in the value.
template <class S> constexpr double rounding_of_value(int bits) {
  if (!ScalarTraits<S>::is_fixed) return 1.5 / 4194304.0;
  return bits == 32 ? 4.0 / 1073741824.0 : 1.0 / 32768.0;
}

}  // namespace detail
}  // namespace nearfield
