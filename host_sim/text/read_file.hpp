#pragma once

#include <cstddef>
#include <string>
#include <string_view>

namespace nearfield::host {

inline constexpr std::size_t largest_input_file = std::size_t{64} << 20U;  // bytes

// The bytes of a file. InputError when it is missing, a directory, unreadable or larger than
// `largest_input_file`.
std::string read_file(const std::string& path);

// Replaces a file as a whole: writes a new file beside it and renames that over it, so that a reader sees
// the old or the new text and a failure leaves the old one. Links are followed; a device or a pipe is written
// to directly. InputError when it cannot be written.
void write_file(const std::string& path, std::string_view text);

}  // namespace nearfield::host
