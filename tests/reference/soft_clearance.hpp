#pragma once
/// The distance from a point to the surface F = ½ of a sum of potentials about points, F = Σ cᵢ P(rᵢ/Rᵢ),
/// found by dense search alone: the field is sampled along rays from the point into all directions and
/// towards all parts of the balls of influence; every first crossing is then moved along the surface to a
/// local minimum of the distance. In double: relative errors of 1e-6 matter here, not of 1e-18.
///
/// Whatever is found lies on the surface, so that the true distance is never greater than the result; it can
/// be less only where every ray misses a part of the solid.

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <utility>
#include <vector>

namespace nearfield::reference {

/// Radius of influence R > 0; strength c may be negative.
struct SoftBall {
  std::array<double, 3> center{};
  double radius = 1;
  double strength = 1;
};

/// How densely the search looks: rays from the point into all directions, rays towards each ball, samples
/// along a ray, local minimisations.
struct SearchDensity {
  int directions = 240;
  int rays_per_ball = 56;
  int samples = 40;
  int descents = 24;
};

/// A long double curve, such as those of potential_curves.hpp, as a callable of double.
template <class Curve>
auto taking_double(const Curve& curve) {
  return [curve](double r) { return curve(static_cast<long double>(r)); };
}

/// `Potential`: a callable of double, r in [0, 1], whose result has `value` and `first`.
template <class Potential>
class SoftClearanceSearch {
 public:
  using Point = std::array<double, 3>;

  SoftClearanceSearch(std::vector<SoftBall> balls, Potential potential, SearchDensity density = {})
      : balls_(std::move(balls)), potential_(std::move(potential)), density_(density) {}

  /// F(p).
  double intensity(const Point& p) const {
    double sum = 0;
    for (const SoftBall& ball : balls_) {
      const double relative = norm(minus(p, ball.center)) / ball.radius;
      if (relative < 1) sum += ball.strength * static_cast<double>(potential_(relative).value);
    }
    return sum;
  }

  /// Distance from p to the nearest point with F ≥ ½: 0 where F(p) ≥ ½, infinite where none was found.
  double clearance(const Point& p) const {
    if (intensity(p) >= 0.5) return 0;
    double nearest = infinity;
    std::vector<Seed> seeds;
    for (const SoftBall& ball : balls_) {
      if (ball.strength <= 0) continue;
      const double away = norm(minus(ball.center, p));
      if (away > 0) cast(p, times(minus(ball.center, p), 1 / away), seeds, nearest);
      for (const double share : {0.3, 0.6, 0.9}) {
        const int count = density_.rays_per_ball / 3;
        for (int i = 0; i < count; ++i) {
          const Point target = plus(ball.center, times(fibonacci_direction(i, count), share * ball.radius));
          const Point towards = minus(target, p);
          const double length = norm(towards);
          if (length > 0) cast(p, times(towards, 1 / length), seeds, nearest);
        }
      }
    }
    for (int i = 0; i < density_.directions; ++i) {
      cast(p, fibonacci_direction(i, density_.directions), seeds, nearest);
    }
    return refined(p, seeds);
  }

 private:
  struct Seed {
    double distance = 0;
    Point place{};
  };
  struct Sample {
    double value = 0;
    Point gradient{};
  };

  static constexpr double infinity = std::numeric_limits<double>::infinity();

  static Point plus(const Point& a, const Point& b) { return {a[0] + b[0], a[1] + b[1], a[2] + b[2]}; }
  static Point minus(const Point& a, const Point& b) { return {a[0] - b[0], a[1] - b[1], a[2] - b[2]}; }
  static Point times(const Point& a, double scale) { return {a[0] * scale, a[1] * scale, a[2] * scale}; }
  static double dot(const Point& a, const Point& b) { return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]; }
  static double norm(const Point& a) { return std::sqrt(dot(a, a)); }

  static Point fibonacci_direction(int i, int count) {
    const double z = 1 - (2 * static_cast<double>(i) + 1) / static_cast<double>(count);
    const double turn = 2.39996322972865332 * static_cast<double>(i);
    const double radius = std::sqrt(1 - z * z);
    return {radius * std::cos(turn), radius * std::sin(turn), z};
  }

  Sample sample(const Point& p) const {
    Sample sum;
    for (const SoftBall& ball : balls_) {
      const Point from_center = minus(p, ball.center);
      const double r = norm(from_center);
      if (r >= ball.radius) continue;
      const auto potential = potential_(r / ball.radius);
      sum.value += ball.strength * static_cast<double>(potential.value);
      if (r > 0) {
        const double slope = ball.strength * static_cast<double>(potential.first) / (ball.radius * r);
        sum.gradient = plus(sum.gradient, times(from_center, slope));
      }
    }
    return sum;
  }

