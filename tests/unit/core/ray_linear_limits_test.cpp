// Ray-linear blends: smoothness, certified rates, what is refused, programs.
#include <golden/node_writer.hpp>
#include <nearfield/field/program.hpp>
#include <unit/core/ray_linear_samples.hpp>

namespace nearfield::ray_linear_tests {
namespace {

template <class S>
class RayLinearLimits : public testing::Test {};
TYPED_TEST_SUITE(RayLinearLimits, Scalars, );

class RayLinearLimitsByScalar : public ByScalar {};
INSTANTIATE_TEST_SUITE_P(, RayLinearLimitsByScalar, all_scalars(), scalar_name);

// From one ratio to the next in steps of the last place, value and derivatives go on without a jump: across
// the edges of the region, across equal operands, across knots.
void expect_smooth(const Subject& subject, Real ratio) {
  const Real step = subject.last_place > 0 ? subject.last_place : 2e-7L, x = subject.rounded(1.25L);
  const Real steepness = std::max<Real>(subject.spread, 1);
  for (const bool swapped : {false, true}) {
    BlendPoint before{};
    for (int i = -3; i <= 3; ++i) {
      const Real y = subject.rounded(x * ratio) + static_cast<Real>(i) * step;
      const BlendPoint here = swapped ? subject.evaluated(y, x) : subject.evaluated(x, y);
      if (i > -3) {
        // The sharpest blends turn from one operand to the other within a 500th of them.
        const Real bend = 500 * step + subject.slope_error;
        EXPECT_LE(std::fabs(here.value - before.value), steepness * step + 3 * step + 1e-8L)
            << subject.name << " at " << ratio;
        EXPECT_LE(std::fabs(here.by_x - before.by_x), bend) << subject.name << " at " << ratio;
        EXPECT_LE(std::fabs(here.by_y - before.by_y), bend) << subject.name << " at " << ratio;
      }
      before = here;
    }
  }
}

TEST_P(RayLinearLimitsByScalar, AreSmoothAcrossEdgesTiesAndKnots) {
  for (const Subject& subject : all_subjects(GetParam())) {
    expect_smooth(subject, 1);
    for (const Real edge : subject.edges) {
      if (edge <= 0) continue;
      expect_smooth(subject, edge);
      for (int knot = 1; knot < 64; knot += 7)
        expect_smooth(subject, 1 - (1 - edge) * static_cast<Real>(knot) / 64);
    }
  }
}

// Sums of absolute derivatives, and changes between two places, stay within the certified rate.
TEST_P(RayLinearLimitsByScalar, NeverChangeFasterThanCertified) {
  Random random(announced_seed("RayLinearLimits.NeverChangeFasterThanCertified", 325));
  Real loosest = 1;
  std::string which;
  for (const Subject& subject : all_subjects(GetParam())) {
    Real steepest = 0;
    for (int i = 0; i < 150; ++i) {
      const Operands a = random_operands(subject, random);
      const BlendPoint here = subject.evaluated(a.x, a.y);
      const Real sum = std::fabs(here.by_x) + std::fabs(here.by_y);
      const Real allowed = subject.spread + 8 * (subject.last_place > 0 ? subject.last_place : 2e-7L);
      EXPECT_LE(sum, allowed) << subject.name << " of " << a.x << " and " << a.y;
      steepest = std::max(steepest, sum / subject.spread);
      const Operands b = {subject.rounded(a.x * random.uniform(0.7L, 1.3L)),
                          subject.rounded(a.y * random.uniform(0.7L, 1.3L))};
      const Real change = std::fabs(subject.evaluated(b.x, b.y).value - here.value);
      EXPECT_LE(change, subject.spread * std::max(std::fabs(a.x - b.x), std::fabs(a.y - b.y)) +
                            2 * subject.certified_error)
          << subject.name;
    }
    if (steepest < loosest) {
      loosest = steepest;
      which = subject.name;
    }
  }
  std::printf("the loosest rate, of %s: %.3Lf of it attained\n", which.c_str(), loosest);
  EXPECT_GT(loosest, 0.4L);
}

TEST_P(RayLinearLimitsByScalar, OperandsOutOfRangeAreConstants) {
  for (const Subject& subject : all_subjects(GetParam())) {
    const BlendPoint below = subject.evaluated(-2, 1), at_zero = subject.evaluated(0, 1);
    EXPECT_EQ(below.value, at_zero.value) << subject.name;
    EXPECT_EQ(below.by_x, 0) << subject.name;
    const BlendPoint above = subject.evaluated(15.5L, 1), at_limit = subject.evaluated(15, 1);
    EXPECT_EQ(above.value, at_limit.value) << subject.name;
    EXPECT_EQ(above.by_x, 0) << subject.name;
    EXPECT_LE(subject.evaluated(15, 15).value, 15) << subject.name;
    EXPECT_GE(subject.evaluated(15, 15).value, 7) << subject.name;
  }
  const Subject sum = norms(GetParam(), SetOperation::intersect)[0];
  EXPECT_EQ(sum.evaluated(10, 10).value, 15);
  EXPECT_EQ(sum.evaluated(10, 10).by_x, 0);
}

template <class S>
Certificate<S> operand_certificate(double lipschitz) {
  Certificate<S> certificate;
  certificate.valid = true;
  certificate.lipschitz = Rate(lipschitz);
  return certificate;
}

TYPED_TEST(RayLinearLimits, RefuseWhatTheyCannotAnswerFor) {
  using S = TypeParam;
  const profile::SuperEllipsoid exact = profile::super_ellipsoidal_intersection(2);
  const Table<S, 64> table = bake<S, 64>(AnyProfile::of(exact));
  const auto certificate = [&table](const auto& blend, double lipschitz) {
    const Certificate<S> of[2] = {operand_certificate<S>(lipschitz), operand_certificate<S>(lipschitz)};
    return blend.certificate(of, table.facts, domain_reach<S>());
  };
  using Factor = typename RaySides<S>::Factor;
  const RaySides<S> sides = RaySides<S>::of(exact);
  EXPECT_TRUE(certificate(RayLinearIntersection<S>{{sides}}, 4).valid);
  EXPECT_FALSE(certificate(RayLinearIntersection<S>{{sides}}, 100).valid);  // 1.7 times as steep
  EXPECT_FALSE(certificate(RayLinearIntersection<S>{}, 1).valid);
  RaySides<S> forged = sides;
  forged.first = Factor(static_cast<Factor>(0.5));
  EXPECT_FALSE(certificate(RayLinearIntersection<S>{{forged}}, 1).valid);
  forged = sides;
  forged.second = Factor(static_cast<Factor>(65));
  EXPECT_FALSE(certificate(RayLinearIntersection<S>{{forged}}, 1).valid);
  forged = sides;
  forged.differ = 2;
  EXPECT_FALSE(certificate(RayLinearIntersection<S>{{forged}}, 1).valid);

  const auto difference = [&](Real surface_square, Real least, double lipschitz) {
    return certificate(RayLinearDifference<S>{{sides, {scalar<S>(surface_square), scalar<S>(least)}}},
                       lipschitz)
        .valid;
  };
  // 16 * 1.7 times as steep: less than 127, and less than 15 where gradients end at 16.
  const double part = fraction_bits_of<S> == 27 ? 0.125 : 1.0;
  EXPECT_TRUE(difference(1, 0.25L, 4 * part));
  EXPECT_TRUE(difference(0.25L, 0.125L, 4 * part));
  EXPECT_FALSE(difference(1, 0.25L, 5 * part));
  EXPECT_FALSE(difference(1, 0.125L, 0.5));  // up to 16
  EXPECT_FALSE(difference(1, 0, 0.5));
  EXPECT_FALSE(difference(1, -0.25L, 0.5));
  EXPECT_FALSE(difference(1, 1.5L, 0.5));
  EXPECT_FALSE(difference(0, 0.25L, 0.5));
}

TEST(RayProfiles, RefuseParametersWithoutABlend) {
  EXPECT_EQ(profile::super_ellipsoidal_union(1).problem(), nullptr);
  EXPECT_NE(profile::super_ellipsoidal_union(0.99).problem(), nullptr);
  EXPECT_NE(profile::super_ellipsoidal_intersection(65).problem(), nullptr);
  EXPECT_NE(profile::super_ellipsoidal_intersection(std::nan("")).problem(), nullptr);
  EXPECT_EQ(profile::scale_union(4, 0.02, 0).problem(), nullptr);
  EXPECT_NE(profile::scale_union(0.01, 0.5, 0).problem(), nullptr);
  EXPECT_NE(profile::scale_union(0.5, 4.1, 0).problem(), nullptr);
  EXPECT_EQ(profile::scale_intersection(1, 1, 0).problem(), nullptr);
  EXPECT_NE(profile::scale_intersection(1.01, 0.5, 0).problem(), nullptr);
  EXPECT_EQ(profile::scale_intersection(0.5, 0.5, 0.2475).problem(), nullptr);
  EXPECT_NE(profile::scale_intersection(0.5, 0.5, 0.25).problem(), nullptr);
  EXPECT_NE(profile::scale_union(0.5, 0.5, -501).problem(), nullptr);
  EXPECT_NE(profile::scale_union(0.5, 0.5, std::nan("")).problem(), nullptr);
}

// At the ends of the allowed parameters a table of 256 segments still exists, says how good it is, and is
// accepted.
TEST(RayProfiles, HaveTablesUpToTheEndsOfTheirParameters) {
  using S = Fixed<27>;
  Real worst = 0, widest = 0;
  const Certificate<S> of[2] = {operand_certificate<S>(1), operand_certificate<S>(1)};
  for (const bool is_union : {true, false}) {
    const double greatest = is_union ? 4.0 : 1.0;
    for (const double r1 : {0.02, greatest}) {
      for (const double r2 : {0.02, greatest}) {
        for (const double p : {-2000 * r1 * r2, 0.0, 0.99 * r1 * r2}) {
          const profile::ScaleBlend exact =
              is_union ? profile::scale_union(r1, r2, p) : profile::scale_intersection(r1, r2, p);
          EXPECT_EQ(exact.problem(), nullptr);
          const Table<S, 256> table = bake<S, 256>(AnyProfile::of(exact));
          const RaySides<S> sides = RaySides<S>::of(exact);
          const Certificate<S> certificate =
              is_union ? RayLinearUnion<S>{{sides}}.certificate(of, table.facts, {})
                       : RayLinearIntersection<S>{{sides}}.certificate(of, table.facts, {});
          EXPECT_TRUE(certificate.valid) << is_union << " " << r1 << " " << r2 << " " << p;
          worst = std::max(worst, std::ldexp(static_cast<Real>(table.facts.error), -30));
          widest = std::max(widest, static_cast<Real>(certificate.lipschitz.to_double()));
        }
      }
    }
  }
  std::printf("greatest error of 256 segments %.2Le, greatest rate %.3Lf\n", worst, widest);
  EXPECT_LT(worst, 1e-3L);
}

using RayOperations = OnlyOperations<Operation::ray_point, Operation::ray_linear_union,
                                     Operation::ray_linear_intersection, Operation::ray_linear_difference>;

// Static composition and program: the same bits.
TYPED_TEST(RayLinearLimits, AreTheSameInPrograms) {
  using S = TypeParam;
  Random random(announced_seed("RayLinearLimits.AreTheSameInPrograms", 329));
  const auto norm = profile::super_ellipsoidal_intersection(2.5);
  const auto crease = profile::scale_union(0.6, 0.25, -0.1);
  const Table<S, 64> norm_table = bake<S, 64>(AnyProfile::of(norm)),
                     crease_table = bake<S, 64>(AnyProfile::of(crease));
  const RayRadius<S> influence(scalar<S>(0.5L));
  const auto point = [&] {
    return RayPoint<S>{{scalar<S>(random.uniform(-1, 1)), scalar<S>(random.uniform(-1, 1)), {}}, influence};
  };
  const auto joined = combine(RayLinearUnion<S>{{RaySides<S>::of(crease)}}, crease_table, point(), point());
  const auto common = combine(RayLinearIntersection<S>{{RaySides<S>::of(norm)}}, norm_table, joined, point());
  const RayLinearDifference<S> difference{{RaySides<S>::of(norm), {scalar<S>(1), scalar<S>(0.25L)}}};
  const auto whole = field(combine(difference, norm_table, common, point()));
  const auto node = combine(difference, norm_table, common, point());
  const auto composed = field(node);
  EXPECT_TRUE(whole.valid());

  golden::NodeWriter<S, 1000, RayOperations> writer;
  writer.table(norm_table);
  writer.table(crease_table);
  writer.write(node);
  ASSERT_EQ(writer.builder().finish().status, LoadStatus::ok);
  const Program<S, RayOperations> program =
      load<S, RayOperations>(writer.builder().words(), writer.builder().size() * 4u);
  ASSERT_TRUE(program.valid());
  EXPECT_EQ(program.kind(), Kind::ray);
  EXPECT_EQ(program.certificate().lipschitz, composed.certificate().lipschitz);
  EXPECT_EQ(ScalarTraits<S>::word(program.certificate().error),
            ScalarTraits<S>::word(composed.certificate().error));
  int blended = 0;
  for (int i = 0; i < 300; ++i) {
    const Vector3<S> p{scalar<S>(random.uniform(-2, 2)), scalar<S>(random.uniform(-2, 2)),
                       scalar<S>(random.uniform(-1, 1))};
    const auto here = composed.template evaluate<Sample<S>>(p, nullptr);
    const auto there = program.template evaluate<Sample<S>>(p, nullptr);
    EXPECT_EQ(ScalarTraits<S>::word(here.value), ScalarTraits<S>::word(there.value));
    EXPECT_TRUE(here.gradient == there.gradient);
    blended += here.value < greatest_ray<S>() ? 1 : 0;
  }
  EXPECT_GT(blended, 250);
}

}  // namespace
}  // namespace nearfield::ray_linear_tests
