// How many instructions a field costs at the worst.
#pragma once

#include <nearfield/field/operations.hpp>

namespace nearfield {

// Worst-case instructions of one evaluation: the value alone, and value with gradient.
struct Budget {
  uint32_t value = 0;
  uint32_t gradient = 0;

  friend constexpr Budget operator+(Budget a, Budget b) { return {a.value + b.value, a.gradient + b.gradient}; }
};

// Cortex-M4 without FPU, Fixed<27>, GCC 12 -O2: the greatest count measured by ports/mps2/operation_costs.cpp over
// each operation's worst paths, dispatch included, plus one in sixteen (a frame's cost is that of
// entering and leaving together). Running that program checks that no measurement exceeds what is stated here.
constexpr Budget cortex_m4_cost(Operation operation) {
  switch (operation) {
    case Operation::sphere: return {96, 156};
    case Operation::capsule: return {173, 225};
    case Operation::box: return {141, 245};
    case Operation::cylinder: return {204, 329};
    case Operation::soft_point: return {87, 250};
    case Operation::soft_segment: return {179, 317};
    case Operation::sharp_union: return {60, 63};
    case Operation::sharp_intersection: return {60, 63};
    case Operation::sharp_subtraction: return {61, 59};
    case Operation::soft_sum: return {64, 92};
    case Operation::exterior_union: return {114, 163};
    case Operation::exterior_intersection: return {114, 163};
    case Operation::exterior_subtraction: return {114, 183};
    case Operation::enter_pose: return {114, 183};
    case Operation::enter_slot: return {85, 114};
    case Operation::leave: return {20, 30};
  }
  return {};
}

// What a query costs beyond the operations: checks, certificate, result.
constexpr Budget kCortexM4QueryCost = {80, 232};

// What a query with gradient adds for checking each pose that it is handed.
constexpr uint32_t kCortexM4PoseCheckCost = 370;

}  // namespace nearfield
