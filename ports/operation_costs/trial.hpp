// Worst instruction counts of the operations of a program, dispatch included.
#pragma once

#include <nearfield/field/builder.hpp>
#include <nearfield/field/program.hpp>
#include <nearfield/query/chain.hpp>

#include <board/cost_rows.hpp>
#include <board/instruction_counter.hpp>
#include <board/console.hpp>

namespace nearfield::costs {

using Q = Fixed<27>;
using Builder = ImageBuilder<Q, 1024>;

// Of a program without operands; fewer if they are measured as well.
inline constexpr int kPoints = 4000;

// A point, and the radius of a ball about it.
struct Place {
  Vector3<Q> point;
  Q radius{};
};

// Fixed seed: every run measures the same.
struct Random {
  uint64_t state = 88172645463325252u;
  uint32_t next() {
    state ^= state << 13;
    state ^= state >> 7;
    state ^= state << 17;
    return static_cast<uint32_t>(state >> 16);
  }
  // Within +-2^-scale of the domain.
  Q coordinate(int scale) { return Q::from_raw(static_cast<int32_t>(next()) / 4 >> scale); }
  Q power_of_two() {
    const int32_t size = 1 << (13 + next() % 17);
    return Q::from_raw(next() % 2 == 0 ? size : -size);
  }
  // Finer scales, planes, axes and powers of two included, so that insides, faces and edges are met.
  Vector3<Q> point() {
    const int scale = static_cast<int>(next() % 9);
    Vector3<Q> p = {coordinate(scale), coordinate(scale), coordinate(scale)};
    Q* const coordinates[] = {&p.x, &p.y, &p.z};
    for (Q* each : coordinates) {
      const uint32_t choice = next() % 16;
      if (choice < 2)
        *each = Q{};
      else if (choice == 2)
        *each = power_of_two();
    }
    if (next() % 32 == 0) p = {power_of_two(), power_of_two(), power_of_two()};
    return p;
  }
  Place place() {
    const Vector3<Q> p = point();
    return {p, absolute(coordinate(static_cast<int>(next() % 9)))};
  }
};

// The identity, which leaves points where they are, and one that does not; parameters with many bits.
inline const Pose<Q> kPoses[] = {{}, {rotation_about<Q>({0.6, 0.0, 0.8}, Q(0.7)), {0.3, -0.2, 0.1}}};
inline const Q kParameters[] = {Q::from_raw(0x5a5a5a5), Q::from_raw(0x1234567)};
inline const Slots<Q> kSlots(kPoses, 2, kParameters, 2);
inline volatile int32_t sink;

template <class Out>
__attribute__((noinline)) Out value_of(const Program<Q>& program, const Place& at, const Slots<Q>& slots) {
  if constexpr (__is_same(Out, Highest<Q>))
    return program.highest(at.point, at.radius, slots);
  else
    return program.evaluate<Out>(at.point, slots);
}
template <class Out>
uint32_t instructions_at(const Program<Q>& program, const Place& at) {
  board::start_instruction_count();
  const Out value = value_of<Out>(program, at, kSlots);
  const uint32_t count = board::stop_instruction_count();
  sink = value.value.raw();
  return count;
}

inline Program<Q> loaded(Builder& builder, const char* what) {
  const Inspection<Q> inspection = builder.finish();
  if (inspection.status != LoadStatus::ok) {
    board::write("a program does not load: ");
    board::write(what);
    board::write(", status ");
    board::write_decimal(static_cast<uint64_t>(inspection.status));
    board::write("\n");
    board::exit_with_status(1);
  }
  return load<Q>(builder.words(), builder.size() * 4);
}

inline constexpr const Target& kTarget = target::NEARFIELD_TARGET_NAME;

constexpr Budget greatest_of_both(const Budget& a, const Budget& b) {
  return {greatest_of_two(a.value, b.value), greatest_of_two(a.gradient, b.gradient),
          greatest_of_two(a.highest, b.highest)};
}

// Of evaluate() itself: what a program without operations takes. None is valid, but it can be run.
inline Budget evaluation_cost() {
  return {instructions_at<Value<Q>>({}, {}), instructions_at<Sample<Q>>({}, {}),
          instructions_at<Highest<Q>>({}, {})};
}

// The greatest costs measured so far of an operation, for each number of items that was tried.
struct Measured {
  static constexpr uint32_t most_counts = 16;
  struct OfCount {
    uint32_t items = 0;
    Budget cost;
  };
  OfCount of_count[most_counts];
  uint32_t counts = 0;

  void note(uint32_t items, const Budget& cost) {
    uint32_t i = 0;
    while (i < counts && of_count[i].items != items) ++i;
    if (i == counts) counts += counts < most_counts ? 1 : 0;
    of_count[i % most_counts].items = items;
    Budget& known = of_count[i % most_counts].cost;
    known = greatest_of_both(known, cost);
  }

