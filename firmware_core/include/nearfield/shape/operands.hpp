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
template <class T, class = void> inline constexpr bool uses_table = false;
template <class T> inline constexpr bool uses_table<T, decltype(void(T::samples_table))> = T::samples_table;

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
  return both;
}

}  // namespace nearfield
