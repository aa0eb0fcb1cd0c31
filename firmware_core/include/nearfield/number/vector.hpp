// Vectors of three scalars, right-handed coordinates.
#pragma once

#include <nearfield/number/sqrt.hpp>

namespace nearfield {

template <class T> struct Vector3 {
  T x{}, y{}, z{};
};

template <class T> constexpr bool operator==(const Vector3<T>& a, const Vector3<T>& b) {
  return a.x == b.x && a.y == b.y && a.z == b.z;
}

// Component-wise, exact for Fixed; the caller's contract keeps the results in range (they wrap otherwise).
template <class T> constexpr Vector3<T> add_in_range(const Vector3<T>& a, const Vector3<T>& b) {
  return {add_in_range(a.x, b.x), add_in_range(a.y, b.y), add_in_range(a.z, b.z)};
}
template <class T> constexpr Vector3<T> subtract_in_range(const Vector3<T>& a, const Vector3<T>& b) {
  return {subtract_in_range(a.x, b.x), subtract_in_range(a.y, b.y), subtract_in_range(a.z, b.z)};
}
// Component-wise, saturating.
template <class T> constexpr Vector3<T> operator+(const Vector3<T>& a, const Vector3<T>& b) {
  return {a.x + b.x, a.y + b.y, a.z + b.z};
}
template <class T> constexpr Vector3<T> operator-(const Vector3<T>& a) { return {-a.x, -a.y, -a.z}; }

// Exact sum of three products. In range when |a| |b| < 2^(width - 1) units of the product; unit vectors always are.
template <class A, class B> constexpr auto dot(const Vector3<A>& a, const Vector3<B>& b) {
  return product(a.x, b.x) + product(a.y, b.y) + product(a.z, b.z);
}

// a * factor, each component rounded once.
template <class S, class F> constexpr Vector3<S> scaled_in_range(const Vector3<S>& a, F factor) {
  return {narrow_in_range<S>(product(a.x, factor)), narrow_in_range<S>(product(a.y, factor)),
          narrow_in_range<S>(product(a.z, factor))};
}
template <class S, class F> constexpr Vector3<S> scaled(const Vector3<S>& a, F factor) {
  return {narrow<S>(product(a.x, factor)), narrow<S>(product(a.y, factor)), narrow<S>(product(a.z, factor))};
}

template <class T> constexpr bool is_zero(const Vector3<T>& a) { return a == Vector3<T>{}; }

// A vector's length (rounded down, see length_of) and its direction: each component within 6 units of 2^-30 and
// half a unit in the last place of To (float: 2^-23); the zero vector has direction zero.
template <class S, class To> struct Polar {
  S length{};
  Vector3<To> direction{};
};

namespace detail {

template <class To> constexpr To direction_component(int32_t v, int normalising_shift, int32_t reciprocal) {
  // |v| < 2^(32 - shift): brought to 31 bits, so that the shift that remains is a constant.
  const int32_t v31 = normalising_shift == 0 ? v >> 1 : shift_left(v, normalising_shift - 1);
  constexpr int shift = 61 - To::fraction_bits;
  const int64_t exact = static_cast<int64_t>(v31) * reciprocal;
  return To::from_raw(static_cast<typename To::Raw>(shift_right_to_32<shift>(exact + (int64_t{1} << (shift - 1)))));
}

}  // namespace detail

template <class To, int F, class R> constexpr Polar<Fixed<F, R>, To> polar(const Vector3<Fixed<F, R>>& v) {
  const RootParts root = root_parts(sum_of_squares(v.x, v.y, v.z));
  return {root_to_scalar<Fixed<F, R>>(root.root),
          {detail::direction_component<To>(v.x.raw(), root.shift, root.reciprocal),
           detail::direction_component<To>(v.y.raw(), root.shift, root.reciprocal),
           detail::direction_component<To>(v.z.raw(), root.shift, root.reciprocal)}};
}
template <class To> constexpr Polar<float, float> polar(const Vector3<float>& v) {
  const float length = square_root(sum_of_squares(v.x, v.y, v.z));
  if (!(length > 0.0f)) return {length, {}};
  if (length < 1e-15f) {
    // Its square has too few digits left.
    constexpr float scale = 1.8446744e19f;  // 2^64
    const Vector3<float> large = {v.x * scale, v.y * scale, v.z * scale};
    const float size = square_root(sum_of_squares(large.x, large.y, large.z));
    return {length, {large.x / size, large.y / size, large.z / size}};
  }
  return {length, {v.x / length, v.y / length, v.z / length}};
}

// The direction alone: the same bits, 25 instructions less.
template <class To, int F, class R> constexpr Vector3<To> direction_of(const Vector3<Fixed<F, R>>& v) {
  const ReciprocalRoot root = reciprocal_root(sum_of_squares(v.x, v.y, v.z));
  return {detail::direction_component<To>(v.x.raw(), root.shift, root.reciprocal),
          detail::direction_component<To>(v.y.raw(), root.shift, root.reciprocal),
          detail::direction_component<To>(v.z.raw(), root.shift, root.reciprocal)};
}
template <class To> constexpr Vector3<float> direction_of(const Vector3<float>& v) { return polar<To>(v).direction; }

}  // namespace nearfield
