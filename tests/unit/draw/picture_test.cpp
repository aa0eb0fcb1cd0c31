#include <gtest/gtest.h>

#include <limits>
#include <stdexcept>

#include "draw/scene_picture.hpp"
#include "draw/timeline.hpp"
#include "sample_scene.hpp"
#include "well_formed.hpp"

namespace nearfield::host::draw {
namespace {

TEST(ScenePicture, HoldsEverythingInBothViews) {
  const ScenePicture picture = sample::picture();
  const std::string svg = scene_picture_svg(picture);
  EXPECT_EQ(xml_fault(svg), "");
  for (const char* group : {"top-view", "side-view", "legend", "caption", "header"}) {
    EXPECT_EQ(occurrences(svg, std::string("class=\"") + group + '"'), 1u) << group;
  }
  for (const char* group : {"field", "bodies", "tool-path", "nearest", "repulsion", "scale-bar", "axes"}) {
    EXPECT_EQ(occurrences(svg, std::string("class=\"") + group + '"'), 2u) << group;
  }
  EXPECT_EQ(occurrences(svg, ">86 mm<"), 2u);
  EXPECT_EQ(occurrences(svg, ">x (m)<"), 2u);
  EXPECT_EQ(occurrences(svg, ">y (m)<"), 1u);
  EXPECT_EQ(occurrences(svg, ">z (m)<"), 1u);
  EXPECT_EQ(occurrences(svg, ">C<"), 1u);
  EXPECT_NE(svg.find("Time 12.34 s. Zone: slow. Speed override 42"), std::string::npos);
  EXPECT_NE(svg.find("to the cell 86 mm, to the person 312 mm and to itself 131 mm."), std::string::npos);
  EXPECT_GE(occurrences(svg, " m</text>"), 4u) << "labelled contour lines";
  EXPECT_LT(svg.size(), 150000u);
}

TEST(ScenePicture, SameBytesEachTimeOnEveryCompiler) {
  const std::string svg = scene_picture_svg(sample::picture());
  EXPECT_EQ(digest(svg), digest(scene_picture_svg(sample::picture())));
  EXPECT_EQ(digest(svg), 6555889141039081106u) << "changes whenever the look of pictures does";
}

TEST(ScenePicture, ShowsWhatThereIsAndNothingElse) {
  ScenePicture picture;
  picture.title = "A & B <empty>";
  const std::string svg = scene_picture_svg(picture);
  EXPECT_EQ(xml_fault(svg), "");
  for (const char* absent :
       {"class=\"field\"", "class=\"nearest\"", "class=\"repulsion\"", ">person<", ">joint<"}) {
    EXPECT_EQ(occurrences(svg, absent), 0u) << absent;
  }
}

TEST(ScenePicture, CapsuleBecomesAStadiumAndABallACircle) {
  ScenePicture picture;
  picture.top.window = {0.0, 1.0, 0.0, 1.0};
  picture.side.window = {0.0, 1.0, 0.0, 1.0};
  picture.arm = {{{0.5, 0.5, 0.2}, {0.5, 0.5, 0.8}, 0.1}};
  const std::string svg = scene_picture_svg(picture);
  const std::size_t side = svg.find("class=\"side-view\"");
  const std::string top_part = svg.substr(0, side);
  const std::string side_part = svg.substr(side);
  const std::string arm = std::string("fill=\"") + palette::arm + '"';
  const auto element_before = [&arm](const std::string& part) {
    const std::size_t at = part.find(arm);
    return part.substr(part.rfind('<', at), 5);
  };
  EXPECT_EQ(element_before(top_part), "<circ") << "seen along its axis";
  EXPECT_EQ(element_before(side_part), "<path") << "seen from the side";
}

TEST(ScenePicture, UnknownClearanceIsNamedAsSuch) {
  ScenePicture picture = sample::picture();
  picture.clearances[1].clearance = std::numeric_limits<double>::quiet_NaN();
  EXPECT_NE(scene_picture_svg(picture).find("to the person unknown"), std::string::npos);
}

TEST(ScenePicture, RejectsWhatCannotBeDrawn) {
  ScenePicture picture = sample::picture();
  picture.top.window.right = picture.top.window.left;
  EXPECT_THROW(scene_picture_svg(picture), std::invalid_argument);
  picture = sample::picture();
  picture.contour_spacing = 0.0;
  EXPECT_THROW(scene_picture_svg(picture), std::invalid_argument);
  picture = sample::picture();
  picture.arm[0].radius = std::numeric_limits<double>::quiet_NaN();
  EXPECT_THROW(scene_picture_svg(picture), std::invalid_argument);
}

TEST(Timeline, HoldsThreePanelsAndTheirMarkers) {
  const std::string svg = timeline_svg(sample::timeline());
  EXPECT_EQ(xml_fault(svg), "");
  for (const char* group : {"clearances", "zones", "zone-names", "speed-override", "markers", "time-axis"}) {
    EXPECT_EQ(occurrences(svg, std::string("class=\"") + group + '"'), 1u) << group;
  }
  for (const char* text : {"to the cell", "to the person", "to itself", "clearance (m)", "time (s)",
                           "slow 0.4 m", "stop 0.12 m", "A", "B", "C", "D", "E"}) {
    EXPECT_EQ(occurrences(svg, std::string(">") + text + '<'), 1u) << text;
  }
  EXPECT_EQ(occurrences(svg, ">stop<"), 2u) << "in the band and in the key";
  EXPECT_LT(svg.size(), 300000u);
}

TEST(Timeline, SameBytesEachTimeOnEveryCompiler) {
  const std::string svg = timeline_svg(sample::timeline());
  EXPECT_EQ(digest(svg), digest(timeline_svg(sample::timeline())));
  EXPECT_EQ(digest(svg), 1499916868210456030u) << "changes whenever the look of pictures does";
}

TEST(Timeline, StaysSmallInTheWorstCase) {
  Timeline chart = sample::timeline();
  chart.curves.resize(6);
  unsigned noise = 3;
  const auto next = [&noise] {
    noise = noise * 1664525u + 1013904223u;
    return (noise >> 8) / 16777216.0;
  };
  for (std::size_t i = 0; i < chart.times.size(); ++i) {
    for (TimelineCurve& curve : chart.curves) {
      curve.clearances.resize(chart.times.size());
      curve.clearances[i] = next() < 0.1 ? std::numeric_limits<double>::quiet_NaN() : next();
    }
    chart.zones[i] = next() < 0.5 ? Zone::free : (next() < 0.5 ? Zone::slow : Zone::stop);
    chart.speed_override[i] = next();
  }
  const std::string svg = timeline_svg(chart);
  EXPECT_EQ(xml_fault(svg), "");
  EXPECT_LT(svg.size(), 300000u);
}

TEST(Timeline, AShortStopIsNeverLost) {
  Timeline chart = sample::timeline();
  for (Zone& zone : chart.zones) zone = Zone::free;
  const auto stop_area = [](const std::string& svg) {
    return occurrences(svg,
                       std::string("fill-rule=\"evenodd\" fill=\"") + palette::zone_fill(Zone::stop) + '"');
  };
  EXPECT_EQ(stop_area(timeline_svg(chart)), 0u);
  chart.zones[17003] = Zone::stop;
  EXPECT_EQ(stop_area(timeline_svg(chart)), 1u);
}

TEST(Timeline, GapsBreakACurve) {
  Timeline chart;
  for (int i = 0; i < 100; ++i) {
    chart.times.push_back(i * 0.1);
    chart.zones.push_back(Zone::free);
    chart.speed_override.push_back(1.0);
  }
  chart.curves = {{"to the cell", std::vector<double>(100, 0.5)}};
  const auto moves = [](const std::string& svg) {
    const std::size_t from = svg.find("class=\"curves\"");
    return occurrences(svg.substr(from, svg.find("</g>", from) - from), "M");
  };
  EXPECT_EQ(moves(timeline_svg(chart)), 1u);
  chart.curves[0].clearances[40] = std::numeric_limits<double>::infinity();
  EXPECT_EQ(moves(timeline_svg(chart)), 2u);
  chart.curves[0].clearances.assign(100, std::numeric_limits<double>::quiet_NaN());
  EXPECT_EQ(moves(timeline_svg(chart)), 0u);
}

TEST(Timeline, RejectsSeriesThatDoNotFit) {
  EXPECT_THROW(timeline_svg(Timeline{}), std::invalid_argument);
  Timeline chart = sample::timeline();
  chart.curves[0].clearances.pop_back();
  EXPECT_THROW(timeline_svg(chart), std::invalid_argument);
  chart = sample::timeline();
  chart.times[5] = chart.times[4];
  EXPECT_THROW(timeline_svg(chart), std::invalid_argument);
}

}  // namespace
}  // namespace nearfield::host::draw
