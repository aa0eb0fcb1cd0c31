#include "command/drawing.hpp"

#include <cstdio>

namespace nearfield::host {

const std::vector<DrawingVerb>& drawing_verbs() {
  static const std::vector<DrawingVerb> all = {
      {"slice", slice_options, "output", ".svg", true, draw_slice},
      {"render", render_options, "output", ".png", true, draw_scene},
      {"curve", curve_options, "svg", ".svg", false, draw_curve},
  };
  return all;
}

void print_warning(const std::string& file, const Drawing& drawing) {
  if (!drawing.warning.empty())
    std::fprintf(stderr, "%s: warning: %s\n", file.c_str(), drawing.warning.c_str());
}

}  // namespace nearfield::host
