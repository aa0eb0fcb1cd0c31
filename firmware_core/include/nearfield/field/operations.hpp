// The list of everything a field can be made of, and what each costs. A new shape, modifier or blend is its header and
// one line here.
#pragma once

#include <nearfield/blend/additive.hpp>
#include <nearfield/blend/hoffmann_hopcroft.hpp>
#include <nearfield/blend/liming.hpp>
#include <nearfield/blend/log_sum_exp.hpp>
#include <nearfield/blend/patch.hpp>
#include <nearfield/blend/ray_linear.hpp>
#include <nearfield/blend/sharp.hpp>
#include <nearfield/blend/soft.hpp>
#include <nearfield/modify/convert.hpp>
#include <nearfield/modify/declared_box.hpp>
#include <nearfield/modify/frame.hpp>
#include <nearfield/modify/influence.hpp>
#include <nearfield/modify/noise.hpp>
#include <nearfield/modify/offset.hpp>
#include <nearfield/modify/parameter.hpp>
#include <nearfield/modify/potential.hpp>
#include <nearfield/modify/ray_of_distance.hpp>
#include <nearfield/modify/scale_about.hpp>
#include <nearfield/modify/scale_along.hpp>
#include <nearfield/modify/scale_from_axis.hpp>
#include <nearfield/modify/sweep.hpp>
#include <nearfield/shape/algebraic.hpp>
#include <nearfield/shape/algebraic_torus.hpp>
#include <nearfield/shape/bicubic_patch.hpp>
#include <nearfield/shape/box.hpp>
#include <nearfield/shape/capsule.hpp>
#include <nearfield/shape/cone_frustum.hpp>
#include <nearfield/shape/cubic_curve.hpp>
#include <nearfield/shape/cylinder.hpp>
#include <nearfield/shape/disc.hpp>
#include <nearfield/shape/polygon.hpp>
#include <nearfield/shape/polyline.hpp>
#include <nearfield/shape/ray.hpp>
#include <nearfield/shape/ray_slab.hpp>
#include <nearfield/shape/soft.hpp>
#include <nearfield/shape/sphere.hpp>
#include <nearfield/shape/tapered_capsule.hpp>
#include <nearfield/shape/torus.hpp>
#include <nearfield/shape/unbounded.hpp>

