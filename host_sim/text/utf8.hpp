#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

#include "text/source_position.hpp"

namespace nearfield::host {

// The length in bytes, 1 to 4, of the well-formed code point (no overlong form, no surrogate, at most
// U+10FFFF) at the start of `text`; 0 when there is none.
std::size_t utf8_length(std::string_view text);

// The byte offset of the first byte that is not part of well-formed UTF-8; nothing when all of it is.
std::optional<std::size_t> first_invalid_utf8(std::string_view text);

// Appends a code point other than a surrogate, at most U+10FFFF.
void append_utf8(std::string& text, std::uint32_t code_point);

// Moves a position over one byte of well-formed UTF-8: a line feed starts a new line.
void advance(SourcePosition& position, char byte);

// The position of the byte at `offset`.
SourcePosition position_at(std::string_view text, std::size_t offset);

}  // namespace nearfield::host
