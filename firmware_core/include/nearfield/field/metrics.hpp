// Ray functions that are made of others (Hsu, equations 2 to 4).
#pragma once

#include <nearfield/field/compose.hpp>

namespace nearfield {

// ((|x / a|^n1 + |y / b|^n1)^(n2 / n1) + |z / c|^n2)^(1 / n2), (x, y, z) from the centre along the local
// axes, (a, b, c) the radii, metres; n1 and n2 from 0.2 to 64. See RaySweep.
template <class S>
constexpr RaySweep<S> superquadric(const Vector3<S>& center, const Vector3<S>& radii, Rate n1, Rate n2) {
  return {center, radii, n1, n2};
}

// (|x / a|^n + |y / b|^n + |z / c|^n)^(1 / n), n from 1 (below that no metric) to 64.
template <class S>
constexpr RaySweep<S> lp_metric(const Vector3<S>& center, const Vector3<S>& radii, Rate n) {
  return superquadric(center, radii, n, n);
}

// Its limit for n without end: the greatest of |x / a|, |y / b| and |z / c|.
template <class S>
constexpr auto box_metric(const Vector3<S>& center, const Vector3<S>& radii) {
  const auto one = ScalarTraits<S>::unit_one();
  const RayIntersection<S> greatest;
  return combine(greatest,
                 combine(greatest, RaySlab<S>{center, {one, {}, {}}, RayRadius<S>(radii.x)},
                         RaySlab<S>{center, {{}, one, {}}, RayRadius<S>(radii.y)}),
                 RaySlab<S>{center, {{}, {}, one}, RayRadius<S>(radii.z)});
}

// (sum of di^n)^(1 / n) of ray functions, n that of the profile, profile::super_ellipsoidal_intersection(n),
// from which the table was baked; the table must outlive the field. Of slabs: generalised distances.
template <class Profile, class S, int segments, int degree, int bits, class A, class B>
constexpr auto generalised_distance(const Profile& profile, const Table<S, segments, degree, bits>& table,
                                    const A& a, const B& b) {
  RayLinearIntersection<S> norm;
  norm.sides = RaySides<S>::of(profile);
  return combine(norm, table, a, b);
}
template <class Profile, class S, int segments, int degree, int bits, class A, class B, class... More>
constexpr auto generalised_distance(const Profile& profile, const Table<S, segments, degree, bits>& table,
                                    const A& a, const B& b, const More&... more) {
  return generalised_distance(profile, table, generalised_distance(profile, table, a, b), more...);
}
template <class Profile, class S, int segments, int degree, int bits, class... Operand>
constexpr auto generalised_distance(const Profile&, const Table<S, segments, degree, bits>&&,
                                    const Operand&...) = delete;

}  // namespace nearfield
