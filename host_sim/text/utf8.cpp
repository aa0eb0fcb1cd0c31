#include "text/utf8.hpp"

#include <algorithm>

namespace nearfield::host {

std::size_t utf8_length(std::string_view text) {
  if (text.empty()) return 0;
  const auto byte = [text](std::size_t index) -> unsigned {
    return index < text.size() ? static_cast<unsigned char>(text[index]) : 0U;
  };
  const auto continues = [byte](std::size_t index) { return (byte(index) & 0xc0U) == 0x80U; };
  const unsigned first = byte(0);
  const unsigned second = byte(1);
  if (first < 0x80U) return 1;
  if (first < 0xc2U || first > 0xf4U || !continues(1)) return 0;
  if (first < 0xe0U) return 2;
  if (!continues(2)) return 0;
  if (first < 0xf0U) {
    const bool overlong = first == 0xe0U && second < 0xa0U;
    const bool surrogate = first == 0xedU && second >= 0xa0U;
    return overlong || surrogate ? 0 : 3;
  }
  const bool overlong = first == 0xf0U && second < 0x90U;
  const bool too_large = first == 0xf4U && second >= 0x90U;
  return overlong || too_large || !continues(3) ? 0 : 4;
}

std::optional<std::size_t> first_invalid_utf8(std::string_view text) {
  std::size_t offset = 0;
  while (offset < text.size()) {
    const std::size_t length = utf8_length(text.substr(offset));
    if (length == 0) return offset;
    offset += length;
  }
  return std::nullopt;
}

void append_utf8(std::string& text, std::uint32_t code_point) {
  const auto append = [&text](std::uint32_t byte) { text += static_cast<char>(byte); };
  if (code_point < 0x80U) {
    append(code_point);
    return;
  }
  if (code_point < 0x800U) {
    append(0xc0U | (code_point >> 6U));
  } else {
    if (code_point < 0x10000U) {
      append(0xe0U | (code_point >> 12U));
    } else {
      append(0xf0U | (code_point >> 18U));
      append(0x80U | ((code_point >> 12U) & 0x3fU));
    }
    append(0x80U | ((code_point >> 6U) & 0x3fU));
  }
  append(0x80U | (code_point & 0x3fU));
}

void advance(SourcePosition& position, char byte) {
  if (byte == '\n') {
    ++position.line;
    position.column = 1;
  } else if ((static_cast<unsigned char>(byte) & 0xc0U) != 0x80U) {
    ++position.column;
  }
}

SourcePosition position_at(std::string_view text, std::size_t offset) {
  SourcePosition position{1, 1};
  for (const char byte : text.substr(0, std::min(offset, text.size()))) advance(position, byte);
  return position;
}

}  // namespace nearfield::host
