// Counts the instructions that a piece of the program executes. Valid only in QEMU with
// -icount shift=8,align=off,sleep=off (toolchains/qemu-mps2.sh), where every instruction takes 256 ns: 6.4
// ticks of the board's 25 MHz timers. The 32-bit timer 0 of the board is used rather than the 24-bit SysTick:
// it holds 671 million instructions instead of 2.6 million and needs no interrupt.
//
//   start_instruction_count();
//   work();
//   const uint32_t instructions = stop_instruction_count();
//
// The count is that of all instructions between the two calls, those that pass arguments and call included,
// and exact: an empty measurement reads 0. It covers at most kGreatestInstructionCount instructions; more
// wrap around. Measurements do not nest. Work that is inlined may be moved across the calls by the compiler
// if it touches no memory: measure calls of functions that are not inlined.
#pragma once

#include <stdint.h>

namespace nearfield::mps2 {

constexpr uint32_t kGreatestInstructionCount = 671088639;

// Calibrates; call it once before the first measurement. Returns false if a loop of known length does not
// measure as that, which means that the emulator does not run in the mode described above.
bool prepare_instruction_counter();

void start_instruction_count();
uint32_t stop_instruction_count();

}  // namespace nearfield::mps2
