#include "model/points.hpp"

#include <array>

#include "text/input_error.hpp"
#include "text/names.hpp"
#include "text/number.hpp"
#include "text/read_file.hpp"
#include "text/utf8.hpp"

namespace nearfield::host {
namespace {

constexpr std::string_view blanks = " \t\r";
constexpr std::array<const char*, 3> coordinates = {"x", "y", "z"};
const char* const expected = "three numbers in m: X,Y,Z";

// Without blanks at both ends; where it is nothing but those, empty at its end.
std::string_view trimmed(std::string_view text) {
  const std::size_t first = text.find_first_not_of(blanks);
  if (first == std::string_view::npos) return text.substr(text.size());
  return text.substr(first, text.find_last_not_of(blanks) - first + 1);
}

class Line {
 public:
  Line(std::string_view text, const std::string& file, std::size_t number)
      : text_(text), file_(file), number_(number) {}

  // The values between commas, trimmed.
  std::vector<std::string_view> values() const {
    std::vector<std::string_view> all;
    std::size_t from = 0;
    for (std::size_t comma = text_.find(','); comma != std::string_view::npos;
         comma = text_.find(',', from)) {
      all.push_back(trimmed(text_.substr(from, comma - from)));
      from = comma + 1;
    }
    all.push_back(trimmed(text_.substr(from)));
    return all;
  }
  // `at` points into the line.
  [[noreturn]] void fail(const char* at, const std::string& path, const std::string& message) const {
    const SourcePosition in_line = position_at(text_, static_cast<std::size_t>(at - text_.data()));
    throw InputError(file_, {number_, in_line.column}, path, message, expected);
  }

 private:
  std::string_view text_;
  const std::string& file_;
  std::size_t number_;
};

Vector3d point_of(const Line& line) {
  const std::vector<std::string_view> values = line.values();
  std::array<double, 3> numbers{};
  for (std::size_t i = 0; i < numbers.size(); ++i) {
    if (i == values.size()) line.fail(values.back().data() + values.back().size(), coordinates[i], "missing");
    const auto number = parse_number(values[i]);
    if (!number) line.fail(values[i].data(), coordinates[i], in_quotes(values[i]) + " is not a number");
    numbers[i] = *number;
  }
  if (values.size() > numbers.size()) {
    line.fail(values[numbers.size()].data(), "", std::to_string(values.size()) + " values");
  }
  return {numbers[0], numbers[1], numbers[2]};
}

bool is_header(const Line& line) {
  const std::vector<std::string_view> values = line.values();
  return values.size() == 3 && values[0] == "x" && values[1] == "y" && values[2] == "z";
}

}  // namespace

std::vector<Vector3d> parse_points(std::string_view text, const std::string& file) {
  if (text.substr(0, 3) == "\xef\xbb\xbf") throw InputError(file, {1, 1}, "", "byte order mark", "UTF-8 without one");
  if (const auto invalid = first_invalid_utf8(text)) {
    throw InputError(file, position_at(text, *invalid), "", "bytes that are not UTF-8", "the file must be UTF-8");
  }
  std::vector<Vector3d> points;
  std::size_t number = 0;
  bool header_may_come = true;
  while (!text.empty()) {
    ++number;
    const std::size_t end = text.find('\n');
    const std::string_view line_text = text.substr(0, end);
    text = end == std::string_view::npos ? std::string_view{} : text.substr(end + 1);
    if (trimmed(line_text).empty()) continue;
    const Line line(line_text, file, number);
    if (!(header_may_come && is_header(line))) points.push_back(point_of(line));
    header_may_come = false;
  }
  if (points.empty()) throw InputError(file, {}, "", "no points", expected);
  return points;
}

std::vector<Vector3d> read_points(const std::string& path) { return parse_points(read_file(path), path); }

}  // namespace nearfield::host
