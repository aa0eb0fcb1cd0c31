// Asks fields of every kind for a clearance. Freestanding.
#pragma once

#include <nearfield/query/clearance.hpp>

namespace nearfield::golden {

// Static fields of other kinds than distances cannot be asked: what a program of the same kind answers.
template <class AnyField, class S = typename AnyField::Scalar>
constexpr Clearance<S> clearance_of_any(const AnyField& field, const Vector3<S>& p, const Pose<S>* poses, uint32_t count) {
  if constexpr (detail::may_be_distance<AnyField>)
    return clearance(field, p, poses, count);
  else
    return {};
}

}  // namespace nearfield::golden
