#include "draw/scene_panel.hpp"

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

#include "draw/axis.hpp"
#include "draw/contour.hpp"
#include "draw/label_placer.hpp"
#include "draw/number_text.hpp"

namespace nearfield::host::draw {

namespace scene_style {
ShapeStyle solid() { return filled(palette::solid); }
ShapeStyle surface() { return stroked(palette::surface, 2.4); }
ShapeStyle contour() { return stroked(palette::contour, 0.9); }
ShapeStyle arm() { return filled_and_stroked(palette::arm, palette::arm_outline, 1.2, 0.92); }
ShapeStyle joint() { return filled_and_stroked(palette::ink, palette::paper, 1.0); }
ShapeStyle person() { return filled_and_stroked(palette::person, palette::person_outline, 1.2, 0.92); }
ShapeStyle nearest() { return stroked(palette::nearest, 3.0); }
ShapeStyle repulsion() { return stroked(palette::repulsion, 3.0); }
ShapeStyle tool_path() { return stroked(palette::tool_path, 1.3); }
}  // namespace scene_style

namespace {

constexpr double contour_label_size = 11.5;
constexpr double clearance_label_size = 15.0;
constexpr double away_arrow_length = 30.0;

double length_of(Point v) { return std::sqrt(v.x * v.x + v.y * v.y); }

/// "#RRGGBB" between two others; share 0 gives `from`, 1 gives `to`.
std::string mixed_colour(const std::string& from, const std::string& to, double share) {
  const char* digits = "0123456789ABCDEF";
  std::string colour = "#";
  for (std::size_t channel = 1; channel < 7; channel += 2) {
    const double a = std::stoi(from.substr(channel, 2), nullptr, 16);
    const double b = std::stoi(to.substr(channel, 2), nullptr, 16);
    const auto level = static_cast<unsigned>(a + (b - a) * share + 0.5);
    colour += digits[level / 16];
    colour += digits[level % 16];
  }
  return colour;
}

class ScenePanel {
 public:
  ScenePanel(SvgDocument& document, const ScenePicture& picture, ViewDirection direction,
             const WorldToPage& to_page)
      : document_(document),
        picture_(picture),
        view_(direction == ViewDirection::top ? picture.top : picture.side),
        direction_(direction),
        to_page_(to_page),
        frame_(to_page.frame()),
        labels_(Rectangle{frame_.left + 3.0, frame_.top + 3.0, frame_.width - 6.0, frame_.height - 6.0}) {}

  void draw() {
    document_.begin_group(direction_ == ViewDirection::top ? "top-view" : "side-view");
    block_contents();
    const Rectangle scale_bar = place_scale_bar();
    const std::optional<Point> clearance_label = place_clearance_label();
    document_.begin_clipped_group("scene", frame_);
    draw_field();
    draw_tool_path();
    draw_bodies();
    draw_repulsion();
    draw_nearest(clearance_label);
    draw_scale_bar(scale_bar);
    document_.end_group();
    draw_frame();
    document_.end_group();
  }

 private:
  struct Body {
    PictureCapsule capsule;
    bool is_arm = false;
    double depth = 0.0;  ///< greater: nearer to the viewer
  };

  Point plane(const Vec3& p) const { return {p[0], direction_ == ViewDirection::top ? p[1] : p[2]}; }
  Point page(const Vec3& p) const { return to_page_(plane(p)); }
  /// The top view is seen from above, the side view from the side of negative y.
  double depth(const Vec3& p) const { return direction_ == ViewDirection::top ? p[2] : -p[1]; }

  // -- what labels must keep off ----------------------------------------------------------------------------

  void block_contents() {
    for (const auto* bodies : {&picture_.arm, &picture_.person}) {
      for (const PictureCapsule& c : *bodies) {
        labels_.block(page(c.start), page(c.end), to_page_.pixels(c.radius) + 2.0);
      }
    }
    if (picture_.nearest) {
      labels_.block(page(picture_.nearest->on_robot), page(picture_.nearest->on_other), 7.0);
      labels_.block(page(picture_.nearest->on_robot), away_arrow_tip(), 7.0);
    }
    if (picture_.repulsion) labels_.block(page(picture_.repulsion->at), repulsion_tip(), 8.0);
    const Polyline path = tool_path();
    for (std::size_t i = 1; i < path.points.size(); ++i)
      labels_.block(path.points[i - 1], path.points[i], 1.5);
    if (!view_.field.values.empty()) {
      for (const Polyline& line : on_page(contour_lines(view_.field, 0.0))) {
        for (std::size_t i = 1; i < line.points.size(); ++i)
          labels_.block(line.points[i - 1], line.points[i], 2.5);
        if (line.closed) labels_.block(line.points.back(), line.points.front(), 2.5);
      }
    }
  }

