// The list of everything a field can be made of, and what each costs. A new shape, modifier or blend is its header and
// one line here.
#pragma once

#include <nearfield/blend/additive.hpp>
#include <nearfield/blend/sharp.hpp>
#include <nearfield/blend/soft.hpp>
#include <nearfield/modify/frame.hpp>
#include <nearfield/shape/box.hpp>
#include <nearfield/shape/capsule.hpp>
#include <nearfield/shape/cylinder.hpp>
#include <nearfield/shape/soft.hpp>
#include <nearfield/shape/sphere.hpp>

namespace nearfield {

// X(code, name, template, value, gradient). Codes are part of the image format and never change their meaning; they
// are dense, so that dispatch is one jump.
// value, gradient: worst-case instructions of the value alone and of value with gradient on a Cortex-M4 without FPU,
// Fixed<27>, GCC 12 -O2, dispatch included; of operations with any number of operands those of each operand. It is the
// greatest count that ports/mps2/operation_costs.cpp measures over each operation's worst paths, and one in sixteen
// more; running that program checks that no measurement exceeds what is stated here.
#define NEARFIELD_OPERATIONS(X)                                          \
  X(0x01, sphere, Sphere, 96, 156)                                       \
  X(0x02, capsule, Capsule, 173, 225)                                    \
  X(0x03, box, Box, 141, 245)                                            \
  X(0x04, cylinder, Cylinder, 204, 329)                                  \
  X(0x05, soft_point, SoftPoint, 87, 250)                                \
  X(0x06, soft_segment, SoftSegment, 179, 317)                           \
  X(0x07, sharp_union, SharpUnion, 60, 63)                               \
  X(0x08, sharp_intersection, SharpIntersection, 60, 63)                 \
  X(0x09, sharp_subtraction, SharpSubtraction, 61, 59)                   \
  X(0x0a, soft_sum, SoftSum, 64, 92)                                     \
  X(0x0b, additive_union, AdditiveUnion, 114, 163)                       \
  X(0x0c, additive_intersection, AdditiveIntersection, 114, 163)         \
  X(0x0d, additive_subtraction, AdditiveSubtraction, 114, 183)           \
  X(0x11, two_sided_union, TwoSidedUnion, 130, 180)                      \
  X(0x12, two_sided_intersection, TwoSidedIntersection, 130, 180)        \
  X(0x13, two_sided_subtraction, TwoSidedSubtraction, 130, 200)          \
  X(0x14, intensity_union, IntensityUnion, 60, 63)                       \
  X(0x15, intensity_intersection, IntensityIntersection, 60, 63)         \
  X(0x16, ray_union, RayUnion, 60, 63)                                   \
  X(0x17, ray_intersection, RayIntersection, 60, 63)

// Frames: evaluate what follows, up to the matching `leave`, in the coordinates of a pose.
//   enter_pose: payload a Pose. enter_slot: payload the number of a pose that the caller passes in.
#define NEARFIELD_FRAME_OPERATIONS(X) \
  X(0x0e, enter_pose, 114, 183)       \
  X(0x0f, enter_slot, 85, 114)        \
  X(0x10, leave, 20, 30)

inline constexpr uint32_t kSlotLimit = 64;  // frame slots of a field

enum class Operation : uint8_t {
#define NEARFIELD_ENUMERATOR(code, name, type, value, gradient) name = code,
  NEARFIELD_OPERATIONS(NEARFIELD_ENUMERATOR)
#undef NEARFIELD_ENUMERATOR
#define NEARFIELD_ENUMERATOR(code, name, value, gradient) name = code,
  NEARFIELD_FRAME_OPERATIONS(NEARFIELD_ENUMERATOR)
#undef NEARFIELD_ENUMERATOR
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
