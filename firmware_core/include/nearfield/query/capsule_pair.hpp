// Distance between two capsules, certified by a separating direction.
#pragma once

#include <nearfield/query/clearance.hpp>

namespace nearfield {

namespace detail {

// numerator / denominator for denominator in [2^-24, 1], saturating; relative error below 2^-24.
// By a product with the square of a reciprocal root, so that the cost is fixed and no division is needed.
template <int F, class R> constexpr Fixed<F, R> quotient(Fixed<F, R> numerator, Unit<Fixed<F, R>> denominator) {
  const ReciprocalRoot root = reciprocal_root(static_cast<uint64_t>(denominator.raw()) << 32);
  // The root is that of the denominator with 62 fraction bits: 1 / d = reciprocal^2 * 2^(2 shift - 62).
  const int32_t reciprocal = multiply_high(root.reciprocal, root.reciprocal);
  const int64_t scaled = static_cast<int64_t>(numerator.raw()) * reciprocal;
  const int shift = 30 - 2 * root.shift;  // 6 ... 30
  const int32_t high = static_cast<int32_t>(scaled >> 32);
  const int32_t result =
      static_cast<int32_t>(static_cast<uint32_t>(scaled) >> shift | static_cast<uint32_t>(high) << (32 - shift));
  if (high >> shift == result >> 31) return Fixed<F, R>::from_raw(static_cast<R>(result));
  return high < 0 ? Fixed<F, R>::least() : Fixed<F, R>::greatest();
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
// Below the true distance by up to 15 rounding units where the segments are at least a quarter of their summed lengths
// apart, by up to 14 + 4 lengths / apart otherwise (measured, Fixed<27>, segments at more than 2^-12 rad to each other).
// Precondition: both lie within 1 1/2 times the domain, as a Chain's placed bodies do; clearance_between() checks it.
// Cost: cost(target, QueryPart::capsule_pair) at the most, clearance_between() included.

template <class S> struct SeparatedBy {
  S distance{};
  Vector3<Unit<S>> direction{};
};

template <class S> constexpr SeparatedBy<S> separation(const Capsule<S>& a, const Capsule<S>& b) {
  using U = Unit<S>;
  using T = ScalarTraits<S>;
  const S zero{};
  const S radii = add_in_range(a.radius, b.radius);
  const Vector3<S> between = subtract_in_range(a.from, b.from);
  if (a.length == zero && b.length == zero) {
    const Polar<S, U> apart = polar<U>(between);
    // Only a float's length may be rounded up.
    const S rounded_up = T::is_fixed ? zero : T::rounding_unit(T::domain());
    return {subtract_in_range(subtract_in_range(apart.length, radii), rounded_up), apart.direction};
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
  auto bound = dot(between, apart);
  if (rise_a < U{}) bound = bound + product(a.length, rise_a);
  if (rise_b > U{}) bound = bound - product(b.length, rise_b);
  // Three roundings, and a direction that may be longer than 1 by 2^-28.
  const S slack = T::times(T::rounding_unit(T::domain()), 3);
  const S apart_at_least = narrow<S>(bound - product(slack, T::unit_one()));
  return {subtract_in_range(greatest_of_two(apart_at_least, zero), radii), apart};
}

// The same as a clearance, for capsules known to within errors (metres) whose sum is `error`.
template <class S> constexpr Clearance<S> clearance_of(const SeparatedBy<S>& apart, S error) {
  Clearance<S> c;
  c.distance = apart.distance - error;
  using T = ScalarTraits<S>;
  c.direction = {T::from_unit(apart.direction.x), T::from_unit(apart.direction.y), T::from_unit(apart.direction.z)};
  c.status = c.distance > S{} ? ClearanceStatus::clear
             : apart.distance + error <= S{} ? ClearanceStatus::touching : ClearanceStatus::undecided;
  return c;
}
// `invalid` for capsules that are not valid or leave the domain.
template <class S> constexpr Clearance<S> clearance_between(const Capsule<S>& a, const Capsule<S>& b, S error) {
  if (!detail::in_domain(a) || !detail::in_domain(b)) return {};
  return clearance_of(separation(a, b), error);
}

}  // namespace nearfield
