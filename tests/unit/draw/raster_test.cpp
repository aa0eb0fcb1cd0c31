// Pixels of areas, lines and text.
#include "draw/raster.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <cstdint>
#include <stdexcept>

#include "draw/stroke_font.hpp"

namespace nearfield::host::draw {
namespace {

// How much black there is, pixels.
double ink(const RasterDocument& document) {
  const RgbImage image = document.image();
  double sum = 0.0;
  for (std::size_t i = 0; i < image.bytes.size(); i += 3) sum += (255.0 - image.bytes[i]) / 255.0;
  return sum;
}
int red_at(const RasterDocument& document, std::size_t x, std::size_t y) {
  const RgbImage image = document.image();
  return image.bytes[3 * (y * image.width + x)];
}

TEST(Raster, AreasCoverWhatTheyShould) {
  RasterDocument document(40, 30);
  document.path({Polyline{{{3.25, 4.5}, {31.75, 7.25}, {12.5, 25.0}}, true}}, filled("#000000"));
  const double area = 0.5 * (28.5 * 20.5 - 9.25 * 2.75);
  EXPECT_NEAR(ink(document), area, 0.005 * area);
}

TEST(Raster, HolesAndOverlapsByTheEvenOddRule) {
  RasterDocument document(20, 20);
  document.path({Polyline{{{2, 2}, {18, 2}, {18, 18}, {2, 18}}, true},
                 Polyline{{{6, 6}, {6, 14}, {14, 14}, {14, 6}}, true}},
                filled("#000000"));
  EXPECT_NEAR(ink(document), 256.0 - 64.0, 0.2);
  EXPECT_EQ(red_at(document, 10, 10), 255);
  EXPECT_EQ(red_at(document, 3, 10), 0);
}

TEST(Raster, OpacityAndWindows) {
  RasterDocument document(20, 20);
  document.begin_clipped_group("half", {0.0, 0.0, 9.5, 20.0});
  document.rectangle({0.0, 0.0, 20.0, 20.0}, filled("#000000", 0.5));
  document.end_group();
  EXPECT_NEAR(red_at(document, 4, 4), 128, 1);
  EXPECT_NEAR(red_at(document, 9, 4), 191, 1);
  EXPECT_EQ(red_at(document, 10, 4), 255);
  EXPECT_THROW(document.end_group(), std::logic_error);
}

TEST(Raster, LinesAreAsWideAsAsked) {
  for (const double width : {0.5, 1.0, 2.4, 5.0}) {
    RasterDocument document(60, 40);
    document.line({10.0, 8.0}, {50.0, 31.0}, stroked("#000000", width));
    const double length = std::sqrt(40.0 * 40.0 + 23.0 * 23.0);
    EXPECT_NEAR(ink(document) / (length * width), 1.0, width < 3.0 ? 0.06 : 0.12) << width;
  }
}

TEST(Raster, JointsOfALineAreNotDarker) {
  RasterDocument document(30, 10);
  document.path({Polyline{{{2, 5.5}, {10, 5.5}, {15, 5.5}, {28, 5.5}}, false}}, [] {
    ShapeStyle style = stroked("#000000", 1.0);
    style.stroke_opacity = 0.5;
    return style;
  }());
  for (const std::size_t x : {9U, 10U, 14U, 15U, 20U}) EXPECT_NEAR(red_at(document, x, 5), 128, 1) << x;
}

TEST(Raster, TextHasInkWhereItIs) {
  TextStyle style;
  style.size = 14.0;
  style.anchor = TextAnchor::end;
  RasterDocument document(100, 40);
  document.text({90.0, 30.0}, "0.25 m", style);
  EXPECT_GT(ink(document), 20.0);
  EXPECT_EQ(red_at(document, 96, 25), 255);
  EXPECT_GT(stroked_text_width("0.25 mm", 14.0), stroked_text_width("0.25 m", 14.0));
  EXPECT_EQ(stroked_text_width("", 14.0), 0.0);
  // Every printable character has a shape of its own; what is not ASCII a box.
  for (char c = '!'; c <= '~'; ++c) EXPECT_FALSE(stroked_text(std::string(1, c), 14.0).empty()) << c;
  EXPECT_EQ(stroked_text("\xC3\xA9", 14.0).size(), 1U);
}

TEST(Raster, RefusesWhatIsNoColour) {
  RasterDocument document(4, 4);
  EXPECT_THROW(document.rectangle({0, 0, 2, 2}, filled("black")), std::invalid_argument);
  EXPECT_THROW(document.rectangle({0, 0, 2, 2}, filled("#12345")), std::invalid_argument);
}

}  // namespace
}  // namespace nearfield::host::draw
