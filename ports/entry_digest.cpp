// The digest of every entry's results on the target: it must be that of the host.
#include <board/digests.hpp>
#include <golden/digests.hpp>
#include <golden/entry_stream.hpp>

namespace {

template <class S>
bool print_entry_digest(const char* name, uint64_t recorded) {
  int invalid = 0;
  const uint64_t digest = nearfield::golden::entry_digest<S>(invalid);
  return nearfield::board::print_digest(name, digest, recorded) && invalid == 0;
}

}  // namespace

int main() {
  using namespace nearfield;
  bool same = print_entry_digest<Fixed<27>>("fixed27", golden::kFixed27EntryDigest);
  same = print_entry_digest<Fixed<16>>("fixed16", golden::kFixed16EntryDigest) && same;
  same = print_entry_digest<float>("float", golden::kFloatEntryDigest) && same;
  return same ? 0 : 1;
}
