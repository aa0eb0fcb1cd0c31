// Operands that bring blends to their worst paths: close to each other, so that they are blended, and of all
// signs and sizes.
#pragma once

#include <operation_costs/fields.hpp>

namespace nearfield::costs {

inline const Sphere<Q> kOtherBall = {{0.15, 0.25, 0.0}, 0.3};

template <template <class> class Blend>
void measure_additive(Q range) {
  Blend<Q> blend;
  blend.scale = ArgumentScale<Q>::of(range);
  if constexpr (__is_same(Blend<Q>, TwoSidedUnion<Q>) || __is_same(Blend<Q>, TwoSidedIntersection<Q>) ||
                __is_same(Blend<Q>, TwoSidedSubtraction<Q>)) {
    Trial(kTwoSidedKernel).operand(kBall).operand(kOtherBall).measure(blend);
  } else {
    Trial(kKernel).operand(kBall).operand(kOtherBall).measure(blend);
  }
}

inline void measure_distance_blends() {
  Trial().operand(kBall).operand(kOtherBall).measure(SharpUnion<Q>{});
  Trial().operand(kBall).operand(kOtherBall).measure(SharpIntersection<Q>{});
  Trial().operand(kBall).operand(kOtherBall).measure(SharpSubtraction<Q>{});
  const Q ranges[] = {Q(0.1), Q(1.25), Q(4.0)};
  for (const Q range : ranges) {
    measure_additive<AdditiveUnion>(range);
    measure_additive<AdditiveIntersection>(range);
    measure_additive<AdditiveSubtraction>(range);
    measure_additive<TwoSidedUnion>(range);
    measure_additive<TwoSidedIntersection>(range);
    measure_additive<TwoSidedSubtraction>(range);
  }
}

// Balls in a row: on one side of it each decides over those before it.
template <template <class> class Blend>
void measure_log_sum_exp() {
  const uint32_t counts[] = {1u, 2u, 4u, 18u};
  for (const uint32_t count : counts) {
    const Q ranges[] = {Q(1.0), Q(4.0)};
    for (const Q range : ranges) {
      Trial trial;
      for (uint32_t i = 0; i < count; ++i)
        trial.operand(Sphere<Q>{{Q::from_raw(static_cast<int32_t>(i << 21)), 0.2, 0.0}, 0.3});
      trial.measure(Blend<Q>{ArgumentScale<Q>::of(range), count});
    }
  }
}

inline void measure_parameters() {
  Trial().operand(kBall).operand(kOtherBall).measure(Morph<Q>{0});
  Trial().operand(kBall).measure(Swell<Q>{Q(-0.7), 0});
  const RayPoint<Q> a = {kPlace, RayRadius<Q>(Q(0.7))}, b = {{0.2, 0.1, 0.3}, RayRadius<Q>(Q(0.7))};
  Trial().operand(a).operand(b).measure(RayMorph<Q>{0});
  const SoftPoint<Q> dim = {kPlace, Influence<Q>(Q(1.5), Q(1.0))}, bright = {{0.2, 0.1, 0.3}, Influence<Q>(Q(1.5), Q(-4.0))};
  Trial(kSquaredPotential).operand(dim).operand(bright).measure(IntensityMorph<Q>{0});
  Trial(kSquaredPotential).operand(bright).measure(Fade<Q>{0});
}

inline void measure_intensity_blends() {
  const Influence<Q> influences[] = {Influence<Q>(Q(1.5), Q(1.0)), Influence<Q>(Q(0.125), Q(4.0)),
                                     Influence<Q>(Q(0.125), Q(-4.0))};
  for (const Influence<Q>& influence : influences) {
    const SoftPoint<Q> a = {kPlace, influence}, b = {{0.11, 0.01, 0.2}, influence};
    Trial(kSquaredPotential).operand(a).operand(b).measure(SoftSum<Q>{});
    Trial(kSquaredPotential).operand(a).operand(a).measure(SoftSum<Q>{});
    Trial(kSquaredPotential).operand(a).operand(b).measure(IntensityUnion<Q>{});
    Trial(kSquaredPotential).operand(a).operand(b).measure(IntensityIntersection<Q>{});
  }
}

// Of operands that cross, and of one that is a copy of the other nearby.
template <const auto& profile, class Blend>
void measure_ray_linear(Blend blend) {
  blend.sides = RaySides<Q>::of(profile);
  const RayPoint<Q> point = {kPlace, RayRadius<Q>(Q(0.7))};
  Trial(kProfile<profile>)
      .operand(point)
      .operand(RaySegment<Q>{kSegment, RayRadius<Q>(Q(0.5))})
      .measure(blend);
  Trial(kProfile<profile>)
      .operand(point)
      .operand(RayPoint<Q>{{0.2, 0.1, 0.3}, RayRadius<Q>(Q(0.7))})
      .measure(blend);
}

inline void measure_ray_blends() {
  const RayPoint<Q> a = {kPlace, RayRadius<Q>(Q(0.7))}, b = {{0.2, 0.1, 0.3}, RayRadius<Q>(Q(0.7))};
  Trial().operand(a).operand(b).measure(RayUnion<Q>{});
  Trial().operand(a).operand(b).measure(RayIntersection<Q>{});
  measure_ray_linear<kRoundUnion>(RayLinearUnion<Q>{});
  measure_ray_linear<kScaleUnion>(RayLinearUnion<Q>{});
  measure_ray_linear<kRoundIntersection>(RayLinearIntersection<Q>{});
  measure_ray_linear<kScaleIntersection>(RayLinearIntersection<Q>{});
  RayLinearDifference<Q> difference;
  difference.complement = {Q(1.0), Q(0.25)};
  measure_ray_linear<kRoundIntersection>(difference);
  measure_ray_linear<kScaleIntersection>(difference);
}

inline void measure_algebraic_blends() {
  for (const Q slope : kSlopes) {
    Trial().operand(plane(slope, 0)).operand(plane(slope, 1)).measure(AlgebraicUnion<Q>{});
    Trial().operand(plane(slope, 0)).operand(plane(slope, 1)).measure(AlgebraicIntersection<Q>{});
    const Q conics[] = {Q(-3.0), Q(0.0), Q(0.875)};
    for (const Q conic : conics) {
      const Q ranges[] = {Q(0.25), Q(1.0)};
      for (const Q range : ranges) {
        const auto measure = [&](auto blend) {
          Trial().operand(plane(slope, 0)).operand(plane(slope, 1)).measure(blend);
        };
        measure(HoffmannHopcroftUnion<Q>::of(range, Q(1.0), conic));
        measure(HoffmannHopcroftIntersection<Q>::of(range, Q(1.0), conic));
        measure(HoffmannHopcroftDifference<Q>::of(range, Q(1.0), conic));
      }
    }
    const uint32_t exponents[] = {1u, 2u, 4u};
    for (const uint32_t exponent : exponents) {
      const uint32_t counts[] = {1u, 2u, 8u};
      for (const uint32_t count : counts) {
        Trial trial;
        for (uint32_t i = 0; i < 2 * count; ++i) trial.operand(plane(slope, static_cast<int>(i)));
        trial.measure(FunctionalSpline<Q>{count, count, exponent, Q(0.3)});
      }
    }
  }
}

// Bounds of a patch: planes through a point near the origin, or through the origin along the axes, so that
// they vanish or are powers of two together.
inline AlgebraicPlane<Q> bound(uint32_t side, Q slope, bool through_axes) {
  if (!through_axes) return plane(slope, static_cast<int>(side + 1));
  const Q size = side < 4 ? slope : -slope;
  const Vector3<Q> normals[] = {{size, {}, {}}, {{}, size, {}}, {{}, {}, size}};
  return {normals[side % 3], {}};
}

template <class Patch>
void measure_patch(uint32_t count, uint32_t exponent, Q slope, bool through_axes) {
  constexpr bool ribbons = __is_same(Patch, RibbonPatch<Q>);
  Patch patch;
  patch.side_count = count;
  patch.exponent = exponent;
  for (uint32_t i = 0; i < count; ++i) patch.side_weight[i] = i % 2 == 0 ? Q(1.5) : Q(-0.75);
  patch.centre_weight = Q(0.3);
  Trial trial;
  for (uint32_t i = 0; i < 2 * count; ++i) {
    const bool is_bound = ribbons ? i % 2 == 1 : i >= count;
    const uint32_t side = ribbons ? i / 2 : i % count;
    if (is_bound)
      trial.operand(bound(side, slope, through_axes));
    else
      trial.operand(plane(Q(1.0), static_cast<int>(side)));
  }
  trial.measure(patch);
}

inline void measure_patches() {
  for (const Q slope : kSlopes) {
    const uint32_t exponents[] = {2u, 3u};
    for (const uint32_t exponent : exponents) {
      const bool both[] = {false, true};
      for (const bool through_axes : both) {
        const uint32_t counts[] = {2u, 3u, 8u};
        for (const uint32_t count : counts) {
          measure_patch<RibbonPatch<Q>>(count, exponent, slope, through_axes);
          if (count > 2) measure_patch<CornerPatch<Q>>(count, exponent, slope, through_axes);
        }
      }
    }
  }
}

inline void measure_blends() {
  measure_distance_blends();
  measure_log_sum_exp<LogSumExpUnion>();
  measure_log_sum_exp<LogSumExpIntersection>();
  measure_log_sum_exp<LogSumExpSubtraction>();
  measure_intensity_blends();
  measure_parameters();
  measure_ray_blends();
  measure_algebraic_blends();
  measure_patches();
}

}  // namespace nearfield::costs
