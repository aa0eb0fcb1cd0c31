#pragma once

#include <vector>

#include "draw/curve_axes.hpp"
#include "draw/curve_picture.hpp"
#include "draw/legend.hpp"

namespace nearfield::host::draw {

/// The panel of a curve's picture that shows the error of its table: over the argument, in units of the power
/// of two next above the stated bound, with the bound and the knots.
class CurveErrorPanel {
 public:
  /// `picture` has errors and outlives this. `top`: where the panel with its legend begins, pixels.
  CurveErrorPanel(const CurvePicture& picture, const ArgumentAxis& axis, double top);

  const Rectangle& frame() const { return frame_; }
  void draw(SvgDocument& document) const;

 private:
  std::vector<LegendEntry> legend() const;
  bool has_visible_knots() const;
  double y_of(double units) const { return frame_.top + 0.5 * frame_.height * (1.0 - units / reach_); }
  void draw_knots(SvgDocument& document) const;
  Polyline error_line() const;

  const CurvePicture& picture_;
  ArgumentAxis axis_;
  double legend_top_;
  Rectangle frame_;
  double unit_ = 1.0;
  int unit_exponent_ = 0;
  double reach_ = 1.0;  // units from the middle to the top
};

}  // namespace nearfield::host::draw