namespace nearfield {

// X(code, name, template, value, gradient). Codes are part of the image format and never change their meaning; they
// are dense, so that dispatch is one jump.
// value, gradient: worst-case instructions of the value alone and of value with gradient on a Cortex-M4 without FPU,
// Fixed<27>, GCC 12 -O2, dispatch included. It is the greatest count that ports/mps2/operation_costs.cpp measures over
// each operation's worst paths, and one in sixteen more; running that program checks that no measurement exceeds what is
// stated here.
#define NEARFIELD_OPERATIONS(X)                                                   \
  X(0x01, sphere, Sphere, 116, 195)                                               \
  X(0x02, capsule, Capsule, 163, 242)                                             \
  X(0x03, box, Box, 146, 255)                                                     \
  X(0x04, cylinder, Cylinder, 211, 363)                                           \
  X(0x05, soft_point, SoftPoint, 126, 302)                                        \
  X(0x06, soft_segment, SoftSegment, 189, 359)                                    \
  X(0x07, sharp_union, SharpUnion, 24, 30)                                        \
  X(0x08, sharp_intersection, SharpIntersection, 24, 30)                          \
  X(0x09, sharp_subtraction, SharpSubtraction, 25, 41)                            \
  X(0x0a, soft_sum, SoftSum, 22, 52)                                              \
  X(0x0b, additive_union, AdditiveUnion, 88, 129)                                 \
  X(0x0c, additive_intersection, AdditiveIntersection, 89, 129)                   \
  X(0x0d, additive_subtraction, AdditiveSubtraction, 88, 141)                     \
  X(0x11, two_sided_union, TwoSidedUnion, 94, 136)                                \
  X(0x12, two_sided_intersection, TwoSidedIntersection, 95, 136)                  \
  X(0x13, two_sided_subtraction, TwoSidedSubtraction, 95, 148)                    \
  X(0x14, intensity_union, IntensityUnion, 24, 30)                                \
  X(0x15, intensity_intersection, IntensityIntersection, 24, 30)                  \
  X(0x16, ray_union, RayUnion, 24, 30)                                            \
  X(0x17, ray_intersection, RayIntersection, 24, 30)                              \
  X(0x18, potential_of_distance, PotentialOfDistance, 92, 208)                    \
  X(0x19, potential_of_ray, PotentialOfRay, 92, 207)                              \
  X(0x1a, variable_influence, VariableInfluence, 149, 428)                        \
  X(0x1b, log_sum_exp_union, LogSumExpUnion, 164, 205)                            \
  X(0x1c, log_sum_exp_intersection, LogSumExpIntersection, 164, 205)              \
  X(0x1d, log_sum_exp_subtraction, LogSumExpSubtraction, 156, 192)                \
  X(0x1e, ray_point, RayPoint, 138, 243)                                          \
  X(0x1f, ray_segment, RaySegment, 208, 311)                                      \
  X(0x20, ray_linear_union, RayLinearUnion, 146, 255)                             \
  X(0x21, ray_linear_intersection, RayLinearIntersection, 146, 246)               \
  X(0x22, ray_linear_difference, RayLinearDifference, 244, 402)                   \
  X(0x23, ray_plane, RayPlane, 107, 149)                                          \
  X(0x24, algebraic_plane, AlgebraicPlane, 64, 99)                                \
  X(0x25, quadric, Quadric, 183, 268)                                             \
  X(0x26, algebraic_of_distance, AlgebraicOfDistance, 27, 69)                     \
  X(0x27, algebraic_of_ray, AlgebraicOfRay, 43, 106)                              \
  X(0x28, hoffmann_hopcroft_union, HoffmannHopcroftUnion, 155, 494)               \
  X(0x29, hoffmann_hopcroft_intersection, HoffmannHopcroftIntersection, 173, 516) \
  X(0x2a, hoffmann_hopcroft_difference, HoffmannHopcroftDifference, 165, 517)     \
  X(0x2b, functional_spline, FunctionalSpline, 134, 333)                          \
  X(0x2c, ribbon_patch, RibbonPatch, 540, 716)                                    \
  X(0x2d, corner_patch, CornerPatch, 792, 272)                                    \
  X(0x2e, algebraic_union, AlgebraicUnion, 24, 30)                                \
  X(0x2f, algebraic_intersection, AlgebraicIntersection, 24, 30)                  \
  X(0x32, tapered_capsule, TaperedCapsule, 233, 438)                              \
  X(0x33, cone_frustum, ConeFrustum, 253, 395)                                    \
  X(0x34, torus, Torus, 189, 347)                                                 \
  X(0x35, disc, Disc, 196, 349)                                                   \
  X(0x36, half_space, HalfSpace, 55, 78)                                          \
  X(0x37, infinite_cylinder, InfiniteCylinder, 112, 192)                          \
  X(0x38, infinite_cone, InfiniteCone, 160, 246)                                  \
  X(0x39, offset, Offset, 16, 24)                                                 \
  X(0x3a, polygon, Polygon, 339, 429)                                             \
  X(0x3b, polyline, Polyline, 350, 438)                                           \
  X(0x3c, cubic_curve, CubicCurve, 1402, 1485)                                    \
  X(0x3d, bicubic_patch, BicubicPatch, 5000, 5100)                                \
  X(0x3e, ray_slab, RaySlab, 112, 166)                                            \
  X(0x3f, ray_of_distance, RayOfDistance, 54, 119)                                \
  X(0x40, ray_sweep, RaySweep, 507, 780)                                          \
  X(0x41, algebraic_torus, AlgebraicTorus, 174, 440)                              \
  X(0x42, noise_intensity, NoiseIntensity, 94, 298)                               \
  X(0x43, noise_distance, NoiseDistance, 80, 160)                                 \
  X(0x44, morph, Morph, 31, 68)                                                   \
  X(0x45, intensity_morph, IntensityMorph, 31, 68)                                \
  X(0x46, ray_morph, RayMorph, 31, 68)                                            \
  X(0x47, swell, Swell, 26, 36)                                                   \
  X(0x48, fade, Fade, 22, 43)                                                     \
  X(0x49, scale_along, ScaleAlong, 127, 257)                                      \
  X(0x4a, scale_about, ScaleAbout, 285, 691)                                      \
  X(0x4b, scale_from_axis, ScaleFromAxis, 149, 363)

// What each item adds to that, of operations with any number of items: operands where their number is any, otherwise
// what the payload's item_count() counts.
#define NEARFIELD_ITEM_COSTS(X)        \
  X(log_sum_exp_union, 50, 127)        \
  X(log_sum_exp_intersection, 50, 127) \
  X(log_sum_exp_subtraction, 53, 139)  \
  X(functional_spline, 20, 93)         \
  X(ribbon_patch, 136, 379)            \
  X(corner_patch, 208, 627)            \
  X(noise_intensity, 157, 230)         \
  X(noise_distance, 157, 230)          \
  X(ray_sweep, 26, 38)                 \
  X(cubic_curve, 765, 765)             \
  X(polygon, 58, 58)                   \
  X(polyline, 58, 68)

// Frames: evaluate what follows, up to the matching `leave`, in the coordinates of a pose.
//   enter_pose: payload a Pose. enter_slot: payload the number of a pose that the caller passes in.
// Boxes: enter_box, payload half extents, moves the point into a box about the local origin, up to the matching
// leave_box, payload a DeclaredBox, which makes a distance of an algebraic result.
#define NEARFIELD_FRAME_OPERATIONS(X) \
  X(0x0e, enter_pose, 128, 202)       \
  X(0x0f, enter_slot, 96, 132)        \
  X(0x10, leave, 20, 30)              \
  X(0x30, enter_box, 75, 90)          \
  X(0x31, leave_box, 111, 157)

inline constexpr uint32_t kSlotLimit = 64;  // frame slots of a field

enum class Operation : uint8_t {
#define NEARFIELD_ENUMERATOR(code, name, type, value, gradient) name = code,
  NEARFIELD_OPERATIONS(NEARFIELD_ENUMERATOR)
#undef NEARFIELD_ENUMERATOR
#define NEARFIELD_ENUMERATOR(code, name, value, gradient) name = code,
  NEARFIELD_FRAME_OPERATIONS(NEARFIELD_ENUMERATOR)
#undef NEARFIELD_ENUMERATOR
};

// The operations that a program may have: what is left out is not linked into a target. Frames and boxes always are there.
struct AllOperations {
  static constexpr bool has(Operation) { return true; }
};
template <Operation... chosen> struct OnlyOperations {
  static constexpr bool has(Operation operation) { return ((operation == chosen) || ...); }
};

// The code of an operation's type.
template <class T> struct OperationOf;
#define NEARFIELD_OPERATION_OF(code, name, type, value_cost, gradient_cost) \
  template <class S> struct OperationOf<type<S>> {                          \
    static constexpr Operation value = Operation::name;                     \
  };
NEARFIELD_OPERATIONS(NEARFIELD_OPERATION_OF)
#undef NEARFIELD_OPERATION_OF

}  // namespace nearfield
