// Square roots: all small arguments, dense samples of large ones, and the bounds that number/sqrt.hpp states.
#include <nearfield/number/vector.hpp>
#include <reference/random.hpp>

#include <gtest/gtest.h>

#include <cmath>
#include <cstdint>
#include <limits>

namespace {

using namespace nearfield;
using reference::Random;

bool is_floor_of_root(uint64_t x, uint64_t root) {
  return root <= 0xffffffffu && root * root <= x && x - root * root <= 2 * root;
}

// Counts violations of what root_parts() and integer_sqrt() promise, and keeps an example of each kind.
class PartsCheck {
 public:
  void add(uint64_t x) {
    const RootParts parts = root_parts(x);
    ++count_;
    if (!is_floor_of_root(x, parts.root) || integer_sqrt(x) != parts.root) note(wrong_root_, x);
    if (x == 0) {
      if (parts.root != 0 || parts.reciprocal != 0 || parts.shift != 0) note(wrong_root_, x);
      return;
    }
    // 2^(62 - 2 shift) <= x < 2^(64 - 2 shift)
    if (parts.shift < 0 || parts.shift > 31 || (x << (2 * parts.shift)) >> 62 == 0 ||
        (x << (2 * parts.shift)) >> (2 * parts.shift) != x) {
      note(wrong_shift_, x);
      return;
    }
    const long double exact = std::ldexp(1.0L, 62 - parts.shift) / std::sqrt(static_cast<long double>(x));
    const long double below = 1.0L - static_cast<long double>(parts.reciprocal) / exact;
    if (parts.reciprocal <= 0 || below < 0.0L || below > std::ldexp(1.0L, -27)) note(wrong_reciprocal_, x);
    if (below < least_below_) least_below_ = below;
    if (below > greatest_below_) greatest_below_ = below;
  }
  void add_neighbours(uint64_t x) {
    for (uint64_t d = 0; d <= 3; ++d) {
      add(x + d);
      add(x - d);
    }
  }
  void expect_none(const char* what) const {
    std::printf("%s: %llu arguments, reciprocal below by %.3Lf to %.3Lf units of 2^-27\n", what,
                static_cast<unsigned long long>(count_), std::ldexp(least_below_, 27),
                std::ldexp(greatest_below_, 27));
    EXPECT_EQ(wrong_root_.count, 0u) << "wrong root of " << wrong_root_.example;
    EXPECT_EQ(wrong_shift_.count, 0u) << "wrong shift for " << wrong_shift_.example;
    EXPECT_EQ(wrong_reciprocal_.count, 0u) << "reciprocal out of bounds for " << wrong_reciprocal_.example;
  }

