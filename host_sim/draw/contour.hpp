#pragma once

#include <cstddef>
#include <vector>

#include "draw/geometry.hpp"

namespace nearfield::host::draw {

/// A scalar field sampled on a regular grid: sample (column, row) lies at
/// (origin.x + column * step_x, origin.y + row * step_y) and is values[row * columns + column].
/// A value that is not finite means "not known here".
struct SampledGrid {
  Point origin;
  double step_x = 0.0;  ///< greater than zero
  double step_y = 0.0;  ///< greater than zero
  std::size_t columns = 0;
  std::size_t rows = 0;
  std::vector<double> values;

  double value(std::size_t column, std::size_t row) const { return values[row * columns + column]; }
  Point position(std::size_t column, std::size_t row) const {
    return {origin.x + static_cast<double>(column) * step_x, origin.y + static_cast<double>(row) * step_y};
  }
};

/// Samples `field(x, y)` over the rectangle from `low` to `high` inclusive. At least two columns and two
/// rows.
template <typename Field>
SampledGrid sample_grid(Point low, Point high, std::size_t columns, std::size_t rows, Field&& field) {
  SampledGrid grid;
  grid.origin = low;
  grid.step_x = (high.x - low.x) / static_cast<double>(columns - 1);
  grid.step_y = (high.y - low.y) / static_cast<double>(rows - 1);
  grid.columns = columns;
  grid.rows = rows;
  grid.values.reserve(columns * rows);
  for (std::size_t row = 0; row < rows; ++row) {
    for (std::size_t column = 0; column < columns; ++column) {
      const Point p = grid.position(column, row);
      grid.values.push_back(field(p.x, p.y));
    }
  }
  return grid;
}

/// The lines where the field equals `level`: marching squares, linear along grid edges; where a cell could be
/// joined two ways, the mean of its corners (the bilinear value at its centre) decides. A sample equal to
/// `level` counts as above. Lower values lie on the left of the walk (y up). A line is closed unless it ends
/// at the border or at a cell with an unknown corner. Open lines come first; each kind in the order in which
/// the grid is scanned. Throws std::invalid_argument when the grid's sizes do not fit its values, a step is
/// not positive or the level is not finite.
std::vector<Polyline> contour_lines(const SampledGrid& grid, double level);

/// The region where the field is below `level` as closed rings, to be filled by the even-odd rule. Along the
/// border of the grid and around unknown samples, which count as above, the rings run through the samples.
/// Errors as contour_lines.
std::vector<Polyline> filled_region(const SampledGrid& grid, double level);

/// The region lower <= field < upper, as rings for the even-odd rule. Needs lower < upper.
std::vector<Polyline> filled_band(const SampledGrid& grid, double lower, double upper);

}  // namespace nearfield::host::draw
