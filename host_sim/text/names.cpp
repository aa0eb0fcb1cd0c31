#include "text/names.hpp"

#include <algorithm>
#include <cstddef>

namespace nearfield::host {

std::string in_quotes(std::string_view text) {
  constexpr std::size_t longest = 60;
  std::string result = "\"";
  if (text.size() <= longest) {
    result += text;
  } else {
    std::size_t end = longest;
    while (end > 0 && (static_cast<unsigned char>(text[end]) & 0xc0U) == 0x80U) --end;
    result += text.substr(0, end);
    result += "...";
  }
  return result + "\"";
}

std::string joined(const std::vector<std::string_view>& names) {
  std::string result;
  for (const std::string_view name : names) {
    if (!result.empty()) result += ", ";
    result += name;
  }
  return result;
}

std::size_t edit_distance(std::string_view a, std::string_view b) {
  std::vector<std::size_t> before_previous(b.size() + 1);
  std::vector<std::size_t> previous(b.size() + 1);
  std::vector<std::size_t> current(b.size() + 1);
  for (std::size_t column = 0; column <= b.size(); ++column) previous[column] = column;
  for (std::size_t row = 1; row <= a.size(); ++row) {
    current[0] = row;
    for (std::size_t column = 1; column <= b.size(); ++column) {
      const std::size_t replaced = previous[column - 1] + (a[row - 1] == b[column - 1] ? 0U : 1U);
      current[column] = std::min({previous[column] + 1, current[column - 1] + 1, replaced});
      if (row > 1 && column > 1 && a[row - 1] == b[column - 2] && a[row - 2] == b[column - 1]) {
        current[column] = std::min(current[column], before_previous[column - 2] + 1);
      }
    }
    before_previous.swap(previous);
    previous.swap(current);
  }
  return previous[b.size()];
}

std::optional<std::string_view> nearest_name(std::string_view wrong,
                                             const std::vector<std::string_view>& allowed) {
  constexpr std::size_t longest = 64;
  if (wrong.size() > longest) return std::nullopt;
  std::optional<std::string_view> nearest;
  std::size_t least = std::max<std::size_t>(1, wrong.size() / 3) + 1;
  for (const std::string_view name : allowed) {
    if (name.size() > longest) continue;
    const std::size_t distance = edit_distance(wrong, name);
    if (distance < least && distance < name.size()) {
      least = distance;
      nearest = name;
    }
  }
  return nearest;
}

std::string unknown_name(std::string_view kind, std::string_view wrong,
                         const std::vector<std::string_view>& allowed) {
  std::string message = "unknown " + std::string(kind) + " " + in_quotes(wrong);
  if (const auto nearest = nearest_name(wrong, allowed)) {
    message += " (did you mean " + in_quotes(*nearest) + "?)";
  }
  return message;
}

}  // namespace nearfield::host
