#include "draw/stroke_font.hpp"

#include <algorithm>
#include <string_view>

#include "draw/text_code_points.hpp"

namespace nearfield::host::draw {
namespace {

constexpr double cap_height = 0.70;   // of the size
constexpr int baseline = 2, cap = 8;  // of the grid in which glyphs are drawn
constexpr double gap = 1.7;           // between glyphs, grid units
constexpr double space = 3.0;         // width of one, grid units

struct Glyph {
  char character;
  const char* lines;  // pairs of digits, x and y (up) of the grid; lines are separated by spaces
};

constexpr Glyph glyphs[] = {
    {'!', "0804 0202"},
    {'"', "0806 2826"},
    {'#', "1218 3238 0444 0646"},
    {'$', "473717060615354443331303 2921"},
    {'%', "0248 0808 4242"},
    {'&', "420718271603123244"},
    {'\'', "0806"},
    {'(', "18070311"},
    {')', "08171301"},
    {'*', "2327 0446 0644"},
    {'+', "0545 2723"},
    {',', "1201"},
    {'-', "0535"},
    {'.', "0202"},
    {'/', "0248"},
    {'0', "120307183847433212"},
    {'1', "062822"},
    {'2', "07183847460242"},
    {'3', "07183847463515 354443321203"},
    {'4', "32380444"},
    {'5', "480805354443321203"},
    {'6', "473818070312324344351504"},
    {'7', "084812"},
    {'8', "15060718384746351504031232434435"},
    {'9', "031232434738180706153546"},
    {':', "0202 0505"},
    {';', "1201 1515"},
    {'<', "370533"},
    {'=', "0646 0444"},
    {'>', "073503"},
    {'?', "07183847462524 2222"},
    {'@', "3525244435364613020718384746"},
    {'A', "022842 1434"},
    {'B', "02083847463505 3544433202"},
    {'C', "4738180703123243"},
    {'D', "02083847433202"},
    {'E', "48080242 0535"},
    {'F', "480802 0535"},
    {'G', "47381807031232434525"},
    {'H', "0208 4248 0545"},
    {'I', "0208"},
    {'J', "4843321203"},
    {'K', "0208 4804 1542"},
    {'L', "080242"},
    {'M', "0208254842"},
    {'N', "02084248"},
    {'O', "120307183847433212"},
    {'P', "02083847463505"},
    {'Q', "120307183847433212 2442"},
    {'R', "02083847463505 2542"},
    {'S', "473818070615354443321203"},
    {'T', "0848 2822"},
    {'U', "080312324348"},
    {'V', "082248"},
    {'W', "0812263248"},
    {'X', "0842 0248"},
    {'Y', "082548 2522"},
    {'Z', "08480242"},
    {'[', "18080111"},
    {'\\', "0842"},
    {']', "08181101"},
    {'^', "062846"},
    {'_', "0141"},
    {'`', "0817"},
    {'a', "4642 4536160503123243"},
    {'b', "0802 0516364543321203"},
    {'c', "4536160503123243"},
    {'d', "4842 4536160503123243"},
    {'e', "04444536160503123243"},
    {'f', "38281712 0636"},
    {'g', "46413010 4536160503123243"},
    {'h', "0802 0516364542"},
    {'i', "0602 0808"},
    {'j', "161100 1818"},
    {'k', "0802 3603 1432"},
    {'l', "0802"},
    {'m', "0602 0516263532 3546566562"},
    {'n', "0602 0516364542"},
    {'o', "160503123243453616"},
    {'p', "0600 0516364543321203"},
    {'q', "4640 4536160503123243"},
    {'r', "0602 051626"},
    {'s', "45361605143443321203"},
    {'t', "18132232 0636"},
    {'u', "0603123243 4642"},
    {'v', "062246"},
    {'w', "0622354266"},
    {'x', "0642 0246"},
    {'y', "0622 4610"},
    {'z', "06460242"},
    {'{', "28170605140311"},
    {'|', "0801"},
    {'}', "08172625142301"},
    {'~', "05163546"},
};
constexpr const char* unknown_glyph = "0208484202";

std::string_view lines_of(char32_t c) {
  for (const Glyph& glyph : glyphs) {
    if (static_cast<char32_t>(glyph.character) == c) return glyph.lines;
  }
  return unknown_glyph;
}

/// Calls use(line, x) for each line of each glyph, x where the glyph starts; returns where the text ends.
/// Grid units.
template <class Use>
double lay_out(const std::string& utf8, const Use& use) {
  double x = 0.0;
  for (const char32_t c : code_points(utf8)) {
    if (c == U' ' || c == U'\u00A0') {
      x += space;
      continue;
    }
    int width = 0;
    Polyline line;
    const auto end_line = [&] {
      if (!line.points.empty()) use(line, x);
      line.points.clear();
    };
    const std::string_view lines = lines_of(c);
    for (std::size_t i = 0; i + 1 < lines.size();) {
      if (lines[i] == ' ') {
        end_line();
        ++i;
        continue;
      }
      line.points.push_back({static_cast<double>(lines[i] - '0'), static_cast<double>(lines[i + 1] - '0')});
      width = std::max(width, lines[i] - '0');
      i += 2;
    }
    end_line();
    x += width + gap;
  }
  return x;
}

double scale_of(double size) { return size * cap_height / (cap - baseline); }

}  // namespace

std::vector<Polyline> stroked_text(const std::string& utf8, double size) {
  const double scale = scale_of(size);
  std::vector<Polyline> lines;
  lay_out(utf8, [&](const Polyline& line, double x) {
    Polyline placed;
    for (const Point& p : line.points) placed.points.push_back({(x + p.x) * scale, (baseline - p.y) * scale});
    if (placed.points.size() == 1) placed.points.push_back(placed.points.front());
    lines.push_back(placed);
  });
  return lines;
}

double stroked_text_width(const std::string& utf8, double size) {
  return std::max(0.0, lay_out(utf8, [](const Polyline&, double) {}) - gap) * scale_of(size);
}

}  // namespace nearfield::host::draw
