// Measures what each operation of a program costs at the worst, dispatch included, and each query, and checks
// the list of nearfield/field/operations.hpp and the queries' budgets against it. A program of one shape
// costs the query's own share plus that shape; a blend, a conversion or a frame is what a program costs
// beyond its operands by themselves.
#include <operation_costs_queries.hpp>

int main() {
  using namespace nearfield;
  if (!board::prepare_instruction_counter()) return 1;
  board::write(
      "worst instructions on this core, and those stated; of any number of items: beyond what is stated of each\n");
  costs::write_heading();
  costs::measure_fields();
  costs::measure_blends();
  costs::report_operations();
  costs::report_frames();
  costs::report_queries();
  return costs::failures == 0 ? 0 : 1;
}
