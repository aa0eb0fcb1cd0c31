// A curve of the catalogue with the parameters that somebody set.
#pragma once

#include <string>
#include <vector>

#include "curves/catalogue.hpp"

namespace nearfield::host {

struct ConfiguredCurve {
  std::string name;
  CurveFamily family = CurveFamily::step;
  std::string parameters;  // `c1 = 10, c2 = 0.5`; empty if it has none
  AnyCurve curve;
};

// The range control that every potential takes besides its own parameters (Hsu): w1 and w2.
const std::vector<CurveParameter>& range_control_parameters();

// What a parameter may be: `from 1 to 1000`, `a whole number from 1 to 8`, `2 to 10 numbers from 0 to 1`.
std::string allowed_values(const CurveParameter& parameter);

// Numbers as they are set: `0.5`, `1,1,0,0`.
std::string settable_text(const double* values, int count);

// The curve called `name`, each of `settings` a NAME=VALUE or NAME=VALUE,VALUE... for one of its parameters;
// the others keep their initial values. InputError for a wrong name (it suggests the nearest), a wrong number
// of values, a value out of range, and parameters that do not fit each other.
ConfiguredCurve configured_curve(const std::string& name, const std::vector<std::string>& settings);

}  // namespace nearfield::host
