// A field in a plane, ready to be drawn.
#pragma once

#include <optional>
#include <string>

#include "draw/slice_picture.hpp"
#include "render/bands.hpp"
#include "render/parallel_rows.hpp"
#include "render/surface_box.hpp"

namespace nearfield::host {

// origin + u U + v V; U and V are perpendicular and of length 1. Coordinates u, v are m.
struct Plane {
  Vector3d origin, u{1.0, 0.0, 0.0}, v{0.0, 1.0, 0.0};
  std::string name_u = "x", name_v = "y";

  Vector3d at(double along_u, double along_v) const { return origin + along_u * u + along_v * v; }
};
// The plane x, y or z (`axis` 0, 1, 2) = value; u and v are the two other coordinates in the order x, y, z.
Plane coordinate_plane(unsigned axis, double value);
// The plane through a point, seen from where the normal (not 0) points to, with z upwards, or y where it is
// along z. The point has the coordinates 0, 0.
Plane plane_through(const Vector3d& origin, const Vector3d& normal);

struct SliceSettings {
  std::size_t width = 640, height = 480;  // pixels, of the whole picture
  Plane plane;
  double middle_u = 0.0, middle_v = 0.0;  // m, of the frame
  double width_metres = 1.0;              // of the frame
  std::optional<double> spacing;  // of contours and layers, in units of the value; default: by the field
  int levels = 10;                // contours outside, and at most inside; the default spacing makes so many
  bool layers = false;            // by `bands`, or even ones
  Bands bands;
  bool slopes = false;
  unsigned threads = 0;
};

// The middle and the width with which a plane shows all of a surface within `surface`; 1 m about the origin
// where it does not meet the plane.
void frame_surface(const std::optional<Box3>& surface, SliceSettings& settings);

// `title` is the picture's; its note tells kind, plane and spacing.
draw::SlicePicture slice_of(const SceneField& field, const SliceSettings& settings, const std::string& title,
                            const ReportProgress& report = {});

}  // namespace nearfield::host
