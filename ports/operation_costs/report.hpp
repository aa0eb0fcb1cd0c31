// The table of what was measured, beside what is stated in nearfield/field/costs/. Each row of it is a name, a kind, and
// three pairs: measured and stated instructions of a value, a value with gradient, a greatest value in a ball.
#pragma once

#include <operation_costs/trial.hpp>

namespace nearfield::costs {

// Rows that state too little, or more than kLoosePercent of what was measured.
inline int failures = 0;
inline constexpr uint32_t kLoosePercent = 115;

// 0: there is no such count. Small counts may be stated by one more.
inline bool write_pair(uint32_t measured, uint32_t stated, size_t width) {
  if (measured == 0) {
    for (size_t i = 1; i < width; ++i) board::write(" ");
    board::write("-      -");
    return true;
  }
  board::write_right_aligned(measured, width);
  // Apart from the other however great: what is not stated has nine digits.
  board::write(" ");
  board::write_right_aligned(stated, 6);
  return measured <= stated;
}
constexpr bool loose(uint32_t measured, uint32_t stated) {
  return measured != 0 && stated > measured + 1 && uint64_t{stated} * 100 > uint64_t{measured} * kLoosePercent;
}

enum class Row { operation, item, part, check };
inline void report(Row kind, const char* name, const Budget& measured, const Budget& stated) {
  constexpr const char* kinds[] = {"operation", "item", "part", "check"};
  board::write_padded(name, 42);
  board::write_padded(kinds[static_cast<int>(kind)], 9);
  bool enough = write_pair(measured.value, stated.value, 8);
  enough = write_pair(measured.gradient, stated.gradient, 8) && enough;
  enough = write_pair(measured.highest, stated.highest, 8) && enough;
  const bool too_much = kind != Row::check && (loose(measured.value, stated.value) ||
                                               loose(measured.gradient, stated.gradient));
  board::write(!enough ? "  EXCEEDED\n" : too_much ? "  LOOSE\n" : "\n");
  failures += !enough || too_much ? 1 : 0;
}
inline void report_part(const char* name, QueryPart part, const Budget& measured) {
  report(Row::part, name, measured, kTarget.cost(part));
}
inline void report_value(const char* name, uint32_t measured, uint32_t stated) {
  report(Row::check, name, {measured, 0, 0}, {stated, 0, 0});
}
inline void report_gradient(const char* name, uint32_t measured, uint32_t stated) {
  report(Row::check, name, {0, measured, 0}, {0, stated, 0});
}

inline void write_heading() {
  board::write("on " NEARFIELD_CORE ", GCC " __VERSION__ "\n");
  board::write_padded("worst instructions, measured and stated", 51);
  board::write("   value         gradient          highest\n");
}
// Every operation of the list; fails for those that were not measured.
inline void report_operations() {
  const auto report_one = [](Operation operation, const char* name, bool has_items) {
    const Measured& measured = measured_costs[static_cast<uint32_t>(operation)];
    if (measured.counts == 0) {
      board::write_padded(name, 42);
      board::write("not measured\n");
      ++failures;
      return;
    }
    report(Row::operation, name, measured.base(), kTarget.cost(operation));
    if (has_items) report(Row::item, name, measured.item(), kTarget.item_cost(operation));
  };
#define NEARFIELD_REPORT(code, name, type) report_one(Operation::name, #name, detail::has_items<type<Q>>);
  NEARFIELD_OPERATIONS(NEARFIELD_REPORT)
#undef NEARFIELD_REPORT
}

}  // namespace nearfield::costs
