#pragma once

#include <cmath>
#include <cstddef>
#include <vector>

#include "draw/scene_picture.hpp"
#include "draw/timeline.hpp"

namespace nearfield::host::draw::sample {

/// A made-up cell for the tests of pictures: a table of 1.6 m by 1.2 m with a pillar on it, blended; a
/// six-axis arm on a pedestal and a person beside the table. Only +, -, *, / and sqrt, so every compiler
/// gives the same numbers.

inline double box_distance(const Vec3& p, const Vec3& centre, const Vec3& half) {
  double outside = 0.0;
  double inside = -1e9;
  for (std::size_t i = 0; i < 3; ++i) {
    const double d = std::fabs(p[i] - centre[i]) - half[i];
    outside += d > 0.0 ? d * d : 0.0;
    inside = d > inside ? d : inside;
  }
  return std::sqrt(outside) + (inside < 0.0 ? inside : 0.0);
}

inline double capsule_distance(const Vec3& p, const Vec3& a, const Vec3& b, double radius) {
  double along = 0.0;
  double length = 0.0;
  for (std::size_t i = 0; i < 3; ++i) {
    along += (p[i] - a[i]) * (b[i] - a[i]);
    length += (b[i] - a[i]) * (b[i] - a[i]);
  }
  double t = along / length;
  t = t < 0.0 ? 0.0 : (t > 1.0 ? 1.0 : t);
  double squared = 0.0;
  for (std::size_t i = 0; i < 3; ++i) {
    const double d = p[i] - a[i] - t * (b[i] - a[i]);
    squared += d * d;
  }
  return std::sqrt(squared) - radius;
}

inline double smooth_least(double a, double b, double width) {
  const double h = width - std::fabs(a - b);
  const double least = a < b ? a : b;
  return h > 0.0 ? least - h * h / (4.0 * width) : least;
}

inline double cell_distance(const Vec3& p) {
  const double table = box_distance(p, {0.5, 0.0, -0.05}, {0.8, 0.6, 0.05});
  const double pillar = capsule_distance(p, {0.75, 0.35, 0.0}, {0.75, 0.35, 0.55}, 0.06);
  return smooth_least(table, pillar, 0.1);
}

inline ScenePicture picture() {
  ScenePicture scene;
  scene.title = "Person steps up to the table";
  scene.letter = "C";
  scene.time = 12.34;
  scene.zone = Zone::slow;
  scene.speed_override = 0.42;
  scene.clearances = {{"to the cell", 0.0858}, {"to the person", 0.312}, {"to itself", 0.131}};
  scene.note = "The arm has begun to lift off the pillar.";
  scene.top.title = "Top view, cut at z = 0.30 m";
  scene.top.window = {-0.65, 2.0, -1.0, 1.0};
  scene.top.field = sample_grid({-0.65, -1.0}, {2.0, 1.0}, 160, 121, [](double x, double y) {
    return cell_distance({x, y, 0.30});
  });
  scene.side.title = "Side view, cut at y = 0.35 m";
  scene.side.window = {-0.65, 2.0, -0.15, 1.85};
  scene.side.field = sample_grid({-0.65, -0.15}, {2.0, 1.85}, 160, 121, [](double x, double z) {
    return cell_distance({x, 0.35, z});
  });
  scene.contour_spacing = 0.05;
  scene.contour_count = 8;

  const std::vector<Vec3> joints = {{0.0, 0.0, 0.02},   {0.0, 0.0, 0.30},    {0.22, 0.10, 0.66},
                                    {0.52, 0.22, 0.52}, {0.60, 0.255, 0.40}, {0.655, 0.20, 0.30}};
  const double radii[] = {0.085, 0.07, 0.055, 0.05, 0.04};
  for (std::size_t i = 0; i + 1 < joints.size(); ++i)
    scene.arm.push_back({joints[i], joints[i + 1], radii[i]});
  scene.arm.push_back({joints.back(), joints.back(), 0.045});
  scene.joints = joints;

  scene.person = {
      {{1.5, -0.1, 0.08}, {1.5, -0.1, 0.85}, 0.08},   {{1.52, 0.12, 0.08}, {1.5, 0.12, 0.85}, 0.08},
      {{1.5, 0.01, 0.95}, {1.5, 0.01, 1.35}, 0.16},   {{1.48, 0.01, 1.62}, {1.48, 0.01, 1.66}, 0.11},
      {{1.48, -0.2, 1.35}, {1.2, -0.22, 1.12}, 0.05}, {{1.48, 0.22, 1.35}, {1.08, 0.2, 0.98}, 0.05}};
  scene.nearest = NearestPair{{0.66, 0.22, 0.345}, {0.72, 0.28, 0.345}, 0.0858, {-0.7, -0.7, 0.15}};
  scene.repulsion = RepulsionArrow{{0.655, 0.20, 0.30}, {-0.10, -0.18, 0.22}};
  for (int i = 0; i <= 3000; ++i) {
    const double t = i / 3000.0;
    scene.tool_path.push_back({1.05 - 0.395 * t, -0.45 + 0.65 * t - 0.8 * t * (1.0 - t),
                               0.12 + 0.18 * t + 0.9 * t * (1.0 - t) * (1.0 - t)});
  }
  return scene;
}

/// A triangle wave of period 1 between -1 and 1.
inline double wave(double t) {
  const double phase = t - std::floor(t);
  return phase < 0.5 ? 4.0 * phase - 1.0 : 3.0 - 4.0 * phase;
}

/// A run of 24,000 samples, one each millisecond.
inline Timeline timeline() {
  Timeline chart;
  chart.title = "Pick and place beside a person";
  chart.curves = {{"to the cell", {}}, {"to the person", {}}, {"to itself", {}}};
  unsigned noise = 1;
  for (int i = 0; i < 24000; ++i) {
    const double t = i / 1000.0;
    noise = noise * 1664525u + 1013904223u;
    const double jitter = (noise >> 16) / 65536.0 * 0.004;
    const double swing = wave(t / 6.0);
    const double approach = t > 8.0 && t < 17.0 ? (12.5 - t) * (12.5 - t) / 20.25 : 1.0;
    const double person = 0.09 + 0.7 * (approach < 1.0 ? approach : 1.0) + 0.05 * swing + jitter;
    chart.times.push_back(t);
    chart.curves[0].clearances.push_back(0.16 + 0.10 * swing * swing - 0.04 * wave(t / 1.7) + jitter);
    chart.curves[1].clearances.push_back(person);
    chart.curves[2].clearances.push_back(0.22 + 0.06 * wave(t / 3.0 + 0.2));
    const double share = (person - 0.12) / 0.28;
    chart.zones.push_back(person < 0.12 ? Zone::stop : (person < 0.4 ? Zone::slow : Zone::free));
    chart.speed_override.push_back(share < 0.0 ? 0.0 : (share > 1.0 ? 1.0 : share));
  }
  chart.thresholds = {{"slow", 0.4}, {"stop", 0.12}};
  chart.markers = {{2.0, "A"}, {9.6, "B"}, {12.34, "C"}, {12.6, "D"}, {20.0, "E"}};
  return chart;
}

}  // namespace nearfield::host::draw::sample
