// Ticks of the default work cell with robots and fields composed in the source, compiled apart from those of images: neither
// changes what the compiler makes of the other.
#pragma once

#include <work_cell/work_cell.hpp>

namespace nearfield::composed {

void tick(const work_cell::Q* arm_joints, const work_cell::Q* person_joints, ArmTick<work_cell::Q>& out);
void tick(const float* arm_joints, const float* person_joints, ArmTick<float>& out);

}  // namespace nearfield::composed
