// Random programs of every operation, as images.
#pragma once

#include <operation_costs/deformations.hpp>

#include <random_programs/draw.hpp>

namespace nearfield::costs {

using ProgramBuilder = ImageBuilder<Q, 4096>;

enum class SharedTable : uint32_t {
  kernel, two_sided_kernel, squared_potential, potential, round_union, scale_union, round_intersection, scale_intersection,
  along, about, count
};

// Draws a program twice: once to see which tables it needs, and once more with these in front of it.
class Composition {
 public:
  static constexpr uint32_t greatest_node_count = 24;

  explicit Composition(uint64_t seed) {
    compose(Draw(seed));
    final_ = true;
    parameters_ = poses_ = 0;
    compose(Draw(seed));
    inspection_ = builder().finish();
  }
  // Most are: a field may reach out of the range of numbers, or take more stack than there is.
  bool valid() const { return inspection_.status == LoadStatus::ok; }
  uint32_t nodes() const { return nodes_; }
  const ProgramBuilder& image() const { return builder(); }

 private:
  static ProgramBuilder& builder() {
    static ProgramBuilder builder;
    return builder;
  }

  void compose(const Draw& draw) {
    draw_ = draw;
    builder() = ProgramBuilder();
    add_tables();
    nodes_ = draw_.within(1, greatest_node_count);
    const uint32_t kind = draw_.below(10);
    if (kind < 7) distance(nodes_, true);
    else if (kind == 7) intensity(nodes_);
    else if (kind == 8) ray(nodes_);
    else algebraic(nodes_);
  }

  void add_tables() {
    add(SharedTable::kernel, kKernel);
    add(SharedTable::two_sided_kernel, kTwoSidedKernel);
    add(SharedTable::squared_potential, kSquaredPotential);
    add(SharedTable::potential, kPotential);
    add(SharedTable::round_union, kProfile<kRoundUnion>);
    add(SharedTable::scale_union, kProfile<kScaleUnion>);
    add(SharedTable::round_intersection, kProfile<kRoundIntersection>);
    add(SharedTable::scale_intersection, kProfile<kScaleIntersection>);
    add(SharedTable::along, kAlongProfile);
    add(SharedTable::about, kAboutProfile);
  }
  template <class Table> void add(SharedTable name, const Table& table) {
    const auto number = static_cast<uint32_t>(name);
    if ((used_tables_ >> number & 1u) != 0) reference_[number] = builder().table(table);
  }

  template <class T> void emit(const T& operation) { builder().operation(operation); }
  template <class T> void emit(const T& operation, SharedTable table) {
    const auto number = static_cast<uint32_t>(table);
    used_tables_ |= 1u << number;
    builder().operation(operation, reference_[number]);
  }
  // Of what was emitted from this word on. Nothing is known of it before the tables are there.
  Inspection<Q> inspected(const ProgramBuilder& of, uint32_t first) const {
    return final_ ? detail::inspect_operations<Q, AllOperations>(of.words(), first, of.size()) : Inspection<Q>{};
  }
  // A little more than the operand's own, which frames may change.
  Certificate<Q> bounds_of_operand(uint32_t first) const {
    Certificate<Q> bounds = inspected(builder(), first).certificate;
    bounds.error = ScalarTraits<Q>::times(bounds.error, 4);
    return bounds;
  }

  // As many nodes for the first operand; the rest is the second's, one the blend itself.
  uint32_t share_of(uint32_t nodes) { return draw_.within(1, nodes - 2); }

  // How many operands of each one node or more, at most as many as are allowed; and then the nodes of each.
  template <class Operand> void operands(uint32_t count, uint32_t nodes, Operand&& operand) {
    uint32_t rest = nodes - count;
    for (uint32_t i = 0; i < count; ++i) {
      const uint32_t more = i + 1 == count ? rest : draw_.below(rest + 1);
      rest -= more;
      operand(1 + more);
    }
  }

