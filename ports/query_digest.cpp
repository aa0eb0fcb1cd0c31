// Digests of the golden query stream on the board: they must be those of the host.
#include <board/digests.hpp>
#include <golden/digests.hpp>
#include <golden/query_stream.hpp>

int main() {
  using namespace nearfield::golden;
  using nearfield::Fixed;
  using nearfield::board::print_digest;
  bool same = print_digest("fixed27", query_digest<Fixed<27>>(kTargetDigestQueries), kFixed27TargetDigest);
  same = print_digest("fixed16", query_digest<Fixed<16>>(kTargetDigestQueries), kFixed16TargetDigest) && same;
  same = print_digest("float", query_digest<float>(kTargetDigestQueries), kFloatTargetDigest) && same;
  return same ? 0 : 1;
}
