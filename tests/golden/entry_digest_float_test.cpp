#include <golden/entry_expectation.hpp>

namespace nearfield::golden {

TEST(EntryDigest, Float) { expect_entry_digest<float>(kFloatEntryDigest); }

}  // namespace nearfield::golden
