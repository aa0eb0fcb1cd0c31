#include "text/xml.hpp"

#include <algorithm>
#include <cstdint>
#include <optional>
#include <utility>

#include "text/input_error.hpp"
#include "text/names.hpp"
#include "text/utf8.hpp"

namespace nearfield::host {
namespace {

bool is_white_space(char character) {
  return character == ' ' || character == '\t' || character == '\n' || character == '\r';
}

bool starts_name(char character) {
  return (character >= 'a' && character <= 'z') || (character >= 'A' && character <= 'Z') ||
         character == '_' || character == ':' || static_cast<unsigned char>(character) >= 0x80U;
}

bool continues_name(char character) {
  return starts_name(character) || (character >= '0' && character <= '9') || character == '-' ||
         character == '.';
}

bool is_xml_character(std::uint32_t code) {
  return code == 0x9U || code == 0xaU || code == 0xdU || (code >= 0x20U && code <= 0xd7ffU) ||
         (code >= 0xe000U && code <= 0xfffdU) || (code >= 0x10000U && code <= 0x10ffffU);
}

bool equal_ignoring_case(std::string_view a, std::string_view b) {
  const auto lower = [](char character) {
    return character >= 'A' && character <= 'Z' ? static_cast<char>(character - 'A' + 'a') : character;
  };
  return a.size() == b.size() &&
         std::equal(a.begin(), a.end(), b.begin(), [lower](char x, char y) { return lower(x) == lower(y); });
}

class XmlParser {
 public:
  XmlParser(std::string_view text, const std::string& file) : text_(text), file_(file) {}

  XmlElement parse() {
    check_characters();
    if (starts("\xef\xbb\xbf")) offset_ += 3;
    if (starts("<?xml") && offset_ + 5 < text_.size() && is_white_space(text_[offset_ + 5])) {
      parse_declaration();
    }
    skip_between_elements();
    if (at_end()) fail("no element", "one root element");
    if (text_[offset_] != '<') fail("text before the root element", "one root element");
    XmlElement root = parse_element();
    skip_between_elements();
    if (!at_end()) fail("content after the root element", "one root element and nothing else");
    return root;
  }

 private:
  [[noreturn]] void fail(const std::string& message, const std::string& allowed) const {
    fail_at(here_, message, allowed);
  }

  [[noreturn]] void fail_at(SourcePosition position, const std::string& message,
                            const std::string& allowed) const {
    throw InputError(file_, position, path_, message, allowed);
  }

  void check_characters() {
    std::optional<std::size_t> wrong = first_invalid_utf8(text_);
    if (wrong) {
      here_ = position_at(text_, *wrong);
      fail("bytes that are not UTF-8", "the file must be UTF-8");
    }
    for (std::size_t offset = 0; offset < text_.size(); ++offset) {
      const auto byte = static_cast<unsigned char>(text_[offset]);
      if (byte < 0x20U && !is_xml_character(byte)) {
        here_ = position_at(text_, offset);
        fail("control character", "text, tabs and line ends");
      }
    }
  }

  bool at_end() const { return offset_ >= text_.size(); }
  bool starts(std::string_view prefix) const { return text_.substr(offset_, prefix.size()) == prefix; }

  char take() {
    const char byte = text_[offset_++];
    advance(here_, byte);
    return byte;
  }

  void take(std::size_t count) {
    for (std::size_t index = 0; index < count; ++index) take();
  }

  void skip_white_space() {
    while (!at_end() && is_white_space(text_[offset_])) take();
  }

  void skip_comment() {
    const std::size_t end = text_.find("-->", offset_ + 4);
    if (end == std::string_view::npos) fail("comment without an end", "a closing \"-->\"");
    take(end + 3 - offset_);
  }

  void skip_between_elements() {
    while (true) {
      skip_white_space();
      if (!starts("<!--")) return;
      skip_comment();
    }
  }

