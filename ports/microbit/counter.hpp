// The counter behind board/instruction_counter.hpp: SysTick, which counts down at the core's 16 MHz, 4.096
// ticks an instruction. It has 24 bits and wraps around to its greatest value.
#pragma once

#include <stdint.h>

namespace nearfield::board {

constexpr uint32_t kGreatestInstructionCount = 4095999;

struct SysTick {
  volatile uint32_t control;
  volatile uint32_t reload;
  volatile uint32_t value;
};

inline SysTick& sys_tick() { return *reinterpret_cast<SysTick*>(uintptr_t{0xE000E010}); }

inline void start_counter() {
  constexpr uint32_t kEnable = 1;
  constexpr uint32_t kCoreClock = 4;
  sys_tick().control = 0;
  sys_tick().reload = 0xFFFFFF;
  sys_tick().value = 0;  // any value clears it; the first tick reloads it
  sys_tick().control = kCoreClock | kEnable;
}

inline uint32_t read_counter() { return sys_tick().value; }

// The two readings are each exact to below one tick.
inline uint32_t instructions_between(uint32_t start, uint32_t stop) {
  const uint32_t ticks = (start - stop) & 0xFFFFFF;
  return static_cast<uint32_t>((uint64_t{ticks} * 125 + 256) >> 9);
}

}  // namespace nearfield::board
