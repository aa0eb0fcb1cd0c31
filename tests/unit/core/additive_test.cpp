/// Additive blends of two operands against the papers' own formulas: value and both partial derivatives, on
/// the edges of their pieces too; ties; inflation, erosion and rate as stated.

#include "unit/core/additive_rows.hpp"

#include <cstdint>
#include <cstdio>
#include <sstream>

namespace nearfield::additive_tests {
namespace {

using reference::announced_seed;

/// The greatest shares of what is stated.
struct Worst {
  Real value = 0, slope = 0, tight_slope = 0;

  void include(const Worst& other) {
    value = std::max(value, other.value);
    slope = std::max(slope, other.slope);
    tight_slope = std::max(tight_slope, other.tight_slope);
  }
  void report(const char* what) const {
    std::printf("  %-24s value %.3Lf, partial derivatives %.3Lf", what, value, slope);
    if (tight_slope > 0) std::printf(", of kinked blends away from the kinks %.3Lf", tight_slope);
    std::printf(" of the stated error\n");
  }
};

template <class S>
class Trial {
 public:
  Trial(const Row& row, Random& random) : row_(row), random_(random), table_(bake<S, 64>(row.kernel)) {}

  void run() {
    ASSERT_LT(table_.facts.error, 1 << 24) << row_.name;
    for (int i = 0; i < 4; ++i) {
      range_ = property::rounded<S>(i == 0 ? real(ScalarTraits<S>::domain())
                                           : std::pow(Real{10}, random_.uniform(-2, 0)));
      for (int k = 0; k < 40; ++k) judge_anywhere();
      if (i > 1) continue;
      for (const Real edge : row_.edges) judge_edge(edge);
    }
  }
  /// Shares of the stated errors anywhere, and on the edges of the formula's pieces or units from them.
  Worst anywhere, on_edges;

 private:
  void judge_anywhere() {
    const Real range = real(range_);
    const S y = property::rounded<S>(random_.uniform(-1, 1));
    const Real apart = random_.chance(0.2L)
                           ? (random_.chance(0.5L) ? 0 : range) + random_.uniform(-1e-3L, 1e-3L) * range
                           : random_.uniform(-1.1L, 1.1L) * range;
    judge_all(property::rounded<S>(real(y) + (random_.chance(0.5L) ? apart : -apart)), y, anywhere);
  }
  void judge_edge(Real edge) {
    const S gap = property::rounded<S>(edge * real(range_));
    const S somewhere = property::rounded<S>(random_.uniform(-0.5L, 0.5L));
    for (const S y : {S{}, somewhere}) {
      for (const int units : {-40, -2, -1, 0, 1, 2, 40}) judge_all(moved<S>(y + gap, units), y, on_edges);
    }
  }

  /// x and y as the smooth maximum sees them, through all three operations.
  void judge_all(S x, S y, Worst& worst) {
    const Real unit = real(ScalarTraits<S>::rounding_unit(
        property::rounded<S>(std::fabs(real(x)) + std::fabs(real(y)) + real(range_))));
    near_ = std::ldexp(real(range_), ScalarTraits<S>::is_fixed ? -28 : -21) + unit;
    const BlendPoint exact = row_.at(real(range_), real(x), real(y));
    const BlendPoint before = limit(x, y, -near_), after = limit(x, y, near_);
    const S minus_x = S{} - x, minus_y = S{} - y;
    judge(negated(blended<S, SetOperation::unite>(row_.sides, range_, table_, minus_x, minus_y)), exact,
          before, after, "union", x, y, worst);
    judge(blended<S, SetOperation::intersect>(row_.sides, range_, table_, x, y), exact, before, after,
          "intersection", x, y, worst);
    BlendPoint less = blended<S, SetOperation::subtract>(row_.sides, range_, table_, x, minus_y);
    less.by_y = -less.by_y;
    judge(less, exact, before, after, "subtraction", x, y, worst);
  }
  /// The blend as it goes on from x + beside, at x.
  BlendPoint limit(S x, S y, Real beside) const {
    const BlendPoint one = row_.at(real(range_), real(x) + beside, real(y)),
                     two = row_.at(real(range_), real(x) + 2 * beside, real(y));
    return {2 * one.value - two.value, 2 * one.by_x - two.by_x, 2 * one.by_y - two.by_y};
  }
  static BlendPoint negated(const BlendPoint& point) { return {-point.value, point.by_x, point.by_y}; }

