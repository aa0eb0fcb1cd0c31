// The comparison of potential functions as it stands in ports/KERNEL.md.
#include <gtest/gtest.h>

#include <fstream>
#include <iterator>
#include <string>

#include "curves/comparison.hpp"

namespace {

using namespace nearfield::host;

TEST(CurveComparison, StandsInTheRecord) {
  std::ifstream file(NEARFIELD_SOURCE_DIR "/ports/KERNEL.md");
  const std::string record{std::istreambuf_iterator<char>(file), std::istreambuf_iterator<char>()};
  const std::string text = comparison_text(compare_potentials());
  EXPECT_NE(record.find(text), std::string::npos) << text;
}

// What the paper says in words.
TEST(CurveComparison, AgreesWithThePapersJudgement) {
  const auto rows = compare_potentials();
  ASSERT_EQ(rows.size(), 6u);
  const auto flexibility = [&rows](std::size_t i) { return rows[i].steepest_slope / rows[i].gentlest_slope; };
  EXPECT_EQ(flexibility(0), 1.0) << "the cubic polynomial in r^2 has none";
  EXPECT_GT(rows[5].steepest_slope, rows[2].steepest_slope) << "a parametric spline is harder than any Bezier curve";
  EXPECT_GT(rows[4].steepest_slope, 300.0) << "c1 / pi";
  EXPECT_EQ(rows[2].greatest_order, 4) << "degree 9";
  EXPECT_GT(rows[4].end_jump, 0.0);
}

}  // namespace
