#include <board/instruction_counter.hpp>

#include <core.hpp>

namespace nearfield::board {
namespace {

uint32_t reading_at_start;
uint32_t overhead;

}  // namespace

// There is no branch between entry and exit, so the number of instructions between the reading here and the
// one in stop_instruction_count() is the same wherever the two are called.
[[gnu::noinline]] void start_instruction_count() { reading_at_start = read_counter(); }

[[gnu::noinline]] uint32_t stop_instruction_count() {
  const uint32_t reading_at_stop = read_counter();
  return instructions_between(reading_at_start, reading_at_stop) - overhead;
}

bool prepare_instruction_counter() {
  start_counter();
  overhead = 0;
  start_instruction_count();
  overhead = stop_instruction_count();
  start_instruction_count();
  run_thousand_instructions();
  return stop_instruction_count() == 1000;
}

}  // namespace nearfield::board
