// Tables baked while the program runs are those of the compiler, to the bit.
#include <gtest/gtest.h>
#include <nearfield/curve/kernel.hpp>
#include <nearfield/curve/potential.hpp>
#include <nearfield/curve/ray_kernel.hpp>
#include <nearfield/curve/tabulated_form.hpp>

#include <string>
#include <vector>

#include "compile/table_baker.hpp"

namespace nearfield::host {
namespace {

template <class S, int segments, class Function>
void expect_same_table(const TableFunction& at_run_time, const Function& function) {
  const Table<S, segments> expected = bake<S, segments>(function);
  const ImageTable found = bake_table<S>(at_run_time);
  ASSERT_EQ(found.index_bits, expected.index_bits);
  EXPECT_EQ(found.slope_headroom, expected.slope_headroom);
  EXPECT_TRUE(S(static_cast<S>(at_run_time.range)) == expected.range);
  EXPECT_EQ(found.facts.error, expected.facts.error);
  EXPECT_EQ(found.facts.slope_error, expected.facts.slope_error);
  EXPECT_EQ(found.facts.greatest_value, expected.facts.greatest_value);
  EXPECT_EQ(found.facts.least_slope, expected.facts.least_slope);
  EXPECT_EQ(found.coefficients,
            std::vector<std::uint32_t>(std::begin(expected.coefficients), std::end(expected.coefficients)));
  EXPECT_TRUE(found.usable());
}

template <class S>
class FieldTables : public testing::Test {};
using Scalars = testing::Types<Fixed<27>, Fixed<24>, Fixed<16>, float>;
TYPED_TEST_SUITE(FieldTables, Scalars, );

TYPED_TEST(FieldTables, AreThoseOfTheCompiler) {
  using S = TypeParam;
  const ConfiguredCurve step = configured_curve("polynomial", {"n=3"});
  expect_same_table<S, 2>(potential_over_square(configured_curve("wyvill", {})),
                          over_square(potential::wyvill));
  expect_same_table<S, 1>(table_function("cubic", CubicKernel{}), CubicKernel{});
  if constexpr (ScalarTraits<S>::is_fixed) {
    expect_same_table<S, 64>(table_function("exterior", exterior(step.curve, 0.25)),
                             exterior(step::polynomial<3>, 0.25));
  }
}

TYPED_TEST(FieldTables, ErrByLessThanIsSoughtOrAreTheBest) {
  using S = TypeParam;
  const double sought =
      (1.0 / 8388608.0 + (ScalarTraits<S>::is_fixed ? 0.0 : 1.0 / 4194304.0)) * 1073741824.0;
  const ConfiguredCurve smooth = configured_curve("polynomial", {"n=3"}),
                        kinked = configured_curve("polynomial", {"n=1"});
  const ImageTable good = bake_table<S>(table_function("a", interior(smooth.curve)));
  EXPECT_LE(good.facts.error, sought);
  EXPECT_LT(good.index_bits, 8);
  const ImageTable best = bake_table<S>(table_function("b", exterior(kinked.curve, 4.0)));
  EXPECT_GT(best.facts.error, sought);
  EXPECT_TRUE(best.usable());
  const ImageTable none =
      bake_table<S>(potential_over_square(configured_curve("arctangent_clamped", {"c1=100"})));
  EXPECT_FALSE(none.usable());
}

TEST(FieldTableFunctions, HaveOneIdentityForEachFunction) {
  EXPECT_EQ(identity_of(configured_curve("polynomial", {})),
            identity_of(configured_curve("polynomial", {"n=3"})));
  EXPECT_NE(identity_of(configured_curve("polynomial", {})),
            identity_of(configured_curve("polynomial", {"n=2"})));
  const ConfiguredCurve cubic = configured_curve("cubic", {"w1=0.5"});
  EXPECT_NE(identity_of(cubic), identity_of(configured_curve("cubic", {})));
  EXPECT_NE(potential_function(cubic).identity, potential_over_square(cubic).identity);
  EXPECT_EQ(potential_function(cubic).range, 0.75);
  EXPECT_EQ(potential_over_square(cubic).range, 0.75);
  EXPECT_NEAR(potential_function(cubic)(Differentiable(2.0 / 3.0)).value, 0.5, 1e-12);
  EXPECT_NEAR(potential_over_square(cubic)(Differentiable(4.0 / 9.0)).value, 0.5, 1e-12);
}

}  // namespace
}  // namespace nearfield::host
