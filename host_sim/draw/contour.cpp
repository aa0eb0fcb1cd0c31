#include "draw/contour.hpp"

#include <cmath>
#include <iterator>
#include <limits>
#include <stdexcept>

namespace nearfield::host::draw {
namespace {

enum class Border { open, closed };

/// Walks one level through the grid. With a closed border the grid is seen with one more ring of samples
/// around it, all above any level.
class MarchingSquares {
 public:
  MarchingSquares(const SampledGrid& grid, double level, Border border)
      : grid_(grid),
        level_(level),
        margin_(border == Border::closed ? 1 : 0),
        unknown_is_above_(border == Border::closed),
        columns_(grid.columns + 2 * margin_),
        rows_(grid.rows + 2 * margin_),
        next_(2 * columns_ * rows_, none),
        entered_(2 * columns_ * rows_, false) {}

  std::vector<Polyline> lines() {
    for (std::size_t row = 0; row + 1 < rows_; ++row) {
      for (std::size_t column = 0; column + 1 < columns_; ++column) link_cell(column, row);
    }
    std::vector<Polyline> result;
    for (std::size_t edge = 0; edge < next_.size(); ++edge) {
      if (next_[edge] != none && !entered_[edge]) add_line(edge, result);
    }
    for (std::size_t edge = 0; edge < next_.size(); ++edge) {
      if (next_[edge] != none) add_line(edge, result);
    }
    return result;
  }

 private:
  static constexpr std::size_t none = std::numeric_limits<std::size_t>::max();

  double value(std::size_t column, std::size_t row) const {
    const bool outside =
        column < margin_ || row < margin_ || column >= grid_.columns + margin_ || row >= grid_.rows + margin_;
    const double sample =
        outside ? std::numeric_limits<double>::infinity() : grid_.value(column - margin_, row - margin_);
    return unknown_is_above_ && !std::isfinite(sample) ? std::numeric_limits<double>::infinity() : sample;
  }

  std::size_t horizontal_edge(std::size_t column, std::size_t row) const {
    return 2 * (row * columns_ + column);
  }
  std::size_t vertical_edge(std::size_t column, std::size_t row) const {
    return 2 * (row * columns_ + column) + 1;
  }

  void link(std::size_t from, std::size_t to) {
    next_[from] = to;
    entered_[to] = true;
  }

  void link_cell(std::size_t column, std::size_t row) {
    const double corner[4] = {value(column, row), value(column + 1, row), value(column + 1, row + 1),
                              value(column, row + 1)};
    unsigned below = 0;
    for (unsigned i = 0; i < 4; ++i) {
      if (!unknown_is_above_ && !std::isfinite(corner[i])) return;
      if (corner[i] < level_) below |= 1u << i;
    }
    const std::size_t bottom = horizontal_edge(column, row);
    const std::size_t top = horizontal_edge(column, row + 1);
    const std::size_t left = vertical_edge(column, row);
    const std::size_t right = vertical_edge(column + 1, row);
    const double centre = 0.25 * corner[0] + 0.25 * corner[1] + 0.25 * corner[2] + 0.25 * corner[3];
    const bool joined = centre < level_;
    switch (below) {
      case 0b0001:
        link(bottom, left);
        break;
      case 0b0010:
        link(right, bottom);
        break;
      case 0b0011:
        link(right, left);
        break;
      case 0b0100:
        link(top, right);
        break;
      case 0b0110:
        link(top, bottom);
        break;
      case 0b0111:
        link(top, left);
        break;
      case 0b1000:
        link(left, top);
        break;
      case 0b1001:
        link(bottom, top);
        break;
      case 0b1011:
        link(right, top);
        break;
      case 0b1100:
        link(left, right);
        break;
      case 0b1101:
        link(bottom, right);
        break;
      case 0b1110:
        link(left, bottom);
        break;
      case 0b0101:
        link(bottom, joined ? right : left);
        link(top, joined ? left : right);
        break;
      case 0b1010:
        link(left, joined ? bottom : top);
        link(right, joined ? top : bottom);
        break;
      default:
        break;
    }
  }

  Point grid_position(std::size_t column, std::size_t row) const {
    return grid_.position(column - margin_, row - margin_);
  }

  Point crossing(std::size_t edge) const {
    const std::size_t column = (edge / 2) % columns_;
    const std::size_t row = (edge / 2) / columns_;
    const std::size_t end_column = column + (edge % 2 == 0 ? 1 : 0);
    const std::size_t end_row = row + (edge % 2 == 0 ? 0 : 1);
    const double a = value(column, row);
    const double b = value(end_column, end_row);
    if (!std::isfinite(a)) return grid_position(end_column, end_row);
    if (!std::isfinite(b)) return grid_position(column, row);
    const double t = (level_ - a) / (b - a);
    const Point from = grid_position(column, row);
    return edge % 2 == 0 ? Point{from.x + t * grid_.step_x, from.y}
                         : Point{from.x, from.y + t * grid_.step_y};
  }

  static bool same(Point a, Point b) { return a.x == b.x && a.y == b.y; }

  void add_line(std::size_t start, std::vector<Polyline>& result) {
    Polyline line;
    line.closed = entered_[start];
    std::size_t edge = start;
    while (edge != none) {
      const Point p = crossing(edge);
      if (line.points.empty() || !same(line.points.back(), p)) line.points.push_back(p);
      const std::size_t following = next_[edge];
      next_[edge] = none;
      edge = following == start ? none : following;
    }
    if (line.closed && line.points.size() > 1 && same(line.points.back(), line.points.front())) {
      line.points.pop_back();
    }
    if (line.points.size() >= (line.closed ? 3u : 2u)) result.push_back(line);
  }

  const SampledGrid& grid_;
  double level_;
  std::size_t margin_;
  bool unknown_is_above_;
  std::size_t columns_;
  std::size_t rows_;
  std::vector<std::size_t> next_;  ///< of each crossed edge, the edge where the line goes on
  std::vector<bool> entered_;      ///< whether a line arrives at the edge
};

void check(const SampledGrid& grid, double level) {
  if (grid.columns < 2 || grid.rows < 2 || grid.values.size() / grid.columns != grid.rows ||
      grid.values.size() % grid.columns != 0) {
    throw std::invalid_argument("draw: a grid needs two columns, two rows and a value for each sample");
  }
  if (!(grid.step_x > 0.0) || !(grid.step_y > 0.0)) {
    throw std::invalid_argument("draw: the steps of a grid must be greater than zero");
  }
  if (!std::isfinite(level)) throw std::invalid_argument("draw: a contour level must be finite");
}

}  // namespace

std::vector<Polyline> contour_lines(const SampledGrid& grid, double level) {
  check(grid, level);
  return MarchingSquares(grid, level, Border::open).lines();
}

std::vector<Polyline> filled_region(const SampledGrid& grid, double level) {
  check(grid, level);
  return MarchingSquares(grid, level, Border::closed).lines();
}

std::vector<Polyline> filled_band(const SampledGrid& grid, double lower, double upper) {
  if (!(lower < upper)) throw std::invalid_argument("draw: a band needs lower < upper");
  std::vector<Polyline> rings = filled_region(grid, upper);
  std::vector<Polyline> holes = filled_region(grid, lower);
  rings.insert(rings.end(), std::make_move_iterator(holes.begin()), std::make_move_iterator(holes.end()));
  return rings;
}

}  // namespace nearfield::host::draw
