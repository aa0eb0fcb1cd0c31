// How many instructions a field costs at the worst, on each target that costs.hpp has been measured on.
#pragma once

#include <nearfield/field/costs/cortex_m0.hpp>
#include <nearfield/field/costs/cortex_m3.hpp>
#include <nearfield/field/costs/cortex_m4.hpp>
#include <nearfield/field/costs/rv32imac.hpp>
#include <nearfield/field/operations.hpp>

namespace nearfield {

// Cores whose costs have been measured, and stand in costs/: NEARFIELD_COSTS_OF_<name>.
#define NEARFIELD_TARGETS(X) X(cortex_m0) X(cortex_m3) X(cortex_m4) X(rv32imac)

enum class Target : uint8_t {
#define NEARFIELD_TARGET(name) name,
  NEARFIELD_TARGETS(NEARFIELD_TARGET)
#undef NEARFIELD_TARGET
};

// The target that this is compiled for; where that is none of them (a host, say), the Cortex-M4.
#if defined(__ARM_ARCH_6M__)
inline constexpr Target kThisTarget = Target::cortex_m0;
#elif defined(__ARM_ARCH_7M__)
inline constexpr Target kThisTarget = Target::cortex_m3;
#elif defined(__riscv) && __riscv_xlen == 32
inline constexpr Target kThisTarget = Target::rv32imac;
#else
inline constexpr Target kThisTarget = Target::cortex_m4;
#endif

// Worst-case instructions of one evaluation: the value alone, value with gradient, the greatest value in a ball. Sums that
// do not fit stay at the greatest number.
struct Budget {
  uint32_t value = 0;
  uint32_t gradient = 0;
  uint32_t highest = 0;

  friend constexpr Budget operator+(Budget a, Budget b) {
    return {sum(a.value, b.value), sum(a.gradient, b.gradient), sum(a.highest, b.highest)};
  }
  friend constexpr Budget operator*(uint32_t count, Budget b) {
    return {product(count, b.value), product(count, b.gradient), product(count, b.highest)};
  }

 private:
  static constexpr uint32_t sum(uint32_t a, uint32_t b) { return a + b < a ? UINT32_MAX : a + b; }
  static constexpr uint32_t product(uint32_t a, uint32_t b) {
    const uint64_t exact = uint64_t{a} * b;
    return exact > UINT32_MAX ? UINT32_MAX : static_cast<uint32_t>(exact);
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

#define NEARFIELD_NO_COST(name, value, gradient, highest)
#define NEARFIELD_COST(name, value, gradient, highest) \
  case Of::name: return {value, gradient, highest};

template <Target target> struct CostsOf;
#define NEARFIELD_COSTS_ON(name)                                                                       \
  template <> struct CostsOf<Target::name> {                                                           \
    static constexpr Budget of(Operation operation) {                                                  \
      using Of = Operation;                                                                            \
      switch (operation) {                                                                             \
        NEARFIELD_COSTS_OF_##name(NEARFIELD_COST, NEARFIELD_NO_COST, NEARFIELD_NO_COST)                \
        case Of::leave:                                                                                \
        case Of::leave_box: return {};                                                                 \
        default: return kNotMeasured;                                                                  \
      }                                                                                                \
    }                                                                                                  \
    static constexpr Budget of_item(Operation operation) {                                             \
      using Of = Operation;                                                                            \
      switch (operation) {                                                                             \
        NEARFIELD_COSTS_OF_##name(NEARFIELD_NO_COST, NEARFIELD_COST, NEARFIELD_NO_COST)                \
        default: return kNotMeasured;                                                                  \
      }                                                                                                \
    }                                                                                                  \
    static constexpr Budget of(QueryPart part) {                                                       \
      using Of = QueryPart;                                                                            \
      switch (part) {                                                                                  \
        NEARFIELD_COSTS_OF_##name(NEARFIELD_NO_COST, NEARFIELD_NO_COST, NEARFIELD_COST)                \
        default: return kNotMeasured;                                                                  \
      }                                                                                                \
    }                                                                                                  \
  };
NEARFIELD_TARGETS(NEARFIELD_COSTS_ON)
#undef NEARFIELD_COSTS_ON
#undef NEARFIELD_COST
#undef NEARFIELD_NO_COST

}  // namespace detail

#define NEARFIELD_CASE(name) \
  case Target::name: return detail::CostsOf<Target::name>::of(what);
// An operation in an image, dispatch included; of any number of items, what none would cost. A frame's cost is that of
// entering and leaving together.
constexpr Budget cost(Target target, Operation what) {
  switch (target) { NEARFIELD_TARGETS(NEARFIELD_CASE) }
  return detail::kNotMeasured;
}
constexpr Budget cost(Target target, QueryPart what) {
  switch (target) { NEARFIELD_TARGETS(NEARFIELD_CASE) }
  return detail::kNotMeasured;
}
#undef NEARFIELD_CASE
#define NEARFIELD_CASE(name) \
  case Target::name: return detail::CostsOf<Target::name>::of_item(what);
// What each item adds.
constexpr Budget item_cost(Target target, Operation what) {
  switch (target) { NEARFIELD_TARGETS(NEARFIELD_CASE) }
  return detail::kNotMeasured;
}
#undef NEARFIELD_CASE

// Of an operation with all its items.
template <class T> constexpr Budget cost_of(Target target, const T& operation) {
  constexpr Operation code = OperationOf<T>::value;
  if constexpr (detail::has_items<T>) {
    return cost(target, code) + static_cast<uint32_t>(detail::item_count(operation)) * item_cost(target, code);
  } else {
    return cost(target, code);
  }
}

// What a query costs beyond its operations: checks of poses and parameters, certificate, result.
constexpr Budget query_cost(Target target, uint32_t slot_count, uint32_t parameter_count) {
  return cost(target, QueryPart::query) + slot_count * cost(target, QueryPart::pose_check) +
         parameter_count * cost(target, QueryPart::parameter_check);
}

}  // namespace nearfield
