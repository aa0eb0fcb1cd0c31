#include "semihosting.hpp"

#include <core.hpp>

namespace nearfield::board {
namespace {

// Operation numbers and the stop code are those of Arm's semihosting specification, version 3,
// which RISC-V shares.
constexpr uintptr_t kOpen = 0x01;
constexpr uintptr_t kWrite = 0x05;
constexpr uintptr_t kGetCommandLine = 0x15;
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

void write(const char* text) {
  size_t size = 0;
  while (text[size] != '\0') ++size;
  write(text, size);
}

void write_decimal(uint64_t number) {
  char digits[20];
  size_t first = sizeof digits;
  do {
    digits[--first] = static_cast<char>('0' + number % 10);
    number /= 10;
  } while (number != 0);
  write(digits + first, sizeof digits - first);
}

void write_hexadecimal(uint64_t number, int digits) {
  char text[16];
  for (int i = digits - 1; i >= 0; --i) {
    text[i] = "0123456789abcdef"[number & 15];
    number >>= 4;
  }
  write(text, static_cast<size_t>(digits));
}

bool read_command_line(char* buffer, size_t size) {
  uintptr_t arguments[] = {address_of(buffer), size};
  if (semihosting_call(kGetCommandLine, arguments) == 0) return true;
  buffer[0] = '\0';
  return false;
}

void exit_with_status(int status) {
  const uintptr_t arguments[] = {kApplicationExit, static_cast<uintptr_t>(status)};
  semihosting_call(kExitExtended, arguments);
  for (;;) asm volatile("wfi");
}

}  // namespace nearfield::board
