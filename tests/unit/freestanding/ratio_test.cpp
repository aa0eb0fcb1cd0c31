// Quotients without a division against exact integer ones.
#include <golden/stream.hpp>
#include <nearfield/number/ratio.hpp>

#include <gtest/gtest.h>

namespace {

using namespace nearfield;

// How far below the quotient rounded down; a failure is 99.
int64_t shortfall(uint32_t numerator, uint32_t denominator) {
  const uint64_t exact = (uint64_t{numerator} << 31) / denominator;
  const uint32_t found = ratio(numerator, denominator);
  return found >= 0x80000000u ? 99 : static_cast<int64_t>(exact) - static_cast<int64_t>(found);
}

class Shortfall {
 public:
  void include(uint32_t numerator, uint32_t denominator) {
    const int64_t here = shortfall(numerator, denominator);
    if (numerator == denominator) {
      EXPECT_LE(here, 3) << denominator;
      EXPECT_GE(here, 1) << denominator;  // 1 itself is no argument
    } else if (here < 0 || here > 2) {
      ADD_FAILURE() << numerator << " / " << denominator << " is off by " << here;
    }
    worst_ = here > worst_ ? here : worst_;
  }
  int64_t worst() const { return worst_; }

 private:
  int64_t worst_ = 0;
};

TEST(Ratio, OfSmallNumbersIsWithinTwoUnits) {
  Shortfall shortfall;
  for (uint32_t denominator = 1; denominator <= 700; ++denominator) {
    for (uint32_t numerator = 0; numerator <= denominator; ++numerator)
      shortfall.include(numerator, denominator);
  }
}

// Denominators next to the ends and middles of the seeds' intervals, numerators of all sizes.
TEST(Ratio, NextToTheSeedsEndsIsWithinTwoUnits) {
  Shortfall shortfall;
  for (uint32_t half = 64; half < 128; ++half) {
    for (uint32_t beside = 0; beside < 17; ++beside) {
      const uint32_t normalised = (half << 25) + beside - 8u;
      for (int shift = 0; shift < 31; shift += 5) {
        const uint32_t denominator = normalised >> shift;
        for (const uint32_t numerator :
             {denominator, denominator - 1, denominator / 2, denominator / 3, uint32_t{1}, uint32_t{0}}) {
          if (numerator <= denominator) shortfall.include(numerator, denominator);
        }
      }
    }
  }
}

TEST(Ratio, OfRandomNumbersIsWithinTwoUnits) {
  golden::Stream stream(301);
  Shortfall shortfall;
  for (int i = 0; i < 100000; ++i) {
    const uint32_t denominator = stream.next() >> stream.below(32);
    if (denominator == 0) continue;
    const auto numerator = static_cast<uint32_t>(stream.next() % (uint64_t{denominator} + 1));
    shortfall.include(numerator, denominator);
  }
  EXPECT_GE(shortfall.worst(), 1);
}

TEST(Ratio, OfNothingIsNothing) {
  EXPECT_EQ(ratio(uint32_t{0}, uint32_t{0}), 0u);
  EXPECT_EQ(ratio(uint32_t{5}, uint32_t{0}), 0u);
  EXPECT_EQ(ratio(0.0f, 0.0f), 0.0f);
  EXPECT_EQ(ratio(1.0f, -1.0f), 0.0f);
}

TEST(Ratio, OfFloatsIsBelowOneWhateverTheyAre) {
  const float infinity = __builtin_inff(),
              none = __builtin_nanf("");
  const float numbers[] = {0.0f, -1.0f, 1.0f, 3.0f, 1e-38f, 3e38f, infinity, -infinity, none};
  for (const float numerator : numbers) {
    for (const float denominator : numbers) {
      const float found = ratio(numerator, denominator);
      EXPECT_TRUE(found >= 0.0f && found < 1.0f) << numerator << " / " << denominator << ": " << found;
    }
  }
  EXPECT_EQ(ratio(1.0f, 3.0f), 1.0f / 3.0f);
  EXPECT_EQ(ratio(2.0f, 2.0f), 1.0f - 1.0f / 16777216.0f);
}

}  // namespace
