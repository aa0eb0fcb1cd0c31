// Ray functions: 1 at the influence boundary, 0.5 on the soft surface.
#pragma once

#include <nearfield/blend/ray_linear.hpp>
#include <nearfield/curve/ray_kernel.hpp>
#include <nearfield/modify/influence.hpp>
#include <nearfield/shape/ray.hpp>

#include "compile/quantise.hpp"
#include "compile/table_baker.hpp"
#include "operators/sharp.hpp"

namespace nearfield::host::operators {

inline const ParameterDescription ray_radius{"influence_radius", 1, {1.0 / 64.0, 16.0, "m"}};

struct RayPointOperator {
  static OperatorDescription description() {
    return shape("ray_point", FieldKind::ray, {ray_radius}, PlacementParts::position);
  }
  template <class Emitter>
  static void add(Emitter& emitter, const FieldNode& node) {
    using S = typename Emitter::Scalar;
    emitter.operation(RayPoint<S>{quantise<S>(node.placement.position),
                                  RayRadius<S>(quantise<S>(node.number("influence_radius")))});
  }
};

struct RaySegmentOperator {
  static OperatorDescription description() {
    return shape("ray_segment", FieldKind::ray, {required_point("from"), required_point("to"), ray_radius},
                 PlacementParts::none);
  }
  template <class Emitter>
  static void add(Emitter& emitter, const FieldNode& node) {
    using S = typename Emitter::Scalar;
    emitter.operation(RaySegment<S>{quantise_capsule<S>(node.vector("from"), node.vector("to"), 0.0),
                                    RayRadius<S>(quantise<S>(node.number("influence_radius")))});
  }
};

struct RayPlaneOperator {
  static OperatorDescription description() {
    return shape("ray_plane", FieldKind::ray, {{"normal", 3, {-1e6, 1e6, {}}}, ray_radius},
                 PlacementParts::position);
  }
  template <class Emitter>
  static void add(Emitter& emitter, const FieldNode& node) {
    using S = typename Emitter::Scalar;
    const Vector3d normal = node.vector("normal");
    const double size = length(normal);
    if (!(size > 0.0)) emitter.refuse(node, "normal", "a zero vector has no direction", "any other");
    emitter.operation(RayPlane<S>{quantise<S>(node.placement.position),
                                  quantise_unit<S>((1.0 / size) * normal),
                                  RayRadius<S>(quantise<S>(node.number("influence_radius")))});
  }
};

// Adds the blend of a profile.
template <SetOperation set_operation, class Emitter, class Profile>
void add_ray_linear(Emitter& emitter, const FieldNode& node, const char* key, const std::string& identity,
                    const Profile& profile) {
  using S = typename Emitter::Scalar;
  if (const char* problem = profile.problem())
    emitter.refuse(node, key, "the parameters do not fit each other", problem);
  const std::uint32_t table = emitter.table(node, key, profile_function(identity, profile)).reference;
  RayLinear<S, set_operation> blend;
  blend.sides = RaySides<S>::of(profile);
  if constexpr (set_operation == SetOperation::subtract) {
    const double surface = node.number("surface");
    blend.complement = {quantise<S>(surface * surface), quantise<S>(node.number("least"))};
  }
  emitter.fold(node, [&] { emitter.operation(blend, table); });
}

// Ricci's blends with exponent n; the difference is the intersection with the complement about `surface`.
template <SetOperation set_operation>
struct SuperEllipsoidalOperator {
  static OperatorDescription description() {
    OperatorDescription description =
        blend(pick<set_operation>("super_ellipsoidal_union", "super_ellipsoidal_intersection",
                                  "super_ellipsoidal_difference"),
              FieldKind::ray, {{"exponent", 1, {1.0, 64.0, {}}}});
    if (set_operation == SetOperation::subtract) {
      description.parameters.push_back({"surface", 1, {0.25, 1.0, {}}, {1.0}});
      description.parameters.push_back(
          {"least", 1, {0.0, 1.0, {}, true}, {0.5}, RatioRule{"surface", 0.26, 4.0}});
    }
    return description;
  }
  template <class Emitter>
  static void add(Emitter& emitter, const FieldNode& node) {
    const double exponent = node.number("exponent");
    const bool is_union = set_operation == SetOperation::unite;
    const std::string identity =
        (is_union ? "super-ellipsoidal union " : "super-ellipsoidal intersection ") + format_number(exponent);
    add_ray_linear<set_operation>(emitter, node, "exponent", identity,
                                  is_union ? profile::super_ellipsoidal_union(exponent)
                                           : profile::super_ellipsoidal_intersection(exponent));
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
  template <class Emitter>
  static void add(Emitter& emitter, const FieldNode& node) {
    const double r1 = node.number("r1"), r2 = node.number("r2"), p = node.number("p");
    const bool is_union = set_operation == SetOperation::unite;
    const std::string identity = std::string(is_union ? "scale union " : "scale intersection ") +
                                 format_number(r1) + " " + format_number(r2) + " " + format_number(p);
    add_ray_linear<set_operation>(
        emitter, node, "p", identity,
        is_union ? profile::scale_union(r1, r2, p) : profile::scale_intersection(r1, r2, p));
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
  template <class Emitter>
  static void add(Emitter& emitter, const FieldNode& node) {
    using S = typename Emitter::Scalar;
    const VariableInfluence<S> influence(quantise<S>(node.number("inner_range")));
    emitter.fold(node, [&] { emitter.operation(influence); });
  }
};

}  // namespace nearfield::host::operators
