#pragma once
/// Potentials P(r) of the relative distance r = distance / radius of influence: 1 for r ≤ 0, 0 for r ≥ 1.

#include "vector.hpp"

#include <stdexcept>

namespace nearfield::reference {

enum class Potential { cubic, wyvill };

/// The lowest-degree polynomial with P(0) = 1, P(1) = 0 and no slope at either end.
inline Real cubic_potential(Real r) {
  if (r <= 0) return 1;
  if (r >= 1) return 0;
  return 1 - 3 * r * r + 2 * r * r * r;
}

inline Real cubic_potential_slope(Real r) {
  return r <= 0 || r >= 1 ? Real{0} : -6 * r + 6 * r * r;
}

/// The cubic in r² with the same end conditions and P(½) = ½.
inline Real wyvill_potential(Real r) {
  if (r <= 0) return 1;
  if (r >= 1) return 0;
  const Real u = r * r;
  return 1 - Real{22} / 9 * u + Real{17} / 9 * u * u - Real{4} / 9 * u * u * u;
}

/// dP/dr, not dP/d(r²).
inline Real wyvill_potential_slope(Real r) {
  if (r <= 0 || r >= 1) return 0;
  const Real u = r * r;
  return r * (-Real{44} / 9 + Real{68} / 9 * u - Real{24} / 9 * u * u);
}

inline Real potential_value(Potential potential, Real r) {
  switch (potential) {
    case Potential::cubic:
      return cubic_potential(r);
    case Potential::wyvill:
      return wyvill_potential(r);
  }
  throw std::invalid_argument("unknown potential");
}

inline Real potential_slope(Potential potential, Real r) {
  switch (potential) {
    case Potential::cubic:
      return cubic_potential_slope(r);
    case Potential::wyvill:
      return wyvill_potential_slope(r);
  }
  throw std::invalid_argument("unknown potential");
}

}  // namespace nearfield::reference