  template <class Inner> void framed(Kind kind, Inner&& inner) {
    ++frames_;
    if (draw_.one_in(3)) {
      builder().enter_scale(UniformScale<Q>(draw_.between(600, 2000)), kind);
      inner();
      builder().leave_scale();
      --frames_;
      return;
    }
    if (draw_.one_in(3)) {
      const uint32_t slot = draw_.below(least_of_two<uint32_t>(poses_ + 1, 4));
      poses_ = greatest_of_two(poses_, slot + 1);
      builder().enter_slot(slot);
    } else {
      builder().enter(draw_.pose());
    }
    inner();
    builder().leave();
    --frames_;
  }
  bool may_enter() { return frames_ < 3 && draw_.one_in(6); }
  uint32_t parameter() {
    const uint32_t slot = draw_.below(least_of_two<uint32_t>(parameters_ + 1, 4));
    parameters_ = greatest_of_two(parameters_, slot + 1);
    return slot;
  }

  // Distances. Those within a box may not be blended, only have an edge in common with others.
  void distance(uint32_t nodes, bool may_be_partial = false) {
    if (nodes == 1) return distance_leaf();
    if (may_enter()) return framed(Kind::distance, [&] { distance(nodes - 1, may_be_partial); });
    if (may_be_partial && frames_ < 3 && draw_.one_in(6)) return boxed(nodes - 1);
    if (nodes == 2 || draw_.one_in(6)) return changed_distance(nodes - 1);
    if (draw_.one_in(5)) return joined_distances(nodes - 1);
    const bool sharp = draw_.one_in(3);
    const uint32_t first = share_of(nodes);
    distance(first, may_be_partial && sharp);
    distance(nodes - 1 - first, may_be_partial && sharp);
    if (sharp) return sharp_blend();
    distance_blend();
  }
  void distance_leaf() {
    Draw& d = draw_;
    switch (d.below(15)) {
      case 0: return emit(Sphere<Q>{d.place(), d.between(50, 600)});
      case 1: return emit(Capsule<Q>(d.place(), d.place(), d.between(20, 300)));
      case 2: return emit(Box<Q>{d.place(), d.lengths(50, 600)});
      case 3: return emit(Cylinder<Q>{d.place(), d.between(50, 500), d.between(50, 500)});
      case 4: {
        // Longer than its radii differ.
        const Vector3<Q> from = d.place(), to = from + Vector3<Q>{Q(0.3), Q(-0.2), Q(0.4)};
        return emit(TaperedCapsule<Q>(from, to, d.between(50, 300), d.between(50, 300)));
      }
      case 5: return emit(ConeFrustum<Q>(d.place(), d.between(50, 500), d.between(50, 500), d.between(50, 500)));
      case 6: return emit(Torus<Q>{d.place(), d.between(200, 600), d.between(20, 200)});
      case 7: return emit(Disc<Q>{d.place(), d.between(100, 600), d.between(20, 200)});
      case 8: return emit(HalfSpace<Q>{d.place(), d.direction()});
      case 9: return emit(InfiniteCylinder<Q>{d.between(-400, 400), d.between(-400, 400), d.between(50, 500)});
      case 10: return emit(InfiniteCone<Q>{d.place(), 0.6, 0.8});
      case 11: return emit(d.polyline());
      case 12: return emit(d.polygon());
      case 13: return emit(d.curve());
      default: return emit(d.patch());
    }
  }
  void boxed(uint32_t nodes) {
    const Vector3<Q> half = draw_.lengths(300, 2000);
    ++frames_;
    const uint32_t first = builder().size();
    builder().enter_box(half);
    algebraic(nodes);
    --frames_;
    static ProgramBuilder draft;
    draft = builder();
    draft.leave_box(DeclaredBox<Q>(half, kUnitRate));
    builder().leave_box(DeclaredBox<Q>(half, inspected(draft, first).boxed.lipschitz));
  }
  void changed_distance(uint32_t nodes) {
    distance(nodes);
    Draw& d = draw_;
    switch (d.below(3)) {
      case 0: return emit(Offset<Q>{d.between(-100, 200)});
      case 1: return emit(Swell<Q>{d.between(-200, 300), parameter()});
      default:
        return emit(NoiseDistance<Q>{{d.between(5, 50), frequency(), d.within(1, 4), d.below(1000)}});
    }
  }
  Fixed<16> frequency() { return Fixed<16>::from_raw(static_cast<int32_t>(draw_.within(1 << 14, 1 << 18))); }
  void sharp_blend() {
    switch (draw_.below(3)) {
      case 0: return emit(SharpUnion<Q>{});
      case 1: return emit(SharpIntersection<Q>{});
      default: return emit(SharpSubtraction<Q>{});
    }
  }
  void distance_blend() {
    const ArgumentScale<Q> scale = ArgumentScale<Q>::of(draw_.between(200, 2000));
    switch (draw_.below(7)) {
      case 0: return emit(AdditiveUnion<Q>{scale}, SharedTable::kernel);
      case 1: return emit(AdditiveIntersection<Q>{scale}, SharedTable::kernel);
      case 2: return emit(AdditiveSubtraction<Q>{scale}, SharedTable::kernel);
      case 3: return emit(TwoSidedUnion<Q>{scale}, SharedTable::two_sided_kernel);
      case 4: return emit(TwoSidedIntersection<Q>{scale}, SharedTable::two_sided_kernel);
      case 5: return emit(TwoSidedSubtraction<Q>{scale}, SharedTable::two_sided_kernel);
      default: return emit(Morph<Q>{parameter()});
    }
  }
  void joined_distances(uint32_t nodes) {
    const uint32_t count = draw_.within(1, least_of_two<uint32_t>(nodes, 8));
    operands(count, nodes, [&](uint32_t of_operand) { distance(of_operand); });
    const ArgumentScale<Q> scale = ArgumentScale<Q>::of(draw_.between(500, 3000));
    switch (draw_.below(3)) {
      case 0: return emit(LogSumExpUnion<Q>{scale, count});
      case 1: return emit(LogSumExpIntersection<Q>{scale, count});
      default: return emit(LogSumExpSubtraction<Q>{scale, count});
    }
  }

