// A loaded program image as a field.
#pragma once

#include <nearfield/field/apply.hpp>
#include <nearfield/field/budget.hpp>
#include <nearfield/field/image.hpp>
#include <nearfield/shape/payload.hpp>

namespace nearfield {

namespace detail {

// What a machine knows of the ball that it evaluates over, if it does.
template <class Out> struct BallOfMachine {};
template <class S> struct BallOfMachine<Highest<S>> {
  Ball<S> ball;
  Ball<S> outer_balls[kFrameDepth];
};

}  // namespace detail

// The field that an image describes, evaluated in place. Holds a pointer to the image, which must stay where it is
// and unchanged. Only a program with status ok may be evaluated; queries refuse any other.
template <class S, class Operations = AllOperations> class Program {
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
  // Worst-case instructions of a value, and of a clearance with all that it checks. Nothing if not valid. Cost: a walk over
  // the image.
  Budget budget(const Target& target = kThisTarget) const;  // of other scalars than Fixed<27> 100,000,000
  constexpr uint32_t slot_count() const { return inspection_.slot_count; }
  constexpr uint32_t parameter_count() const { return inspection_.parameter_count; }
  // As it was loaded from.
  constexpr const uint32_t* image() const { return image_; }

  // Precondition: status ok, p within the domain, slot_count() valid poses and parameter_count() parameters in `slots`.
  template <class Out> Out evaluate(const Vector3<S>& p, const Slots<S>& slots) const;

  // Of an intensity: whether highest() tells anything.
  constexpr bool has_highest() const { return kind() == Kind::intensity && inspection_.has_highest; }
  // Nowhere within `radius` metres of p is the intensity greater than this and certificate().error together.
  // Preconditions as above.
  Highest<S> highest(const Vector3<S>& p, S radius, const Slots<S>& slots) const;

 private:
  // Results that lie in the stack as plain words.
  template <class Out> struct Results {
    const uint32_t* words;
    Out operator[](int i) const { return fetch<Out>(words + static_cast<uint32_t>(i) * payload_words<Out>); }
  };

  // The result on top of the stack is kept apart, so that it stays in registers. What is below it, and the frames, are
  // plain words: they need no initialisation.
  template <class Out> struct Machine : detail::BallOfMachine<Out> {
    static constexpr bool finds_highest = !__is_empty(detail::BallOfMachine<Out>);
    static constexpr uint32_t result_words = payload_words<Out>, point_words = payload_words<Vector3<S>>;

    Machine(const Vector3<S>& p, const Slots<S>& given) : point(p), slots(given.poses), parameters(given.parameters) {}

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
    // The ball as the frame sees it that was entered last.
    void set_ball(const Ball<S>& inner) {
      this->outer_balls[frame_depth - 1] = this->ball;
      this->ball = inner;
    }
    void move_ball(const Vector3<S>& translation, PoseOrigin origin) {
      set_ball(inner_ball(this->ball, translation, origin));
    }
    void leave_frame() {
      --frame_depth;
      if constexpr (finds_highest) this->ball = this->outer_balls[frame_depth];
      point = fetch<Vector3<S>>(outer_points + frame_depth * point_words);
    }
    void leave() {
      leave_frame();
      if constexpr (Out::has_gradient) {
        const Pose<S>* slot = frame_slot[frame_depth];
        top.gradient = slot != nullptr ? rotate(slot->rotation, top.gradient)
                                       : rotate(fetch<Pose<S>>(frame_constant[frame_depth]).rotation, top.gradient);
      }
    }

    void leave_box(const DeclaredBox<S>& box) {
      leave_frame();
      top = box.at(point, top);
    }
    void leave_scale() {
      leave_frame();
      const uint32_t* payload = frame_constant[frame_depth];
      top = fetch<UniformScale<S>>(payload).to_outer(static_cast<Kind>(payload[payload_words<UniformScale<S>>]), top);
    }

    Vector3<S> point;
    const Pose<S>* slots;
    const S* parameters;
    Out top;
    uint32_t depth = 0, frame_depth = 0;
    // One more than the depth that validation allows: the first push saves a result that nobody asks for.
    uint32_t below[(kStackDepth + 1) * result_words];
    uint32_t outer_points[kFrameDepth * point_words];
    const Pose<S>* frame_slot[kFrameDepth];
    const uint32_t* frame_constant[kFrameDepth];
  };

  template <class T> static T fetch(const uint32_t* words) { return detail::words_as<T>(words); }
  template <class T> static void store(uint32_t* words, const T& value) {
    __builtin_memcpy(words, static_cast<const void*>(&value), sizeof(T));
  }

  // Of an operation of the image with all its items.
  static Budget cost_in_image(const Target& target, Operation operation, [[maybe_unused]] const uint32_t* payload) {
    switch (operation) {
#define NEARFIELD_CASE(code, name, type)                                                     \
  case Operation::name:                                                                      \
    if constexpr (Operations::has(Operation::name) && detail::has_items<type<S>>)            \
      return target.cost_of(fetch<type<S>>(payload));                                       \
    break;
      NEARFIELD_OPERATIONS(NEARFIELD_CASE)
#undef NEARFIELD_CASE
      default: break;
    }
    return target.cost(operation);
  }

  TableView<S> table(uint32_t reference) const { return detail::table_of_image<S>(image_ + reference); }

  // Operations that read their payload in place: apart from the others, so that what they need does not weigh on all.
  template <class T, class Out>
  static __attribute__((noinline)) void evaluate_in_place(Machine<Out>& m, const uint32_t* payload) {
    m.push(T::template evaluate_from<Out>(typename T::InImage{payload}, m.point));
  }
  // What all others do, with a copy.
  template <class T, class Out>
  __attribute__((always_inline)) void operate(Machine<Out>& m, const uint32_t* payload) const {
    const T operation = fetch<T>(payload);
    constexpr int count = detail::operand_count_of<T>;
    TableView<S> view;
    if constexpr (detail::uses_table<T>) view = table(payload[payload_words<T>]);
    const auto result = [&](const auto&... of) __attribute__((always_inline)) {
      if constexpr (Machine<Out>::finds_highest && detail::has_own_highest<T>) {
        return detail::apply_highest(operation, m.point, m.ball, view, m.parameters, of...);
      } else {
        return detail::apply<Out>(operation, m.point, view, m.parameters, of...);
      }
    };
    static_assert(count != kAnyNumber || !detail::has_own_highest<T>, "greatest values in a ball are of at most two operands");
    if constexpr (count == kAnyNumber) operate_on_all<T>(m, operation, payload);
    else if constexpr (count == 0) m.push(result());
    else if constexpr (count == 1) m.top = result(m.top);
    else m.top = result(m.pop_below(), m.top);
  }
  // Apart from the others, as those in place.
  template <class T, class Out>
  __attribute__((noinline)) void operate_on_all(Machine<Out>& m, const T& operation, const uint32_t* payload) const {
    const Results<Out> of = m.take(static_cast<uint32_t>(operation.operand_count()));
    TableView<S> view;
    if constexpr (detail::uses_table<T>) view = table(payload[payload_words<T>]);
    m.top = detail::apply_to_all<Out>(operation, view, of);
  }

  template <class Out>
  __attribute__((always_inline)) void step(Machine<Out>& m, Operation operation, const uint32_t* payload) const {
    switch (operation) {
#define NEARFIELD_CASE(code, name, type) \
  case Operation::name:                                   \
    if constexpr (!Operations::has(Operation::name)) return;                              \
    else if constexpr (detail::reads_in_place<type<S>>) return evaluate_in_place<type<S>>(m, payload); \
    else return operate<type<S>>(m, payload);
      NEARFIELD_OPERATIONS(NEARFIELD_CASE)
#undef NEARFIELD_CASE
      case Operation::enter_pose:
        m.enter(nullptr, payload, to_inner(fetch<Pose<S>>(payload), m.point));
        if constexpr (Machine<Out>::finds_highest) m.move_ball(fetch<Pose<S>>(payload).translation, PoseOrigin::constant);
        return;
      case Operation::enter_slot:
        m.enter(m.slots + payload[0], nullptr, to_inner(m.slots[payload[0]], m.point));
        if constexpr (Machine<Out>::finds_highest) m.move_ball(m.slots[payload[0]].translation, PoseOrigin::run_time);
        return;
      case Operation::leave: m.leave(); return;
      case Operation::enter_box: {
        DeclaredBox<S> box;
        box.half = fetch<Vector3<S>>(payload);
        m.enter(nullptr, payload, box.nearest_inside(m.point));
        if constexpr (Machine<Out>::finds_highest) m.move_ball({}, PoseOrigin::constant);
        return;
      }
      case Operation::leave_box: m.leave_box(fetch<DeclaredBox<S>>(payload)); return;
      case Operation::enter_scale: {
        if constexpr (!Operations::has(Operation::enter_scale)) return;
        const auto scale = fetch<UniformScale<S>>(payload);
        m.enter(nullptr, payload, scale.to_inner(m.point));
        if constexpr (Machine<Out>::finds_highest) m.set_ball(scale.to_inner(m.ball));
        return;
      }
      case Operation::leave_scale:
        if constexpr (Operations::has(Operation::enter_scale)) m.leave_scale();
        return;
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

template <class S, class Operations>
template <class Out>
Out Program<S, Operations>::evaluate(const Vector3<S>& p, const Slots<S>& slots) const {
  Machine<Out> machine(p, slots);
  for (const uint32_t *at = image_ + first_, *last = image_ + last_; at != last;) {
    const uint32_t word = *at++;
    step(machine, static_cast<Operation>(word & 0xffu), at);
    at += word >> 8;
  }
  return machine.top;
}

// A loop of its own: sharing it with evaluate() would change the code of that.
template <class S, class Operations>
Highest<S> Program<S, Operations>::highest(const Vector3<S>& p, S radius, const Slots<S>& slots) const {
  Machine<Highest<S>> machine(p, slots);
  machine.ball = {radius, domain_reach<S>().radius};
  for (const uint32_t *at = image_ + first_, *last = image_ + last_; at != last;) {
    const uint32_t word = *at++;
    step(machine, static_cast<Operation>(word & 0xffu), at);
    at += word >> 8;
  }
  return machine.top;
}

template <class S, class Operations> Budget Program<S, Operations>::budget(const Target& target) const {
  if (!valid()) return {};
  Budget sum = target.query_cost(slot_count(), parameter_count());
  for (const uint32_t *at = image_ + first_, *last = image_ + last_; at != last;) {
    const uint32_t word = *at++;
    sum = sum + cost_in_image(target, static_cast<Operation>(word & 0xffu), at);
    at += word >> 8;
  }
  return detail::budget_in<S>(sum);
}

// Checks an image in place, without copying it; see inspect_image() for the cost. `byte_count` may exceed the image.
// Operations: OnlyOperations<...> leaves the code of all others out; images that have one are refused.
template <class S, class Operations = AllOperations> Program<S, Operations> load(const void* image, size_t byte_count) {
  if (reinterpret_cast<uintptr_t>(image) % alignof(uint32_t) != 0) return {};
  const uint32_t* words = static_cast<const uint32_t*>(image);
  const size_t count = byte_count / 4 < kImageWordLimit ? byte_count / 4 : kImageWordLimit;
  return {words, inspect_image<S, Operations>(words, static_cast<uint32_t>(count))};
}

// Evaluating and checking programs of all operations is much code. Large builds compile it in one place and declare it
// everywhere else: each scalar once by NEARFIELD_PROGRAMS(, Scalar) in one source, NEARFIELD_PROGRAMS(extern, Scalar) before
// the first use in all others.
#define NEARFIELD_PROGRAMS(extern_or_nothing, S)                                                                        \
  extern_or_nothing template Value<S> Program<S>::evaluate<Value<S>>(const Vector3<S>&, const Slots<S>&) const;         \
  extern_or_nothing template Sample<S> Program<S>::evaluate<Sample<S>>(const Vector3<S>&, const Slots<S>&) const;       \
  extern_or_nothing template Highest<S> Program<S>::highest(const Vector3<S>&, S, const Slots<S>&) const;               \
  extern_or_nothing template Inspection<S> detail::inspect_operations_at_run_time<S, AllOperations>(const uint32_t*,    \
                                                                                                    uint32_t, uint32_t);
#ifdef NEARFIELD_PROGRAMS_COMPILED_ONCE
NEARFIELD_PROGRAMS(extern, Fixed<27>)
NEARFIELD_PROGRAMS(extern, Fixed<24>)
NEARFIELD_PROGRAMS(extern, Fixed<16>)
NEARFIELD_PROGRAMS(extern, float)
#endif

}  // namespace nearfield
