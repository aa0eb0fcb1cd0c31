#include "command/progress.hpp"

#include <unistd.h>

#include <cstdio>
#include <utility>

namespace nearfield::host {

Progress::Progress(std::string what) : what_(std::move(what)), on_terminal_(isatty(STDERR_FILENO) == 1) {}

Progress::~Progress() { clear(); }

void Progress::report(double done) {
  const int percent = static_cast<int>(100.0 * done);
  if (!on_terminal_ || percent == shown_) return;
  shown_ = percent;
  constexpr int width = 40;
  const int full = width * percent / 100;
  const std::string bar = std::string(static_cast<std::size_t>(full), '#') +
                          std::string(static_cast<std::size_t>(width - full), '.');
  std::fprintf(stderr, "\r%s [%s] %3d %%", what_.c_str(), bar.c_str(), percent);
  std::fflush(stderr);
}

void Progress::clear() {
  if (shown_ >= 0) std::fprintf(stderr, "\r\033[K");
  shown_ = -1;
}

}  // namespace nearfield::host
