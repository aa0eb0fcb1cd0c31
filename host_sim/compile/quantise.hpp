// From real numbers in files to the scalars of firmware_core, each rounded once.
#pragma once

#include <nearfield/modify/frame.hpp>
#include <nearfield/shape/capsule.hpp>

#include "model/placement.hpp"

namespace nearfield::host {

template <class S> S quantise(double value) { return static_cast<S>(value); }
template <class S> nearfield::Vector3<S> quantise(const Vector3d& v) {
  return {quantise<S>(v.x), quantise<S>(v.y), quantise<S>(v.z)};
}
template <class S> nearfield::Vector3<Unit<S>> quantise_unit(const Vector3d& v) { return quantise<Unit<S>>(v); }
template <class S> nearfield::Pose<S> quantise(const Placement& placement) {
  nearfield::Pose<S> pose;
  const Rotation& r = placement.rotation;
  pose.rotation.row[0] = quantise_unit<S>({r[0], r[1], r[2]});
  pose.rotation.row[1] = quantise_unit<S>({r[3], r[4], r[5]});
  pose.rotation.row[2] = quantise_unit<S>({r[6], r[7], r[8]});
  pose.translation = quantise<S>(placement.position);
  return pose;
}

// Capsule from both ends of its axis in real numbers: start, direction and length are each rounded once.
template <class S> nearfield::Capsule<S> quantise_capsule(const Vector3d& from, const Vector3d& to, double radius) {
  const Vector3d along = to - from;
  const double reach = length(along);
  const S rounded_length = quantise<S>(reach);
  if (!(rounded_length > S{})) return {quantise<S>(from), {}, S{}, quantise<S>(radius)};
  return {quantise<S>(from), quantise_unit<S>((1.0 / reach) * along), rounded_length, quantise<S>(radius)};
}

}  // namespace nearfield::host
