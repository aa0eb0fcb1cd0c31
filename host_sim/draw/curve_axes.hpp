#pragma once

#include <string>

#include "draw/svg.hpp"

namespace nearfield::host::draw {

/// The axis of arguments that the panels of a curve's picture share, from pixel `left` to `right`.
struct ArgumentAxis {
  double low = 0.0, high = 1.0;  ///< arguments at its ends
  double left = 0.0, right = 1.0;

  double x_of(double argument) const { return left + (argument - low) / (high - low) * width(); }
  double width() const { return right - left; }
};

inline TextStyle chart_text(double size, TextAnchor anchor) {
  TextStyle style;
  style.size = size;
  style.anchor = anchor;
  return style;
}

/// The name of what a panel shows, upright at its left.
inline void draw_panel_name(SvgDocument& document, const Rectangle& panel, const std::string& name) {
  document.text_along({panel.left - 55.0, panel.top + panel.height / 2.0}, {0.0, -1.0}, name,
                      chart_text(font::small, TextAnchor::middle));
}

/// A line across a panel at height y with what it stands for at its left; stronger for zero.
inline void draw_value_tick(SvgDocument& document, const Rectangle& panel, double y, const std::string& text,
                            bool zero) {
  document.line({panel.left, y}, {panel.right(), y},
                stroked(zero ? palette::frame : palette::grid_line, 1.0));
  document.line({panel.left - 5.0, y}, {panel.left, y}, stroked(palette::frame, 1.0));
  document.text({panel.left - 9.0, y + 0.36 * font::small}, text, chart_text(font::small, TextAnchor::end));
}

}  // namespace nearfield::host::draw
