// Random numbers, places and shapes. Every run draws the same.
#pragma once

#include <nearfield/query/chain.hpp>

#include <operation_costs/skeletons.hpp>

namespace nearfield::costs {

class Draw {
 public:
  explicit Draw(uint64_t seed) { random_.state = (seed + 1) * 0x9e3779b97f4a7c15u; }

  uint32_t below(uint32_t count) { return random_.next() % count; }
  uint32_t within(uint32_t least, uint32_t greatest) { return least + below(greatest - least + 1); }
  bool one_in(uint32_t count) { return below(count) == 0; }
  // Evenly; bounds in thousandths of a metre.
  Q between(int32_t least, int32_t greatest) {
    const auto raw = [](int32_t thousandths) { return static_cast<int32_t>(int64_t{thousandths} * (1 << 27) / 1000); };
    const int64_t width = int64_t{raw(greatest)} - raw(least);
    return Q::from_raw(static_cast<int32_t>(raw(least) + ((width * random_.next()) >> 32)));
  }
  Vector3<Q> place() { return {between(-400, 400), between(-400, 400), between(-400, 400)}; }
  Vector3<Q> lengths(int32_t least, int32_t greatest) {
    return {between(least, greatest), between(least, greatest), between(least, greatest)};
  }
  Vector3<Unit<Q>> direction() {
    const Vector3<Unit<Q>> directions[] = {{0.6, 0.0, 0.8}, {0.36, 0.48, 0.8}, {0.0, 1.0, 0.0}, {-0.48, 0.6, -0.64},
                                           {0.8, -0.6, 0.0}, {0.0, -0.28, 0.96}};
    return directions[below(6)];
  }
  Pose<Q> pose() {
    Pose<Q> pose;
    pose.rotation = rotation_about<Q>(direction(), between(-3000, 3000));
    pose.translation = place();
    return pose;
  }
  // A point of the whole domain, or of its inner part, planes and axes included.
  Vector3<Q> point() { return random_.point(); }
  // Near another one, on any scale; some coordinates stay as they are.
  Vector3<Q> near(Vector3<Q> p) {
    const int scale = static_cast<int>(below(20));
    Q* const coordinates[] = {&p.x, &p.y, &p.z};
    for (Q* each : coordinates) {
      if (one_in(3)) continue;
      *each = clamp(add_in_range(*each, random_.coordinate(scale)), -ScalarTraits<Q>::domain(), ScalarTraits<Q>::domain());
    }
    return p;
  }

  Capsule<Q> segment() { return {place(), place(), Q{}}; }
  Polyline<Q> polyline() {
    Vector3<Q> points[8];
    for (Vector3<Q>& each : points) each = place();
    return {points, static_cast<int>(within(2, 8)), between(0, 200)};
  }
  Polygon<Q> polygon() {
    const bool crown = one_in(2);
    const Q size = between(300, 1000);
    Q x[8], y[8];
    for (int i = 0; i < 8; ++i) {
      x[i] = (crown ? kCrownX : kOutlineX)[i] * size;
      y[i] = (crown ? kCrownY : kOutlineY)[i] * size;
    }
    return {x, y, crown ? 8 : static_cast<int>(within(3, 8)), between(50, 500), between(0, 200)};
  }
  CubicCurve<Q> curve() {
    Vector3<Q> points[13];
    for (Vector3<Q>& each : points) each = place();
    if (one_in(2)) return CubicCurve<Q>(points, static_cast<int>(3 * within(1, 4) + 1), between(0, 200));
    return CubicCurve<Q>::b_spline(points, static_cast<int>(within(4, 7)), between(0, 200));
  }
  BicubicPatch<Q> patch() {
    Vector3<Q> points[16];
    for (int i = 0; i < 16; ++i) {
      const Vector3<Q> off = lengths(-80, 80);
      points[i] = {Q::from_raw((i / 4 - 2) << 25) + off.x, Q::from_raw((i % 4 - 2) << 25) + off.y, off.z};
    }
    return {points, between(0, 200)};
  }

 private:
  Random random_;
};

}  // namespace nearfield::costs
