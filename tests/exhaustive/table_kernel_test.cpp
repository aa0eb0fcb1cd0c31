// The kernel on every kind of coefficients that a loader accepts, up to the ends of the number range: never
// an overflow, and the stated roundings.
#include <nearfield/field/image.hpp>
#include <reference/random.hpp>

#include <gtest/gtest.h>

#include <cmath>
#include <cstdint>
#include <vector>

namespace {

using namespace nearfield;
using Real = long double;
using reference::Random;

// One table with 2^index_bits times the same segment; loadable or not.
struct UniformTable {
  std::vector<uint32_t> words;

  UniformTable(int index_bits, int headroom, const int32_t (&c)[4]) {
    words = {static_cast<uint32_t>(index_bits), static_cast<uint32_t>(headroom), 0, 0, 0, 0, 0, 0};
    for (int i = 0; i < 1 << index_bits; ++i) {
      for (const int32_t coefficient : c) words.push_back(static_cast<uint32_t>(coefficient));
    }
  }
  template <class S>
  bool loadable() const {
    return coefficients_in_range(view<S>(), 1 << words[0]);
  }
  template <class S>
  TableView<S> view() const {
    return {words.data() + image_format::table_header_words, static_cast<int>(words[0]),
            static_cast<int>(words[1])};
  }
};

// Both results against the stored cubic; false when one is farther off than stated.
template <class S>
bool within_stated_rounding(const UniformTable& table, const int32_t (&c)[4], uint32_t argument) {
  const TableView<S> view = table.view<S>();
  const TableSample<S> found = sample_table<true>(view, argument);
  if (sample_table<false>(view, argument).value != found.value) return false;
  const Real segments = static_cast<Real>(1 << view.index_bits);
  const Real place = static_cast<Real>(argument) / 2147483648.0L * segments;
  const Real s = place - std::floor(place) - 0.5L;
  const Real scale = std::ldexp(1.0L, -(30 - view.slope_headroom));
  const Real c1 = c[1] * scale, c2 = c[2] * scale, c3 = c[3] * scale;
  const Real value = std::ldexp(static_cast<Real>(c[0]), -30) + s * (c1 + s * (c2 + s * c3)) / segments;
  const Real slope = c1 + s * (2 * c2 + s * 3 * c3);
  const Real value_off = std::fabs(std::ldexp(static_cast<Real>(found.value.raw()), -30) - value);
  const Real slope_off =
      std::fabs(std::ldexp(static_cast<Real>(found.slope.raw()), -S::fraction_bits) - slope);
  return value_off <= std::ldexp(2.0L, -30) && slope_off <= 3 * scale + std::ldexp(0.5L, -S::fraction_bits);
}

template <class S>
void expect_stated_rounding(uint64_t seed) {
  Random random(seed);
  int tables = 0, wrong = 0;
  for (int i = 0; i < 60000; ++i) {
    const int index_bits = static_cast<int>(random.integer(3, 6));
    const int headroom = static_cast<int>(random.integer(0, 3));
    // c1 ... c3 share the whole range, or a random part of it; often one of them has it all.
    int64_t rest = random.chance(0.5L) ? greatest_of<int32_t> : random.integer(0, greatest_of<int32_t>);
    int32_t c[4] = {};
    const int first = static_cast<int>(random.integer(0, 2));
    for (int j = 0; j < 3; ++j) {
      const int64_t share = random.chance(0.4L) ? rest : random.integer(0, rest);
      c[1 + (first + j) % 3] = static_cast<int32_t>(random.chance(0.5L) ? share : -share);
      rest -= share;
    }
    const int64_t swing = (int64_t{1} << (31 - index_bits + headroom)) + 2;
    const int64_t end = greatest_of<int32_t> - swing;
    if (end > 0) c[0] = static_cast<int32_t>(random.chance(0.3L) ? end : random.integer(-end, end));
    const UniformTable table(index_bits, headroom, c);
    if (!table.loadable<S>()) continue;
    ++tables;
    const uint32_t arguments[] = {0, 0x7fffffffu, 0x40000000u, 0x3fffffffu, 1};
    for (const uint32_t argument : arguments) wrong += !within_stated_rounding<S>(table, c, argument);
    for (int j = 0; j < 40; ++j) {
      wrong += !within_stated_rounding<S>(table, c, static_cast<uint32_t>(random.next() >> 33));
    }
    if (wrong != 0) {
      FAIL() << "2^" << index_bits << " segments, headroom " << headroom << ": " << c[0] << ", " << c[1]
             << ", " << c[2] << ", " << c[3];
    }
  }
  EXPECT_GT(tables, 20000);
}

TEST(TableKernel, StatedRoundingOfFixed27) {
  expect_stated_rounding<Fixed<27>>(reference::announced_seed("TableKernel.StatedRoundingOfFixed27", 91));
}
TEST(TableKernel, StatedRoundingOfFixed16) {
  expect_stated_rounding<Fixed<16>>(reference::announced_seed("TableKernel.StatedRoundingOfFixed16", 92));
}

// The steepest straight line that a table can hold.
TEST(TableKernel, GreatestSlope) {
  // The steepest that loads; one more leaves no room for rounding the slope to a coarse scalar.
  constexpr int32_t steepest = greatest_of<int32_t> - (1 << 23);
  const int32_t rising[4] = {0, steepest, 0, 0}, falling[4] = {0, -steepest, 0, 0};
  const int32_t too_steep[4] = {0, steepest + 1, 0, 0};
  const UniformTable up(3, 0, rising), down(3, 0, falling);
  EXPECT_FALSE(UniformTable(3, 0, too_steep).loadable<Fixed<27>>());
  ASSERT_TRUE(up.loadable<Fixed<27>>() && down.loadable<Fixed<27>>());
  EXPECT_TRUE(within_stated_rounding<Fixed<27>>(up, rising, 0x12345678u));
  EXPECT_TRUE(within_stated_rounding<Fixed<27>>(down, falling, 0x12345678u));
  EXPECT_TRUE(within_stated_rounding<Fixed<16>>(up, rising, 0x12345678u));
  EXPECT_TRUE(within_stated_rounding<Fixed<16>>(down, falling, 0x12345678u));
}

}  // namespace
