// How many instructions a field costs at the worst, on each target whose costs have been measured.
#pragma once

#include <nearfield/field/costs/cortex_m0.hpp>
#include <nearfield/field/costs/cortex_m3.hpp>
#include <nearfield/field/costs/cortex_m33.hpp>
#include <nearfield/field/costs/cortex_m4.hpp>
#include <nearfield/field/costs/cortex_m4f.hpp>
#include <nearfield/field/costs/cortex_m7.hpp>
#include <nearfield/field/costs/rv32imac.hpp>
#include <nearfield/field/costs/rv64imac.hpp>
#include <nearfield/field/operations.hpp>

namespace nearfield {

namespace detail {

// At the greatest number where they do not fit.
constexpr uint32_t sum_of_costs(uint32_t a, uint32_t b) { return a + b < a ? UINT32_MAX : a + b; }
constexpr uint32_t product_of_costs(uint32_t count, uint32_t cost) {
  const uint64_t exact = uint64_t{count} * cost;
  return exact > UINT32_MAX ? UINT32_MAX : static_cast<uint32_t>(exact);
}

}  // namespace detail

// Worst-case instructions of one evaluation: the value alone, value with gradient, the greatest value in a ball. Sums that
// do not fit stay at the greatest number.
struct Budget {
  uint32_t value = 0;
  uint32_t gradient = 0;
  uint32_t highest = 0;

  friend constexpr Budget operator+(Budget a, Budget b) {
    using detail::sum_of_costs;
    return {sum_of_costs(a.value, b.value), sum_of_costs(a.gradient, b.gradient), sum_of_costs(a.highest, b.highest)};
  }
  friend constexpr Budget operator*(uint32_t count, Budget b) {
    using detail::product_of_costs;
    return {product_of_costs(count, b.value), product_of_costs(count, b.gradient), product_of_costs(count, b.highest)};
  }
};

// What queries do besides evaluating operations. Only the counts that are named here count.
enum class QueryPart : uint8_t {
  query,            // value, highest: entering an evaluation; gradient: that, checks, certificate, result
  pose_check,       // gradient: of each pose handed in
  parameter_check,  // gradient: of each parameter handed in
  soft_clearance,   // gradient: all its steps, but for the field's highest()
  link_poses,       // value: of a chain, but for its joints
  revolute_joint,   // value
  other_joint,      // value
  placed_body,      // value
  capsule_pair,     // value
  swept_capsule,    // value: of each capsule of a sweep, but for the field
  refinement,       // value: of each refinement of a sweep, but for the field
  stretch,          // value: of each stretch that a refinement looks at
  tick,             // value: of a monitor with chains of at most 16 links and bodies, but for all of the above
  c_interface,      // gradient: copies of a query through nearfield.h
  c_pose,           // gradient: of each pose handed in there
};

namespace detail {

// Nothing costs as much: a budget with something in it that was not measured can be seen to be no budget.
inline constexpr Budget kNotMeasured = {100000000, 100000000, 100000000};

// Budgets of fields and chains in S: costs are of Fixed<27>. Others round elsewhere and exceed them, by up to a fifth.
template <class S> constexpr Budget budget_in(Budget sum) {
  return ScalarTraits<S>::tag == ScalarTraits<Fixed<27>>::tag ? sum : kNotMeasured;
}

// A row of costs/, 65,535 where there is none.
struct CostRow {
  uint16_t value = 65535, gradient = 65535, highest = 65535;

  constexpr Budget budget() const { return value == 65535 ? kNotMeasured : Budget{value, gradient, highest}; }
};

constexpr uint32_t greatest_operation() {
  uint32_t greatest = 0;
#define NEARFIELD_GREATEST(code, ...) greatest = greatest_of_two<uint32_t>(greatest, code);
  NEARFIELD_OPERATIONS(NEARFIELD_GREATEST)
  NEARFIELD_FRAME_OPERATIONS(NEARFIELD_GREATEST)
#undef NEARFIELD_GREATEST
  return greatest;
}

}  // namespace detail

// A core with its compiler, as what everything costs there. Those that have been measured: namespace target.
class Target {
 public:
  // An operation in an image, dispatch included; of any number of items, what none would cost. A frame's cost is that of
  // entering and leaving together.
  constexpr Budget cost(Operation operation) const {
    if (operation == Operation::leave || operation == Operation::leave_box || operation == Operation::leave_scale) return {};
    const auto code = static_cast<uint32_t>(operation);
    return code < operation_count ? operations_[code].budget() : detail::kNotMeasured;
  }
  // What each item adds.
  constexpr Budget item_cost(Operation operation) const {
    for (const ItemRow& item : items_) {
      if (item.operation == operation) return item.cost.budget();
    }
    return detail::kNotMeasured;
  }
  constexpr Budget cost(QueryPart part) const {
    const auto number = static_cast<uint32_t>(part);
    return number < part_count ? parts_[number].budget() : detail::kNotMeasured;
  }
  // Of an operation with all its items.
  template <class T> constexpr Budget cost_of(const T& operation) const {
    constexpr Operation code = OperationOf<T>::value;
    if constexpr (detail::has_items<T>) {
      return cost(code) + static_cast<uint32_t>(detail::item_count(operation)) * item_cost(code);
    } else {
      return cost(code);
    }
  }
  // What a query costs beyond its operations: checks of poses and parameters, certificate, result.
  constexpr Budget query_cost(uint32_t slot_count, uint32_t parameter_count) const {
    return cost(QueryPart::query) + slot_count * cost(QueryPart::pose_check) +
           parameter_count * cost(QueryPart::parameter_check);
  }

