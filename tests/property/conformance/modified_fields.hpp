#pragma once
/// Fields of one shape, of each kind, to be modified.

#include <nearfield/curve/potential.hpp>
#include <nearfield/curve/tabulated_form.hpp>

#include "property/conformance/skeletons.hpp"

namespace nearfield::property {

struct Stick {
  static constexpr Operation operation = Operation::capsule;
  Skeleton skeleton;
  static Stick draw(Random& random, Real size) { return {draw_skeleton(random, size)}; }
  template <class S>
  auto node() const {
    return skeleton.template capsule<S>(skeleton.radius);
  }
  Real value(const Vec3& p) const {
    return reference::point_segment_distance(p, {skeleton.from, skeleton.from + skeleton.length * skeleton.axis}) -
           skeleton.radius;
  }
  Real outside(Real value, Real factor) const { return factor * value; }
};

struct Ray {
  static constexpr Operation operation = Operation::ray_segment;
  Skeleton skeleton;
  static Ray draw(Random& random, Real size) { return {draw_skeleton(random, size)}; }
  template <class S>
  auto node() const {
    return skeleton.template ray<S>();
  }
  Real value(const Vec3& p) const { return skeleton.cut_off(p, kGreatestRay); }
  Real outside(Real value, Real) const { return value; }
};

struct Plane {
  static constexpr Operation operation = Operation::algebraic_plane;
  Skeleton skeleton;
  static Plane draw(Random& random, Real size) { return {draw_skeleton(random, size)}; }
  template <class S>
  auto node() const {
    return AlgebraicPlane<S>{rounded<S>(0.5L * skeleton.axis), rounded<S>(skeleton.radius)};
  }
  Real value(const Vec3& p) const { return dot(0.5L * skeleton.axis, p) - skeleton.radius; }
  Real outside(Real value, Real) const { return value; }
};

template <class S>
inline const Table<S, 2> wyvill_table = bake<S, 2>(over_square(potential::wyvill));
inline Real wyvill(Real r) {
  const Real u = std::clamp<Real>(r, 0, 1) * std::clamp<Real>(r, 0, 1);
  return 1 - 22 * u / 9 + 17 * u * u / 9 - 4 * u * u * u / 9;
}

struct SoftRod {
  static constexpr Operation operation = Operation::soft_segment;
  Skeleton skeleton;
  static SoftRod draw(Random& random, Real size) { return {draw_skeleton(random, size)}; }
  template <class S>
  auto node() const {
    return with_potential(SoftSegment<S>{skeleton.template capsule<S>(0), Influence<S>(rounded<S>(skeleton.radius), rounded<S>(1))},
                          wyvill_table<S>);
  }
  Real value(const Vec3& p) const {
    return wyvill(skeleton.cut_off(p, 1));
  }
  Real outside(Real value, Real) const { return value; }
};

struct SoftBall {
  static constexpr Operation operation = Operation::soft_point;
  SoftRod rod;
  static SoftBall draw(Random& random, Real size) {
    SoftRod rod = SoftRod::draw(random, size);
    rod.skeleton.length = 0;
    return {rod};
  }
  template <class S>
  auto node() const {
    return with_potential(
        SoftPoint<S>{rounded<S>(rod.skeleton.from), Influence<S>(rounded<S>(rod.skeleton.radius), rounded<S>(1))},
        wyvill_table<S>);
  }
  Real value(const Vec3& p) const { return rod.value(p); }
  Real outside(Real value, Real) const { return value; }
};

inline Skeleton& skeleton_of(SoftBall& ball) { return ball.rod.skeleton; }
inline const Skeleton& skeleton_of(const SoftBall& ball) { return ball.rod.skeleton; }
template <class Field>
Skeleton& skeleton_of(Field& field) {
  return field.skeleton;
}
template <class Field>
const Skeleton& skeleton_of(const Field& field) {
  return field.skeleton;
}

template <class Field>
constexpr bool is_soft = Field::operation == Operation::soft_segment || Field::operation == Operation::soft_point;

}  // namespace nearfield::property
