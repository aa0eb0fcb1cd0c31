#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "draw/geometry.hpp"
#include "draw/style.hpp"

namespace nearfield::host::draw {

/// How an outline or area is painted. Lengths in pixels, opacities 0..1, colours as in `palette`.
struct ShapeStyle {
  std::string fill = "none";
  double fill_opacity = 1.0;
  std::string stroke = "none";
  double stroke_width = 1.0;
  double stroke_opacity = 1.0;
  std::vector<double> dash = {};
};

ShapeStyle filled(std::string fill, double opacity = 1.0);
ShapeStyle stroked(std::string stroke, double width, std::vector<double> dash = {});
ShapeStyle filled_and_stroked(std::string fill, std::string stroke, double width, double opacity = 1.0);

enum class TextAnchor { start, middle, end };

struct TextStyle {
  double size = font::body;
  std::string fill = palette::ink;
  TextAnchor anchor = TextAnchor::start;
  bool bold = false;
  double halo = 0.0;  ///< width of the rim that lifts text off lines beneath it, pixels
  std::string halo_fill = palette::paper;
};

/// Width of a line of UTF-8 text in pixels, estimated on the generous side for the fonts of `font::family`.
double text_width(const std::string& text, const TextStyle& style);

/// `text` broken at spaces so that no line is estimated wider than `width`, unless a single word is.
std::vector<std::string> wrapped(const std::string& text, const TextStyle& style, double width);

/// Text made safe for XML content and attributes: markup escaped, control characters and what is not UTF-8
/// replaced by U+FFFD.
std::string escaped(const std::string& text);

/// An SVG document, written front to back: what is added later covers what was added before. Pixels, y down,
/// two decimals. The same calls give the same bytes. Coordinates that are not finite throw
/// std::invalid_argument.
class SvgDocument {
 public:
  /// `title` and `description` are what a screen reader says. `id_prefix` (letters and digits) keeps the
  /// identifiers of several documents inside one HTML page apart.
  SvgDocument(double width, double height, const std::string& title, const std::string& description,
              std::string id_prefix = "nearfield");

  /// Opens a group; `name` becomes its class (letters, digits, hyphens).
  void begin_group(const std::string& name);
  /// Opens a group of which only what lies inside `window` is shown.
  void begin_clipped_group(const std::string& name, const Rectangle& window);
  /// Closes the innermost group. Throws std::logic_error when none is open.
  void end_group();

  void line(Point from, Point to, const ShapeStyle& style);
  /// Lines and rings in one element, areas by the even-odd rule; those of fewer than two points are left out.
  void path(const std::vector<Polyline>& lines, const ShapeStyle& style);
  void circle(Point centre, double radius, const ShapeStyle& style);
  void rectangle(const Rectangle& area, const ShapeStyle& style, double corner_radius = 0.0);
  /// Outline of all points within `radius` of the segment from `a` to `b`; a circle when they coincide.
  void stadium(Point a, Point b, double radius, const ShapeStyle& style);
  /// A straight arrow with a filled head, `width` wide in the shaft. Shorter than a pixel: left out.
  void arrow(Point from, Point to, const std::string& colour, double width);

  /// Text with its baseline through `position`.
  void text(Point position, const std::string& content, const TextStyle& style);
  /// Text centred at `centre`, running along `direction` (page, any length but zero).
  void text_along(Point centre, Point direction, const std::string& content, const TextStyle& style);

  /// The whole document. Throws std::logic_error while a group is open.
  std::string finish() const;

 private:
  void write_attribute(const char* name, double value);
  void write_attribute(const char* name, const std::string& value);
  void write_style(const ShapeStyle& style);
  void write_text(const std::string& placement, const std::string& content, const TextStyle& style);

  std::string head_;
  std::string body_;
  std::string id_prefix_;
  std::size_t open_groups_ = 0;
  std::size_t clips_ = 0;
};

}  // namespace nearfield::host::draw
