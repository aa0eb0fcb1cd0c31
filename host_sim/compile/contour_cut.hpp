// Where a contour, at which an object's influence is to end, cuts that object.
#pragma once

#include <cstddef>
#include <functional>
#include <optional>

#include "model/vector3d.hpp"

namespace nearfield::host {

// A field of rays that stands still, in the frame of the node that takes it.
struct RayField {
  std::function<double(const Vector3d&)> value;
  double rate = 0.0;   // per metre; infinite where no certificate bounds it
  double error = 0.0;  // of values
  std::size_t steps = 1;  // that an evaluation takes
};

struct ContourCut {
  Vector3d at;  // m
  double object = 0.0, contour = 0.0;
};

// A place within +-reach metres where the object is (at most 0.5) and the contour ends (at least 1). Space is divided into
// eighths where certificates leave room for one, down to reach / 512, of at most 400,000 cells, and no more than `allowance`
// steps are evaluated, which is lessened by them; what that does not find is missed.
std::optional<ContourCut> contour_cut(const RayField& object, const RayField& contour, double reach, std::size_t& allowance);

}  // namespace nearfield::host
