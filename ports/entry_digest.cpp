// The digest of every entry's results on the board: it must be that of the host.
#include <board/digests.hpp>
#include <golden/digests.hpp>
#include <golden/entry_stream.hpp>

int main() {
  using namespace nearfield;
  int invalid = 0;
  const uint64_t digest = golden::entry_digest<Fixed<27>>(invalid);
  return board::print_digest("fixed27", digest, golden::kFixed27EntryDigest) && invalid == 0 ? 0 : 1;
}
