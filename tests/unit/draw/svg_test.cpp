#include "draw/svg.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <limits>
#include <stdexcept>

#include "draw/axis.hpp"
#include "draw/decimate.hpp"
#include "draw/label_placer.hpp"
#include "draw/number_text.hpp"
#include "draw/page_transform.hpp"
#include "well_formed.hpp"

namespace nearfield::host::draw {
namespace {

TEST(NumberText, RoundsAndNeverWritesMinusZero) {
  EXPECT_EQ(fixed_text(1.005, 1), "1.0");
  EXPECT_EQ(fixed_text(-0.001, 2), "0.00");
  EXPECT_EQ(fixed_text(-0.006, 2), "-0.01");
  EXPECT_EQ(short_text(12.50, 2), "12.5");
  EXPECT_EQ(short_text(100.0, 2), "100");
  EXPECT_EQ(short_text(100.0, 0), "100");
  EXPECT_EQ(length_text(0.0858), "86 mm");
  EXPECT_EQ(length_text(-0.004), "-4 mm");
  EXPECT_EQ(length_text(0.9996), "1.00 m");
}

TEST(NumberText, RejectsWhatIsNotANumber) {
  EXPECT_THROW(fixed_text(std::numeric_limits<double>::infinity(), 2), std::invalid_argument);
  EXPECT_THROW(fixed_text(std::numeric_limits<double>::quiet_NaN(), 2), std::invalid_argument);
  EXPECT_THROW(fixed_text(1.0, 10), std::invalid_argument);
}

TEST(Svg, WritesExactlyThis) {
  SvgDocument document(100.0, 50.0, "T", "D");
  document.begin_group("g");
  document.line({1.0, 2.0}, {3.333, 4.0}, stroked("#000000", 1.5, {4.0, 2.0}));
  document.circle({5.0, 5.0}, 2.0, filled("#112233", 0.5));
  document.end_group();
  const std::string svg = document.finish();
  EXPECT_NE(svg.find("<g class=\"g\">\n<path d=\"M1 2L3.33 4\" fill=\"none\" stroke=\"#000000\" "
                     "stroke-width=\"1.5\" stroke-dasharray=\"4 2\"/>\n<circle cx=\"5\" cy=\"5\" r=\"2\" "
                     "fill=\"#112233\" fill-opacity=\"0.5\"/>\n</g>\n</svg>\n"),
            std::string::npos)
      << svg;
  EXPECT_EQ(xml_fault(svg), "");
}

TEST(Svg, EscapesTextAndAttributes) {
  EXPECT_EQ(escaped("a<b>&\"'"), "a&lt;b&gt;&amp;&quot;&#39;");
  EXPECT_EQ(escaped("\x01"), "\xEF\xBF\xBD");
  EXPECT_EQ(escaped("\xC3\xA9 \xE2\x82\xAC"), "\xC3\xA9 \xE2\x82\xAC");
  EXPECT_EQ(escaped("\xC0\x80"), "\xEF\xBF\xBD\xEF\xBF\xBD") << "overlong";
  EXPECT_EQ(escaped("x\xE2\x82"), "x\xEF\xBF\xBD\xEF\xBF\xBD") << "cut off";
  EXPECT_EQ(escaped("\xED\xA0\x80"), "\xEF\xBF\xBD") << "surrogate";
  EXPECT_EQ(escaped("\xF0\x9F\x99\x82"), "\xF0\x9F\x99\x82");
  SvgDocument document(10.0, 10.0, "<&>", "\"");
  document.begin_group("a\"b<");
  document.text({1.0, 1.0}, "</svg>&", {});
  document.end_group();
  EXPECT_EQ(xml_fault(document.finish()), "");
}

TEST(Svg, ShapesAreWellFormedEvenWhenDegenerate) {
  SvgDocument document(10.0, 10.0, "", "");
  document.begin_clipped_group("c", {0.0, 0.0, 5.0, 5.0});
  document.begin_clipped_group("d", {0.0, 0.0, 4.0, 4.0});
  document.stadium({1.0, 1.0}, {1.0, 1.0}, 2.0, filled("#000000"));
  document.stadium({1.0, 1.0}, {4.0, 1.0}, 2.0, filled("#000000"));
  document.arrow({1.0, 1.0}, {1.2, 1.0}, "#000000", 2.0);
  document.path({}, filled("#000000"));
  document.path({Polyline{{{1.0, 1.0}}, false}}, filled("#000000"));
  document.end_group();
  document.end_group();
  const std::string svg = document.finish();
  EXPECT_EQ(xml_fault(svg), "");
  EXPECT_EQ(occurrences(svg, "<circle"), 1u);
  EXPECT_EQ(occurrences(svg, "<path"), 1u);
  EXPECT_NE(svg.find("M1 3L4 3A2 2 0 0 0 4 -1L1 -1A2 2 0 0 0 1 3Z"), std::string::npos) << svg;
  EXPECT_EQ(occurrences(svg, "id=\"nearfield-clip1\""), 1u);
  EXPECT_EQ(occurrences(svg, "id=\"nearfield-clip2\""), 1u);
}

TEST(Svg, RejectsMisuse) {
  SvgDocument document(10.0, 10.0, "", "");
  EXPECT_THROW(document.end_group(), std::logic_error);
  EXPECT_THROW(document.circle({std::numeric_limits<double>::quiet_NaN(), 0.0}, 1.0, {}),
               std::invalid_argument);
  SvgDocument unfinished(10.0, 10.0, "", "");
  unfinished.begin_group("g");
  EXPECT_THROW(unfinished.finish(), std::logic_error);
}

TEST(Svg, WrapsAtSpaces) {
  const TextStyle style;
  const std::string words = "one two three four five six seven";
  const double width = text_width("one two three", style);
  std::string joined;
  for (const std::string& line : wrapped(words, style, width)) {
    EXPECT_LE(text_width(line, style), width) << line;
    joined += (joined.empty() ? "" : " ") + line;
  }
  EXPECT_EQ(joined, words);
  EXPECT_EQ(wrapped("incomprehensible", style, 10.0).size(), 1u);
  EXPECT_TRUE(wrapped("  ", style, 10.0).empty());
}

TEST(PageTransform, TurnsYOverAndKeepsTheScale) {
  const WorldToPage to_page({-1.0, 3.0, 0.0, 2.0}, {10.0, 20.0}, 100.0);
  const Point low = to_page(Point{-1.0, 0.0});
  const Point high = to_page(Point{3.0, 2.0});
  EXPECT_DOUBLE_EQ(low.x, 10.0);
  EXPECT_DOUBLE_EQ(low.y, 220.0);
  EXPECT_DOUBLE_EQ(high.x, 410.0);
  EXPECT_DOUBLE_EQ(high.y, 20.0);
  EXPECT_DOUBLE_EQ(to_page.frame().bottom(), 220.0);
}

TEST(Geometry, SimplifyingStaysWithinTheTolerance) {
  Polyline line;
  for (int i = 0; i <= 100; ++i) line.points.push_back({i * 1.0, i == 50 ? 1.0 : (i % 2 == 0 ? 0.0 : 0.01)});
  const Polyline simple = simplified(line, 0.05);
  ASSERT_LE(simple.points.size(), 8u);
  bool peak = false;
  for (const Point& p : simple.points) peak = peak || p.y == 1.0;
  EXPECT_TRUE(peak);
  EXPECT_EQ(simplified(line, 0.0).points.size(), line.points.size());
  const Polyline square{{{0.0, 0.0}, {0.5, 0.0}, {1.0, 0.0}, {1.0, 1.0}, {0.0, 1.0}}, true};
  EXPECT_EQ(simplified(square, 0.01).points.size(), 4u);
  EXPECT_TRUE(simplified(square, 0.01).closed);
}

TEST(Axis, TicksAreRound) {
  const std::vector<Tick> ticks = round_ticks(-0.31, 0.52, 10);
  ASSERT_EQ(ticks.size(), 9u);
  EXPECT_EQ(ticks.front().text, "-0.3");
  EXPECT_EQ(ticks[3].text, "0.0");
  EXPECT_EQ(ticks.back().text, "0.5");
  EXPECT_EQ(round_ticks(0.0, 24000.0, 5).back().text, "20000");
  EXPECT_TRUE(round_ticks(1.0, 1.0, 5).empty());
  for (double high = 1e-3; high < 1e6; high *= 1.7) {
    const std::size_t count = round_ticks(0.0, high, 9).size();
    EXPECT_GE(count, 4u) << high;
    EXPECT_LE(count, 9u) << high;
  }
}

TEST(Axis, RoundsUp) {
  EXPECT_DOUBLE_EQ(round_up(0.83), 1.0);
  EXPECT_DOUBLE_EQ(round_up(0.11), 0.15);
  EXPECT_DOUBLE_EQ(round_up(6.1), 8.0);
  EXPECT_DOUBLE_EQ(round_up(0.0), 1.0);
}

TEST(Axis, SpreadsApartWithinBounds) {
  const std::vector<double> placed = spread_apart({5.0, 5.0, 6.0, 99.0}, 10.0, 0.0, 100.0);
  for (std::size_t i = 1; i < placed.size(); ++i) EXPECT_GE(placed[i] - placed[i - 1], 10.0);
  EXPECT_GE(placed.front(), 0.0);
  EXPECT_LE(placed.back(), 100.0);
  const std::vector<double> tight = spread_apart({99.0, 99.0, 99.0}, 60.0, 0.0, 100.0);
  EXPECT_DOUBLE_EQ(tight[0], 0.0);
  EXPECT_DOUBLE_EQ(tight[2], 100.0);
}

TEST(Decimate, KeepsEveryMinimumAndMaximumOfASpan) {
  std::vector<double> times;
  std::vector<double> values;
  unsigned noise = 7;
  for (int i = 0; i < 24000; ++i) {
    noise = noise * 1664525u + 1013904223u;
    times.push_back(i * 0.001);
    values.push_back((noise >> 8) / 16777216.0);
  }
  values[12345] = -5.0;
  values[12346] = 7.0;
  const std::size_t buckets = 100;
  const std::vector<std::size_t> kept = decimated(times, values, buckets);
  EXPECT_LE(kept.size(), 4 * buckets);
  std::vector<double> least(buckets, 1e9), greatest(buckets, -1e9), kept_least = least,
                                                                    kept_greatest = greatest;
  for (std::size_t i = 0; i < times.size(); ++i) {
    const std::size_t b = bucket_of(times[i], times.front(), times.back(), buckets);
    least[b] = std::min(least[b], values[i]);
    greatest[b] = std::max(greatest[b], values[i]);
  }
  for (std::size_t k = 0; k < kept.size(); ++k) {
    if (k > 0) {
      ASSERT_LT(kept[k - 1], kept[k]);
    }
    const std::size_t b = bucket_of(times[kept[k]], times.front(), times.back(), buckets);
    kept_least[b] = std::min(kept_least[b], values[kept[k]]);
    kept_greatest[b] = std::max(kept_greatest[b], values[kept[k]]);
  }
  EXPECT_EQ(least, kept_least);
  EXPECT_EQ(greatest, kept_greatest);
}

TEST(LabelPlacer, KeepsOffWhatIsBlocked) {
  LabelPlacer placer({0.0, 0.0, 100.0, 100.0});
  placer.block(Point{0.0, 50.0}, Point{100.0, 50.0}, 10.0);
  EXPECT_FALSE(placer.place({{50.0, 45.0}, {50.0, 2.0}, {-20.0, 80.0}}, 20.0, 10.0));
  const auto first = placer.place({{50.0, 50.0}, {50.0, 80.0}}, 20.0, 10.0);
  ASSERT_TRUE(first);
  EXPECT_DOUBLE_EQ(first->y, 80.0);
  EXPECT_FALSE(placer.place({{55.0, 82.0}}, 20.0, 10.0)) << "taken";
}

TEST(Xml, TheCheckItselfFindsFaults) {
  const std::string head = "<?xml version=\"1.0\"?>\n";
  EXPECT_EQ(xml_fault(head + "<a><b c=\"d\"/></a>\n"), "");
  for (const char* bad :
       {"<a><b></a></b>", "<a", "<a>&</a>", "<a b=c/>", "<a/><a/>", "<a b=\"1\" b=\"2\"/>", "<a>", ""}) {
    EXPECT_NE(xml_fault(head + bad), "") << bad;
  }
}

}  // namespace
}  // namespace nearfield::host::draw