  void judge(const BlendPoint& found, const BlendPoint& exact, const BlendPoint& before,
             const BlendPoint& after, const char* operation, S x, S y, Worst& worst) {
    const auto where = [&] {
      std::ostringstream text;
      text.precision(20);
      text << row_.name << " " << operation << ", as a maximum of " << real(x) << ", " << real(y)
           << ", range " << real(range_) << ", gap / range " << (real(x) - real(y)) / real(range_);
      return text.str();
    };
    const Real unit = real(ScalarTraits<S>::rounding_unit(
        property::rounded<S>(std::fabs(real(x)) + std::fabs(real(y)) + real(range_))));
    const Real value = real(range_) * std::ldexp(static_cast<Real>(table_.facts.error), -30) + 2 * unit;
    const Real off = outside(found.value, exact.value, before.value, after.value, row_.jump > 0);
    ASSERT_LE(off, value) << where();
    worst.value = std::max(worst.value, off / value);

    // The product with a gradient is rounded to so many units (detail::scaled_by_slope).
    const Real last_place = real(ScalarTraits<S>::rounding_unit(ScalarTraits<S>::one()));
    const Real product = fraction_bits_of<S> >= 24 ? std::ldexp(Real{4}, table_.slope_headroom) : 1;
    const Real rounding = (product + 1) * last_place;
    const Real halves = row_.sides == Sides::alike ? 1 : 2;
    const Real slope = std::ldexp(static_cast<Real>(table_.facts.slope_error), -24) / halves + rounding;
    // Where the formula has a kink, one of the one-sided values or what lies between.
    const bool kinked = row_.continuous_derivatives < 1 || row_.jump > 0;
    const Real off_x = outside(found.by_x, exact.by_x, before.by_x, after.by_x, kinked);
    const Real off_y = outside(found.by_y, exact.by_y, before.by_y, after.by_y, kinked);
    ASSERT_LE(off_x, slope) << where() << ": by the first operand " << found.by_x << " for " << exact.by_x;
    ASSERT_LE(off_y, slope) << where() << ": by the second operand " << found.by_y << " for " << exact.by_y;
    worst.slope = std::max({worst.slope, off_x / slope, off_y / slope});
    if (!row_.cubic_pieces || shares_a_segment_with_an_edge((real(x) - real(y)) / real(range_))) return;
    const Real of_rounding =
        rounding + std::ldexp(Real{1}, table_.slope_headroom + (ScalarTraits<S>::is_fixed ? -25 : -19));
    ASSERT_LE(std::max(off_x, off_y), of_rounding) << where() << ": " << found.by_x << " for " << exact.by_x;
    worst.tight_slope = std::max({worst.tight_slope, off_x / of_rounding, off_y / of_rounding});
  }

  /// How far from the exact number, or from all between it and its neighbours.
  static Real outside(Real found, Real exact, Real before, Real after, bool broken) {
    if (!broken) return std::fabs(found - exact);
    const Real least = std::min({exact, before, after}), greatest = std::max({exact, before, after});
    return std::max({least - found, found - greatest, Real{0}});
  }
  /// Such a segment of the table cannot follow the formula; all others do to rounding.
  bool shares_a_segment_with_an_edge(Real gap) const {
    const Real segments = row_.sides == Sides::alike ? 64 : 32, place = std::fabs(gap) * segments;
    const Real slack = segments * near_ / real(range_) + 1e-9L;
    return std::any_of(row_.edges.begin(), row_.edges.end(), [&](Real edge) {
      const Real knot = std::fabs(edge) * segments;
      if (std::fabs(knot - std::round(knot)) < 1e-6L) return false;
      return std::floor(knot) <= place + slack && place - slack <= std::ceil(knot) && edge * gap >= 0;
    });
  }

