#include "text/xml_node.hpp"

#include <algorithm>

#include "text/input_error.hpp"
#include "text/names.hpp"

namespace nearfield::host {
namespace {

bool is_white_space(char character) {
  return character == ' ' || character == '\t' || character == '\n' || character == '\r';
}

std::vector<std::string_view> words(std::string_view text) {
  std::vector<std::string_view> result;
  std::size_t offset = 0;
  while (offset < text.size()) {
    if (is_white_space(text[offset])) {
      ++offset;
      continue;
    }
    const std::size_t begin = offset;
    while (offset < text.size() && !is_white_space(text[offset])) ++offset;
    result.push_back(text.substr(begin, offset - begin));
  }
  return result;
}

// Robot descriptions also write a leading plus.
std::optional<double> parse_signed_number(std::string_view word) {
  if (word.size() > 1 && word[0] == '+' && word[1] != '-') word.remove_prefix(1);
  return parse_number(word);
}

}  // namespace

XmlNode::XmlNode(const XmlDocument& document)
    : element_(&document.root), file_(&document.file), path_(document.root.name) {}

void XmlNode::fail(const std::string& message, const std::string& allowed) const {
  throw InputError(*file_, element_->position, path_, message, allowed);
}

void XmlNode::fail_attribute(std::string_view attribute, const std::string& message,
                             const std::string& allowed) const {
  const XmlAttribute* found = element_->find_attribute(attribute);
  throw InputError(*file_, found == nullptr ? element_->position : found->position,
                   path_ + "@" + std::string(attribute), message, allowed);
}

std::vector<XmlNode> XmlNode::children() const {
  std::vector<XmlNode> result;
  for (const XmlElement& child : element_->children) {
    result.push_back(XmlNode(child, *file_, path_ + "/" + child.name));
  }
  return result;
}

std::optional<XmlNode> XmlNode::optional_child(std::string_view name) const {
  std::optional<XmlNode> result;
  for (const XmlElement& child : element_->children) {
    if (child.name != name) continue;
    XmlNode node(child, *file_, path_ + "/" + child.name);
    if (result) node.fail("a second element " + in_quotes(name), "at most one");
    result = std::move(node);
  }
  return result;
}

XmlNode XmlNode::required_child(std::string_view name) const {
  std::optional<XmlNode> child = optional_child(name);
  if (!child) fail("element " + in_quotes(name) + " is missing", "exactly one is required");
  return *child;
}

XmlNode XmlNode::labelled(std::string_view label) const {
  return XmlNode(*element_, *file_, path_ + "[" + std::string(label) + "]");
}

bool XmlNode::has_attribute(std::string_view name) const noexcept {
  return element_->find_attribute(name) != nullptr;
}

std::string XmlNode::text(std::string_view attribute) const {
  const XmlAttribute* found = element_->find_attribute(attribute);
  if (found == nullptr) fail_attribute(attribute, "missing", "this attribute is required");
  if (found->value.empty()) fail_attribute(attribute, "empty", "a name or text");
  const bool has_control_characters =
      std::any_of(found->value.begin(), found->value.end(),
                  [](char character) { return static_cast<unsigned char>(character) < 0x20U; });
  if (has_control_characters) fail_attribute(attribute, "control character", "a name or text");
  return found->value;
}

std::vector<double> XmlNode::numbers(std::string_view attribute, std::size_t count,
                                     const NumberRange& range) const {
  const std::string wanted = count == 1 ? "a number " : std::to_string(count) + " numbers ";
  const std::string allowed = wanted + describe(range);
  const XmlAttribute* found = element_->find_attribute(attribute);
  if (found == nullptr) fail_attribute(attribute, "missing", "required: " + allowed);
  const std::vector<std::string_view> parts = words(found->value);
  std::vector<double> result;
  for (const std::string_view part : parts) {
    const std::optional<double> number = parse_signed_number(part);
    if (!number) fail_attribute(attribute, in_quotes(part) + " is not a finite decimal number", allowed);
    if (!contains(range, *number)) {
      fail_attribute(attribute, format_number(*number) + " is out of range", allowed);
    }
    result.push_back(*number);
  }
  if (result.size() != count) {
    fail_attribute(attribute, std::to_string(result.size()) + " numbers", allowed);
  }
  return result;
}

double XmlNode::number(std::string_view attribute, const NumberRange& range) const {
  return numbers(attribute, 1, range).front();
}

std::optional<double> XmlNode::optional_number(std::string_view attribute, const NumberRange& range) const {
  if (!has_attribute(attribute)) return std::nullopt;
  return number(attribute, range);
}

void XmlNode::reject_unknown_attributes(const std::vector<std::string_view>& allowed) const {
  for (const XmlAttribute& attribute : element_->attributes) {
    if (attribute.name == "xmlns" || attribute.name.rfind("xmlns:", 0) == 0) continue;
    if (std::find(allowed.begin(), allowed.end(), attribute.name) != allowed.end()) continue;
    fail_attribute(attribute.name, unknown_name("attribute", attribute.name, allowed),
                   allowed.empty() ? "no attributes" : "allowed attributes: " + joined(allowed));
  }
}

void XmlNode::reject_unknown_children(const std::vector<std::string_view>& allowed) const {
  for (const XmlNode& child : children()) {
    if (std::find(allowed.begin(), allowed.end(), child.name()) != allowed.end()) continue;
    child.fail(unknown_name("element", child.name(), allowed),
               allowed.empty() ? "no elements" : "allowed elements: " + joined(allowed));
  }
}

}  // namespace nearfield::host
