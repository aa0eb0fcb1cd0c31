// The list of everything a field can be made of, in programs and in static composition. A new shape, modifier or blend is
// its header and one line here.
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
#include <nearfield/modify/uniform_scale.hpp>
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

// X(code, name, template). Codes are part of the image format and never change their meaning; they are dense, so that
// dispatch is one jump. What each costs: costs.hpp.
#define NEARFIELD_OPERATIONS(X)                                         \
  X(0x01, sphere, Sphere)                                               \
  X(0x02, capsule, Capsule)                                             \
  X(0x03, box, Box)                                                     \
  X(0x04, cylinder, Cylinder)                                           \
  X(0x05, soft_point, SoftPoint)                                        \
  X(0x06, soft_segment, SoftSegment)                                    \
  X(0x07, sharp_union, SharpUnion)                                      \
  X(0x08, sharp_intersection, SharpIntersection)                        \
  X(0x09, sharp_subtraction, SharpSubtraction)                          \
  X(0x0a, soft_sum, SoftSum)                                            \
  X(0x0b, additive_union, AdditiveUnion)                                \
  X(0x0c, additive_intersection, AdditiveIntersection)                  \
  X(0x0d, additive_subtraction, AdditiveSubtraction)                    \
  X(0x11, two_sided_union, TwoSidedUnion)                               \
  X(0x12, two_sided_intersection, TwoSidedIntersection)                 \
  X(0x13, two_sided_subtraction, TwoSidedSubtraction)                   \
  X(0x14, intensity_union, IntensityUnion)                              \
  X(0x15, intensity_intersection, IntensityIntersection)                \
  X(0x16, ray_union, RayUnion)                                          \
  X(0x17, ray_intersection, RayIntersection)                            \
  X(0x18, potential_of_distance, PotentialOfDistance)                   \
  X(0x19, potential_of_ray, PotentialOfRay)                             \
  X(0x1a, variable_influence, VariableInfluence)                        \
  X(0x1b, log_sum_exp_union, LogSumExpUnion)                            \
  X(0x1c, log_sum_exp_intersection, LogSumExpIntersection)              \
  X(0x1d, log_sum_exp_subtraction, LogSumExpSubtraction)                \
  X(0x1e, ray_point, RayPoint)                                          \
  X(0x1f, ray_segment, RaySegment)                                      \
  X(0x20, ray_linear_union, RayLinearUnion)                             \
  X(0x21, ray_linear_intersection, RayLinearIntersection)               \
  X(0x22, ray_linear_difference, RayLinearDifference)                   \
  X(0x23, ray_plane, RayPlane)                                          \
  X(0x24, algebraic_plane, AlgebraicPlane)                              \
  X(0x25, quadric, Quadric)                                             \
  X(0x26, algebraic_of_distance, AlgebraicOfDistance)                   \
  X(0x27, algebraic_of_ray, AlgebraicOfRay)                             \
  X(0x28, hoffmann_hopcroft_union, HoffmannHopcroftUnion)               \
  X(0x29, hoffmann_hopcroft_intersection, HoffmannHopcroftIntersection) \
  X(0x2a, hoffmann_hopcroft_difference, HoffmannHopcroftDifference)     \
  X(0x2b, functional_spline, FunctionalSpline)                          \
  X(0x2c, ribbon_patch, RibbonPatch)                                    \
  X(0x2d, corner_patch, CornerPatch)                                    \
  X(0x2e, algebraic_union, AlgebraicUnion)                              \
  X(0x2f, algebraic_intersection, AlgebraicIntersection)                \
  X(0x32, tapered_capsule, TaperedCapsule)                              \
  X(0x33, cone_frustum, ConeFrustum)                                    \
  X(0x34, torus, Torus)                                                 \
  X(0x35, disc, Disc)                                                   \
  X(0x36, half_space, HalfSpace)                                        \
  X(0x37, infinite_cylinder, InfiniteCylinder)                          \
  X(0x38, infinite_cone, InfiniteCone)                                  \
  X(0x39, offset, Offset)                                               \
  X(0x3a, polygon, Polygon)                                             \
  X(0x3b, polyline, Polyline)                                           \
  X(0x3c, cubic_curve, CubicCurve)                                      \
  X(0x3d, bicubic_patch, BicubicPatch)                                  \
  X(0x3e, ray_slab, RaySlab)                                            \
  X(0x3f, ray_of_distance, RayOfDistance)                               \
  X(0x40, ray_sweep, RaySweep)                                          \
  X(0x41, algebraic_torus, AlgebraicTorus)                              \
  X(0x42, noise_intensity, NoiseIntensity)                              \
  X(0x43, noise_distance, NoiseDistance)                                \
  X(0x44, morph, Morph)                                                 \
  X(0x45, intensity_morph, IntensityMorph)                              \
  X(0x46, ray_morph, RayMorph)                                          \
  X(0x47, swell, Swell)                                                 \
  X(0x48, fade, Fade)                                                   \
  X(0x49, scale_along, ScaleAlong)                                      \
  X(0x4a, scale_about, ScaleAbout)                                      \
  X(0x4b, scale_from_axis, ScaleFromAxis)

// Frames: evaluate what follows, up to the matching `leave`, in the coordinates of a pose.
//   enter_pose: payload a Pose. enter_slot: payload the number of a pose that the caller passes in.
// Boxes: enter_box, payload half extents, moves the point into a box about the local origin, up to the matching
// leave_box, payload a DeclaredBox, which makes a distance of an algebraic result.
// Sizes: enter_scale, payload a UniformScale and the kind of what follows, up to the matching leave_scale.
#define NEARFIELD_FRAME_OPERATIONS(X) \
  X(0x0e, enter_pose)                 \
  X(0x0f, enter_slot)                 \
  X(0x10, leave)                      \
  X(0x30, enter_box)                  \
  X(0x31, leave_box)                  \
  X(0x4c, enter_scale)                \
  X(0x4d, leave_scale)

inline constexpr uint32_t kSlotLimit = 64;  // frame slots of a field

enum class Operation : uint8_t {
#define NEARFIELD_ENUMERATOR(code, name, type) name = code,
  NEARFIELD_OPERATIONS(NEARFIELD_ENUMERATOR)
#undef NEARFIELD_ENUMERATOR
#define NEARFIELD_ENUMERATOR(code, name) name = code,
  NEARFIELD_FRAME_OPERATIONS(NEARFIELD_ENUMERATOR)
#undef NEARFIELD_ENUMERATOR
};

// The operations that a program may have: what is left out is not linked into a target. Frames and boxes always
// are there, sizes with enter_scale.
struct AllOperations {
  static constexpr bool has(Operation) { return true; }
};
template <Operation... chosen> struct OnlyOperations {
  static constexpr bool has(Operation operation) { return ((operation == chosen) || ...); }
};

// The code of an operation's type.
template <class T> struct OperationOf;
#define NEARFIELD_OPERATION_OF(code, name, type)          \
  template <class S> struct OperationOf<type<S>> {        \
    static constexpr Operation value = Operation::name;   \
  };
NEARFIELD_OPERATIONS(NEARFIELD_OPERATION_OF)
#undef NEARFIELD_OPERATION_OF

}  // namespace nearfield
