// What the rest of ports/ needs to know of a Cortex-M core.
#pragma once

#include <stdint.h>

namespace nearfield::board {

// One request to the emulator or debugger, and its answer.
inline uintptr_t semihosting_call(uintptr_t operation, const void* arguments) {
  register uintptr_t r0 asm("r0") = operation;
  register const void* r1 asm("r1") = arguments;
  asm volatile("bkpt 0xab" : "+r"(r0) : "r"(r1) : "memory");
  return r0;
}

inline uintptr_t stack_pointer() {
  uintptr_t address;
  asm volatile("mov %0, sp" : "=r"(address));
  return address;
}

// 1 + 498 * 2 + 2 instructions, with the call of it 1000.
[[gnu::naked, gnu::noinline]] inline void run_thousand_instructions() {
  asm volatile(
      "ldr r0, =498    \n"
      "1: subs r0, #1  \n"
      "bne 1b          \n"
      "nop             \n"
      "bx lr           \n");
}

}  // namespace nearfield::board
