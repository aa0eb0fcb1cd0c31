// An operation on the results of its operands, with whatever else it takes.
#pragma once

#include <nearfield/field/slots.hpp>
#include <nearfield/shape/operands.hpp>

namespace nearfield::detail {

// `of`: as many results as it takes operands; of none it evaluates the shape. `table`, and of `parameters` its slot, are read
// only if it takes them.
template <class Out, class T, class View, class S>
constexpr Out apply(const T& operation, [[maybe_unused]] const Vector3<S>& p, [[maybe_unused]] const Out* of,
                    [[maybe_unused]] const View& table, [[maybe_unused]] const S* parameters) {
  constexpr int count = operand_count_of<T>;
  static_assert(!takes_point_of<T> || count == 1, "operations that take the point have one operand");
  if constexpr (count == 0) {
    if constexpr (uses_table<T>) return operation.template evaluate<Out>(p, table);
    else return operation.template evaluate<Out>(p);
  } else if constexpr (takes_parameter_of<T>) {
    const S parameter = parameters[operation.slot];
    if constexpr (count == 1) return operation.combine(of[0], parameter);
    else return operation.combine(of[0], of[1], parameter);
  } else if constexpr (count == kAnyNumber) {
    if constexpr (uses_table<T>) return operation.template combine_all<Out>(of, table);
    else return operation.template combine_all<Out>(of);
  } else if constexpr (takes_point_of<T>) {
    if constexpr (uses_table<T>) return operation.combine(p, of[0], table);
    else return operation.combine(p, of[0]);
  } else if constexpr (count == 1) {
    if constexpr (uses_table<T>) return operation.combine(of[0], table);
    else return operation.combine(of[0]);
  } else {
    if constexpr (uses_table<T>) return operation.combine(of[0], of[1], table);
    else return operation.combine(of[0], of[1]);
  }
}

}  // namespace nearfield::detail
