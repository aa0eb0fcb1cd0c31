#include "semihosting.hpp"

namespace nearfield::mps2 {
namespace {

// Operation numbers and the stop code are those of Arm's semihosting specification, version 3.
constexpr uint32_t kOpen = 0x01;
constexpr uint32_t kWrite = 0x05;
constexpr uint32_t kGetCommandLine = 0x15;
constexpr uint32_t kExitExtended = 0x20;
constexpr uint32_t kApplicationExit = 0x20026;
constexpr uint32_t kOpenForWriting = 4;

uint32_t address_of(const void* object) { return static_cast<uint32_t>(reinterpret_cast<uintptr_t>(object)); }

uint32_t call(uint32_t operation, const void* arguments) {
  register uint32_t r0 asm("r0") = operation;
  register const void* r1 asm("r1") = arguments;
  asm volatile("bkpt 0xab" : "+r"(r0) : "r"(r1) : "memory");
  return r0;
}

uint32_t open_standard_output() {
  const uint32_t arguments[] = {address_of(":tt"), kOpenForWriting, 3};
  return call(kOpen, arguments);
}

// Zero until opened: no handle of an open file is zero.
uint32_t standard_output = 0;

}  // namespace

void write(const char* bytes, size_t size) {
  if (standard_output == 0) standard_output = open_standard_output();
  const uint32_t arguments[] = {standard_output, address_of(bytes), static_cast<uint32_t>(size)};
  call(kWrite, arguments);
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
  uint32_t arguments[] = {address_of(buffer), static_cast<uint32_t>(size)};
  if (call(kGetCommandLine, arguments) == 0) return true;
  buffer[0] = '\0';
  return false;
}

void exit_with_status(int status) {
  const uint32_t arguments[] = {kApplicationExit, static_cast<uint32_t>(status)};
  call(kExitExtended, arguments);
  for (;;) asm volatile("wfi");
}

}  // namespace nearfield::mps2
