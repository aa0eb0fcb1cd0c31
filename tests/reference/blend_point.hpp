#pragma once
/// What a blend gives: its value and its partial derivatives by the operands.

#include "vector.hpp"

#include <cstddef>
#include <functional>
#include <vector>

namespace nearfield::reference {

/// Value of a blend of two operands, with its partial derivatives.
struct BlendPoint {
  Real value{};
  Real by_x{};
  Real by_y{};
};

/// Value of a blend of any number of operands; partials[i] belongs to operand i.
struct ManyBlendPoint {
  Real value{};
  std::vector<Real> partials{};
};

using BinaryBlend = std::function<BlendPoint(Real, Real)>;

/// blend(…blend(blend(x₀, x₁), x₂)…, xₙ₋₁), with the chain rule; at least one operand.
inline ManyBlendPoint folded(const BinaryBlend& blend, const std::vector<Real>& operands) {
  ManyBlendPoint result{operands.at(0), {1}};
  for (std::size_t i = 1; i < operands.size(); ++i) {
    const BlendPoint step = blend(result.value, operands[i]);
    for (Real& partial : result.partials) partial *= step.by_x;
    result.partials.push_back(step.by_y);
    result.value = step.value;
  }
  return result;
}

}  // namespace nearfield::reference
