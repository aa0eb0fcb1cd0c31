// Measures what each operation of a program costs at the worst, dispatch included, and each query, and checks
// the list of nearfield/field/operations.hpp and the queries' budgets against it. A program of one shape
// costs the query's own share plus that shape; a blend, a conversion or a frame is what a program costs
// beyond its operands by themselves.
#include <operation_costs_deformations.hpp>
#include <operation_costs_queries.hpp>
#include <operation_costs_rays.hpp>
#include <operation_costs_skeletons.hpp>
#include <operation_costs_solids.hpp>

int main() {
  using namespace nearfield;
  if (!board::prepare_instruction_counter()) return 1;
  board::write(
      "worst instructions on this core, and those stated; of any number of items: beyond what is stated of each\n");
  costs::write_heading();
  costs::measure_fields();
  costs::measure_solids();
  costs::measure_ray_functions();
  costs::measure_skeletons();
  costs::measure_deformations();
  costs::measure_blends();
  costs::report_operations();
  costs::report_frames();
  costs::report_queries();
  return costs::failures == 0 ? 0 : 1;
}
