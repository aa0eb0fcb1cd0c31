// Cubic polynomials in space, the chords that stand for them in a search, and the steps that lead from a
// chord to the nearest point of the curve.
#pragma once

#include <nearfield/number/ratio.hpp>
#include <nearfield/number/vector.hpp>

namespace nearfield::detail {

// Of one polynomial piece, t from 0 to 1.
inline constexpr int kChordCount = 8;

// C(t) = start + t (first + t (second + t third)). In range when the coordinates of neighbouring control
// points differ by at most half the domain.
template <class S>
struct CubicPolynomial {
  Vector3<S> start, first, second, third;

  constexpr CubicPolynomial() = default;
  // From four Bezier control points.
  constexpr explicit CubicPolynomial(const Vector3<S>* control) : start(control[0]) {
    const Vector3<S> e0 = subtract_in_range(control[1], control[0]),
                     e1 = subtract_in_range(control[2], control[1]),
                     e2 = subtract_in_range(control[3], control[2]);
    const Vector3<S> turn = subtract_in_range(e1, e0);
    first = three_times(e0);
    second = three_times(turn);
    third = subtract_in_range(subtract_in_range(e2, e1), turn);
  }

 private:
  static constexpr Vector3<S> three_times(const Vector3<S>& v) { return add_in_range(add_in_range(v, v), v); }
};

// p less the ends of the chords, one after the other: V(i / 8) with V = C - C'' / 1024. Between them, at the
// same parameter, chords and curve are at most |C''| / 1024 apart, C'' being largest at an end: where C'' is
// constant the curve lies up to |C''| / 512 to one side of a chord between its own points, and these are
// moved half as far to that side.
template <class S>
class ChordWalk;

// Steps are in units of 2^-(4 + shift) units in the last place; `shift` as curve_shift() tells.
template <int F>
class ChordWalk<Fixed<F>> {
 public:
  using S = Fixed<F>;
  using Inverse = uint32_t;                 // what place() divides by: 2^81 / |step|^2, at most 2^32 - 1
  static constexpr int32_t kOne = 1 << 28;  // as a place: the end of a chord
  static constexpr uint64_t kGreatestSquare = ~uint64_t{0};

  constexpr ChordWalk(const CubicPolynomial<S>& c, const Vector3<S>& p, int shift) : shift_(shift) {
    const auto each = [this](S first, S second, S third, int32_t& step, int32_t& bend, int32_t& turn) {
      const int32_t c1 = shift_left(first.raw(), shift_), c2 = shift_left(second.raw(), shift_),
                    c3 = shift_left(third.raw(), shift_);
      turn = wrapping_add(c3 >> 4, c3 >> 3);
      bend = wrapping_add(c2 >> 1, turn);
      step = wrapping_add(wrapping_add(shift_left(c1, 1), c2 >> 2), wrapping_add(c3 >> 8, c3 >> 6));
    };
    each(c.first.x, c.second.x, c.third.x, step_.x, bend_.x, turn_.x);
    each(c.first.y, c.second.y, c.third.y, step_.y, bend_.y, turn_.y);
    each(c.first.z, c.second.z, c.third.z, step_.z, bend_.z, turn_.z);
    const auto ahead = [](S x, S start, S second) {
      return S::from_raw(wrapping_add(wrapping_subtract(x.raw(), start.raw()), second.raw() >> 9));
    };
    relative_ = {ahead(p.x, c.start.x, c.second.x), ahead(p.y, c.start.y, c.second.y),
                 ahead(p.z, c.start.z, c.second.z)};
  }

  // Of the chord at hand: where the point nearest to p is, from 0 to kOne, by less than 2^-14 too near to its
  // beginning unless the inverse is cut off at its greatest; and p less that point, each component within 1
  // unit in the last place of that.
  constexpr int32_t place(Inverse inverse) const {
    const auto part = [](S x, int32_t step) { return static_cast<int64_t>(x.raw()) * step; };
    const int64_t along =
        part(relative_.x, step_.x) + part(relative_.y, step_.y) + part(relative_.z, step_.z);
    const int32_t high = static_cast<int32_t>(along >> 32);
    if (high < 0) return 0;
    if (high >> (28 - shift_) != 0) return kOne;
    const uint32_t scaled =
        static_cast<uint32_t>(high) << (3 + shift_) | static_cast<uint32_t>(along) >> (29 - shift_);
    const uint32_t share = multiply_high(scaled, inverse);  // Q16
    return share < (1u << 16) ? static_cast<int32_t>(share << 12) : kOne;
  }
  constexpr Vector3<S> offset(int32_t place) const {
    const auto less = [&](S x, int32_t step) {
      return S::from_raw(wrapping_subtract(x.raw(), multiply_high(step, place) >> shift_));
    };
    return {less(relative_.x, step_.x), less(relative_.y, step_.y), less(relative_.z, step_.z)};
  }
  constexpr void advance() {
    const auto less = [this](S x, int32_t step) {
      return S::from_raw(wrapping_subtract(x.raw(), step >> (4 + shift_)));
    };
    relative_ = {less(relative_.x, step_.x), less(relative_.y, step_.y), less(relative_.z, step_.z)};
    step_ = sum(step_, bend_);
    bend_ = sum(bend_, turn_);
  }

