// Tables of curves baked while the program runs: the same steps as tabulate() in the compiler, and the same bits.
#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include <nearfield/curve/tabulate.hpp>

#include "curves/catalogue.hpp"

namespace nearfield::host {

// Value and slope per unit of the curve's own argument.
struct BakedSample {
  double value = 0.0;
  double slope = 0.0;
};

// S: Fixed<27>, Fixed<24>, Fixed<16> or float.
template <class S> struct BakedCurve {
  CurveLayout<S> layout;
  int slope_headroom = 0;
  std::vector<std::uint32_t> wide;    // coefficients of 32 bits
  std::vector<std::int16_t> narrow;   // or of 16
  TableFacts table_facts;
  double error = 0.0;        // greatest |table - exact|, arguments' rounding included
  double slope_error = 0.0;  // per unit of the curve's argument, where the curve has a slope

  // At x rounded to S.
  BakedSample sample(S x) const;
  BakedSample sample_at(double x) const { return sample(S(static_cast<S>(x))); }
};

// Nothing when no table of at most request.greatest_bytes comes within the error asked for, or the curve does not fit
// into one at all. Precondition: curve.problem() == nullptr. With bits = 16, S is Fixed.
template <class S> std::optional<BakedCurve<S>> bake_curve(const AnyCurve& curve, const TableRequest& request);

}  // namespace nearfield::host