  constexpr void state(Operation operation, const detail::CostRow& row) {
    operations_[static_cast<uint32_t>(operation)] = row;
  }
  constexpr void state(QueryPart part, const detail::CostRow& row) { parts_[static_cast<uint32_t>(part)] = row; }
  constexpr void state_item(Operation operation, const detail::CostRow& row) {
    uint32_t free = 0;
    while (items_[free].operation != Operation::leave) ++free;
    items_[free] = {operation, row};
  }

 private:
  static constexpr uint32_t operation_count = detail::greatest_operation() + 1;
  static constexpr uint32_t part_count = static_cast<uint32_t>(QueryPart::c_pose) + 1;
  struct ItemRow {
    Operation operation = Operation::leave;
    detail::CostRow cost;
  };

  detail::CostRow operations_[operation_count];
  detail::CostRow parts_[part_count];
  ItemRow items_[16];
};

namespace target {

#define NEARFIELD_OPERATION_ROW(name, ...) costs.state(Operation::name, {__VA_ARGS__});
#define NEARFIELD_ITEM_ROW(name, ...) costs.state_item(Operation::name, {__VA_ARGS__});
#define NEARFIELD_PART_ROW(name, ...) costs.state(QueryPart::name, {__VA_ARGS__});
#define NEARFIELD_TARGET(name)                                                                            \
  inline constexpr Target name = [] {                                                                     \
    Target costs;                                                                                         \
    NEARFIELD_COSTS_OF_##name(NEARFIELD_OPERATION_ROW, NEARFIELD_ITEM_ROW, NEARFIELD_PART_ROW) return costs; \
  }();
// Every list of targets is made of this one; each has its file in costs/, NEARFIELD_COSTS_OF_<name>.
#define NEARFIELD_TARGETS(X) \
  X(cortex_m0) X(cortex_m3) X(cortex_m4) X(cortex_m4f) X(cortex_m7) X(cortex_m33) X(rv32imac) X(rv64imac)
NEARFIELD_TARGETS(NEARFIELD_TARGET)
#undef NEARFIELD_TARGET
#undef NEARFIELD_OPERATION_ROW
#undef NEARFIELD_ITEM_ROW
#undef NEARFIELD_PART_ROW

}  // namespace target

// The target that this is compiled for; where that is none of them (a host, say), the Cortex-M4: name another where a budget
// is relied upon. Of the cores of Armv7E-M, the Cortex-M7 is the one with an FPU of double precision, the
// Cortex-M4 may have one of single precision.
#if defined(__ARM_ARCH_6M__) || defined(__ARM_ARCH_8M_BASE__)
inline constexpr const Target& kThisTarget = target::cortex_m0;
#elif defined(__ARM_ARCH_7M__)
inline constexpr const Target& kThisTarget = target::cortex_m3;
#elif defined(__ARM_ARCH_8M_MAIN__)
inline constexpr const Target& kThisTarget = target::cortex_m33;
#elif defined(__ARM_ARCH_7EM__) && defined(__ARM_FP) && (__ARM_FP & 8)
inline constexpr const Target& kThisTarget = target::cortex_m7;
#elif defined(__ARM_ARCH_7EM__) && defined(__ARM_FP)
inline constexpr const Target& kThisTarget = target::cortex_m4f;
#elif defined(__riscv) && __riscv_xlen == 32
inline constexpr const Target& kThisTarget = target::rv32imac;
#elif defined(__riscv) && __riscv_xlen == 64
inline constexpr const Target& kThisTarget = target::rv64imac;
#else
inline constexpr const Target& kThisTarget = target::cortex_m4;
#endif

}  // namespace nearfield
