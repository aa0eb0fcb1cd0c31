// The answers to a fixed stream of queries, bit for bit, against digests recorded once.
// A change of these digests is a change of what Nearfield answers.
#include <golden/digests.hpp>
#include <golden/query_stream.hpp>

#include <gtest/gtest.h>

#include <cstdint>
#include <cstdio>
#include <string>

namespace {

using namespace nearfield;
using namespace nearfield::golden;

std::string hexadecimal(uint64_t number) {
  char text[32];
  std::snprintf(text, sizeof text, "0x%016llx", static_cast<unsigned long long>(number));
  return text;
}

TEST(QueryDigest, Fixed27) {
  EXPECT_EQ(hexadecimal(query_digest<Fixed<27>>(kDigestQueries)), hexadecimal(kFixed27Digest));
}
TEST(QueryDigest, Fixed16) {
  EXPECT_EQ(hexadecimal(query_digest<Fixed<16>>(kDigestQueries)), hexadecimal(kFixed16Digest));
}
TEST(QueryDigest, Float) {
  EXPECT_EQ(hexadecimal(query_digest<float>(kDigestQueries)), hexadecimal(kFloatDigest));
}
TEST(QueryDigest, FirstQueriesAsOnTargets) {
  EXPECT_EQ(hexadecimal(query_digest<Fixed<27>>(kTargetDigestQueries)), hexadecimal(kFixed27TargetDigest));
  EXPECT_EQ(hexadecimal(query_digest<Fixed<16>>(kTargetDigestQueries)), hexadecimal(kFixed16TargetDigest));
  EXPECT_EQ(hexadecimal(query_digest<float>(kTargetDigestQueries)), hexadecimal(kFloatTargetDigest));
}

// All fields of the stream are valid ones, so that the digest covers evaluations and not only refusals.
template <class S>
void expect_valid_fields() {
  Writer<S> writers[4];
  EXPECT_TRUE(field(Scene<S>::smooth).valid());
  EXPECT_TRUE(field(Scene<S>::sharp).valid());
  EXPECT_TRUE(field(Scene<S>::carved).valid());
  EXPECT_TRUE(field(Scene<S>::moving).valid());
  EXPECT_TRUE(field(Scene<S>::soft).valid());
  EXPECT_EQ(program_of(writers[0], Scene<S>::nested).status(), LoadStatus::ok);
  EXPECT_EQ(program_of(writers[1], Scene<S>::carved).status(), LoadStatus::ok);
  EXPECT_EQ(program_of(writers[2], Scene<S>::soft_placed).status(), LoadStatus::ok);
  EXPECT_EQ(program_of(writers[3], unite(Scene<S>::turned, Scene<S>::sharp)).status(), LoadStatus::ok);
}
TEST(QueryStream, FieldsAreValid) {
  expect_valid_fields<Fixed<27>>();
  expect_valid_fields<Fixed<16>>();
  expect_valid_fields<float>();
}

TEST(QueryStream, CoversAllAnswers) {
  Stream stream(7);
  const auto node = field(Scene<Fixed<27>>::moving);
  int seen[4] = {};
  for (int i = 0; i < 20000; ++i) {
    const Pose<Fixed<27>> slots[2] = {pose_from<Fixed<27>>(stream), pose_from<Fixed<27>>(stream)};
    ++seen[static_cast<int>(clearance(node, point_from<Fixed<27>>(stream), slots, 2).status)];
  }
  EXPECT_GT(seen[static_cast<int>(ClearanceStatus::invalid)], 200);
  EXPECT_GT(seen[static_cast<int>(ClearanceStatus::touching)], 200);
  EXPECT_GT(seen[static_cast<int>(ClearanceStatus::clear)], 10000);
}

TEST(QueryStream, LongerStreamsHaveOtherDigests) {
  EXPECT_NE(query_digest<Fixed<27>>(10), query_digest<Fixed<27>>(11));
  EXPECT_NE(query_digest<float>(10), query_digest<float>(11));
}

}  // namespace
