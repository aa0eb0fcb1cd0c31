#pragma once

#include "draw/page_transform.hpp"
#include "draw/scene_picture.hpp"
#include "draw/svg.hpp"

namespace nearfield::host::draw {

enum class ViewDirection { top, side };

/// Room that a panel needs around its frame for ticks and their labels, pixels.
struct PanelMargin {
  static constexpr double left = 44.0;
  static constexpr double bottom = 40.0;
  static constexpr double top = 28.0;
};

/// Draws one view of the scene inside `to_page.frame()`, with its title above and axes left and below.
void draw_scene_panel(SvgDocument& document, const ScenePicture& picture, ViewDirection direction,
                      const WorldToPage& to_page);

/// How each kind of thing is painted, for panels and legend alike.
namespace scene_style {
ShapeStyle solid();
ShapeStyle surface();
ShapeStyle contour();
ShapeStyle arm();
ShapeStyle joint();
ShapeStyle person();
ShapeStyle nearest();
ShapeStyle repulsion();
ShapeStyle tool_path();
}  // namespace scene_style

}  // namespace nearfield::host::draw
