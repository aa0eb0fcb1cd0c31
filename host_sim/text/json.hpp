#pragma once

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

#include "text/source_position.hpp"

namespace nearfield::host {

enum class JsonKind { null, boolean, number, string, array, object };

struct JsonMember;

// One JSON value. Only the member that belongs to its kind is meaningful.
struct JsonValue {
  JsonKind kind = JsonKind::null;
  SourcePosition position;
  bool boolean = false;
  double number = 0.0;  // finite
  std::string string;   // UTF-8
  std::vector<JsonValue> elements;
  std::vector<JsonMember> members;  // in the file's order, keys unique
};

struct JsonMember {
  std::string key;
  SourcePosition key_position;
  JsonValue value;
};

struct JsonDocument {
  std::string file;  // as named in errors
  JsonValue root;
};

inline constexpr std::size_t deepest_json = 64;           // nested arrays and objects
inline constexpr std::size_t most_json_values = 2000000;  // in one document

// Reads one JSON text exactly as RFC 8259 has it, in UTF-8 without a byte order mark. InputError, with the
// position and as much of the path as is known, on any other text, on a key that an object has twice, on a
// number that no double can hold, and beyond the two limits above.
JsonDocument parse_json(std::string_view text, const std::string& file);

// Paths as errors write them: `field.operands[2]`, and `["odd key"]` for a key that is not a plain word.
std::string json_path_of_key(std::string_view parent, std::string_view key);
std::string json_path_of_element(std::string_view parent, std::size_t index);

}  // namespace nearfield::host
