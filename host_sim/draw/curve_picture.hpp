#pragma once

#include <string>
#include <vector>

#include "draw/geometry.hpp"

namespace nearfield::host::draw {

/// A function with its first two derivatives and the error of its table, ready to be drawn. Points are
/// arguments and values. Every series is a list of stretches, between which it jumps.
struct CurvePicture {
  std::string title;
  std::vector<std::string> captions;  ///< paragraphs below the chart
  std::string argument = "r";
  std::string function = "F";
  double low = 0.0;  ///< range of the argument axis, low < high
  double high = 1.0;
  std::vector<Polyline> value;
  std::vector<Polyline> first;
  std::vector<Polyline> second;
  std::vector<Point> control_points;
  std::vector<Point> errors;        ///< table - exact over the argument, ascending; empty: there is no table
  double error_bound = 0.0;         ///< stated greatest error, > 0 if there are errors
  std::vector<double> knots;        ///< arguments where segments of the table meet
  std::string id_prefix = "curve";  ///< letters and digits, different for each picture of a page
};

/// The chart as an SVG document 1000 pixels wide: the function, its derivatives scaled to fit as the legend
/// tells, its control points, and below them the table's error in units of a power of two. The derivatives'
/// axis is the function's. Throws std::invalid_argument for points that are not finite.
std::string curve_picture_svg(const CurvePicture& picture);

}  // namespace nearfield::host::draw
