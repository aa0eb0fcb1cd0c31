// How an influence radius changes along a skeleton and about it (KW: f1, f3), as the factors 1 / f that the operations of
// modify/ray_scale.hpp sample. Exact forms in `double`, for baking: never linked into a target.
#pragma once

#include <nearfield/number/differentiable.hpp>
#include <nearfield/table/fit.hpp>

namespace nearfield {

// The cubic spline through 2 to 16 values at equal distances over [0, 1]: natural, the last value at 1; or periodic, the first
// one again at 1.
struct ValueSpline {
  static constexpr int greatest_count = 16;
  int count = 0;
  bool periodic = false;
  double values[greatest_count] = {};
  double bends[greatest_count] = {};  // second derivatives times the sixth part of the squared distance

  constexpr ValueSpline() = default;
  // Precondition: 2 <= value_count <= greatest_count.
  constexpr ValueSpline(const double* given, int value_count, bool closed) : count(value_count), periodic(closed) {
    for (int i = 0; i < count; ++i) values[i] = given[i];
    // bend before + 4 bend + bend after = second difference: each pass leaves less than a third of the error.
    for (int pass = 0; pass < 48; ++pass) {
      for (int i = periodic ? 0 : 1; i < (periodic ? count : count - 1); ++i) {
        const int before = i > 0 ? i - 1 : count - 1, after = i + 1 < count ? i + 1 : 0;
        bends[i] = (values[before] - 2.0 * values[i] + values[after] - bends[before] - bends[after]) / 4.0;
      }
    }
  }

  constexpr int pieces() const { return periodic ? count : count - 1; }
  constexpr Differentiable operator()(const Differentiable& x) const {
    const Differentiable place = pieces() * x;
    int i = place.value > 0.0 ? static_cast<int>(place.value) : 0;
    if (i >= pieces()) i = pieces() - 1;
    const int next = i + 1 < count ? i + 1 : 0;
    const Differentiable b = place - static_cast<double>(i), a = 1.0 - b;
    return values[i] * a + values[next] * b + (a * a * a - a) * bends[i] + (b * b * b - b) * bends[next];
  }
  constexpr detail::Breaks breaks() const {
    detail::Breaks breaks;
    for (int i = 1; i < pieces(); ++i) breaks.add(static_cast<double>(i) / pieces());
    return breaks;
  }
};

// The least and the greatest value of a function over [0, 1], as seen at 1025 places.
struct ProfileRange {
  double least = 0.0, greatest = 0.0;
};
template <class Radius> constexpr ProfileRange range_of(const Radius& radius) {
  ProfileRange range{radius(Differentiable(0.0)).value, radius(Differentiable(0.0)).value};
  for (int i = 1; i <= 1024; ++i) {
    const double value = radius(Differentiable(i / 1024.0)).value;
    if (value < range.least) range.least = value;
    if (value > range.greatest) range.greatest = value;
  }
  return range;
}

// Radii that tables hold, over that of the operand: factors are below 2, and within a ratio that ray_cut() allows.
inline constexpr double kLeastProfileRadius = 0.51, kGreatestProfileRadius = 7.0, kGreatestProfileRatio = 7.0;
template <class Radius> constexpr bool fits_table(const Radius& radius) {
  const ProfileRange range = range_of(radius);
  return range.least >= kLeastProfileRadius && range.greatest <= kGreatestProfileRadius &&
         range.greatest <= kGreatestProfileRatio * range.least;
}

// 1 / radius over a skeleton's parameter, 0 to 1, or over a distance (ScaleAlong, ScaleFromAxis).
template <class Radius> struct AlongProfile {
  Radius radius;
  constexpr detail::Breaks breaks() const { return detail::breaks_of(radius, 0); }
  constexpr Differentiable operator()(const Differentiable& t) const { return 1.0 / radius(t); }
};
template <class Radius> constexpr AlongProfile<Radius> along_profile(Radius radius) { return {radius}; }

// 1 / radius over an angle as diamond_angle() has it (ScaleAbout); the radius over the angle in turns, 0 to 1, with the same
// value and slope at both.
template <class Radius> struct AboutProfile {
  Radius radius;

  // The angle, in turns.
  static constexpr Differentiable turn(const Differentiable& u) {
    const Differentiable quarters = 4.0 * u;
    int quarter = quarters.value > 0.0 ? static_cast<int>(quarters.value) : 0;
    if (quarter > 3) quarter = 3;
    const Differentiable b = quarters - static_cast<double>(quarter), a = 1.0 - b;
    const Differentiable in_quarter = b.value < 0.5 ? atan(b / a) : 0.5 * kPi - atan(a / b);
    return 0.25 * quarter + (0.5 / kPi) * in_quarter;
  }
  // Where a direction of so many turns is.
  static constexpr double place_of(double turns) {
    const int quarter = static_cast<int>(4.0 * turns);
    const double angle = 0.5 * kPi * (4.0 * turns - quarter);
    const double sine = exact_sin(angle), cosine = exact_cos(angle);
    return 0.25 * (quarter + sine / (sine + cosine));
  }
  constexpr detail::Breaks breaks() const {
    detail::Breaks breaks;
    for (int i = 1; i < 4; ++i) breaks.add(0.25 * i);
    const detail::Breaks of_radius = detail::breaks_of(radius, 0);
    for (int i = 0; i < of_radius.count; ++i) {
      const double place = place_of(of_radius.places[i]), quarters = 4.0 * place;
      if (magnitude(quarters - detail::nearest_integer(quarters)) > 1e-9) breaks.add(place);
    }
    return breaks;
  }
  constexpr Differentiable operator()(const Differentiable& u) const { return 1.0 / radius(turn(u)); }
};
template <class Radius> constexpr AboutProfile<Radius> about_profile(Radius radius) { return {radius}; }

}  // namespace nearfield
