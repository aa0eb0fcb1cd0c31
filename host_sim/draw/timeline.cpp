#include "draw/timeline.hpp"

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "draw/axis.hpp"
#include "draw/decimate.hpp"
#include "draw/legend.hpp"
#include "draw/number_text.hpp"
#include "draw/svg.hpp"

namespace nearfield::host::draw {
namespace {

constexpr double page_width = 1000.0;
constexpr double plot_left = 72.0;
constexpr double plot_right = 872.0;
constexpr double clearance_height = 260.0;
constexpr double zone_height = 34.0;
constexpr double override_height = 90.0;
constexpr double panel_gap = 20.0;
constexpr double marker_radius = 10.5;
constexpr std::size_t greatest_point_count = 14000;
const Zone every_zone[] = {Zone::free, Zone::slow, Zone::stop};

TextStyle label(double size, TextAnchor anchor, const char* fill = palette::ink) {
  TextStyle style;
  style.size = size;
  style.anchor = anchor;
  style.fill = fill;
  return style;
}

void check(const Timeline& timeline) {
  const std::size_t count = timeline.times.size();
  bool fits = count >= 2 && timeline.zones.size() == count && timeline.speed_override.size() == count;
  for (const TimelineCurve& curve : timeline.curves) fits = fits && curve.clearances.size() == count;
  if (!fits) throw std::invalid_argument("draw: the series of a timeline need the same length, two or more");
  for (std::size_t i = 0; i < count; ++i) {
    if (!std::isfinite(timeline.times[i]) || (i > 0 && !(timeline.times[i] > timeline.times[i - 1]))) {
      throw std::invalid_argument("draw: the times of a timeline must ascend");
    }
  }
}

class TimelineChart {
 public:
  explicit TimelineChart(const Timeline& timeline)
      : timeline_(timeline), first_(timeline.times.front()), last_(timeline.times.back()) {
    const double legend_top = timeline.title.empty() ? 10.0 : 44.0;
    legend_ = legend_entries();
    legend_top_ = legend_top;
    const double markers_top = legend_top + legend_height(legend_, page_width - plot_left - 16.0);
    marker_centre_ = markers_top + 6.0 + marker_radius;
    const double marker_strip = timeline.markers.empty() ? 8.0 : 6.0 + 2.0 * marker_radius + 12.0;
    clearance_panel_ = panel(markers_top + marker_strip, clearance_height);
    zone_panel_ = panel(clearance_panel_.bottom() + panel_gap, zone_height);
    override_panel_ = panel(zone_panel_.bottom() + panel_gap, override_height);
    find_clearance_range();
  }

  std::string svg() {
    SvgDocument document(page_width, override_panel_.bottom() + 52.0,
                         timeline_.title.empty() ? "Timeline of a run" : timeline_.title,
                         "Clearances, zone and speed override over time", timeline_.id_prefix);
    TextStyle title = label(font::title, TextAnchor::start);
    title.bold = true;
    if (!timeline_.title.empty()) document.text({plot_left, 30.0}, timeline_.title, title);
    draw_legend(document, legend_, {plot_left, legend_top_}, page_width - plot_left - 16.0);
    draw_time_axis(document);
    draw_clearances(document);
    draw_zones(document);
    draw_override(document);
    draw_markers(document);
    draw_zone_names(document);
    return document.finish();
  }

 private:
  static Rectangle panel(double top, double height) {
    return {plot_left, top, plot_right - plot_left, height};
  }

  std::vector<LegendEntry> legend_entries() const {
    std::vector<LegendEntry> entries;
    for (std::size_t i = 0; i < timeline_.curves.size(); ++i) {
      entries.push_back({timeline_.curves[i].name, LegendSymbol::line, curve_style(i)});
    }
    return entries;
  }

  static ShapeStyle curve_style(std::size_t index) {
    const std::size_t colours = static_cast<std::size_t>(palette::curve_count);
    ShapeStyle style = stroked(palette::curve[index % colours], 1.8);
    if (index % 3 == 1) style.dash = {9.0, 2.5};
    if (index % 3 == 2) style.dash = {3.0, 2.0};
    return style;
  }

  void find_clearance_range() {
    double least = 0.0;
    double greatest = timeline_.greatest_clearance;
    const bool given = greatest > 0.0;
    for (const TimelineCurve& curve : timeline_.curves) {
      for (const double clearance : curve.clearances) {
        if (!std::isfinite(clearance)) continue;
        least = std::min(least, clearance);
        if (!given) greatest = std::max(greatest, clearance);
      }
    }
    for (const TimelineThreshold& threshold : timeline_.thresholds) {
      if (!given) greatest = std::max(greatest, threshold.clearance * 1.1);
    }
    clearance_top_ = given ? greatest : round_up(greatest);
    clearance_bottom_ = least < 0.0 ? -round_up(-least) : 0.0;
  }

