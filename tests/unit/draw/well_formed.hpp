#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

namespace nearfield::host::draw {

/// What is wrong with an XML document, or "" when its tags nest, its attributes are quoted and unique and its
/// text is escaped. Knows as much of XML as pictures use.
inline std::string xml_fault(const std::string& xml) {
  std::vector<std::string> open;
  std::size_t at = xml.find("?>");
  if (xml.compare(0, 5, "<?xml") != 0 || at == std::string::npos) return "no declaration";
  at += 2;
  bool had_root = false;
  while (at < xml.size()) {
    const char c = xml[at];
    if (c == '&') {
      const std::size_t end = xml.find(';', at);
      if (end == std::string::npos || end - at > 7) return "bare ampersand";
      at = end + 1;
    } else if (c == '>') {
      return "bare >";
    } else if (c != '<') {
      if (open.empty() && c != '\n') return "text outside the root";
      ++at;
    } else if (xml[at + 1] == '/') {
      const std::size_t end = xml.find('>', at);
      if (end == std::string::npos || open.empty() || open.back() != xml.substr(at + 2, end - at - 2)) {
        return "closing tag does not match";
      }
      open.pop_back();
      at = end + 1;
    } else {
      if (open.empty() && had_root) return "two roots";
      had_root = true;
      std::size_t end = xml.find_first_of(" />", at);
      if (end == std::string::npos) return "tag without end";
      open.push_back(xml.substr(at + 1, end - at - 1));
      at = end;
      std::vector<std::string> names;
      while (at < xml.size() && xml[at] == ' ') {
        const std::size_t equals = xml.find('=', at);
        if (equals == std::string::npos || xml[equals + 1] != '"') return "attribute without quotes";
        const std::string name = xml.substr(at + 1, equals - at - 1);
        for (const std::string& earlier : names) {
          if (earlier == name) return "attribute twice: " + name;
        }
        names.push_back(name);
        const std::size_t close = xml.find('"', equals + 2);
        if (close == std::string::npos) return "quote without end";
        if (xml.substr(equals + 2, close - equals - 2).find('<') != std::string::npos)
          return "< in an attribute";
        at = close + 1;
      }
      if (xml.compare(at, 2, "/>") == 0) {
        open.pop_back();
        at += 2;
      } else if (xml.compare(at, 1, ">") == 0) {
        ++at;
      } else {
        return "tag is malformed";
      }
    }
  }
  if (!open.empty()) return "not closed: " + open.back();
  return had_root ? "" : "no root";
}

inline std::size_t occurrences(const std::string& text, const std::string& part) {
  std::size_t count = 0;
  for (std::size_t at = text.find(part); at != std::string::npos; at = text.find(part, at + 1)) ++count;
  return count;
}

/// FNV-1a.
inline std::uint64_t digest(const std::string& text) {
  std::uint64_t hash = 14695981039346656037u;
  for (const char c : text) hash = (hash ^ static_cast<unsigned char>(c)) * 1099511628211u;
  return hash;
}

}  // namespace nearfield::host::draw
