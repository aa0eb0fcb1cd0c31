// The results of every entry in a fixed stream of points, bit for bit, against digests recorded once.
// A change of these digests is a change of what Nearfield answers.
#include <golden/digests.hpp>
#include <golden/entry_stream.hpp>

#include <gtest/gtest.h>

#include <cstdint>

namespace {

using namespace nearfield;
using namespace nearfield::golden;

template <class S>
void expect_digest(uint64_t recorded) {
  int invalid = 0;
  EXPECT_EQ(entry_digest<S>(invalid), recorded);
  EXPECT_EQ(invalid, 0);
}

TEST(EntryDigest, Fixed27) { expect_digest<Fixed<27>>(kFixed27EntryDigest); }
TEST(EntryDigest, Fixed16) { expect_digest<Fixed<16>>(kFixed16EntryDigest); }
TEST(EntryDigest, Float) { expect_digest<float>(kFloatEntryDigest); }

}  // namespace