 private:
  struct Violations {
    uint64_t count = 0, example = 0;
  };
  static void note(Violations& violations, uint64_t x) {
    if (violations.count++ == 0) violations.example = x;
  }
  uint64_t count_ = 0;
  Violations wrong_root_, wrong_shift_, wrong_reciprocal_;
  long double least_below_ = 1.0L, greatest_below_ = -1.0L;
};

TEST(IntegerSqrt, EverySixteenBitArgument) {
  uint32_t root = 0;
  for (uint32_t x = 0; x <= 0xffffu; ++x) {
    if ((root + 1) * (root + 1) <= x) ++root;
    ASSERT_EQ(integer_sqrt(x), root) << x;
  }
}

TEST(IntegerSqrt, EveryArgumentOf22Bits) {
  PartsCheck check;
  for (uint64_t x = 0; x < (uint64_t{1} << 22); ++x) check.add(x);
  check.expect_none("below 2^22");
}

TEST(IntegerSqrt, DenseAt32And64Bits) {
  Random random(reference::announced_seed("IntegerSqrt.DenseAt32And64Bits", 20260));
  PartsCheck check;
  for (uint64_t x = 0; x <= 0xffffffffu; x += 2039) check.add(x);
  for (int i = 0; i < 3000000; ++i) check.add(random.next());
  for (int i = 0; i < 2000000; ++i) check.add(random.next() >> (random.next() & 63u));
  check.expect_none("dense");
}

// Just below, at and above a square; the greatest argument with the same root.
TEST(IntegerSqrt, AroundSquares) {
  Random random(reference::announced_seed("IntegerSqrt.AroundSquares", 20261));
  PartsCheck check;
  const auto around = [&check](uint64_t r) {
    check.add(r * r - 1);
    check.add(r * r);
    check.add(r * r + 2 * r);
    check.add(r * r + r);
  };
  for (uint64_t r = 1; r < 200000; ++r) around(r);
  for (uint64_t r = 0xffffffffu - 200000; r <= 0xffffffffu; ++r) around(r);
  for (int i = 0; i < 800000; ++i) around((random.next() >> 32) >> (random.next() & 15u) | 1u);
  for (int shift = 1; shift < 32; ++shift) {
    for (uint64_t d = 0; d < 500; ++d) {
      around((uint64_t{1} << shift) + d);
      if ((uint64_t{1} << shift) > d) around((uint64_t{1} << shift) - d);
    }
  }
  check.expect_none("around squares");
}

// The seeds change at multiples of 1/64 of the normalised argument.
TEST(IntegerSqrt, PowersOfTwoAndSeedBorders) {
  PartsCheck check;
  for (int bit = 0; bit < 64; ++bit) check.add_neighbours(uint64_t{1} << bit);
  for (uint64_t border = 16; border <= 64; ++border) {
    for (int down = 0; down < 40; ++down) check.add_neighbours(((border << 57) << 1) >> down);
  }
  for (uint64_t d = 0; d < 100000; ++d) check.add(~uint64_t{0} - d);
  check.expect_none("borders");
  EXPECT_EQ(integer_sqrt(~uint64_t{0}), 0xffffffffu);
  EXPECT_EQ(integer_sqrt(0xfffffffe00000001u), 0xffffffffu);
  EXPECT_EQ(integer_sqrt(0xfffffffe00000000u), 0xfffffffeu);
}

static_assert(integer_sqrt(99) == 9 && integer_sqrt(100) == 10, "usable in constant expressions");

class FloatCheck {
 public:
  void add(uint32_t bits) {
    const float x = bits_as<float>(bits);
    ++count_;
    const uint32_t right = bits_as<uint32_t>(std::sqrt(x));
    const bool by_instruction = bits_as<uint32_t>(square_root(x)) == right;
    const bool by_integers = bits_as<uint32_t>(detail::square_root_of_integers(x)) == right;
    if (!(by_instruction && by_integers) && wrong_++ == 0) example_ = bits;
  }
  void expect_none(const char* what) const {
    std::printf("%s: %llu patterns\n", what, static_cast<unsigned long long>(count_));
    EXPECT_EQ(wrong_, 0u) << "first wrong root: of the bits " << example_;
  }