  // Intensities.
  void intensity(uint32_t nodes) {
    Draw& d = draw_;
    const Influence<Q> influence(d.between(500, 2500), d.between(-500, 1500));
    if (nodes == 1) {
      if (d.one_in(2)) return emit(SoftPoint<Q>{d.place(), influence}, SharedTable::squared_potential);
      return emit(SoftSegment<Q>{d.segment(), influence}, SharedTable::squared_potential);
    }
    if (may_enter()) return framed(Kind::intensity, [&] { intensity(nodes - 1); });
    if (nodes == 2 || d.one_in(4)) return changed_intensity(nodes - 1);
    const uint32_t first = share_of(nodes);
    intensity(first);
    intensity(nodes - 1 - first);
    switch (d.below(4)) {
      case 0: return emit(SoftSum<Q>{});
      case 1: return emit(IntensityUnion<Q>{});
      case 2: return emit(IntensityIntersection<Q>{});
      default: return emit(IntensityMorph<Q>{parameter()});
    }
  }
  void changed_intensity(uint32_t nodes) {
    Draw& d = draw_;
    const Q weight = d.between(-500, 1500);
    const uint32_t first = builder().size(), which = d.below(4);
    if (which == 0) {
      distance(nodes);
      return emit(PotentialOfDistance<Q>(d.between(500, 2500), weight, bounds_of_operand(first)), SharedTable::potential);
    }
    if (which == 1) {
      ray(nodes);
      return emit(PotentialOfRay<Q>(Q(1.0), weight, bounds_of_operand(first)), SharedTable::potential);
    }
    intensity(nodes);
    if (which == 2) return emit(Fade<Q>{parameter()});
    emit(NoiseIntensity<Q>{{d.between(50, 500), frequency(), d.within(1, 4), d.below(1000)}});
  }

