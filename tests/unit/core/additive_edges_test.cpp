/// Continuity of the additive blends across every edge where their formulas' pieces meet, measured by
/// differences: value and slope from one unit to the next; first and second derivatives on both sides from
/// farther away.

#include "unit/core/additive_rows.hpp"

#include <cstdio>

namespace nearfield::additive_tests {
namespace {

using Q = Fixed<27>;

/// The blend's intersection with 0 over the widest range, 4 m, so that arguments and values are fine: per
/// range.
class Measured {
 public:
  explicit Measured(const Row& row) : row_(row), table_(bake<Q, 1024>(row.kernel)) {}

  BlendPoint at(Q x) const {
    return blended<Q, SetOperation::intersect>(row_.sides, range(), table_, x, Q());
  }
  static Q range() { return Q(4.0); }
  static Q place(Real gap) { return property::rounded<Q>(4 * gap); }

  /// From the left of an edge to its right, by differences over 2 step on either side and of errors of order
  /// step^2, extrapolated to step 0.
  struct Jumps {
    Real first = 0, second = 0;  // of dB/dx by values, of its derivative by slopes
  };
  Jumps jumps(Real edge) const {
    const Real step = step_at(edge);
    const auto value = [this](Q x) { return at(x).value / 4; };
    const auto slope = [this](Q x) { return at(x).by_x; };
    return {(4 * jump(value, edge, step / 2) - jump(value, edge, step)) / 3,
            (4 * jump(slope, edge, step / 2) - jump(slope, edge, step)) / 3};
  }

 private:
  /// Within two of them there is no other edge, and of a step only a part.
  Real step_at(Real edge) const {
    Real nearest = 2;
    for (const Real other : row_.edges) {
      if (std::fabs(other - edge) > 1e-6L) nearest = std::min(nearest, std::fabs(other - edge));
    }
    return std::min({nearest / 2.5L, row_.narrowest / 4, Real{1} / 64});
  }
  template <class Function>
  Real jump(const Function& f, Real edge, Real step) const {
    return derivative(f, edge, step) - derivative(f, edge, -step);
  }
  template <class Function>
  Real derivative(const Function& f, Real edge, Real step) const {
    const Q here = place(edge), one = place(edge + step), two = place(edge + 2 * step);
    const Real h = real(one - here) / 4;
    return (4 * f(one) - 3 * f(here) - f(two)) / (2 * h);
  }

