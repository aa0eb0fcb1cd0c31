#include "text/names.hpp"

#include <gtest/gtest.h>

#include <string>

#include "text/number.hpp"

namespace nearfield::host {
namespace {

TEST(Names, EditDistanceCountsSwapsOnce) {
  EXPECT_EQ(edit_distance("", "abc"), 3U);
  EXPECT_EQ(edit_distance("radius", "radius"), 0U);
  EXPECT_EQ(edit_distance("raduis", "radius"), 1U);
  EXPECT_EQ(edit_distance("kitten", "sitting"), 3U);
}

TEST(Names, SuggestsOnlyWhatIsNear) {
  EXPECT_EQ(nearest_name("raduis", {"size", "radius"}), "radius");
  EXPECT_EQ(nearest_name("szie", {"size", "radius"}), "size");
  EXPECT_FALSE(nearest_name("colour", {"size", "radius"}).has_value());
  EXPECT_FALSE(nearest_name("z", {"x", ""}).has_value());
  EXPECT_FALSE(nearest_name(std::string(65, 'a'), {std::string(64, 'a')}).has_value());
}

TEST(Names, LongTextIsShortenedBetweenCodePoints) {
  EXPECT_EQ(in_quotes("abc"), "\"abc\"");
  EXPECT_EQ(in_quotes(std::string(59, 'a') + "éé"), "\"" + std::string(59, 'a') + "...\"");
}

TEST(Number, ParsesDecimalsOnly) {
  EXPECT_EQ(parse_number("-1.5e-3"), -1.5e-3);
  EXPECT_EQ(parse_number("1."), 1.0);
  for (const char* wrong : {"", " 1", "1 ", "+1", "0x10", "inf", "nan", "1e999", "1,5", "--1", "1e"}) {
    EXPECT_FALSE(parse_number(wrong).has_value()) << wrong;
  }
}

TEST(Number, RangesIncludeTheirEndsUnlessExcluded) {
  const NumberRange closed{0.0, 2.0, "m"};
  const NumberRange open{0.0, 2.0, {}, true};
  EXPECT_TRUE(contains(closed, 0.0) && contains(closed, 2.0) && contains(open, 2.0));
  EXPECT_FALSE(contains(open, 0.0) || contains(closed, -1e-300) || contains(closed, 2.1));
  EXPECT_EQ(describe(closed), "from 0 to 2 m");
  EXPECT_EQ(describe(open), "above 0 and at most 2");
  EXPECT_EQ(describe(NumberRange{}), "of any size");
  NumberRange at_least;
  at_least.lowest = 1.5;
  EXPECT_EQ(describe(at_least), "at least 1.5");
}

}  // namespace
}  // namespace nearfield::host
