#include "draw/contour.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <stdexcept>

namespace nearfield::host::draw {
namespace {

double radius(Point p) { return std::sqrt(p.x * p.x + p.y * p.y); }

SampledGrid circle_field(std::size_t count) {
  return sample_grid({-1.5, -1.5}, {1.5, 1.5}, count, count,
                     [](double x, double y) { return std::sqrt(x * x + y * y) - 1.0; });
}

SampledGrid cell(double low_left, double low_right, double high_right, double high_left) {
  return {{0.0, 0.0}, 1.0, 1.0, 2, 2, {low_left, low_right, high_left, high_right}};
}

/// Twice the signed area: positive when walked counter-clockwise.
double signed_area(const Polyline& line) {
  double area = 0.0;
  for (std::size_t i = 0; i < line.points.size(); ++i) {
    const Point a = line.points[i];
    const Point b = line.points[(i + 1) % line.points.size()];
    area += a.x * b.y - b.x * a.y;
  }
  return area;
}

/// Area inside an even number of rings does not count; rings here are nested or apart and turn accordingly.
double region_area(const std::vector<Polyline>& rings) {
  double area = 0.0;
  for (const Polyline& ring : rings) area += signed_area(ring) / 2.0;
  return area;
}

TEST(Contour, CircleIsOneClosedLineWithinTheInterpolationError) {
  for (const std::size_t count : {24u, 61u, 128u}) {
    const SampledGrid grid = circle_field(count);
    for (const double level : {-0.5, 0.0, 0.25}) {
      const std::vector<Polyline> lines = contour_lines(grid, level);
      ASSERT_EQ(lines.size(), 1u) << count << ' ' << level;
      EXPECT_TRUE(lines[0].closed);
      EXPECT_GT(lines[0].points.size(), count);
      EXPECT_GT(signed_area(lines[0]), 0.0) << "the lower inside lies on the left";
      const double wanted = 1.0 + level;
      // Along a grid edge the second derivative of the distance is at most 1 / (least distance on the edge).
      const double error = grid.step_x * grid.step_x / 8.0 / (wanted - grid.step_x);
      for (const Point& p : lines[0].points) EXPECT_NEAR(radius(p), wanted, error);
    }
  }
}

TEST(Contour, NeighbouringPointsLieInOneCell) {
  const SampledGrid grid = circle_field(40);
  const Polyline line = contour_lines(grid, 0.1).at(0);
  for (std::size_t i = 0; i < line.points.size(); ++i) {
    const Point a = line.points[i];
    const Point b = line.points[(i + 1) % line.points.size()];
    EXPECT_LE(std::fabs(a.x - b.x), grid.step_x * 1.000001);
    EXPECT_LE(std::fabs(a.y - b.y), grid.step_y * 1.000001);
  }
}

TEST(Contour, LevelsOfADistanceAreEvenlySpaced) {
  const SampledGrid grid = circle_field(121);
  double previous = 0.0;
  for (int k = -6; k <= 4; ++k) {
    const Polyline line = contour_lines(grid, k * 0.1).at(0);
    double mean = 0.0;
    for (const Point& p : line.points) mean += radius(p) / static_cast<double>(line.points.size());
    if (k > -6) {
      EXPECT_NEAR(mean - previous, 0.1, 2e-4);
    }
    previous = mean;
  }
}

TEST(Contour, LineEndsAtTheBorder) {
  const SampledGrid grid =
      sample_grid({0.0, 0.0}, {2.0, 1.0}, 21, 11, [](double x, double) { return x - 0.73; });
  const std::vector<Polyline> lines = contour_lines(grid, 0.0);
  ASSERT_EQ(lines.size(), 1u);
  EXPECT_FALSE(lines[0].closed);
  ASSERT_EQ(lines[0].points.size(), 11u);
  EXPECT_DOUBLE_EQ(lines[0].points.front().y, 0.0);
  EXPECT_DOUBLE_EQ(lines[0].points.back().y, 1.0);
  for (const Point& p : lines[0].points) EXPECT_NEAR(p.x, 0.73, 1e-12);
}

TEST(Contour, CutCircleGivesFourArcs) {
  const SampledGrid grid = circle_field(101);
  const std::vector<Polyline> lines = contour_lines(grid, 0.8);
  ASSERT_EQ(lines.size(), 4u);
  for (const Polyline& line : lines) {
    EXPECT_FALSE(line.closed);
    for (const Point& end : {line.points.front(), line.points.back()}) {
      EXPECT_TRUE(std::fabs(std::fabs(end.x) - 1.5) < 1e-12 || std::fabs(std::fabs(end.y) - 1.5) < 1e-12);
    }
  }
}

TEST(Contour, EveryCornerPatternSeparatesLowFromHigh) {
  for (unsigned pattern = 0; pattern < 16; ++pattern) {
    const auto corner = [pattern](unsigned i) { return (pattern >> i & 1u) != 0 ? -1.0 : 1.0; };
    const std::vector<Polyline> lines = contour_lines(cell(corner(0), corner(1), corner(2), corner(3)), 0.0);
    const bool saddle = pattern == 5 || pattern == 10;
    EXPECT_EQ(lines.size(), pattern == 0 || pattern == 15 ? 0u : (saddle ? 2u : 1u)) << pattern;
    const Point position[] = {{0.0, 0.0}, {1.0, 0.0}, {1.0, 1.0}, {0.0, 1.0}};
    for (const Polyline& line : lines) {
      ASSERT_EQ(line.points.size(), 2u);
      const Point a = line.points[0];
      const Point b = line.points[1];
      // The corners next to the line's ends are low on its left and high on its right.
      for (unsigned i = 0; i < 4; ++i) {
        const double turn = (b.x - a.x) * (position[i].y - a.y) - (b.y - a.y) * (position[i].x - a.x);
        const bool touches = std::fabs(position[i].x - a.x) + std::fabs(position[i].y - a.y) < 0.6 ||
                             std::fabs(position[i].x - b.x) + std::fabs(position[i].y - b.y) < 0.6;
        if (touches) {
          EXPECT_EQ(turn > 0.0, corner(i) < 0.0) << pattern << ' ' << i;
        }
      }
    }
  }
}

TEST(Contour, SaddleFollowsTheValueAtTheCentre) {
  const auto cuts_off_origin = [](const std::vector<Polyline>& lines) {
    for (const Polyline& line : lines) {
      bool near_origin = true;
      for (const Point& p : line.points) near_origin = near_origin && p.x + p.y < 1.0;
      if (near_origin) return true;
    }
    return false;
  };
  const std::vector<Polyline> apart = contour_lines(cell(-1.0, 2.0, -1.0, 2.0), 0.0);
  const std::vector<Polyline> joined = contour_lines(cell(-2.0, 1.0, -2.0, 1.0), 0.0);
  ASSERT_EQ(apart.size(), 2u);
  ASSERT_EQ(joined.size(), 2u);
  EXPECT_TRUE(cuts_off_origin(apart)) << "high centre: the low corners are apart";
  EXPECT_FALSE(cuts_off_origin(joined)) << "low centre: the low corners are joined";
  const std::vector<Polyline> other_apart = contour_lines(cell(2.0, -1.0, 2.0, -1.0), 0.0);
  const std::vector<Polyline> other_joined = contour_lines(cell(1.0, -2.0, 1.0, -2.0), 0.0);
  EXPECT_FALSE(cuts_off_origin(other_apart));
  EXPECT_TRUE(cuts_off_origin(other_joined)) << "the high corner at the origin is cut off";
}

TEST(Contour, SamplesEqualToTheLevelCountAsAbove) {
  EXPECT_TRUE(contour_lines(cell(0.0, 0.0, 0.0, 0.0), 0.0).empty());
  EXPECT_TRUE(contour_lines(cell(0.0, 1.0, 1.0, 0.0), 0.0).empty());
  const std::vector<Polyline> lines = contour_lines(cell(-1.0, 0.0, 1.0, 0.0), 0.0);
  ASSERT_EQ(lines.size(), 1u);
  EXPECT_DOUBLE_EQ(lines[0].points[0].x, 1.0);
  EXPECT_DOUBLE_EQ(lines[0].points[1].y, 1.0);
}

TEST(Contour, UnknownSamplesOpenALineAndBoundARegion) {
  SampledGrid grid = circle_field(61);
  for (std::size_t row = 0; row < grid.rows; ++row) {
    for (std::size_t column = 0; column < grid.columns; ++column) {
      if (grid.position(column, row).x > 0.5) {
        grid.values[row * grid.columns + column] = std::numeric_limits<double>::quiet_NaN();
      }
    }
  }
  const std::vector<Polyline> lines = contour_lines(grid, 0.0);
  ASSERT_EQ(lines.size(), 1u);
  EXPECT_FALSE(lines[0].closed);
  for (const Point& p : lines[0].points) EXPECT_LE(p.x, 0.5 + 1e-12);
  const std::vector<Polyline> region = filled_region(grid, 0.0);
  ASSERT_EQ(region.size(), 1u);
  const double wanted = 3.14159265 - (3.14159265 / 3.0 - std::sqrt(3.0) / 4.0);
  EXPECT_NEAR(region_area(region), wanted, 0.01);
}

TEST(Contour, RegionsAreClosedAlongTheBorder) {
  const SampledGrid grid = circle_field(101);
  EXPECT_NEAR(region_area(filled_region(grid, 0.0)), 3.14159265, 2e-3);
  const std::vector<Polyline> all = filled_region(grid, 10.0);
  ASSERT_EQ(all.size(), 1u);
  EXPECT_TRUE(all[0].closed);
  EXPECT_NEAR(region_area(all), 9.0, 1e-9);
  EXPECT_TRUE(filled_region(grid, -2.0).empty());
  for (const Polyline& ring : filled_region(grid, 0.8)) EXPECT_TRUE(ring.closed);
}

TEST(Contour, BandsTileTheGrid) {
  const SampledGrid grid = circle_field(80);
  double total = region_area(filled_region(grid, -0.5));
  for (int k = -5; k < 12; ++k) {
    const double lower = k * 0.1;
    const double upper = (k + 1) * 0.1;
    total += region_area(filled_region(grid, upper)) - region_area(filled_region(grid, lower));
    const std::size_t rings = filled_region(grid, upper).size() + filled_region(grid, lower).size();
    EXPECT_EQ(filled_band(grid, lower, upper).size(), rings);
  }
  EXPECT_NEAR(total, 9.0, 1e-9);
  EXPECT_THROW(filled_band(grid, 0.1, 0.1), std::invalid_argument);
}

TEST(Contour, SameLinesTwice) {
  const SampledGrid grid = sample_grid({0.0, 0.0}, {9.0, 7.0}, 91, 71, [](double x, double y) {
    const double u = x - std::floor(x) - 0.5;
    const double v = y - std::floor(y) - 0.5;
    return u * v + 0.02 * x;
  });
  const std::vector<Polyline> once = contour_lines(grid, 0.05);
  const std::vector<Polyline> twice = contour_lines(grid, 0.05);
  ASSERT_EQ(once.size(), twice.size());
  ASSERT_GT(once.size(), 5u);
  bool closed_seen = false;
  for (std::size_t i = 0; i < once.size(); ++i) {
    if (closed_seen) {
      EXPECT_TRUE(once[i].closed) << "open lines come first";
    }
    closed_seen = closed_seen || once[i].closed;
    ASSERT_EQ(once[i].points.size(), twice[i].points.size());
    EXPECT_EQ(once[i].points.front().x, twice[i].points.front().x);
  }
}

TEST(Contour, RejectsAGridThatDoesNotFit) {
  SampledGrid grid = cell(-1.0, 1.0, 1.0, 1.0);
  EXPECT_THROW(contour_lines(grid, std::numeric_limits<double>::quiet_NaN()), std::invalid_argument);
  grid.step_x = 0.0;
  EXPECT_THROW(contour_lines(grid, 0.0), std::invalid_argument);
  grid.step_x = 1.0;
  grid.values.pop_back();
  EXPECT_THROW(contour_lines(grid, 0.0), std::invalid_argument);
  EXPECT_THROW(contour_lines(SampledGrid{}, 0.0), std::invalid_argument);
}

}  // namespace
}  // namespace nearfield::host::draw