  /// Part of the ray that lies in the balls that add to the field, up to `limit`; empty if first ≥ second.
  std::pair<double, double> influenced_part(const Point& p, const Point& direction, double limit) const {
    double begin = infinity;
    double end = 0;
    for (const SoftBall& ball : balls_) {
      if (ball.strength <= 0) continue;
      const Point to_center = minus(ball.center, p);
      const double along = dot(to_center, direction);
      const double half_squared = ball.radius * ball.radius - dot(to_center, to_center) + along * along;
      if (half_squared <= 0) continue;
      const double half = std::sqrt(half_squared);
      if (along + half <= 0) continue;
      begin = std::min(begin, std::max(along - half, 0.0));
      end = std::max(end, along + half);
    }
    return {begin, std::min(end, limit)};
  }

  /// Adds the first crossing of the ray, or the place on the surface up the field from its strongest sample.
  void cast(const Point& p, const Point& direction, std::vector<Seed>& seeds, double& nearest) const {
    // Crossings a little farther than the nearest so far may still lead to a nearer minimum.
    const auto [begin, end] = influenced_part(p, direction, 1.5 * nearest);
    if (!(begin < end)) return;
    double strongest = 0;
    double strongest_at = begin;
    double before = begin;
    for (int i = 1; i <= density_.samples; ++i) {
      const double at =
          begin + (end - begin) * static_cast<double>(i) / static_cast<double>(density_.samples);
      const double value = intensity(plus(p, times(direction, at)));
      if (value >= 0.5) {
        add_crossing(p, direction, before, at, seeds, nearest);
        return;
      }
      if (value > strongest) {
        strongest = value;
        strongest_at = at;
      }
      before = at;
    }
    if (strongest < 0.2) return;
    Point place = plus(p, times(direction, strongest_at));
    if (!project(place)) return;
    const double distance = norm(minus(place, p));
    nearest = std::min(nearest, distance);
    seeds.push_back({distance, place});
  }

  void add_crossing(const Point& p, const Point& direction, double outside, double inside,
                    std::vector<Seed>& seeds, double& nearest) const {
    for (int i = 0; i < 20; ++i) {
      const double middle = (outside + inside) / 2;
      (intensity(plus(p, times(direction, middle))) >= 0.5 ? inside : outside) = middle;
    }
    nearest = std::min(nearest, inside);
    seeds.push_back({inside, plus(p, times(direction, inside))});
  }

  /// Newton's method along the gradient; false if it does not end on the surface.
  bool project(Point& place) const {
    double least_radius = infinity;
    for (const SoftBall& ball : balls_) least_radius = std::min(least_radius, ball.radius);
    for (int i = 0; i < 30; ++i) {
      const Sample here = sample(place);
      const double excess = 0.5 - here.value;
      const double squared = dot(here.gradient, here.gradient);
      if (!(squared > 0)) return false;
      double step = excess / squared;
      const double length = std::fabs(step) * std::sqrt(squared);
      if (length > 0.2 * least_radius) step *= 0.2 * least_radius / length;
      place = plus(place, times(here.gradient, step));
      if (length < 1e-13 * least_radius) return true;
    }
    return std::fabs(intensity(place) - 0.5) < 1e-11;
  }

  /// Moves a place on the surface to where its distance from p is least, by steps along the surface that are
  /// tried at lengths growing and shrinking by their success.
  double descended(const Point& p, Point place) const {
    if (!project(place)) return infinity;
    double distance = norm(minus(place, p));
    double step = 0.5;
    for (int i = 0; i < 200 && step > 1e-9; ++i) {
      const Point gradient = sample(place).gradient;
      const Point towards = minus(p, place);
      const Point along = minus(towards, times(gradient, dot(towards, gradient) / dot(gradient, gradient)));
      if (!(norm(along) > 1e-7 * distance)) break;
      Point moved = plus(place, times(along, step));
      const bool is_on_surface = project(moved);
      const double reached = norm(minus(moved, p));
      if (is_on_surface && reached < distance) {
        place = moved;
        distance = reached;
        step = std::min(step * 1.6, 1e3);
      } else {
        step *= 0.35;
      }
    }
    return distance;
  }

  /// The least distance reached from seeds that are spread, the nearest ones first.
  double refined(const Point& p, std::vector<Seed>& seeds) const {
    std::sort(seeds.begin(), seeds.end(),
              [](const Seed& a, const Seed& b) { return a.distance < b.distance; });
    double least = infinity;
    int descents = 0;
    std::vector<Point> starts;
    double spacing = infinity;
    for (const SoftBall& ball : balls_) spacing = std::min(spacing, 0.1 * ball.radius);
    for (const Seed& seed : seeds) {
      if (descents >= density_.descents) break;
      const bool is_near_another = std::any_of(starts.begin(), starts.end(), [&](const Point& start) {
        return norm(minus(start, seed.place)) < spacing;
      });
      if (is_near_another) continue;
      starts.push_back(seed.place);
      ++descents;
      least = std::min({least, seed.distance, descended(p, seed.place)});
    }
    return least;
  }

  std::vector<SoftBall> balls_;
  Potential potential_;
  SearchDensity density_;
};

template <class Potential>
double soft_clearance(const std::vector<SoftBall>& balls, const Potential& potential,
                      const std::array<double, 3>& p, const SearchDensity& density = {}) {
  return SoftClearanceSearch<Potential>(balls, potential, density).clearance(p);
}

}  // namespace nearfield::reference
