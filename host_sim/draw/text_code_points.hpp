#pragma once

#include <string>

namespace nearfield::host::draw {

/// The code points of UTF-8 text. What is not valid UTF-8 (truncated, overlong, surrogates) or not allowed in
/// XML (control characters, U+FFFE, U+FFFF) becomes U+FFFD, one for each byte or character.
std::u32string code_points(const std::string& utf8);

/// Appends one code point as UTF-8.
void append_utf8(std::string& text, char32_t code_point);

}  // namespace nearfield::host::draw
