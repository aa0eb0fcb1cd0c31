#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

namespace nearfield::host {

// Writes one JSON value piece by piece. Numbers have the shortest form that reads back the same. Text that is
// not UTF-8 is written with U+FFFD in place of each wrong byte. std::logic_error on pieces in a wrong order
// (a value without a key in an object, a missing end, a second root) and std::invalid_argument on a number
// that is not finite, which JSON cannot express.
class JsonWriter {
 public:
  enum class Layout { one_line, indented };
  explicit JsonWriter(Layout layout = Layout::one_line) : layout_(layout) {}

  JsonWriter& begin_object();
  JsonWriter& end_object();
  JsonWriter& begin_array();
  JsonWriter& end_array();
  JsonWriter& key(std::string_view key);

  JsonWriter& number(double value);
  JsonWriter& integer(std::int64_t value);
  JsonWriter& unsigned_integer(std::uint64_t value);
  JsonWriter& string(std::string_view value);
  JsonWriter& boolean(bool value);
  JsonWriter& null();

  // The finished text.
  const std::string& text() const;

 private:
  struct Level {
    bool is_object;
    bool is_empty;
  };

  JsonWriter& value(std::string_view text);
  void begin(bool is_object);
  JsonWriter& end(bool is_object);
  void separate();
  void start_line();

  Layout layout_;
  std::string text_;
  std::vector<Level> levels_;
  bool key_written_ = false;
  bool finished_ = false;
};

}  // namespace nearfield::host
