#pragma once

#include <string>
#include <vector>

#include "draw/style.hpp"

namespace nearfield::host::draw {

/// A clearance over time, metres, one value for each sample; a value that is not finite leaves a gap.
struct TimelineCurve {
  std::string name;
  std::vector<double> clearances;
};

/// A clearance that matters, metres, drawn as a dashed line.
struct TimelineThreshold {
  std::string name;
  double clearance = 0.0;
};

/// A moment worth a picture; `letter` is the letter on that picture.
struct TimelineMarker {
  double time = 0.0;
  std::string letter;
};

/// A run as a chart of three panels over one time axis: clearances, zone, speed override.
struct Timeline {
  std::string title;
  std::vector<double> times;  ///< seconds, ascending, at least two samples
  std::vector<TimelineCurve> curves;
  std::vector<TimelineThreshold> thresholds;
  std::vector<Zone> zones;              ///< one for each sample
  std::vector<double> speed_override;   ///< 0..1, one for each sample; others are drawn clamped
  std::vector<TimelineMarker> markers;  ///< those outside the run are left out
  double greatest_clearance = 0.0;      ///< top of the clearance axis, metres; 0: whatever the curves need
  std::string id_prefix = "timeline";   ///< letters and digits, different for each picture of a page
};

/// The chart as an SVG document 1000 pixels wide. Series of any length are reduced to what the page can show:
/// every minimum, every maximum and, of zones that share a pixel, the more severe one. Below 300 kB for up to
/// six curves. Throws std::invalid_argument when the series differ in length, there are fewer than two
/// samples or times do not ascend.
std::string timeline_svg(const Timeline& timeline);

}  // namespace nearfield::host::draw
