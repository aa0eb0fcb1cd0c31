// What the rest of ports/ needs to know of a RISC-V core.
#pragma once

#include <stdint.h>

namespace nearfield::board {

// One request to the emulator or debugger, and its answer. The three instructions mark it as such; they must
// be uncompressed and lie in one page.
[[gnu::noinline]] inline uintptr_t semihosting_call(uintptr_t operation, const void* arguments) {
  register uintptr_t a0 asm("a0") = operation;
  register const void* a1 asm("a1") = arguments;
  asm volatile(
      ".option push       \n"
      ".option norvc      \n"
      ".balign 16         \n"
      "slli x0, x0, 0x1f  \n"
      "ebreak             \n"
      "srai x0, x0, 7     \n"
      ".option pop        \n"
      : "+r"(a0)
      : "r"(a1)
      : "memory");
  return a0;
}

inline uintptr_t stack_pointer() {
  uintptr_t address;
  asm volatile("mv %0, sp" : "=r"(address));
  return address;
}

// 1 + 498 * 2 + 2 instructions, with the call of it 1000.
[[gnu::naked, gnu::noinline]] inline void run_thousand_instructions() {
  asm volatile(
      "li a0, 498        \n"
      "1: addi a0, a0, -1 \n"
      "bnez a0, 1b       \n"
      "nop               \n"
      "ret               \n");
}

}  // namespace nearfield::board
