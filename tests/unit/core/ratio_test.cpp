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
