#include "render/ray_stepping.hpp"

#include <algorithm>
#include <cmath>

namespace nearfield::host {
namespace {

constexpr int greatest_step_count = 1200;
constexpr double least_advance = 1e-9;      // m
constexpr double decided_reach = 2.0;       // resolutions within which a place is on the surface
constexpr double undecided_step = 12.5;     // resolutions
constexpr double least_from_origin = 1e-6;  // m, of light
constexpr int halvings = 36;

double resolution_at(double t, const SteppingSettings& settings) {
  return std::max(settings.least_resolution, settings.resolution * t);
}

// The end of [outside, inside] that is outside, once that is halved.
double halved(const SceneField& field, const Ray& ray, double outside, double inside) {
  for (int i = 0; i < halvings; ++i) {
    const double middle = 0.5 * (outside + inside);
    (field.inside(ray.at(middle)) ? inside : outside) = middle;
  }
  return outside;
}

RayHit by_fixed_steps(const SceneField& field, const Ray& ray, double from, double to, double step) {
  // Where more than a step is proved to be free, that is taken.
  double free = field.free_radius_where(field.outward(ray.at(from)));
  for (double before = from; before < to;) {
    const double t = std::min(before + std::max(step, free), to), f = field.outward(ray.at(t));
    if (f < 0.0) return {true, halved(field, ray, before, t), Stepping::bisection};
    free = field.free_radius_where(f);
    before = t;
  }
  return {false, to, Stepping::bisection};
}

}  // namespace

Stretch stretch_within(const Ray& ray, const Box3& box) {
  Stretch stretch{0.0, 1e9};
  for (double Vector3d::*x : {&Vector3d::x, &Vector3d::y, &Vector3d::z}) {
    const double origin = ray.origin.*x, slope = ray.direction.*x;
    if (std::abs(slope) < 1e-12) {
      if (origin < box.low.*x || origin > box.high.*x) return {};
      continue;
    }
    const double a = (box.low.*x - origin) / slope, b = (box.high.*x - origin) / slope;
    stretch.from = std::max(stretch.from, std::min(a, b));
    stretch.to = std::min(stretch.to, std::max(a, b));
  }
  return stretch;
}

double first_order_distance(const FieldAnswer& answer, double greatest) {
  const double slope = length(answer.gradient);
  if (answer.outward <= 0.0) return 0.0;
  return answer.outward < greatest * slope ? answer.outward / slope : greatest;
}

double first_order_distance(const SceneField& field, const Vector3d& p, double greatest) {
  const double outward = field.outward(p);
  if (outward <= 0.0) return 0.0;
  return field.free_radius_where(outward) >= greatest ? greatest
                                                      : first_order_distance(field.at(p), greatest);
}

double undecided_distance(const SceneField& field) {
  const FieldProof& proof = field.proof();
  return proof.rate ? proof.error / *proof.rate : 0.0;
}

Stepping stepping_for(const SceneField& field, double tolerance) {
  if (!field.certified()) return Stepping::bisection;
  const FieldProof& proof = field.proof();
  // An intensity without a rate: its error moves the surface by as much as its slope there says, which is not
  // known; it has to be far below the level.
  if (!proof.rate) return proof.error <= 1e-3 ? Stepping::certified : Stepping::bisection;
  return undecided_distance(field) <= tolerance ? Stepping::certified : Stepping::bisection;
}

RayHit first_hit(const SceneField& field, const Ray& ray, const Stretch& stretch,
                 const SteppingSettings& settings) {
  if (!(stretch.from < stretch.to)) return {};
  if (field.inside(ray.at(stretch.from))) return {true, stretch.from, settings.stepping};
  if (settings.stepping == Stepping::bisection) {
    return by_fixed_steps(field, ray, stretch.from, stretch.to, settings.fixed_step);
  }
  double t = stretch.from, before = t, guess = 0.25 * (stretch.to - stretch.from);
  for (int step = 0; step < greatest_step_count; ++step) {
    const Vector3d p = ray.at(t);
    const double radius = field.free_radius(p, guess), resolution = resolution_at(t, settings);
    if (radius < resolution) {
      const FieldAnswer answer = field.at(p);
      if (answer.outward < 0.0) return {true, halved(field, ray, before, t), Stepping::certified};
      if (first_order_distance(answer, decided_reach * resolution) < decided_reach * resolution) {
        return {true, t, Stepping::certified};
      }
    }
    before = t;
    // Within the certificate's error of the surface nothing is proved.
    t += radius < least_advance ? undecided_step * resolution : radius;
    if (t >= stretch.to) return {false, stretch.to, Stepping::certified};
    guess = 1.5 * radius;
  }
  return by_fixed_steps(field, ray, t, stretch.to, settings.fixed_step);
}

double light_along(const SceneField& field, const Ray& ray, const Stretch& stretch, double half_angle,
                   const SteppingSettings& settings) {
  const double width = std::tan(half_angle);
  double light = 1.0, t = std::max(stretch.from, least_from_origin),
         guess = 0.25 * (stretch.to - stretch.from);
  for (int step = 0; step < greatest_step_count && t < stretch.to; ++step) {
    const Vector3d p = ray.at(t);
    const double outward = field.outward(p);
    if (outward < 0.0) return 0.0;
    const double by_rate = field.free_radius_where(outward);
    // A slope is never above the rate: elsewhere the gradient would not make it darker.
    if (by_rate < light * width * t) {
      light = std::min(light, first_order_distance(field.at(p), width * t) / (width * t));
      if (light < 0.01) return 0.0;
    }
    const double radius = field.kind() == Kind::intensity ? field.free_radius(p, guess) : by_rate;
    guess = 1.5 * radius;
    t += std::max(radius, settings.fixed_step);
  }
  return light;
}

}  // namespace nearfield::host
