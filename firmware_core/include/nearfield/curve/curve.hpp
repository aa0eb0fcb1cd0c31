// What every exact curve of this floor is: a callable of one bounded argument with facts about itself, and for people a
// name and parameters. Exact forms in `double`, for baking: never linked into a target.
//
// A curve is a struct with
//   constexpr Differentiable operator()(const Differentiable& x) const  value and derivatives; constant outside its range
//   constexpr CurveFacts facts() const
//   constexpr const char* problem() const                               what is wrong with its parameters, nullptr if nothing
//   constexpr ControlPoints control_points() const                      only if it has some
// A callable without the others is a curve as well, over [0, 1]: see curve_facts().
#pragma once

#include <nearfield/number/differentiable.hpp>

namespace nearfield {

enum class Direction : int8_t { falling = -1, none = 0, rising = 1 };

inline constexpr int kInfinitelySmooth = 99;

struct CurveFacts {
  static constexpr int greatest_break_count = 16;

  double from = 0.0, to = 1.0;     // range of the argument
  double before = 1.0;             // value below it, exactly
  double after = 0.0;              // value above it, exactly
  int continuous_derivatives = 0;  // C^k on the whole line; -1 where the value jumps
  int vanishing_derivatives = 0;   // derivatives 1 ... k are 0 at both ends of the range
  Direction direction = Direction::none;  // monotone, or not known to be
  bool antisymmetric = false;      // about the middle of the range: f(m + t) + f(m - t) = before + after
  bool centred = false;            // halfway between `before` and `after` in the middle of the range
  double end_jump = 0.0;           // greatest jump at an end of the range (tails of functions that only approximate)
  double middle_jump = 0.0;        // half the jump in the middle of the range, where the value lies between both sides
  int break_count = 0;             // between pieces, as fractions of the range, ascending
  double breaks[greatest_break_count] = {};

  constexpr double middle() const { return 0.5 * (from + to); }
  constexpr void add_break(double fraction) {
    if (break_count < greatest_break_count && fraction > 0.0 && fraction < 1.0) breaks[break_count++] = fraction;
  }
};

// Points that people move to shape a curve; none for most.
struct ControlPoints {
  static constexpr int greatest_count = 16;
  int count = 0;
  double x[greatest_count] = {};
  double y[greatest_count] = {};

  constexpr void add(double at, double value) {
    if (count == greatest_count) return;
    x[count] = at;
    y[count++] = value;
  }
};

namespace detail {

template <class Curve> constexpr auto declared_facts(const Curve& curve, int) -> decltype(curve.facts()) { return curve.facts(); }
template <class Curve> constexpr CurveFacts declared_facts(const Curve& curve, long) {
  CurveFacts facts;
  facts.before = curve(Differentiable(0.0)).value;
  facts.after = curve(Differentiable(1.0)).value;
  return facts;
}
template <class Curve> constexpr auto declared_problem(const Curve& curve, int) -> decltype(curve.problem()) { return curve.problem(); }
template <class Curve> constexpr const char* declared_problem(const Curve&, long) { return nullptr; }

template <class Curve> constexpr auto declared_points(const Curve& curve, int) -> decltype(curve.control_points()) {
  return curve.control_points();
}
template <class Curve> constexpr ControlPoints declared_points(const Curve&, long) { return {}; }

}  // namespace detail

// Of a callable without facts: range [0, 1], the values outside those at its ends, nothing else assumed.
template <class Curve> constexpr CurveFacts curve_facts(const Curve& curve) { return detail::declared_facts(curve, 0); }
template <class Curve> constexpr const char* curve_problem(const Curve& curve) { return detail::declared_problem(curve, 0); }
template <class Curve> constexpr ControlPoints control_points_of(const Curve& curve) { return detail::declared_points(curve, 0); }

// A parameter that people set by name: a number, or a list of least_count to greatest_count numbers.
struct CurveParameter {
  static constexpr int greatest_list = 24;

  const char* name = "";
  const char* meaning = "";
  double least = 0.0, greatest = 1.0;  // allowed range of each number
  bool integer = false;
  int least_count = 1, greatest_count = 1;
  int initial_count = 1;
  double initial[greatest_list] = {};
};

struct ParameterValues {
  int count = 0;
  double values[CurveParameter::greatest_list] = {};

  constexpr double number() const { return values[0]; }
  constexpr int integer() const { return static_cast<int>(values[0]); }
};

constexpr CurveParameter number_parameter(const char* name, const char* meaning, double least, double greatest, double initial) {
  return {name, meaning, least, greatest, false, 1, 1, 1, {initial}};
}
constexpr CurveParameter integer_parameter(const char* name, const char* meaning, int least, int greatest, int initial) {
  return {name, meaning, static_cast<double>(least), static_cast<double>(greatest), true, 1, 1, 1, {static_cast<double>(initial)}};
}

}  // namespace nearfield