 private:
  uint64_t count_ = 0, wrong_ = 0;
  uint32_t example_ = 0;
};

TEST(FloatSquareRoot, AcrossAllExponents) {
  FloatCheck check;
  for (uint32_t bits = 0; bits <= 0x7f800000u; bits += 61) check.add(bits);
  for (uint32_t exponent = 0; exponent < 255; ++exponent) {
    for (uint32_t mantissa = 0; mantissa < 2000; ++mantissa) {
      check.add(exponent << 23 | mantissa);
      check.add(exponent << 23 | (0x007fffffu - mantissa));
      check.add(exponent << 23 | (0x00400000u + mantissa));
    }
  }
  check.expect_none("all exponents");
}

TEST(FloatSquareRoot, EveryMantissaOfAnEvenAndAnOddExponent) {
  FloatCheck check;
  for (uint32_t mantissa = 0; mantissa < 1u << 23; ++mantissa) {
    check.add(127u << 23 | mantissa);
    check.add(128u << 23 | mantissa);
  }
  check.expect_none("every mantissa");
}

TEST(FloatSquareRoot, EverySubnormal) {
  FloatCheck check;
  for (uint32_t bits = 0; bits < 1u << 23; ++bits) check.add(bits);
  check.expect_none("subnormals");
}

TEST(FloatSquareRoot, WhatHasNoRoot) {
  const float infinity = std::numeric_limits<float>::infinity();
  const float nan = std::numeric_limits<float>::quiet_NaN();
  EXPECT_EQ(square_root(infinity), infinity);
  EXPECT_TRUE(std::isnan(square_root(nan)));
  EXPECT_TRUE(std::isnan(square_root(-nan)));
  EXPECT_EQ(bits_as<uint32_t>(square_root(-1.0f)), 0u);
  EXPECT_EQ(bits_as<uint32_t>(square_root(-0.0f)), 0u);
  EXPECT_EQ(bits_as<uint32_t>(square_root(-infinity)), 0u);
}

// What polar() states: every component of a direction within 6 units of 2^-30 and half a unit in the last place of To.
template <class To>
long double direction_units() {
  return 0.5L + std::ldexp(6.0L, To::fraction_bits - 30);
}

// The direction within that, and the length rounded down.
template <class S, class To>
void expect_directions(uint64_t seed, int count) {
  Random random(seed);
  long double greatest = 0;
  int violations = 0;
  for (int i = 0; i < count; ++i) {
    int32_t raw[3];
    for (int32_t& component : raw) {
      component = static_cast<int32_t>(random.next() >> 32) >> (random.next() % 31);
      if (i % 7 == 0 && random.next() % 3 == 0) component = random.next() % 2 == 0 ? least_of<int32_t> : 0;
      if (i % 11 == 0 && random.next() % 3 == 0)
        component = random.next() % 2 == 0 ? 1 : greatest_of<int32_t>;
    }
    const Polar<S, To> found =
        polar<To>(Vector3<S>{S::from_raw(raw[0]), S::from_raw(raw[1]), S::from_raw(raw[2])});
    const long double x = raw[0], y = raw[1], z = raw[2];
    const long double length = std::sqrt(x * x + y * y + z * z);
    if (length == 0) {
      ASSERT_TRUE(is_zero(found.direction));
      continue;
    }
    ASSERT_EQ(found.length.raw(), static_cast<int64_t>(std::fmin(std::floor(length), 2147483647.0L)));
    const To components[3] = {found.direction.x, found.direction.y, found.direction.z};
    for (int j = 0; j < 3; ++j) {
      const long double exact = static_cast<long double>(raw[j]) / length;
      const long double off =
          std::fabs(static_cast<long double>(components[j].raw()) - std::ldexp(exact, To::fraction_bits));
      if (off > greatest) greatest = off;
      if (off > direction_units<To>() && violations++ == 0) {
        ADD_FAILURE() << "off by " << off << " units: " << raw[0] << " " << raw[1] << " " << raw[2];
      }
    }
  }
  std::printf("direction with %d fraction bits: off by at most %.3Lf units\n", To::fraction_bits, greatest);
  EXPECT_EQ(violations, 0);
}

TEST(Polar, DirectionErrorOfFixed) {
  const uint64_t seed = reference::announced_seed("Polar.DirectionErrorOfFixed", 20262);
  expect_directions<Fixed<27>, Fixed<27>>(seed, 700000);
  expect_directions<Fixed<27>, Fixed<30>>(seed + 1, 700000);
  expect_directions<Fixed<16>, Fixed<16>>(seed + 2, 700000);
  expect_directions<Fixed<16>, Fixed<30>>(seed + 3, 700000);
  expect_directions<Fixed<24>, Fixed<24>>(seed + 4, 300000);
}

// Three roundings of squares and sums, a root, a quotient: 2 units of 2^-23 a component.
TEST(Polar, DirectionErrorOfFloat) {
  Random random(reference::announced_seed("Polar.DirectionErrorOfFloat", 20263));
  for (int i = 0; i < 700000; ++i) {
    const auto coordinate = [&random] {
      return std::ldexp(static_cast<float>(static_cast<int32_t>(random.next() >> 40) - (1 << 23)),
                        -23 - static_cast<int>(random.next() % 12));
    };
    const Vector3<float> v = {coordinate(), coordinate(), coordinate()};
    const Polar<float, float> found = polar<float>(v);
    const long double x = static_cast<long double>(v.x), y = static_cast<long double>(v.y),
                      z = static_cast<long double>(v.z);
    const long double length = std::sqrt(x * x + y * y + z * z);
    if (length == 0) continue;
    ASSERT_LE(std::fabs(static_cast<long double>(found.length) - length), std::ldexp(length, -22));
    ASSERT_LE(std::fabs(static_cast<long double>(found.direction.x) - x / length), std::ldexp(2.0L, -23));
    ASSERT_LE(std::fabs(static_cast<long double>(found.direction.y) - y / length), std::ldexp(2.0L, -23));
    ASSERT_LE(std::fabs(static_cast<long double>(found.direction.z) - z / length), std::ldexp(2.0L, -23));
  }
  EXPECT_TRUE(is_zero(polar<float>(Vector3<float>{}).direction));
}

}  // namespace
