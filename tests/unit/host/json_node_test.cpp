#include "text/json_node.hpp"

#include <gtest/gtest.h>

#include <functional>
#include <string>
#include <utility>
#include <vector>

#include "input_error_expectation.hpp"

namespace nearfield::host {
namespace {

constexpr NumberRange metres{0.0, 16.0, "m", true};

TEST(JsonNode, ReadsValues) {
  const JsonDocument document = parse_json(
      R"({"number": 2.5, "vector": [1, 2, 3], "count": -7, "flag": true, "name": "arm", "kind": "box"})",
      "f");
  const JsonNode root(document);
  EXPECT_EQ(root.path(), "document");
  EXPECT_EQ(root.required("number").number(metres), 2.5);
  EXPECT_EQ(root.required("vector").numbers(3, metres), (std::vector<double>{1.0, 2.0, 3.0}));
  EXPECT_EQ(root.required("count").integer(-10, 10), -7);
  EXPECT_TRUE(root.required("flag").boolean());
  EXPECT_EQ(root.required("name").string(3), "arm");
  EXPECT_EQ(root.required("kind").choice({"sphere", "box"}), 1U);
  EXPECT_FALSE(root.optional("absent").has_value());
  EXPECT_FALSE(root.has("absent"));
  EXPECT_EQ(root.members().size(), 6U);
  EXPECT_EQ(root.required("vector").elements(3, 3)[2].path(), "vector[2]");
}

TEST(JsonNode, ErrorsSayWhereWhatAndWhatIsAllowed) {
  using Check = std::function<void(const JsonNode&)>;
  const std::vector<std::pair<Malformed, Check>> cases{
      {{"{\"a\": 17}", "file:1:7: a: 17 is out of range; a number above 0 and at most 16 m"},
       [](const JsonNode& root) { root.required("a").number(metres); }},
      {{"{\"a\": 0}", "file:1:7: a: 0 is out of range"},
       [](const JsonNode& root) { root.required("a").number(metres); }},
      {{"{\"a\": \"1\"}", "file:1:7: a: a string is not allowed here; a number"},
       [](const JsonNode& root) { root.required("a").number(metres); }},
      {{"{\"b\": {}}", "file:1:7: b.a: missing; this key is required"},
       [](const JsonNode& root) { root.required("b").required("a"); }},
      {{"{\"a\": [1, 2]}", "file:1:7: a: array of 2; an array of 3 numbers above 0 and at most 16 m"},
       [](const JsonNode& root) { root.required("a").numbers(3, metres); }},
      {{"{\"a\": [1, 2, null]}", "file:1:14: a[2]: null is not allowed here"},
       [](const JsonNode& root) { root.required("a").numbers(3, metres); }},
      {{"{\"a\": 1.5}", "file:1:7: a: 1.5 is not a whole number; a whole number from 0 to 9"},
       [](const JsonNode& root) { root.required("a").integer(0, 9); }},
      {{"{\"a\": 1e300}", "file:1:7: a: 1e+300 is out of range"},
       [](const JsonNode& root) { root.required("a").integer(0, 9); }},
      {{"{\"a\": 0}", "file:1:7: a: a number is not allowed here; true or false"},
       [](const JsonNode& root) { root.required("a").boolean(); }},
      {{"{\"a\": \"\"}", "file:1:7: a: empty string"},
       [](const JsonNode& root) { root.required("a").string(9); }},
      {{"{\"a\": \"abc\"}", "file:1:7: a: string of 3; a string of 1 to 2 bytes"},
       [](const JsonNode& root) { root.required("a").string(2); }},
      {{"{\"a\": \"x\\u0000\"}", "file:1:7: a: control character"},
       [](const JsonNode& root) { root.required("a").string(9); }},
      {{"{\"a\": \"shpere\"}",
        "file:1:7: a: unknown name \"shpere\" (did you mean \"sphere\"?); one of box, sphere"},
       [](const JsonNode& root) {
         root.required("a").choice({"box", "sphere"});
       }},
      {{"{\"a\": \"q\"}", "file:1:7: a: unknown name \"q\"; one of box, sphere"},
       [](const JsonNode& root) {
         root.required("a").choice({"box", "sphere"});
       }},
      {{"{\n \"raduis\": 1}",
        "file:2:2: raduis: unknown key \"raduis\" (did you mean \"radius\"?); allowed keys: radius, size"},
       [](const JsonNode& root) {
         root.reject_unknown_keys({"radius", "size"});
       }},
      {{"[1]", "file:1:1: document: an array is not allowed here; an object"},
       [](const JsonNode& root) { root.required("a"); }},
      {{"[1]", "file:1:1: document: array of 1; an array of 2 to 5 elements"},
       [](const JsonNode& root) { root.elements(2, 5); }},
  };
  for (const auto& [malformed, check] : cases) {
    const Check& run = check;
    const auto read = [&run](const std::string& text, const std::string& file) {
      const JsonDocument document = parse_json(text, file);
      run(JsonNode(document));
    };
    expect_input_error(read, malformed);
  }
}

}  // namespace
}  // namespace nearfield::host
