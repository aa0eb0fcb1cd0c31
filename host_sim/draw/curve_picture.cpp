#include "draw/curve_picture.hpp"

#include <algorithm>
#include <cmath>
#include <optional>
#include <stdexcept>

#include "draw/axis.hpp"
#include "draw/curve_error_panel.hpp"
#include "draw/derivative_scale.hpp"

namespace nearfield::host::draw {
namespace {

constexpr double page_width = 1000.0;
constexpr double plot_left = 72.0;
constexpr double plot_right = 972.0;
constexpr double legend_top = 44.0;
constexpr double value_height = 400.0;
constexpr double square_side = 7.0;
constexpr double key_width = 26.0;
constexpr double caption_line = 19.0;

double greatest_magnitude(const std::vector<Polyline>& lines) {
  double greatest = 0.0;
  for (const Polyline& line : lines) {
    for (const Point& p : line.points) greatest = std::max(greatest, std::fabs(p.y));
  }
  return greatest;
}

void check(const CurvePicture& picture) {
  bool fits = std::isfinite(picture.low) && std::isfinite(picture.high) && picture.low < picture.high;
  const auto include = [&fits](const Point& p) { fits = fits && std::isfinite(p.x) && std::isfinite(p.y); };
  for (const auto* lines : {&picture.value, &picture.first, &picture.second}) {
    for (const Polyline& line : *lines) std::for_each(line.points.begin(), line.points.end(), include);
  }
  std::for_each(picture.control_points.begin(), picture.control_points.end(), include);
  std::for_each(picture.errors.begin(), picture.errors.end(), include);
  for (const double knot : picture.knots) fits = fits && std::isfinite(knot);
  if (!fits) throw std::invalid_argument("draw: a curve needs finite points and an argument axis");
  if (!picture.errors.empty() && !(picture.error_bound > 0.0 && std::isfinite(picture.error_bound))) {
    throw std::invalid_argument("draw: errors need a bound above 0");
  }
}

class CurveChart {
 public:
  explicit CurveChart(const CurvePicture& picture)
      : picture_(picture),
        axis_{picture.low, picture.high, plot_left, plot_right},
        first_scale_(derivative_scale(greatest_magnitude(picture.first))),
        second_scale_(derivative_scale(greatest_magnitude(picture.second))) {
    panel_ = {plot_left, legend_top + legend_height(legend(), legend_width()) + 6.0, axis_.width(),
              value_height};
    if (!picture.errors.empty()) errors_.emplace(picture, axis_, panel_.bottom() + 12.0);
    axis_bottom_ = errors_ ? errors_->frame().bottom() : panel_.bottom();
    for (const std::string& caption : picture.captions) {
      for (std::string& line : wrapped(caption, chart_text(font::small, TextAnchor::start), axis_.width())) {
        caption_lines_.push_back(std::move(line));
      }
    }
    find_value_range();
  }

  std::string svg() const {
    const double caption_height = caption_line * static_cast<double>(caption_lines_.size());
    SvgDocument document(page_width, axis_bottom_ + 66.0 + caption_height, picture_.title,
                         picture_.function + " over " + picture_.argument +
                             " with its first two derivatives and the error of its table",
                         picture_.id_prefix);
    TextStyle title = chart_text(font::title, TextAnchor::start);
    title.bold = true;
    title.size *= std::min(1.0, axis_.width() / std::max(1.0, text_width(picture_.title, title)));
    document.text({plot_left, 30.0}, picture_.title, title);
    draw_legend(document, legend(), {plot_left, legend_top}, legend_width());
    if (!picture_.control_points.empty()) draw_control_point_key(document);
    draw_argument_axis(document);
    draw_values(document);
    if (errors_) errors_->draw(document);
    draw_captions(document);
    return document.finish();
  }

 private:
  static ShapeStyle value_style() { return stroked(palette::curve[0], 3.2); }
  static ShapeStyle first_style() { return stroked(palette::curve[1], 1.8, {9.0, 2.5}); }
  static ShapeStyle second_style() { return stroked(palette::curve[2], 1.8, {3.0, 2.0}); }

  std::vector<LegendEntry> legend() const {
    const std::string f = picture_.function, x = picture_.argument;
    return {{f, LegendSymbol::line, value_style()},
            {f + "′ = " + scale_text(first_scale_) + "d" + f + "/d" + x, LegendSymbol::line, first_style()},
            {f + "″ = " + scale_text(second_scale_) + "d²" + f + "/d" + x + "²", LegendSymbol::line,
             second_style()}};
  }
  // The key of the control points stands at the right of the legend.
  std::string key_text() const {
    return picture_.control_points.size() == 1 ? "control point" : "control points";
  }
  double key_left() const {
    return plot_right - key_width - 7.0 - text_width(key_text(), chart_text(font::small, TextAnchor::start));
  }
  double legend_width() const {
    return (picture_.control_points.empty() ? plot_right : key_left() - 22.0) - plot_left;
  }

  void find_value_range() {
    double low = 0.0, high = 1.0;
    const auto include = [&](const std::vector<Polyline>& lines, double scale) {
      for (const Polyline& line : lines) {
        for (const Point& p : line.points) {
          low = std::min(low, scale * p.y);
          high = std::max(high, scale * p.y);
        }
      }
    };
    include(picture_.value, 1.0);
    include(picture_.first, first_scale_);
    include(picture_.second, second_scale_);
    include({{picture_.control_points, false}}, 1.0);
    const double margin = 0.04 * (high - low);
    low_ = low - margin;
    high_ = high + margin;
  }

