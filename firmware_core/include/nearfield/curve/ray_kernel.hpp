// Profiles h of the ray-linear blends B(x, y) = m + m h, m the operand that decides (the lesser one in a
// union, the greater one in an intersection), as functions of u = (1 - lesser / greater) * factor in [0, 1],
// to be baked for blend/ray_linear.hpp. Exact forms in `double`: never linked into a target.
#pragma once

#include <nearfield/curve/kernel.hpp>

namespace nearfield {

// How u follows from the ratio t = 1 - lesser / greater of the operands: u = t * factor; from u = 1 on the
// blend is sharp. Factors are whole multiples of 2^-17 in [1, 64], which every scalar represents.
struct RayFactors {
  double first = 1.0;   // where the first operand decides
  double second = 1.0;  // where the second one does
  bool differ = false;  // the table's lower half is the first side, its upper half the second
};

namespace detail {

// Down to a multiple of 2^-17: what is left of the range beyond u = 1 is sharp already.
constexpr double representable_factor(double factor) {
  return static_cast<double>(static_cast<int64_t>(factor * 131072.0)) / 131072.0;
}

// q^n for n >= 1, q in [0, 1]. Below 2^-24, where derivatives may be infinite, a parabola that meets it
// there: off by less than 2^-28 of the ratio's own size.
constexpr Differentiable power_below_one(const Differentiable& q, double n) {
  constexpr double least = 1.0 / 16777216.0;
  const double x = q.value < least ? least : q.value;
  const double p = exact_exp(n * exact_log(x));
  if (q.value >= least) return chain(q, p, n * p / x, n * (n - 1.0) * p / (x * x));
  const double linear = (2.0 - n) * p / x, bent = (n - 1.0) * p / (x * x);
  return chain(q, (linear + bent * q.value) * q.value, linear + 2.0 * bent * q.value, 2.0 * bent);
}

}  // namespace detail

namespace profile {

// Ricci's super-ellipsoidal intersection (x^n + y^n)^(1/n) and union (x^-n + y^-n)^(-1/n), n in 1 ... 64.
// Where q^n / n is below 2^-31, q the ratio of the operands, they are cut off. Between n = 1 and 2 the
// derivative by the farther operand starts with infinite slope at ratio 0: a table rounds that off, and its
// facts say by how much.
struct SuperEllipsoid {
  double exponent = 2.0;
  double root = 0.5;  // 1 / n, of the union -1 / n
  double factor = 1.0;

  constexpr Differentiable operator()(const Differentiable& u) const {
    const Differentiable q = 1.0 - u * (1.0 / factor);
    const Differentiable safe = q.value < 0.0 ? Differentiable(0.0, q.first, q.second) : q;
    return exp(root * log(1.0 + detail::power_below_one(safe, exponent))) - 1.0;
  }
  constexpr RayFactors factors() const { return {factor, factor, false}; }
  // Towards ratio 0, ever closer: between them derivatives of q^n change by a factor.
  constexpr detail::Breaks breaks() const {
    detail::Breaks places;
    if (exponent == 1.0 || exponent >= 3.0) return places;
    places.count = 16;
    for (int i = 0; i < places.count; ++i) places.places[i] = 1.0 - detail::power_of_two(-7 - i);
    return places;
  }
  constexpr const char* problem() const {
    return exponent >= 1.0 && exponent <= 64.0 ? nullptr : "n is 1 to 64";
  }
};

constexpr SuperEllipsoid super_ellipsoid_with(double n, double root) {
  const double limit = n >= 1.0 ? exact_exp(exact_log(n / 2147483648.0) / n) : 0.0;
  return {n, root, limit > 0.125 && limit < 0.9 ? detail::representable_factor(1.0 / (1.0 - limit)) : 1.0};
}
constexpr SuperEllipsoid super_ellipsoidal_intersection(double n) { return super_ellipsoid_with(n, 1.0 / n); }
constexpr SuperEllipsoid super_ellipsoidal_union(double n) { return super_ellipsoid_with(n, -1.0 / n); }

// Hsu's scale union B_SA2 and scale intersection B_SS2: the root h of B_H(x1/h - 1, x2/h - 1) = 0 and of
// B_H(1 - x1/h, 1 - x2/h) = 0, B_H the conic of Hoffmann and Hopcroft.
//
// With Q = r1 r2 - p and L(u, v) = r1 r2 - r2 u - r1 v the conic is L^2 = 2 Q u v, and the blend its inner
// arc L = +sqrt(2 Q u v), between the points of tangency (r1, 0) and (0, r2). Where the first operand
// decides, set it to 1; then h = 1 / (1 + w) of the union, 1 / (1 - w) of the intersection, u = w, v = d + y
// w, where y is the other operand and d in [0, r2) its distance from the first, |y - 1|. With e = r2 - d and
// s = r2 + r1 y the arc is the lesser root of
//   (s^2 - 2 Q y) w^2 - 2 (r1 e s + Q d) w + (r1 e)^2 = 0,
//   w = (r1 e)^2 / (b + sqrt(Q (2 r1 e s d + Q d^2 + 2 y (r1 e)^2))),  b = r1 e s + Q d,
// in which nothing cancels: the root is real for Q >= 0, w falls to 0 as e^2 at the region's edge d = r2
// (C1), and it is at most the chord r1 e / s. Both partial derivatives are positive multiples of r2 sqrt(u v)
// + sqrt(Q / 2) v and r1 sqrt(u v) + sqrt(Q / 2) u: the blend is monotone. The chord is below 1, so that the
// intersection exists, when r1 r2 < r1 + r2; up to r = 1 its region ends at the axis, so that B(x, 0) = x.
struct ScaleBlend {
  double r1 = 0.5;
  double r2 = 0.5;
  double p = 0.0;
  bool intersects = false;