  // -- field
  // --------------------------------------------------------------------------------------------------

  void draw_field() {
    if (view_.field.values.empty()) return;
    const double spacing = picture_.contour_spacing;
    document_.begin_group("field");
    const std::size_t count = picture_.contour_count;
    for (std::size_t band = count; band > 0; --band) {
      const double share = static_cast<double>(band - 1) / static_cast<double>(count);
      document_.path(on_page(filled_region(view_.field, static_cast<double>(band) * spacing)),
                     filled(mixed_colour(palette::band_near, palette::band_far, share)));
    }
    document_.path(on_page(filled_region(view_.field, 0.0)), scene_style::solid());
    std::vector<std::vector<Polyline>> lines;
    for (std::size_t k = 1; k <= count; ++k) {
      lines.push_back(on_page(contour_lines(view_.field, static_cast<double>(k) * spacing)));
      document_.path(lines.back(), scene_style::contour());
    }
    document_.path(on_page(contour_lines(view_.field, 0.0)), scene_style::surface());
    for (std::size_t k = picture_.labelled_every; k <= count; k += picture_.labelled_every) {
      draw_contour_label(lines[k - 1], static_cast<double>(k) * spacing);
    }
    document_.end_group();
  }

  std::vector<Polyline> on_page(const std::vector<Polyline>& lines) const {
    std::vector<Polyline> result;
    for (const Polyline& line : lines) result.push_back(simplified(to_page_(line), 0.06));
    return result;
  }

  /// A label on the straightest free stretch of a level's lines, along the line and never upside down.
  void draw_contour_label(const std::vector<Polyline>& lines, double level) {
    TextStyle style;
    style.size = contour_label_size;
    style.fill = palette::quiet_ink;
    style.halo = 2.0;
    const std::string text = short_text(level, 3) + " m";
    const double width = text_width(text, style);
    double least_cost = 1e30;
    Point best_centre;
    Point best_direction;
    for (const Polyline& line : lines) {
      const std::vector<Point> points = evenly_spaced(line, 6.0);
      const auto half = static_cast<std::size_t>(width / 12.0) + 1;
      for (std::size_t i = half; i + half < points.size(); i += 2) {
        const Point a = points[i - half];
        const Point b = points[i + half];
        Point along{b.x - a.x, b.y - a.y};
        const double chord = length_of(along);
        if (chord < 0.9 * width) continue;
        const Point middle{(a.x + b.x) / 2.0, (a.y + b.y) / 2.0};
        const double bulge = length_of({points[i].x - middle.x, points[i].y - middle.y});
        if (along.x < 0.0 || (along.x < 1e-6 && along.y > 0.0)) along = {-along.x, -along.y};
        const double steepness = std::fabs(along.y) / chord;
        const double cost = bulge * 3.0 + steepness * 12.0;
        if (cost >= least_cost || !labels_.is_free(around(points[i], along, width, style.size))) continue;
        least_cost = cost;
        best_centre = points[i];
        best_direction = along;
      }
    }
    if (least_cost > 1e29) return;
    labels_.block(around(best_centre, best_direction, width + 14.0, style.size + 6.0));
    document_.text_along(best_centre, best_direction, text, style);
  }

  static Rectangle around(Point centre, Point direction, double width, double height) {
    const double length = length_of(direction);
    const double c = std::fabs(direction.x) / length;
    const double s = std::fabs(direction.y) / length;
    const double w = c * width + s * height;
    const double h = s * width + c * height;
    return {centre.x - w / 2.0, centre.y - h / 2.0, w, h};
  }

  static std::vector<Point> evenly_spaced(const Polyline& line, double step) {
    std::vector<Point> source = line.points;
    if (line.closed && !source.empty()) source.push_back(source.front());
    std::vector<Point> points;
    double until_next = 0.0;
    for (std::size_t i = 1; i < source.size(); ++i) {
      const Point a = source[i - 1];
      const Point delta{source[i].x - a.x, source[i].y - a.y};
      const double length = length_of(delta);
      double at = until_next;
      for (; at < length; at += step)
        points.push_back({a.x + delta.x * (at / length), a.y + delta.y * (at / length)});
      until_next = at - length;
    }
    return points;
  }

  // -- things in the scene
  // ------------------------------------------------------------------------------------

  Polyline tool_path() const {
    Polyline path;
    for (const Vec3& p : picture_.tool_path) {
      const Point at = page(p);
      const bool moved =
          path.points.empty() || length_of({at.x - path.points.back().x, at.y - path.points.back().y}) >= 0.3;
      if (moved) path.points.push_back(at);
    }
    return simplified(path, 0.15);
  }

