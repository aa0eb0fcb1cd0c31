// Places of a bicubic Bezier surface, and the Newton steps that lead from one to the nearest.
#pragma once

#include <nearfield/number/ratio.hpp>
#include <nearfield/number/vector.hpp>

namespace nearfield::detail {

// From a to b, t from 0 to 1, which give exactly these. Fixed: rounded down, by less than 1 unit in the last
// place; for |b - a| at most half the domain.
template <int F>
constexpr Fixed<F> between(Fixed<F> a, Fixed<F> b, Fixed<30> t) {
  const int32_t way = shift_left(wrapping_subtract(b.raw(), a.raw()), 2);
  return Fixed<F>::from_raw(wrapping_add(a.raw(), multiply_high(way, t.raw())));
}
constexpr float between(float a, float b, float t) { return a + (b - a) * t; }
// For any |b - a|; rounded down by less than 4 units.
template <int F>
constexpr Fixed<F> about_between(Fixed<F> a, Fixed<F> b, Fixed<30> t) {
  const int32_t way = multiply_high(wrapping_subtract(b.raw(), a.raw()), t.raw());
  return Fixed<F>::from_raw(wrapping_add(a.raw(), shift_left(way, 2)));
}
constexpr float about_between(float a, float b, float t) { return between(a, b, t); }

// 2/3 of a number and a third of a step.
template <int F>
constexpr Fixed<F> two_thirds(Fixed<F> x) {
  return Fixed<F>::from_raw(multiply_high(shift_left(x.raw(), 1), 0x55555556));
}
constexpr float two_thirds(float x) { return x * (2.0f / 3.0f); }
constexpr Fixed<30> third(Fixed<30> x) { return Fixed<30>::from_raw(multiply_high(x.raw(), 0x55555556)); }
constexpr float third(float x) { return x * (1.0f / 3.0f); }

// A cubic by its Bezier control points: value, a third of its derivative, a sixth of the second one (de
// Casteljau).
template <class S>
struct CubicAt {
  S value{}, slope{}, bend{};

  template <class T>
  [[gnu::always_inline]] constexpr CubicAt(S a, S b, S c, S d, T t) {
    const S ab = between(a, b, t), bc = between(b, c, t), cd = between(c, d, t);
    const S abc = between(ab, bc, t), bcd = between(bc, cd, t);
    value = between(abc, bcd, t);
    slope = subtract_in_range(bcd, abc);
    bend = subtract_in_range(subtract_in_range(cd, bc), subtract_in_range(bc, ab));
  }
};
// Of numbers of any size, less precisely: value, and a third of the derivative.
template <class S>
struct RoughCubicAt {
  S value{}, slope{};

  template <class T>
  [[gnu::always_inline]] constexpr RoughCubicAt(S a, S b, S c, S d, T t) {
    const S ab = about_between(a, b, t), bc = about_between(b, c, t), cd = about_between(c, d, t);
    const S abc = about_between(ab, bc, t), bcd = about_between(bc, cd, t);
    value = about_between(abc, bcd, t);
    slope = subtract_in_range(bcd, abc);
  }
};

template <class S>
struct BicubicParameters {
  Unit<S> u{}, v{};  // in [0, 1]
};

// p less the surface's point, and derivatives of that point by 3 u and 3 v, those of second order. Rounding
// of the offset: 6 units in the last place a component. Of control points that control(axis, 4 i + j) tells.
template <class S>
struct BicubicPlace {
  Vector3<S> offset, along_u, along_v, bend_u, twist, bend_v;

  template <class Control>
  constexpr BicubicPlace(const Control& control, const Vector3<S>& p, const BicubicParameters<S>& at) {
    const Coordinate x = coordinate(control, 0, at), y = coordinate(control, 1, at),
                     z = coordinate(control, 2, at);
    offset = {subtract_in_range(p.x, x.value), subtract_in_range(p.y, y.value),
              subtract_in_range(p.z, z.value)};
    along_u = {x.along_u, y.along_u, z.along_u};
    along_v = {x.along_v, y.along_v, z.along_v};
    bend_u = {x.bend_u, y.bend_u, z.bend_u};
    twist = {x.twist, y.twist, z.twist};
    bend_v = {x.bend_v, y.bend_v, z.bend_v};
  }