  const Row& row_;
  Table<Q, 1024> table_;
};

TEST(AdditiveBlendEdges, ValuesAndSlopesGoOnFromUnitToUnit) {
  constexpr Real unit = 1.0L / (1 << 27);
  int edges = 0;
  for (const Row& row : all_rows()) {
    const Table<Q, 64> table = bake<Q, 64>(row.kernel);
    const Q range(1.0);
    // How much a slope may change over two units, and log-sum-exp is cut off where its slope is e^-18.
    const Real slope_slack =
        (64 + 4 * std::ldexp(Real{1}, table.slope_headroom)) * unit + 2e-8L + 64 * row.jump;
    std::vector<Real> places = row.edges;
    for (const int knot : {1, 7, 13, 32, 33, 48, 63}) {
      places.push_back(static_cast<Real>(knot) / 64);
      places.push_back(static_cast<Real>(-knot) / 64);
    }
    for (const Real edge : places) {
      const bool kinked = row.continuous_derivatives < 1;
      BlendPoint before{};
      for (int i = -3; i <= 3; ++i) {
        const Q x = moved<Q>(property::rounded<Q>(edge), i);
        const BlendPoint here = blended<Q, SetOperation::intersect>(row.sides, range, table, x, Q());
        if (i > -3) {
          EXPECT_LE(std::fabs(here.value - before.value), 4 * unit + row.jump) << row.name << " at " << edge;
          if (!kinked) {
            EXPECT_LE(std::fabs(here.by_x - before.by_x), slope_slack) << row.name << " at " << edge;
            EXPECT_LE(std::fabs(here.by_y - before.by_y), slope_slack) << row.name << " at " << edge;
          }
        }
        before = here;
      }
      ++edges;
    }
  }
  std::printf("%d edges and knots\n", edges);
}

/// What the same blend of the step with one continuous derivative less jumps by, the least where it jumps at
/// all: of H_1, mu' jumps by 1/2; of H_2, mu'' by 1. Per range.
Real first_jump_of_H_1(const Row& row) { return row.family == Family::exterior ? row.ratio / 8 : 0.5L; }
Real second_jump_of_H_2(const Row& row) {
  return row.family == Family::exterior ? (1 + row.ratio) / 4 : row.family == Family::interior ? 1 : 0.5L;
}
/// A tenth of that is taken for continuous.
constexpr Real continuous_share = 0.1L;
/// A table of 1024 segments cannot follow the second derivative of a step that rises within fewer.
constexpr Real four_segments = 4.0L / 1024;

TEST(AdditiveBlendEdges, FirstAndSecondDerivativesAreContinuous) {
  Real worst_first = 0, worst_second = 0;
  int first = 0, second = 0, too_steep = 0;
  for (const Row& row : all_rows()) {
    if (row.continuous_derivatives < 1) continue;
    if (row.narrowest < four_segments) {
      ++too_steep;
      continue;
    }
    const Measured measured(row);
    for (const Real edge : row.edges) {
      const Measured::Jumps jumps = measured.jumps(edge);
      const Real of_first = std::fabs(jumps.first) / first_jump_of_H_1(row);
      EXPECT_LE(of_first, continuous_share) << row.name << " at " << edge << ": first derivative";
      worst_first = std::max(worst_first, of_first);
      ++first;
      if (row.continuous_derivatives < 2) continue;
      const Real of_second = std::fabs(jumps.second) / second_jump_of_H_2(row);
      EXPECT_LE(of_second, continuous_share) << row.name << " at " << edge << ": second derivative";
      worst_second = std::max(worst_second, of_second);
      ++second;
    }
  }
  std::printf(
      "greatest jump at %d edges: of the first derivative %.4Lf of that of H_1; at %d edges: of the second "
      "%.4Lf"
      " of that of H_2; %d blends are too steep to measure\n",
      first, worst_first, second, worst_second, too_steep);
  EXPECT_LE(too_steep, 8);
}

/// Edges at the ends of a step of range epsilon, where nothing but the step itself ends.
std::vector<Real> ends_of_step(const Row& row) {
  if (row.family == Family::interior) return {-1, 1};
  const Real delta = 1 / (1 + row.ratio), epsilon = row.ratio / (1 + row.ratio);
  std::vector<Real> ends = {-1, 1};
  if (row.ratio < 1) ends.insert(ends.end(), {delta - epsilon, epsilon - delta});
  return ends;
}

// The measure sees what is not continuous: a first derivative of H_1, a second one of H_2.
TEST(AdditiveBlendEdges, JumpsAreSeenWhereThereAreSome) {
  Real least_first = 2, greatest_first = 0, least_second = 2, greatest_second = 0;
  for (const Row& row : all_rows()) {
    const bool one = row.step == "H_1" || row.step == "B_1", two = row.step == "H_2" || row.step == "B_2";
    if (!one && !two) continue;
    const Measured measured(row);
    for (const Real edge : ends_of_step(row)) {
      const Measured::Jumps jumps = measured.jumps(edge);
      const Real of_first = std::fabs(jumps.first) / first_jump_of_H_1(row);
      const Real of_second = std::fabs(jumps.second) / second_jump_of_H_2(row);
      if (one) {
        EXPECT_GT(of_first, 5 * continuous_share) << row.name << " at " << edge;
        EXPECT_NEAR(static_cast<double>(of_first), 1, 0.2) << row.name << " at " << edge;
        least_first = std::min(least_first, of_first);
        greatest_first = std::max(greatest_first, of_first);
      } else {
        EXPECT_GT(of_second, 5 * continuous_share) << row.name << " at " << edge;
        EXPECT_NEAR(static_cast<double>(of_second), 1, 0.1) << row.name << " at " << edge;
        least_second = std::min(least_second, of_second);
        greatest_second = std::max(greatest_second, of_second);
      }
    }
  }
  std::printf("seen of the jumps of H_1: %.3Lf to %.3Lf, of H_2: %.3Lf to %.3Lf\n", least_first,
              greatest_first, least_second, greatest_second);
  EXPECT_LT(least_first, 2);
  EXPECT_LT(least_second, 2);
}

TEST(AdditiveBlendEdges, TheQuadraticBlendHasNoSecondDerivativeWhereItEnds) {
  for (const Row& row : all_rows()) {
    if (row.family != Family::quadratic) continue;
    EXPECT_NEAR(static_cast<double>(std::fabs(Measured(row).jumps(1).second)), 0.5, 0.01);
  }
}

}  // namespace
}  // namespace nearfield::additive_tests
