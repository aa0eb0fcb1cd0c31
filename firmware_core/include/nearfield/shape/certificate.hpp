// What is proved about a field, so that its value may be called a clearance.
#pragma once

#include <nearfield/number/sqrt.hpp>

namespace nearfield {

// Valid for points within the domain. All bounds are rounded upwards.
template <class S> struct Certificate {
  bool valid = false;    // parameters in range, and no intermediate result can leave the number range in the domain
  Rate lipschitz;        // |f(p) - f(q)| <= lipschitz |p - q|, f the field in exact arithmetic; of all kinds but
                         // distances per 1/16 m, as their gradients; kNoRateBound: not bounded
  S erosion{};           // m: how far the blended solid may lie inside the sharp solids it is made of
  S inflation{};         // m: how far outside
  S error{};             // greatest |evaluated - f(p)|: parameter rounding, table errors and all roundings of evaluation
  bool partial = false;  // 0 wherever it is not known: no distance for a blend to go by (modify/declared_box.hpp)
  S magnitude{};         // bound of |value| within the reach; 0: not known, but for algebraic fields, of which the greatest
                         // number says that they may saturate; of distances before what inflation and erosion add
  S below_zero{};        // of intensities: how far below 0 the value may be; 0 where no weight is negative
};

// As a lipschitz constant: none is known that fits a Rate. The error is then the greatest number as a rule.
inline constexpr Rate kNoRateBound = Rate::greatest();

inline constexpr Rate kUnitRate = Rate::from_raw(int32_t{1} << Rate::fraction_bits);

// How far from the local origin points may be when a shape is evaluated, in metres.
template <class S> struct Reach {
  S radius{};
};

// The reach of every point that a query accepts.
template <class S> constexpr Reach<S> domain_reach() {
  const S d = ScalarTraits<S>::domain();
  return {length_of<S>(sum_of_squares(d, d, d)) + ScalarTraits<S>::rounding_unit(d)};
}

// The certificate of an exact signed distance to a shape within `extent` of the local origin, whose evaluation is off
// by at most `units` rounding units.
template <class S>
constexpr Certificate<S> exact_distance(Reach<S> reach, S extent, bool parameters_valid, int units) {
  const S farthest = reach.radius + extent;  // bounds every difference of coordinates
  Certificate<S> certificate;
  certificate.valid = parameters_valid && extent >= S{} && farthest < ScalarTraits<S>::greatest();
  certificate.lipschitz = kUnitRate;
  certificate.error = ScalarTraits<S>::times(ScalarTraits<S>::rounding_unit(farthest), units);
  certificate.magnitude = farthest;
  return certificate;
}

template <class S> constexpr bool within(S value, S low, S high) { return value >= low && value <= high; }

// Whether a radius or half extent is positive and within the domain. False for NaN.
template <class S> constexpr bool valid_length(S length) {
  return length > S{} && length <= ScalarTraits<S>::domain();
}

// Whether all coordinates of a shape's point are acceptable: within the domain. False for NaN.
template <class V> constexpr bool coordinates_in_domain(const V& v) {
  const auto limit = ScalarTraits<decltype(v.x + v.x)>::domain();
  return within(v.x, -limit, limit) && within(v.y, -limit, limit) && within(v.z, -limit, limit);
}

}  // namespace nearfield
