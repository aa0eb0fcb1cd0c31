// Operands that bring shapes, conversions and frames to their worst paths.
#pragma once

#include <operation_costs/report.hpp>
#include <operation_costs/tables.hpp>

namespace nearfield::costs {

inline const Sphere<Q> kBall = {{0.1, 0.2, 0.0}, 0.3};
inline const Capsule<Q> kSegment(Vector3<Q>{-0.3, 0.1, 0.0}, Vector3<Q>{0.4, 0.2, 0.3}, Q{});
inline const Vector3<Q> kPlace = {0.1, 0.0, 0.2};

// Moderate, and so steep that values and gradients saturate.
inline const Q kSlopes[] = {Q(0.25), Q(1.0), Q(4.0)};
inline AlgebraicPlane<Q> plane(Q slope, int turn) {
  const Vector3<Q> normals[] = {{0.9, -0.3, 0.2}, {-0.4, 0.8, 0.3}, {0.1, 0.5, -0.9}, {0.7, 0.6, 0.4}};
  const Vector3<Q>& n = normals[turn & 3];
  return {{n.x * slope, n.y * slope, n.z * slope}, Q(0.03) * slope};
}

inline void measure_distances() {
  Trial().measure(kBall);
  Trial().measure(Capsule<Q>(Vector3<Q>{-0.3, 0.1, 0.0}, Vector3<Q>{0.4, 0.2, 0.3}, Q(0.1)));
  Trial().measure(Box<Q>{{0.1, 0.0, 0.0}, {0.3, 0.2, 0.4}});
  Trial().measure(Box<Q>{{}, {1.0, 1.0, 1.0}});
  Trial().measure(Cylinder<Q>{kPlace, 0.3, 0.4});
  Trial().measure(Cylinder<Q>{{}, 1.0, 1.0});
}

inline void measure_intensities() {
  const Influence<Q> influences[] = {{Q(1.5), Q(1.0)}, {Q(4.0), Q(-1.0)}, {Q(0.125), Q(4.0)}};
  for (const Influence<Q>& influence : influences) {
    Trial(kSquaredPotential).measure(SoftPoint<Q>{kPlace, influence});
    Trial(kSquaredPotential).measure(SoftSegment<Q>{kSegment, influence});
  }
}

inline void measure_rays() {
  const Q radii[] = {Q(0.015625), Q(0.7), Q(4.0)};
  for (const Q radius : radii) {
    const RayRadius<Q> influence(radius);
    Trial().measure(RayPoint<Q>{kPlace, influence});
    Trial().measure(RaySegment<Q>{kSegment, influence});
    Trial().measure(RayPlane<Q>{kPlace, {0.6, 0.0, 0.8}, influence});
  }
}

inline void measure_algebraic() {
  for (const Q slope : kSlopes) {
    Trial().measure(plane(slope, 0));
    const Vector3<Q> all = {slope, slope, slope};
    Trial().measure(Quadric<Q>{all, {}, {}, -slope});
    Trial().measure(Quadric<Q>{all, all, all, slope});
    Trial().measure(Quadric<Q>{{slope, -slope, slope}, {-slope, slope, slope}, all, slope});
  }
}

inline void measure_conversions() {
  const RayPoint<Q> ray = {kPlace, RayRadius<Q>(Q(0.7))};
  const Certificate<Q> of_ball = kBall.certificate(domain_reach<Q>()),
                       of_ray = ray.certificate(domain_reach<Q>());
  const Q limits[] = {Q(0.125), Q(1.0), Q(4.0)};
  for (const Q limit : limits) {
    const Q weights[] = {Q(1.0), Q(-4.0)};
    for (const Q weight : weights) {
      Trial(kPotential).operand(kBall).measure(PotentialOfDistance<Q>(limit, weight, of_ball));
      Trial(kPotential).operand(ray).measure(PotentialOfRay<Q>(limit, weight, of_ray));
    }
  }
  for (const Q slope : kSlopes) {
    Trial().operand(kBall).measure(AlgebraicOfDistance<Q>{slope});
    Trial().operand(ray).measure(AlgebraicOfRay<Q>{Q(0.5), slope});
  }
}

// The influence ends well outside the object, inside it, and just where its remapping has a pole.
inline void measure_variable_influence() {
  const RayPoint<Q> object = {kPlace, RayRadius<Q>(Q(1.0))};
  const Q inner_ranges[] = {Q(0.125), Q(0.6), Q(1.0)};
  for (const Q inner_range : inner_ranges) {
    const VariableInfluence<Q> influence(inner_range);
    const Q radii[] = {Q(0.4), Q(0.5), Q(0.500001), Q(0.51), Q(0.75), Q(1.0), Q(1.5), Q(4.0)};
    for (const Q radius : radii) {
      Trial().operand(object).operand(RayPoint<Q>{kPlace, RayRadius<Q>(radius)}).measure(influence);
      Trial().operand(object).operand(RaySegment<Q>{kSegment, RayRadius<Q>(radius)}).measure(influence);
    }
  }
}

inline Budget box_cost(const AlgebraicPlane<Q>& field, const Vector3<Q>& half) {
  // The constant of the field over the box, from a first look at it.
  DeclaredBox<Q> box(half, kUnitRate);
  Builder draft;
  draft.enter_box(half).operation(field).leave_box(box);
  box = DeclaredBox<Q>(half, draft.finish().boxed.lipschitz);
  Trial trial;
  trial.operand(field);
  Builder& whole = trial.whole() = Builder();
  whole.enter_box(half).operation(field).leave_box(box);
  return trial.worst("enter_box and leave_box");
}

inline void report_frames() {
  const auto report_frame = [](const char* name, Operation enter, const Budget& measured) {
    report(Row::operation, name, measured, kTarget.cost(enter));
  };
  Budget of_pose, of_slot;
  for (uint32_t slot = 0; slot < 2; ++slot) {
    const auto inside = [slot](const Vector3<Q>& p) { return to_inner(kPoses[slot], p); };
    Trial trial;
    trial.operand(kBall);
    trial.whole() = Builder();
    trial.whole().enter(kPoses[slot]).operation(kBall).leave();
    of_pose = greatest_of_both(of_pose, trial.worst("enter_pose", inside));
    trial.whole() = Builder();
    trial.whole().enter_slot(slot).operation(kBall).leave();
    of_slot = greatest_of_both(of_slot, trial.worst("enter_slot", inside));
  }
  report_frame("enter_pose", Operation::enter_pose, of_pose);
  report_frame("enter_slot", Operation::enter_slot, of_slot);
  // Of distances, and of others, whose gradients may saturate.
  Budget scale;
  const auto measure_scale = [&](Q factor, const auto& field, Kind kind) {
    const UniformScale<Q> sized(factor);
    Trial trial;
    trial.operand(field);
    trial.whole() = Builder();
    trial.whole().enter_scale(sized, kind).operation(field).leave_scale();
    const auto inside = [&sized](const Vector3<Q>& p) { return sized.to_inner(p); };
    scale = greatest_of_both(scale, trial.worst("enter_scale and leave_scale", inside));
  };
  const Q factors[] = {Q(0.7), Q(1.3)};
  for (const Q factor : factors) {
    measure_scale(factor, kBall, Kind::distance);
    measure_scale(factor, RayPoint<Q>{kPlace, RayRadius<Q>(Q(0.7))}, Kind::ray);
    measure_scale(factor, plane(Q(1.0), 0), Kind::algebraic);
  }
  report_frame("enter_scale", Operation::enter_scale, scale);
  Budget box;
  const Vector3<Q> halves[] = {Vector3<Q>{4.0, 4.0, 4.0}, Vector3<Q>{0.5, 0.4, 0.3},
                               Vector3<Q>{0.1, 4.0, 1.0}};
  for (const Vector3<Q>& half : halves) {
    const AlgebraicPlane<Q> fields[] = {AlgebraicPlane<Q>{{0.3, 0.2, -0.4}, 0.1},
                                        AlgebraicPlane<Q>{{0.001, 0.0, 0.002}, 3.0},
                                        AlgebraicPlane<Q>{{0.01, 0.02, 0.0}, -3.0}};
    for (const AlgebraicPlane<Q>& field : fields) {
      box = greatest_of_both(box, box_cost(field, half));
    }
  }
  report_frame("enter_box", Operation::enter_box, box);
}

inline void measure_fields() {
  measure_distances();
  measure_intensities();
  measure_rays();
  measure_algebraic();
  measure_conversions();
  measure_variable_influence();
}

}  // namespace nearfield::costs
