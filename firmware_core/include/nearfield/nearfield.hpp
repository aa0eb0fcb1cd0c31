// Nearfield: clearances that are never too large, in fixed point, on a microcontroller.
// This header brings everything a firmware author needs; field/builder.hpp, for writing images, comes on top.
#pragma once

#include <nearfield/curve/curves.hpp>
#include <nearfield/curve/kernel.hpp>
#include <nearfield/curve/radius_profile.hpp>
#include <nearfield/curve/tabulate.hpp>
#include <nearfield/field/compose.hpp>
#include <nearfield/field/deformed.hpp>
#include <nearfield/field/metrics.hpp>
#include <nearfield/field/program.hpp>
#include <nearfield/field/solids.hpp>
#include <nearfield/query/arm_monitor.hpp>
#include <nearfield/query/clearance.hpp>
#include <nearfield/query/soft_clearance.hpp>
#include <nearfield/shape/quadrics.hpp>
