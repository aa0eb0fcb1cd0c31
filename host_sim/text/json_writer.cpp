#include "text/json_writer.hpp"

#include <cmath>
#include <stdexcept>

#include "text/number.hpp"
#include "text/utf8.hpp"

namespace nearfield::host {
namespace {

std::string escaped(std::string_view text) {
  constexpr char digits[] = "0123456789abcdef";
  std::string result = "\"";
  while (!text.empty()) {
    const std::size_t length = utf8_length(text);
    const unsigned byte = static_cast<unsigned char>(text.front());
    if (length == 0) {
      append_utf8(result, 0xfffdU);
    } else if (byte == '"' || byte == '\\') {
      result += '\\';
      result += text.front();
    } else if (byte == '\n') {
      result += "\\n";
    } else if (byte == '\t') {
      result += "\\t";
    } else if (byte < 0x20U || byte == 0x7fU) {
      result += "\\u00";
      result += digits[byte >> 4U];
      result += digits[byte & 0xfU];
    } else {
      result += text.substr(0, length);
    }
    text.remove_prefix(length == 0 ? 1 : length);
  }
  return result + "\"";
}

}  // namespace

void JsonWriter::start_line() {
  if (layout_ == Layout::one_line) return;
  text_ += '\n';
  text_.append(2 * levels_.size(), ' ');
}

// Whatever must stand between the piece before and a value or key.
void JsonWriter::separate() {
  if (levels_.empty()) return;
  if (!levels_.back().is_empty) text_ += layout_ == Layout::one_line ? ", " : ",";
  levels_.back().is_empty = false;
  start_line();
}

JsonWriter& JsonWriter::value(std::string_view text) {
  if (finished_) throw std::logic_error("JSON: a second root value");
  const bool in_object = !levels_.empty() && levels_.back().is_object;
  if (in_object && !key_written_) throw std::logic_error("JSON: a value without a key");
  if (!in_object) separate();
  key_written_ = false;
  text_ += text;
  finished_ = levels_.empty();
  return *this;
}

JsonWriter& JsonWriter::key(std::string_view key) {
  if (levels_.empty() || !levels_.back().is_object || key_written_) {
    throw std::logic_error("JSON: a key where none is allowed");
  }
  separate();
  text_ += escaped(key);
  text_ += ": ";
  key_written_ = true;
  return *this;
}

void JsonWriter::begin(bool is_object) {
  value(is_object ? "{" : "[");
  levels_.push_back({is_object, true});
  finished_ = false;
}

JsonWriter& JsonWriter::end(bool is_object) {
  if (levels_.empty() || levels_.back().is_object != is_object || key_written_) {
    throw std::logic_error("JSON: an end where none is allowed");
  }
  const bool was_empty = levels_.back().is_empty;
  levels_.pop_back();
  if (!was_empty) start_line();
  text_ += is_object ? '}' : ']';
  finished_ = levels_.empty();
  return *this;
}

JsonWriter& JsonWriter::begin_object() {
  begin(true);
  return *this;
}

JsonWriter& JsonWriter::begin_array() {
  begin(false);
  return *this;
}

JsonWriter& JsonWriter::end_object() { return end(true); }

JsonWriter& JsonWriter::end_array() { return end(false); }

JsonWriter& JsonWriter::number(double value_to_write) {
  if (!std::isfinite(value_to_write)) throw std::invalid_argument("JSON: a number that is not finite");
  return value(format_number(value_to_write));
}

JsonWriter& JsonWriter::integer(std::int64_t value_to_write) { return value(std::to_string(value_to_write)); }

JsonWriter& JsonWriter::unsigned_integer(std::uint64_t value_to_write) {
  return value(std::to_string(value_to_write));
}

JsonWriter& JsonWriter::string(std::string_view value_to_write) { return value(escaped(value_to_write)); }

JsonWriter& JsonWriter::boolean(bool value_to_write) { return value(value_to_write ? "true" : "false"); }

JsonWriter& JsonWriter::null() { return value("null"); }

const std::string& JsonWriter::text() const {
  if (!finished_) throw std::logic_error("JSON: the value is not finished");
  return text_;
}

}  // namespace nearfield::host
