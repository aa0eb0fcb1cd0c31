#include <golden/entry_expectation.hpp>

namespace nearfield::golden {

TEST(EntryDigest, Fixed27) { expect_entry_digest<Fixed<27>>(kFixed27EntryDigest); }

}  // namespace nearfield::golden
