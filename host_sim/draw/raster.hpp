#pragma once

#include <string>
#include <vector>

#include "draw/geometry.hpp"
#include "draw/png.hpp"
#include "draw/svg.hpp"

namespace nearfield::host::draw {

/// What SvgDocument draws, as pixels: the calls have the same meaning. Edges are smoothed; dashes are drawn
/// as whole lines, corners of rectangles are sharp, text is that of stroke_font.hpp. Colours are `#RRGGBB`,
/// others throw std::invalid_argument. The same calls give the same pixels.
class RasterDocument {
 public:
  /// White paper; whole pixels.
  RasterDocument(std::size_t width, std::size_t height);

  void begin_group(const std::string& name);
  void begin_clipped_group(const std::string& name, const Rectangle& window);
  void end_group();

  void line(Point from, Point to, const ShapeStyle& style);
  void path(const std::vector<Polyline>& lines, const ShapeStyle& style);
  void rectangle(const Rectangle& area, const ShapeStyle& style, double corner_radius = 0.0);
  void arrow(Point from, Point to, const std::string& colour, double width);
  void text(Point position, const std::string& content, const TextStyle& style);
  void text_along(Point centre, Point direction, const std::string& content, const TextStyle& style);

  RgbImage image() const;

 private:
  void fill(const std::vector<Polyline>& rings, const std::string& colour, double opacity);
  void stroke(const std::vector<Polyline>& lines, const std::string& colour, double width, double opacity);
  void cover_segment(Point a, Point b, double half_width);
  /// Paints what `coverage_` says within the innermost window, and clears it.
  void paint(const std::string& colour, double opacity);
  void cover(std::size_t x, std::size_t y, float share, bool add);

  std::size_t width_, height_;
  std::vector<float> pixels_;    ///< red, green, blue, 0 to 255
  std::vector<float> coverage_;  ///< of the shape being drawn, 0 to 1
  std::vector<std::size_t> touched_;
  std::vector<Rectangle> windows_;
};

}  // namespace nearfield::host::draw
