#pragma once
/// Counts violations of a property over very many cases and keeps the words of the first.

#include <gtest/gtest.h>

#include <sstream>
#include <string>

namespace nearfield::property {

class Failures {
 public:
  /// `describe` writes to a stream; it is called for the first failure alone.
  template <class Describe>
  void check(bool holds, const Describe& describe) {
    if (holds) return;
    if (count_++ == 0) {
      std::ostringstream text;
      text.precision(21);
      describe(text);
      first_ = text.str();
    }
  }
  void expect_none(const std::string& property) const {
    EXPECT_EQ(count_, 0) << property << "; the first case: " << first_;
  }

 private:
  long long count_ = 0;
  std::string first_;
};

}  // namespace nearfield::property
