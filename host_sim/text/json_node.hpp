#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "text/json.hpp"
#include "text/number.hpp"

namespace nearfield::host {

// A place in a JSON document that knows its path, so that every error names file, line, column and path.
// Points into the document, which must outlive it. Every function but those marked noexcept throws
// InputError when the value is not what is asked for; the error says what would be right.
class JsonNode {
 public:
  explicit JsonNode(const JsonDocument& document);
  explicit JsonNode(JsonDocument&&) = delete;

  JsonKind kind() const noexcept { return value_->kind; }
  SourcePosition position() const noexcept { return value_->position; }
  const std::string& file() const noexcept { return *file_; }
  // As errors show it: `document` for the root.
  std::string path() const;

  // Members of an object. `expectation` tells what the missing value would be, e.g. `a number in m`.
  bool has(std::string_view key) const;
  JsonNode required(std::string_view key, std::string_view expectation = {}) const;
  std::optional<JsonNode> optional(std::string_view key) const;
  std::vector<std::pair<std::string, JsonNode>> members() const;
  // Refuses, at the key, the first key that is not in the list, and names the nearest one that is.
  void reject_unknown_keys(const std::vector<std::string_view>& allowed) const;

  // Elements of an array that has from `fewest` to `most` of them.
  std::vector<JsonNode> elements(std::size_t fewest, std::size_t most) const;

  double number(const NumberRange& range) const;
  std::vector<double> numbers(std::size_t count, const NumberRange& range) const;
  // A whole number from `lowest` to `highest`, both within ±2^53.
  std::int64_t integer(std::int64_t lowest, std::int64_t highest) const;
  bool boolean() const;
  // From 1 to `longest` bytes without control characters.
  std::string string(std::size_t longest) const;
  // The index in `allowed` of a string; on a wrong one the error names the nearest.
  std::size_t choice(const std::vector<std::string_view>& allowed) const;

  [[noreturn]] void fail(const std::string& message, const std::string& allowed) const;

 private:
  JsonNode(const JsonValue& value, const std::string& file, std::string path)
      : value_(&value), file_(&file), path_(std::move(path)) {}

  void require_kind(JsonKind kind, const std::string& allowed) const;
  const JsonMember* find(std::string_view key) const;

  const JsonValue* value_;
  const std::string* file_;
  std::string path_;
};

}  // namespace nearfield::host