  // For payloads: it divides.
  constexpr Inverse inverse() const {
    const uint64_t scaled = squared_step() >> 33;
    return scaled < (1u << 16) ? 0xffffffffu : static_cast<uint32_t>((uint64_t{1} << 48) / scaled);
  }
  // How far place() may be off along the chord, m.
  constexpr S place_error() const {
    const uint32_t length = integer_sqrt(squared_step());
    const uint32_t error = squared_step() >> 33 < (1u << 16) ? length : length >> 14;
    return S::from_raw(static_cast<int32_t>(error >> (4 + shift_)) + 1);
  }
  // Units in the last place by which chords may be off their places: per component less than 14 (in a 16th of
  // it, if nothing is shifted: steps 3, bends 3, turns 2, adding up), 8 from steps and 2 from starts and
  // places.
  static constexpr int rounding_units(int shift) { return 2 * (10 + (220 >> (4 + shift)) + 1); }

 private:
  static constexpr Vector3<int32_t> sum(const Vector3<int32_t>& a, const Vector3<int32_t>& b) {
    return {wrapping_add(a.x, b.x), wrapping_add(a.y, b.y), wrapping_add(a.z, b.z)};
  }
  constexpr uint64_t squared_step() const {
    return sum_of_squares(S::from_raw(step_.x), S::from_raw(step_.y), S::from_raw(step_.z));
  }

  Vector3<S> relative_{};
  Vector3<int32_t> step_{}, bend_{}, turn_{};
  int shift_;
};

template <>
class ChordWalk<float> {
 public:
  using Inverse = float;
  static constexpr float kOne = 1.0f;
  static constexpr float kGreatestSquare = 3.0e38f;

  constexpr ChordWalk(const CubicPolynomial<float>& c, const Vector3<float>& p, int) {
    const auto each = [](float first, float second, float third, float& step, float& bend, float& turn) {
      turn = third * (3.0f / 256.0f);
      bend = second * (1.0f / 32.0f) + turn;
      step = (first * (1.0f / 8.0f) + second * (1.0f / 64.0f)) + third * (5.0f / 4096.0f);
    };
    each(c.first.x, c.second.x, c.third.x, step_.x, bend_.x, turn_.x);
    each(c.first.y, c.second.y, c.third.y, step_.y, bend_.y, turn_.y);
    each(c.first.z, c.second.z, c.third.z, step_.z, bend_.z, turn_.z);
    const auto ahead = [](float x, float start, float second) {
      return (x - start) + second * (1.0f / 512.0f);
    };
    relative_ = {ahead(p.x, c.start.x, c.second.x), ahead(p.y, c.start.y, c.second.y),
                 ahead(p.z, c.start.z, c.second.z)};
  }

  constexpr float place(float inverse) const { return clamp(dot(relative_, step_) * inverse, 0.0f, 1.0f); }
  constexpr Vector3<float> offset(float place) const {
    return {relative_.x - step_.x * place, relative_.y - step_.y * place, relative_.z - step_.z * place};
  }
  constexpr void advance() {
    relative_ = subtract_in_range(relative_, step_);
    step_ = add_in_range(step_, bend_);
    bend_ = add_in_range(bend_, turn_);
  }

  // 0 for a chord without length.
  constexpr float inverse() const {
    const float squares = sum_of_squares(step_.x, step_.y, step_.z);
    return squares > 1e-20f ? 1.0f / squares : 0.0f;
  }
  constexpr float place_error() const {
    const float squares = sum_of_squares(step_.x, step_.y, step_.z);
    return squares > 1e-20f ? square_root(squares) * (1.0f / 65536.0f) : 1e-10f;
  }
  static constexpr int rounding_units(int) { return 6; }

 private:
  Vector3<float> relative_{}, step_{}, bend_{}, turn_{};
};

// By how many bits a ChordWalk may bring the coefficients of control points to the left whose neighbours'
// coordinates differ by at most this; 0 to 24.
template <int F>
constexpr int curve_shift(Fixed<F> greatest_edge) {
  int shift = 0;
  while (shift < 24 && greatest_edge.raw() <= (1 << 27) >> shift) ++shift;
  return shift;
}
constexpr int curve_shift(float) { return 0; }

// p less C(t) for t in [0, 1], and what a Newton step towards the nearest point needs. Rounding of the
// offset: 1.5 units in the last place a component.
template <class S>
struct CurvePlace {
  Vector3<S> offset;
  Vector3<S> velocity;  // C'
  Vector3<S> bend;      // C'' / 2

