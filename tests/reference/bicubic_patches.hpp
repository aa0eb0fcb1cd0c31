#pragma once
/// Distances to bicubic Bezier patches, by a dense search and a descent from every local minimum of it.

#include "vector.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <vector>

namespace nearfield::reference {

class BicubicSurface {
 public:
  BicubicSurface() = default;
  /// Of 16 control points, those of u = 0 first; `cells` of the dense search each way.
  explicit BicubicSurface(const std::vector<Vec3>& control, int cells) : cells_(cells) {
    std::copy(control.begin(), control.end(), control_.begin());
    for (int i = 0; i <= cells; ++i) {
      for (int j = 0; j <= cells; ++j) {
        const Vec3 place = at(static_cast<Real>(i) / cells, static_cast<Real>(j) / cells);
        x_.push_back(static_cast<double>(place.x));
        y_.push_back(static_cast<double>(place.y));
        z_.push_back(static_cast<double>(place.z));
      }
    }
    for (int i = 0; i <= cells; ++i) {
      for (int j = 0; j < cells; ++j) {
        longest_cell_ = std::max({longest_cell_, distance(i, j, i, j + 1), distance(j, i, j + 1, i)});
      }
    }
  }

  Vec3 at(Real u, Real v) const { return sum(weights(u), weights(v)); }

  struct Nearest {
    Real distance{};
    Vec3 place;
    Real runner_up{};  // the least distance of any other local minimum, if it is not larger by more than two
                       // cells
  };
  Real distance(const Vec3& p) const { return nearest(p).distance; }
  Nearest nearest(const Vec3& p) const {
    const std::size_t side = static_cast<std::size_t>(cells_) + 1;
    std::vector<double> squares(x_.size());
    const auto px = static_cast<double>(p.x), py = static_cast<double>(p.y), pz = static_cast<double>(p.z);
    for (std::size_t i = 0; i < x_.size(); ++i) {
      const double x = x_[i] - px, y = y_[i] - py, z = z_[i] - pz;
      squares[i] = x * x + y * y + z * z;
    }
    const double least = std::sqrt(*std::min_element(squares.begin(), squares.end()));
    const double farthest = (least + 2 * static_cast<double>(longest_cell_)) * (1 + 1e-9),
                 limit = farthest * farthest;
    Nearest best{infinity, {}, infinity};
    for (std::size_t i = 0; i < side; ++i) {
      for (std::size_t j = 0; j < side; ++j) {
        const double here = squares[i * side + j];
        if (here > limit || !is_least_around(squares, i, j)) continue;
        const Place found = descended(p, {static_cast<Real>(i) / cells_, static_cast<Real>(j) / cells_});
        const Vec3 place = at(found.u, found.v);
        const Real away = reference::distance(place, p);
        const bool is_other = reference::distance(place, best.place) > 1e-6L;
        if (away < best.distance) {
          if (is_other) best.runner_up = best.distance;
          best.distance = away;
          best.place = place;
        } else if (is_other) {
          best.runner_up = std::min(best.runner_up, away);
        }
      }
    }
    return best;
  }

 private:
  static constexpr Real infinity = 1e30L;
  using Weights = std::array<Real, 4>;
  struct Place {
    Real u{}, v{};
  };

  // Bernstein's polynomials and their derivatives.
  static Weights weights(Real t) {
    const Real s = 1 - t;
    return {s * s * s, 3 * s * s * t, 3 * s * t * t, t * t * t};
  }
  static Weights first(Real t) {
    const Real s = 1 - t;
    return {-3 * s * s, 3 * s * (s - 2 * t), 3 * t * (2 * s - t), 3 * t * t};
  }
  static Weights second(Real t) { return {6 - 6 * t, 18 * t - 12, 6 - 18 * t, 6 * t}; }
  Vec3 sum(const Weights& of_u, const Weights& of_v) const {
    Vec3 total;
    for (std::size_t i = 0; i < 4; ++i) {
      Vec3 row;
      for (std::size_t j = 0; j < 4; ++j) row += of_v[j] * control_[4 * i + j];
      total += of_u[i] * row;
    }
    return total;
  }
  Real distance(int i, int j, int k, int l) const {
    const auto sample = [this](int row, int column) {
      const std::size_t index = static_cast<std::size_t>(row * (cells_ + 1) + column);
      return Vec3{static_cast<Real>(x_[index]), static_cast<Real>(y_[index]), static_cast<Real>(z_[index])};
    };
    return reference::distance(sample(i, j), sample(k, l));
  }
  bool is_least_around(const std::vector<double>& squares, std::size_t i, std::size_t j) const {
    const std::size_t last = static_cast<std::size_t>(cells_), side = last + 1;
    const double here = squares[i * side + j];
    for (std::size_t k = i > 0 ? i - 1 : 0; k <= std::min(i + 1, last); ++k) {
      for (std::size_t l = j > 0 ? j - 1 : 0; l <= std::min(j + 1, last); ++l) {
        if (squares[k * side + l] < here) return false;
      }
    }
    return true;
  }

