#pragma once

#include <cstddef>
#include <stdexcept>
#include <string>
#include <string_view>
#include <utility>

#include "text/source_position.hpp"

namespace nearfield::host {

// Something in the user's input is wrong. what() is one line,
// `FILE:LINE:COLUMN: PATH: message; allowed`, in which unknown parts are left out and control characters
// are escaped. `path` names the faulty value, e.g. `field.operands[2].radius`; `allowed` says what is right.
class InputError : public std::runtime_error {
 public:
  InputError(std::string file, SourcePosition position, std::string path, std::string message,
             std::string allowed)
      : std::runtime_error(one_line(file, position, path, message, allowed)),
        file_(std::move(file)),
        position_(position),
        path_(std::move(path)),
        message_(std::move(message)),
        allowed_(std::move(allowed)) {}

  const std::string& file() const { return file_; }
  SourcePosition position() const { return position_; }
  std::size_t line() const { return position_.line; }
  std::size_t column() const { return position_.column; }
  const std::string& path() const { return path_; }
  const std::string& message() const { return message_; }
  const std::string& allowed() const { return allowed_; }

 private:
  static std::string one_line(const std::string& file, SourcePosition position, const std::string& path,
                              const std::string& message, const std::string& allowed) {
    std::string text = file;
    if (position.line != 0) {
      text += ":" + std::to_string(position.line) + ":" + std::to_string(position.column);
    }
    if (!text.empty()) text += ": ";
    if (!path.empty()) text += path + ": ";
    text += message;
    if (!allowed.empty()) text += "; " + allowed;
    return without_control_characters(text);
  }

  static std::string without_control_characters(std::string_view text) {
    constexpr char digits[] = "0123456789abcdef";
    std::string clean;
    clean.reserve(text.size());
    for (const char character : text) {
      const unsigned byte = static_cast<unsigned char>(character);
      if (byte >= 0x20U && byte != 0x7fU) {
        clean += character;
      } else {
        clean += "\\x";
        clean += digits[byte >> 4U];
        clean += digits[byte & 0xfU];
      }
    }
    return clean;
  }

  std::string file_;
  SourcePosition position_;
  std::string path_;
  std::string message_;
  std::string allowed_;
};

}  // namespace nearfield::host
