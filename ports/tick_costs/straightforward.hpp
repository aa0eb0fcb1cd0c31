// A tick of the default work cell's arm as straightforward C++ in float, what a user would write for this arm in this cell: the
// work of ArmMonitor (nearfield/query/arm_monitor.hpp) on the same joint values.
//
// Done: poses and bodies of arm and person; the clearance of nine bodies to five blended solids, by the same search (a value in
// the middle of each, then up to twelve more where the bound is least); all pairs of arm and person, 25 of the arm itself; the
// speed; the soft field's intensity and direction at the tool.
// Left out: limits of joints, the domain, whether anything is valid; rounding errors of poses, bodies and fields, which nobody
// takes off here; statuses; a separating direction for each pair, which bounds its distance whatever the clamping misses;
// fields as data: solids, blend and potential are this cell's, compiled in. The steepest slope is known from Nearfield.
#pragma once

#include <tick_costs/straightforward_robot.hpp>

namespace nearfield::straightforward {

// Of the speed over a clearance, metres: H_3 between the two.
struct Ramp {
  float stop, free;
};

inline constexpr int most_bodies = 10, most_refinements = 12;

// Arm, person, and what has to be kept apart.
struct Robot {
  const Hinge* hinges;
  int hinge_count;
  const Limb* limbs;
  int limb_count;
};
struct LimbPair {
  uint16_t first, second;
};
struct Cell {
  Robot arm, person;
  const uint8_t* checked;  // a flag for each body of the arm
  const LimbPair* self_pairs;
  int self_pair_count, tool_link, refinements;
  float tolerance;
  Ramp of_person, of_cell;
};

struct Nearest {
  float distance;
  Point away;  // a unit vector
  int body, other;
};
struct Tick {
  Nearest cell, person, itself;
  float speed, intensity;
  Point repulsion;
};

// Of joint values in radians and metres.
Tick tick(const Cell& cell, const float* arm_joints, const float* person_joints);

}  // namespace nearfield::straightforward
