// Ray functions that are measures of their own, sweeps, and algebraic surfaces by name.
#pragma once

#include <nearfield/modify/ray_of_distance.hpp>
#include <nearfield/modify/sweep.hpp>
#include <nearfield/shape/algebraic_torus.hpp>
#include <nearfield/shape/quadrics.hpp>
#include <nearfield/shape/ray_slab.hpp>

#include <algorithm>
#include <cmath>

#include "operators/ray.hpp"

namespace nearfield::host::operators {

// `normal` of unit length.
inline void add_ray_slab(FieldEmitter& emitter, const Vector3d& at, const Vector3d& normal, double radius) {
  emitter.operation([&](auto zero) {
    using S = decltype(zero);
    return RaySlab<S>{quantise<S>(at), quantise_unit<S>(normal), RayRadius<S>(quantise<S>(radius))};
  });
}
inline ParameterDescription semi_axes() { return fitting(Fit::length, {"semi_axes", 3, ray_radius_range}); }

struct RaySlabOperator {
  static OperatorDescription description() {
    return shape("ray_slab", FieldKind::ray, {{"normal", 3, {-1e6, 1e6, {}}}, ray_radius()},
                 PlacementParts::position);
  }
  static void add(FieldEmitter& emitter, const FieldNode& node) {
    const Vector3d normal = node.vector("normal");
    const double size = length(normal);
    if (!(size > 0.0)) emitter.refuse(node, "normal", "a zero vector has no direction", "any other");
    add_ray_slab(emitter, node.placement.position, unit_of(normal), node.number("influence_radius"));
  }
};

struct RayOfDistanceOperator {
  static OperatorDescription description() {
    OperatorDescription description;
    description.name = "ray_of_distance";
    description.kind = FieldKind::ray;
    description.operand_kind = FieldKind::distance;
    description.fewest_operands = description.most_operands = 1;
    description.parameters = {ray_radius()};
    return description;
  }
  static void add(FieldEmitter& emitter, const FieldNode& node) {
    const double radius = node.number("influence_radius");
    emitter.operand(node.operands.front());
    emitter.operation([&](auto zero) {
      using S = decltype(zero);
      return RayOfDistance<S>{RayRadius<S>(quantise<S>(radius))};
    });
  }
};

// The Lp distance of infinite exponent.
struct BoxMetricOperator {
  static OperatorDescription description() {
    return shape("box_metric", FieldKind::ray, {semi_axes()}, PlacementParts::position_and_orientation);
  }
  static void add(FieldEmitter& emitter, const FieldNode& node) {
    const Vector3d axes[3] = {{1.0, 0.0, 0.0}, {0.0, 1.0, 0.0}, {0.0, 0.0, 1.0}};
    emitter.placed(node.placement, [&](const Vector3d& at) {
      for (std::size_t i = 0; i < 3; ++i) {
        add_ray_slab(emitter, at, axes[i], node.parameters.at("semi_axes")[i]);
        if (i != 0) emitter.operation([](auto zero) { return RayIntersection<decltype(zero)>{}; });
      }
    });
  }
};

// (sum of |p . n_i|^n)^(1/n) / R, the directions made unit vectors.
struct GeneralisedDistanceOperator {
  static constexpr std::size_t most_directions = 8;
  static OperatorDescription description() {
    ParameterDescription normals{"normals", 3, {-1e6, 1e6, {}}};
    normals.most_points = most_directions;
    return shape("generalised_distance", FieldKind::ray,
                 {std::move(normals), super_ellipsoidal_exponent(), ray_radius()}, PlacementParts::position);
  }
  static void add(FieldEmitter& emitter, const FieldNode& node) {
    const std::vector<Vector3d> normals = node.points("normals");
    if (normals.size() < 2) {
      emitter.refuse(node, "normals", std::to_string(normals.size()) + " of them",
                     "2 to " + std::to_string(most_directions));
    }
    const RayProfile profile = super_ellipsoidal_profile(emitter, node, false);
    const std::uint32_t table = emitter.table(node, "exponent", profile.function);
    for (std::size_t i = 0; i < normals.size(); ++i) {
      const double size = length(normals[i]);
      if (!(size > 0.0)) {
        emitter.refuse(node, "normals[" + std::to_string(i) + "]", "a zero vector has no direction",
                       "any other");
      }
      add_ray_slab(emitter, node.placement.position, unit_of(normals[i]),
                   node.number("influence_radius"));
      if (i != 0) add_ray_linear<SetOperation::intersect>(emitter, node, profile, table);
    }
  }
};

// What superquadrics and sweeps of their section have in common.
struct Sweep {
  Vector3d semi_axes;
  double section, ends;
  double length = 0.0, twist = 0.0, end_scale = 1.0;  // m, rad over the whole length

  explicit Sweep(const FieldNode& node)
      : semi_axes(node.vector("semi_axes")),
        section(node.parameters.at("exponents")[0]),
        ends(node.parameters.at("exponents")[1]) {}
  static ParameterDescription exponents() { return {"exponents", 2, {0.2, 64.0, {}}}; }

