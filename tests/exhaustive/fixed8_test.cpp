// Every operand pair of every arithmetic operation at 8 bits, against exact rational arithmetic.
#include <nearfield/number/vector.hpp>

#include <gtest/gtest.h>

#include <cmath>
#include <cstdint>
#include <limits>
#include <vector>

namespace {

using namespace nearfield;

constexpr int64_t kLeast = -128, kGreatest = 127;

int64_t floor_divide(int64_t numerator, int64_t positive_divisor) {
  const int64_t quotient = numerator / positive_divisor;
  return numerator % positive_divisor < 0 ? quotient - 1 : quotient;
}
// floor(x + 1/2) of the rational x = numerator / divisor.
int64_t round_half_up(int64_t numerator, int64_t divisor) {
  if (divisor < 0) return round_half_up(-numerator, -divisor);
  return floor_divide(2 * numerator + divisor, 2 * divisor);
}
bool representable(int64_t raw) { return raw >= kLeast && raw <= kGreatest; }
int64_t clipped(int64_t raw) { return raw < kLeast ? kLeast : raw > kGreatest ? kGreatest : raw; }
// The representative of raw modulo 256 within the range.
int64_t wrapped(int64_t raw) { return raw - 256 * floor_divide(raw + 128, 256); }

template <class Number>
Number number(int64_t raw) {
  return Number::from_raw(static_cast<typename Number::Raw>(raw));
}

// What an operation with a status must do for the exact result `exact` (in units of the last place).
template <class Number, class Operation>
void expect_saturating(int64_t exact, const Operation& operation, int64_t a, int64_t b) {
  ArithmeticStatus fresh, sticky;
  sticky.saturated = true;
  EXPECT_EQ(operation(fresh).raw(), clipped(exact)) << a << ", " << b;
  EXPECT_EQ(fresh.saturated, !representable(exact)) << a << ", " << b;
  EXPECT_EQ(operation(sticky).raw(), clipped(exact)) << a << ", " << b;
  EXPECT_TRUE(sticky.saturated) << a << ", " << b;
}

template <class Number>
class Fixed8 : public testing::Test {};
using Formats = testing::Types<Fixed<0, int8_t>, Fixed<4, int8_t>, Fixed<6, int8_t>>;
TYPED_TEST_SUITE(Fixed8, Formats, );

template <class Visit>
void for_every_pair(const Visit& visit) {
  for (int64_t a = kLeast; a <= kGreatest; ++a) {
    for (int64_t b = kLeast; b <= kGreatest; ++b) visit(a, b);
  }
}

TYPED_TEST(Fixed8, SumAndDifference) {
  using N = TypeParam;
  for_every_pair([](int64_t a, int64_t b) {
    const N x = number<N>(a), y = number<N>(b);
    EXPECT_EQ((x + y).raw(), clipped(a + b));
    EXPECT_EQ((x - y).raw(), clipped(a - b));
    expect_saturating<N>(
        a + b, [&](ArithmeticStatus& status) { return add(x, y, status); }, a, b);
    expect_saturating<N>(
        a - b, [&](ArithmeticStatus& status) { return subtract(x, y, status); }, a, b);
    EXPECT_EQ(add_in_range(x, y).raw(), wrapped(a + b)) << a << " + " << b;
    EXPECT_EQ(subtract_in_range(x, y).raw(), wrapped(a - b)) << a << " - " << b;
  });
}

TYPED_TEST(Fixed8, Product) {
  using N = TypeParam;
  constexpr int64_t one = int64_t{1} << N::fraction_bits;
  for_every_pair([](int64_t a, int64_t b) {
    const N x = number<N>(a), y = number<N>(b);
    const int64_t exact = round_half_up(a * b, one);
    EXPECT_EQ((x * y).raw(), clipped(exact)) << a << " * " << b;
    expect_saturating<N>(
        exact, [&](ArithmeticStatus& status) { return multiply(x, y, status); }, a, b);
    EXPECT_EQ(product(x, y).raw, a * b);
  });
}

TYPED_TEST(Fixed8, Quotient) {
  using N = TypeParam;
  constexpr int64_t one = int64_t{1} << N::fraction_bits;
  for_every_pair([](int64_t a, int64_t b) {
    const N x = number<N>(a), y = number<N>(b);
    if (b != 0) {
      expect_saturating<N>(
          round_half_up(a * one, b), [&](ArithmeticStatus& status) { return divide(x, y, status); }, a, b);
      return;
    }
    ArithmeticStatus status;
    EXPECT_EQ(divide(x, y, status).raw(), a < 0 ? kLeast : a > 0 ? kGreatest : 0);
    EXPECT_TRUE(status.saturated);
  });
}

TYPED_TEST(Fixed8, NegationAndMagnitude) {
  using N = TypeParam;
  for (int64_t a = kLeast; a <= kGreatest; ++a) {
    EXPECT_EQ((-number<N>(a)).raw(), clipped(-a));
    EXPECT_EQ(absolute(number<N>(a)).raw(), clipped(a < 0 ? -a : a));
  }
}

TYPED_TEST(Fixed8, Order) {
  using N = TypeParam;
  for_every_pair([](int64_t a, int64_t b) {
    const N x = number<N>(a), y = number<N>(b);
    EXPECT_EQ(x == y, a == b);
    EXPECT_EQ(x != y, a != b);
    EXPECT_EQ(x < y, a < b);
    EXPECT_EQ(x > y, a > b);
    EXPECT_EQ(x <= y, a <= b);
    EXPECT_EQ(x >= y, a >= b);
    EXPECT_EQ(least_of_two(x, y).raw(), a < b ? a : b);
    EXPECT_EQ(greatest_of_two(x, y).raw(), a > b ? a : b);
  });
}

TYPED_TEST(Fixed8, ClampOfEveryTriple) {
  using N = TypeParam;
  int64_t wrong = 0;
  for_every_pair([&wrong](int64_t low, int64_t high) {
    if (low > high) return;
    for (int64_t a = kLeast; a <= kGreatest; ++a) {
      const int64_t expected = a < low ? low : a > high ? high : a;
      wrong += clamp(number<N>(a), number<N>(low), number<N>(high)).raw() != expected;
    }
  });
  EXPECT_EQ(wrong, 0);
}

TYPED_TEST(Fixed8, FromReal) {
  using N = TypeParam;
  const double one = std::ldexp(1.0, N::fraction_bits);
  for (int64_t eighths = -1200; eighths <= 1200; ++eighths) {
    EXPECT_EQ(N(static_cast<double>(eighths) / 8 / one).raw(), clipped(round_half_up(eighths, 8))) << eighths;
  }
  for (int64_t a = kLeast; a <= kGreatest; ++a) EXPECT_EQ(N(number<N>(a).to_double()).raw(), a);
  EXPECT_EQ(N(1e300).raw(), kGreatest);
  EXPECT_EQ(N(-1e300).raw(), kLeast);
  EXPECT_EQ(N(std::numeric_limits<double>::infinity()).raw(), kGreatest);
  EXPECT_EQ(N(-std::numeric_limits<double>::infinity()).raw(), kLeast);
  EXPECT_EQ(N(std::numeric_limits<double>::quiet_NaN()).raw(), kLeast);
}

// Narrowing from a product of WideFraction fraction bits, for every 16-bit value that the product type can
// hold.
template <int WideFraction, class To>
void expect_narrowing() {
  constexpr int shift = WideFraction - To::fraction_bits;
  constexpr int64_t divisor = int64_t{1} << shift;
  for (int64_t raw = -32768; raw <= 32767; ++raw) {
    const WideProduct<WideFraction, int8_t> wide = {static_cast<int16_t>(raw)};
    const int64_t exact = round_half_up(raw, divisor);
    EXPECT_EQ(narrow<To>(wide).raw(), clipped(exact)) << raw;
    expect_saturating<To>(
        exact, [&](ArithmeticStatus& status) { return narrow<To>(wide, status); }, raw, shift);
    // The rounding itself must stay within the product's 16 bits for the one-instruction form.
    if (raw + divisor / 2 > 32767) continue;
    EXPECT_EQ(narrow_in_range<To>(wide).raw(), wrapped(exact)) << raw << " to " << To::fraction_bits;
  }
}

TEST(Fixed8Narrowing, EveryWideValue) {
  expect_narrowing<8, Fixed<4, int8_t>>();
  expect_narrowing<8, Fixed<0, int8_t>>();
  expect_narrowing<8, Fixed<6, int8_t>>();
  expect_narrowing<12, Fixed<6, int8_t>>();
  expect_narrowing<12, Fixed<4, int8_t>>();
  expect_narrowing<12, Fixed<0, int8_t>>();
  expect_narrowing<6, Fixed<0, int8_t>>();
  expect_narrowing<4, Fixed<0, int8_t>>();
  expect_narrowing<10, Fixed<4, int8_t>>();
  expect_narrowing<1, Fixed<0, int8_t>>();
}

TEST(Fixed8Narrowing, EveryProductOfTwo) {
  for_every_pair([](int64_t a, int64_t b) {
    const auto exact = product(number<Fixed<4, int8_t>>(a), number<Fixed<6, int8_t>>(b));
    static_assert(decltype(exact.raw + 0){} == 0 && sizeof(exact.raw) == 2, "8-bit products have 16 bits");
    EXPECT_EQ(exact.raw, a * b);
    EXPECT_EQ((narrow<Fixed<4, int8_t>>(exact).raw()), clipped(round_half_up(a * b, 64)));
    EXPECT_EQ((narrow_in_range<Fixed<4, int8_t>>(exact).raw()), wrapped(round_half_up(a * b, 64)));
  });
}

TEST(Fixed8Narrowing, SumsOfProductsWrapAtSixteenBits) {
  for (int64_t a = -32768; a <= 32767; a += 7) {
    for (const int64_t b : {-32768, -32767, -16384, -128, -1, 0, 1, 127, 128, 16384, 32767}) {
      const WideProduct<8, int8_t> x = {static_cast<int16_t>(a)}, y = {static_cast<int16_t>(b)};
      EXPECT_EQ((x + y).raw, static_cast<int16_t>(static_cast<uint16_t>(a + b)));
      EXPECT_EQ((x - y).raw, static_cast<int16_t>(static_cast<uint16_t>(a - b)));
    }
  }
}

TYPED_TEST(Fixed8, HelpersOfGenericCode) {
  using N = TypeParam;
  using T = ScalarTraits<N>;
  const int64_t rates[] = {0,       1,       1 << 23,   (1 << 24) - 1, 1 << 24, (1 << 24) + 1,
                           3 << 23, 5 << 24, 0x7fffffff};
  for (int64_t a = kLeast; a <= kGreatest; ++a) {
    const N x = number<N>(a);
    EXPECT_EQ(T::half(x).raw(), floor_divide(a, 2));
    for (int count = -5; count <= 5; ++count) EXPECT_EQ(T::times(x, count).raw(), clipped(a * count));
    EXPECT_EQ(T::word(x), static_cast<uint32_t>(a));
    EXPECT_EQ(T::from_unit(number<typename T::Unit>(a)).raw(),
              N::fraction_bits == 6 ? a : round_half_up(a, int64_t{1} << (6 - N::fraction_bits)));
    if (a < 0) continue;
    for (const int64_t raw : rates) {
      const Rate rate = Rate::from_raw(static_cast<int32_t>(raw));
      EXPECT_EQ(T::multiply_up(x, rate).raw(), clipped(-floor_divide(-a * raw, 1 << 24)));
      if (raw < 1 << 24) continue;
      const int64_t quotient = T::divide_down(x, reciprocal_down(rate)).raw();
      EXPECT_LE(quotient * raw, a << 24);
      EXPECT_GT((quotient + 2) * raw, a << 24);
    }
  }
}

// floor(sqrt(n)) for n up to the greatest sum of three squares.
std::vector<int64_t> exact_roots() {
  std::vector<int64_t> roots(3 * 128 * 128 + 1);
  int64_t root = 0;
  for (size_t n = 0; n < roots.size(); ++n) {
    while ((root + 1) * (root + 1) <= static_cast<int64_t>(n)) ++root;
    roots[n] = root;
  }
  return roots;
}

TEST(Fixed8Vector, LengthAndDirectionOfEveryTriple) {
  using N = Fixed<4, int8_t>;
  using To = Fixed<6, int8_t>;
  const std::vector<int64_t> roots = exact_roots();
  int64_t wrong_lengths = 0, wrong_polar_lengths = 0, wrong_directions = 0;
  for (int64_t a = kLeast; a <= kGreatest; ++a) {
    for (int64_t b = kLeast; b <= kGreatest; ++b) {
      for (int64_t c = kLeast; c <= kGreatest; ++c) {
        const Vector3<N> v = {number<N>(a), number<N>(b), number<N>(c)};
        const int64_t squares = a * a + b * b + c * c;
        const int64_t expected = clipped(roots[static_cast<size_t>(squares)]);
        wrong_lengths += length_of<N>(sum_of_squares(v.x, v.y, v.z)).raw() != expected;
        const Polar<N, To> polar_form = polar<To>(v);
        wrong_polar_lengths += polar_form.length.raw() != expected;
        const double scale = squares == 0 ? 0.0 : 64.0 / std::sqrt(static_cast<double>(squares));
        const auto off = [scale](To component, int64_t coordinate) {
          return std::fabs(component.raw() - scale * static_cast<double>(coordinate)) > 2.0;
        };
        wrong_directions += off(polar_form.direction.x, a) || off(polar_form.direction.y, b) ||
                            off(polar_form.direction.z, c);
      }
    }
  }
  EXPECT_EQ(wrong_lengths, 0);
  EXPECT_EQ(wrong_polar_lengths, 0);
  EXPECT_EQ(wrong_directions, 0);
}

TEST(Fixed8Vector, PlaneLengthsAndLegs) {
  using N = Fixed<4, int8_t>;
  const std::vector<int64_t> roots = exact_roots();
  for_every_pair([&roots](int64_t a, int64_t b) {
    const N x = number<N>(a), y = number<N>(b);
    EXPECT_EQ(length_of<N>(sum_of_squares(x, y)).raw(), clipped(roots[static_cast<size_t>(a * a + b * b)]));
    if (a >= b && b >= 0) {
      EXPECT_EQ(other_leg(x, y).raw(), roots[static_cast<size_t>(a * a - b * b)]);
    }
  });
}

// Exact in range at 16 bits of product: every pair with a fixed third component.
TEST(Fixed8Vector, DotAndScaling) {
  using N = Fixed<4, int8_t>;
  for_every_pair([](int64_t a, int64_t b) {
    const Vector3<N> v = {number<N>(a), number<N>(b), number<N>(wrapped(a - b))};
    const N factor = number<N>(b);
    const auto squares = dot(v, Vector3<N>{number<N>(b), number<N>(-3), number<N>(5)});
    const int64_t exact = a * b - 3 * b + 5 * wrapped(a - b);
    EXPECT_EQ(squares.raw, static_cast<int16_t>(static_cast<uint16_t>(exact)));
    EXPECT_EQ(scaled(v, factor).x.raw(), clipped(round_half_up(a * b, 16)));
    EXPECT_EQ(scaled_in_range(v, factor).x.raw(), wrapped(round_half_up(a * b, 16)));
    EXPECT_EQ((v + v).y.raw(), clipped(2 * b));
    EXPECT_EQ((-v).y.raw(), clipped(-b));
    EXPECT_EQ(add_in_range(v, v).y.raw(), wrapped(2 * b));
    EXPECT_EQ(subtract_in_range(v, Vector3<N>{factor, factor, factor}).x.raw(), wrapped(a - b));
    EXPECT_EQ(is_zero(v), a == 0 && b == 0);
  });
}

}  // namespace
