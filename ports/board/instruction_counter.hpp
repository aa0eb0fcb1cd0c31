// Counts the instructions that a piece of the program executes. Valid only in QEMU as toolchains/qemu.sh runs
// it, where every instruction takes the same time.
//
//   start_instruction_count();
//   work();
//   const uint32_t instructions = stop_instruction_count();
//
// The count is that of all instructions between the two calls, those that pass arguments and call included,
// and exact: an empty measurement reads 0. It covers at most kGreatestInstructionCount (<counter.hpp> of the
// port) instructions; more wrap around. Measurements do not nest. Work that is inlined may be moved across
// the calls by the compiler if it touches no memory: measure calls of functions that are not inlined, or
// loops as in worst_instruction_count.hpp.
#pragma once

#include <stdint.h>

#include <counter.hpp>

namespace nearfield::board {

// Calibrates; call it once before the first measurement. Returns false if a piece of known length does not
// measure as that, which means that the emulator does not run in the mode described above.
bool prepare_instruction_counter();

void start_instruction_count();
uint32_t stop_instruction_count();

}  // namespace nearfield::board
