#include "command/drawing.hpp"

namespace nearfield::host {

const std::vector<DrawingVerb>& drawing_verbs() {
  static const std::vector<DrawingVerb> all = {
      {"slice", slice_options, "output", ".svg", true, draw_slice},
      {"render", render_options, "output", ".png", true, draw_scene},
      {"curve", curve_options, "svg", ".svg", false, draw_curve},
  };
  return all;
}

}  // namespace nearfield::host
