// What a caller hands a field with each query: poses and parameters, by number.
#pragma once

#include <nearfield/modify/frame.hpp>

namespace nearfield {

// Pointers may be null where the field has no such slots. Queries check the counts, and up to the last slot that the field
// uses all poses (valid_pose()) and parameters (in [0, 1]), and answer `invalid` if any does not fit; evaluate() does not.
template <class S> struct Slots {
  const Pose<S>* poses = nullptr;
  uint32_t pose_count = 0;
  const S* parameters = nullptr;
  uint32_t parameter_count = 0;

  constexpr Slots() = default;
  constexpr Slots(const Pose<S>* first_pose, uint32_t count = 0) : poses(first_pose), pose_count(count) {}
  constexpr Slots(const Pose<S>* first_pose, uint32_t count_of_poses, const S* first_parameter, uint32_t count_of_parameters)
      : poses(first_pose), pose_count(count_of_poses), parameters(first_parameter),
        parameter_count(count_of_parameters) {}
};

inline constexpr uint32_t kParameterLimit = 64;  // parameter slots of a field

}  // namespace nearfield
