#pragma once
/// What a baked table promises about its curve, checked against a long double reference of the curve.

#include <curve_rows/curve_row.hpp>

#include <gtest/gtest.h>

#include <vector>

namespace nearfield::curve_tests {

/// Everything about the tables of a row: Fixed<27> at every argument of a 24-bit grid over the curve's range,
/// Fixed<16> and float at those of them that both can represent. One printed line a table.
void check_tables(const CurveRow& row);

/// Tables of other formats, as the requests say, at every argument of a 20-bit grid; Fixed<27> and Fixed<16>.
void check_formats(const CurveRow& row, const std::vector<TableRequest>& requests);

class CurveTable : public testing::TestWithParam<CurveRow> {};

}  // namespace nearfield::curve_tests
