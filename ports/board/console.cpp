#include "console.hpp"

namespace nearfield::board {

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

}  // namespace nearfield::board
