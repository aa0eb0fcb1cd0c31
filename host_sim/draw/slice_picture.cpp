#include "draw/slice_picture.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>

#include "draw/axis.hpp"
#include "draw/number_text.hpp"
#include "draw/raster.hpp"
#include "draw/svg.hpp"

namespace nearfield::host::draw {
namespace {

constexpr double text_margin = 6.0;                  // pixels that headings keep from the picture's edges
constexpr double least_shrinking = 0.75;             // of headings that are too long
constexpr double least_side_with_scale_bar = 180.0;  // pixels, of the frame
constexpr double margin_left = 58.0, margin_right = 16.0, margin_top = 48.0, margin_bottom = 44.0;
constexpr int shade_count = 10;
constexpr double line_tolerance = 0.05;   // pixels, by which contour lines are made simpler
constexpr double shade_tolerance = 0.15;  // the same of the edges of shades
constexpr const char* inside_fill = "#D9C3AE";
constexpr const char* inside_line = "#A5805C";
constexpr const char* slope_colour = "#3B4A5C";

struct Rgb {
  int red, green, blue;
};
constexpr Rgb inside_dark{186, 98, 58}, inside_light{250, 232, 219}, outside_dark{104, 151, 186},
    outside_light{247, 250, 252};

std::string between(const Rgb& dark, const Rgb& light, double t) {
  const auto mixed = [t](int a, int b) { return static_cast<unsigned>(std::lround(a + t * (b - a))); };
  char text[16];
  std::snprintf(text, sizeof text, "#%02X%02X%02X", mixed(dark.red, light.red) & 0xFFU,
                mixed(dark.green, light.green) & 0xFFU, mixed(dark.blue, light.blue) & 0xFFU);
  return text;
}

/// Draws the same with either kind of document.
template <class Document>
class SlicePainter {
 public:
  SlicePainter(Document& document, const SlicePicture& picture)
      : document_(document),
        picture_(picture),
        frame_(slice_frame(picture.width, picture.height)),
        to_page_(picture.window, {frame_.left, frame_.top},
                 frame_.width / (picture.window.right - picture.window.left)) {}

  void draw() {
    document_.begin_clipped_group("field", frame_);
    if (picture_.shade)
      draw_layers();
    else
      draw_areas();
    draw_contours();
    draw_slopes();
    draw_scale_bar();
    document_.end_group();
    draw_frame();
  }

 private:
  std::vector<Polyline> on_page(const std::vector<Polyline>& lines, double tolerance = line_tolerance) const {
    std::vector<Polyline> page;
    for (const Polyline& one : lines) page.push_back(simplified(to_page_(one), tolerance));
    return page;
  }
  /// The grid of another quantity of f; what is not known stays so.
  template <class Of>
  SampledGrid grid_of(const Of& of) const {
    SampledGrid grid = picture_.field;
    for (double& value : grid.values) value = std::isfinite(value) ? of(value) : value;
    return grid;
  }

  void draw_areas() {
    document_.rectangle(frame_, filled("#FFFFFF"));
    const int count = std::clamp(picture_.outer_count, 1, 24);
    for (int k = count; k >= 1; --k) {
      const double t = static_cast<double>(k - 1) / count;
      document_.path(on_page(filled_region(picture_.field, k * picture_.spacing)),
                     filled(between({203, 217, 231}, {250, 252, 253}, std::sqrt(t))));
    }
    document_.path(on_page(filled_region(picture_.field, 0.0)), filled(inside_fill));
  }
  /// From light to dark, each shade over the one before; those inside are 1 outside, and the other way round.
  void draw_layers() {
    document_.rectangle(frame_, filled(between(outside_dark, outside_light, 1.0)));
    draw_shades(grid_of([this](double f) { return picture_.shade(std::max(f, 0.0)); }), outside_dark,
                outside_light);
    document_.path(on_page(filled_region(picture_.field, 0.0)),
                   filled(between(inside_dark, inside_light, 1.0)));
    draw_shades(grid_of([this](double f) { return picture_.shade(std::min(f, 0.0)); }), inside_dark,
                inside_light);
  }
  void draw_shades(const SampledGrid& shades, const Rgb& dark, const Rgb& light) {
    for (int k = shade_count - 1; k >= 1; --k) {
      const double t = static_cast<double>(k) / shade_count;
      document_.path(on_page(filled_region(shades, t), shade_tolerance),
                     filled(between(dark, light, t - 0.5 / shade_count)));
    }
  }

  void draw_contours() {
    document_.begin_group("contours");
    for (int k = -picture_.inner_count; k <= picture_.outer_count; ++k) {
      if (k == 0) continue;
      ShapeStyle style = stroked(k < 0 ? inside_line : palette::contour, k % 5 == 0 ? 1.3 : 0.8);
      style.stroke_opacity = picture_.shade ? 0.35 : 0.9;
      document_.path(on_page(contour_lines(picture_.field, k * picture_.spacing)), style);
    }
    document_.path(on_page(contour_lines(picture_.field, 0.0)), stroked(palette::surface, 2.4));
    document_.end_group();
  }

