#pragma once
/// Ray functions by their formulas (Hsu, equations 1 to 5), sweeps of a superellipse, and the torus as a
/// quartic. Values are not cut off.

#include "vector.hpp"

#include <algorithm>
#include <cmath>
#include <vector>

namespace nearfield::reference {

/// xⁿ for x ≥ 0, by products where n is a whole number: that takes most of the tests' time otherwise.
inline Real power_of(Real x, Real n) {
  if (n != std::floor(n) || n > 64) return std::pow(x, n);
  Real power = 1;
  for (int bit = 64, exponent = static_cast<int>(n); bit > 0; bit /= 2)
    power *= (exponent & bit) != 0 ? power * x : power;
  return power;
}

/// (Σ |xᵢ|ⁿ)^{1/n}, n > 0; infinite n: the greatest.
inline Real norm_of(Real n, const std::vector<Real>& x) {
  Real greatest = 0;
  for (const Real value : x) greatest = std::max(greatest, std::fabs(value));
  if (greatest == 0 || std::isinf(n)) return greatest;
  Real sum = 0;
  for (const Real value : x) {
    const Real part = std::fabs(value) / greatest;
    sum += part == 0 || part == 1 ? part : power_of(part, n);
  }
  if (sum == 1) return greatest;
  return greatest * (n == 2 ? std::sqrt(sum) : n == 1 ? sum : std::pow(sum, 1 / n));
}

/// A superellipse of exponent `section` carried along a path from `from` along z, turned by `twist` rad and
/// enlarged to `end_scale` at its end; beyond its ends the excess counts by the exponent `ends`.
struct Sweep {
  Vec3 from, radii;
  Real section = 2, ends = 2;
  Real length = 0, twist = 0, end_scale = 1;
};
inline Real ray_of(const Sweep& sweep, const Vec3& p) {
  const Vec3 q = p - sweep.from;
  const Real along = std::clamp(q.z, Real{0}, sweep.length),
             part = sweep.length > 0 ? along / sweep.length : 0;
  const Real angle = sweep.twist * part;
  const Real x = q.x * std::cos(angle) + q.y * std::sin(angle),
             y = q.y * std::cos(angle) - q.x * std::sin(angle);
  const Real scale = 1 + (sweep.end_scale - 1) * part;
  return norm_of(sweep.ends, {norm_of(sweep.section, {x / sweep.radii.x, y / sweep.radii.y}) / scale,
                              (q.z - along) / sweep.radii.z});
}

struct QuarticTorus {
  Vec3 center;
  Real ring = 0, tube = 0, size = 1;
};
inline Real quartic_of(const QuarticTorus& torus, const Vec3& p) {
  const Vec3 q = p - torus.center;
  const Real ring = torus.ring * torus.ring, a = squared_norm(q) + ring - torus.tube * torus.tube;
  return (a * a - 4 * ring * (q.x * q.x + q.y * q.y)) / (4 * ring * torus.size);
}

}  // namespace nearfield::reference
