#pragma once
/// Distances to chains of cubic polynomials, by a dense search and a refinement of every local minimum.

#include "vector.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <vector>

namespace nearfield::reference {

/// a + b t + c t^2 + d t^3, t in [0, 1].
struct CubicPiece {
  Vec3 a, b, c, d;

  Vec3 at(Real t) const { return a + t * (b + t * (c + t * d)); }
  Vec3 velocity(Real t) const { return b + t * (2 * c + (3 * t) * d); }
  Vec3 acceleration(Real t) const { return 2 * c + (6 * t) * d; }
};

inline CubicPiece bezier_piece(const Vec3& p, const Vec3& q, const Vec3& r, const Vec3& s) {
  return {p, 3 * (q - p), 3 * (p - 2 * q + r), s - p + 3 * (q - r)};
}
/// From the basis functions (1 - t)^3 / 6, (3 t^3 - 6 t^2 + 4) / 6, (-3 t^3 + 3 t^2 + 3 t + 1) / 6 and t^3
/// / 6.
inline CubicPiece spline_piece(const Vec3& p, const Vec3& q, const Vec3& r, const Vec3& s) {
  return {(p + 4 * q + r) / 6, (r - p) / 2, (p - 2 * q + r) / 2, (s - p + 3 * (q - r)) / 6};
}

class CubicChain {
 public:
  CubicChain() = default;
  explicit CubicChain(std::vector<CubicPiece> pieces) : pieces_(std::move(pieces)) {
    for (const CubicPiece& piece : pieces_) {
      for (int i = 0; i <= cells; ++i) {
        samples_.push_back(piece.at(static_cast<Real>(i) / cells));
        if (i > 0)
          longest_cell_ =
              std::max(longest_cell_, 1.5L * reference::distance(samples_.back(), *(samples_.end() - 2)));
      }
    }
  }
  const std::vector<CubicPiece>& pieces() const { return pieces_; }

  struct Nearest {
    Real distance{};
    Vec3 place;
    Real runner_up{};  // the least distance of any other local minimum, if it is not larger by more than a
                       // cell
  };
  Real distance(const Vec3& p) const { return nearest(p).distance; }
  Nearest nearest(const Vec3& p) const {
    std::vector<double> squares;
    squares.reserve(samples_.size());
    for (const Vec3& sample : samples_) squares.push_back(static_cast<double>(squared_norm(sample - p)));
    const Real least = std::sqrt(static_cast<Real>(*std::min_element(squares.begin(), squares.end())));
    Nearest best{infinity, {}, infinity};
    for (std::size_t piece = 0; piece < pieces_.size(); ++piece) {
      const double* of = squares.data() + piece * (cells + 1);
      for (int i = 0; i <= cells; ++i) {
        if ((i > 0 && of[i - 1] < of[i]) || (i < cells && of[i + 1] < of[i])) continue;
        if (std::sqrt(static_cast<Real>(of[i])) > least + longest_cell_) continue;
        const Vec3 place =
            pieces_[piece].at(refined(pieces_[piece], p, std::max(i - 1, 0), std::min(i + 1, cells)));
        const Real found = reference::distance(place, p);
        // An end that two pieces share is no other minimum.
        const bool is_other = reference::distance(place, best.place) > 1e-6L;
        if (found < best.distance) {
          if (is_other) best.runner_up = best.distance;
          best.distance = found;
          best.place = place;
        } else if (is_other) {
          best.runner_up = std::min(best.runner_up, found);
        }
      }
    }
    return best;
  }

 private:
  static constexpr int cells = 24;
  static constexpr Real infinity = 1e30L;

  /// The least distance between two samples, by Newton steps on its slope that bisection keeps in place.
  static Real refined(const CubicPiece& piece, const Vec3& p, int first, int last) {
    Real low = static_cast<Real>(first) / cells, high = static_cast<Real>(last) / cells;
    const auto slope = [&](Real t) { return dot(piece.at(t) - p, piece.velocity(t)); };
    if (slope(low) > 0) return low;
    if (slope(high) < 0) return high;
    Real t = (low + high) / 2;
    for (int i = 0; i < 60; ++i) {
      const Vec3 velocity = piece.velocity(t), from_p = piece.at(t) - p;
      const Real s = dot(from_p, velocity);
      if (!(std::fabs(s) > 0)) break;
      (s > 0 ? high : low) = t;
      const Real next = t - s / (squared_norm(velocity) + dot(from_p, piece.acceleration(t)));
      const Real stepped = next > low && next < high ? next : (low + high) / 2;
      if (std::fabs(stepped - t) < 1e-14L) break;
      t = stepped;
    }
    return t;
  }

  std::vector<CubicPiece> pieces_;
  std::vector<Vec3> samples_;
  Real longest_cell_ = 0;
};

}  // namespace nearfield::reference
