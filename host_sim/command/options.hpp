// Options of the command line: --name VALUE, --name=VALUE, and flags; for some verbs one operand, a word
// without dashes.
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
  bool repeatable = false;  // may be given several times, each time with a value of its own
};

enum class Operand { none, one };

class Options {
 public:
  // UsageError for anything that is not described, given twice without being repeatable, or lacks its value,
  // and for more operands than there may be.
  Options(const std::vector<OptionDescription>& descriptions, const std::vector<std::string>& arguments,
          Operand allowed = Operand::none);

  bool has(const std::string& name) const { return values_.count(name) != 0; }
  // Of a repeatable option the last one.
  std::optional<std::string> value(const std::string& name) const;
  // All values of an option, in the order given.
  std::vector<std::string> values(const std::string& name) const;
  // UsageError if it was not given.
  std::string required(const std::string& name) const;
  const std::optional<std::string>& operand() const { return operand_; }
  // Takes the operand for a file's name relative to `folder`. Nothing happens without an operand.
  void look_for_operand_in(const std::string& folder);

 private:
  std::map<std::string, std::vector<std::string>> values_;
  std::optional<std::string> operand_;
};

std::string describe(const std::vector<OptionDescription>& descriptions);

}  // namespace nearfield::host