  // Rays.
  void ray(uint32_t nodes) {
    if (nodes == 1) return ray_leaf();
    if (may_enter()) return framed(Kind::ray, [&] { ray(nodes - 1); });
    if (nodes == 2 || draw_.one_in(4)) return changed_ray(nodes - 1);
    const uint32_t first = share_of(nodes);
    ray(first);
    ray(nodes - 1 - first);
    ray_blend();
  }
  void ray_leaf() {
    Draw& d = draw_;
    const RayRadius<Q> influence(d.between(200, 2000));
    switch (d.below(5)) {
      case 0: return emit(RayPoint<Q>{d.place(), influence});
      case 1: return emit(RaySegment<Q>{d.segment(), influence});
      case 2: return emit(RayPlane<Q>{d.place(), d.direction(), influence});
      case 3: return emit(RaySlab<Q>{d.place(), d.direction(), influence});
      default: return ray_sweep();
    }
  }
  void ray_sweep() {
    Draw& d = draw_;
    const Rate exponents[] = {Rate(0.25), Rate(0.7), Rate(1.3), Rate(2.5), Rate(7.3)};
    const Rate section = exponents[d.below(5)], ends = exponents[d.below(5)];
    const Vector3<Q> radii = d.lengths(200, 800);
    if (d.one_in(3)) return emit(RaySweep<Q>(d.place(), radii, section, ends));
    const Q twist = d.one_in(3) ? Q{} : d.between(-2000, 2000), growth = d.one_in(3) ? Q(1.0) : d.between(500, 1200);
    emit(RaySweep<Q>(d.place(), radii, section, ends, d.between(1000, 3000), twist, growth));
  }
  void changed_ray(uint32_t nodes) {
    Draw& d = draw_;
    const uint32_t which = d.below(5);
    if (which == 0) {
      distance(nodes);
      return emit(RayOfDistance<Q>{RayRadius<Q>(d.between(200, 2000))});
    }
    ray(nodes);
    const Q cut = ray_cut<Q>(kAlongProfile.facts), length = d.between(200, 1500);
    switch (which) {
      case 1: return emit(ScaleAlong<Q>(d.place(), d.direction(), length, cut), SharedTable::along);
      case 2: return emit(ScaleFromAxis<Q>(length, cut), SharedTable::along);
      case 3:
        return emit(ScaleAbout<Q>::axis(kAboutProfile.facts, length, d.one_in(2) ? Rate(0.75) : Rate{}), SharedTable::about);
      default: return emit(ScaleAbout<Q>::circle(kAboutProfile.facts, length, d.between(0, 700)), SharedTable::about);
    }
  }
  void ray_blend() {
    Draw& d = draw_;
    static constexpr RaySides<Q> sides[] = {RaySides<Q>::of(kRoundUnion), RaySides<Q>::of(kScaleUnion),
                                            RaySides<Q>::of(kRoundIntersection), RaySides<Q>::of(kScaleIntersection)};
    const uint32_t profile = d.below(2);
    const SharedTable of_union = profile == 0 ? SharedTable::round_union : SharedTable::scale_union;
    const SharedTable of_intersection = profile == 0 ? SharedTable::round_intersection : SharedTable::scale_intersection;
    switch (d.below(7)) {
      case 0: return emit(RayUnion<Q>{});
      case 1: return emit(RayIntersection<Q>{});
      case 2: return emit(RayMorph<Q>{parameter()});
      case 3: return emit(VariableInfluence<Q>(d.between(200, 1000)));
      case 4: {
        RayLinearUnion<Q> blend;
        blend.sides = sides[profile];
        return emit(blend, of_union);
      }
      case 5: {
        RayLinearIntersection<Q> blend;
        blend.sides = sides[2 + profile];
        return emit(blend, of_intersection);
      }
      default: {
        RayLinearDifference<Q> blend;
        blend.sides = sides[2 + profile];
        blend.complement = {Q(1.0), Q(0.25)};
        return emit(blend, of_intersection);
      }
    }
  }

