// The default work cell's fields as static compositions in any scalar, for an ArmMonitor. The same solids and soft objects as in
// host_sim/scenes/work_cell.json; robots are those of the baked cell.
#pragma once

#include <nearfield/curve/kernel.hpp>
#include <nearfield/curve/potential.hpp>
#include <nearfield/nearfield.hpp>

namespace nearfield::composed {

template <class S> inline constexpr auto kRounding = bake<S, 64>(exterior(step::polynomial<3>, 0.25));
template <class S> inline constexpr auto kPotential = bake<S, 2>(over_square(potential::wyvill));

template <class S> constexpr Vector3<S> point(double x, double y, double z) { return {S(x), S(y), S(z)}; }
template <class S> constexpr Box<S> box(const Vector3<S>& center, const Vector3<S>& half) { return {center, half}; }
template <class S> constexpr Cylinder<S> post(const Vector3<S>& center, double radius, double half_height) {
  return {center, S(radius), S(half_height)};
}
template <class S> constexpr auto spreading(const Vector3<S>& at, double radius, double weight) {
  return with_potential(SoftPoint<S>{at, Influence<S>(S(radius), S(weight))}, kPotential<S>);
}
template <class S> constexpr auto spreading(const Vector3<S>& from, const Vector3<S>& to, double radius, double weight) {
  return with_potential(SoftSegment<S>{Capsule<S>(from, to, S{}), Influence<S>(S(radius), S(weight))}, kPotential<S>);
}

template <class S>
inline constexpr auto kCell = field(unite(
    kRounding<S>, S(0.05), box(point<S>(0.1, 0.0, -0.025), point<S>(0.6, 0.8, 0.025)),
    box(point<S>(0.5, -0.36, 0.025), point<S>(0.12, 0.15, 0.025)), box(point<S>(0.5, 0.36, 0.05), point<S>(0.12, 0.1, 0.05)),
    post(point<S>(0.57, 0.38, 0.15), 0.02, 0.05), post(point<S>(0.8, -0.1, 0.0), 0.06, 0.75)));

// Slots are the person's links.
template <class S>
inline constexpr auto kPresence = field(soft_sum(
    spreading(point<S>(0.65, -0.7, 0.0), point<S>(0.65, 0.7, 0.0), 0.4, 0.4), spreading(point<S>(0.5, -0.36, 0.025), 0.4, 0.6),
    spreading(point<S>(0.5, 0.36, 0.05), point<S>(0.57, 0.38, 0.2), 0.5, 0.8),
    spreading(point<S>(0.8, -0.1, -0.75), point<S>(0.8, -0.1, 0.75), 0.5, 1.0),
    in_slot(4, spreading(point<S>(0.0, 0.0, 0.1), point<S>(0.0, 0.0, 0.42), 0.9, 1.0)),
    in_slot(5, spreading(point<S>(0.0, 0.0, 0.0), 0.7, 1.0)),
    in_slot(7, spreading(point<S>(0.0, 0.0, 0.0), point<S>(0.0, 0.0, -0.3), 0.6, 1.0)),
    in_slot(8, spreading(point<S>(0.0, 0.0, 0.0), point<S>(0.0, 0.0, -0.4), 0.6, 1.0))));

}  // namespace nearfield::composed
