#pragma once

#include <cstddef>

namespace nearfield::host {

// A place in a text file. Lines and columns count from 1, columns in Unicode code points; 0 means unknown.
struct SourcePosition {
  std::size_t line = 0;
  std::size_t column = 0;
};

}  // namespace nearfield::host
