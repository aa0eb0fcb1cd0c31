/// Products put together from halves, as cores without long products compute them.

#include <nearfield/number/integer.hpp>

#include <gtest/gtest.h>

#include <vector>

#include "reference/random.hpp"

namespace nearfield {
namespace {

// Every number whose halves are at an end of their range or next to one, and powers of two with their neighbours.
std::vector<uint32_t> awkward_numbers() {
  std::vector<uint32_t> halves;
  for (const uint32_t half : {0u, 1u, 2u, 0x7ffeu, 0x7fffu, 0x8000u, 0x8001u, 0xfffeu, 0xffffu}) halves.push_back(half);
  std::vector<uint32_t> numbers;
  for (const uint32_t high : halves) {
    for (const uint32_t low : halves) numbers.push_back(high << 16 | low);
  }
  for (int bit = 0; bit < 32; ++bit) {
    for (const uint32_t offset : {0u, 1u, ~0u}) numbers.push_back((1u << bit) + offset);
  }
  return numbers;
}

void expect_exact(uint32_t a, uint32_t b) {
  const auto expected = static_cast<uint32_t>(static_cast<uint64_t>(a) * b >> 32);
  ASSERT_EQ(detail::high_word_from_halves(a, b), expected) << a << " * " << b;
  const auto signed_a = static_cast<int32_t>(a), signed_b = static_cast<int32_t>(b);
  const auto signed_expected = static_cast<int32_t>((static_cast<int64_t>(signed_a) * signed_b) >> 32);
  ASSERT_EQ(detail::high_word_from_halves(signed_a, signed_b), signed_expected) << signed_a << " * " << signed_b;
}

TEST(HighWordFromHalves, IsExactForAwkwardNumbers) {
  const std::vector<uint32_t> numbers = awkward_numbers();
  for (const uint32_t a : numbers) {
    for (const uint32_t b : numbers) expect_exact(a, b);
  }
}

TEST(HighWordFromHalves, IsExactForRandomNumbers) {
  reference::Random random(reference::announced_seed("HighWordFromHalves", 421));
  for (int i = 0; i < 1000000; ++i) {
    const auto a = static_cast<uint32_t>(random.integer(0, 0xffffffffLL)), b = static_cast<uint32_t>(random.integer(0, 0xffffffffLL));
    expect_exact(a, b);
  }
}

}  // namespace
}  // namespace nearfield