  void draw_slopes() {
    if (picture_.slopes.empty()) return;
    std::vector<double> lengths;
    for (const SlicePicture::Slope& slope : picture_.slopes)
      lengths.push_back(std::hypot(slope.uphill.x, slope.uphill.y));
    const auto high = lengths.begin() + static_cast<std::ptrdiff_t>(lengths.size() * 9 / 10);
    std::nth_element(lengths.begin(), high, lengths.end());
    if (!(*high > 0.0)) return;
    document_.begin_group("gradients");
    for (const SlicePicture::Slope& slope : picture_.slopes) {
      const double size = std::hypot(slope.uphill.x, slope.uphill.y),
                   shown = 20.0 * std::min(1.0, size / *high);
      if (shown < 2.0) continue;
      const Point at = to_page_(slope.at);
      const Point half{0.5 * shown * slope.uphill.x / size, -0.5 * shown * slope.uphill.y / size};
      document_.arrow({at.x - half.x, at.y - half.y}, {at.x + half.x, at.y + half.y}, slope_colour, 1.3);
    }
    document_.end_group();
  }

  void draw_scale_bar() {
    // In a small picture it would hide too much; its axes tell the scale as well.
    if (std::min(frame_.width, frame_.height) < least_side_with_scale_bar) return;
    double metres = 0.0;
    for (const Tick& tick : round_ticks(0.0, (picture_.window.right - picture_.window.left) / 4.0, 3))
      metres = std::max(metres, tick.value);
    if (!(metres > 0.0)) return;
    TextStyle style;
    style.size = font::small;
    style.anchor = TextAnchor::middle;
    const std::string text = metres < 0.01 ? short_text(1000.0 * metres, 3) + " mm" : length_text(metres);
    const double width = to_page_.pixels(metres),
                 card = std::max(width + 16.0, text_width(text, style) + 4.0);
    const Rectangle behind{frame_.right() - 8.0 - card, frame_.bottom() - 38.0, card, 32.0};
    const Point left{behind.left + 0.5 * (card - width), frame_.bottom() - 14.0},
        right{left.x + width, left.y};
    document_.begin_group("scale-bar");
    document_.rectangle(behind, filled(palette::paper, 0.85), 3.0);
    document_.path({Polyline{{{left.x, left.y - 5.0}, left, right, {right.x, right.y - 5.0}}, false}},
                   stroked(palette::ink, 1.6));
    document_.text({0.5 * (left.x + right.x), left.y - 8.0}, text, style);
    document_.end_group();
  }

  void draw_frame() {
    document_.begin_group("axes");
    TextStyle style;
    style.size = font::small;
    style.anchor = TextAnchor::middle;
    const WorldWindow& w = picture_.window;
    const auto count = [](double pixels) {
      return static_cast<std::size_t>(std::max(2.0, std::min(pixels / 40.0, std::max(5.0, pixels / 64.0))));
    };
    for (const Tick& tick : round_ticks(w.left, w.right, count(frame_.width))) {
      const double x = to_page_({tick.value, w.bottom}).x;
      document_.line({x, frame_.bottom()}, {x, frame_.bottom() + 4.0}, stroked(palette::frame, 1.0));
      document_.text({x, frame_.bottom() + 17.0}, tick.text, style);
    }
    style.anchor = TextAnchor::end;
    for (const Tick& tick : round_ticks(w.bottom, w.top, count(frame_.height))) {
      const double y = to_page_({w.left, tick.value}).y;
      document_.line({frame_.left - 4.0, y}, {frame_.left, y}, stroked(palette::frame, 1.0));
      document_.text({frame_.left - 7.0, y + 0.36 * font::small}, tick.text, style);
    }
    style.anchor = TextAnchor::middle;
    document_.text({frame_.left + 0.5 * frame_.width, frame_.bottom() + 36.0}, picture_.axis_u, style);
    document_.text_along({14.0, frame_.top + 0.5 * frame_.height}, {0.0, -1.0}, picture_.axis_v, style);
    document_.rectangle(frame_, stroked(palette::frame, 1.0));
    TextStyle heading;
    heading.size = font::heading;
    heading.bold = true;
    draw_heading(20.0, picture_.title, heading);
    TextStyle note;
    note.size = font::small;
    note.fill = palette::quiet_ink;
    draw_heading(38.0, picture_.note, note);
    document_.end_group();
  }
  /// From the frame's left edge; what is too long for that from the picture's, smaller, and at last cut off.
  void draw_heading(double y, std::string text, TextStyle style) {
    const double right = static_cast<double>(picture_.width) - text_margin;
    const double wanted = text_width(text, style);
    const double left = wanted <= right - frame_.left ? frame_.left : std::max(text_margin, right - wanted);
    style.size *= std::clamp((right - left) / std::max(1.0, wanted), least_shrinking, 1.0);
    if (text_width(text, style) > right - left) {
      do {
        // Whole characters: bytes 10xxxxxx go on with one.
        while (text.size() > 1 && (static_cast<unsigned char>(text.back()) & 0xC0U) == 0x80U) text.pop_back();
        text.pop_back();
      } while (!text.empty() && text_width(text + "...", style) > right - left);
      text += "...";
    }
    document_.text({left, y}, text, style);
  }

  Document& document_;
  const SlicePicture& picture_;
  Rectangle frame_;
  WorldToPage to_page_;
};

}  // namespace

Rectangle slice_frame(std::size_t width, std::size_t height) {
  return {margin_left, margin_top, std::max(1.0, static_cast<double>(width) - margin_left - margin_right),
          std::max(1.0, static_cast<double>(height) - margin_top - margin_bottom)};
}

std::string slice_svg(const SlicePicture& picture) {
  SvgDocument document(static_cast<double>(picture.width), static_cast<double>(picture.height), picture.title,
                       picture.note);
  SlicePainter<SvgDocument>(document, picture).draw();
  return document.finish();
}

RgbImage slice_image(const SlicePicture& picture) {
  RasterDocument document(picture.width, picture.height);
  SlicePainter<RasterDocument>(document, picture).draw();
  return document.image();
}

}  // namespace nearfield::host::draw
