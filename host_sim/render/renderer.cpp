#include "render/renderer.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

#include "draw/axis.hpp"
#include "render/view.hpp"

namespace nearfield::host {
namespace {

constexpr double light_half_angle = 0.055;                                 // rad, of the lamp
constexpr std::array<double, 4> openness_reaches{0.03, 0.08, 0.18, 0.35};  // of the surface's radius
// Places of a pixel where neighbours differ, besides its middle: no two in a row or a column, so that edges
// of any direction get even steps.
constexpr double extra_rays[4][2] = {{0.375, 0.125}, {0.875, 0.375}, {0.125, 0.625}, {0.625, 0.875}};
constexpr Colour horizon{0.80, 0.83, 0.87}, zenith{0.93, 0.945, 0.96}, ground_colour{0.74, 0.74, 0.73};
constexpr Colour lamp{1.02, 0.98, 0.92}, sky_light{0.40, 0.43, 0.47}, bounced_light{0.20, 0.19, 0.18};

enum class Seen : std::uint8_t { sky, ground, surface, cut };

struct Look {
  Seen seen = Seen::sky;
  Colour colour;
  Vector3d normal;
  double distance = 0.0;  // m from the camera
  bool bisected = false;
  bool gradient_saturated = false;
};

struct RayCounts {
  std::uint64_t rays = 0, bisected = 0, surface = 0, saturated = 0;
  void add(const Look& look) {
    ++rays;
    bisected += look.bisected ? 1U : 0U;
    surface += look.seen == Seen::surface ? 1U : 0U;
    saturated += look.gradient_saturated ? 1U : 0U;
  }
};

double smooth_step(double from, double to, double x) {
  const double t = std::clamp((x - from) / (to - from), 0.0, 1.0);
  return t * t * (3.0 - 2.0 * t);
}

double distance_to(const Box3& box, const Vector3d& p) {
  const auto beyond = [](double x, double low, double high) { return std::max({0.0, low - x, x - high}); };
  return length({beyond(p.x, box.low.x, box.high.x), beyond(p.y, box.low.y, box.high.y),
                 beyond(p.z, box.low.z, box.high.z)});
}

class Renderer {
 public:
  Renderer(const SceneField& field, const RenderSettings& settings)
      : field_(field), settings_(settings), view_(settings.camera, settings.width, settings.height) {
    const Vector3d size = settings.surface.size();
    radius_ = std::max(0.5 * length(size), 1e-4);
    const double distance = length(settings.camera.at - settings.camera.from);
    footprint_ = view_.pixel_angle();
    stepping_.stepping = stepping_for(field, 0.02 * radius_);
    stepping_.resolution = 0.02 * footprint_;
    stepping_.least_resolution = 1e-3 * footprint_ * distance;
    looked_at_ = stepping_.stepping == Stepping::certified
                     ? settings.drawn
                     : intersection(grown(settings.surface, 0.05 * radius_), settings.drawn);
    stepping_.fixed_step = length(looked_at_.size()) / static_cast<double>(settings.steps);
    shadow_stepping_ = stepping_;
    shadow_stepping_.fixed_step =
        stepping_.stepping == Stepping::certified ? 0.5 * footprint_ * distance : 2.0 * stepping_.fixed_step;
    shadow_box_ = intersection(grown(settings.surface, 0.25 * radius_), settings.drawn);
    const Vector3d forward = view_.forward(), right = view_.right();
    to_lamp_ = normalised(-0.45 * forward + -0.75 * right + Vector3d{0.0, 0.0, 1.15});
    ground_spacing_ = draw::round_up(0.2 * radius_);
  }

  Rendering picture(const ReportProgress& report) {
    Rendering result;
    result.stepping = stepping_.stepping;
    const double undecided = undecided_distance(field_);
    if (undecided > 12.5 * stepping_.resolution * length(settings_.camera.at - settings_.camera.from))
      result.undecided = undecided;
    if (settings_.ground) result.ground_spacing = ground_spacing_;
    result.image = {settings_.width, settings_.height,
                    std::vector<std::uint8_t>(3 * settings_.width * settings_.height)};
    looks_.resize(settings_.width * settings_.height);
    std::vector<RayCounts> counts(settings_.height);
    for_each_row(
        settings_.height, settings_.threads,
        [&](std::size_t y) {
          for (std::size_t x = 0; x < settings_.width; ++x) {
            looks_[y * settings_.width + x] = look(view_.ray(real(x) + 0.5, real(y) + 0.5));
            counts[y].add(look_at(x, y));
          }
        },
        [&](double done) {
          if (report) report(0.5 * done);
        });
    for_each_row(
        settings_.height, settings_.threads,
        [&](std::size_t y) {
          for (std::size_t x = 0; x < settings_.width; ++x) {
            const Colour colour = smoothed(x, y, counts[y]);
            std::uint8_t* byte = result.image.bytes.data() + 3 * (y * settings_.width + x);
            byte[0] = srgb_byte(colour.red);
            byte[1] = srgb_byte(colour.green);
            byte[2] = srgb_byte(colour.blue);
          }
        },
        [&](double done) {
          if (report) report(0.5 + 0.5 * done);
        });
    for (const RayCounts& row : counts) {
      result.rays += row.rays;
      result.bisected_rays += row.bisected;
      result.surface_rays += row.surface;
      result.saturated_gradients += row.saturated;
    }
    return result;
  }

