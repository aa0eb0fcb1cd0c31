// Tables of instruction counts on the console.
#pragma once

#include <board/console.hpp>
#include <board/worst_instruction_count.hpp>

namespace nearfield::board {

// Worst instructions of two forms of one kernel: the value alone, and with slope or gradient.
struct Cost {
  uint32_t value;
  uint32_t both;
};

inline void write_padded(const char* text, size_t width) {
  write(text);
  size_t length = 0;
  while (text[length] != '\0') ++length;
  for (; length < width; ++length) write(" ");
}
inline void write_right_aligned(uint32_t number, size_t width) {
  size_t digits = 1;
  for (uint32_t rest = number; rest >= 10; rest /= 10) ++digits;
  for (; digits < width; ++digits) write(" ");
  write_decimal(number);
}

// Whether both are counts.
inline bool write_row(const char* name, Cost cost) {
  write_padded(name, 40);
  write_right_aligned(cost.value, 7);
  write_right_aligned(cost.both, 7);
  write("\n");
  const bool counted = cost.value != 0 && cost.both != 0;
  if (!counted) write("  0 is no count: a measurement failed\n");
  return counted;
}

}  // namespace nearfield::board
