// Curves of the catalogue in scenes.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "curves/curve_settings.hpp"
#include "model/operators.hpp"
#include "text/json_node.hpp"

namespace nearfield::host {

// Key of the range control beside a potential.
inline constexpr std::string_view range_control_key = "range_control";

struct ReadCurve {
  std::string name;  // as given, or the default
  ConfiguredCurve curve;
};

// The names that stand for a curve of a family by themselves: those of the catalogue, before them
// `polynomial1` to `polynomial3`, which are the steps of that degree.
std::vector<std::string_view> curve_names(CurveFamily family);

// The curve that `node`, an object, gives under the description's key, or the default curve. InputError on
// unknown names, which it compares with those there are, on wrong values, and on values that do not fit each
// other.
ReadCurve read_curve(const JsonNode& node, const CurveDescription& description);

}  // namespace nearfield::host
