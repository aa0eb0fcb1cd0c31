// What an operation says of its operands, for static composition, programs and their validation alike.
//
// A shape has     Out evaluate<Out>(point [, table])           and  certificate(reach [, facts]).
// With operands:  Out combine(a [, b] [, table])               and  certificate(operands, facts, reach), or,
//                 Out combine_all<Out>(operands [, table])     when it takes any number of them.
// `operands` is indexed from 0, in the order in which they were given; `table` (and a shape's `facts`) come only where
// samples_table is true.
//
// Intensities with `has_highest` true also have
//                 Highest<S> highest(point, ball [, table])         or  highest(a [, b], ball [, table]):
// nowhere in the ball is the intensity greater than that and the certificate's error together.
//
// Where the cost grows with a number of parts that are not its operands, int item_count() tells it.
//
// With `takes_parameter` true it has `uint32_t slot`, and combine() and highest() take the value of that parameter slot,
// in [0, 1], as their last argument.
//
// With `takes_point` true, of one operand, combine() takes the point before it, in the coordinates of the frame at hand.
//
// A shape whose payload is large may have evaluate_from<Out>(source, point), which takes what it reads from a source, one part
// after the other: a class of its own, InImage{payload's words}, or one that evaluate() gives it. A program then does not copy
// the payload.
//
// With `takes_partial` true it takes operands whose certificate is partial; with `checks_table` true, bool fits(table) says
// whether a table is of the form that it samples.
#pragma once

#include <nearfield/shape/certificate.hpp>
#include <nearfield/shape/sample.hpp>
#include <nearfield/table/table.hpp>

namespace nearfield {

// As fixed_operand_count: the payload's operand_count() tells.
inline constexpr int kAnyNumber = -1;

namespace detail {

template <class T, class = void> inline constexpr int operand_count_of = 0;
template <class T> inline constexpr int operand_count_of<T, decltype(void(T::fixed_operand_count))> = T::fixed_operand_count;
template <class T, class = void> inline constexpr Kind operand_kind_of = T::kind;
template <class T> inline constexpr Kind operand_kind_of<T, decltype(void(T::operand_kind))> = T::operand_kind;
template <class T, class = void> inline constexpr bool has_own_highest = false;
template <class T> inline constexpr bool has_own_highest<T, decltype(void(T::has_highest))> = T::has_highest;
// Whether greatest values in a ball pass through an operation.
template <class T> inline constexpr bool passes_highest = T::kind != Kind::intensity || has_own_highest<T>;
template <class T, class = void> inline constexpr bool takes_partial_of = false;
template <class T> inline constexpr bool takes_partial_of<T, decltype(void(T::takes_partial))> = T::takes_partial;
template <class T, class = void> inline constexpr bool checks_table_of = false;
template <class T> inline constexpr bool checks_table_of<T, decltype(void(T::checks_table))> = T::checks_table;
template <class T, class = void> inline constexpr bool takes_parameter_of = false;
template <class T> inline constexpr bool takes_parameter_of<T, decltype(void(T::takes_parameter))> = T::takes_parameter;
template <class T, class = void> inline constexpr bool takes_point_of = false;
template <class T> inline constexpr bool takes_point_of<T, decltype(void(T::takes_point))> = T::takes_point;
template <class T, class = void> inline constexpr bool reads_in_place = false;
template <class T> inline constexpr bool reads_in_place<T, decltype(void(sizeof(typename T::InImage)))> = true;
template <class T, class = void> inline constexpr bool uses_table = false;
template <class T> inline constexpr bool uses_table<T, decltype(void(T::samples_table))> = T::samples_table;

template <class T, class = void> inline constexpr bool has_item_count = false;
template <class T> inline constexpr bool has_item_count<T, decltype(void(&T::item_count))> = true;
template <class T> inline constexpr bool has_items = operand_count_of<T> == kAnyNumber || has_item_count<T>;

// By what its cost grows.
template <class T> constexpr int item_count(const T& operation) {
  if constexpr (has_item_count<T>) return operation.item_count();
  else return operation.operand_count();
}

}  // namespace detail

// Certificates of an operation's operands.
template <class S> using OperandCertificates = const Certificate<S>*;

// The worst of each bound, for blends that neither round nor move a surface.
template <class S> constexpr Certificate<S> worst_of(const Certificate<S>& a, const Certificate<S>& b) {
  Certificate<S> both;
  both.valid = a.valid && b.valid;
  both.lipschitz = greatest_of_two(a.lipschitz, b.lipschitz);
  both.erosion = greatest_of_two(a.erosion, b.erosion);
  both.inflation = greatest_of_two(a.inflation, b.inflation);
  both.error = greatest_of_two(a.error, b.error);
  both.below_zero = greatest_of_two(a.below_zero, b.below_zero);
  return both;
}

namespace detail {

// The certificate of an operation with `count` operands.
template <class T, class S>
constexpr Certificate<S> certificate_of(const T& operation, const Certificate<S>* of, int count, const TableFacts& facts,
                                        Reach<S> reach) {
  if constexpr (operand_count_of<T> == kAnyNumber) {
    if (operation.operand_count() != count) return {};
  }
  bool partial = false;
  for (int i = 0; i < count; ++i) partial = partial || of[i].partial;
  if (partial && !takes_partial_of<T>) return {};
  Certificate<S> all = operation.certificate(of, facts, reach);
  all.partial = partial;
  return all;
}
template <class T, class View> constexpr bool table_fits(const T& operation, const View& table) {
  if constexpr (checks_table_of<T>) return operation.fits(table);
  else return true;
}

}  // namespace detail

}  // namespace nearfield