  void draw_tool_path() {
    document_.begin_group("tool-path");
    document_.path({tool_path()}, scene_style::tool_path());
    document_.end_group();
  }

  void draw_bodies() {
    std::vector<Body> bodies;
    for (const PictureCapsule& c : picture_.arm) bodies.push_back({c, true, depth(c.start) + depth(c.end)});
    for (const PictureCapsule& c : picture_.person)
      bodies.push_back({c, false, depth(c.start) + depth(c.end)});
    std::stable_sort(bodies.begin(), bodies.end(),
                     [](const Body& a, const Body& b) { return a.depth < b.depth; });
    document_.begin_group("bodies");
    for (const Body& body : bodies) {
      document_.stadium(page(body.capsule.start), page(body.capsule.end),
                        to_page_.pixels(body.capsule.radius),
                        body.is_arm ? scene_style::arm() : scene_style::person());
    }
    for (const Vec3& joint : picture_.joints) document_.circle(page(joint), 3.4, scene_style::joint());
    document_.end_group();
  }

  Point repulsion_tip() const {
    const Vec3& at = picture_.repulsion->at;
    const Vec3& v = picture_.repulsion->vector;
    return page({at[0] + v[0], at[1] + v[1], at[2] + v[2]});
  }

  void draw_repulsion() {
    if (!picture_.repulsion) return;
    document_.begin_group("repulsion");
    const Point from = page(picture_.repulsion->at);
    document_.arrow(from, repulsion_tip(), palette::repulsion, 3.4);
    document_.end_group();
  }

  Point away_arrow_tip() const {
    const NearestPair& pair = *picture_.nearest;
    Vec3 away = pair.away;
    if (away[0] == 0.0 && away[1] == 0.0 && away[2] == 0.0) {
      for (std::size_t i = 0; i < 3; ++i) away[i] = pair.on_robot[i] - pair.on_other[i];
    }
    const double length = std::sqrt(away[0] * away[0] + away[1] * away[1] + away[2] * away[2]);
    const Point from = page(pair.on_robot);
    if (!(length > 0.0)) return from;
    const Point along = plane(away);
    return {from.x + along.x / length * away_arrow_length, from.y - along.y / length * away_arrow_length};
  }

  static TextStyle clearance_style() {
    TextStyle style;
    style.size = clearance_label_size;
    style.fill = palette::nearest;
    style.anchor = TextAnchor::middle;
    style.bold = true;
    style.halo = 3.0;
    return style;
  }

  std::optional<Point> place_clearance_label() {
    if (!picture_.nearest) return std::nullopt;
    const Point a = page(picture_.nearest->on_robot);
    const Point b = page(picture_.nearest->on_other);
    const Point middle{(a.x + b.x) / 2.0, (a.y + b.y) / 2.0};
    const double width = text_width(length_text(picture_.nearest->clearance), clearance_style()) + 4.0;
    const double height = clearance_label_size + 10.0;
    // Sixteen directions on the border of growing rectangles around the middle of the pair.
    static constexpr Point directions[] = {{1, 0},    {-1, 0},    {0, -1},   {0, 1},     {1, -1},  {-1, -1},
                                           {1, 1},    {-1, 1},    {1, -0.5}, {-1, -0.5}, {1, 0.5}, {-1, 0.5},
                                           {0.5, -1}, {-0.5, -1}, {0.5, 1},  {-0.5, 1}};
    std::vector<Point> centres;
    for (double reach = 8.0; reach < 160.0; reach += 6.0) {
      for (const Point& d : directions) {
        centres.push_back({middle.x + d.x * (width / 2.0 + reach), middle.y + d.y * (height / 2.0 + reach)});
      }
    }
    return labels_.place(centres, width, height);
  }

  void draw_nearest(const std::optional<Point>& label) {
    if (!picture_.nearest) return;
    const Point a = page(picture_.nearest->on_robot);
    const Point b = page(picture_.nearest->on_other);
    document_.begin_group("nearest");
    document_.line(a, b, stroked(palette::paper, 6.0));
    document_.arrow(a, away_arrow_tip(), palette::nearest, 2.2);
    document_.line(a, b, scene_style::nearest());
    for (const Point& end : {a, b}) {
      document_.circle(end, 4.2, filled_and_stroked(palette::nearest, palette::paper, 1.2));
    }
    if (label) {
      const Point middle{(a.x + b.x) / 2.0, (a.y + b.y) / 2.0};
      draw_leader(middle, *label);
      document_.text({label->x, label->y + 0.36 * clearance_label_size},
                     length_text(picture_.nearest->clearance), clearance_style());
    }
    document_.end_group();
  }

