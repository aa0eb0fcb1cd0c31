// Measures what each operation of a program costs at the worst, dispatch included, and each part of a query, and checks
// the costs that nearfield/field/costs/ states for this core. A program of one shape costs the query's own share plus that
// shape; a blend, a conversion or a frame is what a program costs beyond its operands by themselves. With any number of
// items, a base and a share for each: a line above all counts that were tried.
#include <operation_costs/blends.hpp>
#include <operation_costs/deformations.hpp>
#include <operation_costs/rays.hpp>
#include <operation_costs/robots.hpp>
#include <operation_costs/skeletons.hpp>
#include <operation_costs/solids.hpp>

int main() {
  using namespace nearfield;
  if (!board::prepare_instruction_counter()) return 1;
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
  costs::report_robots();
  return costs::failures == 0 ? 0 : 1;
}