  constexpr CurvePlace(const CubicPolynomial<S>& c, const Vector3<S>& p, Unit<S> t) {
    each(c.start.x, c.first.x, c.second.x, c.third.x, p.x, t, offset.x, velocity.x, bend.x);
    each(c.start.y, c.first.y, c.second.y, c.third.y, p.y, t, offset.y, velocity.y, bend.y);
    each(c.start.z, c.first.z, c.second.z, c.third.z, p.z, t, offset.z, velocity.z, bend.z);
  }

 private:
  static constexpr void each(S start, S first, S second, S third, S x, Unit<S> t, S& away, S& speed,
                             S& half) {
    const S cubic = narrow_in_range<S>(product(third, t));
    const S from_second = add_in_range(second, cubic);
    const S from_first = add_in_range(first, narrow_in_range<S>(product(from_second, t)));
    away = subtract_in_range(subtract_in_range(x, start), narrow_in_range<S>(product(from_first, t)));
    const S twice = add_in_range(from_second, cubic);
    speed = add_in_range(from_first, narrow_in_range<S>(product(twice, t)));
    half = add_in_range(twice, cubic);
  }
};

// slope / (2 half_curvature), at most 1/8 either way; half_curvature >= 0.
template <int F>
constexpr Fixed<30> newton_step(WideProduct<F, int32_t> slope, WideProduct<F, int32_t> half_curvature) {
  const uint64_t magnitude =
      slope.raw < 0 ? uint64_t{0} - static_cast<uint64_t>(slope.raw) : static_cast<uint64_t>(slope.raw);
  const uint64_t divisor = static_cast<uint64_t>(half_curvature.raw);
  int32_t step = 1 << 27;
  if (magnitude < divisor >> 2) {
    const int shift = leading_zeros(divisor);
    const uint32_t share =
        ratio(static_cast<uint32_t>(magnitude << shift >> 32), static_cast<uint32_t>(divisor << shift >> 32));
    step = static_cast<int32_t>(share >> 2);
  }
  return Fixed<30>::from_raw(slope.raw < 0 ? -step : step);
}
constexpr float newton_step(float slope, float half_curvature) {
  const float magnitude = absolute(slope), divisor = half_curvature + half_curvature;
  const float step = magnitude < 0.125f * divisor ? ratio(magnitude, divisor) : 0.125f;
  return slope < 0.0f ? -step : step;
}

template <int F, class R>
constexpr WideProduct<F, R> halved(WideProduct<F, R> x) {
  return {x.raw >> 1};
}
constexpr float halved(float x) { return 0.5f * x; }
template <int F, class R>
constexpr bool is_less(WideProduct<F, R> a, WideProduct<F, R> b) {
  return a.raw < b.raw;
}
constexpr bool is_less(float a, float b) { return a < b; }

// Towards the place where the distance is least: by Newton where its square bends upwards by an eighth of
// |C'|^2 at least, less boldly elsewhere.
template <class S>
constexpr Unit<S> step_to_nearest(const CurvePlace<S>& at) {
  const auto half = halved(dot(at.velocity, at.velocity));
  const auto curvature = half - dot(at.offset, at.bend), least = halved(halved(halved(half)));
  return newton_step(dot(at.offset, at.velocity), is_less(curvature, least) ? least : curvature);
}

// (chord + place) / 8, place as ChordWalk has it.
constexpr Fixed<30> curve_parameter(int chord, int32_t place) {
  return Fixed<30>::from_raw((chord << 27) + (place >> 1));
}
constexpr float curve_parameter(int chord, float place) {
  return (static_cast<float>(chord) + place) * 0.125f;
}

// Whether a distance is greater than another by more than rounding explains, both as squares: by no less than
// 2 units in the last place, by 4 at most (float: of a coordinate of p).
template <int F>
constexpr bool is_farther(uint64_t squares, uint64_t others, const Vector3<Fixed<F>>&) {
  return squares > others && squares - others > uint64_t{4} << ((64 - leading_zeros(others)) >> 1);
}
constexpr bool is_farther(float squares, float others, const Vector3<float>& p) {
  const float unit = ((absolute(p.x) + absolute(p.y)) + absolute(p.z)) * (1.0f / 8388608.0f);
  return squares - others > 4.0f * (unit * square_root(others));
}

// Of places on a skeleton that are tried one after the other, p less the nearest: the last where several are
// equally near.
template <class S>
class NearestTried {
 public:
  constexpr explicit NearestTried(const Vector3<S>& p) : p_(p) {}
  constexpr void add(const Vector3<S>& offset) {
    const auto squares = sum_of_squares(offset.x, offset.y, offset.z);
    if (!is_farther(squares, least_, p_)) offset_ = offset;
    least_ = least_of_two(least_, squares);
  }
  constexpr const Vector3<S>& offset() const { return offset_; }

 private:
  const Vector3<S>& p_;
  Vector3<S> offset_{};
  decltype(sum_of_squares(S{}, S{})) least_ = ChordWalk<S>::kGreatestSquare;
};

}  // namespace nearfield::detail
