// Solids that are made of others.
#pragma once

#include <nearfield/field/compose.hpp>

namespace nearfield {

// A distance less `radius` metres: see Offset.
template <class A> constexpr auto offset(const A& a, detail::NotDeduced<typename A::Scalar> radius) {
  return combine(Offset<typename A::Scalar>{radius}, a);
}

// A box of these half edges, metres, whose edges and corners are rounded. 0 <= radius < the least half edge:
// the field is not valid otherwise. Exact signed distance.
template <class S> constexpr auto rounded_box(const Vector3<S>& center, const Vector3<S>& half_edges,
                                              detail::NotDeduced<S> radius) {
  const Vector3<S> core = {half_edges.x - radius, half_edges.y - radius, half_edges.z - radius};
  return offset(radius >= S{} ? Box<S>{center, core} : Box<S>{}, radius);
}

}  // namespace nearfield
