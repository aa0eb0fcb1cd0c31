// Surfaces of revolution, generalised cylinders and random deformations (KW).
#pragma once

#include <nearfield/field/compose.hpp>

namespace nearfield {

// A ray function about the segment from `from` to `to`, metres, whose influence radius at the part t of it is radius f1(t);
// `profile` a table of along_profile(f1), which must outlive the field.
template <class S, int segments, int degree, int bits>
constexpr auto surface_of_revolution(const Table<S, segments, degree, bits>& profile, const Vector3<S>& from,
                                     const Vector3<S>& to, detail::NotDeduced<S> radius) {
  const Capsule<S> segment(from, to, S{});
  const RaySegment<S> ray{segment, RayRadius<S>(radius)};
  return combine(ScaleAlong<S>(segment, ray_cut<S>(profile.facts)), profile, ray);
}
template <class S, int segments, int degree, int bits>
constexpr auto surface_of_revolution(const Table<S, segments, degree, bits>&&, const Vector3<S>&, const Vector3<S>&,
                                     detail::NotDeduced<S>) = delete;

// Its radius times f3 of the angle about the local z axis, `section` a table of about_profile(f3); see ScaleAbout for the core
// and the twist. About the z axis: a generalised cylinder.
template <class S, int segments, int degree, int bits, class A>
constexpr auto scaled_about_axis(const Table<S, segments, degree, bits>& section, detail::NotDeduced<S> core, const A& a,
                                 typename ScaleAbout<S>::Twist turns_per_metre = {}) {
  return combine(ScaleAbout<S>::axis(section.facts, core, turns_per_metre), section, a);
}
template <class S, int segments, int degree, int bits, class A>
constexpr auto scaled_about_axis(const Table<S, segments, degree, bits>&&, detail::NotDeduced<S>, const A&,
                                 typename ScaleAbout<S>::Twist = {}) = delete;

// The same by the angle about a circle of this radius in the plane z = 0.
template <class S, int segments, int degree, int bits, class A>
constexpr auto scaled_about_circle(const Table<S, segments, degree, bits>& section, detail::NotDeduced<S> core,
                                   detail::NotDeduced<S> radius, const A& a) {
  return combine(ScaleAbout<S>::circle(section.facts, core, radius), section, a);
}
template <class S, int segments, int degree, int bits, class A>
constexpr auto scaled_about_circle(const Table<S, segments, degree, bits>&&, detail::NotDeduced<S>, detail::NotDeduced<S>,
                                   const A&) = delete;

// Its radius times a function of the distance from the local z axis, up to `limit` metres; `profile` a table of
// along_profile() of it.
template <class S, int segments, int degree, int bits, class A>
constexpr auto scaled_from_axis(const Table<S, segments, degree, bits>& profile, detail::NotDeduced<S> limit,
                                const A& a) {
  return combine(ScaleFromAxis<S>(limit, ray_cut<S>(profile.facts)), profile, a);
}
template <class S, int segments, int degree, int bits, class A>
constexpr auto scaled_from_axis(const Table<S, segments, degree, bits>&&, detail::NotDeduced<S>, const A&) = delete;

// F (1 + c N) of an intensity, d - c N of a distance: see SolidNoise.
template <class A>
constexpr auto with_noise(const A& a, detail::NotDeduced<typename A::Scalar> amplitude, Fixed<16> cells_per_metre,
                          uint32_t octaves = 1, uint32_t seed = 0) {
  using S = typename A::Scalar;
  static_assert(A::kind == Kind::intensity || A::kind == Kind::distance, "noise is of intensities and distances");
  const SolidNoise<S, A::kind> noise(amplitude, cells_per_metre, octaves, seed);
  if constexpr (A::kind == Kind::intensity) return combine(NoiseIntensity<S>{noise}, a);
  else return combine(NoiseDistance<S>{noise}, a);
}

}  // namespace nearfield
