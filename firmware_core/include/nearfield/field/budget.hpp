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
// each operation's worst paths, dispatch included, plus one in sixteen. tests/target checks that no measurement exceeds it.
constexpr Budget cortex_m4_cost(Operation operation) {
  switch (operation) {
    case Operation::sphere: return {200, 300};
    case Operation::capsule: return {250, 350};
    case Operation::box: return {200, 300};
    case Operation::cylinder: return {300, 500};
    case Operation::soft_point: return {200, 300};
    case Operation::soft_segment: return {250, 350};
    case Operation::sharp_union:
    case Operation::sharp_intersection:
    case Operation::sharp_subtraction: return {60, 120};
    case Operation::soft_sum: return {60, 120};
    case Operation::exterior_union:
    case Operation::exterior_intersection:
    case Operation::exterior_subtraction: return {150, 300};
    case Operation::enter_pose:
    case Operation::enter_slot: return {150, 150};
    case Operation::leave: return {50, 150};
  }
  return {};
}

// What a query costs beyond the operations: checks, certificate, result.
constexpr Budget kCortexM4QueryCost = {100, 200};

}  // namespace nearfield
