#include "text/json_writer.hpp"

#include <gtest/gtest.h>

#include <cstdint>
#include <cstring>
#include <limits>
#include <random>
#include <stdexcept>
#include <string>

#include "text/json.hpp"

namespace nearfield::host {
namespace {

TEST(JsonWriter, WritesOneLineAndIndented) {
  const auto write = [](JsonWriter::Layout layout) {
    JsonWriter writer(layout);
    writer.begin_object().key("a").begin_array().number(0.1).integer(-3).end_array();
    writer.key("b").begin_object().end_object().key("c").boolean(true).key("d").null();
    writer.key("e").string("x").key("f").unsigned_integer(18446744073709551615U).end_object();
    return writer.text();
  };
  EXPECT_EQ(write(JsonWriter::Layout::one_line),
            R"({"a": [0.1, -3], "b": {}, "c": true, "d": null, "e": "x", "f": 18446744073709551615})");
  EXPECT_EQ(write(JsonWriter::Layout::indented),
            "{\n  \"a\": [\n    0.1,\n    -3\n  ],\n  \"b\": {},\n  \"c\": true,\n  \"d\": null,\n"
            "  \"e\": \"x\",\n  \"f\": 18446744073709551615\n}");
}

TEST(JsonWriter, StringsReadBack) {
  const std::string text = "quote \" backslash \\ line\nfeed \t \x01 \x7f é€😀";
  JsonWriter writer;
  writer.string(text);
  EXPECT_EQ(parse_json(writer.text(), "f").root.string, text);
  JsonWriter replaced;
  replaced.string(
      "a\xff"
      "b");
  EXPECT_EQ(parse_json(replaced.text(), "f").root.string,
            "a\xef\xbf\xbd"
            "b");
}

TEST(JsonWriter, NumbersReadBackToTheSameBits) {
  const std::uint64_t seed = 20240517;
  std::mt19937_64 random(seed);
  for (int count = 0; count < 20000; ++count) {
    const std::uint64_t bits = random();
    double value = 0.0;
    std::memcpy(&value, &bits, sizeof value);
    if (!(value >= std::numeric_limits<double>::lowest() && value <= std::numeric_limits<double>::max()))
      continue;
    JsonWriter writer;
    writer.number(value);
    const double back = parse_json(writer.text(), "f").root.number;
    ASSERT_EQ(std::memcmp(&back, &value, sizeof value), 0) << writer.text() << ", seed " << seed;
  }
}

TEST(JsonWriter, RefusesWhatIsNotJson) {
  JsonWriter writer;
  EXPECT_THROW(writer.number(std::numeric_limits<double>::infinity()), std::invalid_argument);
  EXPECT_THROW(writer.number(std::numeric_limits<double>::quiet_NaN()), std::invalid_argument);
  EXPECT_THROW(writer.key("a"), std::logic_error);
  EXPECT_THROW(writer.end_array(), std::logic_error);
  EXPECT_THROW(writer.text(), std::logic_error);
  writer.begin_object();
  EXPECT_THROW(writer.null(), std::logic_error);
  writer.key("a");
  EXPECT_THROW(writer.key("b"), std::logic_error);
  EXPECT_THROW(writer.end_object(), std::logic_error);
  writer.null();
  EXPECT_THROW(writer.end_array(), std::logic_error);
  writer.end_object();
  EXPECT_THROW(writer.null(), std::logic_error);
  EXPECT_EQ(writer.text(), R"({"a": null})");
}

}  // namespace
}  // namespace nearfield::host
