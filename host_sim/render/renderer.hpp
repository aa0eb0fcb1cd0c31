// Pictures of a field's surface in three dimensions.
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>

#include "draw/png.hpp"
#include "render/bands.hpp"
#include "render/colour.hpp"
#include "render/parallel_rows.hpp"
#include "render/ray_stepping.hpp"

namespace nearfield::host {

// z is up in the picture, or y where the camera looks along z.
struct Camera {
  Vector3d from{1.0, -1.0, 1.0}, at;  // m, not the same
  double field_of_view = 35.0;        // degrees, of the picture's height; above 0, below 180
};
// From the front, the right and above, so far away that a box fills a picture of these sides.
Camera camera_framing(const Box3& box, double field_of_view, std::size_t width, std::size_t height);

struct RenderSettings {
  std::size_t width = 640, height = 480;  // pixels
  Camera camera;
  Box3 surface;  // where the surface is: shadows are looked for near it
  Box3 drawn;    // what is drawn: the field is cut off at its faces. Within the field's domain
  std::optional<double> ground;     // m: z of the ground plane
  Colour colour{0.30, 0.42, 0.55};  // of the surface
  Bands bands;                      // on the ground and on cut faces, unless empty
  std::size_t steps = 512;          // across `drawn`, of bisection
  unsigned threads = 0;             // 0: as many as the machine has
};

struct Rendering {
  draw::RgbImage image;
  Stepping stepping = Stepping::certified;
  double undecided = 0.0;  // m from the surface within which nothing is certified; 0 where that is less than
                           // a quarter of a pixel
  std::uint64_t rays = 0;  // from the camera
  std::uint64_t bisected_rays = 0;  // of these, those that ended by bisection
  std::uint64_t surface_rays = 0;   // that met the surface
  std::uint64_t saturated_gradients =
      0;                        // of these, where the gradient saturates: their normals are of differences
  double ground_spacing = 0.0;  // m, between the lines on the ground; 0 without a ground
};

// One ray for each pixel, and four more where neighbours differ. The same settings give the same bytes,
// whatever the number of threads.
Rendering render(const SceneField& field, const RenderSettings& settings, const ReportProgress& report = {});

struct SurfaceNormal {
  Vector3d direction;               // of length 1, or {0, 0, 0}
  bool gradient_saturated = false;  // the gradient is more than 3 degrees off
};
// The normal of the surface at a place near it: the direction of the field's gradient; where there is none or
// it is doubtful that of differences over at most `reach` m each way.
SurfaceNormal surface_normal(const SceneField& field, const Vector3d& p, double reach);

}  // namespace nearfield::host
