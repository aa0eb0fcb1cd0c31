#include "text/json_node.hpp"

#include <algorithm>
#include <cmath>

#include "text/input_error.hpp"
#include "text/names.hpp"

namespace nearfield::host {
namespace {

std::string kind_in_words(JsonKind kind) {
  switch (kind) {
    case JsonKind::null: return "null";
    case JsonKind::boolean: return "true or false";
    case JsonKind::number: return "a number";
    case JsonKind::string: return "a string";
    case JsonKind::array: return "an array";
    case JsonKind::object: return "an object";
  }
  return "a value";
}

bool has_control_characters(std::string_view text) {
  return std::any_of(text.begin(), text.end(), [](char character) {
    const auto byte = static_cast<unsigned char>(character);
    return byte < 0x20U || byte == 0x7fU;
  });
}

}  // namespace

JsonNode::JsonNode(const JsonDocument& document) : value_(&document.root), file_(&document.file) {}

std::string JsonNode::path() const { return path_.empty() ? "document" : path_; }

void JsonNode::fail(const std::string& message, const std::string& allowed) const {
  throw InputError(*file_, value_->position, path(), message, allowed);
}

void JsonNode::require_kind(JsonKind kind, const std::string& allowed) const {
  if (value_->kind != kind) fail(kind_in_words(value_->kind) + " is not allowed here", allowed);
}

const JsonMember* JsonNode::find(std::string_view key) const {
  require_kind(JsonKind::object, "an object");
  for (const JsonMember& member : value_->members) {
    if (member.key == key) return &member;
  }
  return nullptr;
}

bool JsonNode::has(std::string_view key) const { return find(key) != nullptr; }

JsonNode JsonNode::required(std::string_view key, std::string_view expectation) const {
  if (const JsonMember* member = find(key)) {
    return JsonNode(member->value, *file_, json_path_of_key(path_, key));
  }
  throw InputError(*file_, value_->position, json_path_of_key(path_, key), "missing",
                   expectation.empty() ? "this key is required" : "required: " + std::string(expectation));
}

std::optional<JsonNode> JsonNode::optional(std::string_view key) const {
  const JsonMember* member = find(key);
  if (member == nullptr) return std::nullopt;
  return JsonNode(member->value, *file_, json_path_of_key(path_, key));
}

std::vector<std::pair<std::string, JsonNode>> JsonNode::members() const {
  require_kind(JsonKind::object, "an object");
  std::vector<std::pair<std::string, JsonNode>> result;
  for (const JsonMember& member : value_->members) {
    result.emplace_back(member.key, JsonNode(member.value, *file_, json_path_of_key(path_, member.key)));
  }
  return result;
}

void JsonNode::reject_unknown_keys(const std::vector<std::string_view>& allowed) const {
  require_kind(JsonKind::object, "an object");
  for (const JsonMember& member : value_->members) {
    if (std::find(allowed.begin(), allowed.end(), member.key) != allowed.end()) continue;
    throw InputError(*file_, member.key_position, json_path_of_key(path_, member.key),
                     unknown_name("key", member.key, allowed), "allowed keys: " + joined(allowed));
  }
}

std::vector<JsonNode> JsonNode::elements(std::size_t fewest, std::size_t most) const {
  const std::string counts =
      fewest == most ? std::to_string(fewest) : std::to_string(fewest) + " to " + std::to_string(most);
  const std::string allowed = "an array of " + counts + " elements";
  require_kind(JsonKind::array, allowed);
  const std::size_t count = value_->elements.size();
  if (count < fewest || count > most) fail("array of " + std::to_string(count), allowed);
  std::vector<JsonNode> result;
  for (std::size_t index = 0; index < count; ++index) {
    result.push_back(JsonNode(value_->elements[index], *file_, json_path_of_element(path_, index)));
  }
  return result;
}

double JsonNode::number(const NumberRange& range) const {
  const std::string allowed = "a number " + describe(range);
  require_kind(JsonKind::number, allowed);
  if (!contains(range, value_->number)) fail(format_number(value_->number) + " is out of range", allowed);
  return value_->number;
}

std::vector<double> JsonNode::numbers(std::size_t count, const NumberRange& range) const {
  const std::string allowed = "an array of " + std::to_string(count) + " numbers " + describe(range);
  require_kind(JsonKind::array, allowed);
  if (value_->elements.size() != count) {
    fail("array of " + std::to_string(value_->elements.size()), allowed);
  }
  std::vector<double> result;
  for (const JsonNode& element : elements(count, count)) result.push_back(element.number(range));
  return result;
}

std::int64_t JsonNode::integer(std::int64_t lowest, std::int64_t highest) const {
  const std::string allowed =
      "a whole number from " + std::to_string(lowest) + " to " + std::to_string(highest);
  require_kind(JsonKind::number, allowed);
  const double value = value_->number;
  if (value != std::floor(value)) fail(format_number(value) + " is not a whole number", allowed);
  if (value < static_cast<double>(lowest) || value > static_cast<double>(highest)) {
    fail(format_number(value) + " is out of range", allowed);
  }
  return static_cast<std::int64_t>(value);
}

bool JsonNode::boolean() const {
  require_kind(JsonKind::boolean, "true or false");
  return value_->boolean;
}

std::string JsonNode::string(std::size_t longest) const {
  const std::string allowed = "a string of 1 to " + std::to_string(longest) + " bytes";
  require_kind(JsonKind::string, allowed);
  if (value_->string.empty()) fail("empty string", allowed);
  if (value_->string.size() > longest) fail("string of " + std::to_string(value_->string.size()), allowed);
  if (has_control_characters(value_->string)) {
    fail("control character in a string", allowed + " without control characters");
  }
  return value_->string;
}

std::size_t JsonNode::choice(const std::vector<std::string_view>& allowed) const {
  const std::string choices = "one of " + joined(allowed);
  require_kind(JsonKind::string, choices);
  const auto found = std::find(allowed.begin(), allowed.end(), value_->string);
  if (found == allowed.end()) fail(unknown_name("name", value_->string, allowed), choices);
  return static_cast<std::size_t>(found - allowed.begin());
}

}  // namespace nearfield::host
