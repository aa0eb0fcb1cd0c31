#include "draw/legend.hpp"

#include <cstddef>

namespace nearfield::host::draw {
namespace {

constexpr double row_height = 22.0;
constexpr double symbol_width = 26.0;
constexpr double symbol_gap = 7.0;
constexpr double entry_gap = 22.0;

TextStyle label_style() {
  TextStyle style;
  style.size = font::small;
  return style;
}

std::vector<Point> entry_offsets(const std::vector<LegendEntry>& entries, double width) {
  std::vector<Point> offsets;
  Point at;
  for (const LegendEntry& entry : entries) {
    const double needed = symbol_width + symbol_gap + text_width(entry.label, label_style());
    if (at.x > 0.0 && at.x + needed > width) at = {0.0, at.y + row_height};
    offsets.push_back(at);
    at.x += needed + entry_gap;
  }
  return offsets;
}

void draw_symbol(SvgDocument& document, const LegendEntry& entry, Point left_middle) {
  const Point right_middle{left_middle.x + symbol_width, left_middle.y};
  const Point centre{left_middle.x + symbol_width / 2.0, left_middle.y};
  switch (entry.symbol) {
    case LegendSymbol::line:
      document.line(left_middle, right_middle, entry.style);
      break;
    case LegendSymbol::patch:
      document.rectangle({left_middle.x + 2.0, left_middle.y - 6.5, symbol_width - 4.0, 13.0}, entry.style,
                         2.0);
      break;
    case LegendSymbol::dot:
      document.circle(centre, 3.5, entry.style);
      break;
    case LegendSymbol::arrow:
      document.arrow(left_middle, right_middle, entry.style.stroke, entry.style.stroke_width);
      break;
    case LegendSymbol::dumbbell:
      document.line({left_middle.x + 3.0, centre.y}, {right_middle.x - 3.0, centre.y}, entry.style);
      document.circle({left_middle.x + 3.0, centre.y}, 3.5, filled(entry.style.stroke));
      document.circle({right_middle.x - 3.0, centre.y}, 3.5, filled(entry.style.stroke));
      break;
  }
}

}  // namespace

double legend_height(const std::vector<LegendEntry>& entries, double width) {
  return entries.empty() ? 0.0 : entry_offsets(entries, width).back().y + row_height;
}

void draw_legend(SvgDocument& document, const std::vector<LegendEntry>& entries, Point top_left,
                 double width) {
  document.begin_group("legend");
  const std::vector<Point> offsets = entry_offsets(entries, width);
  for (std::size_t i = 0; i < entries.size(); ++i) {
    const Point at{top_left.x + offsets[i].x, top_left.y + offsets[i].y};
    draw_symbol(document, entries[i], {at.x, at.y + row_height / 2.0});
    document.text({at.x + symbol_width + symbol_gap, at.y + row_height / 2.0 + 0.36 * font::small},
                  entries[i].label, label_style());
  }
  document.end_group();
}

}  // namespace nearfield::host::draw
