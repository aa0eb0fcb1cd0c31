// Ray-linear blends against the papers' formulas in long double.
#include <unit/core/ray_linear_samples.hpp>

namespace nearfield::ray_linear_tests {
namespace {

template <class S>
class RayLinearBlends : public testing::Test {};
TYPED_TEST_SUITE(RayLinearBlends, Scalars, );

class RayLinearBlendsByScalar : public ByScalar {};
INSTANTIATE_TEST_SUITE_P(, RayLinearBlendsByScalar, all_scalars(), scalar_name);

// Exactly on the edges of the region and on the tie, and units in the last place beside them.
void expect_equal_on_edges(const Subject& subject, Random& random, Worst& worst) {
  const Real step = subject.last_place > 0 ? subject.last_place : 2e-7L;
  for (const Real edge : {subject.edges[0], subject.edges[1], Real{1}}) {
    if (edge <= 0) continue;
    for (const Real size : {Real{1}, std::exp(random.uniform(-2, 2))}) {
      const Real x = subject.rounded(size), y = subject.rounded(x * edge);
      for (const int units : {-40, -2, -1, 0, 1, 2, 40}) {
        const Real beside = subject.rounded(y + static_cast<Real>(units) * step * std::max<Real>(y, 1));
        expect_equal(subject, {x, beside}, worst);
        expect_equal(subject, {beside, x}, worst);
        if (testing::Test::HasFailure()) return;
      }
    }
  }
}

void expect_all_equal(const std::vector<Subject>& subjects, const char* test, uint64_t seed, int count) {
  Random random(announced_seed(test, seed));
  Worst worst, on_edges;
  for (const Subject& subject : subjects) {
    for (int i = 0; i < count && !testing::Test::HasFailure(); ++i)
      expect_equal(subject, random_operands(subject, random), worst);
    expect_equal_on_edges(subject, random, on_edges);
  }
  worst.report(test);
  on_edges.report("on edges and ties, units from them");
  EXPECT_GT(worst.of_certificate, 0.01L);
}

TEST_P(RayLinearBlendsByScalar, NormsEqualTheirFormulas) {
  expect_all_equal(norms(GetParam(), SetOperation::intersect), "RayLinearBlends.NormsEqualTheirFormulas", 321,
                   2000);
  expect_all_equal(norms(GetParam(), SetOperation::unite), "RayLinearBlends.NormsEqualTheirFormulas", 322,
                   2000);
}
TEST_P(RayLinearBlendsByScalar, ScaleUnionsEqualTheirFormula) {
  expect_all_equal(scale_blends(GetParam(), true), "RayLinearBlends.ScaleUnionsEqualTheirFormula", 323, 200);
}
TEST_P(RayLinearBlendsByScalar, ScaleIntersectionsEqualTheirFormula) {
  expect_all_equal(scale_blends(GetParam(), false), "RayLinearBlends.ScaleIntersectionsEqualTheirFormula",
                   324, 200);
}

// Tables round off what is infinitely steep where one operand is 0; away from there they are as exact as for
// any n.
TEST_P(RayLinearBlendsByScalar, NormsOfSmallExponentsAreExactAwayFromTheAxes) {
  Random random(announced_seed("RayLinearBlends.NormsOfSmallExponentsAreExactAwayFromTheAxes", 330));
  Real worst_value = 0, worst_slope = 0, least = 2;
  for (const SetOperation operation : {SetOperation::unite, SetOperation::intersect}) {
    for (const Subject& subject : norms(GetParam(), operation)) {
      if (subject.exponent >= 2) continue;
      least = std::min(least, subject.exponent > 1 ? subject.exponent : least);
      for (int i = 0; i < 300; ++i) {
        const Real x = subject.rounded(random.uniform(0.5L, 2)),
                   y = subject.rounded(x * random.uniform(0.125L, 1));
        for (const Operands& operands : {Operands{x, y}, Operands{y, x}}) {
          const BlendPoint found = subject.evaluated(operands.x, operands.y),
                           exact = subject.exact(operands.x, operands.y);
          const Real unit = subject.last_place > 0 ? subject.last_place : 2e-7L;
          const Real error = std::fabs(found.value - exact.value);
          const Real off = std::max(std::fabs(found.by_x - exact.by_x), std::fabs(found.by_y - exact.by_y));
          EXPECT_LE(error, 2e-7L + 4 * unit) << subject.name << " of " << operands.x << " and " << operands.y;
          EXPECT_LE(off, 2e-5L + 8 * unit) << subject.name << " of " << operands.x << " and " << operands.y;
          worst_value = std::max(worst_value, error);
          worst_slope = std::max(worst_slope, off);
        }
      }
    }
  }
  std::printf("n from %.6Lf to 2: greatest error %.2Le, of derivatives %.2Le\n", least, worst_value,
              worst_slope);
}

// Norms are associative: one after the other they are the norm of all.
TEST_P(RayLinearBlendsByScalar, NormsOfManyOperandsEqualTheirFormula) {
  Random random(announced_seed("RayLinearBlends.NormsOfManyOperandsEqualTheirFormula", 331));
  Worst worst;
  for (const SetOperation operation : {SetOperation::unite, SetOperation::intersect}) {
    for (const Subject& subject : norms(GetParam(), operation)) {
      for (int trial = 0; trial < 40; ++trial) {
        std::vector<Real> x(static_cast<size_t>(random.integer(3, 8)));
        for (Real& operand : x) operand = subject.rounded(random.uniform(0.2L, 1.8L));
        const auto exact = operation == SetOperation::unite
                               ? reference::super_ellipsoidal_union(subject.exponent, x)
                               : reference::super_ellipsoidal_intersection(subject.exponent, x);
        const reference::ManyBlendPoint found = reference::folded(subject.evaluated, x);
        const Real count = static_cast<Real>(x.size());
        // Each blend's error is of its own result, and the next ones do not enlarge it by more than their
        // rate.
        const Real value = count * subject.value_tolerance(2 * std::max(exact.value, x.back()));
        const Real slope = 2 * count * subject.slope_tolerance(2);
        ASSERT_LE(std::fabs(found.value - exact.value), value) << subject.name << " of " << x.size();
        worst.of_value = std::max(worst.of_value, std::fabs(found.value - exact.value) / value);
        for (size_t i = 0; i < x.size(); ++i) {
          const Real off = std::fabs(found.partials[i] - exact.partials[i]);
          ASSERT_LE(off, slope) << subject.name << " of " << x.size() << ", operand " << i;
          worst.of_slope = std::max(worst.of_slope, off / slope);
        }
      }
    }
  }
  worst.report("RayLinearBlends.NormsOfManyOperandsEqualTheirFormula");
}

TEST_P(RayLinearBlendsByScalar, GoThroughTheAxes) {
  for (const Subject& subject : norms(GetParam(), SetOperation::intersect)) {
    for (const Real x : {0.125L, 1.0L, 3.5L}) {
      EXPECT_LE(std::fabs(subject.evaluated(x, 0).value - x), subject.value_tolerance(x)) << subject.name;
      EXPECT_EQ(subject.evaluated(x, 0).value, subject.evaluated(0, x).value);
    }
    EXPECT_EQ(subject.evaluated(0, 0).value, 0);
  }
  for (const Subject& subject : norms(GetParam(), SetOperation::unite)) {
    EXPECT_LE(std::fabs(subject.evaluated(0.001L, 15).value - subject.rounded(0.001L)),
              15e-7L + 2 * subject.last_place)
        << subject.name;
    EXPECT_EQ(subject.evaluated(0, 1).value, 0);
    EXPECT_EQ(subject.evaluated(0, 0).value, 0);
    EXPECT_EQ(subject.evaluated(0, 0).by_x, subject.evaluated(1, 1).by_x);
  }
  for (const bool is_union : {true, false}) {
    for (const Subject& subject : scale_blends(GetParam(), is_union)) {
      EXPECT_EQ(subject.evaluated(1, 0).value, is_union ? 0 : 1) << subject.name;
      EXPECT_EQ(subject.evaluated(0, 1).value, is_union ? 0 : 1) << subject.name;
    }
  }
}

TEST_P(RayLinearBlendsByScalar, SymmetricOnesDoNotCareForTheOrder) {
  Random random(announced_seed("RayLinearBlends.SymmetricOnesDoNotCareForTheOrder", 326));
  for (const SetOperation operation : {SetOperation::unite, SetOperation::intersect}) {
    for (const Subject& subject : norms(GetParam(), operation)) {
      for (int i = 0; i < 200; ++i) {
        const auto [x, y] = random_operands(subject, random);
        const BlendPoint one = subject.evaluated(x, y), other = subject.evaluated(y, x);
        EXPECT_EQ(one.value, other.value) << subject.name;
        if (x == y) continue;
        EXPECT_EQ(one.by_x, other.by_y) << subject.name;
        EXPECT_EQ(one.by_y, other.by_x) << subject.name;
      }
    }
  }
}

TEST_P(RayLinearBlendsByScalar, SequencesEqualHsus) {
  Random random(announced_seed("RayLinearBlends.SequencesEqualHsus", 327));
  for (const bool is_union : {true, false}) {
    const std::vector<Subject> subjects = scale_blends(GetParam(), is_union);
    for (const Subject& subject : subjects) {
      const ScaleRanges& exact_ranges = subject.ranges;
      for (int trial = 0; trial < 30; ++trial) {
        std::vector<Real> x(4);
        for (Real& operand : x) operand = subject.rounded(random.uniform(0.7L, 1.3L));
        Real found = x[0];
        for (size_t k = 1; k < x.size(); ++k) found = subject.evaluated(found, x[k]).value;
        const Real exact = is_union ? reference::sequential_scale_union(exact_ranges, x).value
                                    : reference::sequential_scale_intersection(exact_ranges, x).value;
        EXPECT_LE(std::fabs(found - exact), 10 * subject.value_tolerance(2 * exact)) << subject.name;
      }
    }
  }
}

// Hsu's difference, with the surface at 1 and at 1/2, wherever the second operand is not deep inside its
// solid.
TYPED_TEST(RayLinearBlends, DifferencesEqualTheirFormula) {
  using S = TypeParam;
  Random random(announced_seed("RayLinearBlends.DifferencesEqualTheirFormula", 328));
  const NormTables<S>& all = NormTables<S>::instance();
  Worst worst;
  for (size_t i = 0; i < exponents().size(); ++i) {
    for (const Real surface : {1.0L, 0.5L}) {
      const Real least = surface / 4, n = exponents()[i];
      Subject subject;
      subject.name = "difference, n " + std::to_string(n);
      subject.exact = [n, surface, least](Real x, Real y) {
        // Below `least` the complement goes on along its tangent.
        const Real reached = std::max(y, least), beyond = reached - y;
        if (beyond == 0) {
          const auto point = reference::super_ellipsoidal_difference(n, {x, y}, surface);
          return BlendPoint{point.value, point.partials[0], point.partials[1]};
        }
        const Real slope = surface * surface / (reached * reached);
        const auto point =
            reference::super_ellipsoidal_intersection(n, {x, slope * reached + slope * beyond});
        return BlendPoint{point.value, point.partials[0], -slope * point.partials[1]};
      };
      RayLinearDifference<S> blend{
          {RaySides<S>::of(all.profiles[i]), {scalar<S>(surface * surface), scalar<S>(least)}}};
      describe<S>(subject, blend, all.profiles[i].factors(), all.tables[i], 1.0L / 16);
      // Roundings of the complement.
      const Real unit = subject.last_place > 0 ? subject.last_place : 1e-6L;
      subject.value_error *= 4;
      subject.slope_error = subject.slope_error * 18 + 1e-7L;
      for (int trial = 0; trial < 500; ++trial) {
        const Operands operands{
            subject.rounded(random.uniform(0, 3)),
            subject.rounded(random.chance(0.3L) ? random.uniform(0, 0.3L) : random.uniform(0, 3))};
        const BlendPoint found = subject.evaluated(operands.x, operands.y),
                         exact = subject.exact(operands.x, operands.y);
        const std::string what =
            subject.name + " of " + std::to_string(operands.x) + " and " + std::to_string(operands.y);
        const Real error = std::fabs(found.value - exact.value),
                   off = std::max(std::fabs(found.by_x - exact.by_x), std::fabs(found.by_y - exact.by_y));
        const Real allowed = subject.value_tolerance(std::max<Real>(exact.value, 1)) + 8 * unit;
        EXPECT_LE(error, allowed) << what;
        worst.of_value = std::max(worst.of_value, error / allowed);
        EXPECT_LE(error, subject.certified_error) << what;
        worst.of_certificate = std::max(worst.of_certificate, error / subject.certified_error);
        // How the ratio of operands moves with the complement's roundings, and by how much that turns
        // derivatives.
        const Real turned = 200 * static_cast<Real>(n) * unit / std::max<Real>(exact.value, 0.1L);
        if (operands.x > 0.05L) {
          EXPECT_LE(off, subject.slope_tolerance(64) + turned) << what;
          worst.of_slope = std::max(worst.of_slope, off / (subject.slope_tolerance(64) + turned));
        }
        EXPECT_LE(std::fabs(found.by_x) + std::fabs(found.by_y), subject.spread + 100 * unit) << what;
      }
    }
  }
  worst.report("RayLinearBlends.DifferencesEqualTheirFormula");
}

}  // namespace
}  // namespace nearfield::ray_linear_tests
