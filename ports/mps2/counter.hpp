// The counter behind board/instruction_counter.hpp: timer 0 of the board (CMSDK APB timer), which counts down
// at 25 MHz, 6.4 ticks an instruction. It has 32 bits where SysTick has 24.
#pragma once

#include <stdint.h>

namespace nearfield::board {

constexpr uint32_t kGreatestInstructionCount = 671088639;

struct Timer {
  volatile uint32_t control;
  volatile uint32_t value;
  volatile uint32_t reload;
};

inline Timer& timer() { return *reinterpret_cast<Timer*>(uintptr_t{0x40000000}); }

inline void start_counter() {
  constexpr uint32_t kEnable = 1;
  timer().control = 0;
  timer().reload = 0xFFFFFFFF;
  timer().value = 0xFFFFFFFF;
  timer().control = kEnable;
}

inline uint32_t read_counter() { return timer().value; }

// The two readings are each exact to below one tick.
inline uint32_t instructions_between(uint32_t start, uint32_t stop) {
  return static_cast<uint32_t>((uint64_t{start - stop} * 5 + 16) >> 5);
}

}  // namespace nearfield::board
