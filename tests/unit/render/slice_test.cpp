// Slices: contours at even spacing where they belong, planes, pictures of both kinds.
#include "render/slice.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "draw/contour.hpp"
#include "draw/svg.hpp"
#include "render/view.hpp"
#include "unit/draw/well_formed.hpp"
#include "unit/render/scene_text.hpp"

namespace nearfield::host {
namespace {

SliceSettings settings_for(const SceneField& field, unsigned axis, double value) {
  SliceSettings settings;
  settings.width = 240;
  settings.height = 200;
  settings.threads = 1;
  settings.plane = coordinate_plane(axis, value);
  frame_surface(surface_box(field, domain_box(field)), settings);
  return settings;
}

TEST(Slice, ContoursOfAPlaneAreEven) {
  const auto field = field_of_text(R"({"type": "half_space", "normal": [0, 0, 2], "position": [0, 0, 0.1]})");
  SliceSettings settings = settings_for(*field, 1, 0.0);
  settings.middle_u = 0.0;
  settings.middle_v = 0.1;
  settings.width_metres = 1.0;
  settings.spacing = 0.05;
  const draw::SlicePicture picture = slice_of(*field, settings, "plane");
  EXPECT_EQ(picture.axis_u, "x (m)");
  EXPECT_EQ(picture.axis_v, "z (m)");
  EXPECT_EQ(picture.note, "distance; y = 0 m; contours every 0.05 m");
  EXPECT_GE(picture.outer_count, 5);
  EXPECT_GE(picture.inner_count, 5);
  for (int k = -picture.inner_count; k <= picture.outer_count; ++k) {
    const auto lines = draw::contour_lines(picture.field, k * picture.spacing);
    ASSERT_EQ(lines.size(), 1U) << k;
    for (const draw::Point& p : lines[0].points) ASSERT_NEAR(p.y, 0.1 + 0.05 * k, 1e-7) << k;
  }
}

TEST(Slice, EveryKindIsBelowZeroInside) {
  for (const std::string& text : {ball_text, soft_text, ray_text, torus_text}) {
    const auto field = field_of_text(text);
    const draw::SlicePicture picture = slice_of(*field, settings_for(*field, 2, 0.0), "");
    std::size_t inside = 0;
    for (std::size_t row = 0; row < picture.field.rows; ++row) {
      for (std::size_t column = 0; column < picture.field.columns; ++column) {
        const draw::Point at = picture.field.position(column, row);
        const bool below = picture.field.value(column, row) < 0.0;
        ASSERT_EQ(below, field->inside({at.x, at.y, 0.0})) << text;
        inside += below ? 1U : 0U;
      }
    }
    EXPECT_GT(inside, picture.field.values.size() / 20) << text;
    EXPECT_GT(picture.spacing, 0.0);
  }
}

TEST(Slice, PlanesAreRightHanded) {
  const Plane plane = plane_through({0.1, 0.2, 0.3}, {0.0, -2.0, 0.0});
  EXPECT_LT(length(plane.u - Vector3d{1.0, 0.0, 0.0}), 1e-12);
  EXPECT_LT(length(plane.v - Vector3d{0.0, 0.0, 1.0}), 1e-12);
  const Plane above = plane_through({}, {0.0, 0.0, 1.0});
  EXPECT_LT(length(above.u - Vector3d{1.0, 0.0, 0.0}), 1e-12);
  EXPECT_LT(length(above.v - Vector3d{0.0, 1.0, 0.0}), 1e-12);
  const Plane slanting = plane_through({}, {1.0, 2.0, 3.0});
  EXPECT_LT(length(cross(slanting.u, slanting.v) - normalised({1.0, 2.0, 3.0})), 1e-12);
}

TEST(Slice, PicturesOfBothKinds) {
  const auto field = field_of_text(soft_text);
  for (const bool layers : {false, true}) {
    SliceSettings settings = settings_for(*field, 2, 0.05);
    settings.layers = layers;
    settings.slopes = true;
    const draw::SlicePicture picture = slice_of(*field, settings, "a < b & c");
    EXPECT_FALSE(picture.slopes.empty());
    EXPECT_EQ(draw::xml_fault(draw::slice_svg(picture)), "");
    EXPECT_EQ(draw::slice_svg(picture), draw::slice_svg(picture));
    const draw::RgbImage image = draw::slice_image(picture);
    EXPECT_EQ(image.width, 240U);
    EXPECT_EQ(image.height, 200U);
    settings.threads = 3;
    EXPECT_EQ(draw::slice_image(slice_of(*field, settings, "a < b & c")).bytes, image.bytes);
  }
}

// All text of an SVG stays within its width, by the widths of letters that pictures reckon with.
void expect_text_within(const std::string& svg, double width, const std::string& what) {
  const auto after = [](const std::string& tag, const std::string& name) {
    const std::size_t at = tag.find(" " + name + "=\"");
    return at == std::string::npos
               ? std::string()
               : tag.substr(at + name.size() + 3, tag.find('"', at + name.size() + 3) - at - name.size() - 3);
  };
  std::size_t count = 0;
  for (std::size_t at = svg.find("<text "); at != std::string::npos; at = svg.find("<text ", at + 1)) {
    const std::size_t end = svg.find('>', at);
    const std::string tag = svg.substr(at, end - at);
    if (tag.find("transform=") != std::string::npos) continue;  // along an axis that is upright
    draw::TextStyle style;
    style.size = std::stod(after(tag, "font-size"));
    style.bold = tag.find("font-weight=") != std::string::npos;
    const double wide = draw::text_width(svg.substr(end + 1, svg.find('<', end) - end - 1), style);
    const std::string anchor = after(tag, "text-anchor");
    const double left = std::stod(after(tag, "x")) - (anchor == "end"      ? 1.0
                                                      : anchor == "middle" ? 0.5
                                                                           : 0.0) *
                                                         wide;
    EXPECT_GE(left, 0.0) << what << tag;
    EXPECT_LE(left + wide, width) << what << tag;
    ++count;
  }
  EXPECT_GE(count, 5U) << what;
}

TEST(Slice, TitlesAreNeverCutOff) {
  const auto field = field_of_text(ball_text);
  for (const std::string& title :
       {std::string("ball"), std::string("Ext ∩, δ = 0.01, ε = 0.25"), std::string(60, 'W'),
        std::string("∪∩∪∩∪∩∪∩∪∩∪∩∪∩∪∩∪∩∪∩∪∩"), std::string(90, '\x80')}) {
    for (const std::size_t width : {160U, 240U, 320U, 640U}) {
      SliceSettings settings = settings_for(*field, 2, 0.0);
      settings.width = width;
      settings.height = 160;
      const std::string svg = draw::slice_svg(slice_of(*field, settings, title));
      EXPECT_EQ(draw::xml_fault(svg), "");
      expect_text_within(svg, static_cast<double>(width), title);
    }
  }
  // What fits stays whole.
  SliceSettings settings = settings_for(*field, 2, 0.0);
  settings.width = 320;
  EXPECT_NE(draw::slice_svg(slice_of(*field, settings, "Ext ∩, δ = 0.01, ε = 0.25"))
                .find(">Ext ∩, δ = 0.01, ε = 0.25</text>"),
            std::string::npos);
}

// Contour spacing, measured along the gradient on the picture: of a distance field within 5 %.
TEST(Slice, LayersOfADistanceAreEquallyWide) {
  const auto field = field_of_text(R"({"type": "torus", "ring_radius": 0.4, "tube_radius": 0.1})");
  SliceSettings settings = settings_for(*field, 2, 0.0);
  settings.spacing = 0.05;
  settings.layers = true;
  const draw::SlicePicture picture = slice_of(*field, settings, "");
  // Along x from the outside of the ring outwards the shade is greatest every 0.05 m.
  const std::size_t row =
      static_cast<std::size_t>(std::lround(-picture.field.origin.y / picture.field.step_y));
  const Bands wave({{1.0, 2.0 * 3.14159265358979323846 / 0.05}});
  std::vector<double> tops;
  for (std::size_t column = 1; column + 1 < picture.field.columns; ++column) {
    const draw::Point at = picture.field.position(column, row);
    const auto shade = [&](std::size_t i) { return wave.shade(picture.field.value(i, row)); };
    if (at.x < 0.52 || !(shade(column) >= shade(column - 1) && shade(column) > shade(column + 1))) continue;
    // The top of the parabola through the three.
    const double l = shade(column - 1), m = shade(column), r = shade(column + 1);
    tops.push_back(at.x + 0.5 * (l - r) / (l - 2.0 * m + r) * picture.field.step_x);
  }
  ASSERT_GE(tops.size(), 3U);
  for (std::size_t i = 1; i < tops.size(); ++i) EXPECT_NEAR(tops[i] - tops[i - 1], 0.05, 0.05 * 0.05);
}

}  // namespace
}  // namespace nearfield::host