  double x_of(double time) const {
    return plot_left + (time - first_) / (last_ - first_) * (plot_right - plot_left);
  }
  double y_of_clearance(double clearance) const {
    const double share = (clearance - clearance_bottom_) / (clearance_top_ - clearance_bottom_);
    return clearance_panel_.bottom() - share * clearance_panel_.height;
  }

  void draw_panel_name(SvgDocument& document, const Rectangle& area, const std::string& name) const {
    document.text_along({17.0, area.top + area.height / 2.0}, {0.0, -1.0}, name,
                        label(font::small, TextAnchor::middle));
  }

  void draw_time_axis(SvgDocument& document) const {
    document.begin_group("time-axis");
    for (const Tick& tick : round_ticks(first_, last_, 13)) {
      const double x = x_of(tick.value);
      for (const Rectangle& area : {clearance_panel_, override_panel_}) {
        document.line({x, area.top}, {x, area.bottom()}, stroked(palette::grid_line, 1.0));
      }
      document.line({x, override_panel_.bottom()}, {x, override_panel_.bottom() + 5.0},
                    stroked(palette::frame, 1.0));
      document.text({x, override_panel_.bottom() + 20.0}, tick.text, label(font::small, TextAnchor::middle));
    }
    document.text({(plot_left + plot_right) / 2.0, override_panel_.bottom() + 41.0}, "time (s)",
                  label(font::body, TextAnchor::middle));
    document.end_group();
  }

  void draw_value_axis(SvgDocument& document, const Rectangle& area, double low, double high,
                       std::size_t greatest_count) const {
    for (const Tick& tick : round_ticks(low, high, greatest_count)) {
      const double y = area.bottom() - (tick.value - low) / (high - low) * area.height;
      document.line({plot_left, y}, {plot_right, y}, stroked(palette::grid_line, 1.0));
      document.line({plot_left - 5.0, y}, {plot_left, y}, stroked(palette::frame, 1.0));
      document.text({plot_left - 9.0, y + 0.36 * font::small}, tick.text,
                    label(font::small, TextAnchor::end));
    }
  }

  /// A series as lines on the page, broken where a whole bucket holds no finite sample.
  template <typename ToPage>
  std::vector<Polyline> series(const std::vector<double>& values, ToPage&& to_page) const {
    const std::size_t pixels = static_cast<std::size_t>(plot_right - plot_left);
    const std::size_t buckets =
        std::min(pixels, greatest_point_count / (4 * (timeline_.curves.size() + 1)) + 1);
    std::vector<Polyline> lines(1);
    std::size_t previous = 0;
    for (const std::size_t i : decimated(timeline_.times, values, buckets)) {
      if (!lines.back().points.empty() && gap_between(values, previous, i, buckets)) lines.emplace_back();
      lines.back().points.push_back(to_page(timeline_.times[i], values[i]));
      previous = i;
    }
    for (Polyline& line : lines) {
      if (line.points.size() == 1) line.points.push_back({line.points[0].x + 1.0, line.points[0].y});
      line = simplified(line, 0.05);
    }
    return lines;
  }

  bool gap_between(const std::vector<double>& values, std::size_t from, std::size_t to,
                   std::size_t buckets) const {
    const std::size_t from_bucket = bucket_of(timeline_.times[from], first_, last_, buckets);
    const std::size_t to_bucket = bucket_of(timeline_.times[to], first_, last_, buckets);
    if (to_bucket <= from_bucket + 1) return false;
    for (std::size_t i = from + 1; i < to; ++i) {
      if (!std::isfinite(values[i])) return true;
    }
    return false;
  }

  void draw_clearances(SvgDocument& document) const {
    document.begin_group("clearances");
    draw_panel_name(document, clearance_panel_, "clearance (m)");
    draw_value_axis(document, clearance_panel_, clearance_bottom_, clearance_top_, 8);
    draw_thresholds(document);
    document.begin_clipped_group("curves", clearance_panel_);
    for (std::size_t i = 0; i < timeline_.curves.size(); ++i) {
      document.path(series(timeline_.curves[i].clearances,
                           [this](double time, double value) {
                             const double shown =
                                 std::clamp(value, clearance_bottom_ - clearance_top_, 2.0 * clearance_top_);
                             return Point{x_of(time), y_of_clearance(shown)};
                           }),
                    curve_style(i));
    }
    document.end_group();
    document.rectangle(clearance_panel_, stroked(palette::frame, 1.0));
    document.end_group();
  }

