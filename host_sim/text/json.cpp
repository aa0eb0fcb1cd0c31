#include "text/json.hpp"

#include <algorithm>
#include <cstdint>
#include <optional>
#include <unordered_set>
#include <utility>

#include "text/input_error.hpp"
#include "text/names.hpp"
#include "text/number.hpp"
#include "text/utf8.hpp"

namespace nearfield::host {
namespace {

bool is_digit(int character) { return character >= '0' && character <= '9'; }

class JsonParser {
 public:
  JsonParser(std::string_view text, const std::string& file) : text_(text), file_(file) {}

  JsonValue parse() {
    if (text_.substr(0, 3) == "\xef\xbb\xbf") fail("byte order mark", "UTF-8 without one");
    if (const auto invalid = first_invalid_utf8(text_)) {
      here_ = position_at(text_, *invalid);
      fail("bytes that are not UTF-8", "the file must be UTF-8");
    }
    skip_white_space();
    JsonValue root = parse_value();
    skip_white_space();
    if (peek() != at_end) fail("text after the end of the JSON value", "one value and nothing else");
    return root;
  }

 private:
  static constexpr int at_end = -1;

  [[noreturn]] void fail(const std::string& message, const std::string& allowed) const {
    fail_at(here_, message, allowed);
  }

  [[noreturn]] void fail_at(SourcePosition position, const std::string& message,
                            const std::string& allowed) const {
    throw InputError(file_, position, path_, message, allowed);
  }

  int peek() const { return offset_ < text_.size() ? static_cast<unsigned char>(text_[offset_]) : at_end; }

  char take() {
    const char byte = text_[offset_++];
    advance(here_, byte);
    return byte;
  }

  bool take_if(char wanted) {
    if (offset_ >= text_.size() || text_[offset_] != wanted) return false;
    take();
    return true;
  }

  void skip_white_space() {
    while (peek() == ' ' || peek() == '\t' || peek() == '\n' || peek() == '\r') take();
  }

  // The next code point in words, for an error.
  std::string found() const {
    if (peek() == at_end) return "the text ends too early";
    const std::string_view rest = text_.substr(offset_);
    return "unexpected " + in_quotes(rest.substr(0, utf8_length(rest)));
  }

  JsonValue parse_value() {
    if (++value_count_ > most_json_values) {
      fail("too many values", "at most " + std::to_string(most_json_values));
    }
    JsonValue value;
    value.position = here_;
    switch (peek()) {
      case '{': parse_object(value); break;
      case '[': parse_array(value); break;
      case '"':
        value.kind = JsonKind::string;
        value.string = parse_string();
        break;
      case 't': parse_word("true"); value.kind = JsonKind::boolean; value.boolean = true; break;
      case 'f': parse_word("false"); value.kind = JsonKind::boolean; break;
      case 'n': parse_word("null"); break;
      default: parse_number_value(value); break;
    }
    return value;
  }

  void parse_word(std::string_view word) {
    if (text_.substr(offset_, word.size()) != word) {
      fail(found(), "a JSON value, such as " + std::string(word));
    }
    for (std::size_t index = 0; index < word.size(); ++index) take();
  }

  void parse_number_value(JsonValue& value) {
    const SourcePosition start = here_;
    const std::size_t begin = offset_;
    const std::string digit_needed = "a digit is needed here";
    const bool negative = take_if('-');
    if (!negative && !is_digit(peek())) {
      fail(found(), "a JSON value: an object, array, string, number, true, false or null");
    }
    if (!is_digit(peek())) fail(found(), digit_needed);
    if (take_if('0')) {
      if (is_digit(peek())) fail_at(start, "number with a leading zero", "no leading zeros");
    } else {
      take_digits();
    }
    if (take_if('.')) {
      if (!is_digit(peek())) fail(found(), digit_needed);
      take_digits();
    }
    if (peek() == 'e' || peek() == 'E') {
      take();
      if (peek() == '+' || peek() == '-') take();
      if (!is_digit(peek())) fail(found(), digit_needed);
      take_digits();
    }
    const std::string_view digits = text_.substr(begin, offset_ - begin);
    const std::optional<double> number = parse_number(digits);
    if (!number) {
      fail_at(start, "number " + in_quotes(digits) + " is out of range", "a double-precision number");
    }
    value.kind = JsonKind::number;
    value.number = *number;
  }

  void take_digits() {
    while (is_digit(peek())) take();
  }

  std::uint32_t parse_four_hexadecimal_digits() {
    std::uint32_t code = 0;
    for (int count = 0; count < 4; ++count) {
      const int digit = peek();
      std::uint32_t nibble = 0;
      if (is_digit(digit)) {
        nibble = static_cast<std::uint32_t>(digit - '0');
      } else if (digit >= 'a' && digit <= 'f') {
        nibble = static_cast<std::uint32_t>(digit - 'a' + 10);
      } else if (digit >= 'A' && digit <= 'F') {
        nibble = static_cast<std::uint32_t>(digit - 'A' + 10);
      } else {
        fail(found(), "four hexadecimal digits after \\u");
      }
      code = code * 16U + nibble;
      take();
    }
    return code;
  }

