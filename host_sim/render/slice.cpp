#include "render/slice.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "draw/axis.hpp"
#include "draw/number_text.hpp"
#include "render/renderer.hpp"
#include "render/view.hpp"
#include "text/number.hpp"

namespace nearfield::host {
namespace {

constexpr double pixels_a_sample = 1.25;
constexpr double pixels_a_slope = 34.0;
constexpr int greatest_line_count = 200;  // each side of the surface

constexpr double Vector3d::*coordinates[] = {&Vector3d::x, &Vector3d::y, &Vector3d::z};
constexpr const char* names[] = {"x", "y", "z"};

double clamped_share(const std::vector<double>& values, double share) {
  std::vector<double> sorted;
  for (const double value : values) {
    if (std::isfinite(value)) sorted.push_back(std::abs(value));
  }
  if (sorted.empty()) return 0.0;
  const auto at =
      sorted.begin() + static_cast<std::ptrdiff_t>(share * static_cast<double>(sorted.size() - 1));
  std::nth_element(sorted.begin(), at, sorted.end());
  return *at;
}

std::string place_of(const Plane& plane) {
  for (unsigned axis = 0; axis < 3; ++axis) {
    if (plane.name_u == names[axis] || plane.name_v == names[axis] || plane.name_u == "u") continue;
    return std::string(names[axis]) + " = " + draw::short_text(plane.origin.*coordinates[axis], 4) + " m";
  }
  const auto list = [](const Vector3d& p) {
    return draw::short_text(p.x, 3) + ", " + draw::short_text(p.y, 3) + ", " + draw::short_text(p.z, 3);
  };
  return "plane through " + list(plane.origin) + " m, normal " + list(cross(plane.u, plane.v));
}

}  // namespace

Plane coordinate_plane(unsigned axis, double value) {
  const unsigned u = axis == 0 ? 1 : 0, v = axis == 2 ? 1 : 2;
  Plane plane;
  plane.origin.*coordinates[axis] = value;
  plane.u = {};
  plane.u.*coordinates[u] = 1.0;
  plane.v = {};
  plane.v.*coordinates[v] = 1.0;
  plane.name_u = names[u];
  plane.name_v = names[v];
  return plane;
}

Plane plane_through(const Vector3d& origin, const Vector3d& normal) {
  const Vector3d towards = normalised(normal);
  const bool along_z = std::abs(towards.z) > 0.9999;
  Plane plane;
  plane.origin = origin;
  plane.u = normalised(cross(along_z ? Vector3d{0.0, 1.0, 0.0} : Vector3d{0.0, 0.0, 1.0}, towards));
  plane.v = cross(towards, plane.u);
  plane.name_u = "u";
  plane.name_v = "v";
  return plane;
}

void frame_surface(const std::optional<Box3>& surface, SliceSettings& settings) {
  const Box3 box = surface.value_or(Box3{{-0.5, -0.5, -0.5}, {0.5, 0.5, 0.5}});
  double least_u = std::numeric_limits<double>::max(), greatest_u = -least_u, least_v = least_u,
         greatest_v = -least_u;
  for (unsigned i = 0; i < 8; ++i) {
    const Vector3d corner{(i & 1U) != 0 ? box.high.x : box.low.x, (i & 2U) != 0 ? box.high.y : box.low.y,
                          (i & 4U) != 0 ? box.high.z : box.low.z};
    const double u = dot(corner - settings.plane.origin, settings.plane.u);
    const double v = dot(corner - settings.plane.origin, settings.plane.v);
    least_u = std::min(least_u, u);
    greatest_u = std::max(greatest_u, u);
    least_v = std::min(least_v, v);
    greatest_v = std::max(greatest_v, v);
  }
  const draw::Rectangle frame = draw::slice_frame(settings.width, settings.height);
  settings.middle_u = 0.5 * (least_u + greatest_u);
  settings.middle_v = 0.5 * (least_v + greatest_v);
  settings.width_metres =
      1.5 * std::max(greatest_u - least_u, (greatest_v - least_v) * frame.width / frame.height);
}

draw::SlicePicture slice_of(const SceneField& field, const SliceSettings& settings, const std::string& title,
                            const ReportProgress& report) {
  const Plane& plane = settings.plane;
  draw::SlicePicture picture;
  picture.title = title;
  picture.width = settings.width;
  picture.height = settings.height;
  picture.axis_u = plane.name_u + " (m)";
  picture.axis_v = plane.name_v + " (m)";
  const draw::Rectangle frame = draw::slice_frame(settings.width, settings.height);
  const double half_u = 0.5 * settings.width_metres, half_v = half_u * frame.height / frame.width;
  picture.window = {settings.middle_u - half_u, settings.middle_u + half_u, settings.middle_v - half_v,
                    settings.middle_v + half_v};

  draw::SampledGrid& grid = picture.field;
  grid.origin = {picture.window.left, picture.window.bottom};
  grid.columns = static_cast<std::size_t>(std::ceil(frame.width / pixels_a_sample)) + 1;
  grid.rows = static_cast<std::size_t>(std::ceil(frame.height / pixels_a_sample)) + 1;
  grid.step_x = 2.0 * half_u / static_cast<double>(grid.columns - 1);
  grid.step_y = 2.0 * half_v / static_cast<double>(grid.rows - 1);
  grid.values.assign(grid.columns * grid.rows, std::numeric_limits<double>::quiet_NaN());
  for_each_row(
      grid.rows, settings.threads,
      [&](std::size_t row) {
        for (std::size_t column = 0; column < grid.columns; ++column) {
          const draw::Point at = grid.position(column, row);
          const Vector3d p = plane.at(at.x, at.y);
          if (field.in_domain(p)) grid.values[row * grid.columns + column] = field.outward(p);
        }
      },
      report);

  // Most of the plane, not the least and greatest values: algebraic ones may be very large in a corner.
  const double most = clamped_share(grid.values, 0.9);
  picture.spacing = settings.spacing.value_or(draw::round_up(most / settings.levels));
  double least = 0.0, greatest = 0.0;
  for (const double f : grid.values) {
    if (!std::isfinite(f)) continue;
    least = std::min(least, f);
    greatest = std::max(greatest, f);
  }
  const auto lines_to = [&](double f) {
    return static_cast<int>(
        std::min<double>(settings.spacing ? greatest_line_count : 2 * settings.levels, f / picture.spacing));
  };
  picture.outer_count = lines_to(greatest);
  picture.inner_count = lines_to(-least);
  if (settings.layers) {
    const Bands bands = settings.bands.empty() ? even_bands(picture.spacing) : settings.bands;
    picture.shade = [bands](double f) { return bands.shade(f); };
  }
  if (settings.slopes) {
    const double step = 2.0 * half_u * pixels_a_slope / frame.width;
    for (double v = picture.window.bottom + 0.5 * step; v < picture.window.top; v += step) {
      for (double u = picture.window.left + 0.5 * step; u < picture.window.right; u += step) {
        const Vector3d p = plane.at(u, v);
        if (!field.in_domain(p)) continue;
        const FieldAnswer answer = field.at(p);
        const SurfaceNormal normal = surface_normal(field, p, 0.01 * step);
        if (normal.gradient_saturated) ++picture.saturated_slopes;
        const Vector3d gradient =
            answer.gradient_doubtful ? length(answer.gradient) * normal.direction : answer.gradient;
        picture.slopes.push_back({{u, v}, {dot(gradient, plane.u), dot(gradient, plane.v)}});
      }
    }
  }
  picture.note = std::string(name_of(field.kind())) + "; " + place_of(plane) + "; contours every " +
                 format_number(picture.spacing) + (field.kind() == Kind::distance ? " m" : "");
  return picture;
}

}  // namespace nearfield::host
