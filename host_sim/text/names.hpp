#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace nearfield::host {

// `"text"`, shortened to its first 60 bytes (whole code points) and `...` when it is longer.
std::string in_quotes(std::string_view text);

// The names separated by ", ".
std::string joined(const std::vector<std::string_view>& names);

// The least number of inserted, removed, replaced or swapped neighbouring bytes that turn `a` into `b`.
std::size_t edit_distance(std::string_view a, std::string_view b);

// The allowed name nearest to a misspelled one, or nothing when none is near (more than a third of its
// letters differ, and more than one) or the wrong name is longer than 64 bytes. Of equals, the first.
std::optional<std::string_view> nearest_name(std::string_view wrong,
                                             const std::vector<std::string_view>& allowed);

// `unknown KIND "wrong" (did you mean "nearest"?)`, for error messages.
std::string unknown_name(std::string_view kind, std::string_view wrong,
                         const std::vector<std::string_view>& allowed);

}  // namespace nearfield::host
