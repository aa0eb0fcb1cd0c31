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
    Machine<Out> machine{p, slots, {}, {}, 0, 0};
    for (const uint32_t *at = image_ + first_, *last = image_ + last_; at != last;) {
      const uint32_t word = *at++;
      step(machine, static_cast<Operation>(word & 0xffu), at);
      at += word >> 8;
    }
    return machine.results[0];
  }

 private:
  struct Frame {
    Vector3<S> outer_point;
    const Pose<S>* slot;
    const uint32_t* constant;
  };
  template <class Out> struct Machine {
    Vector3<S> point;
    const Pose<S>* slots;
    Out results[kStackDepth];
    Frame frames[kFrameDepth];
    int depth, frame_depth;
  };

  TableView<S> table(uint32_t reference) const {
    const uint32_t* t = image_ + reference;
    return {t + image_format::table_header_words, static_cast<int>(t[0]), static_cast<int>(t[1])};
  }

  template <class Out> void step(Machine<Out>& m, Operation operation, const uint32_t* payload) const {
    switch (operation) {
#define NEARFIELD_CASE(code, name, type)                                                                     \
  case Operation::name:                                                                                      \
    m.results[m.depth++] = detail::read_payload<type<S>>(payload).template evaluate<Out>(m.point);           \
    return;
      NEARFIELD_SHAPES(NEARFIELD_CASE)
#undef NEARFIELD_CASE
#define NEARFIELD_CASE(code, name, type)                                                                     \
  case Operation::name:                                                                                      \
    m.results[m.depth++] = detail::read_payload<type<S>>(payload).template evaluate<Out>(                    \
        m.point, table(payload[payload_words<type<S>>]));                                                    \
    return;
      NEARFIELD_SHAPES_WITH_TABLE(NEARFIELD_CASE)
#undef NEARFIELD_CASE
#define NEARFIELD_CASE(code, name, type)                                                                     \
  case Operation::name:                                                                                      \
    --m.depth;                                                                                               \
    m.results[m.depth - 1] =                                                                                 \
        detail::read_payload<type<S>>(payload).combine(m.results[m.depth - 1], m.results[m.depth]);          \
    return;
      NEARFIELD_BLENDS(NEARFIELD_CASE)
#undef NEARFIELD_CASE
#define NEARFIELD_CASE(code, name, type)                                                                     \
  case Operation::name:                                                                                      \
    --m.depth;                                                                                               \
    m.results[m.depth - 1] = detail::read_payload<type<S>>(payload).combine(                                 \
        m.results[m.depth - 1], m.results[m.depth], table(payload[payload_words<type<S>>]));                 \
    return;
      NEARFIELD_BLENDS_WITH_TABLE(NEARFIELD_CASE)
#undef NEARFIELD_CASE
      case Operation::enter_pose:
        m.frames[m.frame_depth++] = {m.point, nullptr, payload};
        m.point = to_inner(detail::read_payload<Pose<S>>(payload), m.point);
        return;
      case Operation::enter_slot: {
        const Pose<S>* slot = m.slots + payload[0];
        m.frames[m.frame_depth++] = {m.point, slot, nullptr};
        m.point = to_inner(*slot, m.point);
        return;
      }
      case Operation::leave: {
        const Frame& frame = m.frames[--m.frame_depth];
        m.point = frame.outer_point;
        if constexpr (Out::has_gradient) {
          Vector3<S>& gradient = m.results[m.depth - 1].gradient;
          gradient = frame.slot != nullptr
                         ? rotate(frame.slot->rotation, gradient)
                         : rotate(detail::read_payload<Pose<S>>(frame.constant).rotation, gradient);
        }
        return;
      }
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
