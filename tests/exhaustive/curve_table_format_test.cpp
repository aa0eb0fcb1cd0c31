// Tables of coefficients of 16 bits, of chords and of parabolas at every argument of a 20-bit grid, against
// long double.
#include <curve_rows/potential_rows.hpp>
#include <curve_rows/step_rows.hpp>

#include <gtest/gtest.h>

#include <vector>

#include "curve_table_check.hpp"

namespace nearfield::curve_tests {
namespace {

class CurveFormat : public testing::TestWithParam<CurveRow> {};

std::vector<CurveRow> format_rows() {
  return {curve_row("polynomial_4", step::Polynomial{4}, reference::PolynomialStepCurve(4)),
          curve_row("wyvill", potential::Wyvill{}, reference::WyvillCurve{}),
          curve_row("arctangent_10_0_4", potential::Arctangent{10, 0.4},
                    reference::ArctangentCurve::plain(10, real(0.4)))};
}

TEST_P(CurveFormat, KeepsItsPromises) {
  std::vector<TableRequest> requests;
  for (const int bits : {32, 16}) {
    for (const int degree : {1, 2, 3}) {
      for (const int bytes : {128, 1024}) requests.push_back({0, bytes, degree, 0, bits});
    }
  }
  check_formats(GetParam(), requests);
}

INSTANTIATE_TEST_SUITE_P(OfThree, CurveFormat, testing::ValuesIn(format_rows()), name_of_row);

}  // namespace
}  // namespace nearfield::curve_tests
