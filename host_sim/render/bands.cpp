#include "render/bands.hpp"

#include <cmath>

namespace nearfield::host {

double Bands::shade(double f) const {
  double sum = 0.0, greatest = 0.0;
  for (const Wave& wave : waves_) {
    sum += wave.amplitude * (std::cos(wave.frequency * f) + 1.0);
    greatest += 2.0 * wave.amplitude;
  }
  return greatest > 0.0 ? sum / greatest : 1.0;
}

Bands even_bands(double spacing) {
  constexpr double turn = 6.283185307179586;
  return Bands({{1.0, turn / spacing}, {0.4, turn / (5.0 * spacing)}});
}

}  // namespace nearfield::host
