// Clearances at many points at once, for hosts: one operation at a time, on a block of points.
#pragma once

#include <nearfield/field/apply.hpp>
#include <nearfield/field/program.hpp>
#include <nearfield/query/clearance.hpp>

namespace nearfield {

namespace detail {

// A program's machine whose every number is a block of them. Loops over the lanes of a block have no branches of their
// own, so that compilers may use vector instructions.
template <class S> class BlockMachine {
 public:
  static constexpr uint32_t lanes = 64;

  BlockMachine(const uint32_t* image, const Slots<S>& slots) : image_(image), slots_(slots) {}

  // Preconditions as Program::evaluate(), for each of at most `lanes` points.
  void run(const Vector3<S>* points, uint32_t count, S* values) {
    for (uint32_t i = 0; i < lanes; ++i) {
      const Vector3<S>& p = points[i < count ? i : 0];
      point_.x[i] = p.x;
      point_.y[i] = p.y;
      point_.z[i] = p.z;
    }
    depth_ = frame_depth_ = 0;
    using namespace image_format;
    const uint32_t *at = image_ + header_words + image_[table_words], *const last = image_ + image_[size_word];
    while (at != last) {
      const uint32_t word = *at++;
      step(static_cast<Operation>(word & 0xffu), at);
      at += word >> 8;
    }
    for (uint32_t i = 0; i < count; ++i) values[i] = stack_[0].value[i];
  }

 private:
  struct Points {
    S x[lanes], y[lanes], z[lanes];
    Vector3<S> operator[](uint32_t i) const { return {x[i], y[i], z[i]}; }
  };
  struct Values {
    S value[lanes];
  };

  template <class T> static T fetch(const uint32_t* words) { return words_as<T>(words); }

  template <class T> __attribute__((noinline)) void operate(const uint32_t* payload) {
    constexpr bool any_number = operand_count_of<T> == kAnyNumber;
    constexpr uint32_t fixed_count = any_number ? 0 : static_cast<uint32_t>(operand_count_of<T>);
    if constexpr (reads_in_place<T>) {
      const typename T::InImage source{payload};
      Values& result = stack_[depth_++];
      for (uint32_t i = 0; i < lanes; ++i) {
        result.value[i] = T::template evaluate_from<Value<S>>(source, point_[i]).value;
      }
    } else {
      const T operation = fetch<T>(payload);
      TableView<S> table;
      if constexpr (uses_table<T>) table = table_of_image<S>(image_ + payload[payload_words<T>]);
      uint32_t count = fixed_count;
      if constexpr (any_number) count = static_cast<uint32_t>(operation.operand_count());
      depth_ -= count;
      Values* const results = stack_ + depth_++;
      for (uint32_t i = 0; i < lanes; ++i) {
        const auto of = [&](uint32_t operand) { return Value<S>{results[operand].value[i]}; };
        const auto with = [&](const auto&... operands) {
          return apply<Value<S>>(operation, point_[i], table, slots_.parameters, operands...);
        };
        Value<S> result;
        if constexpr (any_number) {
          Value<S> all[kStackDepth] = {};
          for (uint32_t operand = 0; operand < count; ++operand) all[operand] = of(operand);
          result = apply_to_all<Value<S>>(operation, table, all);
        } else if constexpr (fixed_count == 0) {
          result = with();
        } else if constexpr (fixed_count == 1) {
          result = with(of(0));
        } else {
          result = with(of(0), of(1));
        }
        results[0].value[i] = result.value;
      }
    }
  }

  // The points as a frame sees them, until leave().
  template <class Place> void enter(const uint32_t* payload, const Place& place) {
    outer_[frame_depth_] = point_;
    entered_[frame_depth_] = payload;
    const Points outer = point_;
    for (uint32_t i = 0; i < lanes; ++i) {
      const Vector3<S> inner = place(outer[i]);
      point_.x[i] = inner.x;
      point_.y[i] = inner.y;
      point_.z[i] = inner.z;
    }
    ++frame_depth_;
  }
  const uint32_t* leave() {
    --frame_depth_;
    point_ = outer_[frame_depth_];
    return entered_[frame_depth_];
  }
  // What a frame makes of the result on top, at its points outside.
  template <class Change> void change_top(const Change& change) {
    Values& top = stack_[depth_ - 1];
    for (uint32_t i = 0; i < lanes; ++i) top.value[i] = change(point_[i], Value<S>{top.value[i]}).value;
  }

  void step(Operation operation, const uint32_t* payload) {
    switch (operation) {
#define NEARFIELD_CASE(code, name, type) \
  case Operation::name: return operate<type<S>>(payload);
      NEARFIELD_OPERATIONS(NEARFIELD_CASE)
#undef NEARFIELD_CASE
      case Operation::enter_pose: {
        const auto pose = fetch<Pose<S>>(payload);
        return enter(payload, [&](const Vector3<S>& p) { return to_inner(pose, p); });
      }
      case Operation::enter_slot: {
        const Pose<S> pose = slots_.poses[payload[0]];
        return enter(payload, [&](const Vector3<S>& p) { return to_inner(pose, p); });
      }
      case Operation::leave: leave(); return;
      case Operation::enter_box: {
        DeclaredBox<S> box;
        box.half = fetch<Vector3<S>>(payload);
        return enter(payload, [&](const Vector3<S>& p) { return box.nearest_inside(p); });
      }
      case Operation::leave_box: {
        leave();
        const auto box = fetch<DeclaredBox<S>>(payload);
        return change_top([&](const Vector3<S>& p, const Value<S>& g) { return box.at(p, g); });
      }
      case Operation::enter_scale: {
        const auto scale = fetch<UniformScale<S>>(payload);
        return enter(payload, [&](const Vector3<S>& p) { return scale.to_inner(p); });
      }
      case Operation::leave_scale: {
        const uint32_t* entered = leave();
        const auto scale = fetch<UniformScale<S>>(entered);
        const Kind kind = static_cast<Kind>(entered[payload_words<UniformScale<S>>]);
        return change_top([&](const Vector3<S>&, const Value<S>& v) { return scale.to_outer(kind, v); });
      }
    }
  }

  const uint32_t* image_;
  Slots<S> slots_;
  Points point_;
  Values stack_[kStackDepth];
  Points outer_[kFrameDepth];
  const uint32_t* entered_[kFrameDepth] = {};
  uint32_t depth_ = 0, frame_depth_ = 0;
};

}  // namespace detail

// The distances of clearance() at many points, to the bit; the least number where that is `invalid`. About 9 KiB of stack.
template <class S>
void clearance_distances(const Program<S>& field, const Vector3<S>* points, uint32_t count, S* distances,
                         const Slots<S>& slots = {}) {
  using Machine = detail::BlockMachine<S>;
  const bool may_be_asked = detail::may_be_asked(field, Vector3<S>{}, slots) && detail::valid_slots(field, slots);
  Machine machine(field.image(), slots);
  const detail::Certifier<S> certifier(field.certificate());
  for (uint32_t first = 0; first < count; first += Machine::lanes) {
    const uint32_t here = least_of_two<uint32_t>(count - first, Machine::lanes);
    Vector3<S> inside[Machine::lanes];
    S values[Machine::lanes] = {};
    for (uint32_t i = 0; i < here; ++i) inside[i] = coordinates_in_domain(points[first + i]) ? points[first + i] : Vector3<S>{};
    if (may_be_asked) machine.run(inside, here, values);
    for (uint32_t i = 0; i < here; ++i) {
      const bool asked = may_be_asked && coordinates_in_domain(points[first + i]);
      distances[first + i] = asked ? certifier.lower_bound(values[i]) : ScalarTraits<S>::least();
    }
  }
}

}  // namespace nearfield
