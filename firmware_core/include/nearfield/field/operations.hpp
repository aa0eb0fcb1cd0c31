// The list of everything a field can be made of. A new shape or blend is its header and one line here.
#pragma once

#include <nearfield/blend/additive.hpp>
#include <nearfield/blend/soft.hpp>
#include <nearfield/modify/frame.hpp>
#include <nearfield/shape/box.hpp>
#include <nearfield/shape/capsule.hpp>
#include <nearfield/shape/cylinder.hpp>
#include <nearfield/shape/soft.hpp>
#include <nearfield/shape/sphere.hpp>

namespace nearfield {

template <class S> using SharpUnion = Sharp<S, SetOperation::unite>;
template <class S> using SharpIntersection = Sharp<S, SetOperation::intersect>;
template <class S> using SharpSubtraction = Sharp<S, SetOperation::subtract>;
template <class S> using ExteriorUnion = Exterior<S, SetOperation::unite>;
template <class S> using ExteriorIntersection = Exterior<S, SetOperation::intersect>;
template <class S> using ExteriorSubtraction = Exterior<S, SetOperation::subtract>;

// X(code, name, template): codes are part of the image format and never change their meaning; they are dense, so that dispatch is one jump.
// Shapes push a result, blends replace the two results on top of the stack by one. WITH_TABLE entries sample a table.
#define NEARFIELD_SHAPES(X)      \
  X(0x01, sphere, Sphere)        \
  X(0x02, capsule, Capsule)      \
  X(0x03, box, Box)              \
  X(0x04, cylinder, Cylinder)
#define NEARFIELD_SHAPES_WITH_TABLE(X) \
  X(0x05, soft_point, SoftPoint)       \
  X(0x06, soft_segment, SoftSegment)
#define NEARFIELD_BLENDS(X)                          \
  X(0x07, sharp_union, SharpUnion)                   \
  X(0x08, sharp_intersection, SharpIntersection)     \
  X(0x09, sharp_subtraction, SharpSubtraction)       \
  X(0x0a, soft_sum, SoftSum)
#define NEARFIELD_BLENDS_WITH_TABLE(X)               \
  X(0x0b, exterior_union, ExteriorUnion)             \
  X(0x0c, exterior_intersection, ExteriorIntersection) \
  X(0x0d, exterior_subtraction, ExteriorSubtraction)

inline constexpr uint32_t kSlotLimit = 64;  // frame slots of a field

// Frames: evaluate what follows, up to the matching `leave`, in the coordinates of a pose.
enum class Operation : uint8_t {
#define NEARFIELD_ENUMERATOR(code, name, type) name = code,
  NEARFIELD_SHAPES(NEARFIELD_ENUMERATOR) NEARFIELD_SHAPES_WITH_TABLE(NEARFIELD_ENUMERATOR)
  NEARFIELD_BLENDS(NEARFIELD_ENUMERATOR) NEARFIELD_BLENDS_WITH_TABLE(NEARFIELD_ENUMERATOR)
#undef NEARFIELD_ENUMERATOR
  enter_pose = 0x0e,  // payload: a Pose
  enter_slot = 0x0f,  // payload: the number of a pose that the caller passes in
  leave = 0x10,
};

// The operation of a shape or blend type.
template <class T> struct OperationOf;
#define NEARFIELD_OPERATION_OF(code, name, type)                 \
  template <class S> struct OperationOf<type<S>> {               \
    static constexpr Operation value = Operation::name;          \
    static constexpr bool uses_table = false;                    \
  };
#define NEARFIELD_OPERATION_WITH_TABLE_OF(code, name, type)      \
  template <class S> struct OperationOf<type<S>> {               \
    static constexpr Operation value = Operation::name;          \
    static constexpr bool uses_table = true;                     \
  };
NEARFIELD_SHAPES(NEARFIELD_OPERATION_OF)
NEARFIELD_SHAPES_WITH_TABLE(NEARFIELD_OPERATION_WITH_TABLE_OF)
NEARFIELD_BLENDS(NEARFIELD_OPERATION_OF)
NEARFIELD_BLENDS_WITH_TABLE(NEARFIELD_OPERATION_WITH_TABLE_OF)
#undef NEARFIELD_OPERATION_OF
#undef NEARFIELD_OPERATION_WITH_TABLE_OF

}  // namespace nearfield