  void draw_thresholds(SvgDocument& document) const {
    std::vector<TimelineThreshold> shown;
    for (const TimelineThreshold& threshold : timeline_.thresholds) {
      if (threshold.clearance >= clearance_bottom_ && threshold.clearance <= clearance_top_) {
        shown.push_back(threshold);
      }
    }
    std::stable_sort(shown.begin(), shown.end(), [](const TimelineThreshold& a, const TimelineThreshold& b) {
      return a.clearance > b.clearance;
    });
    std::vector<double> wanted;
    for (const TimelineThreshold& threshold : shown) wanted.push_back(y_of_clearance(threshold.clearance));
    const std::vector<double> placed =
        spread_apart(wanted, 16.0, clearance_panel_.top + 6.0, clearance_panel_.bottom() - 4.0);
    for (std::size_t i = 0; i < shown.size(); ++i) {
      document.line({plot_left, wanted[i]}, {plot_right, wanted[i]},
                    stroked(palette::quiet_ink, 1.3, {6.0, 4.0}));
      document.line({plot_right, wanted[i]}, {plot_right + 8.0, placed[i]}, stroked(palette::quiet_ink, 1.0));
      document.text({plot_right + 12.0, placed[i] + 0.36 * font::small},
                    shown[i].name + " " + short_text(shown[i].clearance, 3) + " m",
                    label(font::small, TextAnchor::start));
    }
  }

  void draw_zones(SvgDocument& document) {
    document.begin_group("zones");
    draw_panel_name(document, zone_panel_, "zone");
    const std::size_t buckets = static_cast<std::size_t>(plot_right - plot_left);
    std::vector<Zone> columns(buckets, Zone::free);
    for (std::size_t i = 0; i < timeline_.times.size(); ++i) {
      const std::size_t from = bucket_of(timeline_.times[i], first_, last_, buckets);
      const bool is_last = i + 1 == timeline_.times.size();
      const std::size_t to =
          is_last ? buckets - 1 : bucket_of(timeline_.times[i + 1], first_, last_, buckets);
      for (std::size_t column = from; column <= to; ++column) {
        const bool shared = column == to && to > from && !is_last;
        if (!shared) columns[column] = std::max(columns[column], timeline_.zones[i]);
      }
    }
    for (const Zone zone : every_zone) draw_zone_runs(document, columns, zone);
    draw_zone_key(document);
    document.rectangle(zone_panel_, stroked(palette::frame, 1.0));
    document.end_group();
  }

  static TextStyle zone_name_style(Zone zone) {
    TextStyle style = label(font::small, TextAnchor::middle);
    style.bold = zone == Zone::stop;
    style.halo = 2.5;
    style.halo_fill = palette::zone_fill(zone);
    return style;
  }

  void draw_zone_runs(SvgDocument& document, const std::vector<Zone>& columns, Zone zone) {
    std::vector<Polyline> areas;
    const double name_width = text_width(zone_name(zone), zone_name_style(zone)) + 4.0;
    for (std::size_t from = 0, to = 0; from < columns.size(); from = to) {
      while (to < columns.size() && columns[to] == columns[from]) ++to;
      if (columns[from] != zone) continue;
      const double left = plot_left + static_cast<double>(from);
      const double right = plot_left + static_cast<double>(to);
      areas.push_back({{{left, zone_panel_.top},
                        {right, zone_panel_.top},
                        {right, zone_panel_.bottom()},
                        {left, zone_panel_.bottom()}},
                       true});
      const Point room = widest_between_markers(left, right);
      if (room.y - room.x > name_width) {
        zone_names_.push_back({(room.x + room.y) / 2.0, zone});
      } else if (right - left > name_width) {
        zone_names_.push_back({(left + right) / 2.0, zone});
      }
    }
    document.path(areas, filled(palette::zone_fill(zone)));
  }

  void draw_zone_key(SvgDocument& document) const {
    double chip_top = zone_panel_.top - 9.0;
    for (const Zone zone : every_zone) {
      document.rectangle({plot_right + 12.0, chip_top, 16.0, 13.0},
                         filled_and_stroked(palette::zone_fill(zone), palette::frame, 0.8), 2.0);
      document.text({plot_right + 34.0, chip_top + 11.0}, zone_name(zone),
                    label(font::small, TextAnchor::start));
      chip_top += 18.0;
    }
  }

