// A scene with its robot and person, compiled for the player.
#pragma once

#include <string>
#include <vector>

#include "compile/field_compiler.hpp"
#include "compile/robot_compiler.hpp"
#include "model/scene_description.hpp"
#include "work_cell/work_cell.hpp"

namespace nearfield::host {

using work_cell::Q;

// Keyframes of a robot's joints, as vectors that a Track can refer to.
struct CompiledTrack {
  std::vector<std::uint32_t> times;  // microseconds
  std::vector<Q> values;
  std::uint32_t variables = 0;
};

// Owns everything that a work_cell::WorkCell refers to.
struct CompiledWorkCell {
  CompiledRobot<Q> arm, person;  // person: without bodies if there is none
  CompiledTrack arm_track, person_track;
  std::vector<std::uint8_t> checked_against_cell;
  CompiledField<Q> cell;
  CompiledField<Q> soft;  // empty image if the scene has none
  work_cell::WorkCell settings;  // its plain numbers; the spans are filled in by view()

  // Valid as long as this object stays where it is and is not changed.
  work_cell::WorkCell view() const;
};

// `robot_file` and `srdf_file` are those of the arm; an empty srdf_file checks all but directly joined links.
// InputError, with file and place, when the scene lacks what a simulation needs (cycle, separation) or names links or
// joints that the robot does not have, when joint values are outside the limits, or when something does not fit.
CompiledWorkCell compile_work_cell(const SceneDescription& scene, const std::string& robot_file,
                                   const std::string& srdf_file);

}  // namespace nearfield::host
