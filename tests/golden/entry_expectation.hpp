// The results of every entry in a fixed stream of points, bit for bit, against digests recorded once.
// A change of these digests is a change of what Nearfield answers. A file for each scalar: they take long to compile.
#pragma once

#include <golden/digests.hpp>
#include <golden/entry_stream.hpp>

#include <gtest/gtest.h>

#include <cstdint>

namespace nearfield::golden {

template <class S>
void expect_entry_digest(std::uint64_t recorded) {
  int invalid = 0;
  EXPECT_EQ(entry_digest<S>(invalid), recorded);
  EXPECT_EQ(invalid, 0);
}

}  // namespace nearfield::golden
