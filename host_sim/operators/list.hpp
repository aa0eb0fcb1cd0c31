// Every operator of the scene format. Each is a struct in one of the headers below, and one line in the list, with
//   static OperatorDescription description()                    what a reader needs to know of it
//   template <class Emitter> static void add(Emitter&, node)    how a node of it becomes operations
// An Emitter (compile/field_compiler.cpp) has
//   Scalar                             the scalar type
//   operation(payload [, table])       adds an operation of nearfield/field/operations.hpp
//   table(node, key, function)         reference and range of a function's table; blames node.key when there is none
//   operand(node)                      adds a node below
//   certified_operand(node)            the same, and returns its certificate (of an outer frame, so none too small)
//   in_declared_box(node, half)        adds the one node below within a declared box
//   trial_value(node, point, blend)    value at a point of all nodes below, blended by what blend() adds; adds nothing
//   refuse(node, key, what, allowed)   InputError at node.key
//   fold(node, add_operation)          adds all nodes below, from the second on each followed by add_operation()
//   in_frame(placement, inside)        what inside() adds, in a frame of its own
//   placed(placement, shape)           what shape(at) adds: at the position, or turned in a frame of its own at {}
#pragma once

#include <cstddef>
#include <vector>

#include "operators/additive.hpp"
#include "operators/algebraic.hpp"
#include "operators/placement.hpp"
#include "operators/ray.hpp"
#include "operators/sharp.hpp"
#include "operators/soft.hpp"
#include "operators/solids.hpp"

namespace nearfield::host::operators {

template <class... Operators>
struct List {
  static std::vector<OperatorDescription> descriptions() { return {Operators::description()...}; }

  // Adds a node of the operator at `index`.
  template <class Emitter>
  static void add(std::size_t index, Emitter& emitter, const FieldNode& node) {
    using Add = void (*)(Emitter&, const FieldNode&);
    static constexpr Add adders[] = {&Operators::template add<Emitter>...};
    adders[index](emitter, node);
  }
};

using All =
    List<BallOperator, CapsuleOperator, BoxOperator, CylinderOperator,
         SharpOperator<SetOperation::unite, FieldKind::distance>,
         SharpOperator<SetOperation::intersect, FieldKind::distance>,
         SharpOperator<SetOperation::subtract, FieldKind::distance>, ExteriorOperator<SetOperation::unite>,
         ExteriorOperator<SetOperation::intersect>, ExteriorOperator<SetOperation::subtract>,
         InteriorOperator<SetOperation::unite>, InteriorOperator<SetOperation::intersect>,
         InteriorOperator<SetOperation::subtract>, LogSumExpOperator<SetOperation::unite>,
         LogSumExpOperator<SetOperation::intersect>, LogSumExpOperator<SetOperation::subtract>,
         QuadraticOperator<SetOperation::unite>, QuadraticOperator<SetOperation::intersect>,
         QuadraticOperator<SetOperation::subtract>, CubicOperator<SetOperation::unite>,
         CubicOperator<SetOperation::intersect>, CubicOperator<SetOperation::subtract>, PlaceOperator,
         SoftPointOperator, SoftSegmentOperator, SoftSumOperator,
         SharpOperator<SetOperation::unite, FieldKind::intensity>,
         SharpOperator<SetOperation::intersect, FieldKind::intensity>,
         SharpOperator<SetOperation::unite, FieldKind::ray>,
         SharpOperator<SetOperation::intersect, FieldKind::ray>, PotentialOperator<FieldKind::distance>,
         PotentialOperator<FieldKind::ray>, RayPointOperator, RaySegmentOperator, RayPlaneOperator,
         VariableInfluenceOperator, SuperEllipsoidalOperator<SetOperation::unite>,
         SuperEllipsoidalOperator<SetOperation::intersect>, SuperEllipsoidalOperator<SetOperation::subtract>,
         ScaleOperator<SetOperation::unite>, ScaleOperator<SetOperation::intersect>, AlgebraicPlaneOperator,
         QuadricOperator, DeclaredBoxOperator, AlgebraicOfDistanceOperator, AlgebraicOfRayOperator,
         SharpOperator<SetOperation::unite, FieldKind::algebraic>,
         SharpOperator<SetOperation::intersect, FieldKind::algebraic>,
         HoffmannHopcroftOperator<SetOperation::unite>, HoffmannHopcroftOperator<SetOperation::intersect>,
         HoffmannHopcroftOperator<SetOperation::subtract>, LimingOperator, FunctionalSplineOperator,
         RibbonPatchOperator, CornerPatchOperator>;

}  // namespace nearfield::host::operators
