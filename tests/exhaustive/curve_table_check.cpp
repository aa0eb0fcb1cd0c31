#include "curve_table_check.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <cstdint>
#include <cstdio>
#include <optional>
#include <string>
#include <type_traits>
#include <vector>

#include "curve_table_joints.hpp"

namespace nearfield::curve_tests {
namespace {

constexpr int kBlock = 2048;
constexpr double kBesideKink = 1.0 / 67108864;

// Units in the last place by which a value may step against its curve's direction, and by which value and
// slope may jump at knots beyond what they climb between the two arguments.
constexpr double kGreatestStepAgainst = 1.0, kGreatestValueJump = 1.0, kGreatestSlopeJump = 1.0;
// Units in the last place of a slope by which stored coefficients, rounded, may point against the curve's
// direction.
constexpr double kGreatestSlopeAgainst = 3.0;
// A slope error of 128 is no statement: facts of tables have no more.
constexpr double kNoSlopeError = 127.99;

double per_two_to_the_30(double x) { return std::ldexp(x, 30); }

/// One table and what was seen of it on the way over its range.
template <class S>
class TableWatch {
 public:
  /// Looks at every argument of which the number is a multiple of `every`, a power of two.
  TableWatch(const CurveRow& row, host::BakedCurve<S> baked, int every)
      : row_(row), facts_(row.curve.facts()), baked_(std::move(baked)), every_(every) {}

  void look(int64_t first, double step, int count, const CurvePoint* points) {
    with_view(baked_, [&](const auto& view, auto rising) {
      const auto& placement = baked_.layout.placement;
      for (int i = static_cast<int>(-first & (every_ - 1)); i < count; i += every_) {
        const double x = facts_.from + static_cast<double>(first + i) * step;
        const auto raw = sample_curve<true, rising.value>(view, placement, S(static_cast<S>(x)));
        see(x, raw_value(raw.value), static_cast<Real>(raw.slope) * slope_unit_, points[i]);
      }
      return 0;
    });
  }

  void expect(const std::string& size) const {
    SCOPED_TRACE(row_.name + ", " + scalar_name<S>() + ", " + size);
    const TableShape& shape = baked_.layout.shape;
    std::printf(
        "%-34s %-9s %-5s degree %d%s x %4d, %2d bits, %5d bytes; error stated %.6g seen %.6g, slope %.6g "
        "%.6g",
        row_.name.c_str(), scalar_name<S>(), size.c_str(), shape.degree, shape.over_square ? " (square)" : "",
        shape.segments, shape.bits, shape.bytes(), per_two_to_the_30(baked_.error),
        per_two_to_the_30(static_cast<double>(error_)), per_two_to_the_30(baked_.slope_error),
        per_two_to_the_30(static_cast<double>(slope_error_)));
    const Joints joints = joints_of(facts_, row_.expected.kinks, baked_);
    const double slope_against_direction =
        facts_.direction == Direction::none ? 0.0 : slope_against(facts_, baked_);
    std::printf("; joints %.2f, slope %.2f (%d > 1)", joints.value_jump, joints.slope_jump,
                joints.slopes_beyond_one_unit);
    std::printf("; against its direction %.2f (%lld steps), slope %.2f\n",
                against_ / value_unit<S>(shape.bits), static_cast<long long>(against_count_),
                slope_against_direction);
    EXPECT_LE(error_, static_cast<Real>(baked_.error)) << "value at " << worst_;
    if (baked_.slope_error < kNoSlopeError) {
      EXPECT_LE(slope_error_, static_cast<Real>(baked_.slope_error)) << "slope at " << worst_slope_;
    }
    // Where slopes have fewer fraction bits than values, what a climb is truncated to is coarser by as much.
    const int coarser = baked_.layout.rising ? baked_.layout.scale.slope_headroom - index_bits_for(shape.segments) : 0;
    EXPECT_LE(against_ / value_unit<S>(shape.bits), std::ldexp(kGreatestStepAgainst, coarser))
        << "against its direction at " << worst_against_;
    EXPECT_LE(slope_against_direction, kGreatestSlopeAgainst);
    EXPECT_LE(joints.value_jump, kGreatestValueJump) << "value at knot " << joints.value_knot;
    // Chords have no slope to be continuous.
    if (shape.degree > 1) {
      EXPECT_LE(joints.slope_jump, kGreatestSlopeJump) << "slope at knot " << joints.slope_knot;
    }
    expect_outside(facts_, baked_);
    expect_mirrored(facts_, baked_);
    expect_ranges(baked_);
  }

  const host::BakedCurve<S>& baked() const { return baked_; }

 private:
  void see(double x, double value, Real slope, const CurvePoint& exact) {
    if (x <= facts_.from || x >= facts_.to) return;  // there the table is exactly `before` or `after`
    bool kink = false;
    for (const double at : row_.expected.kinks) kink = kink || std::fabs(x - at) < kBesideKink;
    note(std::fabs(static_cast<Real>(value) - exact.value), x, error_, worst_);
    note(kink ? Real{0} : std::fabs(slope - exact.first), x, slope_error_, worst_slope_);
    const double climb = (value - last_value_) * static_cast<double>(facts_.direction);
    if (looked_ && climb < 0) {
      ++against_count_;
      note(-climb, x, against_, worst_against_);
    }
    looked_ = true;
    last_value_ = value;
  }
  template <class Number>
  static void note(Number here, double x, Number& greatest, double& place) {
    // So that what is not a number stays.
    if (here <= greatest) return;
    greatest = here;
    place = x;
  }

