// Shapes as straightforward C++ in float: what a user would write. Value and, where asked for, gradient.
#pragma once

namespace nearfield::straightforward {

struct Point {
  float x, y, z;
};
struct FieldValue {
  float value;
  Point gradient;
};

// As C libraries have it without an FPU, digit by digit; of normal numbers and 0. A call.
[[gnu::noinline]] inline float root_of_library(float x) {
  if (!(x > 0.0f)) return 0.0f;
  unsigned bits;
  __builtin_memcpy(&bits, &x, sizeof(bits));
  const int exponent = static_cast<int>(bits >> 23) - 127;
  unsigned rest = ((bits & 0x7fffffu) | 0x800000u) << ((exponent & 1) + 1), found = 0, twice = 0;
  for (unsigned digit = 1u << 24; digit != 0; digit >>= 1) {
    const unsigned tried = twice + digit;
    if (tried <= rest) {
      twice = tried + digit;
      rest -= tried;
      found += digit;
    }
    rest <<= 1;
  }
  if (rest != 0) found += found & 1;
  const unsigned result = (found >> 1) + 0x3f000000u + (static_cast<unsigned>(exponent >> 1) << 23);
  __builtin_memcpy(&x, &result, sizeof(x));
  return x;
}
// The FPU's instruction where there is one.
[[gnu::always_inline]] inline float root(float x) {
#if defined(__ARM_FP)
  float r;
  asm("vsqrt.f32 %0, %1" : "=t"(r) : "t"(x));
  return r;
#else
  return root_of_library(x);
#endif
}
[[gnu::always_inline]] inline float squared(const Point& p) { return p.x * p.x + p.y * p.y + p.z * p.z; }

// Wyvill's potential of r^2 / R^2 about the origin.
template <bool with_gradient> [[gnu::always_inline]] inline FieldValue ball_potential(const Point& p, float inverse_square) {
  const float t = squared(p) * inverse_square;
  if (t >= 1.0f) return {0.0f, {0.0f, 0.0f, 0.0f}};
  constexpr float a = -22.0f / 9.0f, b = 17.0f / 9.0f, c = -4.0f / 9.0f;
  const float g = with_gradient ? 2.0f * inverse_square * (a + t * (2.0f * b + t * (3.0f * c))) : 0.0f;
  return {1.0f + t * (a + t * (b + t * c)), {g * p.x, g * p.y, g * p.z}};
}

struct Segment {
  Point from, axis;
  float length, radius;
};
[[gnu::always_inline]] inline float squared_to_segment(const Segment& s, const Point& p) {
  const Point r = {p.x - s.from.x, p.y - s.from.y, p.z - s.from.z};
  float place = r.x * s.axis.x + r.y * s.axis.y + r.z * s.axis.z;
  place = place < 0.0f ? 0.0f : place > s.length ? s.length : place;
  return squared({r.x - place * s.axis.x, r.y - place * s.axis.y, r.z - place * s.axis.z});
}

struct Frame {
  float m[9];
  Point t;
};
[[gnu::always_inline]] inline float outside_box(const Frame& f, const Point& half, const Point& p) {
  const Point r = {p.x - f.t.x, p.y - f.t.y, p.z - f.t.z};
  const float x = f.m[0] * r.x + f.m[3] * r.y + f.m[6] * r.z, y = f.m[1] * r.x + f.m[4] * r.y + f.m[7] * r.z,
              z = f.m[2] * r.x + f.m[5] * r.y + f.m[8] * r.z;
  const auto beyond = [](float a, float limit) {
    const float d = (a < 0.0f ? -a : a) - limit;
    return d < 0.0f ? 0.0f : d;
  };
  return root(squared({beyond(x, half.x), beyond(y, half.y), beyond(z, half.z)}));
}

}  // namespace nearfield::straightforward
