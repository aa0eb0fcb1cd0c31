// From reset to main() on a RISC-V core in machine mode: memory, write protection of the code; and what traps
// do.
#include <bare_metal/memory_layout.hpp>
#include <bare_metal/startup.hpp>
#include <board/console.hpp>

extern "C" {
void reset_handler();
void trap_handler();
void protect_code();
[[noreturn]] void report_trap(uintptr_t cause, uintptr_t program_counter, uintptr_t value,
                              bool stack_overflow);
}

namespace {

using nearfield::board::write;
using nearfield::board::write_hexadecimal;

void write_field(const char* name, uintptr_t value) {
  write(name);
  write_hexadecimal(value, static_cast<int>(2 * sizeof value));
}

}  // namespace

// The linker must not make the loading of gp relative to gp.
[[gnu::naked, gnu::section(".reset"), gnu::used]] void reset_handler() {
  asm volatile(
      ".option push               \n"
      ".option norelax            \n"
      "la gp, __global_pointer$   \n"
      ".option pop                \n"
      "la sp, stack_top           \n"
      "la t0, trap_handler        \n"
      "csrw mtvec, t0             \n"
      "call initialise_memory     \n"
      "call protect_code          \n"
      "call main                  \n"
      "call exit_after_main       \n");
}

// Everything below RAM becomes read-only, in machine mode as well and until reset: the code, address zero,
// and what a stack grows into that is too large.
void protect_code() {
  constexpr uintptr_t kReadable = 1, kExecutable = 4, kUpToAddress = 1 << 3, kLocked = 1 << 7;
  asm volatile("csrw pmpaddr0, %0" ::"r"(reinterpret_cast<uintptr_t>(stack_bottom) >> 2));
  asm volatile("csrw pmpcfg0, %0" ::"r"(kReadable | kExecutable | kUpToAddress | kLocked) : "memory");
}

// After a stack overflow nothing can be called, so the report then runs on a fresh stack.
[[gnu::naked, gnu::aligned(4)]] void trap_handler() {
  asm volatile(
      "csrr a0, mcause        \n"
      "csrr a1, mepc          \n"
      "csrr a2, mtval         \n"
      "la t0, stack_bottom    \n"
      "sltu a3, sp, t0        \n"
      "beqz a3, 1f            \n"
      "la sp, stack_top       \n"
      "1: call report_trap    \n");
}

void report_trap(uintptr_t cause, uintptr_t program_counter, uintptr_t value, bool stack_overflow) {
  write_field("trap: cause ", cause);
  write_field(", pc ", program_counter);
  write_field(", value ", value);
  write(stack_overflow ? ", stack overflow\n" : "\n");
  nearfield::board::exit_with_status(nearfield::board::kFaultExitStatus);
}