  Point on_panel(const Point& p, double scale) const {
    return {axis_.x_of(p.x), panel_.bottom() - (scale * p.y - low_) / (high_ - low_) * value_height};
  }

  void draw_argument_axis(SvgDocument& document) const {
    document.begin_group("argument-axis");
    for (const Tick& tick : round_ticks(picture_.low, picture_.high, 13)) {
      const double x = axis_.x_of(tick.value);
      document.line({x, panel_.top}, {x, panel_.bottom()}, stroked(palette::grid_line, 1.0));
      if (errors_) {
        document.line({x, errors_->frame().top}, {x, errors_->frame().bottom()},
                      stroked(palette::grid_line, 1.0));
      }
      document.line({x, axis_bottom_}, {x, axis_bottom_ + 5.0}, stroked(palette::frame, 1.0));
      document.text({x, axis_bottom_ + 20.0}, tick.text, chart_text(font::small, TextAnchor::middle));
    }
    document.text({(plot_left + plot_right) / 2.0, axis_bottom_ + 40.0}, picture_.argument,
                  chart_text(font::body, TextAnchor::middle));
    document.end_group();
  }

  void draw_values(SvgDocument& document) const {
    document.begin_group("values");
    draw_panel_name(document, panel_,
                    picture_.function + ", " + picture_.function + "′, " + picture_.function + "″");
    for (const Tick& tick : round_ticks(low_, high_, 9)) {
      draw_value_tick(document, panel_, on_panel({0.0, tick.value}, 1.0).y, tick.text, tick.value == 0.0);
    }
    document.begin_clipped_group("curves", panel_);
    draw_series(document, picture_.second, second_scale_, second_style());
    draw_series(document, picture_.first, first_scale_, first_style());
    draw_series(document, picture_.value, 1.0, value_style());
    document.end_group();
    if (!picture_.control_points.empty()) draw_control_points(document);
    document.rectangle(panel_, stroked(palette::frame, 1.0));
    document.end_group();
  }

  // Jumps between stretches are joined by a thin dotted line.
  void draw_series(SvgDocument& document, const std::vector<Polyline>& lines, double scale,
                   const ShapeStyle& style) const {
    std::vector<Polyline> on_page, jumps;
    for (const Polyline& line : lines) {
      if (line.points.empty()) continue;
      Polyline stretch;
      for (const Point& p : line.points) stretch.points.push_back(on_panel(p, scale));
      stretch = simplified(stretch, 0.04);
      const Point after = stretch.points.front(),
                  before = on_page.empty() ? after : on_page.back().points.back();
      if (!on_page.empty() && std::fabs(after.y - before.y) < 0.75) {
        on_page.back().points.insert(on_page.back().points.end(), stretch.points.begin() + 1,
                                     stretch.points.end());
        continue;
      }
      if (!on_page.empty()) jumps.push_back({{before, after}, false});
      on_page.push_back(std::move(stretch));
    }
    document.path(jumps, stroked(style.stroke, 1.2, {1.5, 2.5}));
    document.path(on_page, style);
  }

  static void draw_polygon(SvgDocument& document, const std::vector<Point>& points) {
    document.path({{points, false}}, stroked(palette::quiet_ink, 1.0));
    for (const Point& p : points) {
      document.rectangle({p.x - square_side / 2.0, p.y - square_side / 2.0, square_side, square_side},
                         filled_and_stroked(palette::paper, palette::ink, 1.4));
    }
  }

  void draw_control_points(SvgDocument& document) const {
    document.begin_group("control-points");
    std::vector<Point> points;
    for (const Point& p : picture_.control_points) points.push_back(on_panel(p, 1.0));
    draw_polygon(document, points);
    document.end_group();
  }

  void draw_control_point_key(SvgDocument& document) const {
    document.begin_group("control-point-key");
    const double left = key_left(), y = legend_top + 11.0;
    if (picture_.control_points.size() == 1)
      draw_polygon(document, {{left + key_width / 2.0, y}});
    else
      draw_polygon(document, {{left + 4.0, y}, {left + key_width - 4.0, y}});
    document.text({left + key_width + 7.0, y + 0.36 * font::small}, key_text(),
                  chart_text(font::small, TextAnchor::start));
    document.end_group();
  }

  void draw_captions(SvgDocument& document) const {
    document.begin_group("caption");
    double y = axis_bottom_ + 64.0;
    for (const std::string& line : caption_lines_) {
      document.text({plot_left, y}, line, chart_text(font::small, TextAnchor::start));
      y += caption_line;
    }
    document.end_group();
  }

  const CurvePicture& picture_;
  ArgumentAxis axis_;
  double first_scale_;
  double second_scale_;
  Rectangle panel_;
  std::optional<CurveErrorPanel> errors_;
  double axis_bottom_ = 0.0;
  std::vector<std::string> caption_lines_;
  double low_ = 0.0;  // of the value axis
  double high_ = 1.0;
};

}  // namespace

std::string curve_picture_svg(const CurvePicture& picture) {
  check(picture);
  return CurveChart(picture).svg();
}

}  // namespace nearfield::host::draw
