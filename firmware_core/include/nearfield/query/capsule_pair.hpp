// Distance between two capsules, certified by a separating direction.
#pragma once

#include <nearfield/query/clearance.hpp>

namespace nearfield {

namespace detail {

// numerator / denominator for denominator in [2^-24, 1], saturating; relative error below 2^-25.
// By two products with a reciprocal square root, so that the cost is fixed and no division is needed.
template <int F, class R> constexpr Fixed<F, R> quotient(Fixed<F, R> numerator, Unit<Fixed<F, R>> denominator) {
  const ReciprocalRoot root = reciprocal_root(static_cast<uint64_t>(denominator.raw()) << 32);
  int64_t value = numerator.raw();
  for (int i = 0; i < 2; ++i) {
    // The root is that of the denominator with 62 fraction bits: 1 / sqrt(d) = reciprocal * 2^(shift - 31).
    value = (value * root.reciprocal) >> (31 - root.shift);
    if (value > greatest_of<int32_t>) value = greatest_of<int32_t>;
    if (value < -greatest_of<int32_t>) value = -greatest_of<int32_t>;
  }
  return Fixed<F, R>::from_raw(static_cast<R>(value));
}
constexpr float quotient(float numerator, float denominator) { return numerator / denominator; }

template <class S> constexpr bool nearly_parallel(Unit<S> denominator) {
  if constexpr (ScalarTraits<S>::is_fixed) return denominator.raw() < (1 << (Unit<S>::fraction_bits - 24));
  else return !(denominator > 1.0f / 1048576.0f);
}

}  // namespace detail

// Signed distance of two capsules (metres), a lower bound, and the direction from the second to the first.
// Their nearest points are found in one pass; whatever that misses cannot make the answer too large, for the bound is
// that of a separating direction n: least n . a over the first segment less greatest n . b over the second.
// At most 5 rounding units below the true distance where the segments are not nearly parallel (within 2^-12 rad).
// Cost on Cortex-M4: kCapsulePairCost instructions at the most, clearance_between() included.
inline constexpr uint32_t kCapsulePairCost = 420;

template <class S> struct SeparatedBy {
  S distance{};
  Vector3<S> direction{};
};

template <class S> constexpr SeparatedBy<S> separation(const Capsule<S>& a, const Capsule<S>& b) {
  using U = Unit<S>;
  using T = ScalarTraits<S>;
  const S zero{};
  const S radii = a.radius + b.radius;
  const Vector3<S> between = subtract_in_range(a.from, b.from);
  if (a.length == zero && b.length == zero) {
    const Polar<S, S> apart = polar<S>(between);
    return {apart.length - radii, apart.direction};
  }
  // Minimise |between + s u - t v| over s in [0, a.length], t in [0, b.length].
  const S along_a = narrow_in_range<S>(dot(between, a.axis)), along_b = narrow_in_range<S>(dot(between, b.axis));
  const U cosine = narrow_in_range<U>(dot(a.axis, b.axis));
  const U denominator = subtract_in_range(T::unit_one(), narrow_in_range<U>(product(cosine, cosine)));
  const auto scaled_by_cosine = [cosine](S length) { return narrow_in_range<S>(product(length, cosine)); };
  const S start = detail::nearly_parallel<S>(denominator)
                      ? zero
                      : detail::quotient(subtract_in_range(scaled_by_cosine(along_b), along_a), denominator);
  S s = clamp(start, zero, a.length);
  const S t = clamp(add_in_range(along_b, scaled_by_cosine(s)), zero, b.length);
  s = clamp(subtract_in_range(scaled_by_cosine(t), along_a), zero, a.length);
  const Vector3<S> gap = subtract_in_range(add_in_range(between, a.along(s)), b.along(t));

  const Vector3<U> apart = direction_of<U>(gap);
  const U rise_a = narrow_in_range<U>(dot(apart, a.axis)), rise_b = narrow_in_range<U>(dot(apart, b.axis));
  const S over_a = least_of_two(narrow_in_range<S>(product(a.length, rise_a)), zero);
  const S over_b = greatest_of_two(narrow_in_range<S>(product(b.length, rise_b)), zero);
  // Four roundings, and a direction that may be longer than 1 by 2^-28.
  const S slack = T::times(T::rounding_unit(T::domain()), 4);
  const S bound = narrow_in_range<S>(dot(between, apart)) + over_a - over_b - slack;
  return {greatest_of_two(bound, zero) - radii, {T::from_unit(apart.x), T::from_unit(apart.y), T::from_unit(apart.z)}};
}

// The same as a clearance, for capsules each known to within its share of `error` (metres, their sum).
template <class S> constexpr Clearance<S> clearance_between(const Capsule<S>& a, const Capsule<S>& b, S error) {
  const SeparatedBy<S> apart = separation(a, b);
  Clearance<S> c;
  c.distance = apart.distance - error;
  c.direction = apart.direction;
  c.status = c.distance > S{} ? ClearanceStatus::clear
             : apart.distance + error <= S{} ? ClearanceStatus::touching : ClearanceStatus::undecided;
  return c;
}

}  // namespace nearfield
