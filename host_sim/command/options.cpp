#include "command/options.hpp"

#include <algorithm>
#include <filesystem>

#include "text/names.hpp"

namespace nearfield::host {

Options::Options(const std::vector<OptionDescription>& descriptions,
                 const std::vector<std::string>& arguments, Operand allowed) {
  for (std::size_t i = 0; i < arguments.size(); ++i) {
    const std::string& argument = arguments[i];
    if (argument.rfind("--", 0) != 0) {
      const bool is_operand = allowed == Operand::one && !operand_ && argument.rfind('-', 0) != 0;
      if (!is_operand) throw UsageError("unexpected argument " + in_quotes(argument));
      operand_ = argument;
      continue;
    }
    const std::size_t equals = argument.find('=');
    const std::string name = argument.substr(2, equals == std::string::npos ? equals : equals - 2);
    const auto found = std::find_if(descriptions.begin(), descriptions.end(),
                                    [&name](const OptionDescription& d) { return d.name == name; });
    if (found == descriptions.end()) {
      std::vector<std::string_view> names;
      for (const OptionDescription& d : descriptions) names.push_back(d.name);
      throw UsageError(unknown_name("option", name, names));
    }
    if (values_.count(name) != 0 && !found->repeatable) throw UsageError("--" + name + " is given twice");
    if (found->argument.empty()) {
      if (equals != std::string::npos) throw UsageError("--" + name + " takes no value");
      values_[name].emplace_back();
    } else if (equals != std::string::npos) {
      values_[name].push_back(argument.substr(equals + 1));
    } else if (i + 1 < arguments.size()) {
      values_[name].push_back(arguments[++i]);
    } else {
      throw UsageError("--" + name + " needs a value: " + found->argument);
    }
  }
}

std::optional<std::string> Options::value(const std::string& name) const {
  const auto found = values_.find(name);
  if (found == values_.end()) return std::nullopt;
  return found->second.back();
}

std::vector<std::string> Options::values(const std::string& name) const {
  const auto found = values_.find(name);
  return found == values_.end() ? std::vector<std::string>{} : found->second;
}

std::string Options::required(const std::string& name) const {
  const auto found = values_.find(name);
  if (found == values_.end()) throw UsageError("--" + name + " is required");
  return found->second.back();
}

void Options::look_for_operand_in(const std::string& folder) {
  if (operand_) operand_ = (std::filesystem::path(folder) / *operand_).string();
}

std::string describe(const std::vector<OptionDescription>& descriptions) {
  std::string text;
  for (const OptionDescription& d : descriptions) {
    std::string left = "  --" + d.name + (d.argument.empty() ? "" : " " + d.argument);
    left.resize(std::max<std::size_t>(left.size() + 2, 26), ' ');
    text += left + d.help + "\n";
  }
  return text;
}

}  // namespace nearfield::host
