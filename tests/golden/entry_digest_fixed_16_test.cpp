#include <golden/entry_expectation.hpp>

namespace nearfield::golden {

TEST(EntryDigest, Fixed16) { expect_entry_digest<Fixed<16>>(kFixed16EntryDigest); }

}  // namespace nearfield::golden
