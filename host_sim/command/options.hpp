// Options of the command line: --name VALUE, --name=VALUE, and flags.
#pragma once

#include <map>
#include <optional>
#include <string>
#include <vector>

namespace nearfield::host {

// Something is wrong with how the command was called. what() is one line.
class UsageError : public std::exception {
 public:
  explicit UsageError(std::string message) : message_(std::move(message)) {}
  const char* what() const noexcept override { return message_.c_str(); }

 private:
  std::string message_;
};

struct OptionDescription {
  std::string name;      // without dashes
  std::string argument;  // how the value is called in the help; empty: a flag
  std::string help;
};

class Options {
 public:
  // UsageError for anything that is not described, given twice, or lacks its value.
  Options(const std::vector<OptionDescription>& descriptions, const std::vector<std::string>& arguments);

  bool has(const std::string& name) const { return values_.count(name) != 0; }
  std::optional<std::string> value(const std::string& name) const;
  // UsageError if it was not given.
  std::string required(const std::string& name) const;

 private:
  std::map<std::string, std::string> values_;
};

std::string describe(const std::vector<OptionDescription>& descriptions);

}  // namespace nearfield::host
