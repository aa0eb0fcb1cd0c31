// Ray functions: 1 at the influence boundary, 0.5 on the soft surface.
#pragma once

#include <nearfield/blend/ray_linear.hpp>
#include <nearfield/curve/ray_kernel.hpp>
#include <nearfield/modify/influence.hpp>
#include <nearfield/shape/ray.hpp>

#include "operators/sharp.hpp"
#include "operators/solids.hpp"

namespace nearfield::host::operators {

inline constexpr NumberRange ray_radius_range{1.0 / 64.0, 16.0, "m"};
inline ParameterDescription ray_radius() {
  return fitting(Fit::length, {"influence_radius", 1, ray_radius_range});
}

struct RayPointOperator {
  static OperatorDescription description() {
    return shape("ray_point", FieldKind::ray, {ray_radius()}, PlacementParts::position);
  }
  static void add(FieldEmitter& emitter, const FieldNode& node) {
    const double radius = node.number("influence_radius");
    emitter.operation([&](auto zero) {
      using S = decltype(zero);
      return RayPoint<S>{quantise<S>(node.placement.position), RayRadius<S>(quantise<S>(radius))};
    });
  }
};

struct RaySegmentOperator {
  static OperatorDescription description() {
    return shape("ray_segment", FieldKind::ray, {required_point("from"), required_point("to"), ray_radius()},
                 PlacementParts::none);
  }
  static void add(FieldEmitter& emitter, const FieldNode& node) {
    const Ends ends = ends_of(emitter, node);
    const double radius = node.number("influence_radius");
    emitter.operation([&](auto zero) {
      using S = decltype(zero);
      return RaySegment<S>{quantise_capsule<S>(ends.from, ends.to, 0.0), RayRadius<S>(quantise<S>(radius))};
    });
  }
};

// `normal` of unit length.
inline void add_ray_plane(FieldEmitter& emitter, const Vector3d& at, const Vector3d& normal, double radius) {
  emitter.operation([&](auto zero) {
    using S = decltype(zero);
    return RayPlane<S>{quantise<S>(at), quantise_unit<S>(normal), RayRadius<S>(quantise<S>(radius))};
  });
}
struct RayPlaneOperator {
  static OperatorDescription description() {
    return shape("ray_plane", FieldKind::ray, {{"normal", 3, {-1e6, 1e6, {}}}, ray_radius()},
                 PlacementParts::position);
  }
  static void add(FieldEmitter& emitter, const FieldNode& node) {
    const Vector3d normal = node.vector("normal");
    const double size = length(normal);
    if (!(size > 0.0)) emitter.refuse(node, "normal", "a zero vector has no direction", "any other");
    add_ray_plane(emitter, node.placement.position, unit_of(normal), node.number("influence_radius"));
  }
};

// A blend's profile, and how its argument follows from the operands' ratio.
struct RayProfile {
  TableFunction function;
  RayFactors both;

