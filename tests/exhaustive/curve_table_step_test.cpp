// Tables of every step at every argument of a 24-bit grid, against long double.
#include <curve_rows/step_rows.hpp>

#include <gtest/gtest.h>

#include "curve_table_check.hpp"

namespace nearfield::curve_tests {
namespace {

INSTANTIATE_TEST_SUITE_P(PolynomialStep, CurveTable, testing::ValuesIn(polynomial_rows()), name_of_row);
INSTANTIATE_TEST_SUITE_P(CutoffStep, CurveTable, testing::ValuesIn(cutoff_rows()), name_of_row);
INSTANTIATE_TEST_SUITE_P(LogisticStep, CurveTable, testing::ValuesIn(logistic_rows()), name_of_row);

}  // namespace
}  // namespace nearfield::curve_tests
