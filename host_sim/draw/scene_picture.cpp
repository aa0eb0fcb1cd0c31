#include "draw/scene_picture.hpp"

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "draw/legend.hpp"
#include "draw/number_text.hpp"
#include "draw/scene_panel.hpp"
#include "draw/svg.hpp"

namespace nearfield::host::draw {
namespace {

constexpr double page_width = 1000.0;
constexpr double border = 14.0;
constexpr double between_panels = 18.0;
constexpr double line_height = 20.0;

void check(const ScenePicture& picture) {
  for (const WorldWindow& w : {picture.top.window, picture.side.window}) {
    const bool finite =
        std::isfinite(w.left) && std::isfinite(w.right) && std::isfinite(w.bottom) && std::isfinite(w.top);
    if (!finite || !(w.left < w.right) || !(w.bottom < w.top)) {
      throw std::invalid_argument("draw: the window of a view must be finite and not empty");
    }
  }
  if (!std::isfinite(picture.contour_spacing) || !(picture.contour_spacing > 0.0) ||
      picture.contour_count > 40 || picture.labelled_every < 1) {
    throw std::invalid_argument(
        "draw: contours need a spacing above zero, at most 40 lines, labels every 1 or more");
  }
}

std::string caption(const ScenePicture& picture) {
  std::string text = "Time " + fixed_text(picture.time, 2) + " s. Zone: " + zone_name(picture.zone) +
                     ". Speed override " + fixed_text(picture.speed_override * 100.0, 0) + "\u00A0%.";
  for (std::size_t i = 0; i < picture.clearances.size(); ++i) {
    const NamedClearance& entry = picture.clearances[i];
    text += i == 0 ? " Clearance " : (i + 1 == picture.clearances.size() ? " and " : ", ");
    text += entry.to + ' ' + (std::isfinite(entry.clearance) ? length_text(entry.clearance) : "unknown");
    if (i + 1 == picture.clearances.size()) text += '.';
  }
  if (!picture.note.empty()) text += ' ' + picture.note;
  return text;
}

std::vector<LegendEntry> legend(const ScenePicture& picture) {
  std::vector<LegendEntry> entries;
  if (!picture.top.field.values.empty() || !picture.side.field.values.empty()) {
    ShapeStyle inside = scene_style::solid();
    inside.stroke = palette::surface;
    inside.stroke_width = 2.0;
    entries.push_back({picture.field_name + " (cut)", LegendSymbol::patch, inside});
    entries.push_back({"contour every " + length_text(picture.contour_spacing), LegendSymbol::line,
                       stroked(palette::contour, 1.4)});
  }
  if (!picture.arm.empty()) entries.push_back({"robot arm", LegendSymbol::patch, scene_style::arm()});
  if (!picture.joints.empty()) entries.push_back({"joint", LegendSymbol::dot, scene_style::joint()});
  if (!picture.person.empty()) entries.push_back({"person", LegendSymbol::patch, scene_style::person()});
  if (!picture.tool_path.empty()) {
    entries.push_back({"tool path so far", LegendSymbol::line, scene_style::tool_path()});
  }
  if (picture.nearest) {
    entries.push_back({"nearest pair", LegendSymbol::dumbbell, scene_style::nearest()});
    entries.push_back({"direction away", LegendSymbol::arrow, stroked(palette::nearest, 2.2)});
  }
  if (picture.repulsion) entries.push_back({"repulsion", LegendSymbol::arrow, scene_style::repulsion()});
  return entries;
}

/// Title at the left, after the letter in its disc; the zone in a chip at the right.
void draw_header(SvgDocument& document, const ScenePicture& picture) {
  document.begin_group("header");
  double left = border;
  if (!picture.letter.empty()) {
    TextStyle letter;
    letter.size = font::heading;
    letter.fill = palette::paper;
    letter.anchor = TextAnchor::middle;
    letter.bold = true;
    document.circle({left + 13.0, 24.0}, 13.0, filled(palette::ink));
    document.text({left + 13.0, 24.0 + 0.36 * letter.size}, picture.letter, letter);
    left += 36.0;
  }
  TextStyle title;
  title.size = font::title;
  title.bold = true;
  document.text({left, 24.0 + 0.36 * title.size}, picture.title, title);
  const std::string state = std::string(zone_name(picture.zone)) + " \u00B7 speed " +
                            fixed_text(picture.speed_override * 100.0, 0) + "\u00A0%";
  TextStyle chip;
  chip.size = font::body;
  chip.anchor = TextAnchor::middle;
  chip.bold = true;
  const double width = text_width(state, chip) + 22.0;
  document.rectangle({page_width - border - width, 11.0, width, 26.0},
                     filled_and_stroked(palette::zone_fill(picture.zone), palette::frame, 0.8), 13.0);
  document.text({page_width - border - width / 2.0, 24.0 + 0.36 * chip.size}, state, chip);
  document.end_group();
}

}  // namespace

std::string scene_picture_svg(const ScenePicture& picture) {
  check(picture);
  const WorldWindow& top = picture.top.window;
  const WorldWindow& side = picture.side.window;
  const double room = page_width - 2.0 * border - 2.0 * PanelMargin::left - between_panels;
  const double scale = room / ((top.right - top.left) + (side.right - side.left));
  const double top_height = (top.top - top.bottom) * scale;
  const double side_height = (side.top - side.bottom) * scale;
  const double panels_top = 44.0 + PanelMargin::top;
  const double panels_bottom = panels_top + std::max(top_height, side_height);

  const WorldToPage top_to_page(top, {border + PanelMargin::left, panels_bottom - top_height}, scale);
  const double side_left = top_to_page.frame().right() + between_panels + PanelMargin::left;
  const WorldToPage side_to_page(side, {side_left, panels_bottom - side_height}, scale);

  const std::vector<LegendEntry> entries = legend(picture);
  const double text_width_available = page_width - 2.0 * border;
  const double legend_top = panels_bottom + PanelMargin::bottom + 6.0;
  const double caption_top = legend_top + legend_height(entries, text_width_available) + 8.0;
  const TextStyle caption_style;
  const std::string words = caption(picture);
  const std::vector<std::string> lines = wrapped(words, caption_style, text_width_available);

  SvgDocument document(page_width, caption_top + line_height * static_cast<double>(lines.size()) + 10.0,
                       picture.title.empty() ? "Robot cell" : picture.title, words, picture.id_prefix);
  draw_header(document, picture);
  draw_scene_panel(document, picture, ViewDirection::top, top_to_page);
  draw_scene_panel(document, picture, ViewDirection::side, side_to_page);
  draw_legend(document, entries, {border, legend_top}, text_width_available);
  document.begin_group("caption");
  for (std::size_t i = 0; i < lines.size(); ++i) {
    document.text({border, caption_top + 15.0 + line_height * static_cast<double>(i)}, lines[i],
                  caption_style);
  }
  document.end_group();
  return document.finish();
}

}  // namespace nearfield::host::draw
