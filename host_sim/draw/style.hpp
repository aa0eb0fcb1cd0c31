#pragma once

namespace nearfield::host::draw {

/// What the speed supervision allows: full speed, reduced speed, standstill.
enum class Zone { free, slow, stop };

/// The word for a zone, lower case.
constexpr const char* zone_name(Zone zone) {
  return zone == Zone::free ? "free" : (zone == Zone::slow ? "slow" : "stop");
}

/// Every colour of every picture. Hues are those of Okabe and Ito, told apart with any kind of colour vision;
/// meaning never rests on hue alone (labels, dashes and weights repeat it).
namespace palette {
inline constexpr const char* paper = "#FFFFFF";
inline constexpr const char* ink = "#1B2430";
inline constexpr const char* quiet_ink = "#56616F";
inline constexpr const char* grid_line = "#E3E7EC";
inline constexpr const char* frame = "#8C97A4";

inline constexpr const char* solid = "#B4BDC9";
inline constexpr const char* surface = "#2E3A48";
inline constexpr const char* contour = "#8796A9";
inline constexpr const char* band_near = "#C6D4E3";
inline constexpr const char* band_far = "#FFFFFF";

inline constexpr const char* arm = "#F2B134";
inline constexpr const char* arm_outline = "#8A5A00";
inline constexpr const char* person = "#7CC3EC";
inline constexpr const char* person_outline = "#004F80";
inline constexpr const char* nearest = "#C8450A";
inline constexpr const char* repulsion = "#00795A";
inline constexpr const char* tool_path = "#5B3A8C";

/// Curves, in order of use.
inline constexpr const char* curve[] = {"#0072B2", "#C8450A", "#00795A", "#A3508A", "#8A5A00", "#1B2430"};
inline constexpr int curve_count = 6;

/// Backgrounds of zones; dark text on any of them has a contrast of at least 4.5.
constexpr const char* zone_fill(Zone zone) {
  return zone == Zone::free ? "#A9DCCB" : (zone == Zone::slow ? "#F6D27A" : "#F0987A");
}
}  // namespace palette

namespace font {
inline constexpr const char* family =
    "system-ui, -apple-system, 'Segoe UI', 'Helvetica Neue', Arial, 'DejaVu Sans', sans-serif";
inline constexpr double title = 19.0;
inline constexpr double heading = 14.5;
inline constexpr double body = 14.0;
inline constexpr double small = 12.5;
}  // namespace font

}  // namespace nearfield::host::draw
