// Quotients without a division against exact ones.
#include <nearfield/number/ratio.hpp>
#include <reference/random.hpp>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>

namespace {

using namespace nearfield;
using reference::announced_seed;
using reference::Random;
using reference::Real;

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
    worst_ = std::max(worst_, here);
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
  Random random(announced_seed("Ratio.OfRandomNumbersIsWithinTwoUnits", 301));
  Shortfall shortfall;
  for (int i = 0; i < 1000000; ++i) {
    const uint64_t bits = random.next();
    const uint32_t denominator = static_cast<uint32_t>(bits >> 32) >> (bits & 31u);
    if (denominator == 0) continue;
    shortfall.include(static_cast<uint32_t>(random.next() % (uint64_t{denominator} + 1)), denominator);
  }
  std::printf("greatest shortfall %lld units of 2^-31\n", static_cast<long long>(shortfall.worst()));
  EXPECT_GE(shortfall.worst(), 1);
}

TEST(Ratio, OfNothingIsNothing) {
  EXPECT_EQ(ratio(uint32_t{0}, uint32_t{0}), 0u);
  EXPECT_EQ(ratio(uint32_t{5}, uint32_t{0}), 0u);
  EXPECT_EQ(ratio(0.0f, 0.0f), 0.0f);
  EXPECT_EQ(ratio(1.0f, -1.0f), 0.0f);
}

TEST(Ratio, OfFloatsIsBelowOneWhateverTheyAre) {
  const float infinity = std::numeric_limits<float>::infinity(),
              none = std::numeric_limits<float>::quiet_NaN();
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

// Every 2511th normalised number.
TEST(Ratio, ReciprocalIsBelowByLessThanStated) {
  Real most = 0;
  for (uint64_t d = 0x80000000u; d <= 0xffffffffu; d += 2511) {
    const Real short_by = 9223372036854775808.0L / static_cast<Real>(d) -
                          static_cast<Real>(detail::normalised_reciprocal(static_cast<uint32_t>(d)));
    EXPECT_GT(short_by, 0) << d;
    most = std::max(most, short_by);
  }
  EXPECT_LT(most, 1.2L);
  EXPECT_EQ(detail::normalised_reciprocal(0x80000000u), 0xffffffffu);
}

template <class S>
void expect_quotients(uint64_t seed) {
  Random random(announced_seed("Ratio.QuotientIsWithinTheStatedError", seed));
  const Real unit = std::ldexp(1.0L, -S::fraction_bits),
             greatest = static_cast<Real>(S::greatest().to_double());
  for (int i = 0; i < 20000; ++i) {
    const S a = S::from_raw(static_cast<int32_t>(random.next() >> 33) >> random.integer(0, 30));
    const S b = S::from_raw((static_cast<int32_t>(random.next() >> 33) >> random.integer(0, 30)) | 1);
    const Real exact = static_cast<Real>(a.raw()) / static_cast<Real>(b.raw());
    const Real found = static_cast<Real>(quotient<S>(a, reciprocal_of(b)).to_double());
    if (exact >= greatest) {
      EXPECT_GE(found, greatest * (1 - std::ldexp(1.0L, -30)));
    } else {
      EXPECT_LE(std::fabs(found - exact), unit / 2 + exact * std::ldexp(1.0L, -30))
          << a.raw() << " / " << b.raw();
    }
  }
  EXPECT_EQ(quotient<S>(S(1.0), reciprocal_of(S{})).raw(), 0);
}

TEST(Ratio, QuotientIsWithinTheStatedError) {
  expect_quotients<Fixed<27>>(302);
  expect_quotients<Fixed<24>>(303);
  expect_quotients<Fixed<16>>(304);
  EXPECT_EQ(quotient<Rate>(Fixed<16>(3.0), reciprocal_of(Fixed<16>(4.0))), Rate(0.75));
  EXPECT_EQ(quotient<float>(3.0f, reciprocal_of(4.0f)), 0.75f);
  EXPECT_EQ(reciprocal_of(0.0f).inverse, 0.0f);
}

}  // namespace
