#pragma once

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

#include "text/source_position.hpp"

namespace nearfield::host {

struct XmlAttribute {
  std::string name;
  std::string value;  // references replaced, line ends and tabs as spaces
  SourcePosition position;
};

struct XmlElement {
  std::string name;
  SourcePosition position;  // of its `<`
  std::vector<XmlAttribute> attributes;
  std::vector<XmlElement> children;
  std::string text;  // all character data directly inside, references replaced

  // The attribute of that name, or null.
  const XmlAttribute* find_attribute(std::string_view attribute) const;
};

struct XmlDocument {
  std::string file;  // as named in errors
  XmlElement root;
};

inline constexpr std::size_t deepest_xml = 64;            // nested elements
inline constexpr std::size_t most_xml_elements = 500000;  // in one document
inline constexpr std::size_t most_xml_attributes = 256;   // of one element

// Reads the XML that robot descriptions use: an optional declaration (UTF-8), one root element, elements,
// attributes, comments, character data, the five named references and numeric ones. Anything else (DOCTYPE,
// CDATA, processing instructions) and everything that is not well-formed is an InputError with its position,
// as are documents beyond the limits above. A comment may contain "--", which XML forbids and writers use.
XmlDocument parse_xml(std::string_view text, const std::string& file);

}  // namespace nearfield::host
