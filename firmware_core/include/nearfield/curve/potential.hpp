// Potential functions of soft objects in closed form: from 1 at the skeleton, r = 0, to 0 at the influence radius,
// r = 1 (KW; Hsu). Exact forms in `double`, for baking: never linked into a target.
#pragma once

#include <nearfield/curve/curve.hpp>

namespace nearfield::potential {

// What all potentials share. `order`: derivatives that vanish at 0 and 1.
constexpr CurveFacts potential_facts(int order, bool antisymmetric, bool centred) {
  CurveFacts facts;
  facts.continuous_derivatives = facts.vanishing_derivatives = order;
  facts.direction = Direction::falling;
  facts.antisymmetric = antisymmetric;
  facts.centred = centred;
  return facts;
}
constexpr bool outside(const Differentiable& r) { return r.value <= 0.0 || r.value >= 1.0; }
constexpr Differentiable end_value(const Differentiable& r) { return r.value <= 0.0 ? 1.0 : 0.0; }

// 1 - 3 r^2 + 2 r^3; order 1, centred (KW).
struct Cubic {
  static constexpr const char* name = "cubic";
  constexpr Differentiable operator()(const Differentiable& r) const {
    return outside(r) ? end_value(r) : 1.0 - (3.0 - 2.0 * r) * square(r);
  }
  constexpr CurveFacts facts() const { return potential_facts(1, true, true); }
  static constexpr Cubic from(const ParameterValues*) { return {}; }
  constexpr const char* problem() const { return nullptr; }
};

// The cubic in u = r^2 of order 1 through (radius, intensity): (1 - u)^2 (1 + c u). Through (1/2, 1/2) it is
// 1 - (22/9) r^2 + (17/9) r^4 - (4/9) r^6 (KW).
struct Wyvill {
  static constexpr const char* name = "wyvill";
  static constexpr CurveParameter parameters[] = {
      number_parameter("radius", "r of the interior point that the curve passes through", 0.1, 0.9, 0.5),
      number_parameter("intensity", "value there", 0.01, 0.99, 0.5)};
  double radius = 0.5;
  double intensity = 0.5;

  constexpr double bulge() const {
    const double u = radius * radius;
    return (intensity / ((1.0 - u) * (1.0 - u)) - 1.0) / u;
  }
  constexpr Differentiable operator()(const Differentiable& r) const {
    if (outside(r)) return end_value(r);
    const Differentiable u = square(r);
    return square(1.0 - u) * (1.0 + bulge() * u);
  }
  constexpr CurveFacts facts() const { return potential_facts(1, false, magnitude((*this)(0.5).value - 0.5) < 1e-12); }
  static constexpr Wyvill from(const ParameterValues* values) { return {values[0].number(), values[1].number()}; }
  constexpr ControlPoints control_points() const {
    ControlPoints points;
    points.add(radius, intensity);
    return points;
  }
  constexpr const char* problem() const {
    if (!(radius > 0.0 && radius < 1.0)) return "radius lies between 0 and 1";
    return bulge() >= -1.0 && bulge() <= 2.0 ? nullptr : "a curve through this point is not monotone";
  }
};
inline constexpr Wyvill wyvill{};

// 1/2 - atan(c1 (r - c2)) / pi: hard blending. It misses (0, 1) and (1, 0) by facts().end_jump (KW).
struct Arctangent {
  static constexpr const char* name = "arctangent";
  static constexpr CurveParameter parameters[] = {number_parameter("c1", "steepness", 1, 1000, 10),
                                                  number_parameter("c2", "r of the value 1/2", 0.1, 0.9, 0.5)};
  double c1 = 10.0;
  double c2 = 0.5;

  constexpr Differentiable inside(const Differentiable& r) const { return 0.5 - atan(c1 * (r - c2)) * (1.0 / kPi); }
  constexpr Differentiable operator()(const Differentiable& r) const {
    return outside(r) ? end_value(r) : inside(r);
  }
  constexpr CurveFacts facts() const {
    CurveFacts facts = potential_facts(-1, c2 == 0.5, c2 == 0.5);
    facts.vanishing_derivatives = 0;
    const double at_start = 1.0 - inside(0.0).value, at_end = inside(1.0).value;
    facts.end_jump = at_start > at_end ? at_start : at_end;
    return facts;
  }
  static constexpr Arctangent from(const ParameterValues* values) { return {values[0].number(), values[1].number()}; }
  constexpr const char* problem() const {
    if (!(c1 >= 1.0 && c1 <= 1000.0)) return "c1 is 1 to 1000";
    return c2 >= 0.1 && c2 <= 0.9 ? nullptr : "c2 is 0.1 to 0.9";
  }
};

// The same with both ends pinned: (F(r) - F(1)) / (F(0) - F(1)); meant for c1 < 50 (KW).
struct ArctangentClamped {
  static constexpr const char* name = "arctangent_clamped";
  static constexpr const auto& parameters = Arctangent::parameters;
  double c1 = 10.0;
  double c2 = 0.5;

  constexpr Arctangent plain() const { return {c1, c2}; }
  constexpr Differentiable operator()(const Differentiable& r) const {
    if (outside(r)) return end_value(r);
    const double last = plain().inside(1.0).value, first = plain().inside(0.0).value;
    return (plain().inside(r) - last) * (1.0 / (first - last));
  }
  constexpr CurveFacts facts() const { return potential_facts(0, c2 == 0.5, c2 == 0.5); }
  static constexpr ArctangentClamped from(const ParameterValues* values) { return {values[0].number(), values[1].number()}; }
  constexpr const char* problem() const { return plain().problem(); }
};

// Blanc's potential with softness s, in u = r^2, C^1 at r = 1/2: 1 - (3 u)^2 / (s + (4.5 - 4 s) u) up to there,
// (1 - u)^2 / (0.75 - s + (1.5 + 4 s) u) beyond (Hsu).
struct Blanc {
  static constexpr const char* name = "blanc";
  static constexpr CurveParameter parameters[] = {number_parameter("s", "softness", 0, 100, 1)};
  double s = 1.0;

  constexpr Differentiable operator()(const Differentiable& r) const {
    if (outside(r)) return end_value(r);
    const Differentiable u = square(r);
    if (r.value > 0.5) return square(1.0 - u) / (0.75 - s + (1.5 + 4.0 * s) * u);
    return s == 0.0 ? 1.0 - 2.0 * u : 1.0 - 9.0 * square(u) / (s + (4.5 - 4.0 * s) * u);
  }
  constexpr CurveFacts facts() const {
    CurveFacts facts = potential_facts(1, false, true);
    facts.add_break(0.5);
    return facts;
  }
  static constexpr Blanc from(const ParameterValues* values) { return {values[0].number()}; }
  constexpr const char* problem() const { return s >= 0.0 && s <= 100.0 ? nullptr : "s is 0 to 100"; }
};

}  // namespace nearfield::potential
