// How many instructions a field costs at the worst.
#pragma once

#include <nearfield/field/operations.hpp>

namespace nearfield {

// Worst-case instructions of one evaluation: the value alone, and value with gradient.
struct Budget {
  uint32_t value = 0;
  uint32_t gradient = 0;

  friend constexpr Budget operator+(Budget a, Budget b) { return {a.value + b.value, a.gradient + b.gradient}; }
  friend constexpr Budget operator*(uint32_t count, Budget b) { return {count * b.value, count * b.gradient}; }
};

// The cost stated in operations.hpp: of any number of items, that of none. A frame's cost is that of entering and leaving
// together.
constexpr Budget cortex_m4_cost(Operation operation) {
  switch (operation) {
#define NEARFIELD_COST(code, name, type, value, gradient) \
  case Operation::name: return {value, gradient};
    NEARFIELD_OPERATIONS(NEARFIELD_COST)
#undef NEARFIELD_COST
#define NEARFIELD_COST(code, name, value, gradient) \
  case Operation::name: return {value, gradient};
    NEARFIELD_FRAME_OPERATIONS(NEARFIELD_COST)
#undef NEARFIELD_COST
  }
  return {};
}
constexpr Budget cortex_m4_item_cost(Operation operation) {
  switch (operation) {
#define NEARFIELD_COST(name, value, gradient) \
  case Operation::name: return {value, gradient};
    NEARFIELD_ITEM_COSTS(NEARFIELD_COST)
#undef NEARFIELD_COST
    default: return {};
  }
}
template <class T> constexpr Budget cortex_m4_cost(const T& operation) {
  constexpr Operation code = OperationOf<T>::value;
  if constexpr (detail::has_items<T>) {
    return cortex_m4_cost(code) + static_cast<uint32_t>(detail::item_count(operation)) * cortex_m4_item_cost(code);
  } else {
    return cortex_m4_cost(code);
  }
}

// What a greatest value in a ball, highest(), costs of operations whose values cost this.
constexpr uint32_t cortex_m4_highest_cost(uint32_t value) { return value + value / 2 + value / 4; }

// What a query costs beyond the operations: checks, certificate, result.
inline constexpr Budget kCortexM4QueryCost = {28, 225};

// What a query with gradient adds for checking each pose that it is handed.
inline constexpr uint32_t kCortexM4PoseCheckCost = 380;
// The same for each parameter.
inline constexpr uint32_t kCortexM4ParameterCheckCost = 8;

}  // namespace nearfield
