// Random numbers that are the same on the host and on a target. Freestanding.
#pragma once

#include <nearfield/number/integer.hpp>

namespace nearfield::golden {

// Pseudo-random 64-bit integers: a congruence modulo 2^64 whose state is mixed before it is used.
class Stream {
 public:
  constexpr explicit Stream(uint64_t seed) : state_(seed) {}
  constexpr uint32_t next() {
    state_ = state_ * 0xd1342543de82ef95u + 0x2545f4914f6cdd1du;
    const uint64_t folded = (state_ ^ (state_ >> 29)) * 0xbf0a8b1457695355u;
    return static_cast<uint32_t>(folded >> 32);
  }
  constexpr uint32_t below(uint32_t count) { return multiply_high(next(), count); }
  // In -2^(bits - 1) ... 2^(bits - 1) - 1.
  constexpr int32_t integer_of_bits(int bits) { return static_cast<int32_t>(next()) >> (32 - bits); }

 private:
  uint64_t state_;
};

}  // namespace nearfield::golden