  void parse_unicode_escape(std::string& text, SourcePosition start) {
    const std::string pairs_needed = "surrogates come in pairs, high and then low";
    std::uint32_t code = parse_four_hexadecimal_digits();
    if (code >= 0xdc00U && code <= 0xdfffU) fail_at(start, "low surrogate without a high one", pairs_needed);
    if (code >= 0xd800U && code <= 0xdbffU) {
      const bool escaped = take_if('\\') && take_if('u');
      const std::uint32_t low = escaped ? parse_four_hexadecimal_digits() : 0U;
      if (low < 0xdc00U || low > 0xdfffU) fail_at(start, "high surrogate without a low one", pairs_needed);
      code = 0x10000U + ((code - 0xd800U) << 10U) + (low - 0xdc00U);
    }
    append_utf8(text, code);
  }

  void parse_escape(std::string& text) {
    const SourcePosition start = here_;
    take();
    switch (peek()) {
      case '"': case '\\': case '/': text += take(); return;
      case 'b': text += '\b'; break;
      case 'f': text += '\f'; break;
      case 'n': text += '\n'; break;
      case 'r': text += '\r'; break;
      case 't': text += '\t'; break;
      case 'u': take(); parse_unicode_escape(text, start); return;
      default: fail(found(), "an escape is one of \\\" \\\\ \\/ \\b \\f \\n \\r \\t \\uXXXX");
    }
    take();
  }

  std::string parse_string() {
    const SourcePosition start = here_;
    take();
    std::string text;
    while (true) {
      const int next = peek();
      if (next == at_end) fail_at(start, "string without an end", "a closing quotation mark");
      if (next < 0x20) fail("control character in a string", "an escape such as \\n or \\u001f");
      if (next == '"') break;
      if (next == '\\') {
        parse_escape(text);
      } else {
        text += take();
      }
    }
    take();
    return text;
  }

  void enter() {
    if (++depth_ > deepest_json) {
      fail("nested too deeply", "at most " + std::to_string(deepest_json) + " levels");
    }
    take();
    skip_white_space();
  }

  void parse_array(JsonValue& array) {
    array.kind = JsonKind::array;
    enter();
    const std::size_t path_size = path_.size();
    if (!take_if(']')) {
      while (true) {
        path_ = json_path_of_element(path_, array.elements.size());
        array.elements.push_back(parse_value());
        path_.resize(path_size);
        skip_white_space();
        if (take_if(']')) break;
        if (!take_if(',')) fail(found(), "\",\" or \"]\" after an array's element");
        skip_white_space();
      }
    }
    --depth_;
  }

  void parse_object(JsonValue& object) {
    object.kind = JsonKind::object;
    enter();
    const std::size_t path_size = path_.size();
    std::unordered_set<std::string> keys;
    if (!take_if('}')) {
      while (true) {
        object.members.push_back(parse_member(keys));
        path_.resize(path_size);
        skip_white_space();
        if (take_if('}')) break;
        if (!take_if(',')) fail(found(), "\",\" or \"}\" after an object's member");
        skip_white_space();
      }
    }
    --depth_;
  }

  JsonMember parse_member(std::unordered_set<std::string>& keys) {
    if (peek() != '"') fail(found(), "a key in quotation marks");
    JsonMember member;
    member.key_position = here_;
    member.key = parse_string();
    path_ = json_path_of_key(path_, member.key);
    if (!keys.insert(member.key).second) {
      fail_at(member.key_position, "the key is there twice", "each key once");
    }
    skip_white_space();
    if (!take_if(':')) fail(found(), "\":\" after a key");
    skip_white_space();
    member.value = parse_value();
    return member;
  }

  std::string_view text_;
  const std::string& file_;
  std::size_t offset_ = 0;
  SourcePosition here_{1, 1};
  std::string path_;
  std::size_t depth_ = 0;
  std::size_t value_count_ = 0;
};

bool is_plain_word(std::string_view key) {
  const auto plain = [](char character) {
    return (character >= 'a' && character <= 'z') || (character >= 'A' && character <= 'Z') ||
           is_digit(character) || character == '_' || character == '-';
  };
  return !key.empty() && std::all_of(key.begin(), key.end(), plain);
}

}  // namespace

JsonDocument parse_json(std::string_view text, const std::string& file) {
  return JsonDocument{file, JsonParser(text, file).parse()};
}

std::string json_path_of_key(std::string_view parent, std::string_view key) {
  std::string path(parent);
  if (!is_plain_word(key)) return path + "[" + in_quotes(key) + "]";
  if (!path.empty()) path += ".";
  return path += key;
}

std::string json_path_of_element(std::string_view parent, std::size_t index) {
  return std::string(parent) + "[" + std::to_string(index) + "]";
}

}  // namespace nearfield::host
