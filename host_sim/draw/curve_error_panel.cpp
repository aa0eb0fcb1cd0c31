#include "draw/curve_error_panel.hpp"

#include <algorithm>

#include "draw/axis.hpp"
#include "draw/decimate.hpp"
#include "draw/derivative_scale.hpp"

namespace nearfield::host::draw {
namespace {

constexpr double panel_height = 120.0;
// Ticks of knots closer than this, in pixels, would be a grey bar.
constexpr double least_knot_distance = 2.5;

ShapeStyle bound_style() { return stroked(palette::curve[1], 1.3, {6.0, 4.0}); }
ShapeStyle error_style() { return stroked(palette::curve[0], 1.2); }

}  // namespace

CurveErrorPanel::CurveErrorPanel(const CurvePicture& picture, const ArgumentAxis& axis, double top)
    : picture_(picture), axis_(axis), legend_top_(top) {
  frame_ = {axis.left, top + legend_height(legend(), axis.width()) + 4.0, axis.width(), panel_height};
  for (; unit_ >= 2.0 * picture.error_bound; unit_ *= 0.5) --unit_exponent_;
  for (; unit_ < picture.error_bound; unit_ *= 2.0) ++unit_exponent_;
  reach_ = 1.35 * picture.error_bound / unit_;
}

void CurveErrorPanel::draw(SvgDocument& document) const {
  document.begin_group("errors");
  draw_legend(document, legend(), {axis_.left, legend_top_}, axis_.width());
  draw_panel_name(document, frame_, "error (2" + superscript(unit_exponent_) + ")");
  for (const Tick& tick : round_ticks(-reach_, reach_, 5)) {
    draw_value_tick(document, frame_, y_of(tick.value), tick.text, tick.value == 0.0);
  }
  draw_knots(document);
  document.begin_clipped_group("error-curve", frame_);
  document.path({error_line()}, error_style());
  for (const double side : {-1.0, 1.0}) {
    const double y = y_of(side * picture_.error_bound / unit_);
    document.line({axis_.x_of(picture_.errors.front().x), y}, {axis_.x_of(picture_.errors.back().x), y},
                  bound_style());
  }
  document.end_group();
  document.rectangle(frame_, stroked(palette::frame, 1.0));
  document.end_group();
}

std::vector<LegendEntry> CurveErrorPanel::legend() const {
  std::vector<LegendEntry> entries;
  entries.push_back({"table − exact", LegendSymbol::line, error_style()});
  entries.push_back({"stated bound", LegendSymbol::line, bound_style()});
  if (has_visible_knots()) {
    entries.push_back({"knots", LegendSymbol::line, stroked(palette::quiet_ink, 7.0, {1.2, 5.0})});
  }
  return entries;
}

bool CurveErrorPanel::has_visible_knots() const {
  return picture_.knots.size() > 1 &&
         axis_.width() / static_cast<double>(picture_.knots.size() - 1) >= least_knot_distance;
}

void CurveErrorPanel::draw_knots(SvgDocument& document) const {
  if (!has_visible_knots()) return;
  std::vector<Polyline> ticks;
  for (const double knot : picture_.knots) {
    const double x = axis_.x_of(knot);
    ticks.push_back({{{x, frame_.bottom() - 7.0}, {x, frame_.bottom()}}, false});
  }
  document.path(ticks, stroked(palette::quiet_ink, 1.2));
}

Polyline CurveErrorPanel::error_line() const {
  std::vector<double> arguments, errors;
  for (const Point& p : picture_.errors) {
    arguments.push_back(p.x);
    errors.push_back(p.y / unit_);
  }
  Polyline line;
  for (const std::size_t i : decimated(arguments, errors, static_cast<std::size_t>(axis_.width()))) {
    // What leaves the panel ends well outside of it.
    line.points.push_back({axis_.x_of(arguments[i]), y_of(std::clamp(errors[i], -4.0, 4.0))});
  }
  return simplified(line, 0.05);
}

}  // namespace nearfield::host::draw