  constexpr Differentiable operator()(const Differentiable& u) const {
    if (!factors().differ) return side(u, true);
    return u.value < 0.5 ? side(2.0 * u, true) : side(2.0 * u - 1.0, false);
  }
  constexpr RayFactors factors() const {
    const double first = detail::representable_factor(reciprocal_range(r2));
    const double second = detail::representable_factor(reciprocal_range(r1));
    return {first, second, r1 != r2};
  }
  // The edges of the region, where the second derivative jumps.
  constexpr detail::Breaks breaks() const {
    const RayFactors scale = factors();
    const double first = scale.first / reciprocal_range(r2), second = scale.second / reciprocal_range(r1);
    detail::Breaks places;
    places.count = scale.differ ? 2 : 1;
    places.places[0] = scale.differ ? 0.5 * first : first;
    places.places[1] = 0.5 + 0.5 * second;
    return places;
  }
  // Flatter or sharper conics than these are a chord or a corner to any table.
  constexpr const char* problem() const {
    const double greatest = intersects ? 1.0 : 4.0, q = r1 * r2 - p;
    if (!(r1 >= 0.02 && r1 <= greatest && r2 >= 0.02 && r2 <= greatest)) {
      return intersects ? "r1 and r2 are 0.02 to 1" : "r1 and r2 are 0.02 to 4";
    }
    if (!(q >= least_roundness * r1 * r2)) return "p is at most 0.99 r1 r2";
    return q <= greatest_roundness * r1 * r2 ? nullptr : "p is at least -2000 r1 r2";
  }

 private:
  static constexpr double least_roundness = 0.00999999, greatest_roundness = 2001.00001;  // of Q / (r1 r2)

  // 1 / t at the edge where the other operand is r beyond or below the deciding one.
  constexpr double reciprocal_range(double r) const { return intersects ? 1.0 / r : (1.0 + r) / r; }

  constexpr Differentiable side(const Differentiable& u, bool first) const {
    const double own = first ? r1 : r2, across = first ? r2 : r1, q = r1 * r2 - p;
    const double factor = first ? factors().first : factors().second;
    const Differentiable t = u * (1.0 / factor);
    const Differentiable y = intersects ? 1.0 - t : 1.0 / (1.0 - t);
    const Differentiable d = intersects ? t : t / (1.0 - t);
    const Differentiable e = across - d;
    if (!(e.value > 0.0)) return 0.0;
    const Differentiable reach = own * e, s = across + own * y, along = reach * s;
    const Differentiable root = sqrt(q * (2.0 * along * d + q * square(d) + 2.0 * y * square(reach)));
    const Differentiable w = square(reach) / (along + q * d + root);
    return intersects ? w / (1.0 - w) : -w / (1.0 + w);
  }
};

constexpr ScaleBlend scale_union(double r1, double r2, double p) { return {r1, r2, p, false}; }
constexpr ScaleBlend scale_intersection(double r1, double r2, double p) { return {r1, r2, p, true}; }

}  // namespace profile
}  // namespace nearfield
