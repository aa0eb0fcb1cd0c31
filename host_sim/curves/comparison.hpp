// The comparison of potential functions of KW, Table 1, as far as it can be measured without a target: flexibility and
// smoothness, and the table of each. What they cost in instructions is measured by ports/kernel_costs.cpp.
#pragma once

#include <string>
#include <vector>

namespace nearfield::host {

struct ComparisonRow {
  std::string name;            // as in the paper
  double gentlest_slope = 0.0; // of those that its parameters allow, magnitude at r = 1/2
  double steepest_slope = 0.0;
  int least_order = 0;         // derivatives that vanish at both ends
  int greatest_order = 0;
  double end_jump = 0.0;       // greatest jump at an end, of functions that only approximate
  int table_bytes = 0;         // of the table of the gentlest one within 2^-20
};

std::vector<ComparisonRow> compare_potentials();

// A heading and one line a row, aligned.
std::string comparison_text(const std::vector<ComparisonRow>& rows);

}  // namespace nearfield::host
