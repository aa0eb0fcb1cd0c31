// Text output, arguments and the end of the program by semihosting: the debugger or emulator does the work.
// Without one attached every call here faults.
#pragma once

#include <stddef.h>
#include <stdint.h>

namespace nearfield::board {

// Writes `size` bytes to the standard output of the emulator; nothing is buffered here.
void write(const char* bytes, size_t size);

// Writes a zero-terminated string to the standard output of the emulator.
void write(const char* text);

// Writes a number in decimal.
void write_decimal(uint64_t number);

// Writes the lowest `digits` (1 to 16) hexadecimal digits of a number, lower case, leading zeros kept.
void write_hexadecimal(uint64_t number, int digits);

// Copies the command line, image name first and arguments separated by blanks, to `buffer`, zero-terminated.
// Returns false, with an empty string, if there is none or it does not fit into `size` (at least 1) bytes.
bool read_command_line(char* buffer, size_t size);

// Ends the emulation. The emulator's exit status is the lowest 8 bits of `status`; 0 is success.
[[noreturn]] void exit_with_status(int status);

}  // namespace nearfield::board
