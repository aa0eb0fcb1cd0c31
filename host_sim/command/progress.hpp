#pragma once

#include <string>

namespace nearfield::host {

// A progress bar on standard error if that is a terminal; nothing otherwise.
class Progress {
 public:
  explicit Progress(std::string what);
  ~Progress();
  Progress(const Progress&) = delete;
  Progress& operator=(const Progress&) = delete;

  // `done` from 0 to 1.
  void report(double done);

 private:
  void clear();

  std::string what_;
  bool on_terminal_;
  int shown_ = -1;  // percent
};

}  // namespace nearfield::host
