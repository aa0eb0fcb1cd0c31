// What an image prints for ports/SIZES.md: the greatest stack since start-up.
#pragma once

#include <board/console.hpp>
#include <board/stack_watermark.hpp>

namespace nearfield::board {

inline void report_stack() {
  const size_t stack = greatest_stack_bytes();
  write("stack ");
  write_decimal(stack);
  write("\n");
}

}  // namespace nearfield::board