  /// Half the squared distance from p near a place.
  struct Slopes {
    Real u{}, v{}, uu{}, uv{}, vv{};
    Real size{};  // of the curvatures
    Real distance{};
  };
  Slopes slopes(const Vec3& p, const Place& at) const {
    std::array<std::array<Vec3, 4>, 3> rows;
    const std::array<Weights, 3> of_v{weights(at.v), first(at.v), second(at.v)};
    const std::array<Weights, 3> of_u{weights(at.u), first(at.u), second(at.u)};
    for (std::size_t k = 0; k < 3; ++k) {
      for (std::size_t i = 0; i < 4; ++i) {
        for (std::size_t j = 0; j < 4; ++j) rows[k][i] += of_v[k][j] * control_[4 * i + j];
      }
    }
    const auto across = [&](std::size_t by_u, std::size_t by_v) {
      Vec3 total;
      for (std::size_t i = 0; i < 4; ++i) total += of_u[by_u][i] * rows[by_v][i];
      return total;
    };
    const Vec3 away = across(0, 0) - p, along_u = across(1, 0), along_v = across(0, 1);
    const Real speeds_u = squared_norm(along_u), speeds_v = squared_norm(along_v);
    return {dot(away, along_u),
            dot(away, along_v),
            speeds_u + dot(away, across(2, 0)),
            dot(along_u, along_v) + dot(away, across(1, 1)),
            speeds_v + dot(away, across(0, 2)),
            speeds_u + speeds_v + 1e-30L,
            squared_norm(away)};
  }
  /// Downhill from a place, by damped Newton steps within the patch (Levenberg, Marquardt).
  Place descended(const Vec3& p, Place from) const {
    constexpr Real least_damping = 1e-9L;
    Real damping = least_damping;
    Slopes here = slopes(p, from);
    for (int i = 0; i < 200 && damping < 1e9L; ++i) {
      const bool u_fixed = (from.u <= 0 && here.u >= 0) || (from.u >= 1 && here.u <= 0);
      const bool v_fixed = (from.v <= 0 && here.v >= 0) || (from.v >= 1 && here.v <= 0);
      if (u_fixed && v_fixed) break;
      const Real a = here.uu + damping * here.size, c = here.vv + damping * here.size;
      const Real b = u_fixed || v_fixed ? 0 : here.uv, determinant = a * c - b * b;
      if ((u_fixed || a > 0) && (v_fixed || c > 0) && (u_fixed || v_fixed || determinant > 0)) {
        const Real step_u = u_fixed ? 0 : v_fixed ? -here.u / a : (b * here.v - c * here.u) / determinant;
        const Real step_v = v_fixed ? 0 : u_fixed ? -here.v / c : (b * here.u - a * here.v) / determinant;
        Place next{std::clamp<Real>(from.u + step_u, 0, 1), std::clamp<Real>(from.v + step_v, 0, 1)};
        // Where one is held back, the other one goes where it then is least.
        if (next.u != from.u + step_u)
          next.v = std::clamp<Real>(from.v - (here.v + here.uv * (next.u - from.u)) / c, 0, 1);
        else if (next.v != from.v + step_v)
          next.u = std::clamp<Real>(from.u - (here.u + here.uv * (next.v - from.v)) / a, 0, 1);
        const Real change = std::fabs(next.u - from.u) + std::fabs(next.v - from.v);
        // Newton's next step would be the square of that.
        const bool converges_fast = std::min(a, c) > 1e-3L * here.size && determinant > 1e-3L * a * c;
        if (damping <= least_damping && change < 1e-9L && converges_fast) return next;
        if (change < 1e-13L) return from;
        const Slopes there = slopes(p, next);
        if (there.distance < here.distance) {
          from = next;
          here = there;
          damping = std::max(damping / 100, least_damping);
          continue;
        }
      }
      damping = std::max<Real>(damping * 30, 1e-6L);
    }
    return from;
  }

  std::array<Vec3, 16> control_;
  int cells_ = 0;
  std::vector<double> x_, y_, z_;
  Real longest_cell_ = 0;
};

}  // namespace nearfield::reference
