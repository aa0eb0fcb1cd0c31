#pragma once
/// Brute-force searches and differences that know nothing of the formulas they check.

#include "vector.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <functional>

namespace nearfield::reference {

/// Fourth-order central difference of a function of one variable; uses its values up to 2h to either side.
inline Real difference(const std::function<Real(Real)>& f, Real t, Real h = 1e-4L) {
  return (8 * (f(t + h) - f(t - h)) - (f(t + 2 * h) - f(t - 2 * h))) / (12 * h);
}

/// Least value of a convex function on [0, 1], by ternary search.
inline Real convex_minimum(const std::function<Real(Real)>& f) {
  Real low = 0;
  Real high = 1;
  for (int i = 0; i < 160; ++i) {
    const Real third = (high - low) / 3;
    if (f(low + third) <= f(high - third)) {
      high -= third;
    } else {
      low += third;
    }
  }
  return std::min({f(0), f(1), f((low + high) / 2)});
}

/// Part of a surface, a function of two parameters in [0, 1].
using Patch = std::function<Vec3(Real, Real)>;

/// Walks from parameters (u, v) of a patch to a local minimum of the distance to `p`, with steps from `reach`
/// down to 1e-10. It starts three times over, each time from where it ended: near a pole one parameter has to
/// settle before the other matters.
inline Real descended_distance(const Patch& patch, const Vec3& p, Real u, Real v, Real reach) {
  Real best = distance(p, patch(u, v));
  for (int round = 0; round < 3; ++round) {
    for (Real step = reach; step > 1e-10L;) {
      const Real from_u = u;
      const Real from_v = v;
      for (int k = -1; k <= 1; ++k) {
        for (int l = -1; l <= 1; ++l) {
          const Real try_u = std::clamp(from_u + step * static_cast<Real>(k), Real{0}, Real{1});
          const Real try_v = std::clamp(from_v + step * static_cast<Real>(l), Real{0}, Real{1});
          const Real tried = distance(p, patch(try_u, try_v));
          if (tried < best) {
            best = tried;
            u = try_u;
            v = try_v;
          }
        }
      }
      const bool moved = std::max(std::fabs(u - from_u), std::fabs(v - from_v)) > 0;
      step *= moved ? 0.95L : 0.5L;
    }
  }
  return best;
}

/// Least distance from `p` to a patch: a dense grid, and a descent from each of its local minima. Right to
/// 1e-12 for patches of metre size that turn by at most one full circle.
inline Real patch_distance(const Patch& patch, const Vec3& p) {
  constexpr int cells = 20;
  std::array<std::array<Real, cells + 1>, cells + 1> grid{};
  for (int i = 0; i <= cells; ++i) {
    for (int j = 0; j <= cells; ++j) {
      grid[static_cast<std::size_t>(i)][static_cast<std::size_t>(j)] =
          distance(p, patch(static_cast<Real>(i) / cells, static_cast<Real>(j) / cells));
    }
  }
  const auto at = [&grid](int i, int j) {
    return grid[static_cast<std::size_t>(i)][static_cast<std::size_t>(j)];
  };
  Real least = at(0, 0);
  for (int i = 0; i <= cells; ++i) {
    for (int j = 0; j <= cells; ++j) {
      bool lowest = true;
      for (int k = std::max(i - 1, 0); k <= std::min(i + 1, cells); ++k) {
        for (int l = std::max(j - 1, 0); l <= std::min(j + 1, cells); ++l) {
          lowest = lowest && at(i, j) <= at(k, l);
        }
      }
      if (!lowest) continue;
      const Real u = static_cast<Real>(i) / cells;
      const Real v = static_cast<Real>(j) / cells;
      least = std::min(least, descended_distance(patch, p, u, v, Real{1} / cells));
    }
  }
  return least;
}

}  // namespace nearfield::reference
