/// Fields of each kind at another size, and soft skeletons at their own.

#include <nearfield/curve/potential.hpp>
#include <nearfield/curve/tabulated_form.hpp>

#include "property/conformance/skeletons.hpp"
#include "reference/shapes.hpp"

namespace nearfield::property {
namespace {

/// Fields as they are before they are scaled.
struct Stick {
  static constexpr Operation operation = Operation::capsule;
  Skeleton skeleton;
  static Stick draw(Random& random, Real size) { return {draw_skeleton(random, size)}; }
  template <class S>
  auto node() const {
    return skeleton.template capsule<S>(skeleton.radius);
  }
  Real value(const Vec3& p) const {
    return reference::point_segment_distance(p, {skeleton.from, skeleton.from + skeleton.length * skeleton.axis}) -
           skeleton.radius;
  }
  Real outside(Real value, Real factor) const { return factor * value; }
};

struct Ray {
  static constexpr Operation operation = Operation::ray_segment;
  Skeleton skeleton;
  static Ray draw(Random& random, Real size) { return {draw_skeleton(random, size)}; }
  template <class S>
  auto node() const {
    return skeleton.template ray<S>();
  }
  Real value(const Vec3& p) const { return skeleton.cut_off(p, kGreatestRay); }
  Real outside(Real value, Real) const { return value; }
};

struct Plane {
  static constexpr Operation operation = Operation::algebraic_plane;
  Skeleton skeleton;
  static Plane draw(Random& random, Real size) { return {draw_skeleton(random, size)}; }
  template <class S>
  auto node() const {
    return AlgebraicPlane<S>{rounded<S>(0.5L * skeleton.axis), rounded<S>(skeleton.radius)};
  }
  Real value(const Vec3& p) const { return dot(0.5L * skeleton.axis, p) - skeleton.radius; }
  Real outside(Real value, Real) const { return value; }
};

template <class S>
const Table<S, 2> wyvill_table = bake<S, 2>(over_square(potential::wyvill));

struct SoftRod {
  static constexpr Operation operation = Operation::soft_segment;
  Skeleton skeleton;
  static SoftRod draw(Random& random, Real size) { return {draw_skeleton(random, size)}; }
  template <class S>
  auto node() const {
    return with_potential(SoftSegment<S>{skeleton.template capsule<S>(0), Influence<S>(rounded<S>(skeleton.radius), rounded<S>(1))},
                          wyvill_table<S>);
  }
  Real value(const Vec3& p) const {
    const Real r = skeleton.cut_off(p, 1), u = r * r;
    return 1 - 22 * u / 9 + 17 * u * u / 9 - 4 * u * u * u / 9;
  }
  Real outside(Real value, Real) const { return value; }
};

struct SoftBall {
  static constexpr Operation operation = Operation::soft_point;
  SoftRod rod;
  static SoftBall draw(Random& random, Real size) {
    SoftRod rod = SoftRod::draw(random, size);
    rod.skeleton.length = 0;
    return {rod};
  }
  template <class S>
  auto node() const {
    return with_potential(
        SoftPoint<S>{rounded<S>(rod.skeleton.from), Influence<S>(rounded<S>(rod.skeleton.radius), rounded<S>(1))},
        wyvill_table<S>);
  }
  Real value(const Vec3& p) const { return rod.value(p); }
  Real outside(Real value, Real) const { return value; }
};

Skeleton& skeleton_of(SoftBall& ball) { return ball.rod.skeleton; }
const Skeleton& skeleton_of(const SoftBall& ball) { return ball.rod.skeleton; }
template <class Field>
Skeleton& skeleton_of(Field& field) {
  return field.skeleton;
}
template <class Field>
const Skeleton& skeleton_of(const Field& field) {
  return field.skeleton;
}

template <class Field>
constexpr bool is_soft = Field::operation == Operation::soft_segment || Field::operation == Operation::soft_point;

/// Factors from 1/2 up: what is smaller inside must fit the number range there.
template <class Field, bool is_scaled, class Scalar>
struct SizeRow {
  static constexpr const char* name = "uniform_scale";
  static constexpr bool exact_solid = false;
  static constexpr Real direction_tolerance = gradient_tolerance<Scalar>(2, 1e-6L);
  using Operations = OnlyOperations<Field::operation>;
  struct Parameters {
    Field field;
    Real factor = 1;
  };
  static Parameters draw(Random& random, Real size) {
    const Real factor = random.chance(0.2L) ? std::ldexp(Real{1}, static_cast<int>(random.integer(-1, 3)))
                                            : std::exp2(random.uniform(-1, 3));
    return {Field::draw(random, size), is_scaled ? factor : 1};
  }
  static std::vector<Parameters> degenerate(Real size) {
    std::vector<Parameters> all;
    for (const Real factor : {0.5L, 1.0L, 3.0L, 8.0L}) {
      Field field{};
      skeleton_of(field).radius = size;
      all.push_back({field, is_scaled ? factor : 1});
    }
    return all;
  }
  static std::vector<Vec3> places(const Parameters& p) {
    const Skeleton& skeleton = skeleton_of(p.field);
    const Vec3 end = skeleton.from + skeleton.length * skeleton.axis;
    return {{}, p.factor * skeleton.from, p.factor * end, p.factor * (end + Vec3{skeleton.radius, 0, 0})};
  }
  template <class S>
  static void tables(golden::NodeWriter<S, 4096, Operations>& writer) {
    if constexpr (is_soft<Field>) writer.table(wyvill_table<S>);
  }
  template <class S>
  static auto node(const Parameters& p) {
    if constexpr (is_scaled) return scaled(rounded<S>(p.factor), p.field.template node<S>());
    else return p.field.template node<S>();
  }
  static Real value(const Parameters& p, const Vec3& at) {
    return p.field.outside(p.field.value((1 / p.factor) * at), p.factor);
  }
};

template <class Scalar>
struct ScaledDistance : SizeRow<Stick, true, Scalar> {};
template <class Scalar>
struct ScaledRay : SizeRow<Ray, true, Scalar> {};
template <class Scalar>
struct ScaledAlgebraic : SizeRow<Plane, true, Scalar> {};
template <class Scalar>
struct ScaledIntensity : SizeRow<SoftRod, true, Scalar> {};
template <class Scalar>
struct SoftSegmentRow : SizeRow<SoftRod, false, Scalar> {
  static constexpr const char* name = "soft_segment";
};
template <class Scalar>
struct SoftPointRow : SizeRow<SoftBall, false, Scalar> {
  static constexpr const char* name = "soft_point";
};

TEST(ScaleConformance, OfDistances) { judge_rows<ScaledDistance>(790); }
TEST(ScaleConformance, OfRays) { judge_rows<ScaledRay>(791); }
TEST(ScaleConformance, OfAlgebraicFields) { judge_rows<ScaledAlgebraic>(792); }
TEST(ScaleConformance, OfIntensities) { judge_rows<ScaledIntensity>(793); }
TEST(SoftConformance, SoftSegment) { judge_rows<SoftSegmentRow>(794); }
TEST(SoftConformance, SoftPoint) { judge_rows<SoftPointRow>(795); }

}  // namespace
}  // namespace nearfield::property