 private:
  static double real(std::size_t n) { return static_cast<double>(n); }
  const Look& look_at(std::size_t x, std::size_t y) const { return looks_[y * settings_.width + x]; }

  // -- edges between pixels
  static bool differ(const Look& a, const Look& b) {
    if (a.seen != b.seen) return true;
    const auto shown = [](const Colour& c) {
      return std::sqrt(std::max(0.0, 0.3 * c.red + 0.6 * c.green + 0.1 * c.blue));
    };
    if (std::abs(shown(a.colour) - shown(b.colour)) > 0.04) return true;
    return a.seen == Seen::surface &&
           (dot(a.normal, b.normal) < 0.9 ||
            std::abs(a.distance - b.distance) > 0.05 * std::min(a.distance, b.distance));
  }
  bool at_edge(std::size_t x, std::size_t y) const {
    const Look& own = look_at(x, y);
    for (std::size_t v = y == 0 ? 0 : y - 1; v <= std::min(y + 1, settings_.height - 1); ++v) {
      for (std::size_t u = x == 0 ? 0 : x - 1; u <= std::min(x + 1, settings_.width - 1); ++u) {
        if (differ(own, look_at(u, v))) return true;
      }
    }
    return false;
  }
  Colour smoothed(std::size_t x, std::size_t y, RayCounts& counts) const {
    if (!at_edge(x, y)) return look_at(x, y).colour;
    Colour sum = look_at(x, y).colour;
    for (const auto& [u, v] : extra_rays) {
      const Look one = look(view_.ray(real(x) + u, real(y) + v));
      sum = sum + one.colour;
      counts.add(one);
    }
    return 0.2 * sum;
  }

  // -- one ray
  Look look(const Ray& ray) const {
    Look result;
    result.colour = sky(ray);
    Stretch stretch = stretch_within(ray, looked_at_);
    const double ground_at = ground_distance(ray);
    stretch.to = std::min(stretch.to, ground_at);
    const RayHit hit = first_hit(field_, ray, stretch, stepping_);
    result.bisected = hit.stepping == Stepping::bisection;
    if (hit.hit) {
      const bool cut = hit.t <= stretch.from;
      result.seen = cut ? Seen::cut : Seen::surface;
      result.distance = hit.t;
      const Vector3d p = ray.at(hit.t);
      const double reach = footprint_ * hit.t;
      if (cut) {
        result.normal = face_normal(p, ray);
      } else {
        const SurfaceNormal normal = surface_normal(field_, p, reach);
        result.normal = facing(normal.direction, ray);
        result.gradient_saturated = normal.gradient_saturated;
      }
      result.colour =
          lit(p, result.normal, cut ? cut_colour(p) : settings_.colour, ray, reach, cut ? 0.0 : 1.0);
    } else if (ground_at < 1e9) {
      result.seen = Seen::ground;
      result.distance = ground_at;
      result.normal = {0.0, 0.0, 1.0};
      const Vector3d p = ray.at(ground_at);
      const double fade = smooth_step(3.0 * radius_, 9.0 * radius_, length(p - settings_.surface.middle()));
      if (fade < 1.0) {
        const Colour ground = lit(p, result.normal, ground_paint(p, ray), ray, footprint_ * ground_at, 0.0);
        result.colour = mixed(ground, result.colour, fade);
      }
    }
    return result;
  }

  double ground_distance(const Ray& ray) const {
    if (!settings_.ground || !(ray.direction.z < -1e-6) || !(ray.origin.z > *settings_.ground)) return 1e9;
    return std::min(1e9, (*settings_.ground - ray.origin.z) / ray.direction.z);
  }
  static Colour sky(const Ray& ray) {
    return mixed(horizon, zenith, smooth_step(-0.25, 0.6, ray.direction.z));
  }

  static Vector3d facing(const Vector3d& normal, const Ray& ray) {
    return length(normal) > 0.0 ? normal : -1.0 * ray.direction;
  }
  // Of the face of what is drawn that a point lies on; towards the camera when the camera is inside.
  Vector3d face_normal(const Vector3d& p, const Ray& ray) const {
    Vector3d normal = -1.0 * ray.direction;
    double nearest = 1e-6 * (1.0 + radius_);
    for (double Vector3d::*x : {&Vector3d::x, &Vector3d::y, &Vector3d::z}) {
      for (const double side : {-1.0, 1.0}) {
        const double distance = std::abs(p.*x - (side < 0.0 ? looked_at_.low.*x : looked_at_.high.*x));
        if (distance >= nearest) continue;
        nearest = distance;
        normal = {};
        normal.*x = side;
      }
    }
    return normal;
  }