  void add(FieldEmitter& emitter, const Placement& placement) const {
    emitter.placed(placement, [&](const Vector3d& at) {
      emitter.operation([&](auto zero) {
        using S = decltype(zero);
        return RaySweep<S>(quantise<S>(at), quantise<S>(semi_axes), quantise<Rate>(section),
                           quantise<Rate>(ends), quantise<S>(length), quantise<S>(twist),
                           quantise<S>(end_scale));
      });
    });
  }
};

struct SuperquadricOperator {
  static OperatorDescription description() {
    return shape("superquadric", FieldKind::ray, {semi_axes(), Sweep::exponents()},
                 PlacementParts::position_and_orientation);
  }
  static void add(FieldEmitter& emitter, const FieldNode& node) { Sweep(node).add(emitter, node.placement); }
};

// The position is the start of the path, which runs along the local z axis.
struct RaySweepOperator {
  static OperatorDescription description() {
    return shape("ray_sweep", FieldKind::ray,
                 {semi_axes(),
                  Sweep::exponents(),
                  fitting(Fit::edge, {"length", 1, {0.0, 32.0, "m", true}}),
                  {"twist", 1, {-128.0, 128.0, "rad/m"}, {0.0}},
                  {"end_scale", 1, {0.125, 8.0, {}}, {1.0}}},
                 PlacementParts::position_and_orientation);
  }
  static void add(FieldEmitter& emitter, const FieldNode& node) {
    Sweep sweep(node);
    sweep.length = node.number("length");
    sweep.end_scale = node.number("end_scale");
    const double thinnest = std::min(sweep.semi_axes.x, sweep.semi_axes.y),
                 widest = std::max(sweep.semi_axes.x, sweep.semi_axes.y);
    emitter.require(node, "end_scale", sweep.end_scale,
                    {std::min(1.0, std::max(0.125, 1.01 * ray_radius_range.lowest / thinnest)),
                     std::max(1.0, std::min(8.0, 0.999 * emitter.limits().domain / widest))});
    // Beyond these the section turns as fast as it can be told apart, or the angle leaves its range.
    const double fastest =
        0.999 * std::min(2.0 / (widest * std::max(1.0, sweep.end_scale)), 15.0 / sweep.length);
    emitter.require(node, "twist", node.number("twist"), {-fastest, fastest, "rad/m"});
    sweep.twist = node.number("twist") * sweep.length;
    sweep.add(emitter, node.placement);
  }
};

// A named quadric with what stands for `size` where a node has none, metres.
inline void add_quadric(FieldEmitter& emitter, const FieldNode& node, const RealQuadric& quadric) {
  const double limit = emitter.limits().domain;
  if (!quadric.fits(limit)) {
    emitter.refuse(node, "size", emitter.misfit(node.number("size")) + " with the other parameters",
                   "a size of which neither the reciprocal nor the square of the radius over it exceeds " +
                       format_number(limit));
  }
  const Vector3d& at = node.placement.position;
  const RealQuadric placed = quadric.turned(node.placement.rotation.data()).moved(at.x, at.y, at.z);
  const auto add = [&](const RealQuadric& exact) {
    emitter.operation([&](auto zero) { return exact.template rounded<decltype(zero)>(); });
  };
  if (placed.fits(limit)) return add(placed);
  emitter.in_frame(node.placement, [&] { add(quadric); });
}
inline ParameterDescription polynomial_size() { return {"size", 1, {1.0 / 64.0, 32.0, "m"}, {1.0}}; }

struct AlgebraicSphereOperator {
  static OperatorDescription description() {
    return shape("algebraic_sphere", FieldKind::algebraic, {required_size("radius"), polynomial_size()},
                 PlacementParts::position);
  }
  static void add(FieldEmitter& emitter, const FieldNode& node) {
    add_quadric(emitter, node, algebraic_sphere(node.number("radius"), node.number("size")));
  }
};

struct AlgebraicCylinderOperator {
  static OperatorDescription description() {
    return shape("algebraic_cylinder", FieldKind::algebraic, {required_size("radius"), polynomial_size()},
                 PlacementParts::position_and_orientation);
  }
  static void add(FieldEmitter& emitter, const FieldNode& node) {
    add_quadric(emitter, node, algebraic_cylinder(node.number("radius"), node.number("size")));
  }
};

struct AlgebraicConeOperator {
  static OperatorDescription description() {
    return shape("algebraic_cone", FieldKind::algebraic,
                 {{"half_angle", 1, {0.001, 1.57, "rad"}}, polynomial_size()},
                 PlacementParts::position_and_orientation);
  }
  static void add(FieldEmitter& emitter, const FieldNode& node) {
    add_quadric(emitter, node, algebraic_cone(node.number("half_angle"), node.number("size")));
  }
};

struct AlgebraicTorusOperator {
  static OperatorDescription description() {
    ParameterDescription tube = fitting(Fit::length, {"tube_radius", 1, ray_radius_range});
    tube.ratio = RatioRule{"ring_radius", 0.0, 1.0};
    ParameterDescription size = fitting(Fit::edge, {"size", 1, {1.0 / 64.0, 32.0, "m"}, {1.0}});
    return shape(
        "algebraic_torus", FieldKind::algebraic,
        {fitting(Fit::length, {"ring_radius", 1, ray_radius_range}), std::move(tube), std::move(size)},
        PlacementParts::position_and_orientation);
  }
  static void add(FieldEmitter& emitter, const FieldNode& node) {
    const double ring = node.number("ring_radius"), tube = std::min(node.number("tube_radius"), ring),
                 size = node.number("size");
    emitter.placed(node.placement, [&](const Vector3d& at) {
      emitter.operation([&](auto zero) {
        using S = decltype(zero);
        return AlgebraicTorus<S>(quantise<S>(at), quantise<S>(ring), quantise<S>(tube), quantise<S>(size));
      });
    });
  }
};

}  // namespace nearfield::host::operators
