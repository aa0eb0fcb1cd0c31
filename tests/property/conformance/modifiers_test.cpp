/// Frames, conversions, and what changes with a parameter: on fields of one shape, of each kind that they take.

#include "property/conformance/modified_fields.hpp"

namespace nearfield::property {
namespace {

template <class S>
inline const Table<S, 32> wyvill_over_r = bake<S, 32>(over_range(potential::wyvill));

/// Two fields, and what a modifier takes besides. Numbers that every scalar holds.
template <class Field>
struct Modified {
  Field field, other;
  Real number = 1, parameter = 0;
  reference::Pose pose;
};

template <class Modifier, class Field, class Scalar>
struct ModifierRow : Modifier {
  static constexpr bool exact_solid = false;
  static constexpr Real direction_tolerance = gradient_tolerance<Scalar>(4, 1e-5L);
  using Operations = typename Modifier::template Operations<Field::operation>;
  using Parameters = Modified<Field>;
  static Parameters draw(Random& random, Real greatest) {
    const Real size = Modifier::room * greatest;
    Parameters p;
    p.field = Field::draw(random, size);
    p.other = Field::draw(random, size);
    p.number = even(random.uniform(0.2L, 1) * size);
    p.parameter = random.chance(0.3L) ? static_cast<Real>(random.integer(0, 1)) : even(random.uniform(0, 0.999L));
    p.pose = random.pose(size);
    return p;
  }
  static std::vector<Parameters> degenerate(Real size) {
    Field field{};
    skeleton_of(field).radius = size;
    Parameters p;
    p.field = p.other = field;
    p.pose.rotation = reference::rotation_from_quaternion(1, 0, 0, 0);
    Parameters end = p;
    end.parameter = 1;
    return {p, end};
  }
  static std::vector<Vec3> places(const Parameters& p) {
    std::vector<Vec3> all{{}};
    for (const Field* field : {&p.field, &p.other}) {
      const Skeleton& skeleton = skeleton_of(*field);
      const Vec3 end = skeleton.from + skeleton.length * skeleton.axis;
      for (const Vec3& at : {skeleton.from, end, end + Vec3{skeleton.radius, 0, 0}}) all.push_back(Modifier::outside(p, at));
    }
    return all;
  }
  template <class S>
  static void tables(golden::NodeWriter<S, 4096, Operations>& writer) {
    if constexpr (is_soft<Field>) writer.table(wyvill_table<S>);
    if constexpr (Modifier::samples_potential) writer.table(wyvill_over_r<S>);
  }
  template <class S>
  static auto node(const Parameters& p) {
    return Modifier::template of<S>(p, p.field.template node<S>());
  }
  template <class S>
  static conformance::Given<S> given(const Parameters& p) {
    return {rounded_pose<S>(p.pose), rounded<S>(p.parameter)};
  }
};

struct Unmoved {
  static constexpr Real room = 1;
  static constexpr bool samples_potential = false;
  template <class Field>
  static Vec3 outside(const Modified<Field>&, const Vec3& at) {
    return at;
  }
};

struct Posed {
  static constexpr const char* name = "enter_pose";
  static constexpr Real room = 1;
  static constexpr bool samples_potential = false;
  template <Operation operand>
  using Operations = OnlyOperations<operand>;
  template <class Field>
  static Vec3 outside(const Modified<Field>& p, const Vec3& at) {
    return reference::to_world(p.pose, at);
  }
  template <class S, class Field, class Node>
  static auto of(const Modified<Field>& p, const Node& node) {
    return place(rounded_pose<S>(p.pose), node);
  }
  template <class Field>
  static Real value(const Modified<Field>& p, const Vec3& at) {
    return p.field.value(reference::to_local(p.pose, at));
  }
};
/// The pose may be anywhere in the domain, so there is less room.
struct InASlot : Posed {
  static constexpr Real room = 0.8L;
  static constexpr const char* name = "enter_slot";
  template <class S, class Field, class Node>
  static auto of(const Modified<Field>&, const Node& node) {
    return in_slot(0, node);
  }
};

template <template <class> class Potential, Operation operation>
struct PotentialOfField : Unmoved {
  static constexpr const char* name = operation == Operation::potential_of_ray ? "potential_of_ray" : "potential_of_distance";
  static constexpr bool samples_potential = true;
  template <Operation operand>
  using Operations = OnlyOperations<operand, operation>;
  template <class Field>
  static Real limit(const Modified<Field>& p) {
    return operation == Operation::potential_of_ray ? 1 : p.number;
  }
  template <class S, class Field, class Node>
  static auto of(const Modified<Field>& p, const Node& node) {
    const Certificate<S> certificate = node.certificate(domain_reach<S>());
    return combine(Potential<S>(rounded<S>(limit(p)), rounded<S>(1), certificate), wyvill_over_r<S>, node);
  }
  template <class Field>
  static Real value(const Modified<Field>& p, const Vec3& at) {
    return wyvill(p.field.value(at) / limit(p));
  }
};

struct AlgebraicOf : Unmoved {
  static constexpr const char* name = "algebraic_of_ray";
  template <Operation operand>
  using Operations = OnlyOperations<operand, Operation::algebraic_of_ray>;
  template <class S, class Field, class Node>
  static auto of(const Modified<Field>&, const Node& node) {
    return combine(AlgebraicOfRay<S>{rounded<S>(0.5L), rounded<S>(0.25L)}, node);
  }
  template <class Field>
  static Real value(const Modified<Field>& p, const Vec3& at) {
    return (p.field.value(at) - 0.5L) / 4;
  }
};

template <template <class> class MorphOfKind, Operation operation>
struct Morphing : Unmoved {
  static constexpr bool unit_directions = false;
  static constexpr const char* name = operation == Operation::morph              ? "morph"
                                      : operation == Operation::intensity_morph ? "intensity_morph"
                                                                                : "ray_morph";
  template <Operation operand>
  using Operations = OnlyOperations<operand, operation>;
  template <class S, class Field, class Node>
  static auto of(const Modified<Field>& p, const Node& node) {
    return combine(MorphOfKind<S>{0}, node, p.other.template node<S>());
  }
  template <class Field>
  static Real value(const Modified<Field>& p, const Vec3& at) {
    return (1 - p.parameter) * p.field.value(at) + p.parameter * p.other.value(at);
  }
};

struct Swelling : Unmoved {
  static constexpr const char* name = "swell";
  template <Operation operand>
  using Operations = OnlyOperations<operand, Operation::swell>;
  template <class S, class Field, class Node>
  static auto of(const Modified<Field>& p, const Node& node) {
    return combine(Swell<S>{rounded<S>(p.number), 0}, node);
  }
  template <class Field>
  static Real value(const Modified<Field>& p, const Vec3& at) {
    return p.field.value(at) - p.parameter * p.number;
  }
};

struct Fading : Unmoved {
  static constexpr const char* name = "fade";
  template <Operation operand>
  using Operations = OnlyOperations<operand, Operation::fade>;
  template <class S, class Field, class Node>
  static auto of(const Modified<Field>&, const Node& node) {
    return combine(Fade<S>{0}, node);
  }
  template <class Field>
  static Real value(const Modified<Field>& p, const Vec3& at) {
    return p.parameter * p.field.value(at);
  }
};

template <class Modifier, class Field>
struct RowOf {
  template <class Scalar>
  using Row = ModifierRow<Modifier, Field, Scalar>;
};

TEST(ModifierConformance, PosedDistance) { judge_rows<RowOf<Posed, Stick>::Row>(820); }
TEST(ModifierConformance, PosedRay) { judge_rows<RowOf<Posed, Ray>::Row>(821); }
TEST(ModifierConformance, DistanceInASlot) { judge_rows<RowOf<InASlot, Stick>::Row>(822); }
TEST(ModifierConformance, PotentialOfDistance) {
  judge_rows<RowOf<PotentialOfField<PotentialOfDistance, Operation::potential_of_distance>, Stick>::Row>(823);
}
TEST(ModifierConformance, PotentialOfRay) {
  judge_rows<RowOf<PotentialOfField<PotentialOfRay, Operation::potential_of_ray>, Ray>::Row>(824);
}
TEST(ModifierConformance, AlgebraicOfRay) { judge_rows<RowOf<AlgebraicOf, Ray>::Row>(825); }
TEST(ModifierConformance, Morph) { judge_rows<RowOf<Morphing<Morph, Operation::morph>, Stick>::Row>(826); }
TEST(ModifierConformance, IntensityMorph) {
  judge_rows<RowOf<Morphing<IntensityMorph, Operation::intensity_morph>, SoftBall>::Row>(827);
}
TEST(ModifierConformance, RayMorph) { judge_rows<RowOf<Morphing<RayMorph, Operation::ray_morph>, Ray>::Row>(828); }
TEST(ModifierConformance, Swell) { judge_rows<RowOf<Swelling, Stick>::Row>(829); }
TEST(ModifierConformance, Fade) { judge_rows<RowOf<Fading, SoftRod>::Row>(830); }

}  // namespace
}  // namespace nearfield::property
