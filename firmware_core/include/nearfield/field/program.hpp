// A loaded program image as a field.
#pragma once

#include <nearfield/field/image.hpp>

namespace nearfield {

// The field that an image describes, evaluated in place. Holds a pointer to the image, which must stay where it is
// and unchanged. Only a program with status ok may be evaluated; queries refuse any other.
template <class S> class Program {
 public:
  using Scalar = S;

  constexpr Program() = default;
  constexpr Program(const uint32_t* image, const Inspection<S>& inspection)
      : image_(image), inspection_(inspection) {
    if (inspection.status == LoadStatus::ok) {
      first_ = image_format::header_words + image[image_format::table_words];
      last_ = image[image_format::size_word];
    }
  }

  constexpr LoadStatus status() const { return inspection_.status; }
  constexpr bool valid() const { return status() == LoadStatus::ok; }
  constexpr Kind kind() const { return inspection_.kind; }
  constexpr const Certificate<S>& certificate() const { return inspection_.certificate; }
  constexpr Budget budget() const { return inspection_.budget; }
  constexpr uint32_t slot_count() const { return inspection_.slot_count; }

  // Precondition: status ok, p within the domain, slot_count() valid poses in `slots` (null if there are none).
  template <class Out> Out evaluate(const Vector3<S>& p, const Pose<S>* slots) const {
    Machine<Out> machine(p, slots);
    for (const uint32_t *at = image_ + first_, *last = image_ + last_; at != last;) {
      const uint32_t word = *at++;
      step(machine, static_cast<Operation>(word & 0xffu), at);
      at += word >> 8;
    }
    return machine.top;
  }

 private:
  // Results that lie in the stack as plain words.
  template <class Out> struct Results {
    const uint32_t* words;
    Out operator[](int i) const { return fetch<Out>(words + static_cast<uint32_t>(i) * payload_words<Out>); }
  };

  // The result on top of the stack is kept apart, so that it stays in registers. What is below it, and the frames, are
  // plain words: they need no initialisation.
  template <class Out> struct Machine {
    static constexpr uint32_t result_words = payload_words<Out>, point_words = payload_words<Vector3<S>>;

    Machine(const Vector3<S>& p, const Pose<S>* poses) : point(p), slots(poses) {}

    void push(const Out& result) {
      store(below + depth * result_words, top);
      ++depth;
      top = result;
    }
    Out pop_below() {
      --depth;
      return fetch<Out>(below + depth * result_words);
    }
    // The last `count` results; the next is to be stored in `top`.
    Results<Out> take(uint32_t count) {
      store(below + depth * result_words, top);
      depth -= count - 1;
      return {below + depth * result_words};
    }
    void enter(const Pose<S>* slot, const uint32_t* constant, const Vector3<S>& inner_point) {
      store(outer_points + frame_depth * point_words, point);
      frame_slot[frame_depth] = slot;
      frame_constant[frame_depth] = constant;
      ++frame_depth;
      point = inner_point;
    }
    void leave() {
      --frame_depth;
      point = fetch<Vector3<S>>(outer_points + frame_depth * point_words);
      if constexpr (Out::has_gradient) {
        const Pose<S>* slot = frame_slot[frame_depth];
        top.gradient = slot != nullptr ? rotate(slot->rotation, top.gradient)
                                       : rotate(fetch<Pose<S>>(frame_constant[frame_depth]).rotation, top.gradient);
      }
    }

    Vector3<S> point;
    const Pose<S>* slots;
    Out top;
    uint32_t depth = 0, frame_depth = 0;
    // One more than the depth that validation allows: the first push saves a result that nobody asks for.
    uint32_t below[(kStackDepth + 1) * result_words];
    uint32_t outer_points[kFrameDepth * point_words];
    const Pose<S>* frame_slot[kFrameDepth];
    const uint32_t* frame_constant[kFrameDepth];
  };

  // Words of the image or the machine as values: a copy that the compiler turns into loads.
  template <class T> static T fetch(const uint32_t* words) {
    T value;
    if constexpr (payload_words<T> != 0) __builtin_memcpy(static_cast<void*>(&value), words, sizeof(T));
    return value;
  }
  template <class T> static void store(uint32_t* words, const T& value) {
    __builtin_memcpy(words, static_cast<const void*>(&value), sizeof(T));
  }

  TableView<S> table(uint32_t reference) const {
    const uint32_t* t = image_ + reference;
    return {t + image_format::table_header_words, static_cast<int>(t[0]), static_cast<int>(t[1])};
  }

  template <class T, class Out> __attribute__((always_inline)) void operate(Machine<Out>& m, const uint32_t* payload) const {
    constexpr int count = detail::operand_count_of<T>;
    const T operation = fetch<T>(payload);
    if constexpr (count == kAnyNumber) {
      operate_on_all<T>(m, operation, payload);
    } else if constexpr (detail::uses_table<T>) {
      const TableView<S> view = table(payload[payload_words<T>]);
      if constexpr (count == 0) m.push(operation.template evaluate<Out>(m.point, view));
      else if constexpr (count == 1) m.top = operation.combine(m.top, view);
      else m.top = operation.combine(m.pop_below(), m.top, view);
    } else {
      if constexpr (count == 0) m.push(operation.template evaluate<Out>(m.point));
      else if constexpr (count == 1) m.top = operation.combine(m.top);
      else m.top = operation.combine(m.pop_below(), m.top);
    }
  }
  // Apart from the others, so that what they need does not weigh on all.
  template <class T, class Out>
  __attribute__((noinline)) void operate_on_all(Machine<Out>& m, const T& operation, const uint32_t* payload) const {
    const Results<Out> of = m.take(static_cast<uint32_t>(operation.operand_count()));
    if constexpr (detail::uses_table<T>) m.top = operation.template combine_all<Out>(of, table(payload[payload_words<T>]));
    else m.top = operation.template combine_all<Out>(of);
  }

  template <class Out>
  __attribute__((always_inline)) void step(Machine<Out>& m, Operation operation, const uint32_t* payload) const {
    switch (operation) {
#define NEARFIELD_CASE(code, name, type, value, gradient) \
  case Operation::name: return operate<type<S>>(m, payload);
      NEARFIELD_OPERATIONS(NEARFIELD_CASE)
#undef NEARFIELD_CASE
      case Operation::enter_pose:
        m.enter(nullptr, payload, to_inner(fetch<Pose<S>>(payload), m.point));
        return;
      case Operation::enter_slot:
        m.enter(m.slots + payload[0], nullptr, to_inner(m.slots[payload[0]], m.point));
        return;
      case Operation::leave: m.leave(); return;
    }
  }

  const uint32_t* image_ = nullptr;
  uint32_t first_ = 0, last_ = 0;
  Inspection<S> inspection_ = not_loaded();

  static constexpr Inspection<S> not_loaded() {
    Inspection<S> none;
    none.status = LoadStatus::no_image;
    return none;
  }
};

// Checks an image in place, without copying it; see inspect_image() for the cost. `byte_count` may exceed the image.
template <class S> Program<S> load(const void* image, size_t byte_count) {
  if (reinterpret_cast<uintptr_t>(image) % alignof(uint32_t) != 0) return {};
  const uint32_t* words = static_cast<const uint32_t*>(image);
  const size_t count = byte_count / 4 < kImageWordLimit ? byte_count / 4 : kImageWordLimit;
  return {words, inspect_image<S>(words, static_cast<uint32_t>(count))};
}

}  // namespace nearfield
