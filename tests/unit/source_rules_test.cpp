// Rules that the sources keep: what may include what, what the firmware may not name, what lies where.
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <regex>
#include <set>
#include <sstream>
#include <string>
#include <vector>

namespace nearfield {
namespace {

namespace fs = std::filesystem;

const fs::path root = NEARFIELD_SOURCE_DIR;

// Lowest first. A header includes its own floor and those below.
constexpr std::array<const char*, 8> floors = {"number", "table",  "curve", "shape",
                                               "blend",  "modify", "field", "query"};

std::string text_of(const fs::path& file) {
  std::ifstream stream(file, std::ios::binary);
  return {std::istreambuf_iterator<char>(stream), {}};
}

std::vector<std::string> lines_of(const std::string& text) {
  std::vector<std::string> lines;
  std::istringstream stream(text);
  for (std::string line; std::getline(stream, line);) lines.push_back(line);
  return lines;
}

std::vector<fs::path> files_below(const fs::path& folder) {
  std::vector<fs::path> files;
  for (const fs::directory_entry& entry : fs::recursive_directory_iterator(folder)) {
    if (entry.is_regular_file()) files.push_back(entry.path());
  }
  std::sort(files.begin(), files.end());
  return files;
}

// What a line includes, with its brackets or quotes; empty if it is no #include.
std::string included_by(const std::string& line) {
  static const std::regex include("^\\s*#\\s*include\\s*(.*?)\\s*(//.*|/\\*.*)?$");
  std::smatch match;
  return std::regex_match(line, match, include) ? match[1].str() : "";
}

// Place of a path like `shape/box.hpp` in `floors`; above all of them for a header that lies in no floor.
std::size_t floor_of(const std::string& path) {
  const std::string folder = path.substr(0, path.find('/'));
  return static_cast<std::size_t>(std::find(floors.begin(), floors.end(), folder) - floors.begin());
}

// What is wrong with an #include in a header (its path relative to include/nearfield) or, with an empty path,
// in a source file; empty if nothing is.
std::string fault_of_include(const std::string& header, const std::string& included) {
  if (included == "<stdint.h>" || included == "<stddef.h>") return "";
  if (included.size() > 2 && included.front() == '"' && included.back() == '"') {
    return included.find("..") == std::string::npos ? "" : "leaves its folder";
  }
  const std::string own = "<nearfield/";
  if (included.compare(0, own.size(), own) != 0) return "is no header of the firmware core";
  const std::string target = included.substr(own.size(), included.size() - own.size() - 1);
  if (!fs::is_regular_file(root / "firmware_core/include/nearfield" / target)) return "does not exist";
  if (!header.empty() && floor_of(target) > floor_of(header)) return "lies on a floor above";
  return "";
}

// Text without comments and without what is in quotes.
std::string code_of(const std::string& text) {
  static const std::regex no_code(R"(//[^\n]*|/\*[^*]*\*+(?:[^/*][^*]*\*+)*/|"(?:[^"\\\n]|\\.)*")");
  return std::regex_replace(text, no_code, " ");
}

TEST(SourceRules, FirmwareIncludesOnlyItselfAndTwoHeadersOfC) {
  const fs::path headers = root / "firmware_core/include/nearfield";
  std::size_t seen = 0;
  for (const fs::path& file : files_below(root / "firmware_core")) {
    if (file.filename() == "CMakeLists.txt") continue;
    const bool is_header = file.string().compare(0, headers.string().size(), headers.string()) == 0;
    const std::string header = is_header ? file.lexically_relative(headers).generic_string() : "";
    std::size_t number = 0;
    for (const std::string& line : lines_of(text_of(file))) {
      ++number;
      const std::string included = included_by(line);
      if (included.empty()) continue;
      ++seen;
      const std::string fault = fault_of_include(header, included);
      EXPECT_EQ(fault, "") << file.string() << ":" << number << ": " << included << " " << fault;
    }
  }
  EXPECT_GT(seen, 50U);
}

TEST(SourceRules, FaultyIncludesAreSeen) {
  EXPECT_EQ(included_by("  #  include <cmath>  // sqrt"), "<cmath>");
  EXPECT_EQ(included_by("// #include <cmath>"), "");
  EXPECT_NE(fault_of_include("shape/box.hpp", "<cmath>"), "");
  EXPECT_NE(fault_of_include("shape/box.hpp", "<nearfield/query/clearance.hpp>"), "");
  EXPECT_NE(fault_of_include("shape/box.hpp", "<nearfield/nearfield.hpp>"), "");
  EXPECT_NE(fault_of_include("shape/box.hpp", "<nearfield/number/absent.hpp>"), "");
  EXPECT_NE(fault_of_include("shape/box.hpp", "\"../query/clearance.hpp\""), "");
  EXPECT_EQ(fault_of_include("query/clearance.hpp", "<nearfield/shape/box.hpp>"), "");
  EXPECT_EQ(fault_of_include("nearfield.hpp", "<nearfield/query/clearance.hpp>"), "");
}

TEST(SourceRules, EveryHeaderHasAFloor) {
  const fs::path headers = root / "firmware_core/include/nearfield";
  for (const fs::path& file : files_below(root / "firmware_core/include")) {
    const std::string path = file.lexically_relative(headers).generic_string();
    if (path == "nearfield.hpp" || path == "nearfield.h") continue;
    EXPECT_LT(floor_of(path), floors.size()) << path;
  }
}

TEST(SourceRules, CompiledFirmwareSourcesKnowNoDouble) {
  const std::regex number_type(R"(\b(double|long\s+double)\b)");
  std::size_t seen = 0;
  for (const fs::path& file : files_below(root / "firmware_core/src")) {
    ++seen;
    EXPECT_FALSE(std::regex_search(code_of(text_of(file)), number_type)) << file;
  }
  EXPECT_GT(seen, 0U);
  EXPECT_TRUE(std::regex_search(code_of("f(double /* x */)"), number_type));
  EXPECT_FALSE(std::regex_search(code_of("int x;  // no double\n/* double */ \"double\""), number_type));
}

TEST(SourceRules, FoldersOfTheRoot) {
  const std::set<std::string> allowed = {
      "firmware_core", "host_sim", "ports", "tests",
      "toolchains",    "build",    "out"};  // the last two are not part of the sources
  for (const fs::directory_entry& entry : fs::directory_iterator(root)) {
    const std::string name = entry.path().filename().string();
    if (!entry.is_directory() || name.front() == '.') continue;
    EXPECT_EQ(allowed.count(name), 1U) << name;
  }
}

// Written in two parts each, so that this file does not hold them.
const std::vector<std::string> machine_paths = {
    "/ho"
    "me/",
    "/ro"
    "ot/",
    "/wo"
    "rk/",
    "/us"
    "r/local",
    "/op"
    "t/",
    "/mn"
    "t/",
    "C:"
    "\\"};

// The first web address whose host is none of those that sources may name (a licence, the namespaces of
// formats, papers); empty if there is none.
std::string foreign_address(const std::string& text) {
  static const std::regex address(
      "[a-z]+:"
      "//([A-Za-z0-9.-]+)[^\\s\"'<>)]*");
  const std::set<std::string> allowed = {"www.apache.org", "www.w3.org", "doi.org"};
  for (std::sregex_iterator match(text.begin(), text.end(), address), end; match != end; ++match) {
    if (allowed.count((*match)[1].str()) == 0) return match->str();
  }
  return "";
}

TEST(SourceRules, NoMachinePathsAndNoForeignAddresses) {
  EXPECT_NE(foreign_address("see https:"
                            "//packages.example.org/x"),
            "");
  EXPECT_EQ(foreign_address("http:"
                            "//www.w3.org/2000/svg"),
            "");
  std::size_t seen = 0;
  for (const fs::directory_entry& top : fs::directory_iterator(root)) {
    const std::string name = top.path().filename().string();
    if (name == "build" || name == "out" || name == ".git") continue;
    const std::vector<fs::path> files =
        top.is_directory() ? files_below(top.path()) : std::vector<fs::path>{top.path()};
    for (const fs::path& file : files) {
      ++seen;
      const std::string text = text_of(file);
      for (const std::string& path : machine_paths) {
        EXPECT_EQ(text.find(path), std::string::npos) << file << " names a place on some machine: " << path;
      }
      EXPECT_EQ(foreign_address(text), "") << file;
    }
  }
  EXPECT_GT(seen, 100U);
}

}  // namespace
}  // namespace nearfield