  // -- paint
  Colour band_paint(double f) const {
    const BandColours colours = f < 0.0 ? band_colours_inside : band_colours_outside;
    return mixed(*colour_of(colours.dark), *colour_of(colours.light), settings_.bands.shade(f));
  }
  Colour cut_colour(const Vector3d& p) const {
    if (!settings_.bands.empty()) return band_paint(field_.outward(p));
    return mixed(settings_.colour, {0.85, 0.85, 0.85}, 0.55);
  }
  Colour ground_paint(const Vector3d& p, const Ray& ray) const {
    if (!settings_.bands.empty() && field_.in_domain(p)) {
      return mixed({0.0, 0.0, 0.0}, band_paint(field_.outward(p)), 0.92);
    }
    const double across = footprint_ * length(p - ray.origin) / std::max(0.05, -ray.direction.z);
    const double line = std::max(ground_line(p.x, across), ground_line(p.y, across));
    return (1.0 - 0.16 * line) * ground_colour;
  }
  // How much of a stretch `across` long about x is covered by lines.
  double ground_line(double x, double across) const {
    const double half = 0.012 * ground_spacing_;
    const double off = std::abs(x - ground_spacing_ * std::round(x / ground_spacing_));
    const double covered = std::min(off + 0.5 * across, half) - std::max(off - 0.5 * across, -half);
    return std::clamp(covered / across, 0.0, 1.0);
  }

  // -- light
  double lamp_light(const Vector3d& p) const {
    const Ray ray{p, to_lamp_};
    const Stretch stretch = stretch_within(ray, shadow_box_);
    if (!(stretch.from < stretch.to)) return 1.0;
    const double light = light_along(field_, ray, stretch, light_half_angle, shadow_stepping_);
    return light * light * (3.0 - 2.0 * light);
  }
  // The share of the sky that neighbours leave free, from the first-order distance at places along the
  // normal.
  double openness(const Vector3d& p, const Vector3d& normal) const {
    double hidden = 0.0;
    for (const double share : openness_reaches) {
      const double reach = share * radius_;
      const Vector3d at = p + reach * normal;
      const double near = 1.0 - smooth_step(0.0, 0.25 * radius_, distance_to(settings_.surface, at));
      if (near <= 0.0 || !settings_.drawn.contains(at)) continue;
      hidden += near * (1.0 - first_order_distance(field_, at, reach) / reach);
    }
    return 1.0 - 0.85 * hidden / static_cast<double>(openness_reaches.size());
  }
  Colour lit(const Vector3d& p, const Vector3d& normal, const Colour& paint, const Ray& ray, double reach,
             double gloss) const {
    const Vector3d above = p + std::max(2.0 * reach, 4.0 * stepping_.least_resolution) * normal;
    const double towards_lamp = dot(normal, to_lamp_);
    const double from_lamp = towards_lamp > 0.0 ? lamp_light(above) : 0.0;
    const double open = openness(p, normal);
    Colour light = std::max(0.0, towards_lamp) * from_lamp * lamp;
    light = light + open * (0.5 + 0.5 * normal.z) * sky_light + open * (0.5 - 0.5 * normal.z) * bounced_light;
    Colour result = paint * light;
    if (gloss > 0.0) {
      const Vector3d half = normalised(to_lamp_ - ray.direction);
      const double shine = std::pow(std::max(0.0, dot(normal, half)), 60.0);
      const double grazing = std::pow(1.0 - std::clamp(-dot(normal, ray.direction), 0.0, 1.0), 4.0);
      result = result + gloss * 0.16 * shine * from_lamp * lamp + gloss * 0.12 * grazing * open * zenith;
    }
    return result;
  }

  const SceneField& field_;
  const RenderSettings& settings_;
  View view_;
  double radius_ = 1.0, footprint_ = 1e-3, ground_spacing_ = 0.1;
  SteppingSettings stepping_, shadow_stepping_;
  Box3 looked_at_, shadow_box_;
  Vector3d to_lamp_;
  std::vector<Look> looks_;
};

}  // namespace

SurfaceNormal surface_normal(const SceneField& field, const Vector3d& p, double reach) {
  const FieldAnswer answer = field.at(p);
  const double slope = length(answer.gradient);
  if (slope > 1e-6 && !answer.gradient_doubtful) return {1.0 / slope * answer.gradient, false};
  // A large slope leads out of the number range soon.
  const double near = answer.gradient_doubtful ? 0.02 * reach : reach;
  const auto change = [&](const Vector3d& by) {
    return field.in_domain(p + by) && field.in_domain(p - by) ? field.outward(p + by) - field.outward(p - by)
                                                              : 0.0;
  };
  const Vector3d difference{change({near, 0.0, 0.0}), change({0.0, near, 0.0}), change({0.0, 0.0, near})};
  const double size = length(difference);
  if (!(size > 0.0)) return {};
  constexpr double cosine = 0.9986;  // of 3 degrees
  const bool off = answer.gradient_doubtful && dot(difference, answer.gradient) < cosine * size * slope;
  return {1.0 / size * difference, off};
}

Rendering render(const SceneField& field, const RenderSettings& settings, const ReportProgress& report) {
  return Renderer(field, settings).picture(report);
}

}  // namespace nearfield::host
