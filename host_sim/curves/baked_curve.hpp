// Tables of curves baked while the program runs: the same steps as tabulate() in the compiler, and the same bits.
#pragma once

#include <cstdint>
#include <optional>
#include <type_traits>
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
  std::vector<std::uint32_t> wide;    // coefficients of 32 bits
  std::vector<std::int16_t> narrow;   // or of 16
  TableFacts table_facts;
  double error = 0.0;        // greatest |table - exact|, arguments' rounding included
  double slope_error = 0.0;  // per unit of the curve's argument, where the curve has a slope

  // At x rounded to S.
  BakedSample sample(S x) const;
  BakedSample sample_at(double x) const { return sample(S(static_cast<S>(x))); }
};

// Calls work(degree, bits, rising) with the numbers as types.
template <class S, class Work> auto with_format(const TableShape& shape, bool rising, const Work& work) {
  const auto with_rising = [&](auto degree, auto bits) {
    return rising ? work(degree, bits, std::true_type{}) : work(degree, bits, std::false_type{});
  };
  const auto with_bits = [&](auto degree) {
    if constexpr (ScalarTraits<S>::is_fixed) {
      if (shape.bits == 16) return with_rising(degree, std::integral_constant<int, 16>{});
    }
    return with_rising(degree, std::integral_constant<int, 32>{});
  };
  return shape.degree == 1   ? with_bits(std::integral_constant<int, 1>{})
         : shape.degree == 2 ? with_bits(std::integral_constant<int, 2>{})
                             : with_bits(std::integral_constant<int, 3>{});
}

// Its table, whose format the caller knows.
template <int degree, int bits, class S> TableView<S, degree, bits> view_of(const BakedCurve<S>& curve) {
  TableView<S, degree, bits> view;
  if constexpr (bits == 16) view.coefficients = curve.narrow.data();
  else view.coefficients = curve.wide.data();
  view.index_bits = curve.layout.scale.index_bits;
  view.slope_headroom = curve.layout.scale.slope_headroom;
  return view;
}

// Calls work(view, rising) with the table's format as types.
template <class S, class Work> auto with_view(const BakedCurve<S>& curve, const Work& work) {
  return with_format<S>(curve.layout.shape, curve.layout.rising, [&](auto degree, auto bits, auto rising) {
    return work(view_of<degree.value, bits.value>(curve), rising);
  });
}

// Nothing when no table of at most request.greatest_bytes comes within the error asked for, or the curve does not fit
// into one at all. Precondition: curve.problem() == nullptr. With bits = 16, S is Fixed.
template <class S> std::optional<BakedCurve<S>> bake_curve(const AnyCurve& curve, const TableRequest& request);

}  // namespace nearfield::host
