#include "instruction_counter.hpp"

extern "C" {
uint32_t instruction_counter_ticks_at_start;
uint32_t instruction_counter_overhead;
void run_known_loop();
}

namespace nearfield::mps2 {
namespace {

// Timer 0 of the board (CMSDK APB timer) counts down and starts again at RELOAD.
struct Timer {
  volatile uint32_t control;
  volatile uint32_t value;
  volatile uint32_t reload;
};

constexpr uintptr_t kTimerAddress = 0x40000000;
constexpr uint32_t kEnable = 1;

constexpr uint32_t kKnownLoopInstructions = 1000;

}  // namespace
}  // namespace nearfield::mps2

// 1 + 498 * 2 + 2 instructions, with the call of it 1000.
[[gnu::naked, gnu::noinline]] void run_known_loop() {
  asm volatile(
      "mov r0, #498    \n"
      "1: subs r0, #1  \n"
      "bne 1b          \n"
      "nop             \n"
      "bx lr           \n");
}

namespace nearfield::mps2 {

bool prepare_instruction_counter() {
  auto* timer = reinterpret_cast<Timer*>(kTimerAddress);
  timer->control = 0;
  timer->reload = 0xFFFFFFFF;
  timer->value = 0xFFFFFFFF;
  timer->control = kEnable;

  instruction_counter_overhead = 0;
  start_instruction_count();
  instruction_counter_overhead = stop_instruction_count();

  start_instruction_count();
  run_known_loop();
  return stop_instruction_count() == kKnownLoopInstructions;
}

// Hand-written, so that the number of instructions between the reading of the timer here and the one in
// stop_instruction_count() is the same wherever the two are called.
[[gnu::naked, gnu::noinline]] void start_instruction_count() {
  asm volatile(
      "ldr r1, =instruction_counter_ticks_at_start \n"
      "mov r2, #0x40000000                         \n"
      "ldr r0, [r2, #4]                            \n"
      "str r0, [r1]                                \n"
      "bx lr                                       \n");
}

namespace {

[[gnu::used]] uint32_t instructions_since_start(uint32_t ticks_now) asm("instructions_since_start");

uint32_t instructions_since_start(uint32_t ticks_now) {
  const uint32_t ticks = instruction_counter_ticks_at_start - ticks_now;
  // 6.4 ticks an instruction; the two readings are each exact to below one tick.
  const auto instructions = static_cast<uint32_t>((uint64_t{ticks} * 5 + 16) >> 5);
  return instructions - instruction_counter_overhead;
}

}  // namespace

[[gnu::naked, gnu::noinline]] uint32_t stop_instruction_count() {
  asm volatile(
      "mov r2, #0x40000000        \n"
      "ldr r0, [r2, #4]           \n"
      "b instructions_since_start \n");
}

}  // namespace nearfield::mps2
