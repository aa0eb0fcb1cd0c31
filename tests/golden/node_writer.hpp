// Writes a static composition as a program image, so that both forms of one field can be compared.
// Freestanding.
#pragma once

#include <nearfield/field/builder.hpp>
#include <nearfield/field/compose.hpp>

namespace nearfield::golden {

// Add the tables that the field samples first, then write() the node once, then builder().finish().
// What is written often is not inlined: that would take most of the time of compiling the tests.
template <class S, uint32_t Capacity, class Operations = AllOperations>
class NodeWriter {
 public:
  template <int segments>
  [[gnu::noinline]] constexpr void table(const Table<S, segments>& table) {
    if (table_count_ == kTableLimit) return;
    coefficients_[table_count_] = table.coefficients;
    references_[table_count_] = builder_.table(table);
    ++table_count_;
  }

  template <class Shape>
  [[gnu::noinline]] constexpr void write(const Shape& shape) {
    builder_.operation(shape);
  }
  template <class T, class View, class... Operand>
  constexpr void write(const Combined<T, View, Operand...>& node) {
    write(node.operands);
    if constexpr (detail::uses_table<T>)
      builder_.operation(node.operation, reference_of(node.table));
    else
      builder_.operation(node.operation);
  }
  constexpr void write(const NodeList<>&) {}
  template <class First, class... Rest>
  constexpr void write(const NodeList<First, Rest...>& list) {
    write(list.first);
    write(list.rest);
  }
  template <class A>
  constexpr void write(const Placed<A>& node) {
    builder_.enter(node.pose);
    write(node.a);
    builder_.leave();
  }
  template <class A>
  constexpr void write(const Scaled<A>& node) {
    builder_.enter_scale(node.scale, A::kind);
    write(node.a);
    builder_.leave_scale();
  }
  template <class A>
  constexpr void write(const InSlot<A>& node) {
    builder_.enter_slot(node.slot);
    write(node.a);
    builder_.leave();
  }

  constexpr ImageBuilder<S, Capacity, Operations>& builder() { return builder_; }

 private:
  static constexpr int kTableLimit = 4;

  // 0, which no table has, for one that was not added.
  constexpr uint32_t reference_of(const TableView<S>& view) const {
    for (int i = 0; i < table_count_; ++i) {
      if (coefficients_[i] == view.coefficients) return references_[i];
    }
    return 0;
  }

  ImageBuilder<S, Capacity, Operations> builder_;
  const uint32_t* coefficients_[kTableLimit] = {};
  uint32_t references_[kTableLimit] = {};
  int table_count_ = 0;
};

}  // namespace nearfield::golden
