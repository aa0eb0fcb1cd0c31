// An operation on the results of its operands, with whatever else it takes: programs, batches and compositions alike.
#pragma once

#include <nearfield/field/slots.hpp>
#include <nearfield/shape/operands.hpp>
#include <nearfield/shape/sample.hpp>

namespace nearfield::detail {

// Of all whose number of operands is fixed: `of` are the results of these, in order; of none it evaluates the shape. `table`,
// and of `parameters` its slot, are read only if it takes them.
template <class Out, class T, class View, class S, class... Operand>
constexpr Out apply(const T& operation, [[maybe_unused]] const Vector3<S>& p, [[maybe_unused]] const View& table,
                    [[maybe_unused]] const S* parameters, const Operand&... of) {
  static_assert(operand_count_of<T> == static_cast<int>(sizeof...(of)), "not as many operands as it takes");
  static_assert(!takes_point_of<T> || sizeof...(of) == 1, "operations that take the point have one operand");
  if constexpr (sizeof...(of) == 0) {
    if constexpr (uses_table<T>) return operation.template evaluate<Out>(p, table);
    else return operation.template evaluate<Out>(p);
  } else if constexpr (takes_parameter_of<T>) {
    return operation.combine(of..., parameters[operation.slot]);
  } else if constexpr (takes_point_of<T>) {
    if constexpr (uses_table<T>) return operation.combine(p, of..., table);
    else return operation.combine(p, of...);
  } else {
    if constexpr (uses_table<T>) return operation.combine(of..., table);
    else return operation.combine(of...);
  }
}

// The same of any number of operands: `of[i]` are their results.
template <class Out, class T, class View, class Results>
constexpr Out apply_to_all(const T& operation, [[maybe_unused]] const View& table, const Results& of) {
  if constexpr (uses_table<T>) return operation.template combine_all<Out>(of, table);
  else return operation.template combine_all<Out>(of);
}

// The same of greatest values in the ball around `p`. Precondition: has_own_highest<T>.
template <class T, class View, class S, class... Operand>
constexpr Highest<S> apply_highest(const T& operation, [[maybe_unused]] const Vector3<S>& p, const Ball<S>& ball,
                                   [[maybe_unused]] const View& table, [[maybe_unused]] const S* parameters,
                                   const Operand&... of) {
  static_assert(operand_count_of<T> == static_cast<int>(sizeof...(of)) && sizeof...(of) <= 2,
                "greatest values in a ball are of at most two operands");
  if constexpr (sizeof...(of) == 0) {
    if constexpr (uses_table<T>) return operation.highest(p, ball, table);
    else return operation.highest(p, ball);
  } else if constexpr (takes_parameter_of<T>) {
    return operation.highest(of..., ball, parameters[operation.slot]);
  } else {
    if constexpr (uses_table<T>) return operation.highest(of..., ball, table);
    else return operation.highest(of..., ball);
  }
}

}  // namespace nearfield::detail
