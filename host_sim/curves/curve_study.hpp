// A curve beside its table: what `nearfield curve` reports and draws.
#pragma once

#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "curves/baked_curve.hpp"
#include "curves/curve_settings.hpp"

namespace nearfield::host {

enum class CurveScalar { q27, q24, q16, single };

// A baked curve of any scalar.
struct StudiedTable {
  TableShape shape;
  bool mirrored = false;      // half of the range is stored
  double error = 0.0;         // stated: greatest |table - exact|
  double slope_error = 0.0;   // stated: per unit of the argument, where the curve has a slope
  std::vector<double> knots;  // ends of the segments, ascending, those of a mirrored half included
  std::function<BakedSample(double)> sample_at;  // at an argument that the scalar has
};

struct CurveStudy {
  ConfiguredCurve configured;
  TableRequest request;
  CurveScalar scalar = CurveScalar::q27;
  std::optional<StudiedTable> table;  // nothing: no table of that size holds the curve
  bool within_error = false;          // the table comes within the error asked for

  const AnyCurve& curve() const { return configured.curve; }
  // `r` of potentials, `t` of steps; what they are called as functions: `F` and `μ`.
  const char* argument_name() const { return configured.family == CurveFamily::step ? "t" : "r"; }
  const char* function_name() const { return configured.family == CurveFamily::step ? "μ" : "F"; }
};

// The table that the request asks for, or where no table meets its error, the best one of that size.
CurveStudy study_of(const ConfiguredCurve& configured, const TableRequest& request, CurveScalar scalar);

// `Fixed<27>`, `float`.
std::string type_name(CurveScalar scalar);

// Exact and tabulated, at an argument that the scalar has.
struct CurveRow {
  double argument = 0.0;
  Differentiable exact;
  std::optional<BakedSample> table;

  double error() const { return table ? table->value - exact.value : 0.0; }
  double slope_error() const { return table ? table->slope - exact.first : 0.0; }
};

// `count` (two or more) of them from one end of the range to the other, evenly but for the rounding to the
// scalar. Where a curve jumps at the ends of its range, the first and the last lie just within.
std::vector<CurveRow> rows_of(const CurveStudy& study, int count);

}  // namespace nearfield::host
