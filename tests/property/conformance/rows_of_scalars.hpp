#pragma once
/// Rows whose tolerances depend on the scalar.

#include "property/conformance/conformance.hpp"

namespace nearfield::property {

/// Numbers that every scalar holds exactly: slopes are compared as if they were not rounded.
inline Real even(Real x) { return std::ceil(x * 1024) / 1024; }

/// Gradients are per 1/16 m: what so many units in their last place are per metre, and a relative part.
template <class S>
constexpr Real gradient_tolerance(int units, Real relative) {
  constexpr Real last_places =
      ScalarTraits<S>::is_fixed ? static_cast<Real>(int64_t{1} << fraction_bits_of<S>) : 16777216;
  return relative + 16 * units / last_places;
}

/// Judges a row that is a template in every scalar.
template <template <class> class Row>
void judge_rows(std::uint64_t usual_seed) {
  const std::uint64_t seed = reference::announced_seed(Row<float>::name, usual_seed);
  conformance::Judge<Row<Fixed<27>>, Fixed<27>>(seed).run();
  conformance::Judge<Row<Fixed<16>>, Fixed<16>>(seed + 1).run();
  conformance::Judge<Row<float>, float>(seed + 2).run();
}

}  // namespace nearfield::property
