#include "text/json.hpp"

#include <gtest/gtest.h>

#include <string>
#include <vector>

#include "input_error_expectation.hpp"

namespace nearfield::host {
namespace {

TEST(Json, ReadsEveryKindWithItsPosition) {
  const JsonDocument document =
      parse_json("{\"a\": [1, -2.5e3, true],\n  \"b\": {\"c\": null, \"d\": \"x\"}}", "f");
  ASSERT_EQ(document.root.kind, JsonKind::object);
  ASSERT_EQ(document.root.members.size(), 2U);
  const JsonMember& a = document.root.members[0];
  EXPECT_EQ(a.key, "a");
  ASSERT_EQ(a.value.elements.size(), 3U);
  EXPECT_EQ(a.value.elements[1].number, -2500.0);
  EXPECT_EQ(a.value.elements[1].position.line, 1U);
  EXPECT_EQ(a.value.elements[1].position.column, 11U);
  EXPECT_TRUE(a.value.elements[2].boolean);
  const JsonMember& b = document.root.members[1];
  EXPECT_EQ(b.key_position.line, 2U);
  EXPECT_EQ(b.key_position.column, 3U);
  ASSERT_EQ(b.value.members.size(), 2U);
  EXPECT_EQ(b.value.members[0].value.kind, JsonKind::null);
  EXPECT_EQ(b.value.members[1].value.string, "x");
}

TEST(Json, NumbersAreCorrectlyRounded) {
  const JsonDocument document = parse_json("[0.1, 1e308, 4.9e-324, -0, 9007199254740993, 0.3e1]", "f");
  const std::vector<double> expected{0.1, 1e308, 4.9e-324, -0.0, 9007199254740992.0, 3.0};
  ASSERT_EQ(document.root.elements.size(), expected.size());
  for (std::size_t index = 0; index < expected.size(); ++index) {
    EXPECT_EQ(document.root.elements[index].number, expected[index]) << index;
  }
}

TEST(Json, EscapesBecomeUtf8) {
  const JsonDocument document = parse_json(R"(["\"\\\/\b\f\n\r\t", "\u00e9\u20ac\ud83d\ude00", "é€😀"])", "f");
  EXPECT_EQ(document.root.elements[0].string, "\"\\/\b\f\n\r\t");
  EXPECT_EQ(document.root.elements[1].string, "é€😀");
  EXPECT_EQ(document.root.elements[2].string, "é€😀");
}

TEST(Json, ColumnsCountCodePoints) {
  expect_input_error(parse_json, {"[\"é€😀\", x]", "file:1:9: [1]: unexpected \"x\""});
}

TEST(Json, DepthAndSizeAreLimited) {
  const std::string deepest = std::string(64, '[') + std::string(64, ']');
  EXPECT_NO_THROW(parse_json(deepest, "f"));
  expect_input_error(parse_json, {"[" + deepest + "]", "file:1:65: [0]"});
  std::string many = "[0";
  for (std::size_t count = 0; count < most_json_values; ++count) many += ",0";
  try {
    parse_json(many + "]", "file");
    ADD_FAILURE();
  } catch (const InputError& error) {
    EXPECT_EQ(error.message(), "too many values");
  }
}

TEST(Json, RefusesWhatRfc8259DoesNotAllow) {
  const std::vector<Malformed> cases{
      {"", "file:1:1: the text ends too early"},
      {"  \n ", "file:2:2: the text ends too early"},
      {"{} {}", "file:1:4: text after the end"},
      {"\xef\xbb\xbf{}", "file:1:1: byte order mark"},
      {"{\"a\": 1,}", "file:1:9: unexpected \"}\""},
      {"{\"a\" 1}", "file:1:6: a: unexpected \"1\""},
      {"{\"a\": 1 \"b\": 2}", "file:1:9: unexpected \"\"\""},
      {"{a: 1}", "file:1:2: unexpected \"a\""},
      {"{\"a\": {\"b\": [1, 2,]}}", "file:1:19: a.b[2]: unexpected \"]\""},
      {"{\"a\": 1, \"b\": 2,\n \"a\": 3}", "file:2:2: a: the key is there twice"},
      {"{\"a\": {\"x y\": 1, \"x y\": 2}}", "file:1:18: a[\"x y\"]: the key is there twice"},
      {"[1, 2", "file:1:6: the text ends too early"},
      {"[1 2]", "file:1:4: unexpected \"2\""},
      {"[01]", "file:1:2: [0]: number with a leading zero"},
      {"[1.]", "file:1:4: [0]: unexpected \"]\""},
      {"[.5]", "file:1:2: [0]: unexpected \".\""},
      {"[+1]", "file:1:2: [0]: unexpected \"+\""},
      {"[-]", "file:1:3: [0]: unexpected \"]\""},
      {"[1e]", "file:1:4: [0]: unexpected \"]\""},
      {"[1, 1e999]", "file:1:5: [1]: number \"1e999\" is out of range"},
      {"[NaN]", "file:1:2: [0]: unexpected \"N\""},
      {"[-Infinity]", "file:1:3: [0]: unexpected \"I\""},
      {"[0x10]", "file:1:3: unexpected \"x\""},
      {"[tru]", "file:1:2: [0]: unexpected \"t\""},
      {"[nulls]", "file:1:6: unexpected \"s\""},
      {"[\"abc]", "file:1:2: [0]: string without an end"},
      {"[\"a\nb\"]", "file:1:4: [0]: control character"},
      {"[\"\\x41\"]", "file:1:4: [0]: unexpected \"x\""},
      {"[\"\\u12g4\"]", "file:1:7: [0]: unexpected \"g\""},
      {"[\"\\ud800\"]", "file:1:3: [0]: high surrogate"},
      {"[\"\\ud800\\u0041\"]", "file:1:3: [0]: high surrogate"},
      {"[\"\\udc00\"]", "file:1:3: [0]: low surrogate"},
      {"[\"\xff\"]", "file:1:3: bytes that are not UTF-8"},
      {"[\"\xc0\xaf\"]", "file:1:3: bytes that are not UTF-8"},
      {"[\"\xed\xa0\x80\"]", "file:1:3: bytes that are not UTF-8"},
      {"// comment\n1", "file:1:1: unexpected \"/\""},
      {"['a']", "file:1:2: [0]: unexpected \"'\""},
  };
  for (const Malformed& malformed : cases) expect_input_error(parse_json, malformed);
}

}  // namespace
}  // namespace nearfield::host