  /// A thin line from the pair to its label when they are far apart.
  void draw_leader(Point middle, Point label) {
    const Point delta{label.x - middle.x, label.y - middle.y};
    if (length_of(delta) < 62.0) return;
    const double half_width =
        text_width(length_text(picture_.nearest->clearance), clearance_style()) / 2.0 + 2.0;
    const double half_height = clearance_label_size / 2.0 + 1.0;
    const double share = std::min(std::fabs(delta.x) > 0.0 ? half_width / std::fabs(delta.x) : 1.0,
                                  std::fabs(delta.y) > 0.0 ? half_height / std::fabs(delta.y) : 1.0);
    document_.line(middle, {label.x - delta.x * share, label.y - delta.y * share},
                   stroked(palette::nearest, 1.0));
  }

  // -- frame, axes, scale
  // -------------------------------------------------------------------------------------

  double scale_bar_metres() const {
    double metres = 0.001;
    for (const Tick& tick : round_ticks(0.0, (view_.window.right - view_.window.left) / 4.0, 3)) {
      if (tick.value > 0.0) metres = tick.value;
    }
    return metres;
  }

  /// Room for the scale bar in the first free corner, or in the upper right one when all are taken.
  Rectangle place_scale_bar() {
    const double width = to_page_.pixels(scale_bar_metres()) + 16.0;
    const double height = 34.0;
    const double left = frame_.left + 8.0;
    const double right = frame_.right() - 8.0 - width;
    const double top = frame_.top + 8.0;
    const double bottom = frame_.bottom() - 8.0 - height;
    for (const Point corner : {Point{right, top}, {left, top}, {right, bottom}, {left, bottom}}) {
      const Rectangle area{corner.x, corner.y, width, height};
      if (!labels_.is_free(area)) continue;
      labels_.block(area);
      return area;
    }
    return {right, top, width, height};
  }

  void draw_scale_bar(const Rectangle& area) {
    const Point left{area.left + 8.0, area.bottom() - 9.0};
    const Point right{area.right() - 8.0, left.y};
    document_.begin_group("scale-bar");
    document_.rectangle(area, filled(palette::paper, 0.85), 3.0);
    document_.path({Polyline{{{left.x, left.y - 5.0}, left, right, {right.x, right.y - 5.0}}, false}},
                   stroked(palette::ink, 1.6));
    TextStyle style;
    style.size = font::small;
    style.anchor = TextAnchor::middle;
    document_.text({(left.x + right.x) / 2.0, left.y - 7.0}, length_text(scale_bar_metres()), style);
    document_.end_group();
  }

  void draw_frame() {
    document_.begin_group("axes");
    TextStyle style;
    style.size = font::small;
    style.anchor = TextAnchor::middle;
    const WorldWindow& w = view_.window;
    const auto ticks_for = [](double pixels) {
      return static_cast<std::size_t>(std::max(2.0, pixels / 48.0));
    };
    for (const Tick& tick : round_ticks(w.left, w.right, ticks_for(frame_.width))) {
      const double x = to_page_({tick.value, w.bottom}).x;
      document_.line({x, frame_.bottom()}, {x, frame_.bottom() + 4.0}, stroked(palette::frame, 1.0));
      document_.text({x, frame_.bottom() + 17.0}, tick.text, style);
    }
    style.anchor = TextAnchor::end;
    for (const Tick& tick : round_ticks(w.bottom, w.top, ticks_for(frame_.height))) {
      const double y = to_page_({w.left, tick.value}).y;
      document_.line({frame_.left - 4.0, y}, {frame_.left, y}, stroked(palette::frame, 1.0));
      document_.text({frame_.left - 7.0, y + 0.36 * font::small}, tick.text, style);
    }
    style.anchor = TextAnchor::middle;
    document_.text({frame_.left + frame_.width / 2.0, frame_.bottom() + 34.0}, "x (m)", style);
    document_.text_along({frame_.left - 37.0, frame_.top + frame_.height / 2.0}, {0.0, -1.0},
                         direction_ == ViewDirection::top ? "y (m)" : "z (m)", style);
    document_.rectangle(frame_, stroked(palette::frame, 1.0));
    TextStyle heading;
    heading.size = font::heading;
    heading.bold = true;
    document_.text({frame_.left, frame_.top - 10.0}, view_.title, heading);
    document_.end_group();
  }

  SvgDocument& document_;
  const ScenePicture& picture_;
  const SceneView& view_;
  ViewDirection direction_;
  const WorldToPage& to_page_;
  Rectangle frame_;
  LabelPlacer labels_;
};

}  // namespace

void draw_scene_panel(SvgDocument& document, const ScenePicture& picture, ViewDirection direction,
                      const WorldToPage& to_page) {
  ScenePanel(document, picture, direction, to_page).draw();
}

}  // namespace nearfield::host::draw
