// Layers of a field: sum a_j (cos(w_j f) + 1), as Akleman and Chen have it. Of even thickness where |gradient
// f| is.
#pragma once

#include <string>
#include <vector>

namespace nearfield::host {

struct Wave {
  double amplitude = 1.0;  // a, above 0
  double frequency = 1.0;  // w, rad for each unit of f; above 0
};

class Bands {
 public:
  Bands() = default;
  explicit Bands(std::vector<Wave> waves) : waves_(std::move(waves)) {}

  bool empty() const { return waves_.empty(); }
  // The sum over the greatest that it can be: 0 to 1, 1 where f is 0.
  double shade(double f) const;

 private:
  std::vector<Wave> waves_;
};

// A wave each `spacing` of f, and every fifth stands out.
Bands even_bands(double spacing);

// sRGB `#RRGGBB` from dark to light at shades 0 and 1, inside and outside of the surface.
struct BandColours {
  const char* dark;
  const char* light;
};
inline constexpr BandColours band_colours_inside{"#B4552D", "#F9E3D3"};
inline constexpr BandColours band_colours_outside{"#5B8DB0", "#F3F7FA"};

}  // namespace nearfield::host
