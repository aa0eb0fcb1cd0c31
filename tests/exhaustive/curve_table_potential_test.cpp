// Tables of every potential at every argument of a 24-bit grid, against long double.
#include <curve_rows/potential_rows.hpp>

#include <gtest/gtest.h>

#include "curve_table_check.hpp"

namespace nearfield::curve_tests {
namespace {

INSTANTIATE_TEST_SUITE_P(Formula, CurveTable, testing::ValuesIn(formula_rows()), name_of_row);
INSTANTIATE_TEST_SUITE_P(Arctangent, CurveTable, testing::ValuesIn(arctangent_rows()), name_of_row);
INSTANTIATE_TEST_SUITE_P(Spline, CurveTable, testing::ValuesIn(spline_rows()), name_of_row);
INSTANTIATE_TEST_SUITE_P(Parametric, CurveTable, testing::ValuesIn(parametric_rows()), name_of_row);
INSTANTIATE_TEST_SUITE_P(RangeControl, CurveTable, testing::ValuesIn(range_rows()), name_of_row);

}  // namespace
}  // namespace nearfield::curve_tests