  // The least line through the costs of fewest and most items that is above all.
  struct Line {
    uint32_t base, item;
  };
  template <class Count>
  Line line(Count&& count) const {
    const OfCount *fewest = of_count, *most = of_count;
    for (uint32_t i = 0; i < counts; ++i) {
      if (of_count[i].items < fewest->items) fewest = of_count + i;
      if (of_count[i].items > most->items) most = of_count + i;
    }
    const uint32_t items = most->items - fewest->items, low = count(fewest->cost), high = count(most->cost);
    const uint32_t item = items == 0 || high <= low ? 0 : (high - low + items - 1) / items;
    uint32_t base = 1;
    for (uint32_t i = 0; i < counts; ++i) {
      const uint32_t all = count(of_count[i].cost), of_items = of_count[i].items * item;
      if (all > base + of_items) base = all - of_items;
    }
    return {base, item};
  }
  Budget base() const {
    return {line([](const Budget& c) { return c.value; }).base, line([](const Budget& c) { return c.gradient; }).base,
            line([](const Budget& c) { return c.highest; }).base};
  }
  Budget item() const {
    return {line([](const Budget& c) { return c.value; }).item, line([](const Budget& c) { return c.gradient; }).item,
            line([](const Budget& c) { return c.highest; }).item};
  }
};
inline Measured measured_costs[256];

constexpr const char* name_of(Operation operation) {
  switch (operation) {
#define NEARFIELD_NAME(code, name, type) \
  case Operation::name:                  \
    return #name;
    NEARFIELD_OPERATIONS(NEARFIELD_NAME)
#undef NEARFIELD_NAME
    default:
      return "frame";
  }
}

// Operands, and one operation on all of them (a shape: on none): what a program costs beyond its operands by
// themselves at the same point. Takes memory from the one trial before: there is one at a time.
class Trial {
 public:
  Trial() { whole_ = Builder(); }
  // Of operations that sample this table.
  template <class Table>
  explicit Trial(const Table& table) : Trial() {
    table_ = whole_.table(table);
  }

  template <class T>
  Trial& operand(const T& shape) {
    if (operand_count_ == 0) tables_alone() = whole_;
    Builder& lone = operands_[operand_count_++];
    lone = tables_alone();
    append(lone, shape);
    return append(whole_, shape);
  }
  // As the last one of the program.
  template <class T>
  void measure(const T& operation) {
    append(whole_, operation);
    const Operation code = OperationOf<T>::value;
    uint32_t items = 0;
    if constexpr (detail::has_items<T>) items = static_cast<uint32_t>(detail::item_count(operation));
    measured_costs[static_cast<uint32_t>(code)].note(items, worst(name_of(code)));
  }
  // The whole program, for frames.
  Builder& whole() { return whole_; }

  Budget worst(const char* what) {
    return worst(what, [](const Vector3<Q>& p) { return p; });
  }
  // to_inner: where the whole program asks its operands.
  template <class ToInner> Budget worst(const char* what, ToInner&& to_inner) {
    const Program<Q> whole = loaded(whole_, what);
    Program<Q> operands[kStackDepth];
    for (int i = 0; i < operand_count_; ++i) operands[i] = loaded(operands_[i], what);
    const Budget evaluation = evaluation_cost();
    Budget worst;
    Random random;
    for (int i = 0; i < kPoints / (operand_count_ + 1); ++i) {
      const Place at = random.place(), inner = {to_inner(at.point), at.radius};
      worst = greatest_of_both(worst, {beyond_operands<Value<Q>>(whole, at, operands, inner, evaluation.value),
                                       beyond_operands<Sample<Q>>(whole, at, operands, inner, evaluation.gradient),
                                       beyond_operands<Highest<Q>>(whole, at, operands, inner, evaluation.highest)});
    }
    return worst;
  }

 private:
  template <class T>
  Trial& append(Builder& builder, const T& operation) {
    if constexpr (detail::uses_table<T>)
      builder.operation(operation, table_);
    else
      builder.operation(operation);
    return *this;
  }
  template <class Out>
  uint32_t beyond_operands(const Program<Q>& whole, const Place& at, const Program<Q>* operands, const Place& inner,
                           uint32_t evaluation) const {
    uint32_t count = instructions_at<Out>(whole, at) - evaluation;
    for (int i = 0; i < operand_count_; ++i) count -= instructions_at<Out>(operands[i], inner) - evaluation;
    return count;
  }

  static Builder& tables_alone() {
    static Builder builder;
    return builder;
  }
  inline static Builder whole_, operands_[kStackDepth];
  uint32_t table_ = 0;
  int operand_count_ = 0;
};

}  // namespace nearfield::costs
