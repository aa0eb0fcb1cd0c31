#pragma once

#include <string>
#include <vector>

#include "draw/svg.hpp"

namespace nearfield::host::draw {

enum class LegendSymbol { line, patch, dot, arrow, dumbbell };

/// One entry: a small symbol painted in `style` and what it stands for.
struct LegendEntry {
  std::string label;
  LegendSymbol symbol = LegendSymbol::line;
  ShapeStyle style;
};

/// Height in pixels of a legend that flows over rows of the given width.
double legend_height(const std::vector<LegendEntry>& entries, double width);

/// Draws the entries from `top_left` on, left to right, in rows of the given width.
void draw_legend(SvgDocument& document, const std::vector<LegendEntry>& entries, Point top_left,
                 double width);

}  // namespace nearfield::host::draw