  /// Names stand above the markers' lines, off them where there is room.
  void draw_zone_names(SvgDocument& document) const {
    document.begin_group("zone-names");
    for (const ZoneName& name : zone_names_) {
      document.text({name.centre, zone_panel_.top + zone_height / 2.0 + 0.36 * font::small},
                    zone_name(name.zone), zone_name_style(name.zone));
    }
    document.end_group();
  }

  /// The widest stretch (from x to y) of [left, right] without a marker's line.
  Point widest_between_markers(double left, double right) const {
    std::vector<double> cuts{left, right};
    for (const TimelineMarker& marker : timeline_.markers) {
      const double x = x_of(marker.time);
      if (x > left && x < right) cuts.push_back(x);
    }
    std::sort(cuts.begin(), cuts.end());
    Point widest{left, left};
    for (std::size_t i = 1; i < cuts.size(); ++i) {
      if (cuts[i] - cuts[i - 1] > widest.y - widest.x + 1e-9) widest = {cuts[i - 1], cuts[i]};
    }
    return widest;
  }

  void draw_override(SvgDocument& document) const {
    document.begin_group("speed-override");
    draw_panel_name(document, override_panel_, "override");
    draw_value_axis(document, override_panel_, 0.0, 1.0, 3);
    std::vector<Polyline> lines = series(timeline_.speed_override, [this](double time, double value) {
      return Point{x_of(time),
                   override_panel_.bottom() - std::clamp(value, 0.0, 1.0) * override_panel_.height};
    });
    for (const Polyline& line : lines) {
      if (line.points.empty()) continue;
      Polyline area = line;
      area.points.push_back({line.points.back().x, override_panel_.bottom()});
      area.points.push_back({line.points.front().x, override_panel_.bottom()});
      area.closed = true;
      document.path({area}, filled(palette::curve[0], 0.14));
    }
    document.path(lines, stroked(palette::curve[0], 1.8));
    document.rectangle(override_panel_, stroked(palette::frame, 1.0));
    document.text({plot_right + 12.0, override_panel_.top + 5.0}, "1 full speed",
                  label(font::small, TextAnchor::start, palette::quiet_ink));
    document.text({plot_right + 12.0, override_panel_.bottom() + 4.0}, "0 standstill",
                  label(font::small, TextAnchor::start, palette::quiet_ink));
    document.end_group();
  }

  void draw_markers(SvgDocument& document) const {
    std::vector<TimelineMarker> shown;
    for (const TimelineMarker& marker : timeline_.markers) {
      if (marker.time >= first_ && marker.time <= last_) shown.push_back(marker);
    }
    std::stable_sort(shown.begin(), shown.end(),
                     [](const TimelineMarker& a, const TimelineMarker& b) { return a.time < b.time; });
    std::vector<double> wanted;
    for (const TimelineMarker& marker : shown) wanted.push_back(x_of(marker.time));
    const std::vector<double> placed = spread_apart(wanted, 2.0 * marker_radius + 3.0, plot_left, plot_right);
    document.begin_group("markers");
    TextStyle letter = label(font::small, TextAnchor::middle, palette::paper);
    letter.bold = true;
    for (std::size_t i = 0; i < shown.size(); ++i) {
      const ShapeStyle thin = stroked(palette::ink, 1.0, {2.0, 3.0});
      document.line({wanted[i], clearance_panel_.top}, {wanted[i], override_panel_.bottom()}, thin);
      document.line({placed[i], marker_centre_ + marker_radius}, {wanted[i], clearance_panel_.top},
                    stroked(palette::ink, 1.0));
      document.circle({placed[i], marker_centre_}, marker_radius, filled(palette::ink));
      document.text({placed[i], marker_centre_ + 0.36 * font::small}, shown[i].letter, letter);
    }
    document.end_group();
  }

  struct ZoneName {
    double centre;
    Zone zone;
  };

  const Timeline& timeline_;
  double first_;
  double last_;
  std::vector<LegendEntry> legend_;
  double legend_top_ = 0.0;
  double marker_centre_ = 0.0;
  Rectangle clearance_panel_;
  Rectangle zone_panel_;
  Rectangle override_panel_;
  double clearance_bottom_ = 0.0;
  double clearance_top_ = 1.0;
  std::vector<ZoneName> zone_names_;
};

}  // namespace

std::string timeline_svg(const Timeline& timeline) {
  check(timeline);
  return TimelineChart(timeline).svg();
}

}  // namespace nearfield::host::draw
