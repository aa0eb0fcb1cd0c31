// What table a curve should have, and which ones are considered for it. Runs in the compiler or on the host.
#pragma once

#include <nearfield/curve/tabulated_form.hpp>
#include <nearfield/table/fit.hpp>

namespace nearfield {

enum class TableParameter : uint8_t { automatic, direct, squared };  // the curve's own argument, or its square

struct TableRequest {
  int log2_error = 20;        // greatest error 2^-log2_error in the value; 0 asks for the least that fits
  int greatest_bytes = 1024;  // of coefficients
  int degree = 0;             // 1, 2, 3; 0: chosen
  int segments = 0;           // 0: chosen
  int bits = 32;              // of a coefficient: 32 or 16
  TableParameter parameter = TableParameter::automatic;

  constexpr double greatest_error() const { return log2_error > 0 ? detail::power_of_two(-log2_error) : 4.0; }
};

// The same as a type, for requests in constant expressions: Within<20>, BestOf<1024>, or a struct of one's own with
// a static constexpr TableRequest `value`.
template <int log2_error, int greatest_bytes = 1024, TableParameter parameter = TableParameter::automatic> struct Within {
  static constexpr TableRequest value{log2_error, greatest_bytes, 0, 0, 32, parameter};
};
template <int greatest_bytes, TableParameter parameter = TableParameter::automatic> struct BestOf {
  static constexpr TableRequest value{0, greatest_bytes, 0, 0, 32, parameter};
};
template <int degree, int segments, int bits = 32, TableParameter parameter = TableParameter::automatic> struct Exactly {
  static constexpr TableRequest value{0, 16384, degree, segments, bits, parameter};
};

// Shapes to try, the smallest first; among equals over the square first, which saves a square root, then low degree.
struct CandidateShapes {
  static constexpr int greatest_count = 96;
  int count = 0;
  TableShape shapes[greatest_count] = {};

  constexpr void add(const TableShape& shape) {
    if (count == greatest_count) return;
    int at = count++;
    for (; at > 0 && precedes(shape, shapes[at - 1]); --at) shapes[at] = shapes[at - 1];
    shapes[at] = shape;
  }

 private:
  static constexpr bool precedes(const TableShape& a, const TableShape& b) {
    if (a.bytes() != b.bytes()) return a.bytes() < b.bytes();
    if (a.over_square != b.over_square) return a.over_square;
    return a.degree < b.degree;
  }
};

namespace detail {

// The least number of segments of which some meet at every break; 1 when more than 32 would be needed.
constexpr int aligned_segments(const CurveFacts& facts, bool squared) {
  const Breaks breaks = tabulated_breaks(facts, squared);
  for (int n = 1; n <= 32; ++n) {
    bool aligned = true;
    for (int i = 0; i < breaks.count; ++i) {
      const double place = breaks.places[i] * n;
      aligned = aligned && magnitude(place - nearest_integer(place)) < 1e-9;
    }
    if (aligned) return n;
  }
  return 1;
}

constexpr int greatest_segments(const TableRequest& request, int degree, int step) {
  const int fitting = request.greatest_bytes / ((degree + 1) * request.bits / 8);
  return (fitting < 1024 ? fitting : 1024) / step * step;
}

}  // namespace detail

// Sharp bends belong on knots, so segments come in multiples of the pieces. Chords, whose slope jumps, serve only curves
// that have kinks themselves, unless they are asked for.
constexpr CandidateShapes candidate_shapes(const CurveFacts& facts, const TableRequest& request) {
  CandidateShapes candidates;
  if (facts.middle_jump > request.greatest_error()) return candidates;
  for (int squared = 0; squared < 2; ++squared) {
    const TableParameter this_one = squared != 0 ? TableParameter::squared : TableParameter::direct;
    if (request.parameter != TableParameter::automatic && request.parameter != this_one) continue;
    if (squared != 0 && facts.from != 0.0) continue;
    const int aligned = detail::aligned_segments(facts, squared != 0);
    for (int degree = 1; degree <= 3; ++degree) {
      if (request.degree != 0 && request.degree != degree) continue;
      if (request.degree == 0 && degree == 1 && facts.continuous_derivatives > 0) continue;
      if (request.segments != 0) {
        if (degree != 2 || request.segments % 2 == 0) candidates.add({degree, request.segments, request.bits, squared != 0});
        continue;
      }
      const int step = degree == 2 && aligned % 2 != 0 ? 2 * aligned : aligned;
      const int most = detail::greatest_segments(request, degree, step);
      if (most < step) continue;
      for (int segments = step; segments < most; segments *= 2) candidates.add({degree, segments, request.bits, squared != 0});
      candidates.add({degree, most, request.bits, squared != 0});
    }
  }
  return candidates;
}

// The greatest deviations over segments first ... first + count - 1, with arguments rounded by `argument_error` of the
// range; stops where the total is above `limit`.
template <class Curve>
constexpr detail::Deviation deviation_of_shape(const TabulatedForm<Curve>& form, const TableShape& shape, bool monotone,
                                               double argument_error, int first, int count, double limit) {
  detail::Deviation worst;
  for (int i = first; i < first + count && i < shape.segments; ++i) {
    const detail::SegmentEnds ends = detail::segment_ends(form, shape, i, monotone);
    const detail::Polynomial polynomial = detail::polynomial_of(ends, shape.degree, 1.0 / shape.segments);
    // Few places tell most shapes that do not fit.
    for (int steps = 8; steps > 0; steps = steps < detail::compared_steps(shape.segments) ? detail::compared_steps(shape.segments) : 0) {
      const detail::Deviation here = detail::deviation_of(polynomial, form, i, shape.segments, steps);
      worst.include(here.value, here.slope, argument_error * polynomial.steepest());
      if (!(worst.total() <= limit)) return worst;
    }
  }
  return worst;
}

}  // namespace nearfield
