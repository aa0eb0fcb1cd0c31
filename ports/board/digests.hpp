// Digests as a board prints and compares them.
#pragma once

#include <board/console.hpp>

namespace nearfield::board {

// Prints `name digest`; whether it is the recorded one.
inline bool print_digest(const char* name, uint64_t digest, uint64_t recorded) {
  write(name);
  write(" ");
  write_hexadecimal(digest, 16);
  write(digest == recorded ? "\n" : " differs from the recorded digest\n");
  return digest == recorded;
}

}  // namespace nearfield::board