  void parse_declaration() {
    const SourcePosition start = here_;
    take(5);
    XmlElement declaration;
    parse_attributes(declaration);
    if (!starts("?>")) fail("XML declaration without an end", "a closing \"?>\"");
    take(2);
    const XmlAttribute* version = declaration.find_attribute("version");
    if (version == nullptr) fail_at(start, "XML declaration without a version", "version=\"1.0\"");
    if (version->value != "1.0" && version->value != "1.1") {
      fail_at(version->position, "XML version " + in_quotes(version->value), "version 1.0 or 1.1");
    }
    const XmlAttribute* encoding = declaration.find_attribute("encoding");
    if (encoding != nullptr && !equal_ignoring_case(encoding->value, "utf-8") &&
        !equal_ignoring_case(encoding->value, "us-ascii")) {
      fail_at(encoding->position, "encoding " + in_quotes(encoding->value), "UTF-8");
    }
  }

  std::string parse_name(const std::string& what) {
    if (at_end()) fail("the text ends too early", what);
    if (!starts_name(text_[offset_])) {
      const std::string_view rest = text_.substr(offset_);
      fail("unexpected " + in_quotes(rest.substr(0, utf8_length(rest))), what);
    }
    const std::size_t begin = offset_;
    while (!at_end() && continues_name(text_[offset_])) take();
    return std::string(text_.substr(begin, offset_ - begin));
  }

  void parse_attributes(XmlElement& element) {
    while (true) {
      const bool separated = !at_end() && is_white_space(text_[offset_]);
      skip_white_space();
      if (at_end()) fail("the text ends inside a tag", "a closing \">\"");
      const char next = text_[offset_];
      if (next == '>' || next == '/' || next == '?') return;
      if (!separated) fail("no space before an attribute", "white space between attributes");
      if (element.attributes.size() == most_xml_attributes) {
        fail("too many attributes", "at most " + std::to_string(most_xml_attributes));
      }
      XmlAttribute attribute;
      attribute.position = here_;
      attribute.name = parse_name("an attribute's name, \">\" or \"/>\"");
      if (element.find_attribute(attribute.name) != nullptr) {
        fail_at(attribute.position, "attribute " + in_quotes(attribute.name) + " is there twice",
                "each attribute once");
      }
      skip_white_space();
      if (!starts("=")) fail("attribute " + in_quotes(attribute.name) + " without a value", "name=\"value\"");
      take();
      skip_white_space();
      parse_attribute_value(attribute);
      element.attributes.push_back(std::move(attribute));
    }
  }

  void parse_attribute_value(XmlAttribute& attribute) {
    if (!starts("\"") && !starts("'")) fail("attribute value without quotation marks", "name=\"value\"");
    const SourcePosition start = here_;
    const char quotation_mark = take();
    while (true) {
      if (at_end()) fail_at(start, "attribute value without an end", "a closing quotation mark");
      const char next = text_[offset_];
      if (next == quotation_mark) break;
      if (next == '<') fail("\"<\" in an attribute value", "&lt;");
      if (next == '&') {
        parse_reference(attribute.value);
      } else {
        const char character = take();
        attribute.value += is_white_space(character) ? ' ' : character;
      }
    }
    take();
  }

  void parse_reference(std::string& text) {
    const SourcePosition start = here_;
    const std::string allowed = "&lt; &gt; &amp; &quot; &apos; or a number such as &#233; or &#xe9;";
    constexpr std::size_t longest = 10;
    const std::size_t end = text_.substr(0, std::min(text_.size(), offset_ + longest + 1)).find(';', offset_);
    if (end == std::string_view::npos) fail("\"&\" that starts no reference", allowed);
    const std::string_view name = text_.substr(offset_ + 1, end - offset_ - 1);
    if (name == "lt") {
      text += '<';
    } else if (name == "gt") {
      text += '>';
    } else if (name == "amp") {
      text += '&';
    } else if (name == "quot") {
      text += '"';
    } else if (name == "apos") {
      text += '\'';
    } else {
      const std::optional<std::uint32_t> code = numeric_reference(name);
      if (!code) {
        fail_at(start, "unknown reference " + in_quotes(text_.substr(offset_, end + 1 - offset_)), allowed);
      }
      append_utf8(text, *code);
    }
    take(end + 1 - offset_);
  }

