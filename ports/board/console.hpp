// Text output and the end of the program, on whatever the port has for it: semihosting on a board, the operating
// system, or the runner of a module.
#pragma once

#include <stddef.h>
#include <stdint.h>

namespace nearfield::board {

// Writes `size` bytes; nothing is buffered here.
void write(const char* bytes, size_t size);

// Writes a zero-terminated string.
void write(const char* text);

// Writes a number in decimal.
void write_decimal(uint64_t number);

// Writes the lowest `digits` (1 to 16) hexadecimal digits of a number, lower case, leading zeros kept.
void write_hexadecimal(uint64_t number, int digits);

// Ends the program. The exit status of what ran it is the lowest 8 bits of `status`; 0 is success.
[[noreturn]] void exit_with_status(int status);

}  // namespace nearfield::board
