// Skeletons of few and of many parts, brought to their worst paths.
#pragma once

#include <operation_costs/trial.hpp>

namespace nearfield::costs {

inline const Vector3<Q> kChain[] = {{-0.3, 0.1, 0.0}, {0.4, 0.2, 0.3},  {0.7, -0.3, 0.1},   {1.1, 0.2, -0.6},
                                    {0.2, 1.3, 0.4},  {-0.8, 0.9, 0.2}, {-1.2, -0.4, -0.7}, {0.3, -1.1, 0.5}};
// A star-shaped polygon: of its first vertices simple as well.
inline const Q kOutlineX[] = {Q(1.0), Q(0.5), Q(0.1), Q(-0.4), Q(-0.9), Q(-0.3), Q(0.0), Q(0.6)};
inline const Q kOutlineY[] = {Q(0.0), Q(0.4), Q(1.1), Q(0.3), Q(0.1), Q(-0.2), Q(-0.8), Q(-0.3)};
// Most of its edges cross any one height.
inline const Q kCrownX[] = {Q(-1.0), Q(-0.9), Q(-0.5), Q(0.0), Q(0.5), Q(0.9), Q(1.0), Q(0.0)};
inline const Q kCrownY[] = {Q(-1.0), Q(1.0), Q(-0.8), Q(1.0), Q(-0.8), Q(1.0), Q(-1.0), Q(-1.2)};
// Four Bezier segments, and seven points of a spline.
inline const Vector3<Q> kCurve[] = {{-0.3, 0.1, 0.0}, {0.1, 0.2, 0.3},  {0.3, -0.1, 0.1}, {0.5, 0.2, -0.2},
                                    {0.7, 0.5, -0.5}, {0.5, 0.7, -0.4}, {0.3, 0.8, -0.3}, {0.1, 0.9, -0.2},
                                    {-0.1, 0.9, 0.0}, {-0.2, 0.7, 0.2}, {-0.3, 0.5, 0.3}, {-0.4, 0.4, 0.4},
                                    {-0.5, 0.3, 0.3}};

inline void measure_curves() {
  const int point_counts[] = {4, 7, 10, 13};
  for (const int count : point_counts) Trial().measure(CubicCurve<Q>(kCurve, count, Q(0.1)));
  const int spline_counts[] = {4, 7};
  for (const int count : spline_counts) Trial().measure(CubicCurve<Q>::b_spline(kCurve, count, Q(0.1)));
  const Vector3<Q> wild[] = {{-1.5, 0.3, 0.1}, {0.4, 1.0, -0.8}, {0.3, -0.9, 0.9}, {1.6, 0.2, -0.1}};
  Trial().measure(CubicCurve<Q>(wild, 4, Q{}));
  const Vector3<Q> one_place[] = {kCurve[0], kCurve[0], kCurve[0], kCurve[0]};
  Trial().measure(CubicCurve<Q>(one_place, 4, Q{}));
}

inline void measure_skeletons() {
  const int point_counts[] = {2, 3, 8};
  for (const int count : point_counts) Trial().measure(Polyline<Q>(kChain, count, Q(0.1)));
  const int vertex_counts[] = {3, 4, 8};
  for (const int count : vertex_counts)
    Trial().measure(Polygon<Q>(kOutlineX, kOutlineY, count, Q(0.1), Q(0.05)));
  Trial().measure(Polygon<Q>(kCrownX, kCrownY, 8, Q(0.1), Q{}));
  measure_curves();
}

}  // namespace nearfield::costs
