// Digests of the golden query stream on the board: they must be those of the host.
#include <board/semihosting.hpp>
#include <golden/digests.hpp>
#include <golden/query_stream.hpp>

namespace {

// Prints `name digest`; whether it is the recorded one.
bool print_digest(const char* name, uint64_t digest, uint64_t recorded) {
  using namespace nearfield::board;
  write(name);
  write(" ");
  write_hexadecimal(digest, 16);
  write(digest == recorded ? "\n" : " differs from the recorded digest\n");
  return digest == recorded;
}

}  // namespace

int main() {
  using namespace nearfield::golden;
  using nearfield::Fixed;
  bool same = print_digest("fixed27", query_digest<Fixed<27>>(kDigestQueries), kFixed27Digest);
  same = print_digest("fixed16", query_digest<Fixed<16>>(kDigestQueries), kFixed16Digest) && same;
  same = print_digest("float", query_digest<float>(kDigestQueries), kFloatDigest) && same;
  return same ? 0 : 1;
}
