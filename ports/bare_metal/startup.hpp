// What start-up does on every core between its own first instructions and main(), and after main().
#pragma once

extern "C" {
// .data, .bss and the painted stack. It needs a stack pointer and nothing else.
void initialise_memory();

// Ends the emulation with what main() returned.
[[noreturn]] void exit_after_main(int status);
}

namespace nearfield::board {

// The emulator's exit status after a fault.
constexpr int kFaultExitStatus = 112;

}  // namespace nearfield::board
