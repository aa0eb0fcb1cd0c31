// Robots as straightforward C++ in float, what a user would write: poses of links, bodies as segments with a radius, and how
// far two of these are apart.
#pragma once

#include <stdint.h>

#include <float_shapes.hpp>

namespace nearfield::straightforward {

inline Point sum(const Point& a, const Point& b) { return {a.x + b.x, a.y + b.y, a.z + b.z}; }
inline Point difference(const Point& a, const Point& b) { return {a.x - b.x, a.y - b.y, a.z - b.z}; }
inline Point times(float k, const Point& a) { return {k * a.x, k * a.y, k * a.z}; }
inline float dot(const Point& a, const Point& b) { return a.x * b.x + a.y * b.y + a.z * b.z; }
inline float least(float a, float b) { return a < b ? a : b; }
inline float clamped(float x, float low, float high) { return x < low ? low : x > high ? high : x; }
inline Point direction(const Point& a) {
  const float length = root(squared(a));
  return length > 0.0f ? times(1.0f / length, a) : Point{0.0f, 0.0f, 0.0f};
}

// Of a frame's rotation, three rows.
inline Point turned_out(const Frame& f, const Point& p) {
  return {f.m[0] * p.x + f.m[1] * p.y + f.m[2] * p.z, f.m[3] * p.x + f.m[4] * p.y + f.m[5] * p.z,
          f.m[6] * p.x + f.m[7] * p.y + f.m[8] * p.z};
}
inline Point turned_in(const Frame& f, const Point& p) {
  return {f.m[0] * p.x + f.m[3] * p.y + f.m[6] * p.z, f.m[1] * p.x + f.m[4] * p.y + f.m[7] * p.z,
          f.m[2] * p.x + f.m[5] * p.y + f.m[8] * p.z};
}
inline Point to_outer(const Frame& f, const Point& p) { return sum(turned_out(f, p), f.t); }
inline Point to_inner(const Frame& f, const Point& p) { return turned_in(f, difference(p, f.t)); }

inline void multiply(const float* a, const float* b, float* product) {
  for (int i = 0; i < 3; ++i) {
    for (int j = 0; j < 3; ++j) {
      product[3 * i + j] = a[3 * i] * b[j] + a[3 * i + 1] * b[3 + j] + a[3 * i + 2] * b[6 + j];
    }
  }
}

// Both to about 1e-6, of angles within 16 rad: a quarter turn's polynomials, shorter than a libm's.
struct SineAndCosine {
  float sine, cosine;
};
inline SineAndCosine sine_and_cosine(float angle) {
  const float quarters = angle * 0.636619772f;
  const int32_t whole = static_cast<int32_t>(quarters < 0.0f ? quarters - 0.5f : quarters + 0.5f);
  const float k = static_cast<float>(whole);
  const float x = angle - k * 1.5703125f - k * 4.83826794e-4f, z = x * x;
  const float s = x * (1.0f + z * (-1.0f / 6.0f + z * (1.0f / 120.0f - z * (1.0f / 5040.0f))));
  const float c = 1.0f + z * (-0.5f + z * (1.0f / 24.0f + z * (-1.0f / 720.0f + z * (1.0f / 40320.0f))));
  switch (whole & 3) {
    case 0: return {s, c};
    case 1: return {c, -s};
    case 2: return {-s, -c};
    default: return {-c, s};
  }
}

enum class Motion : uint8_t { none, turn, slide };
struct Hinge {
  Motion motion;
  uint16_t parent, variable;
  Frame origin;
  Point axis;
};

// Rodrigues' formula.
inline void rotation_about(const Point& n, float angle, float* m) {
  const SineAndCosine turn = sine_and_cosine(angle);
  const float s = turn.sine, c = turn.cosine, rest = 1.0f - c;
  m[0] = c + rest * n.x * n.x;
  m[1] = rest * n.x * n.y - s * n.z;
  m[2] = rest * n.z * n.x + s * n.y;
  m[3] = rest * n.x * n.y + s * n.z;
  m[4] = c + rest * n.y * n.y;
  m[5] = rest * n.y * n.z - s * n.x;
  m[6] = rest * n.z * n.x - s * n.y;
  m[7] = rest * n.y * n.z + s * n.x;
  m[8] = c + rest * n.z * n.z;
}

// Poses of all links; link 0 is the root, link i + 1 is moved by hinge i.
inline void link_poses(const Hinge* hinges, int count, const float* values, Frame* poses) {
  poses[0] = {{1.0f, 0.0f, 0.0f, 0.0f, 1.0f, 0.0f, 0.0f, 0.0f, 1.0f}, {0.0f, 0.0f, 0.0f}};
  for (int i = 0; i < count; ++i) {
    const Hinge& hinge = hinges[i];
    const Frame& parent = poses[hinge.parent];
    Frame moved = hinge.origin;
    if (hinge.motion == Motion::turn) {
      float turn[9];
      rotation_about(hinge.axis, values[hinge.variable], turn);
      multiply(hinge.origin.m, turn, moved.m);
    } else if (hinge.motion == Motion::slide) {
      moved.t = to_outer(hinge.origin, times(values[hinge.variable], hinge.axis));
    }
    multiply(parent.m, moved.m, poses[i + 1].m);
    poses[i + 1].t = to_outer(parent, moved.t);
  }
}

struct Limb {
  uint16_t link;
  Segment segment;
};
inline Segment placed(const Limb& limb, const Frame* poses) {
  const Frame& pose = poses[limb.link];
  return {to_outer(pose, limb.segment.from), turned_out(pose, limb.segment.axis), limb.segment.length, limb.segment.radius};
}

// From the nearest point of b to that of a, by the textbook's clamping of two places.
inline Point gap_between(const Segment& a, const Segment& b) {
  const Point between = difference(a.from, b.from);
  const float along_a = dot(between, a.axis), along_b = dot(between, b.axis), cosine = dot(a.axis, b.axis);
  const float denominator = 1.0f - cosine * cosine;
  float s = denominator > 1e-6f ? clamped((cosine * along_b - along_a) / denominator, 0.0f, a.length) : 0.0f;
  const float t = clamped(along_b + cosine * s, 0.0f, b.length);
  s = clamped(cosine * t - along_a, 0.0f, a.length);
  return difference(sum(between, times(s, a.axis)), times(t, b.axis));
}

// The nearest pair so far; its direction is made of the gap only at the end.
struct Pair {
  float distance = 1e30f;
  Point gap = {0.0f, 0.0f, 0.0f};
  uint16_t first = 0, second = 0;

  void consider(const Segment& a, const Segment& b, uint16_t i, uint16_t j) {
    const Point apart = gap_between(a, b);
    const float found = root(squared(apart)) - a.radius - b.radius;
    if (found >= distance) return;
    distance = found;
    gap = apart;
    first = i;
    second = j;
  }
};

}  // namespace nearfield::straightforward