  // Algebraic values.
  void algebraic(uint32_t nodes) {
    if (nodes == 1) return algebraic_leaf();
    if (may_enter()) return framed(Kind::algebraic, [&] { algebraic(nodes - 1); });
    if (nodes == 2 || draw_.one_in(5)) return algebraic_of_others(nodes - 1);
    if (nodes >= 5 && draw_.one_in(3)) return patch(nodes - 1);
    if (draw_.one_in(5)) return spline(nodes - 1);
    const uint32_t first = share_of(nodes);
    algebraic(first);
    algebraic(nodes - 1 - first);
    algebraic_blend();
  }
  void algebraic_leaf() {
    Draw& d = draw_;
    switch (d.below(3)) {
      case 0: return emit(AlgebraicPlane<Q>{d.lengths(-900, 900), d.between(-300, 300)});
      case 1: return emit(Quadric<Q>{d.lengths(-500, 500), d.lengths(-500, 500), d.lengths(-500, 500), d.between(-500, 500)});
      default: return emit(AlgebraicTorus<Q>(d.place(), d.between(300, 700), d.between(50, 300), d.between(500, 2000)));
    }
  }
  void algebraic_of_others(uint32_t nodes) {
    if (draw_.one_in(2)) {
      distance(nodes);
      return emit(AlgebraicOfDistance<Q>{draw_.between(200, 1500)});
    }
    ray(nodes);
    emit(AlgebraicOfRay<Q>{Q(0.5), draw_.between(200, 1500)});
  }
  void algebraic_blend() {
    Draw& d = draw_;
    const Q range = d.between(200, 1000), conic = d.between(-1000, 875);
    switch (d.below(5)) {
      case 0: return emit(AlgebraicUnion<Q>{});
      case 1: return emit(AlgebraicIntersection<Q>{});
      case 2: return emit(HoffmannHopcroftUnion<Q>::of(range, Q(1.0), conic));
      case 3: return emit(HoffmannHopcroftIntersection<Q>::of(range, Q(1.0), conic));
      default: return emit(HoffmannHopcroftDifference<Q>::of(range, Q(1.0), conic));
    }
  }
  void spline(uint32_t nodes) {
    const uint32_t count = draw_.within(2, least_of_two<uint32_t>(nodes, 8)), primaries = draw_.within(1, count - 1);
    operands(count, nodes, [&](uint32_t of_operand) { algebraic(of_operand); });
    emit(FunctionalSpline<Q>{primaries, count - primaries, draw_.within(1, 4), draw_.between(100, 500)});
  }
  void patch(uint32_t nodes) {
    const uint32_t sides = draw_.within(2, least_of_two<uint32_t>(nodes / 2, 8));
    operands(2 * sides, nodes, [&](uint32_t of_operand) { algebraic(of_operand); });
    if (sides == 2 || draw_.one_in(2)) return emit_patch(RibbonPatch<Q>(), sides);
    emit_patch(CornerPatch<Q>(), sides);
  }
  template <class Patch> void emit_patch(Patch patch, uint32_t sides) {
    patch.side_count = sides;
    patch.exponent = draw_.within(2, 3);
    for (uint32_t i = 0; i < sides; ++i) patch.side_weight[i] = draw_.between(-1000, 1500);
    patch.centre_weight = draw_.between(-500, 500);
    emit(patch);
  }

  Draw draw_{0};
  bool final_ = false;
  uint32_t nodes_ = 0, frames_ = 0, poses_ = 0, parameters_ = 0;
  uint32_t used_tables_ = 0;
  uint32_t reference_[static_cast<uint32_t>(SharedTable::count)] = {};
  Inspection<Q> inspection_;
};

}  // namespace nearfield::costs
