#pragma once
/// Every curve of the core with several parameters each, next to its long double reference: what tests of
/// curves go through.

#include <curves/baked_curve.hpp>
#include <reference/curve_point.hpp>

#include <gtest/gtest.h>

#include <functional>
#include <memory>
#include <ostream>
#include <string>
#include <utility>
#include <vector>

namespace nearfield::curve_tests {

using reference::CurvePoint;
using reference::Real;

/// Which request a curve is expected to meet: 2^-20 in 1 KiB, the same in 16 KiB only, or neither, so that
/// the best of each size is what there is.
enum class Meets { in_one_kibibyte, in_sixteen_kibibytes, nowhere };

struct Expected {
  Meets meets = Meets::in_one_kibibyte;
  int exact_segments = 0;  ///< where a table of that many segments is exact to rounding; 0: of no such curve
  /// Arguments inside the range at which the curve itself has no slope: slopes within 2^-26 of them are not
  /// compared.
  std::vector<double> kinks = {};
  /// A table of 16 KiB follows it to slopes of 127 and more per unit of its argument: more than one in float
  /// holds.
  bool too_steep_for_float = false;
};

/// A curve of the core and what it should be.
struct CurveRow {
  std::string name;
  host::AnyCurve curve;
  /// The reference at count arguments from `first`, `step` apart.
  std::function<void(double first, double step, int count, CurvePoint* points)> reference;
  Expected expected;
};

template <class Curve, class Reference>
CurveRow curve_row(std::string name, const Curve& curve, const Reference& exact, Expected expected = {}) {
  // GoogleTest copies rows.
  const auto shared = std::make_shared<const Reference>(exact);
  return {std::move(name), host::AnyCurve(curve),
          [shared](double first, double step, int count, CurvePoint* points) {
            for (int i = 0; i < count; ++i) points[i] = (*shared)(static_cast<Real>(first + step * i));
          },
          std::move(expected)};
}

inline std::ostream& operator<<(std::ostream& stream, const CurveRow& row) { return stream << row.name; }
inline std::string name_of_row(const testing::TestParamInfo<CurveRow>& info) { return info.param.name; }

}  // namespace nearfield::curve_tests
