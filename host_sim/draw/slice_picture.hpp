#pragma once

#include <cstddef>
#include <functional>
#include <string>
#include <vector>

#include "draw/contour.hpp"
#include "draw/page_transform.hpp"
#include "draw/png.hpp"

namespace nearfield::host::draw {

/// A field in a plane, f below 0 inside its surface.
struct SlicePicture {
  struct Slope {
    Point at;      ///< metres
    Point uphill;  ///< the part of the field's gradient in the plane, any scale
  };

  std::string title;
  std::string note;            ///< beneath the title
  std::string axis_u, axis_v;  ///< with their units
  std::size_t width = 640;     ///< of the whole picture, pixels
  std::size_t height = 480;
  WorldWindow window;    ///< as slice_frame() has it for this picture's sides: the same scale both ways
  SampledGrid field;     ///< f over the window
  double spacing = 0.1;  ///< of the contour lines, in units of f; above 0
  int outer_count = 10;  ///< contour lines outside, at spacing, 2 spacing ...
  int inner_count = 10;  ///< and inside
  std::function<double(double f)>
      shade;  ///< of layers, 0 to 1 and 1 where f is 0; without it areas are plain
  std::vector<Slope> slopes;
  std::size_t saturated_slopes = 0;  ///< whose direction is that of differences
};

/// The frame within a picture of these sides that shows the plane, pixels.
Rectangle slice_frame(std::size_t width, std::size_t height);

std::string slice_svg(const SlicePicture& picture);
RgbImage slice_image(const SlicePicture& picture);

}  // namespace nearfield::host::draw