 private:
  struct Coordinate {
    S value, along_u, along_v, bend_u, twist, bend_v;
  };
  template <class Control>
  [[gnu::noinline]] static constexpr Coordinate coordinate(const Control& control, uint32_t axis,
                                                           const BicubicParameters<S>& at) {
    const auto row = [&](uint32_t i) __attribute__((always_inline)) {
      return CubicAt<S>(control(axis, i), control(axis, i + 1), control(axis, i + 2), control(axis, i + 3),
                        at.v);
    };
    const CubicAt<S> a = row(0), b = row(4), c = row(8), d = row(12);
    const CubicAt<S> place(a.value, b.value, c.value, d.value, at.u);
    const RoughCubicAt<S> slope(a.slope, b.slope, c.slope, d.slope, at.u),
        bend(a.bend, b.bend, c.bend, d.bend, at.u);
    return {place.value, place.slope,           slope.value, two_thirds(place.bend),
            slope.slope, two_thirds(bend.value)};
  }
};

// The offset alone: the same bits.
template <class S, class Control>
[[gnu::noinline]] constexpr S bicubic_coordinate(const Control& control, uint32_t axis,
                                                 const BicubicParameters<S>& at) {
  const auto row = [&](uint32_t i) {
    return CubicAt<S>(control(axis, i), control(axis, i + 1), control(axis, i + 2), control(axis, i + 3),
                      at.v)
        .value;
  };
  return CubicAt<S>(row(0), row(4), row(8), row(12), at.u).value;
}
template <class S, class Control>
constexpr Vector3<S> bicubic_offset(const Control& control, const Vector3<S>& p,
                                    const BicubicParameters<S>& at) {
  return {subtract_in_range(p.x, bicubic_coordinate<S>(control, 0, at)),
          subtract_in_range(p.y, bicubic_coordinate<S>(control, 1, at)),
          subtract_in_range(p.z, bicubic_coordinate<S>(control, 2, at))};
}

// Half the squared distance near a place, as a function of 3 u and 3 v: a paraboloid that opens upwards along
// both, scaled so that its curvatures are at most 1. Where it curves less than an eighth of the surface's
// speed says, that.
template <class U>
struct Paraboloid {
  U pull_u{}, pull_v{};  // minus its slopes, at most the greater curvature in magnitude
  U uu{}, uv{}, vv{};
};

template <int F>
constexpr Paraboloid<Fixed<30>> paraboloid_at(const BicubicPlace<Fixed<F>>& at) {
  const auto curvature = [&](const Vector3<Fixed<F>>& along, const Vector3<Fixed<F>>& bend) {
    const int64_t squared_speed = dot(along, along).raw;
    return greatest_of_two(wrapping_subtract(squared_speed, dot(at.offset, bend).raw), squared_speed >> 3);
  };
  const int64_t uu = curvature(at.along_u, at.bend_u), vv = curvature(at.along_v, at.bend_v);
  const int64_t most = greatest_of_two(uu, vv);
  const int shift = leading_zeros(static_cast<uint64_t>(most) | 1u) - 1;
  const auto scaled = [&](int64_t x) {
    const int64_t limited = clamp(x, -most, most);
    return Fixed<30>::from_raw(
        static_cast<int32_t>(static_cast<int64_t>(static_cast<uint64_t>(limited) << shift) >> 33));
  };
  return {scaled(dot(at.offset, at.along_u).raw), scaled(dot(at.offset, at.along_v).raw), scaled(uu),
          scaled(wrapping_subtract(dot(at.along_u, at.along_v).raw, dot(at.offset, at.twist).raw)),
          scaled(vv)};
}
constexpr Paraboloid<float> paraboloid_at(const BicubicPlace<float>& at) {
  const auto curvature = [&](const Vector3<float>& along, const Vector3<float>& bend) {
    const float squared_speed = dot(along, along);
    return greatest_of_two(squared_speed - dot(at.offset, bend), squared_speed * 0.125f);
  };
  return {dot(at.offset, at.along_u), dot(at.offset, at.along_v), curvature(at.along_u, at.bend_u),
          dot(at.along_u, at.along_v) - dot(at.offset, at.twist), curvature(at.along_v, at.bend_v)};
}

// part / whole, at most +-1; 0 for a part of 0. whole >= 0.
constexpr Fixed<30> limited_share(Fixed<30> part, Fixed<30> whole) {
  const Fixed<30> magnitude = absolute(part);
  int32_t share = part.raw() == 0 ? 0 : 1 << 30;
  if (magnitude < whole)
    share = static_cast<int32_t>(
        ratio(static_cast<uint32_t>(magnitude.raw()), static_cast<uint32_t>(whole.raw())) >> 1);
  return Fixed<30>::from_raw(part.raw() < 0 ? -share : share);
}
constexpr float limited_share(float part, float whole) {
  const float magnitude = absolute(part);
  const float share = magnitude < whole ? ratio(magnitude, whole) : magnitude > 0.0f ? 1.0f : 0.0f;
  return part < 0.0f ? -share : share;
}

// Newton's step from a place, within the surface: to the least of the paraboloid there, by at most 1/8 of u
// and v.
template <class U>
class BicubicStep {
 public:
  constexpr explicit BicubicStep(const Paraboloid<U>& near) : near_(near) {}

  template <class S>
  constexpr BicubicParameters<S> from(const BicubicParameters<S>& at) const {
    BicubicParameters<S> next;
    if (near_.uu < near_.vv)
      step(at.v, at.u, near_.pull_v, near_.pull_u, near_.vv, near_.uu, next.v, next.u);
    else
      step(at.u, at.v, near_.pull_u, near_.pull_v, near_.uu, near_.vv, next.u, next.v);
    return next;
  }

 private:
  using T = ScalarTraits<U>;

  // x curves more than y. First y, as if x followed freely; then x; where that ends at a side, y again.
  constexpr void step(U x, U y, U pull_x, U pull_y, U xx, U yy, U& next_x, U& next_y) const {
    const U lean = limited_share(near_.uv, xx);
    const U rest = subtract_in_range(yy, times(lean, near_.uv)), least = T::half(T::half(T::half(yy)));
    next_y = inside(moved(y, subtract_in_range(pull_y, times(lean, pull_x)), greatest_of_two(rest, least)));
    const U free_x = moved(x, subtract_in_range(pull_x, times(near_.uv, way(y, next_y))), xx);
    next_x = inside(free_x);
    if (next_x != free_x)
      next_y = inside(moved(y, subtract_in_range(pull_y, times(near_.uv, way(x, next_x))), yy));
  }
  static constexpr U times(U a, U b) { return narrow_in_range<U>(product(a, b)); }
  static constexpr U inside(U x) { return clamp(x, U{}, T::one()); }
  // Of 3 u.
  static constexpr U way(U from, U to) {
    const U step = subtract_in_range(to, from);
    return add_in_range(step, add_in_range(step, step));
  }
  static constexpr U moved(U from, U pull, U curvature) {
    constexpr U eighth = T::half(T::half(T::half(T::one())));
    return add_in_range(from, clamp(third(limited_share(pull, curvature)), -eighth, eighth));
  }

  Paraboloid<U> near_;
};

}  // namespace nearfield::detail
