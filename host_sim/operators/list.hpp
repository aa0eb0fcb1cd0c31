// Every operator of the scene format. Each is a struct in one of the headers below, and one line in the list,
// with
//   static OperatorDescription description()          what a reader needs to know of it
//   static void add(FieldEmitter&, const FieldNode&)  how a node of it, whose parameters fit the scalar,
//                                                     becomes operations
#pragma once

#include <cstddef>
#include <vector>

#include "operators/additive.hpp"
#include "operators/algebraic.hpp"
#include "operators/deformations.hpp"
#include "operators/exact_solids.hpp"
#include "operators/metrics.hpp"
#include "operators/parameter.hpp"
#include "operators/patch.hpp"
#include "operators/placement.hpp"
#include "operators/ray.hpp"
#include "operators/sharp.hpp"
#include "operators/skeletons.hpp"
#include "operators/soft.hpp"
#include "operators/solids.hpp"

namespace nearfield::host::operators {

template <class... Operators>
struct List {
  static std::vector<OperatorDescription> descriptions() { return {Operators::description()...}; }

  // Adds a node of the operator at `index`.
  static void add(std::size_t index, FieldEmitter& emitter, const FieldNode& node) {
    using Add = void (*)(FieldEmitter&, const FieldNode&);
    static constexpr Add adders[] = {&Operators::add...};
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
         LpDistanceOperator, VariableInfluenceOperator, SuperEllipsoidalOperator<SetOperation::unite>,
         SuperEllipsoidalOperator<SetOperation::intersect>, SuperEllipsoidalOperator<SetOperation::subtract>,
         ScaleOperator<SetOperation::unite>, ScaleOperator<SetOperation::intersect>, AlgebraicPlaneOperator,
         QuadricOperator, DeclaredBoxOperator, AlgebraicOfDistanceOperator, AlgebraicOfRayOperator,
         SharpOperator<SetOperation::unite, FieldKind::algebraic>,
         SharpOperator<SetOperation::intersect, FieldKind::algebraic>,
         HoffmannHopcroftOperator<SetOperation::unite>, HoffmannHopcroftOperator<SetOperation::intersect>,
         HoffmannHopcroftOperator<SetOperation::subtract>, LimingOperator, FunctionalSplineOperator,
         RibbonPatchOperator, CornerPatchOperator, MorphOperator<FieldKind::distance>,
         MorphOperator<FieldKind::intensity>, MorphOperator<FieldKind::ray>, SwellOperator, FadeOperator,
         PolylineOperator, PolygonOperator, CubicCurveOperator, BicubicPatchOperator,
         TaperedCapsuleOperator, ConeFrustumOperator, TorusOperator, DiscOperator, HalfSpaceOperator,
         InfiniteCylinderOperator, InfiniteConeOperator, OffsetOperator, RoundedBoxOperator,
         RaySlabOperator, RayOfDistanceOperator, BoxMetricOperator, GeneralisedDistanceOperator,
         SuperquadricOperator, RaySweepOperator, AlgebraicSphereOperator,
         AlgebraicCylinderOperator, AlgebraicConeOperator, AlgebraicTorusOperator,
         NoiseOperator<FieldKind::distance>, NoiseOperator<FieldKind::intensity>, ScaleAlongOperator,
         ScaleAboutOperator, ScaleFromAxisOperator>;

}  // namespace nearfield::host::operators
