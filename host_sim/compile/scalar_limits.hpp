// What a number type leaves of the range that the format gives a parameter.
#pragma once

#include <string>
#include <string_view>

#include "compile/field_scalar.hpp"
#include "model/operators.hpp"

namespace nearfield::host {

struct ScalarLimits {
  std::string_view name;   // as `nearfield eval --scalar` has it
  double domain = 0.0;     // of coordinates, sizes and factors
  double end = 0.0;        // reciprocals and quotients of parameters stay below this
  double least = 0.0;      // number that does not become 0
  double algebraic = 0.0;  // algebraic values saturate here
};
ScalarLimits limits_of(FieldScalar scalar);

// The part of `range` in which numbers are what `fit` asks for. Of Fit::not_zero without the gap around 0.
NumberRange fitting_range(const ScalarLimits& limits, Fit fit, const NumberRange& range);
// Whether a number of the range is one of fitting_range(), and of Fit::not_zero not 0 once it is rounded.
bool fits(const ScalarLimits& limits, Fit fit, double value);
// fitting_range() in words.
std::string describe_fitting(const ScalarLimits& limits, Fit fit, const NumberRange& range);

}  // namespace nearfield::host
