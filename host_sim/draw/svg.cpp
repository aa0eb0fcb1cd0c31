#include "draw/svg.hpp"

#include <cmath>
#include <stdexcept>
#include <utility>

#include "draw/number_text.hpp"
#include "draw/text_code_points.hpp"

namespace nearfield::host::draw {
namespace {

std::string coordinate(double value) { return short_text(value, 2); }

std::string pair(Point p) { return coordinate(p.x) + ' ' + coordinate(p.y); }

double advance(char32_t c) {
  if (c == U' ' || c == U'\u00A0') return 0.34;
  if (std::u32string_view(U"iljtfrI.,:;'|!()[]-\u00B7").find(c) != std::u32string_view::npos) return 0.40;
  if (std::u32string_view(U"mwMW%@").find(c) != std::u32string_view::npos) return 0.96;
  if (c >= U'A' && c <= U'Z') return 0.72;
  return c < 0x2000 ? 0.62 : 0.9;
}

}  // namespace

ShapeStyle filled(std::string fill, double opacity) {
  ShapeStyle style;
  style.fill = std::move(fill);
  style.fill_opacity = opacity;
  return style;
}

ShapeStyle stroked(std::string stroke, double width, std::vector<double> dash) {
  ShapeStyle style;
  style.stroke = std::move(stroke);
  style.stroke_width = width;
  style.dash = std::move(dash);
  return style;
}

ShapeStyle filled_and_stroked(std::string fill, std::string stroke, double width, double opacity) {
  ShapeStyle style = stroked(std::move(stroke), width);
  style.fill = std::move(fill);
  style.fill_opacity = opacity;
  return style;
}

double text_width(const std::string& text, const TextStyle& style) {
  double width = 0.0;
  for (const char32_t c : code_points(text)) width += advance(c);
  return width * style.size * (style.bold ? 1.1 : 1.0);
}

std::vector<std::string> wrapped(const std::string& text, const TextStyle& style, double width) {
  std::vector<std::string> lines;
  std::string line;
  std::size_t at = 0;
  while (at < text.size()) {
    std::size_t end = text.find(' ', at);
    if (end == std::string::npos) end = text.size();
    const std::string word = text.substr(at, end - at);
    at = end + 1;
    if (word.empty()) continue;
    const std::string longer = line.empty() ? word : line + ' ' + word;
    if (!line.empty() && text_width(longer, style) > width) {
      lines.push_back(line);
      line = word;
    } else {
      line = longer;
    }
  }
  if (!line.empty()) lines.push_back(line);
  return lines;
}

std::string escaped(const std::string& text) {
  std::string safe;
  for (const char32_t c : code_points(text)) {
    switch (c) {
      case U'&':
        safe += "&amp;";
        break;
      case U'<':
        safe += "&lt;";
        break;
      case U'>':
        safe += "&gt;";
        break;
      case U'"':
        safe += "&quot;";
        break;
      case U'\'':
        safe += "&#39;";
        break;
      default:
        append_utf8(safe, c);
    }
  }
  return safe;
}

SvgDocument::SvgDocument(double width, double height, const std::string& title,
                         const std::string& description, std::string id_prefix)
    : id_prefix_(std::move(id_prefix)) {
  const std::string w = coordinate(width);
  const std::string h = coordinate(height);
  head_ = "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n<svg xmlns=\"http://www.w3.org/2000/svg\" width=\"" +
          w + "\" height=\"" + h + "\" viewBox=\"0 0 " + w + ' ' + h + "\" role=\"img\" font-family=\"" +
          escaped(font::family) + "\" stroke-linejoin=\"round\" stroke-linecap=\"butt\">\n<title>" +
          escaped(title) + "</title>\n<desc>" + escaped(description) + "</desc>\n";
  rectangle({0.0, 0.0, width, height}, filled(palette::paper));
}

void SvgDocument::begin_group(const std::string& name) {
  body_ += "<g class=\"" + escaped(name) + "\">\n";
  ++open_groups_;
}

void SvgDocument::begin_clipped_group(const std::string& name, const Rectangle& window) {
  const std::string id = escaped(id_prefix_) + "-clip" + std::to_string(++clips_);
  body_ += "<clipPath id=\"" + id + "\"><rect";
  write_attribute("x", window.left);
  write_attribute("y", window.top);
  write_attribute("width", window.width);
  write_attribute("height", window.height);
  body_ += "/></clipPath>\n<g class=\"" + escaped(name) + "\" clip-path=\"url(#" + id + ")\">\n";
  ++open_groups_;
}

void SvgDocument::end_group() {
  if (open_groups_ == 0) throw std::logic_error("draw: no group is open");
  --open_groups_;
  body_ += "</g>\n";
}

void SvgDocument::line(Point from, Point to, const ShapeStyle& style) {
  path({Polyline{{from, to}, false}}, style);
}

void SvgDocument::path(const std::vector<Polyline>& lines, const ShapeStyle& style) {
  std::string data;
  for (const Polyline& line : lines) {
    if (line.points.size() < 2) continue;
    data += 'M' + pair(line.points.front());
    char separator = 'L';
    for (std::size_t i = 1; i < line.points.size(); ++i) {
      data += separator + pair(line.points[i]);
      separator = ' ';
    }
    if (line.closed) data += 'Z';
  }
  if (data.empty()) return;
  body_ += "<path d=\"" + data + '"';
  if (style.fill != "none") body_ += " fill-rule=\"evenodd\"";
  write_style(style);
  body_ += "/>\n";
}

void SvgDocument::circle(Point centre, double radius, const ShapeStyle& style) {
  body_ += "<circle";
  write_attribute("cx", centre.x);
  write_attribute("cy", centre.y);
  write_attribute("r", radius);
  write_style(style);
  body_ += "/>\n";
}

void SvgDocument::rectangle(const Rectangle& area, const ShapeStyle& style, double corner_radius) {
  body_ += "<rect";
  write_attribute("x", area.left);
  write_attribute("y", area.top);
  write_attribute("width", area.width);
  write_attribute("height", area.height);
  if (corner_radius > 0.0) write_attribute("rx", corner_radius);
  write_style(style);
  body_ += "/>\n";
}

void SvgDocument::stadium(Point a, Point b, double radius, const ShapeStyle& style) {
  const double dx = b.x - a.x;
  const double dy = b.y - a.y;
  const double length = std::sqrt(dx * dx + dy * dy);
  if (!(length >= 0.01)) return circle(a, radius, style);
  const Point side{-dy / length * radius, dx / length * radius};
  const std::string arc = 'A' + coordinate(radius) + ' ' + coordinate(radius) + " 0 0 0 ";
  body_ += "<path d=\"M" + pair({a.x + side.x, a.y + side.y}) + 'L' + pair({b.x + side.x, b.y + side.y}) +
           arc + pair({b.x - side.x, b.y - side.y}) + 'L' + pair({a.x - side.x, a.y - side.y}) + arc +
           pair({a.x + side.x, a.y + side.y}) + "Z\"";
  write_style(style);
  body_ += "/>\n";
}

void SvgDocument::arrow(Point from, Point to, const std::string& colour, double width) {
  const double dx = to.x - from.x;
  const double dy = to.y - from.y;
  const double length = std::sqrt(dx * dx + dy * dy);
  if (length < 1.0) return;
  const double head_length = length < 4.5 * width ? length : 4.5 * width;
  const double head_half_width = head_length * 0.42;
  const Point unit{dx / length, dy / length};
  const Point neck{to.x - unit.x * head_length, to.y - unit.y * head_length};
  const double overlap = head_length * 0.2;
  line(from, {neck.x + unit.x * overlap, neck.y + unit.y * overlap}, stroked(colour, width));
  path({Polyline{{to,
                  {neck.x - unit.y * head_half_width, neck.y + unit.x * head_half_width},
                  {neck.x + unit.y * head_half_width, neck.y - unit.x * head_half_width}},
                 true}},
       filled(colour));
}

void SvgDocument::text(Point position, const std::string& content, const TextStyle& style) {
  write_text(" x=\"" + coordinate(position.x) + "\" y=\"" + coordinate(position.y) + '"', content, style);
}

void SvgDocument::text_along(Point centre, Point direction, const std::string& content,
                             const TextStyle& style) {
  const double length = std::sqrt(direction.x * direction.x + direction.y * direction.y);
  const double c = direction.x / length;
  const double s = direction.y / length;
  const double drop = 0.36 * style.size;
  TextStyle centred = style;
  centred.anchor = TextAnchor::middle;
  write_text(" transform=\"matrix(" + short_text(c, 5) + ' ' + short_text(s, 5) + ' ' + short_text(-s, 5) +
                 ' ' + short_text(c, 5) + ' ' + pair({centre.x - s * drop, centre.y + c * drop}) + ")\"",
             content, centred);
}

std::string SvgDocument::finish() const {
  if (open_groups_ != 0) throw std::logic_error("draw: a group is still open");
  return head_ + body_ + "</svg>\n";
}

void SvgDocument::write_attribute(const char* name, double value) {
  write_attribute(name, coordinate(value));
}

void SvgDocument::write_attribute(const char* name, const std::string& value) {
  body_ += std::string(" ") + name + "=\"" + escaped(value) + '"';
}

void SvgDocument::write_style(const ShapeStyle& style) {
  write_attribute("fill", style.fill);
  if (style.fill != "none" && style.fill_opacity < 1.0) write_attribute("fill-opacity", style.fill_opacity);
  if (style.stroke == "none") return;
  write_attribute("stroke", style.stroke);
  write_attribute("stroke-width", style.stroke_width);
  if (style.stroke_opacity < 1.0) write_attribute("stroke-opacity", style.stroke_opacity);
  if (style.dash.empty()) return;
  std::string dashes;
  for (const double length : style.dash) dashes += (dashes.empty() ? "" : " ") + coordinate(length);
  write_attribute("stroke-dasharray", dashes);
}

void SvgDocument::write_text(const std::string& placement, const std::string& content,
                             const TextStyle& style) {
  body_ += "<text" + placement;
  write_attribute("font-size", style.size);
  write_attribute("fill", style.fill);
  if (style.bold) body_ += " font-weight=\"600\"";
  if (style.anchor == TextAnchor::middle) body_ += " text-anchor=\"middle\"";
  if (style.anchor == TextAnchor::end) body_ += " text-anchor=\"end\"";
  if (style.halo > 0.0) {
    body_ += " paint-order=\"stroke\"";
    write_attribute("stroke", style.halo_fill);
    write_attribute("stroke-width", 2.0 * style.halo);
  }
  body_ += '>' + escaped(content) + "</text>\n";
}

}  // namespace nearfield::host::draw
