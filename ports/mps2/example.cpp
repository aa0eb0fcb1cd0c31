// A program for the board: what it does goes between the two lines that measure.
#include <mps2/instruction_counter.hpp>
#include <mps2/semihosting.hpp>
#include <mps2/stack_watermark.hpp>

int main() {
  using namespace nearfield::mps2;
  if (!prepare_instruction_counter()) return 1;
  start_instruction_count();
  write("Nearfield on a Cortex-M4\n");
  write_decimal(stop_instruction_count());
  write(" instructions, ");
  write_decimal(greatest_stack_bytes());
  write(" bytes of stack\n");
  return 0;
}
