// FNV-1a, 64 bits, over 32-bit words: one number that stands for all results of a run.
#pragma once

#include <stdint.h>

namespace nearfield::work_cell {

class Digest {
 public:
  constexpr void add(uint32_t word) {
    for (int shift = 0; shift < 32; shift += 8) {
      state_ ^= (word >> shift) & 0xffu;
      state_ *= 1099511628211u;
    }
  }
  constexpr uint64_t value() const { return state_; }

 private:
  uint64_t state_ = 14695981039346656037u;
};

}  // namespace nearfield::work_cell
