#include "draw/raster.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <stdexcept>

#include "draw/stroke_font.hpp"

namespace nearfield::host::draw {
namespace {

constexpr int lines_a_pixel = 4;  // of an area's edge, one above the other

std::array<float, 3> channels_of(const std::string& colour) {
  const bool plain = colour.size() == 7 && colour[0] == '#' &&
                     colour.find_first_not_of("0123456789abcdefABCDEF", 1) == std::string::npos;
  if (!plain) throw std::invalid_argument("draw: a colour of pixels is not #RRGGBB");
  std::array<float, 3> channels{};
  for (std::size_t i = 0; i < 3; ++i)
    channels[i] = static_cast<float>(std::stoi(colour.substr(1 + 2 * i, 2), nullptr, 16));
  return channels;
}

Rectangle common(const Rectangle& a, const Rectangle& b) {
  const double left = std::max(a.left, b.left), top = std::max(a.top, b.top);
  return {left, top, std::max(0.0, std::min(a.right(), b.right()) - left),
          std::max(0.0, std::min(a.bottom(), b.bottom()) - top)};
}

/// The pixels, of `count`, that the stretch [low, high] touches.
struct PixelRange {
  std::size_t first, end;
};
PixelRange pixels_between(double low, double high, std::size_t count) {
  const double greatest = static_cast<double>(count);
  return {static_cast<std::size_t>(std::clamp(std::floor(low), 0.0, greatest)),
          static_cast<std::size_t>(std::clamp(std::ceil(high), 0.0, greatest))};
}

}  // namespace

RasterDocument::RasterDocument(std::size_t width, std::size_t height)
    : width_(width),
      height_(height),
      pixels_(3 * width * height, 255.0F),
      coverage_(width * height, 0.0F),
      windows_{{0.0, 0.0, static_cast<double>(width), static_cast<double>(height)}} {}

void RasterDocument::begin_group(const std::string&) { windows_.push_back(windows_.back()); }
void RasterDocument::begin_clipped_group(const std::string&, const Rectangle& window) {
  windows_.push_back(common(windows_.back(), window));
}
void RasterDocument::end_group() {
  if (windows_.size() == 1) throw std::logic_error("draw: no group is open");
  windows_.pop_back();
}

void RasterDocument::line(Point from, Point to, const ShapeStyle& style) {
  path({Polyline{{from, to}, false}}, style);
}

void RasterDocument::path(const std::vector<Polyline>& lines, const ShapeStyle& style) {
  if (style.fill != "none") fill(lines, style.fill, style.fill_opacity);
  if (style.stroke != "none") stroke(lines, style.stroke, style.stroke_width, style.stroke_opacity);
}

void RasterDocument::rectangle(const Rectangle& area, const ShapeStyle& style, double) {
  path({Polyline{{{area.left, area.top},
                  {area.right(), area.top},
                  {area.right(), area.bottom()},
                  {area.left, area.bottom()}},
                 true}},
       style);
}

void RasterDocument::arrow(Point from, Point to, const std::string& colour, double width) {
  const double dx = to.x - from.x, dy = to.y - from.y, length = std::hypot(dx, dy);
  if (length < 1.0) return;
  const double head_length = std::min(length, 4.5 * width), head_half_width = head_length * 0.42;
  const Point unit{dx / length, dy / length};
  const Point neck{to.x - unit.x * head_length, to.y - unit.y * head_length};
  line(from, neck, stroked(colour, width));
  path({Polyline{{to,
                  {neck.x - unit.y * head_half_width, neck.y + unit.x * head_half_width},
                  {neck.x + unit.y * head_half_width, neck.y - unit.x * head_half_width}},
                 true}},
       filled(colour));
}

void RasterDocument::text(Point position, const std::string& content, const TextStyle& style) {
  std::vector<Polyline> lines = stroked_text(content, style.size);
  const double width = stroked_text_width(content, style.size);
  const double start = style.anchor == TextAnchor::start    ? 0.0
                       : style.anchor == TextAnchor::middle ? 0.5 * width
                                                            : width;
  for (Polyline& one : lines) {
    for (Point& p : one.points) p = {position.x + p.x - start, position.y + p.y};
  }
  const double thickness = style.size * (style.bold ? 0.125 : 0.085);
  if (style.halo > 0.0) stroke(lines, style.halo_fill, thickness + 2.0 * style.halo, 1.0);
  stroke(lines, style.fill, thickness, 1.0);
}

void RasterDocument::text_along(Point centre, Point direction, const std::string& content,
                                const TextStyle& style) {
  const double size = std::hypot(direction.x, direction.y);
  const Point along{direction.x / size, direction.y / size};
  std::vector<Polyline> lines = stroked_text(content, style.size);
  const double start = 0.5 * stroked_text_width(content, style.size), drop = 0.36 * style.size;
  for (Polyline& one : lines) {
    for (Point& p : one.points) {
      const double u = p.x - start, v = p.y + drop;
      p = {centre.x + u * along.x - v * along.y, centre.y + u * along.y + v * along.x};
    }
  }
  stroke(lines, style.fill, style.size * (style.bold ? 0.125 : 0.085), 1.0);
}

RgbImage RasterDocument::image() const {
  RgbImage image{width_, height_, std::vector<std::uint8_t>(pixels_.size())};
  for (std::size_t i = 0; i < pixels_.size(); ++i)
    image.bytes[i] = static_cast<std::uint8_t>(std::lround(pixels_[i]));
  return image;
}

/// Even-odd: on each line the places where edges cross it, in order, begin and end the area in turns.
void RasterDocument::fill(const std::vector<Polyline>& rings, const std::string& colour, double opacity) {
  const std::size_t lines = height_ * lines_a_pixel;
  std::vector<std::vector<double>> crossings(lines);
  for (const Polyline& ring : rings) {
    for (std::size_t i = 0; i < ring.points.size(); ++i) {
      const Point a = ring.points[i], b = ring.points[(i + 1) % ring.points.size()];
      if (a.y == b.y) continue;
      const double low = std::min(a.y, b.y), high = std::max(a.y, b.y);
      // Line j is at (j + 1/2) / lines_a_pixel.
      const double first = std::max(0.0, std::ceil(low * lines_a_pixel - 0.5));
      for (double j = first; j < static_cast<double>(lines) && (j + 0.5) / lines_a_pixel < high; j += 1.0) {
        const double y = (j + 0.5) / lines_a_pixel;
        crossings[static_cast<std::size_t>(j)].push_back(a.x + (y - a.y) / (b.y - a.y) * (b.x - a.x));
      }
    }
  }
  for (std::size_t j = 0; j < lines; ++j) {
    std::vector<double>& places = crossings[j];
    std::sort(places.begin(), places.end());
    for (std::size_t i = 0; i + 1 < places.size(); i += 2) {
      const PixelRange range = pixels_between(places[i], places[i + 1], width_);
      for (std::size_t x = range.first; x < range.end; ++x) {
        const double left = static_cast<double>(x);
        const double share = std::min(left + 1.0, places[i + 1]) - std::max(left, places[i]);
        if (share > 0.0) cover(x, j / lines_a_pixel, static_cast<float>(share / lines_a_pixel), true);
      }
    }
  }
  paint(colour, opacity);
}

void RasterDocument::stroke(const std::vector<Polyline>& lines, const std::string& colour, double width,
                            double opacity) {
  for (const Polyline& one : lines) {
    if (one.points.size() < 2) continue;
    for (std::size_t i = 1; i < one.points.size(); ++i)
      cover_segment(one.points[i - 1], one.points[i], 0.5 * width);
    if (one.closed) cover_segment(one.points.back(), one.points.front(), 0.5 * width);
  }
  paint(colour, opacity);
}

void RasterDocument::cover_segment(Point a, Point b, double half_width) {
  // A line thinner than a pixel covers less of it.
  const double half = std::max(0.5, half_width), share = half_width / half, reach = half + 0.5;
  const PixelRange columns = pixels_between(std::min(a.x, b.x) - reach, std::max(a.x, b.x) + reach, width_);
  const PixelRange rows = pixels_between(std::min(a.y, b.y) - reach, std::max(a.y, b.y) + reach, height_);
  const double dx = b.x - a.x, dy = b.y - a.y, squared = dx * dx + dy * dy;
  for (std::size_t y = rows.first; y < rows.end; ++y) {
    for (std::size_t x = columns.first; x < columns.end; ++x) {
      const double px = static_cast<double>(x) + 0.5 - a.x, py = static_cast<double>(y) + 0.5 - a.y;
      const double t = squared > 0.0 ? std::clamp((px * dx + py * dy) / squared, 0.0, 1.0) : 0.0;
      const double covered = std::clamp(reach - std::hypot(px - t * dx, py - t * dy), 0.0, 1.0) * share;
      if (covered > 0.0) cover(x, y, static_cast<float>(covered), false);
    }
  }
}

void RasterDocument::cover(std::size_t x, std::size_t y, float share, bool add) {
  float& covered = coverage_[y * width_ + x];
  if (covered == 0.0F) touched_.push_back(y * width_ + x);
  covered = add ? std::min(1.0F, covered + share) : std::max(covered, share);
}

void RasterDocument::paint(const std::string& colour, double opacity) {
  const std::array<float, 3> channels = channels_of(colour);
  const Rectangle& window = windows_.back();
  for (const std::size_t i : touched_) {
    const double x = static_cast<double>(i % width_), y = static_cast<double>(i / width_);
    const Rectangle seen = common(window, {x, y, 1.0, 1.0});
    const float share = coverage_[i] * static_cast<float>(opacity * seen.width * seen.height);
    coverage_[i] = 0.0F;
    for (std::size_t channel = 0; channel < 3; ++channel) {
      float& pixel = pixels_[3 * i + channel];
      pixel += share * (channels[channel] - pixel);
    }
  }
  touched_.clear();
}

}  // namespace nearfield::host::draw