  const CurveRow& row_;
  CurveFacts facts_;
  host::BakedCurve<S> baked_;
  int every_;
  Real slope_unit_ =
      ScalarTraits<S>::is_fixed ? std::ldexp(Real{1}, -baked_.layout.slope_fraction_bits) : Real{1};
  Real error_ = 0, slope_error_ = 0;
  double against_ = 0, last_value_ = 0;
  double worst_ = 0, worst_slope_ = 0, worst_against_ = 0;
  int64_t against_count_ = 0;
  bool looked_ = false;
};

/// Takes `watches` over the curve's range, 2^grid_bits arguments.
template <class... Watch>
void sweep(const CurveRow& row, int grid_bits, std::vector<Watch>&... watches) {
  const CurveFacts facts = row.curve.facts();
  const int64_t count = int64_t{1} << grid_bits;
  const double step = (facts.to - facts.from) / static_cast<double>(count);
  std::vector<CurvePoint> points(kBlock);
  for (int64_t first = 0; first < count; first += kBlock) {
    row.reference(facts.from + static_cast<double>(first) * step, step, kBlock, points.data());
    const auto look = [&](auto& all) {
      for (auto& watch : all) watch.look(first, step, kBlock, points.data());
    };
    (look(watches), ...);
  }
}

constexpr TableRequest within_20_bits(int bytes) { return {20, bytes}; }
constexpr TableRequest best_of(int bytes) { return {0, bytes}; }

/// How many numbers of the grid lie between two arguments that Fixed<16> and float can represent as well.
int common_arguments(const CurveFacts& facts) {
  int every = 64;
  while (std::fmod((facts.to - facts.from) * every / (1 << 24), 1.0 / (1 << 16)) != 0) every *= 2;
  return every;
}

template <class S>
void add_watches(const CurveRow& row, int every, std::vector<TableWatch<S>>& watches) {
  for (const int bytes : {1024, 16384}) {
    auto baked = host::bake_curve<S>(row.curve, within_20_bits(bytes));
    const bool met = baked.has_value();
    if (std::is_same_v<S, Fixed<27>>) {
      const Meets needed = bytes == 1024 ? Meets::in_one_kibibyte : Meets::in_sixteen_kibibytes;
      EXPECT_EQ(met, row.expected.meets <= needed) << row.name << " within 2^-20 in " << bytes << " bytes";
    }
    if (!met) baked = host::bake_curve<S>(row.curve, best_of(bytes));
    if (std::is_same_v<S, float> && row.expected.too_steep_for_float && bytes > 1024) {
      EXPECT_FALSE(baked.has_value()) << row.name << " in float";
      continue;
    }
    ASSERT_TRUE(baked.has_value()) << row.name << " has no table of " << bytes << " bytes";
    EXPECT_LE(baked->layout.shape.bytes(), bytes);
    if (met) {
      EXPECT_LE(baked->error, std::ldexp(1.0, -20));
    }
    watches.emplace_back(row, *std::move(baked), every);
    if (met) return;
  }
}

}  // namespace

void check_tables(const CurveRow& row) {
  ASSERT_EQ(row.curve.problem(), nullptr) << row.name;
  const int common = common_arguments(row.curve.facts());
  std::vector<TableWatch<Fixed<27>>> fine;
  std::vector<TableWatch<Fixed<16>>> coarse;
  std::vector<TableWatch<float>> floating;
  add_watches(row, 1, fine);
  add_watches(row, common, coarse);
  add_watches(row, common, floating);
  ASSERT_FALSE(testing::Test::HasFatalFailure());
  if (row.expected.exact_segments > 0) {
    const auto& baked = fine.front().baked();
    EXPECT_EQ(baked.layout.shape.segments, row.expected.exact_segments) << row.name;
    EXPECT_LE(per_two_to_the_30(baked.error), 16.0) << row.name << " is exact to rounding";
  }
  sweep(row, 24, fine, coarse, floating);
  const auto expect_all = [](const auto& watches) {
    for (const auto& watch : watches)
      watch.expect(watch.baked().layout.shape.bytes() > 1024 ? "large" : "1 KiB");
  };
  expect_all(fine);
  expect_all(coarse);
  expect_all(floating);
}

void check_formats(const CurveRow& row, const std::vector<TableRequest>& requests) {
  ASSERT_EQ(row.curve.problem(), nullptr) << row.name;
  std::vector<TableWatch<Fixed<27>>> fine;
  std::vector<TableWatch<Fixed<16>>> coarse;
  const int common = common_arguments(row.curve.facts()) / 16;
  for (const TableRequest& request : requests) {
    auto baked = host::bake_curve<Fixed<27>>(row.curve, request);
    auto baked_coarse = host::bake_curve<Fixed<16>>(row.curve, request);
    ASSERT_TRUE(baked && baked_coarse) << row.name;
    EXPECT_EQ(baked->layout.shape.bits, request.bits);
    EXPECT_EQ(baked->layout.shape.degree, request.degree);
    fine.emplace_back(row, *std::move(baked), 1);
    coarse.emplace_back(row, *std::move(baked_coarse), common);
  }
  sweep(row, 20, fine, coarse);
  for (const auto& watch : fine) watch.expect("");
  for (const auto& watch : coarse) watch.expect("");
}

TEST_P(CurveTable, KeepsItsPromises) { check_tables(GetParam()); }

}  // namespace nearfield::curve_tests
