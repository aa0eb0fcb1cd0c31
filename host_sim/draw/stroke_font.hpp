#pragma once

#include <string>
#include <vector>

#include "draw/geometry.hpp"

namespace nearfield::host::draw {

/// Text as lines of a plain font of this project, for pictures made of pixels: printable ASCII; whatever else
/// is drawn as an empty box. `size` as that of an SVG font, pixels; the baseline starts at {0, 0}, y down.
std::vector<Polyline> stroked_text(const std::string& utf8, double size);
/// How far the same text reaches, pixels.
double stroked_text_width(const std::string& utf8, double size);

}  // namespace nearfield::host::draw
