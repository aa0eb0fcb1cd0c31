// A work cell as plain data: what the host compiles from robot and scene files, and a target keeps in flash.
// Freestanding: nothing but firmware_core underneath.
#pragma once

#include <nearfield/nearfield.hpp>

namespace nearfield::work_cell {

using Q = Fixed<27>;  // metres, radians

template <class T> struct Span {
  const T* data = nullptr;
  uint32_t count = 0;
};

// Joint values at given times, between which they move with smooth (cubic) timing.
struct Track {
  Span<uint32_t> times;     // microseconds, ascending, the first 0
  Span<Q> values;           // one row of `variables` numbers for each time
  uint32_t variables = 0;
};

struct RobotData {
  Span<Joint<Q>> joints;
  Span<Body<Q>> bodies;
  Track track;
};

struct WorkCell {
  RobotData arm;
  RobotData person;              // no bodies: nobody
  Span<uint8_t> checked_against_cell;  // one flag per arm body
  Span<BodyPair> self_pairs;
  Span<uint32_t> cell_image;
  Span<uint32_t> soft_image;     // may be empty
  uint16_t tool_link = 0;
  int refinements = 12;          // evaluations beyond one for each body
  Q tolerance{};
  Q person_stop{}, person_free{}, cell_stop{}, cell_free{};  // metres
  uint32_t ticks = 0;            // of 1 ms
};

}  // namespace nearfield::work_cell
