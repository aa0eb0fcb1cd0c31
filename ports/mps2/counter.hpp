// The counter behind board/instruction_counter.hpp: timer 0 of the board (CMSDK APB timer), which counts down at
// 25 MHz, 6.4 ticks an instruction; on AN505 at 20 MHz, by its address in secure state. It has 32 bits where SysTick
// has 24.
#pragma once

#include <stdint.h>

namespace nearfield::board {

constexpr bool kIsAn505 = __ARM_ARCH == 8;
constexpr uint32_t kTicksOf125Instructions = kIsAn505 ? 640 : 800;
constexpr uint32_t kGreatestInstructionCount =
    static_cast<uint32_t>((uint64_t{1} << 32) * 125 / kTicksOf125Instructions) - 1;

struct Timer {
  volatile uint32_t control;
  volatile uint32_t value;
  volatile uint32_t reload;
};

inline Timer& timer() { return *reinterpret_cast<Timer*>(uintptr_t{kIsAn505 ? 0x50000000 : 0x40000000}); }

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
  return static_cast<uint32_t>((uint64_t{start - stop} * 125 + kTicksOf125Instructions / 2) / kTicksOf125Instructions);
}

}  // namespace nearfield::board
