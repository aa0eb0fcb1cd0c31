/// Products put together from halves, as cores without long products compute them.

#include <golden/stream.hpp>
#include <nearfield/number/integer.hpp>

#include <gtest/gtest.h>

namespace nearfield {
namespace {

// Every number whose halves are at an end of their range or next to one, and powers of two with their neighbours.
constexpr uint32_t kHalves[] = {0, 1, 2, 0x7ffe, 0x7fff, 0x8000, 0x8001, 0xfffe, 0xffff};
constexpr int kAwkwardNumbers = 9 * 9 + 3 * 32;

uint32_t awkward_number(int i) {
  if (i < 9 * 9) return kHalves[i / 9] << 16 | kHalves[i % 9];
  const int power = i - 9 * 9;
  return (1u << power / 3) + static_cast<uint32_t>(power % 3 - 1);
}

void expect_exact(uint32_t a, uint32_t b) {
  const auto expected = static_cast<uint32_t>(static_cast<uint64_t>(a) * b >> 32);
  ASSERT_EQ(detail::high_word_from_halves(a, b), expected) << a << " * " << b;
  const auto signed_a = static_cast<int32_t>(a), signed_b = static_cast<int32_t>(b);
  const auto signed_expected = static_cast<int32_t>((static_cast<int64_t>(signed_a) * signed_b) >> 32);
  ASSERT_EQ(detail::high_word_from_halves(signed_a, signed_b), signed_expected) << signed_a << " * " << signed_b;
}

TEST(HighWordFromHalves, IsExactForAwkwardNumbers) {
  for (int i = 0; i < kAwkwardNumbers; ++i) {
    for (int j = 0; j < kAwkwardNumbers; ++j) expect_exact(awkward_number(i), awkward_number(j));
  }
}

TEST(HighWordFromHalves, IsExactForRandomNumbers) {
  golden::Stream stream(421);
  for (int i = 0; i < 100000; ++i) {
    const uint32_t a = stream.next(), b = stream.next();
    expect_exact(a, b);
  }
}

}  // namespace
}  // namespace nearfield
