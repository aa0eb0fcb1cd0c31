// On which side of a circular cone about an axis a point lies, without a root.
#pragma once

#include <nearfield/number/sqrt.hpp>

namespace nearfield {

// Whether height / sqrt(squares) < sine. height: of a point along the axis; squares: of its distance from the
// apex; |sine| <= 1. Exact but for points nearer to that cone than a unit in the last place (float: a
// rounding unit); on it, and in the apex, true for a sine above 0 alone.
template <int F> constexpr bool is_lower(Fixed<F> height, uint64_t squares, Fixed<30> sine) {
  const int32_t h = height.raw(), s = sine.raw();
  const uint32_t sine_squared =
      static_cast<uint32_t>(static_cast<uint64_t>(static_cast<int64_t>(s) * s) >> 29);  // Q31
  const uint64_t bound = (squares >> 32) * sine_squared + ((squares & 0xffffffffu) * sine_squared >> 32);
  const uint64_t square = static_cast<uint64_t>(static_cast<int64_t>(h) * h) >> 1;
  if (h < 0) return s >= 0 || square > bound;
  return s > 0 && square <= bound;
}
constexpr bool is_lower(float height, float squares, float sine) {
  const float bound = sine * sine * squares, square = height * height;
  return height < 0.0f ? sine >= 0.0f || square > bound : sine > 0.0f && square <= bound;
}

}  // namespace nearfield
