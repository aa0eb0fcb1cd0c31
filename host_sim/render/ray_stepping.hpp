// The first place where a ray meets a field's surface.
#pragma once

#include <cstdint>

#include "render/scene_field.hpp"
#include "render/surface_box.hpp"

namespace nearfield::host {

struct Ray {
  Vector3d origin;     // m
  Vector3d direction;  // a unit vector
  Vector3d at(double t) const { return origin + t * direction; }
};

// From `from` to `to` along a ray, m; empty where from >= to.
struct Stretch {
  double from = 0.0, to = 0.0;
};
Stretch stretch_within(const Ray& ray, const Box3& box);

enum class Stepping : std::uint8_t { certified, bisection };

struct RayHit {
  bool hit = false;
  double t = 0.0;                           // m along the ray
  Stepping stepping = Stepping::certified;  // how this ray was followed to its end
};

struct SteppingSettings {
  Stepping stepping = Stepping::certified;
  double resolution = 1e-5;  // m for each m from the camera: nearer than this to the surface counts as on it
  double least_resolution = 1e-6;  // m
  double fixed_step = 1e-3;        // m, of bisection
};

// How near the surface may be, m, where the certificate cannot tell on which side a place lies; 0 where that
// is not known.
double undecided_distance(const SceneField& field);
// Certified where the field has a proof and undecided_distance() is at most `tolerance` m.
Stepping stepping_for(const SceneField& field, double tolerance);

// Certified: advances by free_radius() until that is below the resolution, and the first-order distance to
// the surface below twice that: nothing is jumped over however thin. Where the certificate's error leaves
// open whether there is a surface, steps are of 12.5 resolutions. A ray that is not at its end after 1200
// steps goes on by bisection. Bisection: steps of fixed_step, or more where that is proved to be free, halved
// where the sign changes: what is thinner may be missed. The hit is on the side from which the ray comes;
// where the stretch begins inside, at its beginning.
RayHit first_hit(const SceneField& field, const Ray& ray, const Stretch& stretch,
                 const SteppingSettings& settings);

// What of a light of the given half angle (rad) reaches the ray's origin, 0 to 1: the least first-order
// distance to the surface over the distance from the origin, 0 where the ray meets the surface. Steps are of
// what is proved to be free, and of fixed_step at least: near the surface the light is dim already.
double light_along(const SceneField& field, const Ray& ray, const Stretch& stretch, double half_angle,
                   const SteppingSettings& settings);

// The distance to the surface that a tangent of the field shows, 0 inside; `greatest` where that is farther,
// or no slope.
double first_order_distance(const FieldAnswer& answer, double greatest);
// The same at a place, without a gradient where the certificate says that the surface is farther.
double first_order_distance(const SceneField& field, const Vector3d& p, double greatest);

}  // namespace nearfield::host
