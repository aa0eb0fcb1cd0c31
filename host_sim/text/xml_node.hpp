#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "text/number.hpp"
#include "text/xml.hpp"

namespace nearfield::host {

// A place in an XML document that knows its path (`robot/link[arm]/collision[0]`, an attribute as
// `.../sphere@radius`), so that every error names file, line, column and path. Points into the document,
// which must outlive it. Functions throw InputError when the document is not what is asked for.
class XmlNode {
 public:
  explicit XmlNode(const XmlDocument& document);
  explicit XmlNode(XmlDocument&&) = delete;

  const std::string& name() const noexcept { return element_->name; }
  SourcePosition position() const noexcept { return element_->position; }
  const std::string& file() const noexcept { return *file_; }
  const std::string& path() const noexcept { return path_; }

  // The children in order.
  std::vector<XmlNode> children() const;
  // The only child of that name; nothing when there is none, an error when there are two.
  std::optional<XmlNode> optional_child(std::string_view name) const;
  XmlNode required_child(std::string_view name) const;
  // The same place, its path ending in `[label]`.
  XmlNode labelled(std::string_view label) const;

  bool has_attribute(std::string_view name) const noexcept;
  // Text of an attribute: not empty, without control characters.
  std::string text(std::string_view attribute) const;
  double number(std::string_view attribute, const NumberRange& range) const;
  std::optional<double> optional_number(std::string_view attribute, const NumberRange& range) const;
  // Exactly `count` numbers separated by white space.
  std::vector<double> numbers(std::string_view attribute, std::size_t count, const NumberRange& range) const;

  // Refuse what is not in the list and name the nearest that is. Attributes `xmlns` and `xmlns:...` are fine.
  void reject_unknown_attributes(const std::vector<std::string_view>& allowed) const;
  void reject_unknown_children(const std::vector<std::string_view>& allowed) const;

  [[noreturn]] void fail(const std::string& message, const std::string& allowed) const;
  [[noreturn]] void fail_attribute(std::string_view attribute, const std::string& message,
                                   const std::string& allowed) const;

 private:
  XmlNode(const XmlElement& element, const std::string& file, std::string path)
      : element_(&element), file_(&file), path_(std::move(path)) {}

  const XmlElement* element_;
  const std::string* file_;
  std::string path_;
};

}  // namespace nearfield::host
