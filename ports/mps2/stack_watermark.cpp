#include "stack_watermark.hpp"

extern "C" {
extern uint32_t stack_bottom[];
extern uint32_t stack_top[];
uint32_t deepest_changed_stack_word();
}

namespace {

constexpr uint32_t kPattern = 0xA5C3963C;

}  // namespace

// Address of the deepest word that is not as painted. It and stack_bytes_below_caller() use no stack either,
// and of the registers only r0 to r3.
[[gnu::naked, gnu::noinline]] uint32_t deepest_changed_stack_word() {
  asm volatile(
      "ldr r0, =stack_bottom  \n"
      "ldr r1, =%c0           \n"
      "1: cmp sp, r0          \n"
      "beq 2f                 \n"
      "ldr r2, [r0], #4       \n"
      "cmp r2, r1             \n"
      "beq 1b                 \n"
      "subs r0, r0, #4        \n"
      "2: bx lr               \n" ::"i"(kPattern));
}

namespace nearfield::mps2 {

// Hand-written, because it must not use the stack that it paints.
[[gnu::naked, gnu::noinline]] void paint_unused_stack() {
  asm volatile(
      "ldr r0, =stack_bottom  \n"
      "ldr r1, =%c0           \n"
      "b 2f                   \n"
      "1: str r1, [r0], #4    \n"
      "2: cmp sp, r0          \n"
      "bhi 1b                 \n"
      "bx lr                  \n" ::"i"(kPattern));
}

[[gnu::naked, gnu::noinline]] size_t stack_bytes_below_caller() {
  asm volatile(
      "mov r3, lr                    \n"
      "bl deepest_changed_stack_word \n"
      "sub r0, sp, r0                \n"
      "bx r3                         \n");
}

size_t greatest_stack_bytes() {
  return static_cast<uint32_t>(reinterpret_cast<uintptr_t>(stack_top)) - deepest_changed_stack_word();
}

size_t stack_size_bytes() { return static_cast<size_t>(stack_top - stack_bottom) * sizeof(uint32_t); }

}  // namespace nearfield::mps2
