/// Fields of each kind at another size, and soft skeletons at their own.

#include "property/conformance/modified_fields.hpp"

namespace nearfield::property {
namespace {

/// Factors from 1/2 up: what is smaller inside must fit the number range there.
template <class Field, bool is_scaled, class Scalar>
struct SizeRow {
  static constexpr const char* name = "uniform_scale";
  static constexpr bool exact_solid = false;
  static constexpr Real direction_tolerance = gradient_tolerance<Scalar>(2, 1e-6L);
  using Operations = OnlyOperations<Field::operation, Operation::enter_scale>;
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
