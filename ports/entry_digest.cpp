// Digests of every entry's results on the board: they must be those of the host.
#include <board/digests.hpp>
#include <golden/digests.hpp>
#include <golden/entry_stream.hpp>

namespace {

template <class S>
bool print_entries(const char* name, uint64_t recorded) {
  int invalid = 0;
  const uint64_t digest = nearfield::golden::entry_digest<S>(invalid);
  return nearfield::board::print_digest(name, digest, recorded) && invalid == 0;
}

}  // namespace

int main() {
  using namespace nearfield::golden;
  using nearfield::Fixed;
  bool same = print_entries<Fixed<27>>("fixed27", kFixed27EntryDigest);
  same = print_entries<Fixed<16>>("fixed16", kFixed16EntryDigest) && same;
  same = print_entries<float>("float", kFloatEntryDigest) && same;
  return same ? 0 : 1;
}