  const Row& row_;
  Random& random_;
  Table<S, 64> table_;
  S range_{};
  Real near_ = 0;  // how far roundings move the argument, metres
};

template <class S>
void expect_papers_formulas(const char* test, std::uint64_t seed) {
  Random random(announced_seed(test, seed));
  Worst anywhere, on_edges;
  int rows = 0;
  for (const Row& row : all_rows()) {
    Trial<S> trial(row, random);
    trial.run();
    if (testing::Test::HasFatalFailure()) return;
    anywhere.include(trial.anywhere);
    on_edges.include(trial.on_edges);
    ++rows;
  }
  std::printf("%d blends, greatest shares\n", rows);
  anywhere.report("anywhere");
  on_edges.report("on edges, units from them");
}

TEST(AdditiveBlends, EqualThePapersFormulasInFixed27) {
  expect_papers_formulas<Fixed<27>>("AdditiveBlendsFixed27", 401);
}
TEST(AdditiveBlends, EqualThePapersFormulasInFixed24) {
  expect_papers_formulas<Fixed<24>>("AdditiveBlendsFixed24", 402);
}
TEST(AdditiveBlends, EqualThePapersFormulasInFixed16) {
  expect_papers_formulas<Fixed<16>>("AdditiveBlendsFixed16", 403);
}
TEST(AdditiveBlends, EqualThePapersFormulasInFloat) {
  expect_papers_formulas<float>("AdditiveBlendsFloat", 404);
}

// Li's: g1 (1 - g2) delta / 4 with g1 = mu(delta / epsilon), g2 = mu(-delta / epsilon), so delta / 4 for
// epsilon <= delta; his interior blend leaves ties alone.
TEST(AdditiveBlends, TakeTheTieValuesOfThePapers) {
  using Q = Fixed<27>;
  const Q range(0.9);
  for (const Row& row : all_rows()) {
    const Table<Q, 64> table = bake<Q, 64>(row.kernel);
    const Real tie =
        blended<Q, SetOperation::intersect>(row.sides, range, table, Q(0.25), Q(0.25)).value - 0.25L;
    const Real allowed = std::ldexp(static_cast<Real>(table.facts.error), -30) + std::ldexp(Real{2}, -27) +
                         (row.ratio == 1 ? row.jump : 0);
    EXPECT_LE(std::fabs(tie - (row.at(real(range), 0.25L, 0.25L).value - 0.25L)), allowed) << row.name;
    Real exact = 0;
    if (row.family == Family::exterior) {
      if (row.ratio > 1) continue;
      // A step that only approximates is not quite 0 and 1 yet.
      exact =
          real(range) / (1 + row.ratio) / 4 * (row.ratio < 1 ? 1 : (1 - row.jump / 2) * (1 - row.jump / 2));
    }
    if (row.family == Family::log_sum_exp) exact = std::log(Real{2}) / 18 * real(range);
    if (row.family == Family::quadratic) exact = real(range) / 4;
    if (row.family == Family::cubic) exact = real(range) / 6;
    EXPECT_LE(std::fabs(tie - exact), allowed) << row.name;
  }
  const double mu = step::polynomial<3>(Differentiable(0.25)).value;
  const Table<Q, 64> wide = bake<Q, 64>(any(exterior(step::polynomial<3>, 4.0)));
  const Real tie = blended<Q, SetOperation::intersect>(Sides::alike, Q(0.5), wide, Q(), Q()).value;
  EXPECT_NEAR(static_cast<double>(tie), 0.1 * mu * mu / 4, 1e-7);
}

/// How far a blend of operands of rate 1 leaves the sharp operation, and its rate, with the range 1.
struct Reached {
  Real inflation = 0, erosion = 0, spread = 1;
};

template <SetOperation operation>
void expect_reached(const Row& row, const Table<Fixed<27>, 64>& table) {
  using Q = Fixed<27>;
  const std::string what = row.name + (operation == SetOperation::unite       ? " union"
                                       : operation == SetOperation::intersect ? " intersection"
                                                                              : " subtraction");
  Certificate<Q> operand;
  operand.valid = true;
  operand.lipschitz = kUnitRate;
  const Certificate<Q> operands[2] = {operand, operand};
  const ArgumentScale<Q> scale = ArgumentScale<Q>::of(Q(1.0));
  const Certificate<Q> stated =
      row.sides == Sides::alike
          ? Additive<Q, operation>{scale}.certificate(operands, table.facts, domain_reach<Q>())
          : Additive<Q, operation, Sides::differ>{scale}.certificate(operands, table.facts,
                                                                     domain_reach<Q>());
  ASSERT_TRUE(stated.valid) << what;
  Reached found, exact;
  const auto include = [](Reached& reached, Real value, Real sharp, Real spread) {
    reached.inflation = std::max(reached.inflation, sharp - value);
    reached.erosion = std::max(reached.erosion, value - sharp);
    reached.spread = std::max(reached.spread, spread);
  };
  for (int i = -1024; i <= 1024; ++i) {
    const Q x(i / 1024.0);
    const Real gap = real(x);
    const BlendPoint point = blended<Q, operation>(row.sides, Q(1.0), table, x, Q());
    // Both with the second operand 0; the union's maximum is that of -x.
    const bool unites = operation == SetOperation::unite;
    const Real sharp = unites ? std::min(gap, Real{0}) : std::max(gap, Real{0});
    include(found, point.value, sharp, std::fabs(point.by_x) + std::fabs(point.by_y));
    if (!unites) continue;
    const BlendPoint maximum = row.at(1, -gap, 0);
    include(exact, -maximum.value, sharp, std::fabs(maximum.by_x) + std::fabs(maximum.by_y));
  }
  // Of the range: how finely a table's ranges are bounded (ranges_of()).
  const Real few = 4e-6L, error = std::ldexp(static_cast<Real>(table.facts.error), -30) + few;
  const Real inflation = real(stated.inflation), erosion = real(stated.erosion),
             rate = real(stated.lipschitz);
  EXPECT_LE(found.inflation, inflation) << what;
  EXPECT_LE(found.erosion, erosion) << what;
  EXPECT_LE(found.spread, rate) << what;
  EXPECT_GE(found.inflation, 0.99L * inflation - few) << what;
  EXPECT_GE(found.erosion, 0.99L * erosion - few) << what;
  EXPECT_GE(found.spread, 1 + 0.95L * (rate - 1) - 1e-4L) << what;
  const bool unites = operation == SetOperation::unite;
  if (unites) {
    // The paper's own formula: bounded by what is stated, and within 1 % of it.
    EXPECT_LE(exact.inflation, inflation + error) << what;
    EXPECT_LE(exact.erosion, erosion + error) << what;
    EXPECT_GE(exact.inflation, 0.99L * inflation - error) << what;
    EXPECT_GE(exact.erosion, 0.99L * erosion - error) << what;
  }

  // A union grows and an intersection shrinks by what the maximum adds.
  const Real added = unites ? inflation : erosion, taken = unites ? erosion : inflation;
  if (row.family == Family::interior) {
    EXPECT_LE(added, error) << what << ": on the inner side of the sharp operation";
    EXPECT_LE(exact.inflation, 1e-18L) << what << ": within the union";
  } else if (row.family != Family::exterior || row.ratio <= 1) {
    EXPECT_LE(taken, error) << what << ": on the outer side of the sharp operation";
    EXPECT_LE(exact.erosion, 1e-18L) << what << ": contains the union";
  } else if (row.ratio >= 3.999L && row.step == "H_3") {
    // For epsilon > delta the formula itself goes below the maximum: neither solid contains the other.
    EXPECT_NEAR(static_cast<double>(taken * (1 + row.ratio)), 0.055, 0.001)
        << what << ": MATHS.md, section 5";
  }
}

// The union's solid: where the blend is below the sharp minimum it is larger. Of all blends, the widest and
// those of steps that are not antisymmetric among them.
TEST(AdditiveBlends, StatedInflationAndErosionAreReached) {
  int apart = 0;
  for (const Row& row : all_rows()) {
    const Table<Fixed<27>, 64> table = bake<Fixed<27>, 64>(row.kernel);
    expect_reached<SetOperation::unite>(row, table);
    expect_reached<SetOperation::intersect>(row, table);
    expect_reached<SetOperation::subtract>(row, table);
    apart += row.family == Family::exterior && row.ratio > 1 ? 1 : 0;
  }
  std::printf("%d of %d blends with epsilon > delta, of which containment is not promised\n", apart,
              static_cast<int>(all_rows().size()));
}

// A step that only approximates leaves a jump at the end of the range: 64 units of 2^-30 are too much of it.
TEST(AdditiveBlends, TablesThatEndWithAJumpAreRefused) {
  int refused = 0;
  for (const Row& row : all_rows()) {
    const Table<Fixed<27>, 64> table = bake<Fixed<27>, 64>(row.kernel);
    const Real last = 1 - 1e-12L, jump = std::fabs(row.at(1, last, 0).value - last) * (1 << 24);
    if (jump < 0.9L || jump > 1.1L) {
      EXPECT_EQ(fits(row, table), jump < 1) << row.name;
    }
    refused += fits(row, table) ? 0 : 1;
  }
  EXPECT_GT(refused, 2);
}

TEST(AdditiveBlends, OneSidedTablesOfStepsThatAreNotAntisymmetricAreRefused) {
  for (const StepRow& step : all_steps()) {
    if (step.step.facts().antisymmetric) continue;
    EXPECT_EQ((bake<Fixed<27>, 64>(exterior_row(step, 0.25, Sides::alike).kernel)).facts.error,
              greatest_of<int32_t>);
    EXPECT_EQ((bake<Fixed<27>, 64>(interior_row(step, Sides::alike).kernel)).facts.error,
              greatest_of<int32_t>);
  }
}

}  // namespace
}  // namespace nearfield::additive_tests