  static std::optional<std::uint32_t> numeric_reference(std::string_view name) {
    if (name.size() < 2 || name[0] != '#') return std::nullopt;
    const bool hexadecimal = name[1] == 'x';
    const std::string_view digits = name.substr(hexadecimal ? 2 : 1);
    if (digits.empty() || digits.size() > 7) return std::nullopt;
    std::uint32_t code = 0;
    for (const char digit : digits) {
      std::uint32_t digit_value = 0;
      if (digit >= '0' && digit <= '9') {
        digit_value = static_cast<std::uint32_t>(digit - '0');
      } else if (hexadecimal && digit >= 'a' && digit <= 'f') {
        digit_value = static_cast<std::uint32_t>(digit - 'a' + 10);
      } else if (hexadecimal && digit >= 'A' && digit <= 'F') {
        digit_value = static_cast<std::uint32_t>(digit - 'A' + 10);
      } else {
        return std::nullopt;
      }
      code = code * (hexadecimal ? 16U : 10U) + digit_value;
    }
    if (!is_xml_character(code)) return std::nullopt;
    return code;
  }

  XmlElement parse_element() {
    if (starts("<!DOCTYPE")) fail("DOCTYPE", "elements and comments only");
    if (starts("<![CDATA[")) fail("CDATA section", "elements, comments and text");
    if (starts("<!")) fail("unknown declaration", "elements and comments only");
    if (starts("<?")) fail("processing instruction", "an XML declaration at the very start only");
    if (++depth_ > deepest_xml) {
      fail("nested too deeply", "at most " + std::to_string(deepest_xml) + " levels");
    }
    if (++element_count_ > most_xml_elements) {
      fail("too many elements", "at most " + std::to_string(most_xml_elements));
    }
    XmlElement element;
    element.position = here_;
    take();
    element.name = parse_name("an element's name after \"<\"");
    const std::size_t path_size = path_.size();
    if (path_size != 0) path_ += '/';
    path_ += element.name;
    parse_attributes(element);
    if (const XmlAttribute* name = element.find_attribute("name")) path_ += "[" + name->value + "]";
    const bool empty = starts("/>");
    if (!empty && !starts(">")) fail("unexpected " + in_quotes(text_.substr(offset_, 1)), "\">\" or \"/>\"");
    take(empty ? 2 : 1);
    if (!empty) parse_content(element);
    path_.resize(path_size);
    --depth_;
    return element;
  }

  void parse_content(XmlElement& element) {
    while (true) {
      if (at_end()) {
        fail_at(element.position, "element " + in_quotes(element.name) + " without an end",
                "a closing </" + element.name + ">");
      }
      if (starts("</")) break;
      if (starts("<!--")) {
        skip_comment();
      } else if (starts("<")) {
        element.children.push_back(parse_element());
      } else if (starts("&")) {
        parse_reference(element.text);
      } else {
        element.text += take();
      }
    }
    const SourcePosition start = here_;
    take(2);
    const std::string name = parse_name("an element's name after \"</\"");
    if (name != element.name) {
      fail_at(start, "</" + name + "> closes <" + element.name + ">",
              "</" + element.name + ">, opened at line " + std::to_string(element.position.line));
    }
    skip_white_space();
    if (!starts(">")) fail("closing tag without an end", "\">\"");
    take();
  }

  std::string_view text_;
  const std::string& file_;
  std::size_t offset_ = 0;
  SourcePosition here_{1, 1};
  std::string path_;
  std::size_t depth_ = 0;
  std::size_t element_count_ = 0;
};

}  // namespace

const XmlAttribute* XmlElement::find_attribute(std::string_view attribute) const {
  for (const XmlAttribute& candidate : attributes) {
    if (candidate.name == attribute) return &candidate;
  }
  return nullptr;
}

XmlDocument parse_xml(std::string_view text, const std::string& file) {
  return XmlDocument{file, XmlParser(text, file).parse()};
}

}  // namespace nearfield::host
