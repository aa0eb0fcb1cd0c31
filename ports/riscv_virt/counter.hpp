// The counter behind board/instruction_counter.hpp: the core's own count of retired instructions. QEMU
// derives it from the time: it is exact only where an instruction takes 1 ns.
#pragma once

#include <stdint.h>

namespace nearfield::board {

constexpr uint32_t kGreatestInstructionCount = 0xFFFFFFFF;

inline void start_counter() {}

// The lower half on a 32-bit core.
inline uint32_t read_counter() {
  uintptr_t retired;
  asm volatile("csrr %0, minstret" : "=r"(retired)::"memory");
  return static_cast<uint32_t>(retired);
}

inline uint32_t instructions_between(uint32_t start, uint32_t stop) { return stop - start; }

}  // namespace nearfield::board
