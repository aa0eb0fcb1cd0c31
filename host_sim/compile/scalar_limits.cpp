#include "compile/scalar_limits.hpp"

#include <algorithm>
#include <cmath>

#include <nearfield/shape/algebraic_bounds.hpp>

namespace nearfield::host {
namespace {

constexpr std::string_view names[] = {"q27", "q24", "q16", "float"};
constexpr double least_normal_float = 1.17549435082228750797e-38;

}  // namespace

ScalarLimits limits_of(FieldScalar scalar) {
  return with_scalar(scalar, [scalar](auto zero) {
    using S = decltype(zero);
    using T = ScalarTraits<S>;
    ScalarLimits limits;
    limits.name = names[static_cast<std::size_t>(scalar)];
    limits.domain = T::to_double(T::domain());
    limits.end = T::is_fixed ? std::ldexp(1.0, 31 - fraction_bits_of<S>) : T::to_double(T::greatest());
    limits.least = T::is_fixed ? std::ldexp(0.5, -fraction_bits_of<S>) : least_normal_float;
    limits.algebraic = T::to_double(algebraic_limit<S>());
    return limits;
  });
}

NumberRange fitting_range(const ScalarLimits& limits, Fit fit, const NumberRange& range) {
  const double scale = fit == Fit::edge ? 2.0 : 1.0;
  NumberRange fitting = range;
  if (fit == Fit::any) return fitting;
  fitting.highest = std::min(range.highest, scale * limits.domain);
  if (fit == Fit::number || fit == Fit::not_zero) {
    fitting.lowest = std::max(range.lowest, -limits.domain);
  } else if (range.lowest < scale * limits.least) {
    fitting.lowest = scale * limits.least;
    fitting.lowest_excluded = false;
  }
  return fitting;
}

bool fits(const ScalarLimits& limits, Fit fit, double value) {
  if (fit == Fit::not_zero && !(std::abs(value) > limits.least)) return false;
  return contains(fitting_range(limits, fit, {}), value);
}

std::string describe_fitting(const ScalarLimits& limits, Fit fit, const NumberRange& range) {
  const std::string text = describe(fitting_range(limits, fit, range));
  return fit == Fit::not_zero ? text + ", more than " + format_number(limits.least) + " from 0" : text;
}

}  // namespace nearfield::host