  RayFactors factors() const { return both; }
};
template <class Profile>
RayProfile ray_profile(const FieldEmitter& emitter, const FieldNode& node, const char* key,
                       const std::string& identity, const Profile& profile) {
  if (const char* problem = profile.problem()) {
    emitter.refuse(node, key, "the parameters do not fit each other", problem);
  }
  return {profile_function(identity, profile), profile.factors()};
}

// Adds the operation of a profile whose table there is.
template <SetOperation set_operation>
void add_ray_linear(FieldEmitter& emitter, const FieldNode& node, const RayProfile& profile,
                    std::uint32_t table) {
  emitter.operation(
      [&](auto zero) {
        using S = decltype(zero);
        RayLinear<S, set_operation> blend;
        blend.sides = RaySides<S>::of(profile);
        if constexpr (set_operation == SetOperation::subtract) {
          const double surface = node.number("surface");
          blend.complement = {quantise<S>(surface * surface), quantise<S>(node.number("least"))};
        }
        return blend;
      },
      table);
}
template <SetOperation set_operation>
void fold_ray_linear(FieldEmitter& emitter, const FieldNode& node, const char* key,
                     const RayProfile& profile) {
  const std::uint32_t table = emitter.table(node, key, profile.function);
  emitter.fold(node, [&] { add_ray_linear<set_operation>(emitter, node, profile, table); });
}

// Of a node's exponent.
inline RayProfile super_ellipsoidal_profile(const FieldEmitter& emitter, const FieldNode& node,
                                            bool is_union) {
  const double exponent = node.number("exponent");
  const std::string identity =
      (is_union ? "super-ellipsoidal union " : "super-ellipsoidal intersection ") + format_number(exponent);
  return ray_profile(emitter, node, "exponent", identity,
                     is_union ? profile::super_ellipsoidal_union(exponent)
                              : profile::super_ellipsoidal_intersection(exponent));
}
inline ParameterDescription super_ellipsoidal_exponent() { return {"exponent", 1, {1.0, 64.0, {}}}; }

// Ricci's blends with exponent n; the difference is the intersection with the complement about `surface`.
template <SetOperation set_operation>
struct SuperEllipsoidalOperator {
  static OperatorDescription description() {
    OperatorDescription description =
        blend(pick<set_operation>("super_ellipsoidal_union", "super_ellipsoidal_intersection",
                                  "super_ellipsoidal_difference"),
              FieldKind::ray, {super_ellipsoidal_exponent()});
    if (set_operation == SetOperation::subtract) {
      description.parameters.push_back({"surface", 1, {0.25, 1.0, {}}, {1.0}});
      description.parameters.push_back(
          {"least", 1, {0.0, 1.0, {}, true}, {0.5}, RatioRule{"surface", 0.26, 4.0}});
    }
    return description;
  }
  static void add(FieldEmitter& emitter, const FieldNode& node) {
    fold_ray_linear<set_operation>(
        emitter, node, "exponent",
        super_ellipsoidal_profile(emitter, node, set_operation == SetOperation::unite));
  }
};

// Hsu's L_p distance (|x/a|^n + |y/b|^n + |z/c|^n)^(1/n): the super-ellipsoidal intersection of three pairs
// of planes back to back.
struct LpDistanceOperator {
  static OperatorDescription description() {
    return shape("lp_distance", FieldKind::ray,
                 {super_ellipsoidal_exponent(), fitting(Fit::length, {"semi_axes", 3, ray_radius_range})},
                 PlacementParts::position_and_orientation);
  }
  static void add(FieldEmitter& emitter, const FieldNode& node) {
    const RayProfile profile = super_ellipsoidal_profile(emitter, node, false);
    const std::uint32_t table = emitter.table(node, "exponent", profile.function);
    const Vector3d axes[3] = {{1.0, 0.0, 0.0}, {0.0, 1.0, 0.0}, {0.0, 0.0, 1.0}};
    emitter.placed(node.placement, [&](const Vector3d& at) {
      for (std::size_t i = 0; i < 3; ++i) {
        const double semi_axis = node.parameters.at("semi_axes")[i];
        add_ray_plane(emitter, at, axes[i], semi_axis);
        add_ray_plane(emitter, at, -1.0 * axes[i], semi_axis);
        emitter.operation([](auto zero) { return RayIntersection<decltype(zero)>{}; });
        if (i != 0) add_ray_linear<SetOperation::intersect>(emitter, node, profile, table);
      }
    });
  }
};

// Hsu's B_SA2 and B_SS2 with ranges r1, r2 and shape p.
template <SetOperation set_operation>
struct ScaleOperator {
  static OperatorDescription description() {
    const bool is_union = set_operation == SetOperation::unite;
    const NumberRange range{0.02, is_union ? 4.0 : 1.0, {}};
    return blend(is_union ? "scale_union" : "scale_intersection", FieldKind::ray,
                 {{"r1", 1, range}, {"r2", 1, range}, {"p", 1, {-1e5, 256.0, {}}, {0.0}}});
  }
  static void add(FieldEmitter& emitter, const FieldNode& node) {
    const double r1 = node.number("r1"), r2 = node.number("r2"), p = node.number("p");
    const bool is_union = set_operation == SetOperation::unite;
    const std::string identity = std::string(is_union ? "scale union " : "scale intersection ") +
                                 format_number(r1) + " " + format_number(r2) + " " + format_number(p);
    fold_ray_linear<set_operation>(
        emitter, node, "p",
        ray_profile(emitter, node, "p", identity,
                    is_union ? profile::scale_union(r1, r2, p) : profile::scale_intersection(r1, r2, p)));
  }
};

// Hsu's variable influential radius: the first operand, the object, with its influence up to the second one's
// contour.
struct VariableInfluenceOperator {
  static OperatorDescription description() {
    OperatorDescription description =
        blend("variable_influence", FieldKind::ray, {{"inner_range", 1, {0.125, 1.0, {}}, {1.0}}});
    description.most_operands = 2;
    return description;
  }
  static void add(FieldEmitter& emitter, const FieldNode& node) {
    const double inner_range = node.number("inner_range");
    emitter.fold(node, [&] {
      emitter.operation([&](auto zero) {
        using S = decltype(zero);
        return VariableInfluence<S>(quantise<S>(inner_range));
      });
    });
    // Last, so that operands are judged before what is made of them.
    require_contour_outside(emitter, node);
  }

 private:
  // Of operands that neither move nor change: of others it cannot be told.
  static void require_contour_outside(FieldEmitter& emitter, const FieldNode& node) {
    const std::optional<RayField> object = emitter.ray_field(node.operands[0]);
    const std::optional<RayField> contour = emitter.ray_field(node.operands[1]);
    if (!object || !contour) return;
    const std::optional<ContourCut> cut = emitter.contour_cut(*object, *contour);
    if (!cut) return;
    const Vector3d& at = cut->at;
    emitter.refuse(node.operands[1],
                   "the contour cuts the object: at (" + format_number(at.x) + ", " + format_number(at.y) + ", " +
                       format_number(at.z) + ") m the object's ray value is " + format_number(cut->object) +
                       " and the contour's " + format_number(cut->contour),
                   "a contour whose ray value is below 1 wherever the object's is at most 0.5");
  }
};

}  // namespace nearfield::host::operators
