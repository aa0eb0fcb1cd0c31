// A program for the board: what it does goes between the two lines that measure.
#include <board/instruction_counter.hpp>
#include <board/console.hpp>
#include <board/stack_watermark.hpp>

int main() {
  using namespace nearfield::board;
  if (!prepare_instruction_counter()) return 1;
  start_instruction_count();
  write("Nearfield on " NEARFIELD_CORE "\n");
  write_decimal(stop_instruction_count());
  write(" instructions, ");
  write_decimal(greatest_stack_bytes());
  write(" bytes of stack\n");
  return 0;
}
