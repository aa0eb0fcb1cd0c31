#pragma once

#include <gtest/gtest.h>

#include <string>
#include <string_view>

#include "text/input_error.hpp"

namespace nearfield::host {

// A text that a reader must refuse, and how the error's line must start: `file:LINE:COLUMN: PATH: what`.
struct Malformed {
  std::string text;
  std::string expected;
};

template <class Read>
void expect_input_error(const Read& read, const Malformed& malformed) {
  try {
    read(malformed.text, "file");
    ADD_FAILURE() << "accepted: " << malformed.text;
  } catch (const InputError& error) {
    const std::string_view line = error.what();
    EXPECT_EQ(line.substr(0, malformed.expected.size()), malformed.expected)
        << "whole line: " << line << "\ninput: " << malformed.text;
    EXPECT_EQ(line.find('\n'), std::string_view::npos) << line;
    EXPECT_FALSE(error.allowed().empty()) << line;
  }
}

// `text` with its only occurrence of `from` replaced.
inline std::string with(std::string text, std::string_view from, std::string_view to) {
  const std::size_t offset = text.find(from);
  if (offset == std::string::npos) {
    ADD_FAILURE() << "nothing to replace: " << from;
    return text;
  }
  EXPECT_EQ(text.find(from, offset + 1), std::string::npos) << "more than one: " << from;
  return text.replace(offset, from.size(), to);
}

}  // namespace nearfield::host
