// What `nearfield curve` prints. Every text ends with a line end.
#pragma once

#include <string>

#include "curves/curve_study.hpp"

namespace nearfield::host {

// The curve with the parameters that were set: `bezier, b = (1, 1, 0, 0)`.
std::string headline_of(const CurveStudy& study);

// The table in a few words: `degree 3, 32 segments over r^2, 512 bytes`; or that there is none.
std::string table_in_words(const CurveStudy& study);

// `1.61e-07 = 2^-22.57`; `0` for 0.
std::string error_in_words(double error);

// That no table comes within the error asked for, and how near the best one comes; empty when one does. One
// line without its end.
std::string missed_error_of(const CurveStudy& study);

// Facts, table, stated errors and `count` samples.
std::string text_report_of(const CurveStudy& study, int count);

// argument, exact, table, error, exact_slope, table_slope, slope_error, exact_second_derivative; numbers that
// read back as the same double. What concerns the table is empty where there is none.
std::string csv_report_of(const CurveStudy& study, int count);

// All curves with their parameters, a block each.
std::string list_of_curves();

}  // namespace nearfield::host
