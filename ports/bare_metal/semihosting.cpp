// The console of a board: the debugger or emulator does the work. Without one attached every call faults.
#include <board/console.hpp>

#include <core.hpp>

namespace nearfield::board {
namespace {

// Operation numbers and the stop code are those of Arm's semihosting specification, version 3,
// which RISC-V shares.
constexpr uintptr_t kOpen = 0x01;
constexpr uintptr_t kWrite = 0x05;
constexpr uintptr_t kExitExtended = 0x20;
constexpr uintptr_t kApplicationExit = 0x20026;
constexpr uintptr_t kOpenForWriting = 4;

uintptr_t address_of(const void* object) { return reinterpret_cast<uintptr_t>(object); }

uintptr_t open_standard_output() {
  const uintptr_t arguments[] = {address_of(":tt"), kOpenForWriting, 3};
  return semihosting_call(kOpen, arguments);
}

// Zero until opened: no handle of an open file is zero.
uintptr_t standard_output = 0;

}  // namespace

void write(const char* bytes, size_t size) {
  if (standard_output == 0) standard_output = open_standard_output();
  const uintptr_t arguments[] = {standard_output, address_of(bytes), size};
  semihosting_call(kWrite, arguments);
}

void exit_with_status(int status) {
  const uintptr_t arguments[] = {kApplicationExit, static_cast<uintptr_t>(status)};
  semihosting_call(kExitExtended, arguments);
  for (;;) asm volatile("wfi");
}

}  // namespace nearfield::board
